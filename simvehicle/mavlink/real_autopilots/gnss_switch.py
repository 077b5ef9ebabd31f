"""GNSS receiver of an ArduPilot, whose JSON interface has no word for a fix that is lost: its own switch for tests,
the auxiliary function GPS_DISABLE, turns it off. No socket, no clock.
"""

from __future__ import annotations

from typing import Any

from simvehicle.mavlink.codec import ReceivedFrame, decode
from simvehicle.mavlink.commands import command_long
from skytender import mavlink as mav

DO_AUX_FUNCTION = 218
"""MAV_CMD_DO_AUX_FUNCTION, of ArduPilot's dialect: the function, and its switch's position."""
GPS_DISABLE = 65
"""ArduPilot's number of that function (RCx_OPTION)."""
SWITCH_LOW, SWITCH_HIGH = 0, 2


class GnssSwitch:
    """The switch of one autopilot, on at first."""

    def __init__(self, sysid: int) -> None:
        self._sysid = sysid
        self._off = False
        self._unanswered = 0

    def settings(self, *, lost: bool) -> list[Any]:
        """The command that is to be said now, so that its receiver has no fix while it is lost."""
        if lost == self._off:
            return []
        self._off = lost
        self._unanswered += 1
        return [command_long(self._sysid, DO_AUX_FUNCTION, GPS_DISABLE, SWITCH_HIGH if lost else SWITCH_LOW)]

    def answers(self, frame: ReceivedFrame) -> bool:
        """Whether a frame is the autopilot's answer to the switch."""
        if not self._unanswered or frame.msgid != mav.MAVLINK_MSG_ID_COMMAND_ACK:
            return False
        content: Any = decode(frame)
        if content.command != DO_AUX_FUNCTION:
            return False
        self._unanswered -= 1
        return True
