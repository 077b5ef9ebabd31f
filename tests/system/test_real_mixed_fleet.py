"""Real ArduCopters and a real PX4 in one session beside ours, where SKYTENDER_ARDUCOPTER and SKYTENDER_PX4 name them:
the demo's goal, and each failure of the world that a scenario may ask for."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sessions import Outcome, demo, fly_apart, small

ARDUCOPTER, PX4 = os.environ.get("SKYTENDER_ARDUCOPTER", ""), os.environ.get("SKYTENDER_PX4", "")
PATIENCE_S = 600.0
"""Wall time of one session here: it takes less than a minute on two cores that are free."""
pytestmark = [
    pytest.mark.skipif(not (ARDUCOPTER and PX4), reason="SKYTENDER_ARDUCOPTER and SKYTENDER_PX4 do not name both"),
    pytest.mark.timeout(PATIENCE_S + 60.0),
]
STARTS = {2: (4.0, 4.0, 0.0), 3: (4.0, -4.0, 0.0)}
BATTERY_S, GUST_S, JUMP_S, LOST_S, MOTOR_S, END_S = 8.0, 12.0, 18.0, 30.0, 68.0, 73.0
JUMP_M, OUT_FOR_S, GUST_M_S = 2.0, 8.0, 8.0


def real(path: str, kind: str) -> dict[str, Any]:
    return {"autopilot": {kind: path}}


def test_two_of_ours_two_arducopters_and_a_px4_meet_the_goal_of_the_demo(tmp_path: Path) -> None:
    content = demo()
    pursuers = content["vehicles"]["pursuers"]
    for pursuer, kind in zip(pursuers[2:], ("ardupilot", "ardupilot", "px4"), strict=True):
        pursuer.update(real(PX4 if kind == "px4" else ARDUCOPTER, kind))
    outcome = fly_apart(content, tmp_path / "session", "--plain", patience_s=PATIENCE_S)
    assert outcome.status == 0, outcome.stdout
    assert outcome.summary["outcome"] == "met"
    services = outcome.summary["refuelling"]
    assert {3, 4, 5} <= {service["receiver"] for service in services}
    for sysid in (3, 4, 5):
        truth = outcome.truth(sysid)
        drawn, received, given, remaining = truth.energy.T
        assert np.abs(truth.head["initial_j"] + received - drawn - given - remaining).max() < 1e-6
        assert received[-1] == sum(s["energy_j"] for s in services if s["receiver"] == sysid) > 0


@pytest.fixture(scope="module")
def failing(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    """One of ours, an ArduCopter and a PX4, which both have sensors that err, and meet one failure after another."""
    content = small(goal={"duration_s": END_S, "refuelled_at_least": 0, "lost_at_most": 2})
    content["refuelling"] = {"enabled": False}
    content["formation"] = {"ring_m": 4.0}
    content["wind"] = {"gusts": [{"at_s": GUST_S, "hold_s": 2.0, "speed_m_s": GUST_M_S, "from_deg": 0.0}]}
    (ours,) = content["vehicles"]["pursuers"]
    ours["battery"] = battery = {"capacity_j": 60000}
    for (sysid, start), (path, kind) in zip(STARTS.items(), ((ARDUCOPTER, "ardupilot"), (PX4, "px4")), strict=True):
        one = {"sysid": sysid, "start_m": [*start], "battery": battery, "sensors": {}, **real(path, kind)}
        content["vehicles"]["pursuers"].append(one)
    content["faults"] = [
        fault
        for sysid in STARTS
        for fault in (
            {"fault": "battery", "sysid": sysid, "at_s": BATTERY_S, "share": 0.2},
            {"fault": "gps_jump", "sysid": sysid, "at_s": JUMP_S, "for_s": 6.0, "jump_m": [JUMP_M, 0.0]},
            {"fault": "gps_off", "sysid": sysid, "at_s": LOST_S, "for_s": OUT_FOR_S},
            {"fault": "motor", "sysid": sysid, "at_s": MOTOR_S},
        )
    ]
    return fly_apart(content, tmp_path_factory.mktemp("failing"), "--plain", patience_s=PATIENCE_S)


def between(outcome: Outcome, sysid: int, kind: str, begin_s: float, end_s: float) -> list[tuple[float, Any]]:
    """Messages that a vehicle has said in a while of the session, and when."""
    found = outcome.messages(kind)
    return [
        (t, m) for t, m in found if begin_s < t <= end_s and (m.get_srcSystem(), m.get_srcComponent()) == (sysid, 1)
    ]


def at(outcome: Outcome, sysid: int, time_s: float) -> np.ndarray:
    """True state at a time of the session."""
    truth = outcome.truth(sysid)
    return np.asarray(truth.state[np.abs(truth.time_s - time_s).argmin()])


@pytest.mark.parametrize("sysid", STARTS)
def test_a_battery_drops_and_is_measured(failing: Outcome, sysid: int) -> None:
    before, after = (
        np.mean([m.voltage_battery for _, m in between(failing, sysid, "SYS_STATUS", BATTERY_S + a, BATTERY_S + b)])
        for a, b in ((-2.0, 0.0), (1.5, 3.5))
    )
    assert before - after > 100  # mV
    truth = failing.truth(sysid)
    assert -np.diff(truth.energy[:, 3]).min() == pytest.approx(12_000.0, abs=60.0)


@pytest.mark.parametrize("sysid", STARTS)
def test_a_gust_from_the_north_tilts_it(failing: Outcome, sysid: int) -> None:
    """Thrust leans to where the gust comes from: the estimate knows it as the truth does."""
    lean = {}
    for name, time_s in (("before", GUST_S - 0.5), ("in", GUST_S + 2.0)):
        roll, pitch, yaw = at(failing, sysid, time_s)[6:9]
        lean[name] = np.degrees(-pitch * np.cos(yaw) - roll * np.sin(yaw))
    assert lean["in"] - lean["before"] > 4.0


@pytest.mark.parametrize("sysid", STARTS)
def test_where_gnss_has_it_too_far_north_it_flies_as_far_south_until_that_is_over(failing: Outcome, sysid: int) -> None:
    errors_m = {}
    for name, time_s in (("before", JUMP_S), ("in", JUMP_S + 5.0), ("after", JUMP_S + 11.0)):
        (*_, (_, said)) = between(failing, sysid, "LOCAL_POSITION_NED", time_s - 1.0, time_s)
        errors_m[name] = said.x + STARTS[sysid][0] - at(failing, sysid, time_s)[0]
    assert abs(errors_m["before"]) < 1.5  # three deviations of its GNSS, and of its own
    assert errors_m["in"] - errors_m["before"] == pytest.approx(JUMP_M, abs=0.8)
    assert errors_m["after"] - errors_m["before"] == pytest.approx(0.0, abs=0.8)


@pytest.mark.parametrize("sysid", STARTS)
def test_its_estimate_errs_by_no_more_than_its_sensors_do(failing: Outcome, sysid: int) -> None:
    reported = between(failing, sysid, "LOCAL_POSITION_NED", 6.0, JUMP_S)
    errors = [np.array((m.x, m.y, m.z)) + STARTS[sysid] - at(failing, sysid, t)[:3] for t, m in reported]
    assert 0.02 < np.std(errors, axis=0).mean() < 0.5


@pytest.mark.parametrize("sysid", STARTS)
def test_without_a_fix_it_comes_down_by_itself_and_flies_again_with_it(failing: Outcome, sysid: int) -> None:
    fixes = [m.fix_type for _, m in between(failing, sysid, "GPS_RAW_INT", LOST_S + 1.0, LOST_S + OUT_FOR_S)]
    assert fixes or sysid == 2  # nobody has asked an ArduCopter for it
    assert all(fix < 3 for fix in fixes)
    modes = {
        s: {m.custom_mode for _, m in between(failing, sysid, "HEARTBEAT", s, s + 1.2)}
        for s in (LOST_S - 1.2, MOTOR_S - 1.2)
    }
    steered = {4} if sysid == 2 else {6 << 16}
    assert all(mode == steered for mode in modes.values()), modes
    out = {m.custom_mode for _, m in between(failing, sysid, "HEARTBEAT", LOST_S + 1.0, LOST_S + OUT_FOR_S)}
    assert out - steered, "its failsafe has not flown it"
    assert at(failing, sysid, MOTOR_S)[2] < -1.5


@pytest.mark.parametrize("sysid", STARTS)
def test_one_whose_motors_stop_falls(failing: Outcome, sysid: int) -> None:
    assert at(failing, sysid, END_S)[2] == pytest.approx(0.0, abs=0.01)
    fault = next(f for f in failing.summary["faults"] if (f["fault"], f["sysid"]) == ("motor", sysid))
    assert not fault["survived"]


def test_ours_beside_them_flies_on(failing: Outcome) -> None:
    assert failing.vehicle(1)["final_mode"] == "offboard"
    assert {f["survived"] for f in failing.summary["faults"] if f["fault"] != "motor"} == {True}
