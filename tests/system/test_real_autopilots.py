"""Autopilots that are not ours, flown by a session on our physics: a stand-in that speaks ArduPilot's JSON interface,
and a real ArduCopter where SKYTENDER_ARDUCOPTER names one."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import copter_names
import numpy as np
import psutil
import pytest
import yaml
from launched import first_heartbeat, launched
from on_our_physics import GUEST, assert_refuelled, assert_reported_where_it_is, mixed, several
from sessions import ROOT, Outcome, demo, fly, fly_apart

STAND_IN = ROOT / "tests" / "peers" / "json_arducopter.py"
REAL = os.environ.get("SKYTENDER_ARDUCOPTER", "")
COPTER = GUEST
PATIENCE_S = 400.0
"""Wall time of the demo with two real ones: a quarter of a minute on two cores that are free."""
NEEDS_REAL = pytest.mark.skipif(not REAL, reason="SKYTENDER_ARDUCOPTER names no ArduCopter's simulator")


def program(folder: Path, like: str = "4.7") -> Path:
    """The stand-in for a version as a program of its own."""
    path = folder / "arducopter"
    path.write_text(f'#!/bin/sh\nexec {sys.executable} {STAND_IN} --like {like} "$@"\n')
    path.chmod(0o755)
    return path


def with_copter(ardupilot: Path | str, **keys: Any) -> dict[str, Any]:
    """The fleet whose guest an ArduCopter flies."""
    params = copter_names.speed(ardupilot, 4.0)
    return mixed({"ardupilot": str(ardupilot)}, **{"params": params, **keys})


def copters() -> list[psutil.Process]:
    """Stand-ins and real ones that live."""
    programs = {str(STAND_IN), REAL} - {""}
    return [process for process in psutil.process_iter(["cmdline"]) if programs & {*(process.info["cmdline"] or [])}]


@pytest.fixture(scope="module", params=["4.6", "4.7", pytest.param("real", marks=NEEDS_REAL)])
def flown(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    folder = tmp_path_factory.mktemp("mixed")
    copter = REAL if request.param == "real" else program(folder, request.param)
    return fly(with_copter(copter), folder / "session", "--plain")


def test_it_takes_off_follows_its_target_and_is_recorded_as_ours_are(flown: Outcome) -> None:
    assert flown.status == 0, flown.stdout
    copter = flown.vehicle(COPTER)
    assert copter["final_mode"] == "offboard"
    assert copter["max_tracking_error_m"] < 2.0  # the stand-in has no integral, and wind pushes it
    assert flown.summary["digest"].startswith("sha256:")
    heartbeats = [m for _, m in flown.messages("HEARTBEAT") if m.get_srcSystem() == COPTER]
    assert {m.autopilot for m in heartbeats} == {3}
    assert "Flies on EKF3 (AHRS_EKF_TYPE 3)" in (flown.folder / "session.log").read_text()
    assert "ArduCopter" in (flown.folder / "vehicles" / str(COPTER) / "autopilot.log").read_text()


def test_it_takes_ten_kilojoules_in_the_air_and_flies_on(flown: Outcome) -> None:
    assert_refuelled(flown)


def test_what_it_reports_is_where_our_physics_has_it(flown: Outcome) -> None:
    assert_reported_where_it_is(flown, 0.4)


def test_it_flies_the_same_way_again(flown: Outcome, tmp_path: Path) -> None:
    named = yaml.safe_load((flown.folder / "scenario.yaml").read_text())["vehicles"]["pursuers"][1]["autopilot"]
    again = fly(with_copter(named["ardupilot"], duration_s=5.0), tmp_path / "session", "--plain")
    for sysid in (1, COPTER):
        before, now = flown.truth(sysid), again.truth(sysid)
        ticks = len(now.time_s)
        assert ticks >= 50
        assert np.array_equal(before.state[:ticks], now.state)
        assert np.array_equal(before.energy[:ticks], now.energy)
    assert copters() == []


def test_one_that_cannot_be_had_is_one_sentence_and_nothing_is_left(tmp_path: Path) -> None:
    outcome = fly(with_copter(program(tmp_path), params={"KIND": 1.0}), tmp_path / "session", "--plain")
    assert outcome.status == 1
    assert "is no ArduCopter with four rotors" in outcome.stderr
    assert "Traceback" not in outcome.stderr
    assert copters() == []


def test_one_in_python_finds_modules_beside_itself_where_the_supervisor_is_started_anew(tmp_path: Path) -> None:
    """A process with a second thread cannot fork its supervisor: it starts a Python that keeps its folder out of its
    path, which is no business of the autopilot's."""
    over = threading.Event()
    other = threading.Thread(target=over.wait)
    other.start()
    try:
        content = with_copter(program(tmp_path)) | {"goal": {"duration_s": 5.0}}
        outcome = fly(content, tmp_path / "session", "--plain")
    finally:
        over.set()
        other.join()
    assert outcome.status == 0, outcome.stderr


def test_a_period_that_is_no_multiple_of_its_step_is_flown(tmp_path: Path) -> None:
    content = with_copter(program(tmp_path), duration_s=8.0)
    content |= {"clock": {"mode": "lockstep", "period_s": 0.036}, "goal": {"duration_s": 8.0}}
    outcome = fly(content, tmp_path / "session", "--plain")
    assert outcome.status == 0, outcome.stderr
    assert {outcome.vehicle(sysid)["final_mode"] for sysid in (1, COPTER)} == {"offboard"}
    assert outcome.truth(COPTER).p_ned[-1, 2] < -1.0


def test_one_that_is_killed_is_lost_and_the_others_fly_on(tmp_path: Path) -> None:
    outcome = fly(
        with_copter(program(tmp_path), duration_s=8.0, params={"KILLED_AT_S": 6.0}), tmp_path / "session", "--plain"
    )
    assert outcome.status == 1
    assert outcome.summary["sim_time_s"] == 8.0
    assert "was killed by signal 9" in (outcome.folder / "session.log").read_text()
    assert outcome.vehicle(1)["final_mode"] == "offboard"
    assert copters() == []


def test_it_is_launched_for_other_ground_stations_too(tmp_path: Path) -> None:
    with launched(with_copter(program(tmp_path)), tmp_path) as where:
        heard = first_heartbeat(where[COPTER])
    assert (heard.get_srcSystem(), heard.autopilot, heard.custom_mode) == (COPTER, 3, 4)
    assert copters() == []


@NEEDS_REAL
@pytest.mark.timeout(PATIENCE_S + 60.0)
def test_a_real_one_that_is_never_ready_says_why(tmp_path: Path) -> None:
    """It has no GNSS, so that it never knows its place."""
    params = {"GPS_TYPE": 0.0, "GPS1_TYPE": 0.0}
    outcome = fly_apart(with_copter(REAL, params=params), tmp_path, "--plain", patience_s=PATIENCE_S)
    assert outcome.status == 1
    assert "was not ready in 120 s of its time: " in outcome.stderr
    assert "Traceback" not in outcome.stderr
    assert copters() == []


@NEEDS_REAL
@pytest.mark.timeout(PATIENCE_S + 60.0)
def test_two_of_ours_and_two_real_ones_meet_the_goal_of_the_demo(tmp_path: Path) -> None:
    content = demo()
    pursuers = content["vehicles"]["pursuers"][:4]
    for pursuer in pursuers[2:]:
        pursuer["autopilot"] = {"ardupilot": REAL}
    content["vehicles"]["pursuers"] = pursuers
    outcome = fly_apart(content, tmp_path / "session", "--plain", patience_s=PATIENCE_S)
    assert outcome.status == 0, outcome.stdout
    assert {3, 4} <= {service["receiver"] for service in outcome.summary["refuelling"]}


@NEEDS_REAL
def test_a_real_one_has_the_same_session_beside_other_work(tmp_path: Path) -> None:
    one = fly(with_copter(REAL), tmp_path / "one", "--plain")
    with subprocess.Popen([sys.executable, "-c", "while True: pass"]) as busy:
        try:
            other = fly(with_copter(REAL), tmp_path / "other", "--plain")
        finally:
            busy.kill()
    assert one.summary["digest"] == other.summary["digest"]


@NEEDS_REAL
def test_a_real_one_leans_into_the_wind_as_the_drag_of_its_rotors_says(tmp_path: Path) -> None:
    content = with_copter(REAL, duration_s=20.0)
    content.update(wind={"speed_m_s": 8.0}, refuelling={"enabled": False}, goal={"duration_s": 20.0})
    roll, pitch, _ = fly(content, tmp_path / "session", "--plain").truth(COPTER).state[-50:, 6:9].mean(axis=0)
    tilt = np.arccos(np.cos(roll) * np.cos(pitch))
    # iris: m g / cos = 4 k w^2, and a rotor's drag is 1.75e-4 kg times its speed w times the wind across
    mass, weight = 1.5, 1.5 * 9.80665
    rotor_rad_s = np.sqrt(weight / np.cos(tilt) / (4 * 5.84e-6))
    assert np.tan(tilt) == pytest.approx(4 * rotor_rad_s * 1.75e-4 * 8.0 * np.cos(tilt) / weight, rel=0.06)
    assert mass * np.tan(tilt) > 0.3


@NEEDS_REAL
def test_a_real_one_meets_the_sensors_and_faults_of_its_scenario(tmp_path: Path) -> None:
    """ArduCopter 4.6 leaves the ground after 9 s; a voltage counts while it neither spools up nor climbs."""
    content = with_copter(REAL, duration_s=25.0, sensors={})
    faults = [{"fault": "battery", "sysid": COPTER, "at_s": 15.0, "share": 0.3}]
    faults.append({"fault": "motor", "sysid": COPTER, "at_s": 22.0})
    content.update(wind={}, refuelling={"enabled": False}, goal={"duration_s": 25.0}, faults=faults)
    outcome = fly(content, tmp_path / "session", "--plain")
    truth = outcome.truth(COPTER)
    there = {round(t, 1): row for t, row in zip(truth.time_s, truth.p_ned, strict=True)}
    errors = np.array(
        [
            np.array((m.x + 2.0, m.y + 3.0, m.z)) - there[round(t, 1)]
            for t, m in outcome.messages("LOCAL_POSITION_NED")
            if m.get_srcSystem() == COPTER and 5.0 < t < 22.0
        ]
    )
    assert 0.02 < errors.std(axis=0).mean() < 0.5  # its estimate errs, and by no more than its sensors do
    volts = [(t, m.voltage_battery) for t, m in outcome.messages("SYS_STATUS") if m.get_srcSystem() == COPTER]
    before, after = ([v for t, v in volts if a < t < b] for a, b in ((12.0, 15.0), (17.0, 21.0)))
    assert min(before) - max(after) > 200  # mV; it measures what is gone
    assert there[21.9][2] < -1.0
    assert there[24.9][2] == pytest.approx(0.0, abs=0.01)


@NEEDS_REAL
def test_five_real_ones_fly_and_are_refuelled(tmp_path: Path) -> None:
    places = [(4.0, 4.0), (4.0, -4.0), (-4.0, 4.0), (-4.0, -4.0), (6.0, 0.0)]
    content = several(with_copter(REAL, duration_s=30.0), *places)
    outcome = fly(content, tmp_path / "session", "--plain")
    assert outcome.status == 0, outcome.stdout
    assert {outcome.vehicle(sysid)["final_mode"] for sysid in range(2, 7)} <= {"offboard", "refuel"}
