"""Launched autopilots, here stand-ins; orders to them, as the supervisor gives them, and what they answer."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any, TypeVar

from pymavlink.dialects.v20 import common

from simvehicle.mavlink.codec import split
from simvehicle.mavlink.connection import Connection
from simvehicle.sitl.autopilot_process import read_wanted
from simvehicle.sitl.autopilot_unit import AutopilotUnit

PEERS = Path(__file__).resolve().parents[1] / "peers"
LAUNCHED = 7
"""System id of what is launched, where no other is asked for."""
Launched = TypeVar("Launched", bound=AutopilotUnit)


def stand_in(program: Path, script: str, like: str) -> Path:
    """A program that is the stand-in of tests/peers for a version."""
    program.write_text(f'#!/bin/sh\nexec {sys.executable} {PEERS / script} --like {like} "$@"\n')
    program.chmod(0o755)
    return program


def launched(
    kind: type[Launched],
    program: Path,
    folder: Path,
    *,
    sysid: int = LAUNCHED,
    sensors: dict[str, float] | None = None,
    **given: float,
) -> tuple[Launched, Connection]:
    """A program, booted in a folder of its own; `given`: its parameters. Raises AutopilotError."""
    content = {
        "program": str(program),
        "folder": str(folder / "own"),
        "home": [47.4, 8.5, 488.0],
        "start_ned": [1.0, 2.0, 0.0],
        "yaw_deg": 70.0,
        "epoch_s": 1_770_000_000,
        "battery": {"capacity_j": 60000.0, "initial_j": 30000.0, "hover_w": 200.0, "avionics_w": 10.0},
        "capture_m": 1.5,
        "relative_speed_m_s": 0.5,
        "parameters": given,
        "truth": None,
        "world": {"vehicles": {sysid: {"airframe": "iris", "sensors": sensors}}},
    }
    wanted, plant = read_wanted(content, sysid, kind.step_ms / 1e3)
    connection = Connection(sysid)
    return kind(wanted, plant, connection), connection


def said_in_flight(
    booted: AutopilotUnit, connection: Connection, streamed: int, *, within_mv: int
) -> dict[str, list[Any]]:
    """What it says by kind in its first 3 s, asked for a message every 100 ms: nothing of its boot, no clock, and of
    its battery what SYS_STATUS says too, its voltage within so much."""
    assert connection.frames() == []
    booted.start_clock(5000, 0)
    order(booted, connection, LAUNCHED, common.MAV_CMD_SET_MESSAGE_INTERVAL, streamed, 1e5)
    booted.advance(8000)
    said: dict[str, list[Any]] = {}
    for message in common.MAVLink(None).parse_buffer(b"".join(connection.frames())) or []:
        said.setdefault(message.get_type(), []).append(message)
    assert {"HEARTBEAT", "SYS_STATUS", "BATTERY_STATUS", "COMMAND_ACK", "NAMED_VALUE_INT"} <= said.keys()
    assert not said.keys() & {"SYSTEM_TIME", "PARAM_VALUE"}
    status, battery = said["SYS_STATUS"][-1], said["BATTERY_STATUS"][-1]
    assert abs(status.voltage_battery - sum(battery.voltages[:4])) <= within_mv
    assert status.battery_remaining == battery.battery_remaining == 50
    return said


def order(booted: AutopilotUnit, connection: Connection, sysid: int, command: int, *params: float) -> None:
    """Let it receive a command."""
    seven = (*params, *(0.0,) * (7 - len(params)))
    message = common.MAVLink_command_long_message(sysid, 1, command, 0, *seven)
    (frame,) = split(bytes(message.pack(common.MAVLink(None, 255, 190))))
    booted.receive(frame, connection)


def fixes_around_an_outage(booted: AutopilotUnit, connection: Connection, sysid: int = LAUNCHED) -> list[int]:
    """GPS fix that it reports after 2 s without GNSS, and 2 s after that; nothing but its orders is acknowledged."""
    order(booted, connection, sysid, common.MAV_CMD_SET_MESSAGE_INTERVAL, common.MAVLINK_MSG_ID_GPS_RAW_INT, 2e5)
    fixes: list[int] = []
    for to_ms, kind in ((2000, common.FAILURE_TYPE_OFF), (4000, common.FAILURE_TYPE_OK)):
        order(booted, connection, sysid, common.MAV_CMD_INJECT_FAILURE, common.FAILURE_UNIT_SENSOR_GPS, kind)
        booted.advance(to_ms)
        said = common.MAVLink(None).parse_buffer(b"".join(connection.frames())) or []
        fixes.append([m.fix_type for m in said if m.get_type() == "GPS_RAW_INT"][-1])
        answered = {m.command: m.result for m in said if m.get_type() == "COMMAND_ACK"}
        assert answered.pop(common.MAV_CMD_INJECT_FAILURE) == common.MAV_RESULT_ACCEPTED
        assert set(answered) <= {common.MAV_CMD_SET_MESSAGE_INTERVAL}  # what the process asked for is its own
    return fixes
