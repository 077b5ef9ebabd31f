"""A mission's present item: set by command or message, and said in MISSION_CURRENT."""

import math
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from tests.simvehicle.mavlink.test_mission_protocol import MISSION, mission_mode, reached, upload, waypoint

ACCEPTED, DENIED, FAILED = 0, 2, 4


def test_the_present_item_is_set_by_command_and_said_after_its_acknowledgement(vehicle_bench: Any) -> None:
    """Out of range is FAILED, also where there is no mission, and MISSION_CURRENT is no matter of its stream."""
    bench = vehicle_bench()
    command = mav.MAV_CMD_DO_SET_MISSION_CURRENT
    assert bench.result(command, 0.0) == bench.result(command, -1.0, 1.0) == FAILED
    upload(bench, [waypoint(bench, north, 0.0, 2.5) for north in (3.0, 6.0)])
    bench.command(mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAVLINK_MSG_ID_MISSION_CURRENT, -1.0)
    for number in (2.0, -2.0, math.nan, math.inf):
        assert bench.result(command, number) == FAILED
    assert bench.result(command, 0.0, 2.0) == DENIED
    for number, seq in ((1.0, 1), (1.0, 1), (-1.0, 1), (0.0, 0)):
        ack, current = bench.command(command, number)
        assert (ack.result, current.get_type(), current.seq) == (ACCEPTED, "MISSION_CURRENT", seq)
    (current,) = bench.send(mav.MAVLink_mission_set_current_message(1, 1, 1))
    assert (current.get_type(), current.seq) == ("MISSION_CURRENT", 1)


def test_a_mission_flown_to_its_end_is_paused_by_a_reset(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    upload(bench, [waypoint(bench, north, 0.0, 2.5) for north in (1.0, 3.0)])
    mission_mode(bench)
    bench.fly(15.0, until=lambda b: b.vehicle.mode == "hold")
    command = mav.MAV_CMD_DO_SET_MISSION_CURRENT
    for reset, state in ((0.0, mav.MISSION_STATE_COMPLETE), (1.0, mav.MISSION_STATE_PAUSED)):
        ack, current = bench.command(command, -1.0, reset)
        assert (ack.result, current.seq, current.mission_state) == (ACCEPTED, 1, state)
    mission_mode(bench)
    bench.fly(5.0, until=lambda b: b.vehicle.mode == "hold")
    assert reached(bench) == [0, 1, 1]


@pytest.mark.parametrize(("autopilot", "total"), [("px4", 2), ("ardupilot", 1)])
def test_home_is_no_item_of_the_total_and_without_a_mission_there_is_none(
    vehicle_bench: Any, autopilot: str, total: int
) -> None:
    bench = vehicle_bench(autopilot=autopilot)

    def current() -> tuple[int, int, int]:
        _, said = bench.command(mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_MISSION_CURRENT)
        return said.seq, said.total, said.mission_state

    assert current() == (0, 65535, mav.MISSION_STATE_NO_MISSION)
    upload(bench, [waypoint(bench, north, 0.0, 2.5) for north in (3.0, 6.0)])
    assert current() == (0, total, mav.MISSION_STATE_NOT_STARTED)
    bench.send(mav.MAVLink_mission_clear_all_message(1, 1, MISSION))
    assert current() == (0, 65535, mav.MISSION_STATE_NO_MISSION)


def test_an_ardupilot_with_nothing_but_home_has_no_mission(vehicle_bench: Any) -> None:
    bench = vehicle_bench(autopilot="ardupilot")
    upload(bench, [waypoint(bench, 0.0, 0.0, 0.0)])
    _, said = bench.command(mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_MISSION_CURRENT)
    assert (said.total, said.mission_state) == (65535, mav.MISSION_STATE_NO_MISSION)
