"""Requests for messages: messages once, streams at a rate, pings, time."""

from __future__ import annotations

import math

from simvehicle.mavlink.codec import message
from simvehicle.mavlink.commands import ACCEPTED, DENIED, UNSUPPORTED, VehicleCommand
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.context import Call, CommandHandler, MessageHandler, ServiceContext
from simvehicle.mavlink.services.component_metadata import component_metadata
from simvehicle.mavlink.telemetry import TELEMETRY, autopilot_version, available_modes, message_of
from skytender import mavlink as mav

FASTEST_HZ = 250
_POSITION = ("LOCAL_POSITION_NED", "GLOBAL_POSITION_INT")
_STATUS = ("SYS_STATUS", "GPS_RAW_INT", "BATTERY_STATUS", "EXTENDED_SYS_STATE")
DATA_STREAMS: dict[int, tuple[str, ...]] = {
    mav.MAV_DATA_STREAM_EXTENDED_STATUS: _STATUS,
    mav.MAV_DATA_STREAM_POSITION: _POSITION,
    mav.MAV_DATA_STREAM_EXTRA1: ("ATTITUDE",),
    mav.MAV_DATA_STREAM_EXTRA2: ("VFR_HUD",),
    mav.MAV_DATA_STREAM_ALL: (*_STATUS, *_POSITION, "ATTITUDE", "VFR_HUD"),
}
"""REQUEST_DATA_STREAM's groups; those that hold nothing that the vehicle sends are passed over."""


def set_interval(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    msgid, interval_us = request.whole(1, -1), request.value(2, 0.0)
    stops_heartbeat = msgid == mav.MAVLINK_MSG_ID_HEARTBEAT and interval_us < 0.0
    if stops_heartbeat or not math.isfinite(interval_us):
        return DENIED
    known = connection.streams.set_interval(msgid, interval_us, context.vehicle.time_ms)
    return ACCEPTED if known else UNSUPPORTED


def get_interval(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    return _answer_with_interval(context, request.whole(1, -1), connection)


def request_message(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    msgid = request.whole(1, -1)
    if msgid == mav.MAVLINK_MSG_ID_MESSAGE_INTERVAL:
        return _answer_with_interval(context, request.whole(2, -1), connection)
    if msgid in (mav.MAVLINK_MSG_ID_COMPONENT_METADATA, mav.MAVLINK_MSG_ID_CURRENT_EVENT_SEQUENCE):
        context.events.listen(connection)
    return _answer_with(context, msgid, request.whole(2))


def requests(msgid: int) -> CommandHandler:
    """The handler of a command that asks for one message, whatever its parameters."""
    return lambda context, _request, _connection: _answer_with(context, msgid)


def _answer_with_interval(context: ServiceContext, msgid: int, connection: Connection) -> int:
    interval_us = connection.streams.interval_us(msgid)
    if interval_us is None:
        return UNSUPPORTED
    context.after_ack.append(message("MESSAGE_INTERVAL")(message_id=msgid, interval_us=interval_us))
    return ACCEPTED


def _answer_with(context: ServiceContext, msgid: int, index: int = 0) -> int:
    """Accepted only with the message behind it; what the vehicle does not have is unsupported. `index`: the mode."""
    answers = [message_of(context.vehicle, stream.key) for stream in TELEMETRY if stream.msgid == msgid]
    if msgid == mav.MAVLINK_MSG_ID_AUTOPILOT_VERSION:
        answers = [autopilot_version(context.vehicle, context.sysid)]
    elif msgid == mav.MAVLINK_MSG_ID_AVAILABLE_MODES:
        answers = available_modes(context.vehicle, index)
    elif msgid == mav.MAVLINK_MSG_ID_AVAILABLE_MODES_MONITOR:
        answers = [message("AVAILABLE_MODES_MONITOR")()]  # its modes never change
    elif msgid == mav.MAVLINK_MSG_ID_COMPONENT_METADATA:
        answers = [component_metadata(context.vehicle)]
    elif msgid == mav.MAVLINK_MSG_ID_CURRENT_EVENT_SEQUENCE:
        answers = [context.events.current()]
    context.after_ack.extend(answers)
    return ACCEPTED if answers else UNSUPPORTED


def data_stream(context: ServiceContext, call: Call) -> None:
    content = call.content
    rate_hz = min(content.req_message_rate, FASTEST_HZ) if content.start_stop else 0
    for key in DATA_STREAMS.get(content.req_stream_id, ()):
        call.connection.streams.set_rate(key, rate_hz, context.vehicle.time_ms)


def ping(context: ServiceContext, call: Call) -> None:
    """The echo of a PING to all; one that is addressed is itself an echo."""
    if call.content.target_system == 0:
        system, component = call.sender
        call.connection.put(call.content._replace(target_system=system, target_component=component))


def timesync(context: ServiceContext, call: Call) -> None:
    """TIMESYNC: the asker's time returned with the own, in ns; an answer (tc1 not 0) gets none."""
    if call.content.tc1 == 0:
        unix_us = context.vehicle.unix_epoch_us + 1000 * context.vehicle.time_ms
        call.connection.put(call.content._replace(tc1=1000 * unix_us))


def request_event(context: ServiceContext, call: Call) -> None:
    context.events.request(call.content.first_sequence, call.content.last_sequence, call.sender, call.connection)


MESSAGES: dict[int, MessageHandler] = {
    mav.MAVLINK_MSG_ID_REQUEST_EVENT: request_event,
    mav.MAVLINK_MSG_ID_REQUEST_DATA_STREAM: data_stream,
    mav.MAVLINK_MSG_ID_PING: ping,
    mav.MAVLINK_MSG_ID_TIMESYNC: timesync,
}
COMMANDS: dict[int, CommandHandler] = {
    mav.MAV_CMD_SET_MESSAGE_INTERVAL: set_interval,
    mav.MAV_CMD_GET_MESSAGE_INTERVAL: get_interval,
    mav.MAV_CMD_REQUEST_MESSAGE: request_message,
    mav.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES: requests(mav.MAVLINK_MSG_ID_AUTOPILOT_VERSION),
    mav.MAV_CMD_GET_HOME_POSITION: requests(mav.MAVLINK_MSG_ID_HOME_POSITION),
}
