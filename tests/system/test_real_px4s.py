"""PX4s flown by a session on our physics: a stand-in that speaks HIL, and a real one where SKYTENDER_PX4 names its
build."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import pytest
from launched import first_heartbeat, launched
from on_our_physics import GUEST, assert_refuelled, assert_reported_where_it_is, mixed, several
from sessions import ROOT, Outcome, Running, demo, fly, fly_apart

STAND_IN = ROOT / "tests" / "peers" / "hil_px4.py"
REAL = os.environ.get("SKYTENDER_PX4", "")
PX4 = GUEST
PATIENCE_S = 400.0
"""Wall time of a session that takes less than a minute on two cores that are free."""
NEEDS_REAL = pytest.mark.skipif(not REAL, reason="SKYTENDER_PX4 names no build/px4_sitl_default")


def build(folder: Path, like: str = "1.18") -> Path:
    """The stand-in for a version as a build of PX4's."""
    program = folder / "px4_sitl_default" / "bin" / "px4"
    scripts = program.parents[1] / "etc" / "init.d-posix"
    for made in (program.parent, scripts):
        made.mkdir(parents=True)
    (scripts / "rcS").touch()
    program.write_text(f'#!/bin/sh\nexec {sys.executable} {STAND_IN} --like {like} "$@"\n')
    program.chmod(0o755)
    return program.parents[1]


def with_px4(px4: Path | str, **keys: Any) -> dict[str, Any]:
    """The fleet whose guest a PX4 flies."""
    return mixed({"px4": str(px4)}, attitude_deg=[0.0, 0.0, 70.0], **keys)


def px4s() -> list[psutil.Process]:
    """Stand-ins and real ones that live."""
    programs = {str(STAND_IN), f"{Path(REAL).resolve()}/bin/px4" if REAL else ""} - {""}
    return [process for process in psutil.process_iter(["cmdline"]) if programs & {*(process.info["cmdline"] or [])}]


@pytest.fixture(scope="module", params=["1.15", "1.17", "1.18", pytest.param("real", marks=NEEDS_REAL)])
def flown(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    folder = tmp_path_factory.mktemp("mixed")
    px4 = REAL if request.param == "real" else build(folder, request.param)
    return fly(with_px4(px4), folder / "session", "--plain")


def test_it_takes_off_follows_its_target_and_is_recorded_as_ours_are(flown: Outcome) -> None:
    assert flown.status == 0, flown.stdout
    px4 = flown.vehicle(PX4)
    assert px4["final_mode"] == "offboard"
    assert px4["max_tracking_error_m"] < 2.0
    assert px4["missing_streams"] == []
    assert flown.summary["digest"] is None  # threads of a real one take turns as the machine lets them
    heartbeats = [m for _, m in flown.messages("HEARTBEAT") if m.get_srcSystem() == PX4]
    assert {m.autopilot for m in heartbeats} == {12}
    assert {6 << 16} <= {m.custom_mode for m in heartbeats}
    assert "px4" in (flown.folder / "vehicles" / str(PX4) / "autopilot.log").read_text()
    assert px4s() == []


def test_it_takes_ten_kilojoules_in_the_air_and_flies_on(flown: Outcome) -> None:
    assert_refuelled(flown)
    volts = [m.voltage_battery for _, m in flown.messages("SYS_STATUS") if m.get_srcSystem() == PX4]
    told = [sum(m.voltages[:4]) for _, m in flown.messages("BATTERY_STATUS") if m.get_srcSystem() == PX4]
    assert volts[-1] == pytest.approx(told[-1], abs=150)  # it measures our battery, half a second late


def test_what_it_reports_is_where_our_physics_has_it(flown: Outcome) -> None:
    assert_reported_where_it_is(flown, 0.6)


def test_one_that_cannot_be_had_is_one_sentence_and_nothing_is_left(tmp_path: Path) -> None:
    outcome = fly(with_px4("nowhere"), tmp_path / "session", "--plain")
    assert outcome.status == 1
    assert "nowhere cannot be started: there is no " in outcome.stderr
    assert "Traceback" not in outcome.stderr
    assert px4s() == []


@pytest.fixture(params=["stand-in", pytest.param("real", marks=NEEDS_REAL)])
def px4(request: pytest.FixtureRequest, tmp_path: Path) -> str:
    """A build of PX4's, the stand-in's and a real one."""
    return REAL if request.param == "real" else str(build(tmp_path))


def test_one_that_is_killed_is_lost_and_the_others_fly_on(px4: str, tmp_path: Path) -> None:
    running = Running(with_px4(px4, duration_s=30.0), tmp_path, "--json")
    try:
        running.wait_for(lambda seen: seen["t_s"] > 1.0)
        (one,) = px4s()
        one.kill()
        outcome = running.finish()
    finally:
        running.stop()
    assert outcome.status == 1
    assert outcome.summary["sim_time_s"] == 30.0
    assert "was killed by signal 9" in (outcome.folder / "session.log").read_text()
    assert outcome.vehicle(1)["final_mode"] == "offboard"
    assert px4s() == []


def test_it_is_launched_for_other_ground_stations_too(px4: str, tmp_path: Path) -> None:
    with launched(with_px4(px4), tmp_path) as where:
        heard = first_heartbeat(where[PX4])
    assert (heard.get_srcSystem(), heard.autopilot, heard.custom_mode) == (PX4, 12, 4 << 16 | 3 << 24)
    assert px4s() == []


@NEEDS_REAL
@pytest.mark.timeout(PATIENCE_S + 60.0)
def test_a_real_one_that_is_never_ready_says_why(tmp_path: Path) -> None:
    """It wants one satellite more than there are, so that it never knows its place. It says so once: by its link, or
    before that is up, in its last lines."""
    outcome = fly_apart(with_px4(REAL, params={"EKF2_REQ_NSATS": 13.0}), tmp_path, "--plain", patience_s=PATIENCE_S)
    assert outcome.status == 1
    assert "was not ready in 120 s of its time" in outcome.stderr
    assert "not enough GPS Satellites" in outcome.stderr
    assert "Traceback" not in outcome.stderr
    assert px4s() == []


@NEEDS_REAL
def test_two_of_ours_and_a_real_one_meet_the_goal_of_the_demo(tmp_path: Path) -> None:
    content = demo()
    pursuers = content["vehicles"]["pursuers"][:4]
    pursuers[3]["autopilot"] = {"px4": REAL}
    content["vehicles"]["pursuers"] = pursuers
    outcome = fly(content, tmp_path / "session", "--plain")
    assert outcome.status == 0, outcome.stdout


@NEEDS_REAL
def test_a_real_one_flies_nearly_the_same_way_again(tmp_path: Path) -> None:
    first, second = (fly(with_px4(REAL), tmp_path / name, "--plain").truth(PX4).p_ned for name in ("one", "other"))
    assert len(first) == len(second)
    assert np.abs(first - second).max() < 1.0


@NEEDS_REAL
def test_three_real_ones_fly_together(tmp_path: Path) -> None:
    content = several(with_px4(REAL, duration_s=30.0), (4.0, 4.0), (4.0, -4.0), (-4.0, 4.0))
    outcome = fly(content, tmp_path / "session", "--plain")
    assert outcome.status == 0, outcome.stdout
    assert {outcome.vehicle(sysid)["final_mode"] for sysid in range(2, 5)} <= {"offboard", "refuel"}
