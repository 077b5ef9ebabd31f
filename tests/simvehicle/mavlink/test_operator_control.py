"""Operator control of one vehicle, spoken with pymavlink; the rules are those of MAV_CMD_REQUEST_OPERATOR_CONTROL and
CONTROL_STATUS in MAVLink's development.xml, for a single owner."""

import math
from typing import Any

import newer
import pytest
from pymavlink.dialects.v20 import common as mav

ACCEPTED, DENIED, FAILED, NOT_IN_CONTROL = 0, 2, 4, 10
REQUEST = newer.dialect.MAV_CMD_REQUEST_OPERATOR_CONTROL
MANAGER, ALLOWED = 1, 2
OURS, OTHER = (255, 190), (42, 190)
POSITION = 3576


def asked(bench: Any, station: tuple[int, int], *, release: bool = False, allow: bool = False) -> int:
    params = (float(not release), float(allow), 10.0, float(station[0]))
    return int(bench.result(REQUEST, *params, source=station))


def status(bench: Any) -> tuple[int, int]:
    bench.tick()
    last = bench.of("CONTROL_STATUS")[-1]
    assert list(last.gcs_secondary) == [0] * 10
    return last.gcs_main, last.flags


def test_nothing_is_said_and_every_station_commands_until_one_asks_for_control(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    assert bench.of("CONTROL_STATUS") == []
    for station in (OURS, OTHER):
        assert bench.result(mav.MAV_CMD_NAV_LOITER_UNLIM, source=station) == ACCEPTED
    ack, now = bench.command(mav.MAV_CMD_REQUEST_MESSAGE, 512.0)
    assert (ack.result, now.gcs_main, now.flags) == (ACCEPTED, 0, MANAGER | ALLOWED)


def test_the_owner_is_said_at_once_and_once_a_second(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    assert asked(bench, OURS) == ACCEPTED
    assert status(bench) == (255, MANAGER)
    bench.heard.clear()
    bench.fly(5.0)
    assert len(bench.of("CONTROL_STATUS")) == 5


def test_what_another_station_commands_is_refused_and_what_it_only_asks_is_not(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    asked(bench, OURS)
    for command in (mav.MAV_CMD_NAV_LAND, mav.MAV_CMD_COMPONENT_ARM_DISARM, mav.MAV_CMD_DO_SET_MODE):
        assert bench.result(command, 0.0, source=OTHER) == NOT_IN_CONTROL
    assert bench.result(mav.MAV_CMD_REQUEST_MESSAGE, 148.0, source=OTHER) == ACCEPTED
    assert bench.result(mav.MAV_CMD_SET_MESSAGE_INTERVAL, 30.0, 1e6, source=OTHER) == ACCEPTED
    assert bench.send(mav.MAVLink_param_request_read_message(1, 1, b"MPC_LAND_SPEED", -1), OTHER)
    assert bench.send(mav.MAVLink_mission_request_list_message(1, 1, 0), OTHER)
    assert bench.vehicle.mode == "hold"
    assert bench.result(mav.MAV_CMD_NAV_LAND, source=OURS) == ACCEPTED


@pytest.mark.parametrize(
    "message",
    [
        mav.MAVLink_set_mode_message(1, 1, 4 << 16 | 6 << 24),
        mav.MAVLink_param_set_message(1, 1, b"MPC_LAND_SPEED", 2.5, 9),
        mav.MAVLink_mission_count_message(1, 1, 1, 0),
        mav.MAVLink_set_position_target_local_ned_message(0, 1, 1, 1, POSITION, 9.0, 9.0, -9.0, *[0.0] * 8),
        mav.MAVLink_set_position_target_global_int_message(0, 1, 1, 5, POSITION, 0, 0, 500.0, *[0.0] * 8),
    ],
    ids=lambda message: str(message.get_type()),
)
def test_messages_that_change_its_state_are_the_owners_alone(vehicle_bench: Any, message: Any) -> None:
    bench = vehicle_bench().in_air()
    asked(bench, OURS)
    speed, mode = bench.vehicle.parameters["MPC_LAND_SPEED"], bench.vehicle.mode
    bench.heard.clear()
    assert bench.send(message, OTHER) == []
    assert (bench.vehicle.parameters["MPC_LAND_SPEED"], bench.vehicle.mode) == (speed, mode)
    assert math.isnan(bench.vehicle.set_point_now["time_s"])
    bench.tick()
    assert bench.texts[1:] == ["Refused: ground station 255 has control"]


def test_a_component_of_its_own_and_another_vehicle_are_no_other_station(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    asked(bench, OURS)
    assert bench.result(mav.MAV_CMD_NAV_LOITER_UNLIM, source=(1, 191)) == ACCEPTED
    assert bench.result(mav.MAV_CMD_NAV_LOITER_UNLIM, source=(7, 1)) == ACCEPTED


def test_without_permission_the_request_fails_and_the_owner_is_asked(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    asked(bench, OURS)
    answers = bench.command(REQUEST, 1.0, 0.0, 15.0, 42.0, source=OTHER)
    notice, ack = sorted(answers, key=lambda one: one.get_type() == "COMMAND_ACK")
    assert (ack.result, ack.target_system) == (FAILED, 42)
    assert (notice.get_type(), notice.command, notice.target_system) == ("COMMAND_LONG", REQUEST, 255)
    assert (notice.param1, notice.param2, notice.param3, notice.param4) == (1.0, 0.0, 15.0, 42.0)
    assert status(bench) == (255, MANAGER)
    assert asked(bench, OURS, allow=True) == ACCEPTED
    assert status(bench) == (255, MANAGER | ALLOWED)
    assert asked(bench, OTHER) == ACCEPTED
    assert status(bench) == (42, MANAGER)
    assert bench.result(mav.MAV_CMD_NAV_LOITER_UNLIM, source=OURS) == NOT_IN_CONTROL


def test_the_owner_gives_it_back_and_no_other_can(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    asked(bench, OURS)
    assert asked(bench, OTHER, release=True) == NOT_IN_CONTROL
    assert status(bench) == (255, MANAGER)
    assert asked(bench, OURS, release=True) == ACCEPTED
    assert status(bench) == (0, MANAGER | ALLOWED)
    assert bench.result(mav.MAV_CMD_NAV_LOITER_UNLIM, source=OTHER) == ACCEPTED


def test_a_lost_owner_is_a_lost_link_whatever_others_say_and_then_it_has_none(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"COM_DL_LOSS_T": 5.0}).in_air()
    asked(bench, OURS)
    for _ in range(49):
        bench.send(mav.MAVLink_heartbeat_message(mav.MAV_TYPE_GCS, 8, 0, 0, 4, 3), OTHER)
        bench.tick()
    assert (bench.vehicle.mode, status(bench)[0]) == ("hold", 255)
    bench.tick(2)
    assert "Failsafe: ground station lost, return" in bench.texts
    assert "Ground station 255 lost, nothing has control" in bench.texts
    assert status(bench) == (0, MANAGER | ALLOWED)


@pytest.mark.parametrize("params", [(1.0, 0.0, 10.0, 41.0), (2.0, 0.0, 10.0, 42.0), (1.0, 3.0, 10.0, 42.0)])
def test_a_request_for_another_station_or_with_nonsense_is_denied(
    vehicle_bench: Any, params: tuple[float, ...]
) -> None:
    assert vehicle_bench().result(REQUEST, *params, source=OTHER) == DENIED


def test_a_reboot_forgets_the_owner(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    asked(bench, OURS)
    bench.vehicle.restart()
    assert status(bench) == (0, MANAGER | ALLOWED)
