"""Other ground stations' messages on their way to vehicles: which pass, and which take a vehicle from the supervisor.

1. Nothing passes unless the session lets others command (`forward: {control: true}`).
2. A message passes to the vehicle of the session that it names. One that claims to come from a vehicle does not pass,
   nor do messages over which two masters would fight without either knowing: rates of streams, transfers of energy,
   keys.
3. A message that only asks for something passes, and the supervisor goes on flying the vehicle. What asks is named
   here; every other message takes the vehicle, also an unknown one: from then on the supervisor sends it
   nothing but its HEARTBEAT, until an operator's `rejoin`. So two masters never fly one vehicle.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.ids import STATION
from gcs.refuelling.relay import Relay
from gcs.supervisor.arming import ArmingSequence
from gcs.supervisor.operator import Operator, OperatorReply
from gcs.telemetry.events import Event
from gcs.telemetry.state import FleetSnapshot
from skytender import mavlink as mav

if TYPE_CHECKING:  # most sessions have none
    from gcs.link.forwarder import FromStation

_COMMANDS = frozenset({mav.MAVLINK_MSG_ID_COMMAND_LONG, mav.MAVLINK_MSG_ID_COMMAND_INT})
_STOPPED = frozenset({mav.MAVLINK_MSG_ID_REQUEST_DATA_STREAM, mav.MAVLINK_MSG_ID_SETUP_SIGNING})
_STOPPED_COMMANDS = frozenset({mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAV_CMD_USER_1})
_ASKS = frozenset({
    mav.MAVLINK_MSG_ID_PING, mav.MAVLINK_MSG_ID_PARAM_REQUEST_READ, mav.MAVLINK_MSG_ID_PARAM_REQUEST_LIST,
    mav.MAVLINK_MSG_ID_PARAM_EXT_REQUEST_READ, mav.MAVLINK_MSG_ID_PARAM_EXT_REQUEST_LIST,
    mav.MAVLINK_MSG_ID_MISSION_REQUEST_LIST, mav.MAVLINK_MSG_ID_MISSION_REQUEST_PARTIAL_LIST,
    mav.MAVLINK_MSG_ID_MISSION_REQUEST, mav.MAVLINK_MSG_ID_MISSION_REQUEST_INT, mav.MAVLINK_MSG_ID_MISSION_ACK,
    mav.MAVLINK_MSG_ID_LOG_REQUEST_LIST, mav.MAVLINK_MSG_ID_LOG_REQUEST_DATA, mav.MAVLINK_MSG_ID_LOG_REQUEST_END,
})  # fmt: skip
"""Messages that ask for something and change nothing."""
_ASKING_COMMANDS = frozenset({
    mav.MAV_CMD_REQUEST_MESSAGE, mav.MAV_CMD_GET_MESSAGE_INTERVAL, mav.MAV_CMD_GET_HOME_POSITION,
    mav.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES, mav.MAV_CMD_REQUEST_PROTOCOL_VERSION,
    mav.MAV_CMD_REQUEST_CAMERA_INFORMATION, mav.MAV_CMD_REQUEST_CAMERA_SETTINGS,
    mav.MAV_CMD_REQUEST_CAMERA_CAPTURE_STATUS, mav.MAV_CMD_REQUEST_STORAGE_INFORMATION,
    mav.MAV_CMD_REQUEST_VIDEO_STREAM_INFORMATION, mav.MAV_CMD_REQUEST_VIDEO_STREAM_STATUS,
    mav.MAV_CMD_REQUEST_FLIGHT_INFORMATION, mav.MAV_CMD_RUN_PREARM_CHECKS,
})  # fmt: skip
"""Commands that do the same."""
_FTP_OPCODE = 3
"""Place of the opcode in a MAVFTP payload."""
_FTP_ASKS = frozenset({
    mav.MAV_FTP_OPCODE_NONE, mav.MAV_FTP_OPCODE_TERMINATESESSION, mav.MAV_FTP_OPCODE_RESETSESSION,
    mav.MAV_FTP_OPCODE_LISTDIRECTORY, mav.MAV_FTP_OPCODE_OPENFILERO, mav.MAV_FTP_OPCODE_READFILE,
    mav.MAV_FTP_OPCODE_CALCFILECRC, mav.MAV_FTP_OPCODE_BURSTREADFILE,
})  # fmt: skip
"""Requests of MAVFTP that write nothing."""


MOST_AT_ONCE = 32
"""Messages to one vehicle that pass in a tick."""
SAY_AGAIN_S = 10.0
MOST_SAID = 1000
"""Most different messages that are reported within SAY_AGAIN_S."""


class Passed(NamedTuple):
    """A message on its way to a vehicle."""

    sysid: int
    message: Message | Relay
    name: str
    """of the message, or of the command in it"""
    takes: bool
    """whether the supervisor leaves the vehicle to its sender"""


def passed(
    frame: Frame, vehicles: Collection[int], stations: Mapping[int, tuple[int, int]] | None = None
) -> Passed | None:
    """Result for another station's frame; None where it does not pass. `stations`: our own ids for vehicles that know
    us by others than STATION."""
    if frame.sysid in vehicles or frame.msgid in _STOPPED:
        return None
    try:
        content = codec.fields(frame)
    except ValueError:
        return None
    sysid = getattr(content, "target_system", getattr(content, "target", 0))
    if sysid not in vehicles:
        return None
    name, asks = codec.name(frame.msgid), frame.msgid in _ASKS
    if frame.msgid in _COMMANDS:
        if content.command in _STOPPED_COMMANDS:
            return None
        name = mav.command_name(content.command)
        asks = content.command in _ASKING_COMMANDS
    elif frame.msgid == mav.MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL:
        asks = content.payload[_FTP_OPCODE] in _FTP_ASKS
    # One with our own id goes out as ours: a vehicle counts our sequence numbers.
    own = (frame.sysid, frame.compid) == (stations or {}).get(sysid, STATION)
    message = Message(frame.msgid, tuple(content)) if own else Relay(frame.raw)
    return Passed(sysid, message, name, takes=not asks)


class ForwardedControl:
    """Messages that other ground stations have sent to a session's vehicles and that are not passed on yet."""

    def __init__(
        self,
        arming: Mapping[int, ArmingSequence],
        operator: Operator,
        stations: Mapping[int, tuple[int, int]] | None = None,
    ) -> None:
        """`stations` as in `passed`."""
        self._stations = stations
        self._arming = arming
        self._operator = operator
        self._waiting: dict[int, list[Message | Relay]] = {}
        self._said_s: dict[tuple[int, str, str], float] = {}

    def receive(self, received: Sequence[FromStation], snapshot: FleetSnapshot) -> list[Event]:
        """Take what has come; what to tell of it, which is recorded as decisions as well."""
        events: list[Event] = []
        now_s = snapshot.time_s
        for frame, by in received:
            one = passed(frame, self._arming, self._stations)
            if one is None:
                continue
            waiting = self._waiting.setdefault(one.sysid, [])
            if len(waiting) >= MOST_AT_ONCE or not snapshot.vehicle(one.sysid).alive:
                continue
            if one.takes and not self._arming[one.sysid].released:
                reply, event = self._operator.obey({"command": "release", "sysid": one.sysid}, snapshot)
                events.append(event)
                if not reply.taken:
                    continue
            waiting.append(one.message)
            if self._is_new(one, by, now_s):
                text = f"{one.name} to {snapshot.vehicle(one.sysid).label} by {by}"
                events.append(self._operator.note(now_s, "forward", OperatorReply(True, text), one.sysid))
        return events

    @property
    def waiting(self) -> Collection[int]:
        """System ids of the vehicles for which something waits."""
        return self._waiting.keys()

    def pop(self, sysid: int) -> list[Message | Relay]:
        """Remove and return what goes to the vehicle with its next grant."""
        return self._waiting.pop(sysid, [])

    def _is_new(self, one: Passed, by: str, now_s: float) -> bool:
        said = (one.sysid, one.name, by)
        if now_s - self._said_s.get(said, -SAY_AGAIN_S) < SAY_AGAIN_S:
            self._said_s[said] = now_s
            return False
        if len(self._said_s) >= MOST_SAID:
            self._said_s = {key: s for key, s in self._said_s.items() if now_s - s < SAY_AGAIN_S}
            if len(self._said_s) >= MOST_SAID:
                return False
        self._said_s[said] = now_s
        return True
