"""What is asked and said of what an autopilot flies on; its frames by pymavlink, its values as ArduPilot's parameter
documentation has them."""

from __future__ import annotations

from typing import Any

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.mavlink import codec
from gcs.mavlink.autopilots import PROFILES
from gcs.scenario.model import Scenario
from gcs.supervisor.estimators import ASK_EVERY_S, ASK_TIMES, Estimators

COPTER = 2
ARDUPILOT, PX4, GENERIC = (PROFILES[name] for name in ("ardupilot", "px4", "generic"))
NAMES = {0: "DCM", 2: "EKF2", 3: "EKF3", 11: "an estimator outside it"}


def estimators(*faults: str, sensors: bool = False) -> Estimators:
    ours = {"sysid": 1, "start_m": [4.0, 0.0, 0.0], "battery": {"capacity_j": 60000}, "plant": "rotors"}
    theirs = {**ours, "sysid": COPTER, "start_m": [0.0, 0.0, 0.0], "autopilot": {"ardupilot": "arducopter"}}
    made: dict[str, Any] = {"gps_jump": {"jump_m": [1.0, 0.0]}, "battery": {"share": 0.1}}
    return Estimators(
        Scenario.model_validate(
            {
                "schema": 1,
                "name": "estimates",
                "axes": "ned",
                "origin": {"lat_deg": 47.4, "lon_deg": 8.5, "alt_m": 488.0},
                "goal": {"duration_s": 60.0},
                "vehicles": {"pursuers": [ours, {**theirs, **({"sensors": {}} if sensors else {})}]},
                "faults": [
                    {"fault": fault, "sysid": sysid, "at_s": 10.0, **made.get(fault, {})}
                    for fault in faults
                    for sysid in (1, COPTER)
                ],
            }
        )
    )


def told(name: str, value: float, kind: int = mav.MAV_PARAM_TYPE_INT8) -> list[codec.Frame]:
    message = mav.MAVLink_param_value_message(name.encode(), value, kind, 900, 65535)
    return [*codec.split(bytes(message.pack(mav.MAVLink(None, COPTER, 1)))).frames]


@pytest.mark.parametrize("number", [-1, 0, 3, 10, 11])
def test_what_it_flies_on_is_said_once(number: int) -> None:
    found = estimators("battery")
    (asked,) = found.requests(COPTER, ARDUPILOT, 0.0)
    (m,) = mav.MAVLink(None).parse_buffer(codec.frame(asked, 0, 255, 190)) or []
    assert (m.get_type(), m.target_system, m.param_id, m.param_index) == (
        "PARAM_REQUEST_READ",
        COPTER,
        "AHRS_EKF_TYPE",
        -1,
    )
    assert found.receive(COPTER, told("AHRS_TRIM_X", 10.0), 0.1) is None
    event = found.receive(COPTER, told("AHRS_EKF_TYPE", number), 0.2)
    assert event is not None
    assert (event.t_s, event.sysid, event.level) == (0.2, COPTER, "warning" if number == 10 else "info")
    if number == 10:
        assert event.text == (
            "Flies on its simulation's truth (AHRS_EKF_TYPE 10) and not on an estimate, so errors and faults of its "
            "sensors have no effect"
        )
    else:
        name = NAMES.get(number, "an estimator that is not known here")
        assert event.text == f"Flies on {name} (AHRS_EKF_TYPE {number})"
    assert found.receive(COPTER, told("AHRS_EKF_TYPE", number), 0.3) is None
    assert found.requests(COPTER, ARDUPILOT, 100.0) == []


@pytest.mark.parametrize(
    ("faults", "sensors", "named"),
    [
        (("gps_off",), False, "gps_off"),
        (("gps_off", "gps_jump", "battery"), True, "sensors, gps_jump, gps_off"),
        (("motor",), True, "sensors"),
    ],
)
def test_what_of_the_scenario_has_no_effect_on_truth_is_named(
    faults: tuple[str, ...], sensors: bool, named: str
) -> None:
    found = estimators(*faults, sensors=sensors)
    found.requests(COPTER, ARDUPILOT, 0.0)
    event = found.receive(COPTER, told("AHRS_EKF_TYPE", 10.0), 0.1)
    assert event is not None
    assert event.text.endswith(f", so these have no effect on it: {named}")


def test_one_that_does_not_answer_is_asked_some_times_and_only_an_ardupilot_of_others_is() -> None:
    found = estimators()
    times = [k for k in range(100) if found.requests(COPTER, ARDUPILOT, 0.5 * k)]
    assert times == [round(2 * ASK_EVERY_S * k) for k in range(ASK_TIMES)]
    for profile in (PX4, GENERIC):
        assert estimators().requests(COPTER, profile, 0.0) == []
    assert estimators().requests(1, ARDUPILOT, 0.0) == []  # one of ours, of which the scenario says it
