"""All that another ground station can say past our set points, said to a vehicle that flies them: it flies on alike."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.supervisor.forwarding import passed

PLACE = (3.0, -2.0, -4.0)
COMMANDS = (*mav.enums["MAV_CMD"], 59_999, 65_535)
READS = {"NONE", "TERMINATESESSION", "RESETSESSION", "LISTDIRECTORY", "OPENFILERO", "READFILE", "CALCFILECRC"}
READS |= {"BURSTREADFILE"}
"""MAVFTP's requests that leave files as they are, by MAVLink's definition."""
TARGETS = {"target_system": 1, "target": 1, "target_component": 1}


def value(kind: str, length: int, number: float) -> Any:
    """A field's value that its type holds: a number, or an array of it."""
    if kind == "char":
        return bytes(max(length, 1))
    one: float = number if kind in ("float", "double") else int(number) if math.isfinite(number) else 0
    return one if length == 0 else [one] * length


def filled(kind: type[Any], number: float, **given: Any) -> Any:
    """A message whose fields are all this number, but for its target and what is `given`."""
    fields = {}
    for name, type_, length in zip(kind.fieldnames, kind.fieldtypes, array_lengths(kind), strict=True):
        fields[name] = given.get(name, TARGETS.get(name, value(type_, length, number)))
    return kind(**fields)


def array_lengths(kind: type[Any]) -> list[int]:
    """Lengths of a message's arrays in the order of its fields, 0 of what is none."""
    lengths = dict(zip(kind.ordered_fieldnames, kind.array_lengths, strict=True))
    return [lengths[name] for name in kind.fieldnames]


def everything() -> Iterator[Any]:
    """Each message of the dialect that names a vehicle, each command in both forms, each request of MAVFTP."""
    draws = random.Random(7)
    for kind in mav.mavlink_map.values():
        if {"target_system", "target"} & set(kind.fieldnames):
            for number in (0, 1, 2, draws.randrange(3, 100)):
                yield filled(kind, number)
    for command in COMMANDS:
        for number in (0.0, 1.0, 30.0, math.nan):
            yield filled(mav.MAVLink_command_long_message, number, command=command, confirmation=0)
            yield filled(mav.MAVLink_command_int_message, number, command=command, frame=6, current=0)
    for opcode in range(256):
        payload = [0, 0, 1, opcode, 4, 0, 0, 0, 0, 0, 0, 0, *b"/log", *bytes(235)]
        yield filled(mav.MAVLink_file_transfer_protocol_message, 0, payload=payload)


def raw(message: Any) -> bytes:
    return bytes(message.pack(mav.MAVLink(None, 245, 190)))


def known(bench: Any) -> Any:
    """All that decides how a vehicle flies: its motion, its order, home, plans, parameters and battery."""
    v = bench.vehicle
    motion = (v.p_ned, v.v_ned, v.attitude_ned, v.mode, v.armed, v.remaining_j)
    order = (
        repr(v.set_point_now),  # with NaN for what it has not
        v.home_ned,
        v.mission,
        v.fence,
        v.rally_ned,
        (v.exchange.given_j, v.exchange.received_j, v.exchange.current),
        v.failed,
    )
    return motion, order, dict(v.parameters)


def test_what_passes_without_taking_a_vehicle_neither_moves_nor_re_aims_it(vehicle_bench: Any) -> None:
    """Beside a twin that hears our set points alone, to the last bit, after each message and at last."""
    bench, twin = vehicle_bench().offboard(PLACE), vehicle_bench().offboard(PLACE)
    said = 0
    for message in everything():
        (frame,) = codec.split(raw(message)).frames
        one = passed(frame, {1})
        if one is None or one.takes:
            continue
        said += 1
        for each in (bench, twin):
            each.gcs_heartbeat()
            each.set_point(PLACE)
        bench.feed(frame.raw)
        for each in (bench, twin):
            each.tick()
        assert known(bench) == known(twin), message
    assert said > 50
    for each in (bench, twin):
        each.fly(5.0, p_ned=PLACE)
    assert known(bench) == known(twin)
    assert bench.vehicle.mode == "offboard"


def test_what_passes_only_asks_by_its_name_in_mavlink_itself() -> None:
    """Every other message takes the vehicle or does not pass: one that a later dialect adds, too."""
    for message in everything():
        (frame,) = codec.split(raw(message)).frames
        one = passed(frame, {1})
        if one is None or one.takes:
            continue
        if message.get_type() == "FILE_TRANSFER_PROTOCOL":
            opcode = mav.enums["MAV_FTP_OPCODE"][message.payload[3]].name
            assert opcode.removeprefix("MAV_FTP_OPCODE_") in READS
        else:
            words = set(one.name.split("_"))
            assert words & {"REQUEST", "GET", "PING", "ACK", "CHECKS"}, one.name
            assert not words & {"SET", "DO", "NAV", "ERASE", "WRITE", "CLEAR", "INJECT"}, one.name


@pytest.mark.parametrize(
    "message",
    [
        filled(mav.MAVLink_mission_item_int_message, 0, frame=6, command=mav.MAV_CMD_NAV_WAYPOINT, current=2, z=50.0),
        filled(mav.MAVLink_mission_item_message, 0, frame=3, command=mav.MAV_CMD_NAV_WAYPOINT, current=2, z=50.0),
        filled(mav.MAVLink_set_home_position_message, 1),
        filled(mav.MAVLink_set_gps_global_origin_message, 1),
        filled(mav.MAVLink_gps_inject_data_message, 1),
        filled(mav.MAVLink_param_set_message, 1, param_id=b"MPC_XY_CRUISE"),
        filled(mav.MAVLink_mission_count_message, 1),
        filled(mav.MAVLink_mission_clear_all_message, 0),
        filled(mav.MAVLink_file_transfer_protocol_message, 0, payload=[0, 0, 1, 6, *bytes(247)]),
        filled(mav.MAVLink_command_long_message, 0.0, command=mav.MAV_CMD_PREFLIGHT_STORAGE, confirmation=0),
    ],
    ids=lambda message: message.get_type(),
)
def test_what_once_moved_a_vehicle_under_our_set_points_takes_it(message: Any) -> None:
    (frame,) = codec.split(raw(message)).frames
    one = passed(frame, {1})
    assert one is not None
    assert one.takes
