"""Events of vehicles (https://mavlink.io/en/services/events.html), as the texts that their STATUSTEXTs are.

A vehicle's metadata is read once it has been received for ASK_AFTER_S and while it is not armed: its files may fill a
slow link for some seconds. What it has said until then, as in a flight, is put into words only then.
"""

from __future__ import annotations

from collections.abc import Iterable

from gcs.mavlink import codec
from gcs.mavlink.autopilots import Params
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.metadata.reported_events import NAMES, ReportedEvents
from skytender import mavlink as mav

ASK_AFTER_S = 5.0
"""By then a station has asked for what it needs itself."""
SAY_EVERY_S = 10.0
OLD_S = 10.0
"""[choice] What came longer ago is said with its age: a reader takes what is said for what is so now."""
IDS = frozenset(map(codec.msgid, NAMES))
"""Messages that are read."""
EVENT = codec.msgid("EVENT")
ASKED: tuple[int, Params] = (
    int(mav.MAV_CMD_REQUEST_MESSAGE),
    (float(mav.MAVLINK_MSG_ID_COMPONENT_METADATA),),
)
"""The command that asks a vehicle for its metadata."""


def aged(text: str, came_s: float, now_s: float) -> str:
    """Text of an event as it is said now."""
    old_s = now_s - came_s
    return f"{text} ({old_s:.0f} s ago)" if old_s > OLD_S else text


class VehicleEvents:
    """Events of the autopilots of many vehicles."""

    def __init__(self) -> None:
        self._reported: dict[int, ReportedEvents] = {}
        self._received_s: dict[int, float] = {}
        self._asked: set[int] = set()
        """which were asked for COMPONENT_METADATA"""
        self._lost: dict[int, int] = {}
        self._said_s: dict[int, float] = {}

    def receive(self, sysid: int, compid: int, frames: Iterable[Frame], now_s: float) -> list[tuple[int, str, float]]:
        """Take an autopilot's frames; (MAV_SEVERITY, text, when it came) of each event."""
        texts = []
        for frame in frames:
            self._received_s.setdefault(sysid, now_s)
            if frame.msgid in IDS:
                if sysid not in self._reported:
                    self._reported[sysid] = ReportedEvents(sysid, compid)
                texts += self._reported[sysid].receive(codec.name(frame.msgid), codec.fields(frame), now_s)
        return texts

    def due(self, sysid: int, now_s: float, *, armed: bool) -> bool:
        """Whether a vehicle is to be sent ASKED now, once."""
        waited_s = now_s - self._received_s.get(sysid, now_s)
        if sysid in self._asked or armed or waited_s < ASK_AFTER_S:
            return False
        self._asked.add(sysid)
        return True

    def poll(self, sysid: int, now_s: float) -> list[Message]:
        """Messages that read a vehicle's metadata, and ask for events that it has sent in vain."""
        reported = self._reported.get(sysid)
        return [] if reported is None else reported.poll(now_s)

    def losses(self, sysid: int, now_s: float) -> str:
        """Sentence on how many of a vehicle's events were lost since the last one; empty where there is none."""
        reported = self._reported.get(sysid)
        lost = 0 if reported is None else reported.lost - self._lost.get(sysid, 0)
        if not lost or now_s < self._said_s.get(sysid, -SAY_EVERY_S) + SAY_EVERY_S:
            return ""
        self._lost[sysid] = self._lost.get(sysid, 0) + lost
        self._said_s[sysid] = now_s
        return f"{lost} of its events did not arrive, nor when asked for"
