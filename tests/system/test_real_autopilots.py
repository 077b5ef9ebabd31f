"""Autopilots that are not ours, flown by a session on our physics: a stand-in that speaks ArduPilot's JSON interface,
and a real ArduCopter where SKYTENDER_ARDUCOPTER names one."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import pytest
from sessions import ROOT, Outcome, fly, small

STAND_IN = ROOT / "tests" / "peers" / "json_arducopter.py"
REAL = os.environ.get("SKYTENDER_ARDUCOPTER", "")
COPTER = 2


def program(folder: Path) -> Path:
    """The stand-in as a program of its own."""
    path = folder / "arducopter"
    path.write_text(f'#!/bin/sh\nexec {sys.executable} {STAND_IN} "$@"\n')
    path.chmod(0o755)
    return path


def mixed(ardupilot: Path | str, *, duration_s: float = 26.0, **keys: Any) -> dict[str, Any]:
    """One of ours, one that another autopilot flies and that needs energy, their target and a tanker, in wind."""
    goal = {"duration_s": duration_s, "refuelled_at_least": 1, "pursue": {"within_m": 3.5, "for_s": 5.0}}
    content = small(goal=goal, wind={"speed_m_s": 4.0, "from_deg": 200.0, "turbulence_m_s": 5.0})
    content["vehicles"]["pursuers"][0]["battery"]["initial_percent"] = 100
    battery = {"capacity_j": 60000, "initial_percent": 50}
    copter = {"sysid": COPTER, "start_m": [2.0, 3.0, 0.0], "battery": battery, "params": {"WPNAV_SPEED": 400.0}}
    content["vehicles"]["pursuers"].append({**copter, "autopilot": {"ardupilot": str(ardupilot)}, **keys})
    content["refuelling"] = {"limit_j": 10000}
    return content


def copters() -> list[psutil.Process]:
    """Stand-ins that live."""
    found = []
    for process in psutil.process_iter(["cmdline"]):
        if str(STAND_IN) in (process.info["cmdline"] or []):
            found.append(process)
    return found


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    folder = tmp_path_factory.mktemp("mixed")
    return fly(mixed(program(folder)), folder / "session", "--plain")


def test_it_takes_off_follows_its_target_and_is_recorded_as_ours_are(flown: Outcome) -> None:
    assert flown.status == 0, flown.stdout
    copter = flown.vehicle(COPTER)
    assert copter["final_mode"] == "offboard"
    assert copter["max_tracking_error_m"] < 2.0  # the stand-in has no integral, and wind pushes it
    assert flown.summary["digest"].startswith("sha256:")
    heartbeats = [m for _, m in flown.messages("HEARTBEAT") if m.get_srcSystem() == COPTER]
    assert {m.autopilot for m in heartbeats} == {3}
    assert "ArduCopter" in (flown.folder / "vehicles" / str(COPTER) / "autopilot.log").read_text()


def test_it_takes_ten_kilojoules_in_the_air_and_flies_on(flown: Outcome) -> None:
    (service, *_) = flown.summary["refuelling"]
    assert (service["receiver"], service["tanker"]) == (COPTER, 201)
    assert service["energy_j"] >= 10_000
    copter, tanker = flown.vehicle(COPTER)["energy"], flown.vehicle(201)["energy"]
    assert copter["received_j"] == service["energy_j"]
    assert tanker["given_j"] - tanker["received_j"] == copter["received_j"]  # what did not arrive came back
    assert tanker["lost_j"] == 0.0
    truth = flown.truth(COPTER)
    drawn, received, given, remaining = truth.energy.T
    assert np.abs(truth.head["initial_j"] + received - drawn - given - remaining).max() < 1e-6
    assert received[-1] == copter["received_j"]
    assert copter["drawn_j"] == pytest.approx(drawn[-1], abs=200.0)
    assert truth.p_ned[-1, 2] < -1.0


def test_what_it_reports_is_where_our_physics_has_it(flown: Outcome) -> None:
    truth = flown.truth(COPTER)
    reported = [(t, m) for t, m in flown.messages("LOCAL_POSITION_NED") if m.get_srcSystem() == COPTER]
    assert len(reported) > 100
    by_time = {round(t, 1): row for t, row in zip(truth.time_s, truth.p_ned, strict=True)}
    for t, m in reported[20:]:
        north, east, down = by_time[round(t, 1)] - [2.0, 3.0, 0.0]
        assert (m.x, m.y, m.z) == pytest.approx((north, east, down), abs=0.15)


def test_it_is_the_same_session_again(flown: Outcome, tmp_path: Path) -> None:
    again = fly(mixed(program(tmp_path)), tmp_path / "session", "--plain")
    assert again.summary["digest"] == flown.summary["digest"]
    assert copters() == []


@pytest.mark.parametrize(
    ("name", "keys", "said"),
    [
        ("none", {}, "cannot be started: No such file or directory"),
        ("/bin/true", {}, "ended with status 0, and said nothing"),
        ("", {"params": {"CRASH": 1.0}}, "ended with status 3; its last lines: PANIC: a parameter that it cannot bear"),
    ],
)
def test_one_that_cannot_be_had_is_one_sentence_and_nothing_is_left(
    tmp_path: Path, name: str, keys: dict[str, Any], said: str
) -> None:
    outcome = fly(mixed(name or program(tmp_path), **keys), tmp_path / "session", "--plain")
    assert outcome.status == 1
    assert said in outcome.stderr
    assert "Traceback" not in outcome.stderr
    assert copters() == []


def test_one_that_is_killed_is_lost_and_the_others_fly_on(tmp_path: Path) -> None:
    params = {"WPNAV_SPEED": 400.0, "KILLED_AT_S": 8.0}
    outcome = fly(mixed(program(tmp_path), duration_s=14.0, params=params), tmp_path / "session", "--plain")
    assert outcome.status == 1
    assert outcome.summary["sim_time_s"] == 14.0
    assert "was killed by signal 9" in (outcome.folder / "session.log").read_text()
    assert outcome.vehicle(1)["final_mode"] == "offboard"
    assert copters() == []


@pytest.mark.skipif(not REAL, reason="SKYTENDER_ARDUCOPTER names no ArduCopter's simulator")
def test_a_real_arducopter_flies_the_same_way_twice(tmp_path: Path) -> None:
    one, other = (fly(mixed(REAL, duration_s=80.0), tmp_path / name, "--plain") for name in ("one", "other"))
    assert one.status == 0, one.stdout
    assert one.summary["digest"] == other.summary["digest"]
