"""Standard modes: listed, reported and set as https://mavlink.io/en/services/standard_modes.html asks; numbers and
messages are pymavlink's own development dialect, which newer.xml agrees with."""

from typing import Any

import newer
import pytest
from pymavlink.dialects.v20 import development as mav

ACCEPTED, TEMPORARILY_REJECTED, UNSUPPORTED, FAILED = 0, 1, 3, 4
AVAILABLE, CURRENT, MONITOR = 435.0, 436.0, 437.0
RETURN, MISSION, LAND, TAKEOFF = 5, 6, 7, 8
SETTLED_BY_PX4 = {
    4 << 16 | 4 << 24: MISSION,
    4 << 16 | 5 << 24: RETURN,
    4 << 16 | 6 << 24: LAND,
    4 << 16 | 2 << 24: TAKEOFF,
}
"""PX4's getStandardModeFromNavState."""


def listed(bench: Any, index: int = 0) -> list[Any]:
    ack, *modes = bench.command(mav.MAV_CMD_REQUEST_MESSAGE, AVAILABLE, float(index))
    assert (ack.command, ack.result) == (mav.MAV_CMD_REQUEST_MESSAGE, ACCEPTED)
    return modes


@pytest.mark.parametrize("name", ["AVAILABLE_MODES", "CURRENT_MODE", "AVAILABLE_MODES_MONITOR"])
def test_the_definitions_that_pymavlink_has_too_are_the_same(name: str) -> None:
    msgid = getattr(mav, f"MAVLINK_MSG_ID_{name}")
    ours, theirs = newer.MESSAGES[msgid], mav.mavlink_map[msgid]
    for of in ("msgname", "crc_extra", "ordered_fieldnames", "fieldtypes", "array_lengths"):
        assert getattr(ours, of) == getattr(theirs, of)


@pytest.mark.parametrize("autopilot", ["px4", "ardupilot", "generic"])
def test_every_mode_is_listed_once_and_alone_under_its_index(vehicle_bench: Any, autopilot: str) -> None:
    bench = vehicle_bench(autopilot=autopilot)
    modes = listed(bench)
    assert [one.mode_index for one in modes] == list(range(1, len(modes) + 1))
    assert {one.number_modes for one in modes} == {len(modes)}
    assert len({one.custom_mode for one in modes}) == len(modes)
    for one in modes:
        assert bool(one.mode_name) is not bool(one.standard_mode)
        (alone,) = listed(bench, one.mode_index)
        assert alone.to_dict() == one.to_dict()
    assert set(bench.vehicle.identity.spoken.values()) == {one.custom_mode for one in modes}
    assert bench.result(mav.MAV_CMD_REQUEST_MESSAGE, AVAILABLE, float(len(modes) + 1)) == UNSUPPORTED


def test_a_px4s_standard_modes_are_px4s_and_an_ardupilot_has_none(vehicle_bench: Any) -> None:
    px4 = {one.custom_mode: one.standard_mode for one in listed(vehicle_bench()) if one.standard_mode}
    assert px4 == SETTLED_BY_PX4
    assert not any(one.standard_mode for one in listed(vehicle_bench(autopilot="ardupilot")))


def test_a_mode_that_no_one_may_ask_for_is_listed_as_such(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    for one in listed(bench):
        selectable = not one.properties & mav.MAV_MODE_PROPERTY_NOT_USER_SELECTABLE
        main, sub = one.custom_mode >> 16 & 0xFF, one.custom_mode >> 24
        known = bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, float(main), float(sub)) != UNSUPPORTED
        assert known is selectable


def test_the_current_mode_is_the_heartbeats_and_says_what_was_intended(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"COM_DL_LOSS_T": 5.0}).in_air()
    assert bench.result(mav.MAV_CMD_SET_MESSAGE_INTERVAL, CURRENT, 2e6) == ACCEPTED
    bench.heard.clear()
    bench.fly(4.2)
    assert [one.custom_mode for one in bench.of("CURRENT_MODE")] == [4 << 16 | 3 << 24] * 3
    bench.heard.clear()
    assert bench.result(mav.MAV_CMD_DO_SET_STANDARD_MODE, float(LAND)) == ACCEPTED
    bench.tick()
    (current,), (beat, *_) = bench.of("CURRENT_MODE"), bench.of("HEARTBEAT")
    assert (current.standard_mode, current.custom_mode) == (LAND, beat.custom_mode)
    assert current.intended_custom_mode == current.custom_mode
    bench = vehicle_bench(params={"COM_DL_LOSS_T": 5.0}).in_air()
    bench.fly(6.0, gcs=False)  # a failsafe, which nothing intended
    _, current = bench.command(mav.MAV_CMD_REQUEST_MESSAGE, CURRENT)
    assert current.standard_mode in (RETURN, LAND)
    assert current.intended_custom_mode == 4 << 16 | 3 << 24


def test_nothing_of_it_comes_unasked(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    assert not {"CURRENT_MODE", "AVAILABLE_MODES", "AVAILABLE_MODES_MONITOR"} & {one.get_type() for one in bench.heard}


def test_the_list_never_changes(vehicle_bench: Any) -> None:
    _, monitor = vehicle_bench().command(mav.MAV_CMD_REQUEST_MESSAGE, MONITOR)
    assert (monitor.get_type(), monitor.seq) == ("AVAILABLE_MODES_MONITOR", 0)


@pytest.mark.parametrize(("standard", "mode"), [(LAND, "land"), (RETURN, "return")])
def test_a_standard_mode_is_set(vehicle_bench: Any, standard: int, mode: str) -> None:
    bench = vehicle_bench().in_air()
    assert bench.result(mav.MAV_CMD_DO_SET_STANDARD_MODE, float(standard)) == ACCEPTED
    assert bench.vehicle.mode == mode


def test_a_standard_mode_takes_off_and_a_mission_needs_one(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.arm()
    assert bench.result(mav.MAV_CMD_DO_SET_STANDARD_MODE, float(MISSION)) == TEMPORARILY_REJECTED
    assert bench.result(mav.MAV_CMD_DO_SET_STANDARD_MODE, float(TAKEOFF)) == ACCEPTED
    assert bench.vehicle.mode == "takeoff"


@pytest.mark.parametrize("standard", [0, 1, 2, 3, 4, 9, 255, -1])
def test_other_standard_modes_fail_and_an_ardupilot_knows_none(vehicle_bench: Any, standard: int) -> None:
    assert vehicle_bench().result(mav.MAV_CMD_DO_SET_STANDARD_MODE, float(standard)) == FAILED
    assert vehicle_bench(autopilot="ardupilot").result(mav.MAV_CMD_DO_SET_STANDARD_MODE, 7.0) == UNSUPPORTED
