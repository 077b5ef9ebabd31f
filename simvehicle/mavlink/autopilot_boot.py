"""Boot of an ArduPilot before its session begins: put into GUIDED, and asked for its checks, until it would let itself
be armed. No socket, no clock.

Levelling, aligning and finding its place take tens of seconds of its own time, in which it stands. GUIDED needs a
place, and with it the checks before arming ask for all that a flight of ours needs.
"""

from __future__ import annotations

from typing import Any

from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink.codec import ReceivedFrame, decode, message

ASK_EVERY_S = 0.5
GUIDED = 4
LAST_REASONS = 3
_CHECKS = "PreArm: "


class AutopilotBoot:
    """Conversation with one autopilot while it boots; times are its own."""

    def __init__(self, sysid: int) -> None:
        self._sysid = sysid
        self._asked_s = -ASK_EVERY_S
        self._guided = self._healthy = False
        self._reasons: dict[str, None] = {}
        self.kind: tuple[int, int] | None = None
        """MAV_TYPE and MAV_AUTOPILOT, once it has said them"""
        self.volts = 0.0
        """voltage of its battery as it measures it"""

    @property
    def ready(self) -> bool:
        """Whether it is in GUIDED, and its checks before arming pass."""
        return self._guided and self._healthy

    @property
    def is_arducopter(self) -> bool:
        """Whether it is, as far as it has said, what `autopilot: {ardupilot: …}` wants."""
        return self.kind in (None, (mav.MAV_TYPE_QUADROTOR, mav.MAV_AUTOPILOT_ARDUPILOTMEGA))

    @property
    def reasons(self) -> str:
        """Its last reasons not to be armed; empty where it has given none."""
        return " | ".join(list(self._reasons)[-LAST_REASONS:])

    def requests(self, now_s: float) -> list[Any]:
        """Messages that are to be said to it now."""
        if now_s - self._asked_s < ASK_EVERY_S:
            return []
        self._asked_s = now_s
        asked = [self._command(mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_SYS_STATUS)]
        if not self._guided:
            custom = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
            asked.append(self._command(mav.MAV_CMD_DO_SET_MODE, custom, GUIDED))
        return asked

    def receive(self, frame: ReceivedFrame) -> None:
        """Learn from one of its frames."""
        content: Any = decode(frame)
        if frame.msgid == mav.MAVLINK_MSG_ID_HEARTBEAT:
            self.kind = (content.type, content.autopilot)
            self._guided = content.custom_mode == GUIDED
        elif frame.msgid == mav.MAVLINK_MSG_ID_SYS_STATUS:
            self._healthy = bool(content.onboard_control_sensors_health & mav.MAV_SYS_STATUS_PREARM_CHECK)
            self.volts = 1e-3 * content.voltage_battery
        elif frame.msgid == mav.MAVLINK_MSG_ID_STATUSTEXT and content.text.startswith(_CHECKS):
            reason = content.text.removeprefix(_CHECKS)
            self._reasons.pop(reason, None)
            self._reasons[reason] = None

    def _command(self, command: int, *params: float) -> Any:
        numbers = (*map(float, params), *(0.0,) * (7 - len(params)))
        return message("COMMAND_LONG")(*numbers, command, self._sysid, mav.MAV_COMP_ID_AUTOPILOT1, 0)
