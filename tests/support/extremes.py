"""Least and greatest values that a scenario's JSON Schema allows a key."""

from __future__ import annotations

from typing import Any

from gcs.scenario.document import options
from gcs.scenario.json_schema import editor_schema
from gcs.scenario.keys import known_paths

SMALL, LARGE = 1e-9, 1e6
"""above a bound that is excluded itself, and where there is none"""


def number_keys(block: str) -> list[str]:
    """Key paths of a block's numbers, without those inside its lists."""
    keys = [key for key in known_paths() if key.startswith(f"{block}.") and "*" not in key]
    return [key for key in keys if any(node.get("type") == "number" for node in _nodes(key))]


def extremes(key: str) -> list[float]:
    """Least and greatest of a number."""
    (number,) = (node for node in _nodes(key) if node.get("type") == "number")
    least = number.get("minimum", number.get("exclusiveMinimum", -LARGE - SMALL) + SMALL)
    greatest = number.get("maximum", number.get("exclusiveMaximum", LARGE + SMALL) - SMALL)
    return [least, greatest]


def _nodes(key: str) -> list[dict[str, Any]]:
    schema = editor_schema()
    nodes = list(options(schema, schema))
    for part in key.split("."):
        nodes = [
            found for node in nodes if part in node.get("properties", ())
            for found in options(schema, node["properties"][part])
        ]  # fmt: skip
    return nodes
