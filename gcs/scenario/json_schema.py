"""The JSON Schema of a scenario file, for editors: what a file may say, which is more than what `Scenario` holds.

A file may give keys once, in `vehicles.defaults`, instead of in each vehicle; so only `sysid` is
required of a vehicle, which one that is external may give in its block.
A vehicle or an obstacle may be a grid of many, and a planner or a policy be named in short.

It is shipped as gcs/schemas/scenario.schema.json, since it takes longer to make than a scenario to read:

    python -m gcs.scenario.json_schema >gcs/schemas/scenario.schema.json
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

from gcs.scenario.model import Scenario

VEHICLES = ("Pursuer", "Target", "Tanker")
GRID = {
    "type": "object",
    "description": "Many alike, row by row; system ids count up.",
    "properties": {
        "count": {"type": "integer", "minimum": 1, "description": "how many"},
        "columns": {"type": "integer", "minimum": 1, "description": "how many stand in a row, along the second axis"},
        "spacing_m": {
            "type": "array",
            "items": {"type": "number"},
            "minItems": 2,
            "maxItems": 2,
            "description": "between rows, along the first axis, and between neighbours in a row, along the second, m",
        },
    },
    "required": ["count", "columns", "spacing_m"],
    "additionalProperties": False,
}
SHIPPED = Path(__file__).resolve().parents[1] / "schemas" / "scenario.schema.json"
DRAFT = "https://json-schema.org/draft/2020-12/schema"


@cache
def editor_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of a scenario file, to be read only; values that are right one by one but not
    together are not in it."""
    return json.loads(SHIPPED.read_text(encoding="utf-8"))


def of_models() -> dict[str, Any]:
    """The same, made of `Scenario` and its parts."""
    schema = Scenario.model_json_schema()
    parts = schema["$defs"]
    keys: dict[str, Any] = {}
    for name in VEHICLES:
        del parts[name]["required"]
        parts[name]["anyOf"] = [{"required": ["sysid"]}, {"required": ["external"]}]
        keys |= parts[name]["properties"]
    for name in ("Battery", "External"):
        parts[name].pop("required", None)
    del keys["sysid"]
    for name in (*VEHICLES, "Obstacle"):
        parts[name]["properties"]["grid"] = GRID
    for key in ("planner", "competition"):
        part = schema["properties"][key]
        part["anyOf"] = [{"$ref": part.pop("$ref")}, {"type": "string"}]
    parts["Vehicles"]["properties"]["defaults"] = {
        "type": "object",
        "description": "Keys that are given to each vehicle that lacks them.",
        "properties": keys,
        "additionalProperties": False,
    }
    return {"$schema": DRAFT, "title": "Skytender scenario", **{k: v for k, v in schema.items() if k != "title"}}


if __name__ == "__main__":
    print(json.dumps(of_models(), indent=1, ensure_ascii=False))
