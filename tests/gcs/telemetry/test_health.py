"""What is wrong with a vehicle, worst first, and its part in the refuelling."""

import math
from typing import Any

import pytest
from views import view

from gcs.mavlink.autopilots import FlightMode
from gcs.telemetry.health import (
    ACT,
    CONDITIONS,
    LOOK,
    WELL,
    HealthIssue,
    Known,
    State,
    Worst,
    health_issues,
    severity,
    state,
    worst,
)
from skytender import mavlink as mav

NOW_S = 100.0
REMOVED, PILOTED = {"ours": False}, {"mode": FlightMode.MANUAL}
HELD = {"mode": FlightMode.HOLD}
GROUNDED = {"armed": False, "landed": True}
BARRED = mav.MAV_SYS_STATUS_PREARM_CHECK


def issues(changed: Any, how: Any) -> list[HealthIssue]:
    """Of a vehicle in flight that is changed; `how`: what is known of it, and of its link."""
    known = {name: value for name, value in how.items() if name in Known._fields}
    link = {name: value for name, value in how.items() if name not in Known._fields}
    return health_issues(view(**changed), NOW_S, Known(**known), **link)


def test_a_vehicle_that_is_well_has_no_trouble() -> None:
    assert health_issues(view(), NOW_S) == []
    assert severity([]) == WELL


@pytest.mark.parametrize(
    ("changed", "how", "text", "how_bad"),
    [
        ({"alive": False}, {}, "dead", ACT),
        ({"last_received_s": -math.inf, "last_message_s": -math.inf}, {}, "no telemetry yet", LOOK),
        ({"last_received_s": 96.0, "last_message_s": 96.0}, {}, "no telemetry for 4 s", ACT),
        ({"last_received_s": 94.0, "last_message_s": 96.0}, {}, "no telemetry for 4 s", ACT),
        ({"last_received_s": 96.0}, {}, "no HEARTBEAT for 4 s", ACT),
        ({"last_received_s": -math.inf}, {}, "no HEARTBEAT for 100 s", ACT),
        ({"uncertain": "by its own word"}, {}, "position uncertain", LOOK),
        ({"p_ned": None}, {}, "no position", LOOK),
        ({"age_s": 2.0}, {}, "position out of date", LOOK),
        ({"drawn_j": 8_500.0}, {}, "battery 15 %", LOOK),
        ({"drawn_j": 9_200.0}, {}, "battery 8 %", ACT),
        ({"drawn_j": 10_400.0, "power_w": 0.0}, {}, "battery 0 %", ACT),
        ({"power_w": 100.0}, {}, "50 s of flight left", LOOK),
        ({"power_w": 250.0}, {}, "20 s of flight left", ACT),
        ({"mode": FlightMode.LAND}, {}, "Land", ACT),
        ({"mode": FlightMode.RETURN}, {}, "Return", ACT),
        ({"mode": FlightMode.RETURN}, {"ordered": "return"}, "Return", LOOK),
        ({"mode": FlightMode.LAND}, {"ordered": "return"}, "Land", LOOK),
        ({"mode": FlightMode.LAND}, {"ordered": "land"}, "Land", LOOK),
        ({"mode": FlightMode.LAND}, {"ordered": "hold"}, "Land", ACT),
        ({"mode": FlightMode.HOLD, "drawn_j": 6_000.0}, {"ordered": "hold"}, "held, not refuelled", LOOK),
        ({"armed": False, "landed": True}, {"down": True, "ordered": "hold"}, "not flying", ACT),
        ({"armed": False, "landed": True}, {"down": True}, "not flying", ACT),
        ({**HELD, "failsafe": True}, {}, "failsafe: Hold", ACT),
        ({"mode": FlightMode.LAND, "failsafe": True}, REMOVED, "failsafe: Land", ACT),
        ({"mode": FlightMode.LAND, "failsafe": True}, {"ordered": "land"}, "failsafe: Land", LOOK),
        ({"mode": FlightMode.LAND}, REMOVED, "Land", LOOK),
        (HELD, {}, "Hold without an order", LOOK),
        (PILOTED, {}, "Manual without an order", LOOK),
        (PILOTED, {"ordered": "hold"}, "Manual without an order", LOOK),
        (PILOTED, {"on_mission": True}, "Manual without an order", LOOK),
        (GROUNDED | {"unhealthy": BARRED | mav.MAV_SYS_STATUS_SENSOR_GPS}, {}, "not ready: GPS", LOOK),
        (GROUNDED | {"unhealthy": BARRED}, REMOVED, "not ready: its own checks fail", LOOK),
        ({"unhealthy": int(mav.MAV_SYS_STATUS_GEOFENCE)}, {}, "outside its geofence", ACT),
        ({}, {"too_near": "0.02 m from mast"}, "0.02 m from mast", ACT),
        ({}, {"out_of_order": True}, "out of order", LOOK),
        ({}, {"unanswered_s": 7.4}, "no answer for 7 s", ACT),
        ({}, {"lost_share": 0.3}, "30 % packet loss", LOOK),
        ({}, {"lost_share": 0.7}, "70 % packet loss", ACT),
    ],
)
def test_each_trouble_has_its_words_and_its_weight(changed: Any, how: Any, text: str, how_bad: int) -> None:
    found = issues(changed, how)
    assert [trouble.text for trouble in found] == [text]
    assert severity(found) == how_bad


@pytest.mark.parametrize(
    ("changed", "how"),
    [
        ({"drawn_j": 9_900.0, "energy_source": "none", "power_w": 0.0}, {}),  # it has not told any energy
        ({"armed": False, "landed": True, "mode": FlightMode.LAND}, {}),  # it has landed and is done
        ({"armed": False, "landed": True}, {"ordered": "land"}),
        ({"armed": False, "landed": True, "power_w": 250.0}, {}),  # nothing falls from the ground
        (HELD, {"ordered": "hold"}),
        (HELD, {"on_mission": True}),
        (HELD, REMOVED),
        (HELD | {"has_climbed": True}, {}),
        (PILOTED, REMOVED),
        (PILOTED | GROUNDED, {}),
        ({"unhealthy": BARRED | mav.MAV_SYS_STATUS_SENSOR_GPS}, {}),  # in flight nothing is armed
        (GROUNDED | {"unhealthy": int(mav.MAV_SYS_STATUS_SENSOR_3D_MAG)}, {}),  # one of several
        ({}, {"unanswered_s": 2.9}),
        ({}, {"lost_share": 0.1}),
    ],
)
def test_what_is_in_order_is_no_trouble(changed: Any, how: Any) -> None:
    assert issues(changed, how) == []


def test_the_worst_comes_first() -> None:
    found = health_issues(view(age_s=2.0, drawn_j=9_500.0, mode=FlightMode.LAND), NOW_S, lost_share=0.3)
    assert [trouble.severity for trouble in found] == sorted((trouble.severity for trouble in found), reverse=True)
    assert {"battery 5 %", "Land", "position out of date", "30 % packet loss"} <= {trouble.text for trouble in found}


SILENT = {"last_received_s": 91.0, "last_message_s": 91.0}


@pytest.mark.parametrize(
    ("changed", "how", "expected"),
    [
        ({}, {}, Worst()),
        ({"alive": False, **SILENT}, {}, ("dead", "9 s", 9.0)),
        ({"alive": False, "last_received_s": -math.inf, "last_message_s": -math.inf}, {}, ("dead", "never heard", 0.0)),
        ({**SILENT, "power_w": 250.0, "mode": FlightMode.LAND}, {}, ("silent", "9 s", 9.0)),
        ({"mode": FlightMode.LAND, "power_w": 250.0}, {}, ("failing", "Land", 0.0)),
        ({"power_w": 250.0, "drawn_j": 5_000.0}, {"lost_share": 0.3}, ("low", "20 s", -20.0)),
        ({"power_w": 30.0, "drawn_j": 8_500.0}, {}, ("low", "50 s", -50.0)),
        ({"armed": False, "landed": True, "drawn_j": 8_500.0}, {"ordered": "land"}, ("low", "15 %", -1e6 - 15)),
        ({}, {"lost_share": 0.3}, ("warned", "30 % packet loss", 0.0)),
        ({}, {"lost_share": 0.7}, ("failing", "70 % packet loss", 0.0)),
    ],
)
def test_a_vehicles_condition_is_the_worst_that_it_is_in(changed: Any, how: Any, expected: Any) -> None:
    """Of 10 kJ, 100 W last 100 s; LOOK below 60 s."""
    assert worst(issues(changed, how)) == expected


def test_conditions_go_from_dead_to_warned() -> None:
    assert CONDITIONS == ("dead", "silent", "failing", "low", "warned")


@pytest.mark.parametrize("message_s", [-math.inf, 0.4])
def test_what_has_not_sent_a_heartbeat_yet_is_waited_for_and_is_silent_after_three_seconds(message_s: float) -> None:
    unheard = view(last_received_s=-math.inf, last_message_s=message_s)
    assert worst(health_issues(unheard, 0.5)) == ("warned", "none yet", 0.0)
    assert worst(health_issues(unheard, 3.0)).condition == "silent"


@pytest.mark.parametrize(
    ("parts", "part"),
    [
        ({}, State.IDLE),
        ({"competing": {3}}, State.COMPETING),
        ({"competing": {3}, "leader": 3}, State.LEADS),
        ({"waiting": {3}, "competing": {3}}, State.WAITS),
        ({"served": {3}}, State.SERVED),
        ({"serving": {3}}, State.SERVES),
    ],
)
def test_a_vehicles_part_in_the_refuelling(parts: Any, part: State) -> None:
    assert state(view(), **parts) is part
    assert state(view(alive=False), **parts) is State.LOST
