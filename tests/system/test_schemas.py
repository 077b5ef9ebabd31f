"""What a session leaves behind keeps to the schemas that ship with the ground station."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path
from typing import Any

import jsonschema
from sessions import Running, demo, fly, merged, small

from gcs.recording.summary import Summary


def schema(name: str) -> dict[str, Any]:
    text = resources.files("gcs").joinpath("schemas", f"{name}.schema.json").read_text(encoding="utf-8")
    loaded: dict[str, Any] = json.loads(text)
    return loaded


def test_the_shipped_summary_schema_is_the_summary() -> None:
    assert schema("summary") == Summary.model_json_schema(by_alias=True)


def test_summary_and_decisions_keep_to_their_schemas(tmp_path: Path) -> None:
    outcome = fly(merged(demo(), {"goal": {"duration_s": 60}, "radio": {"loss": 0.3}}), tmp_path, "--plain")
    jsonschema.Draft202012Validator(schema("summary")).validate(outcome.summary)
    validator = jsonschema.Draft202012Validator(schema("decisions"))
    decisions = outcome.decisions
    assert {"set_point", "competition", "decided", "transfer", "served"} <= {d["kind"] for d in decisions}
    seen: dict[str, int] = {}
    for decision in decisions:
        seen[decision["kind"]] = seen.get(decision["kind"], 0) + 1
        if seen[decision["kind"]] <= 50:
            validator.validate(decision)


def test_a_wrong_decision_is_refused() -> None:
    validator = jsonschema.Draft202012Validator(schema("decisions"))
    assert not validator.is_valid({"t_s": 1.0, "kind": "set_point", "sysid": 1, "p_ned": [0, 0], "v_ned": [0, 0, 0]})
    assert not validator.is_valid({"t_s": 1.0, "kind": "guess"})


def test_an_interrupted_session_has_a_valid_summary_too(tmp_path: Path) -> None:
    running = Running(small(clock={"mode": "real", "speed": 5.0}), tmp_path, "--json")
    try:
        running.wait_for(lambda s: s["t_s"] > 2.0)
        running.process.terminate()
        outcome = running.finish()
    finally:
        running.stop()
    assert outcome.status == 143
    jsonschema.Draft202012Validator(schema("summary")).validate(outcome.summary)
