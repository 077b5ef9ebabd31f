"""A mission, a fence or rally points read from one vehicle, or put into it: no socket or clock here, time is an
argument (s).

    read    MISSION_REQUEST_LIST → MISSION_COUNT → MISSION_REQUEST_INT → MISSION_ITEM_INT … → MISSION_ACK
    write   MISSION_COUNT → MISSION_REQUEST(_INT) → MISSION_ITEM_INT … → MISSION_ACK
    clear   MISSION_CLEAR_ALL → MISSION_ACK

Rules:
1. At first the plan is read: one that is there already is not written. A plan without items is one to clear. Of one
   that differs in its number of items no item is read, unless it is to be kept.
2. What has been written is read back, and counts only when it reads as it was written, but for what the autopilot does
   not keep (habits.py). So an acknowledgement that is lost costs nothing: the reading decides.
3. What is not answered is asked again after REPEAT_S, TRIES times in a row; a plan that reads otherwise is written
   WRITES times.
4. MAV_MISSION_UNSUPPORTED ends it at once: the vehicle takes no such plan, or no such item.
5. Only what is addressed to this station counts. What the vehicle says to another one shows that this one is at work
   there, too; where it accepts another one's plan, what has been read so far is read again.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.ids import STATION
from gcs.mavlink.plans.habits import PlanHabits
from gcs.mavlink.plans.items import MISSION, PlanDifference, PlanItem, as_sent, differences
from skytender import mavlink as mav

REPEAT_S = 1.5
TRIES = 6
WRITES = 3
NAMES = frozenset(
    {"MISSION_COUNT", "MISSION_REQUEST", "MISSION_REQUEST_INT", "MISSION_ITEM_INT", "MISSION_ACK"}
)  # fmt: skip
MESSAGES = frozenset(map(codec.msgid, NAMES))

PlanOutcome = Literal["read", "kept", "uploaded", "unsupported", "refused", "differs", "silent"]
"""`kept`: it had the plan already; `differs`: it reads otherwise than it was written."""


class ItemDifference(NamedTuple):
    """A difference of an item, by its number."""

    number: int
    command: int
    difference: PlanDifference

    @property
    def text(self) -> str:
        """`item 3 NAV_WAYPOINT: Hold 5 is 0`."""
        return f"item {self.number} {mav.command_name(self.command)}: {self.difference.text}"


class PlanClient:
    """The dialogue with one vehicle about one kind of plan (MAV_MISSION_TYPE)."""

    def __init__(
        self,
        sysid: int,
        compid: int,
        kind: int,
        items: Sequence[PlanItem] | None,
        habits: PlanHabits = PlanHabits(),  # noqa: B008 - it cannot be changed
        *,
        station: tuple[int, int] = STATION,
        first: int = 0,
        keeps: bool = False,
    ) -> None:
        """`items`: what it is to have, as `wire_items` makes them; None to read only. `station`: our ids. `first`:
        number of the first item, behind home, for people. `keeps`: whether another plan is read whole before it is
        replaced."""
        self.sysid, self.compid, self.kind = sysid, compid, kind
        self.items = None if items is None else tuple(items)
        self.outcome: PlanOutcome | None = None
        """None while it is under way"""
        self.why = ""
        """words of the vehicle's refusal, or where it differs"""
        self.found: tuple[PlanItem, ...] | None = None
        """what it has, by its last whole reading"""
        self.replaced: tuple[PlanItem, ...] = ()
        """what it had before it was written, where that is kept"""
        self.lost: list[ItemDifference] = []
        """what of the plan its autopilot does not keep as it was given"""
        self._habits, self._station, self._keeps = habits, station, keeps
        self._home = int(kind == MISSION and habits.begin_with_home)
        self._first = first - self._home
        self._others: set[tuple[int, int]] = set()
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
        if name not in NAMES or self.outcome is not None or content.mission_type != self.kind:
            return
        to = content.target_system, content.target_component
        if to[0] not in (0, self._station[0]) or to[1] not in (0, self._station[1]):
            self._note_other_station(name, content, to)
        elif name == "MISSION_ACK" and content.type != mav.MAV_MISSION_ACCEPTED:
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

    def compare(self, items: Sequence[PlanItem]) -> list[ItemDifference]:
        """Differences of what was read from these items, one by one; home never differs."""
        pairs = list(enumerate(zip(items, self.found or (), strict=False)))[self._home :]
        return [
            ItemDifference(self._first + index, own.command, difference)
            for index, (own, other) in pairs
            for difference in differences(self.kind, own, other, self._habits)
        ]

    @property
    def count(self) -> int:
        """How many items it has, home aside."""
        return max(self._count - self._home, 0)

    def has_count(self, items: Sequence[PlanItem]) -> bool:
        """Whether it has as many items as these, home aside."""
        return self.count == self.expected(items)

    def expected(self, items: Sequence[PlanItem]) -> int:
        """How many items these are, home aside."""
        return max(len(items) - self._home, 0)

    def _repeat(self, now_s: float) -> None:
        if self._tries >= TRIES:
            self._end("refused" if self.why else "silent", self.why or f"no answer, though it was asked {TRIES} times")
            return
        self._tries += 1
        if self._writing and self._sent >= len(self.items or ()):
            self._begin_reading()
        if self._writing:
            self._ask_to_write(now_s)
        elif self._read is None:
            self._put(now_s, "MISSION_REQUEST_LIST")
        else:
            self._put(now_s, "MISSION_REQUEST_INT", seq=len(self._read))

    def _read_on(self, name: str, content: Any, now_s: float) -> None:
        if name == "MISSION_COUNT" and self._read is None:
            self._read, self._count, self._tries = [], content.count, 0
        elif name == "MISSION_ITEM_INT" and self._read is not None and content.seq == len(self._read) < self._count:
            self._read.append(PlanItem(**{field: getattr(content, field) for field in PlanItem._fields}))
            self._tries = 0
        else:
            return
        whole = self.items is None or (self._keeps and not self._writes) or (self.items and self.has_count(self.items))
        if len(self._read) < self._count and whole:
            self._put(now_s, "MISSION_REQUEST_INT", seq=len(self._read))
            return
        self._put(now_s, "MISSION_ACK", type=mav.MAV_MISSION_ACCEPTED)
        self.found = tuple(self._read)
        if self.items is None:
            self._end("read")
        else:
            self._judge(self.items, now_s)

    def _judge(self, items: Sequence[PlanItem], now_s: float) -> None:
        """End where it reads as it should, else write it."""
        found = self.compare(items)
        self.lost = [one for one in found if one.difference.lost]
        different = [one for one in found if not one.difference.lost]
        if self.has_count(items) and not different:
            self._end("uploaded" if self._writes else "kept")
        elif self._writes >= WRITES and self.why:
            self._end("refused", self.why)
        elif self._writes >= WRITES:
            self._end("differs", f"read back, {different[0].text if different else f'it has {self.count} items'}")
        else:
            if self._keeps and not self._writes and self.count:
                self.replaced = self.found or ()
            self._writing, self._writes, self._tries = True, self._writes + 1, 0
            self._ask_to_write(now_s)

    def _ask_to_write(self, now_s: float) -> None:
        self._sent = 0
        if self.items:
            self._put(now_s, "MISSION_COUNT", count=len(self.items))
        else:
            self._put(now_s, "MISSION_CLEAR_ALL")

    def _write(self, name: str, content: Any, now_s: float) -> None:
        items = self.items or ()
        if name in ("MISSION_REQUEST", "MISSION_REQUEST_INT") and content.seq < len(items):
            self._sent = max(self._sent, content.seq + 1)
            self._tries, self.why = 0, ""
            item = items[content.seq]
            sent = as_sent(self.kind, item, self._habits)
            self._put(now_s, "MISSION_ITEM_INT", seq=content.seq, **sent._asdict())
        elif name == "MISSION_ACK":
            self.why = ""
            self._begin_reading()
            self._put(now_s, "MISSION_REQUEST_LIST")

    def _begin_reading(self) -> None:
        self._writing, self._read, self._tries = False, None, 0

    def _refused(self, result: int, now_s: float) -> None:
        self.why = f"it answered {_RESULTS[result]}" if result in _RESULTS else "it refused"
        if self._writing and self._sent and self.items and result in _OF_ITEMS:
            at = self._sent - 1
            self.why += f" to item {self._first + at}, {mav.command_name(self.items[at].command)}"
            if 1 < len(self.items) == self._sent:  # some autopilots look at a plan when they have all of it
                self.why += ", or to the plan as a whole"
        elif result in _MEAN:
            self.why += f": {_MEAN[result]}"
        if result == mav.MAV_MISSION_INVALID_SEQUENCE and self._writing:
            return  # of an item that it had asked for twice: it says by itself which one it wants next
        if result == mav.MAV_MISSION_UNSUPPORTED:
            self._end("unsupported", self.why)
        elif result not in _PASSING or self._refusals >= TRIES:
            self._end("refused", self.why)
        else:  # busy, or its own upload given up: begin this part again in a while
            self._refusals += 1
            self._read, self._sent, self._due_s = None, 0, now_s + REPEAT_S

    def _note_other_station(self, name: str, content: Any, to: tuple[int, int]) -> None:
        self._others.add(to)
        if name == "MISSION_ACK" and content.type == mav.MAV_MISSION_ACCEPTED and not self._writing:
            self._read, self._due_s, self._refusals = None, 0.0, self._refusals + 1
            if self._refusals > TRIES:
                self._end("refused", "it gets other plans while it is read")

    def _end(self, outcome: PlanOutcome, why: str = "") -> None:
        self.outcome, self.why = outcome, why
        if self._others and outcome in ("refused", "differs", "silent"):
            stations = ", ".join(f"{sysid}/{compid}" for sysid, compid in sorted(self._others))
            self.why += f"; it spoke with another ground station, {stations}, about its plan meanwhile"

    def _put(self, now_s: float, name: str, **values: Any) -> None:
        self._due_s = now_s + REPEAT_S
        to = {"target_system": self.sysid, "target_component": self.compid, "mission_type": self.kind}
        self._out.append(codec.message(name, **to, **values))


class PlanClients:
    """The dialogues with one vehicle about several kinds of plan, one after the other: it has one at a time."""

    def __init__(self, clients: Sequence[PlanClient]) -> None:
        self.sysid, self.compid = clients[0].sysid, clients[0].compid
        self.clients = tuple(clients)

    @property
    def done(self) -> bool:
        """Whether all have ended."""
        return all(client.done for client in self.clients)

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        for client in self.clients:
            if not client.done:
                client.receive(name, content, now_s)
                return

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        return next((client.poll(now_s) for client in self.clients if not client.done), [])


_RESULTS = mav.ENUMS["MAV_MISSION_RESULT"]
_PASSING = frozenset(
    {
        mav.MAV_MISSION_ERROR,
        mav.MAV_MISSION_INVALID_SEQUENCE,
        mav.MAV_MISSION_DENIED,
        mav.MAV_MISSION_OPERATION_CANCELLED,
    }
)
_MEAN = {
    mav.MAV_MISSION_ERROR: "it is busy with another transfer, or flies this mission",
    mav.MAV_MISSION_INVALID_SEQUENCE: "items come out of turn, or the plan changes meanwhile",
    mav.MAV_MISSION_DENIED: "another ground station is writing to it",
    mav.MAV_MISSION_UNSUPPORTED: "it takes no such plan",
    mav.MAV_MISSION_NO_SPACE: "it has no room for so many items",
    mav.MAV_MISSION_OPERATION_CANCELLED: "it has given the transfer up",
}
_OF_ITEMS = frozenset(_RESULTS) - {
    mav.MAV_MISSION_NO_SPACE,
    mav.MAV_MISSION_INVALID_SEQUENCE,
    mav.MAV_MISSION_DENIED,
    mav.MAV_MISSION_OPERATION_CANCELLED,
}
"""Refusals of an item rather than of the whole."""
