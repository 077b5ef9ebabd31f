"""Failures that the world does to a vehicle whose autopilot is not ours."""

from __future__ import annotations

import math
from typing import Any

import pytest
from pymavlink.dialects.v20 import common

from simvehicle.mavlink.codec import ReceivedFrame, split
from simvehicle.mavlink.real_autopilots.world_failures import NOWHERE, WorldFailures

OFF, WRONG, OK = common.FAILURE_TYPE_OFF, common.FAILURE_TYPE_WRONG, common.FAILURE_TYPE_OK
GPS, BATTERY = common.FAILURE_UNIT_SENSOR_GPS, common.FAILURE_UNIT_SYSTEM_BATTERY
MOTOR, BAROMETER = common.FAILURE_UNIT_SYSTEM_MOTOR, common.FAILURE_UNIT_SENSOR_BARO
ACCEPTED, DENIED, UNSUPPORTED = 0, 2, 3


def order(*params: float, command: int = common.MAV_CMD_INJECT_FAILURE, target: int = 7) -> ReceivedFrame:
    seven = (*params, *(0.0,) * (7 - len(params)))
    message = common.MAVLink_command_long_message(target, 1, command, 0, *seven)
    (frame,) = split(bytes(message.pack(common.MAVLink(None, 255, 190))))
    return frame


def answered(failures: WorldFailures, *params: float) -> int:
    (ack,) = failures.receive(order(*params)) or []
    result: Any = ack.result
    return int(result)


def test_motors_battery_and_gps_fail_and_are_mended() -> None:
    gone: list[float] = []
    failures = WorldFailures(7, gone.append)
    assert answered(failures, MOTOR, OFF, 3) == ACCEPTED
    assert failures.dead_motors == {2}
    assert answered(failures, MOTOR, OFF, 0) == ACCEPTED
    assert failures.dead_motors == {0, 1, 2, 3}
    assert answered(failures, MOTOR, OK, 1) == ACCEPTED
    assert failures.dead_motors == {1, 2, 3}
    assert answered(failures, BATTERY, WRONG, 0, 1500.0) == ACCEPTED
    assert gone == [1500.0]
    assert answered(failures, GPS, WRONG, 0, 0.0, 12.0, -3.0) == ACCEPTED
    assert failures.position_error_ned == (12.0, -3.0, 0.0)
    assert answered(failures, GPS, OFF) == ACCEPTED
    assert failures.gnss_lost
    assert answered(failures, GPS, OK) == ACCEPTED
    assert (failures.position_error_ned, failures.gnss_lost) == (NOWHERE, False)


@pytest.mark.parametrize(
    ("params", "result"),
    [
        ((MOTOR, OFF, 5), DENIED),
        ((BATTERY, WRONG, 0, math.nan), DENIED),
        ((BATTERY, WRONG, 0, -1.0), DENIED),
        ((GPS, WRONG, 0, 0.0, 1e9), DENIED),
        ((GPS, common.FAILURE_TYPE_STUCK), UNSUPPORTED),
        ((BAROMETER, WRONG), UNSUPPORTED),
        ((BATTERY, OFF), UNSUPPORTED),
    ],
)
def test_what_cannot_be_is_not_done(params: tuple[float, ...], result: int) -> None:
    failures = WorldFailures(7, lambda _: None)
    assert answered(failures, *params) == result
    assert (failures.dead_motors, failures.position_error_ned) == (set(), NOWHERE)


def test_other_frames_are_the_autopilot_s() -> None:
    failures = WorldFailures(7, lambda _: None)
    assert failures.receive(order(1.0, command=common.MAV_CMD_COMPONENT_ARM_DISARM)) is None
    assert failures.receive(order(MOTOR, OFF, target=8)) is None
