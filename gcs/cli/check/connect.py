"""Questions of peers at connect: version, home, message intervals, time, FTP, plans, command handling."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from gcs.cli.check.asking import (
    MAVPROXY,
    MAVSDK,
    QGC,
    Ask,
    command_int,
    command_long,
    commanded,
    requested,
    to_vehicle,
)
from gcs.cli.check.control import STATUS
from gcs.cli.check.dialogue import CheckedVehicle, Question
from gcs.cli.check.modes import MODES
from gcs.cli.check.predicates import OK, always, answered, leaves_alone, refuses
from gcs.mavlink.codec import Message, message
from skytender import mavlink as mav

UNKNOWN_COMMAND = 65000
OPEN_FILE, RESET_SESSIONS, FTP_ACK, FTP_NAK = 4, 2, 128, 129


def _version_fault(vehicle: CheckedVehicle, content: Any) -> str:
    if not content.capabilities & mav.MAV_PROTOCOL_CAPABILITY_MISSION_INT:
        return "its capabilities lack MISSION_INT"
    if not content.capabilities & mav.MAV_PROTOCOL_CAPABILITY_MAVLINK2:
        return "its capabilities lack MAVLINK2"
    number = tuple(content.flight_sw_version >> shift & 0xFF for shift in (24, 16, 8))
    oldest = vehicle.profile.oldest_version
    if oldest is not None and number < oldest:
        wanted = ".".join(map(str, oldest))
        return f"its version is {'.'.join(map(str, number))}, QGroundControl wants {wanted} at least"
    return ""


def _ping() -> Question:
    def ask(_: CheckedVehicle) -> Sequence[Message]:
        return [message("PING", time_usec=1, seq=4711, target_system=0, target_component=0)]

    def ours(vehicle: CheckedVehicle, content: Any) -> bool:
        return bool(content.seq == 4711 and (content.target_system, content.target_component) == vehicle.station)

    return Question(
        "ping",
        "PING echoed to its sender",
        {MAVSDK: "has no round-trip time"},
        answered("PING", ours=ours),
        ask,
        when=lambda v: "" if v.profile.pinged else "MAVSDK sends ArduPilot none",
    )


def _timesync() -> Question:
    def ask(_: CheckedVehicle) -> Sequence[Message]:
        return [message("TIMESYNC", tc1=0, ts1=123_456_789)]

    def ours(_: CheckedVehicle, content: Any) -> bool:
        return bool(content.tc1 != 0 and content.ts1 == 123_456_789)

    misses = {MAVSDK: "cannot align clocks", MAVPROXY: "has no link delay to show"}
    return Question("timesync", "TIMESYNC answered with its own time", misses, answered("TIMESYNC", ours=ours), ask)


def _ftp(number: int, opcode: int, data: bytes = b"") -> Ask:
    """A request of its own number: one that is repeated is answered by what was answered before."""
    payload = bytes([number, 0, 0, opcode, len(data), 0, 0, 0, 0, 0, 0, 0]) + data
    return to_vehicle("FILE_TRANSFER_PROTOCOL", target_network=0, payload=list(payload.ljust(251, b"\0")))


def _ftp_answer(opcode: int) -> Callable[[CheckedVehicle, Any], bool]:
    return lambda _, content: content.payload[3] in (FTP_ACK, FTP_NAK) and content.payload[5] == opcode


CONNECT = [
    requested(
        "AUTOPILOT_VERSION",
        "AUTOPILOT_VERSION with MISSION_INT and MAVLINK2",
        {MAVSDK: "info and mission plugins time out", QGC: "takes the vehicle for one without capabilities"},
        fault=_version_fault,
    ),
    commanded(
        "autopilot-version-520",
        "AUTOPILOT_VERSION the old way (520), or its refusal",
        {MAVSDK: "asks again for seconds"},
        mav.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES,
        command_long(mav.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES, 1.0),
        then="AUTOPILOT_VERSION",
        may_refuse=always,
    ),
    commanded(
        "message-interval",
        "SET_MESSAGE_INTERVAL (511) for EXTENDED_SYS_STATE",
        {MAVSDK: "cannot set rates; telemetry.in_air() may never yield"},
        mav.MAV_CMD_SET_MESSAGE_INTERVAL,
        command_long(mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAVLINK_MSG_ID_EXTENDED_SYS_STATE, 1e6),
    ),
    Question(
        "extended-sys-state",
        "EXTENDED_SYS_STATE after that",
        {
            MAVSDK: "telemetry.in_air() and landed_state() never yield",
            QGC: "guesses from the throttle whether it flies",
        },
        answered("EXTENDED_SYS_STATE"),
        repeat_s=1.5,
    ),
    requested(
        "HOME_POSITION",
        "HOME_POSITION",
        {
            MAVSDK: "health_all_ok never turns true, and it asks every 2 s",
            QGC: "draws no home",
            MAVPROXY: "has no home, unless 410 brings it",
        },
    ),
    _ping(),
    _timesync(),
    *(
        requested(
            name, f"{name}, or its refusal", {QGC: "waits for it, three times, before it goes on"}, may_refuse=always
        )
        for name in ("PROTOCOL_VERSION", "COMPONENT_METADATA", "COMPONENT_INFORMATION")
    ),
    *MODES,
    STATUS,
    Question(
        "unknown-command",
        "an unknown command is refused",
        {
            MAVSDK: "waits through its retries, then says TIMEOUT",
            QGC: "says that the vehicle did not respond to a command",
        },
        refuses(UNKNOWN_COMMAND),
        command_long(UNKNOWN_COMMAND),
    ),
    commanded(
        "command-int",
        "commands as COMMAND_INT too",
        {QGC: "cannot go to a place on the map", MAVPROXY: "its guided command times out"},
        mav.MAV_CMD_REQUEST_MESSAGE,
        command_int(mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_AUTOPILOT_VERSION),
        then="AUTOPILOT_VERSION",
    ),
    Question(
        "other-target",
        "a command to another system id is left alone",
        {MAVSDK: "flies every vehicle on the port when it means one"},
        leaves_alone("whose target_system is another vehicle's"),
        command_long(mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_AUTOPILOT_VERSION, offset=1),
        lambda *_: OK,
        tries=1,
        elsewhere=True,
    ),
    commanded(
        "home-position-410",
        "HOME_POSITION the old way (410, component 0), or its refusal by one that sent it today's",
        {MAVPROXY: "asks again every few seconds and has no home"},
        mav.MAV_CMD_GET_HOME_POSITION,
        command_long(mav.MAV_CMD_GET_HOME_POSITION, to_component=0),
        then="HOME_POSITION",
        may_refuse=lambda vehicle: vehicle.of("HOME_POSITION") is not None,
    ),
    Question(
        "ftp",
        "FTP answered, if only by a NAK",
        {
            MAVPROXY: "tries ten times before it asks for parameters one by one",
            QGC: "waits before it asks for parameters",
        },
        answered("FILE_TRANSFER_PROTOCOL", ours=_ftp_answer(OPEN_FILE)),
        _ftp(1, OPEN_FILE, b"@PARAM/param.pck"),
    ),
    Question(
        "ftp-reset",
        "FTP sessions closed again",
        {MAVPROXY: "cannot open the next file"},
        answered("FILE_TRANSFER_PROTOCOL", ours=_ftp_answer(RESET_SESSIONS)),
        _ftp(3, RESET_SESSIONS),
        when=lambda v: "" if _opened(v) else "no file was opened",
    ),
]


def _opened(vehicle: CheckedVehicle) -> bool:
    content = vehicle.of("FILE_TRANSFER_PROTOCOL")
    return content is not None and content.payload[3] == FTP_ACK


def _mission(kind: int, name: str, capability: int, misses: dict[str, str]) -> Question:
    def ask(vehicle: CheckedVehicle) -> Sequence[Message]:
        to = {"target_system": vehicle.sysid, "target_component": vehicle.compid}
        over = [message("MISSION_ACK", type=mav.MAV_MISSION_ACCEPTED, mission_type=kind - 1, **to)] if kind else []
        return [*over, message("MISSION_REQUEST_LIST", mission_type=kind, **to)]

    def when(vehicle: CheckedVehicle) -> str:
        return "" if not capability or vehicle.capabilities & capability else "its capabilities say that it has none"

    judge = answered("MISSION_COUNT", ours=lambda _, content: content.mission_type == kind)
    return Question(f"{name}-download", f"{name} download begins (MISSION_COUNT)", misses, judge, ask, when=when)


MISSIONS = [
    _mission(
        0, "mission", 0, {MAVSDK: "mission.download_mission() times out", QGC: "says that the plan could not be loaded"}
    ),
    _mission(1, "fence", mav.MAV_PROTOCOL_CAPABILITY_MISSION_FENCE, {QGC: "says that the fence could not be loaded"}),
    _mission(
        2, "rally", mav.MAV_PROTOCOL_CAPABILITY_MISSION_RALLY, {QGC: "says that rally points could not be loaded"}
    ),
]
