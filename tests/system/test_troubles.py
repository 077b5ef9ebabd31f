"""What one vehicle's trouble does to the others: nothing that they need not suffer."""

from __future__ import annotations

import json
import signal
from pathlib import Path
from typing import Any

import numpy as np
from sessions import Running, demo, fly, merged, small
from ways import at_grants, nearest_m

OPEN = {"refuelling": {"enabled": False}}
PURSUERS = (1, 2, 3, 4, 5)


def paced(**changes: Any) -> dict[str, Any]:
    goal = {"duration_s": 45.0, "refuelled_at_least": 0}
    return merged(merged(demo(), {"clock": {"mode": "real", "speed": 5.0}, "goal": goal}), changes)


def test_pursuers_hold_when_their_target_dies(tmp_path: Path) -> None:
    content = paced(**OPEN)
    for pursuer in content["vehicles"]["pursuers"]:
        pursuer["battery"] = {"initial_percent": 100}
    running = Running(content, tmp_path, "--json")
    try:
        running.wait_for(lambda s: s["t_s"] > 20.0)
        running.vehicle(101).send_signal(signal.SIGKILL)
        outcome = running.finish()
    finally:
        running.stop()
    assert outcome.summary["outcome"] == "lost"
    for sysid in PURSUERS:
        truth = outcome.truth(sysid)
        late = truth.time_s > 35.0
        assert np.ptp(truth.p_ned[late], axis=0).max() < 1.0
        assert truth.p_ned[late, 2].max() < -0.3


def test_pursuers_stay_in_the_air_when_their_target_lands(tmp_path: Path) -> None:
    content = paced(clock={"mode": "lockstep"}, **OPEN)
    content["vehicles"]["targets"][0]["battery"] = {"capacity_j": 24000, "initial_percent": 25}
    outcome = fly(content, tmp_path, "--plain")
    target = outcome.truth(101)
    assert target.p_ned[-1, 2] == 0.0
    landed_s = float(target.time_s[np.flatnonzero(target.p_ned[:, 2] < 0.0)[-1]])
    for sysid in (1, 2):
        truth = outcome.truth(sysid)
        assert truth.p_ned[truth.time_s > landed_s - 5.0, 2].max() < -0.3
    assert "takes no more part" in outcome.stdout


def test_separation_is_not_measured_from_places_that_nobody_told(tmp_path: Path) -> None:
    dark = [{"sysid": 101, "from_s": 18.0, "to_s": 28.0}]
    outcome = fly(
        paced(clock={"mode": "lockstep"}, radio={"blackouts": dark}, goal={"duration_s": 32.0}, **OPEN),
        tmp_path,
        "--plain",
    )
    assert nearest_m(at_grants(outcome, (*PURSUERS, 101, 201))) >= 0.6
    assert "No telemetry for" in outcome.stdout
    assert "Heard again" in outcome.stdout


def test_a_vehicle_that_stalls_does_not_make_the_others_leave(tmp_path: Path) -> None:
    """Longer than the 10 s of silence after which a vehicle leaves its supervisor."""
    content = small(clock={"mode": "real", "speed": 2.0}, goal={"duration_s": 20.0, "refuelled_at_least": 0})
    running = Running(content, tmp_path, "--json")
    try:
        running.wait_for(lambda s: s["t_s"] > 3.0)
        stalled = running.vehicle(1)
        stalled.suspend()
        told: list[str] = []
        shown: dict[int, set[str]] = {1: set(), 101: set()}
        for line in running.lines():
            message = json.loads(line)
            told += [event["text"] for event in message.get("events", ())]
            for row in message.get("vehicles", ()) if message["type"] == "snapshot" else ():
                if row["sysid"] in shown and row["condition"] == "silent":
                    shown[row["sysid"]].add(row["figure"])
            if any("has not answered for 1" in text for text in told):
                break
        stalled.resume()
        outcome = running.finish()
    finally:
        running.stop()
    assert any("pursuer 1 lives but has not answered" in text for text in told)
    assert any(figure.startswith("no answer ") for figure in shown[1])
    assert shown[101] == set()
    assert outcome.status == 0
    assert outcome.summary["completed"] is True


def test_a_session_whose_vehicles_all_died_is_not_complete(tmp_path: Path) -> None:
    running = Running(small(clock={"mode": "real", "speed": 2.0}), tmp_path, "--json")
    try:
        running.wait_for(lambda s: s["t_s"] > 2.0)
        for sysid in (1, 101, 201):
            running.vehicle(sysid).send_signal(signal.SIGKILL)
        outcome = running.finish()
    finally:
        running.stop()
    assert outcome.summary["completed"] is False
    assert outcome.summary["outcome"] == "lost"


def test_parameters_that_a_vehicle_refuses_are_bad_input(tmp_path: Path) -> None:
    content = small()
    content["vehicles"]["pursuers"][0]["params"] = {"MPC_XY_VELMAX": 3.0}
    outcome = fly(content, tmp_path, "--plain")
    assert outcome.status == 2
    assert "MPC_XY_VEL_MAX" in outcome.stderr


def test_a_view_that_cannot_be_written_does_not_end_the_session(tmp_path: Path) -> None:
    running = Running(small(), tmp_path, "--plain", stdout="/dev/full")
    try:
        outcome = running.finish()
    finally:
        running.stop()
    assert outcome.summary["outcome"] == "met"
    assert "Traceback" not in outcome.stderr
