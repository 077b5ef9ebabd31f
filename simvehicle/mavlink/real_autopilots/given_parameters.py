"""Parameters that a scenario gives an autopilot that is not ours, read back once it has booted. No socket, no clock.

One that it does not know, or keeps another value of, would change nothing and not say so. Some autopilots are silent
about a name that they do not know.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from typing import Any

from simvehicle.mavlink.codec import ReceivedFrame, decode, message
from skytender import mavlink as mav

ASK_EVERY_S = 0.5
TRIES = 6
_INTEGERS = dict(zip(range(1, 7), "BbHhIi", strict=True))
"""struct's format by MAV_PARAM_TYPE, of those that a PARAM_VALUE can carry by their bytes."""


class GivenParameters:
    """Conversation with one autopilot about what it was given; times are its own, s."""

    def __init__(self, sysid: int, given: Mapping[str, float], *, bytewise: bool) -> None:
        """`bytewise`: an integer's bytes stand in PARAM_VALUE, else its value."""
        self._sysid, self._given, self._bytewise = sysid, given, bytewise
        self._open = dict.fromkeys(given, 0)
        self._asked_s = -ASK_EVERY_S
        self.not_taken: dict[str, str] = {}
        """reason by name"""

    @property
    def done(self) -> bool:
        """Whether all are known to be taken, or not."""
        return not self._open

    def requests(self, now_s: float) -> list[Any]:
        """Messages that are to be said to it now."""
        if now_s - self._asked_s < ASK_EVERY_S:
            return []
        self._asked_s = now_s
        for name in [name for name, tries in self._open.items() if tries >= TRIES]:
            self._end(name, "it does not know it")
        self._open = {name: tries + 1 for name, tries in self._open.items()}
        read = message("PARAM_REQUEST_READ")
        return [
            read(param_index=-1, target_system=self._sysid, target_component=mav.MAV_COMP_ID_AUTOPILOT1, param_id=name)
            for name in self._open
        ]

    def receive(self, frame: ReceivedFrame) -> None:
        """Learn from one of its frames."""
        if frame.msgid not in (mav.MAVLINK_MSG_ID_PARAM_VALUE, mav.MAVLINK_MSG_ID_PARAM_ERROR):
            return
        content: Any = decode(frame)
        if content.param_id not in self._open:
            return
        if frame.msgid == mav.MAVLINK_MSG_ID_PARAM_ERROR:
            self._end(content.param_id, "it does not know it")
            return
        number, form = content.param_value, _INTEGERS.get(content.param_type)
        if form is not None and self._bytewise:
            (number,) = struct.unpack_from("<" + form, struct.pack("<f", number))
        wanted = self._given[content.param_id]
        taken = number == wanted or (form is None and struct.pack("<f", number) == struct.pack("<f", wanted))
        self._end(content.param_id, "" if taken else f"it keeps {number:g}")

    def _end(self, name: str, why: str) -> None:
        del self._open[name]
        if why:
            self.not_taken[name] = why
