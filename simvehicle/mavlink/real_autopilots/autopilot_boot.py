"""Boot of an autopilot that is not ours before its session begins: put into the mode from which it will be armed, and
asked for its checks and its home, until it would let itself be armed. No socket, no clock.

Levelling, aligning and finding its place take seconds or tens of seconds of its own time, in which it stands. The mode
needs a place, and with it the checks before arming ask for all that a flight of ours needs. Its home it may know later:
a session would wait for it with the heights of its return. It is ready at a HEARTBEAT, for which a session waits as
well: so the next one comes as long after the session's begin each time.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from simvehicle.mavlink.codec import ReceivedFrame, decode
from simvehicle.mavlink.commands import command_long
from skytender import mavlink as mav

ASK_EVERY_S = 0.5
LAST_REASONS = 3


class BootMode(NamedTuple):
    """How one kind of autopilot says that it waits for us."""

    vehicle: str
    """what it must be, for a sentence"""
    autopilot: int
    """MAV_AUTOPILOT of its HEARTBEAT"""
    custom_mode: int
    """of its HEARTBEAT, once it waits in its mode"""
    set_mode: tuple[int, ...]
    """params 2 and on of the MAV_CMD_DO_SET_MODE that asks for it"""
    reasons: tuple[str, ...]
    """how a STATUSTEXT begins that says why it cannot be armed"""


ARDUCOPTER_BOOT = BootMode("ArduCopter", mav.MAV_AUTOPILOT_ARDUPILOTMEGA, 4, (4,), ("PreArm: ",))
"""It waits in GUIDED."""
PX4_BOOT = BootMode("PX4", mav.MAV_AUTOPILOT_PX4, 4 << 16 | 3 << 24, (4, 3), ("Preflight Fail: ", "Preflight: "))
"""It waits in Hold. What it says without "Fail" forbids to arm in some modes only, and may be all that it says."""


class AutopilotBoot:
    """Conversation with one autopilot while it boots; times are its own."""

    def __init__(self, sysid: int, mode: BootMode) -> None:
        self._sysid = sysid
        self._mode = mode
        self._asked_s = -ASK_EVERY_S
        self._in_mode = self._healthy = self._at_home = False
        self.ready = False
        """whether it was in its mode at its last HEARTBEAT, its checks before arming pass, and it knows its home"""
        self._reasons: dict[str, None] = {}
        self._said_sysid: int | None = None
        """system id of an autopilot that has another than was wanted"""
        self.kind: tuple[int, int] | None = None
        """MAV_TYPE and MAV_AUTOPILOT, once it has said them"""
        self.volts = 0.0
        """voltage of its battery as it measures it"""

    @property
    def mismatch(self) -> str:
        """Sentence's end that says why it is not the autopilot that is wanted; empty where it is, as far as it has
        said."""
        if self._said_sysid is not None:
            return f"did not take its parameters: it says that its system id is {self._said_sysid}, not {self._sysid}"
        wanted = (mav.MAV_TYPE_QUADROTOR, self._mode.autopilot)
        if self.kind in (None, wanted):
            return ""
        said = "its HEARTBEAT has type {} and autopilot {}, not {} and {}".format(*(self.kind or ()), *wanted)
        return f"is no {self._mode.vehicle} with four rotors: {said}"

    @property
    def reasons(self) -> str:
        """Its last reasons not to be armed; empty where it has given none."""
        return " | ".join(list(self._reasons)[-LAST_REASONS:])

    def requests(self, now_s: float) -> list[Any]:
        """Messages that are to be said to it now."""
        if now_s - self._asked_s < ASK_EVERY_S:
            return []
        self._asked_s = now_s
        asked = [command_long(self._sysid, mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_SYS_STATUS)]
        if not self._at_home:
            home = mav.MAVLINK_MSG_ID_HOME_POSITION
            asked.append(command_long(self._sysid, mav.MAV_CMD_REQUEST_MESSAGE, home))
        if not self._in_mode:
            custom = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
            asked.append(command_long(self._sysid, mav.MAV_CMD_DO_SET_MODE, custom, *self._mode.set_mode))
        return asked

    def receive(self, frame: ReceivedFrame) -> None:
        """Learn from one of its frames; those of its other components say nothing of it."""
        if frame.compid != mav.MAV_COMP_ID_AUTOPILOT1:
            return
        if frame.sysid != self._sysid:
            self._said_sysid = frame.sysid
            return
        content: Any = decode(frame)
        if frame.msgid == mav.MAVLINK_MSG_ID_HEARTBEAT:
            self.kind = (content.type, content.autopilot)
            self._in_mode = content.custom_mode == self._mode.custom_mode
            self.ready = self._in_mode and self._healthy and self._at_home
        elif frame.msgid == mav.MAVLINK_MSG_ID_SYS_STATUS:
            self._healthy = bool(content.onboard_control_sensors_health & mav.MAV_SYS_STATUS_PREARM_CHECK)
            self.ready = self.ready and self._healthy
            self.volts = 1e-3 * content.voltage_battery
        elif frame.msgid == mav.MAVLINK_MSG_ID_HOME_POSITION:
            self._at_home = True
        elif frame.msgid == mav.MAVLINK_MSG_ID_STATUSTEXT:
            for prefix in self._mode.reasons:
                if content.text.startswith(prefix):
                    reason = content.text.removeprefix(prefix)
                    self._reasons.pop(reason, None)
                    self._reasons[reason] = None
