"""An operator at the session's socket, and what real vehicles make of it; one session for all."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import resources
from typing import Any

import jsonschema
import pytest
from attached import Attached, row
from sessions import Outcome, Running, small

HOLD_POINT_M = 0.5
SET_MODE, LAND, TRANSFER = 176, 21, 31010
GIVER, RECEIVER = 201, 2


@dataclass
class Session:
    outcome: Outcome
    lines: list[dict[str, Any]]
    events: list[dict[str, Any]]
    replies: dict[str, dict[str, Any]]
    times_s: dict[str, float]
    seen: dict[str, dict[str, Any]]


def scenario() -> dict[str, Any]:
    def pursuer(sysid: int, east_m: float, percent: float) -> dict[str, Any]:
        battery = {"capacity_j": 30_000, "initial_percent": percent}
        return {"sysid": sysid, "start_m": [2.0, east_m, 0.0], "target": 101, "battery": battery}

    def target(sysid: int, east_m: float) -> dict[str, Any]:
        path = [[0.0, east_m, -2.5], [40.0, east_m, -2.5]]
        return {"sysid": sysid, "start_m": [0.0, east_m, 0.0], "battery": {"capacity_j": 90_000},
                "path_m": path, "speed_m_s": 0.4}  # fmt: skip

    return small(
        clock={"mode": "real", "speed": 20.0},
        goal={"duration_s": 180.0, "refuelled_at_least": 0},
        vehicles={
            "pursuers": [pursuer(1, 0.0, 90.0), pursuer(2, 4.0, 70.0), pursuer(3, -4.0, 65.0)],
            "targets": [target(101, 0.0), target(102, 9.0)],
        },
        competition={"need_from": 0.4, "dwell_s": 1.0},
        refuelling={"rate_w": 1200.0},
    )


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Session]:
    running = Running(scenario(), tmp_path_factory.mktemp("operator"), "--json")
    try:
        running.wait_for(lambda _: True)
        client = Attached(running.folder)
        told = operate(client)
        outcome = running.finish()
        client.close()
        yield Session(outcome, client.lines, client.events, *told)
    finally:
        running.stop()


def operate(client: Attached) -> tuple[dict[str, Any], dict[str, float], dict[str, Any]]:
    replies: dict[str, dict[str, Any]] = {}
    times_s: dict[str, float] = {}
    seen: dict[str, Any] = {}

    def order(name: str, command: str, **keys: Any) -> None:
        replies[name] = client.order(command, **keys)
        times_s[name] = next(line["t_s"] for line in reversed(client.lines) if line["type"] == "snapshot")

    client.until(lambda s: all(v["stage"] == "fly" for v in s["vehicles"]), "all flew")
    order("pause", "pause")
    order("inspect", "inspect", sysid=1)
    order("skip 3", "skip", sysid=3)
    order("hold 1", "hold", sysid=1)
    order("retarget 2", "retarget", sysid=2, target=102)
    order("refuel 2", "refuel", sysid=2)
    for name, command, keys in (
        ("unknown vehicle", "hold", {"sysid": 77}),
        ("no vehicle", "land", {"sysid": "1"}),
        ("not taken", "rejoin", {"sysid": 2}),
        ("no target", "retarget", {"sysid": 2, "target": 3}),
        ("no pursuer", "refuel", {"sysid": 101}),
        ("unknown command", "holt", {}),
        ("of a replay", "seek", {"t_s": 3.0}),
    ):
        order(name, command, **keys)
    order("resume", "resume")
    seen["held"] = client.until(lambda s: row(s, 1)["mode"] == "hold", "1 held")

    client.until(lambda s: any(x["phase"] == "transfer" and x["energy_j"] > 500 for x in s["services"]), "a transfer")
    order("hold 201", "hold", sysid=GIVER)
    seen["broken off"] = client.until(
        lambda s: not s["services"] and row(s, GIVER)["mode"] == "hold", "the tanker was held"
    )
    order("inspect nobody", "inspect", sysid=None)
    seen["moved on"] = client.until(lambda s: row(s, 2)["target_m"] < 2.5, "2 came to its new target")

    order("land 1", "land", sysid=1)
    seen["landed"] = client.until(lambda s: not row(s, 1)["armed"] and row(s, 1)["landed"], "1 landed")
    order("rejoin 1", "rejoin", sysid=1)
    order("rejoin 201", "rejoin", sysid=GIVER)
    order("skip 3 again", "skip", sysid=3)
    seen["back"] = client.until(lambda s: row(s, 1)["stage"] == "fly" and row(s, 1)["mode"] == "offboard", "1 flew")
    order("return 1", "return", sysid=1)
    seen["going home"] = client.until(lambda s: row(s, 1)["mode"] == "return", "1 went home")
    seen["served"] = client.until(
        lambda s: any(h["receiver"] == 3 and h["energy_j"] > 0 for h in s["history"]), "3 was refuelled"
    )
    order("stop", "stop")  # before the next transfer, which would be cut in two
    return replies, times_s, seen


def test_orders_that_make_sense_are_taken_and_others_refused_with_a_sentence(session: Session) -> None:
    refused = {
        "unknown vehicle",
        "no vehicle",
        "not taken",
        "no target",
        "no pursuer",
        "unknown command",
        "of a replay",
    }
    assert {name for name, reply in session.replies.items() if not reply["ok"]} == refused
    assert all(reply["text"].endswith((".", "?")) for reply in session.replies.values())
    assert "'hold'" in session.replies["unknown command"]["text"]


def test_a_client_reads_the_session_first(session: Session) -> None:
    first = session.lines[0]
    assert (first["type"], first["source"], first["control"]) == ("session", "session", True)
    assert [v["sysid"] for v in first["vehicles"]] == [1, 2, 3, 101, 102, 201]
    assert all(line["type"] != "session" for line in session.lines[1:])


def test_one_that_is_held_stays_where_it_is_and_gets_no_set_points(session: Session) -> None:
    held, moved = session.seen["held"], session.seen["moved on"]
    assert (row(held, 1)["stage"], row(moved, 1)["mode"]) == ("operator", "hold")
    assert moved["t_s"] - held["t_s"] > 5.0
    before, after = row(held, 1)["p_ned"], row(moved, 1)["p_ned"]
    assert math.dist(before, after) < HOLD_POINT_M
    began, ended = session.times_s["hold 1"], session.times_s["rejoin 1"]
    points = [d["t_s"] for d in session.outcome.decisions if d["kind"] == "set_point" and d["sysid"] == 1]
    assert points
    assert not [t_s for t_s in points if began + 0.2 < t_s < ended - 1.0]


def test_orders_are_acknowledged_by_the_vehicles(session: Session) -> None:
    acks = [(e["sysid"], e["text"]) for e in session.events if e["kind"] == "ack" and e["level"] == "info"]
    for said in ((1, "Hold accepted"), (1, "Land accepted"), (GIVER, "Hold accepted"), (1, "Return accepted")):
        assert said in acks


def test_who_lands_by_order_is_no_failsafe_and_flies_again_when_it_rejoins(session: Session) -> None:
    assert row(session.seen["landed"], 1)["trouble"] == []
    assert -row(session.seen["back"], 1)["p_ned"][2] > 1.5
    assert not [e for e in session.events if e["kind"] == "failsafe"]
    landed = [m for _, m in session.outcome.messages("COMMAND_LONG") if m.target_system == 1 and m.command == LAND]
    assert len(landed) == 1


def test_who_is_asked_for_is_served_first_by_the_operator(session: Session) -> None:
    decided = [(d["receiver"], d["by"]) for d in session.outcome.decisions if d["kind"] == "decided"]
    assert decided[0] == (2, "operator")
    assert {(3, "competition"), (3, "unopposed")} & set(decided)
    first_of_3 = next(d["t_s"] for d in session.outcome.decisions if d["kind"] == "decided" and d["receiver"] == 3)
    assert first_of_3 >= session.times_s["skip 3 again"] - 1.0


def test_a_tanker_that_is_taken_breaks_its_transfer_off_in_order_and_no_joule_is_lost(session: Session) -> None:
    (ended,) = [d for d in session.outcome.decisions if d["kind"] == "served" and d["receiver"] == RECEIVER]
    assert "taken by the operator" in ended["reason"]
    assert ended["energy_j"] > 500
    sent = [(m.target_system, m.command, m.param2) for _, m in session.outcome.messages("COMMAND_LONG")]
    starts = [entry for entry in sent if entry[1] == TRANSFER]
    assert starts[:4] == [(RECEIVER, TRANSFER, 2.0), (GIVER, TRANSFER, 1.0), (GIVER, TRANSFER, 0.0),
                          (RECEIVER, TRANSFER, 0.0)]  # fmt: skip
    held = max(i for i, entry in enumerate(sent) if entry[:2] == (GIVER, SET_MODE) and entry[2] == 4.0)
    assert held > sent.index((GIVER, TRANSFER, 0.0))
    assert [v["energy"]["lost_j"] for v in session.outcome.summary["vehicles"]] == [0.0] * 6


def test_every_ledger_closes(session: Session) -> None:
    for sysid in (1, 2, 3, 101, 102, 201):
        truth = session.outcome.truth(sysid)
        assert truth.ledger_error_j() < 1e-6 * truth.head["capacity_j"]


def test_one_follows_its_new_target(session: Session) -> None:
    assert row(session.seen["moved on"], 2)["target_m"] < 2.5
    assert row(session.seen["held"], 2)["target_m"] > 2.5


def test_every_order_is_recorded_taken_or_not(session: Session) -> None:
    validator = jsonschema.Draft202012Validator(json.loads(
        resources.files("gcs").joinpath("schemas/decisions.schema.json").read_text(encoding="utf-8")))  # fmt: skip
    orders = [d for d in session.outcome.decisions if d["kind"] == "operator"]
    for record in orders:
        validator.validate(record)
    unrecorded = {"inspect", "inspect nobody", "unknown command", "of a replay"}
    assert [(d["taken"], d["text"]) for d in orders] == [
        (reply["ok"], reply["text"]) for name, reply in session.replies.items() if name not in unrecorded
    ]
    told = [e["text"] for e in session.events if e["kind"] == "operator"]
    refused = {True: "", False: "{command} refused: "}
    assert told == [f"Operator: {refused[d['taken']].format(**d)}{d['text']}" for d in orders if d["command"] != "stop"]


def test_what_is_inspected_is_told_with_its_rate_and_nothing_else(session: Session) -> None:
    snapshots = [line for line in session.lines if line["type"] == "snapshot"]
    inspected = session.seen["broken off"]["inspected"]
    assert list(inspected) == ["1"]
    attitude = inspected["1"]["ATTITUDE"]
    assert attitude["rate_hz"] == pytest.approx(10.0, rel=0.1)
    assert attitude["count"] > 50
    assert abs(attitude["fields"]["roll"]) < 0.2
    assert inspected["1"]["HEARTBEAT"]["rate_hz"] == pytest.approx(1.0, rel=0.3)
    assert snapshots[0]["inspected"] == {} == snapshots[-1]["inspected"]


def test_the_session_ends_as_interrupted_with_its_last_order_in_it(session: Session) -> None:
    assert session.outcome.summary["outcome"] == "interrupted"
    assert session.outcome.decisions[-1]["command"] == "stop"
