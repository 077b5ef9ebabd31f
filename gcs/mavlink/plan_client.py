"""A fence or rally points put into one vehicle: no socket or clock here, time is an argument (s).

    read    MISSION_REQUEST_LIST → MISSION_COUNT → MISSION_REQUEST_INT → MISSION_ITEM_INT … → MISSION_ACK
    write   MISSION_COUNT → MISSION_REQUEST(_INT) → MISSION_ITEM_INT … → MISSION_ACK

Rules:
1. At first the plan is read: one that is there already is not written.
2. What has been written is read back, and counts only when it reads as it was written. So an acknowledgement that is
   lost costs nothing: the reading decides.
3. What is not answered is asked again after REPEAT_S, TRIES times in a row; a plan that reads otherwise is written
   WRITES times.
4. MAV_MISSION_UNSUPPORTED ends it at once: the vehicle takes no such plan.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from skytender import mavlink as mav

REPEAT_S = 1.5
TRIES = 6
WRITES = 3
SAME_DEG_E7 = 1
"""An autopilot may keep degrees as floating point: one unit (11 mm) is rounding."""
SAME_M = 0.05
MESSAGES = frozenset(
    {
        mav.MAVLINK_MSG_ID_MISSION_COUNT,
        mav.MAVLINK_MSG_ID_MISSION_REQUEST,
        mav.MAVLINK_MSG_ID_MISSION_REQUEST_INT,
        mav.MAVLINK_MSG_ID_MISSION_ITEM_INT,
        mav.MAVLINK_MSG_ID_MISSION_ACK,
    }
)

PlanOutcome = Literal["kept", "uploaded", "unsupported", "refused", "differs", "silent"]
"""`kept`: it had the plan already; `differs`: it reads otherwise than it was written."""


class PlanItem(NamedTuple):
    """One item of a fence or of rally points, as the wire carries it: x and y in degE7, z in m."""

    command: int
    frame: int
    param1: float
    x: int
    y: int
    z: float

    def same(self, other: PlanItem) -> bool:
        """Whether another stands for the same; frames may be named otherwise."""
        near = abs(self.x - other.x) <= SAME_DEG_E7 and abs(self.y - other.y) <= SAME_DEG_E7
        sizes = abs(self.param1 - other.param1) <= SAME_M and abs(self.z - other.z) <= SAME_M
        return self.command == other.command and near and sizes


class PlanClient:
    """The dialogue with one vehicle about one kind of plan (MAV_MISSION_TYPE)."""

    def __init__(self, sysid: int, compid: int, kind: int, items: Sequence[PlanItem]) -> None:
        self.sysid, self.compid, self.kind = sysid, compid, kind
        self.items = tuple(items)
        self.outcome: PlanOutcome | None = None
        """None while it is under way"""
        self.why = ""
        """words of the vehicle's refusal, or where it differs"""
        self._writing = False
        self._writes = 0
        self._read: list[PlanItem] | None = None
        self._count = 0
        self._sent = 0
        """items that were asked for so far, in writing"""
        self._tries = self._refusals = 0
        self._due_s = 0.0
        self._out: list[Message] = []

    @property
    def done(self) -> bool:
        """Whether it has ended, and nothing waits to be sent."""
        return self.outcome is not None and not self._out

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        if self.outcome is not None or content.mission_type != self.kind:
            return
        if name == "MISSION_ACK" and content.type != mav.MAV_MISSION_ACCEPTED:
            self._refused(content.type, now_s)
        elif self._writing:
            self._write(name, content, now_s)
        else:
            self._read_on(name, content, now_s)

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        if self.outcome is None and now_s >= self._due_s and not self._out:
            self._repeat(now_s)
        taken, self._out = self._out, []
        return taken

    def _repeat(self, now_s: float) -> None:
        if self._tries >= TRIES:
            self._end("refused" if self.why else "silent", self.why or f"no answer, though it was asked {TRIES} times")
            return
        self._tries += 1
        if self._writing and self._sent >= len(self.items):
            self._begin_reading()
        if self._writing:
            self._sent = 0
            self._put(now_s, "MISSION_COUNT", count=len(self.items))
        elif self._read is None:
            self._put(now_s, "MISSION_REQUEST_LIST")
        else:
            self._put(now_s, "MISSION_REQUEST_INT", seq=len(self._read))

    def _read_on(self, name: str, content: Any, now_s: float) -> None:
        if name == "MISSION_COUNT" and self._read is None:
            self._read, self._count, self._tries = [], content.count, 0
        elif name == "MISSION_ITEM_INT" and self._read is not None and content.seq == len(self._read):
            item = PlanItem(content.command, content.frame, content.param1, content.x, content.y, content.z)
            self._read.append(item)
            self._tries = 0
        else:
            return
        if self._count == len(self.items) and len(self._read) < self._count:
            self._put(now_s, "MISSION_REQUEST_INT", seq=len(self._read))
            return
        self._put(now_s, "MISSION_ACK", type=mav.MAV_MISSION_ACCEPTED)
        self._compare(self._read, now_s)

    def _compare(self, read: list[PlanItem], now_s: float) -> None:
        differs = [i for i, (own, other) in enumerate(zip(self.items, read, strict=False)) if not own.same(other)]
        if self._count == len(self.items) and not differs:
            self._end("uploaded" if self._writes else "kept")
        elif self._writes >= WRITES:
            where = f"item {differs[0]} is another" if differs else f"it has {self._count} items"
            self._end("differs", f"read back, {where}")
        else:
            self._writing, self._writes, self._sent, self._tries = True, self._writes + 1, 0, 0
            self._put(now_s, "MISSION_COUNT", count=len(self.items))

    def _write(self, name: str, content: Any, now_s: float) -> None:
        if name in ("MISSION_REQUEST", "MISSION_REQUEST_INT") and content.seq < len(self.items):
            self._sent = max(self._sent, content.seq + 1)
            self._tries = 0
            item = self.items[content.seq]
            rest = {"current": 0, "autocontinue": 1, "param2": 0.0, "param3": 0.0, "param4": 0.0}
            self._put(now_s, "MISSION_ITEM_INT", seq=content.seq, **rest, **item._asdict())
        elif name == "MISSION_ACK":
            self._begin_reading()
            self._put(now_s, "MISSION_REQUEST_LIST")

    def _begin_reading(self) -> None:
        self._writing, self._read, self._tries = False, None, 0

    def _refused(self, result: int, now_s: float) -> None:
        self.why = f"it answered {_RESULTS[result]}" if result in _RESULTS else "it refused"
        if result == mav.MAV_MISSION_UNSUPPORTED:
            self._end("unsupported", self.why)
        elif result not in _PASSING or self._refusals >= TRIES:
            self._end("refused", self.why)
        else:  # busy, or its own upload given up: begin this part again in a while
            self._refusals += 1
            self._read, self._sent, self._due_s = None, 0, now_s + REPEAT_S

    def _end(self, outcome: PlanOutcome, why: str = "") -> None:
        self.outcome, self.why = outcome, why

    def _put(self, now_s: float, name: str, **values: Any) -> None:
        self._due_s = now_s + REPEAT_S
        to = {"target_system": self.sysid, "target_component": self.compid, "mission_type": self.kind}
        self._out.append(codec.message(name, **to, **values))


_RESULTS = mav.ENUMS["MAV_MISSION_RESULT"]
_PASSING = frozenset({mav.MAV_MISSION_ERROR, mav.MAV_MISSION_INVALID_SEQUENCE, mav.MAV_MISSION_OPERATION_CANCELLED})
