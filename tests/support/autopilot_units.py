"""Orders to launched autopilots, as the supervisor gives them, and what they answer."""

from __future__ import annotations

from pymavlink.dialects.v20 import common

from simvehicle.mavlink.codec import split
from simvehicle.mavlink.connection import Connection
from simvehicle.sitl.autopilot_unit import AutopilotUnit


def order(booted: AutopilotUnit, connection: Connection, sysid: int, command: int, *params: float) -> None:
    """Let it receive a command."""
    seven = (*params, *(0.0,) * (7 - len(params)))
    message = common.MAVLink_command_long_message(sysid, 1, command, 0, *seven)
    (frame,) = split(bytes(message.pack(common.MAVLink(None, 255, 190))))
    booted.receive(frame, connection)


def fixes_around_an_outage(booted: AutopilotUnit, connection: Connection, sysid: int) -> list[int]:
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
