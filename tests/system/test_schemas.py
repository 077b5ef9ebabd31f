"""What a session leaves behind keeps to the schemas that ship with the ground station."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path
from typing import Any

import jsonschema
from attached import Attached
from sessions import Running, fly, small, two_refuellings

from gcs.recording import tlog_reader
from gcs.recording.summary import Summary
from gcs.scenario import json_schema
from gcs.session import message_types
from gcs.session.observer import Observer
from gcs.session.replay import Replay, ReplaySource


def schema(name: str) -> dict[str, Any]:
    text = resources.files("gcs").joinpath("schemas", f"{name}.schema.json").read_text(encoding="utf-8")
    loaded: dict[str, Any] = json.loads(text)
    return loaded


def test_the_shipped_summary_schema_is_the_summary() -> None:
    assert schema("summary") == Summary.model_json_schema(by_alias=True)


def test_the_shipped_scenario_schema_is_the_scenario() -> None:
    """`python -m gcs.scenario.json_schema >gcs/schemas/scenario.schema.json` brings it up to date."""
    assert schema("scenario") == json_schema.of_models()


def test_the_shipped_schema_of_messages_is_that_of_their_types() -> None:
    assert schema("messages") == message_types.schema()


def test_every_line_of_a_session_an_observer_and_a_replay_keeps_to_the_schema(tmp_path: Path) -> None:
    shipped = schema("messages")
    shipped["$defs"] = {name: rule | {"additionalProperties": False} for name, rule in shipped["$defs"].items()}
    validator = jsonschema.Draft202012Validator(shipped)
    content = small(
        clock={"mode": "real", "speed": 20.0}, bases=[{"name": "pad", "position_m": [5, 5, 0], "stock_j": 1000}]
    )
    running = Running(content, tmp_path, "--json")
    try:
        running.wait_for(lambda _: True)
        client = Attached(running.folder)
        assert client.order("inspect", sysid=1)["ok"]
        client.send_line(b'{"foo": 1}')
        while client.next()["type"] != "end":
            pass
        client.close()
        outcome = running.finish()
    finally:
        running.stop()
    live = client.lines
    assert {line["type"] for line in live} == {"session", "snapshot", "reply", "end"}
    assert {"id": None, "ok": False} in [{k: line[k] for k in ("id", "ok")} for line in live if line["type"] == "reply"]
    assert any(line["services"] for line in live if line["type"] == "snapshot")
    observer, source = Observer("monitor", "udpin:0.0.0.0:14550"), ReplaySource(Replay(outcome.folder), speed=None)
    for t_us, frame in tlog_reader.read(outcome.folder / "session.tlog"):
        observer.receive(frame, (t_us - 1767225600_000_000) / 1e6)
    told = [observer.session(), observer.snapshot(40.0, speed=1.0, phase="flying")]
    for t_s in (0.0, 10.0, 25.0, 40.0):
        source.send({"command": "seek", "t_s": t_s})
        source.send({"command": "inspect", "sysid": 1})
        told += [dict(line) for line in source.receive()]
    for line in (*live, *json.loads(json.dumps(told, allow_nan=False))):
        validator.validate(line)


def test_summary_and_decisions_keep_to_their_schemas(tmp_path: Path) -> None:
    outcome = fly(two_refuellings(), tmp_path, "--plain")
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
