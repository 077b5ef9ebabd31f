"""Plans that pass between ground stations and vehicles: messages of the mission protocol in, plans out.

A download counts when all its items have come, an upload when the vehicle acknowledges it. `incomplete` gives plans
that were received only in part.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from gcs.missions.items import GLOBAL, LOCAL, ItemError, MissionItem, MissionPlan, sorted_out
from skytender import mavlink as mav

ALL, MISSION = int(mav.MAV_MISSION_TYPE_ALL), int(mav.MAV_MISSION_TYPE_MISSION)
KINDS = (MISSION, int(mav.MAV_MISSION_TYPE_FENCE), int(mav.MAV_MISSION_TYPE_RALLY))
MESSAGES = (
    "MISSION_COUNT",
    "MISSION_ITEM",
    "MISSION_ITEM_INT",
    "MISSION_ACK",
    "MISSION_CLEAR_ALL",
    "MISSION_WRITE_PARTIAL_LIST",
)
_NOT_OF_A_PLAN = (2, 3)
"""Values of `current` by which ArduPilot takes an item as an order to go there at once, or to change height."""
_PER_DEGREE, _PER_METRE = 1e7, 1e4
"""Units of MISSION_ITEM_INT's x and y."""
UNKNOWN = 2**31 - 1
"""Its x and y where they are not given."""
NOT_GIVEN = frozenset({UNKNOWN, -UNKNOWN - 1})
"""Numbers that they read as then; the second as of a PX4, which makes it of the first."""


class Held(NamedTuple):
    """Items of one kind (MAV_MISSION_TYPE) that a vehicle has from a time on; `missing` of them are not known."""

    t_s: float
    sysid: int
    kind: int
    items: tuple[MissionItem, ...]
    missing: int = 0

    @property
    def total(self) -> int:
        """How many items it has."""
        return len(self.items) + self.missing


@dataclass
class _Transfer:
    count: int | None
    items: dict[int, MissionItem] = field(default_factory=dict)
    t_s: float = 0.0

    def held(self, t_s: float, sysid: int, kind: int) -> Held:
        count = max(self.items, default=-1) + 1 if self.count is None else self.count
        items = tuple(item for seq, item in sorted(self.items.items()) if seq < count)
        return Held(t_s, sysid, kind, items, count - len(items))


class Transfers:
    """Transfers of a whole fleet. `take` is given each plan when a vehicle has it, or is known to have it."""

    def __init__(self, take: Callable[[Held], object]) -> None:
        self._take = take
        self._uploads: dict[tuple[int, int], _Transfer] = {}
        self._downloads: dict[tuple[int, int], _Transfer] = {}
        self._held: dict[tuple[int, int], Held] = {}

    def receive(self, name: str, content: Any, sender: int, t_s: float, *, from_vehicle: bool) -> None:
        """Take one of MESSAGES with its fields."""
        kind = getattr(content, "mission_type", MISSION)
        sysid = sender if from_vehicle else content.target_system
        under_way = self._downloads if from_vehicle else self._uploads
        if name == "MISSION_ACK":
            if from_vehicle:
                self._acknowledged(sysid, kind, t_s, accepted=content.type == mav.MAV_MISSION_ACCEPTED)
        elif name == "MISSION_CLEAR_ALL":
            for one in KINDS if kind == ALL else (kind,):
                self._uploads[sysid, one] = _Transfer(0, t_s=t_s)
        elif name == "MISSION_WRITE_PARTIAL_LIST":
            held = self._held.get((sysid, kind))
            if held is not None and not from_vehicle and not held.missing:
                self._uploads[sysid, kind] = _Transfer(len(held.items), dict(enumerate(held.items)), t_s)
        elif name == "MISSION_COUNT":
            transfer = under_way[sysid, kind] = _Transfer(content.count, t_s=t_s)
            self._complete(transfer, sysid, kind, t_s, from_vehicle)
        elif content.current not in _NOT_OF_A_PLAN:
            transfer = under_way.setdefault((sysid, kind), _Transfer(None))
            transfer.items[content.seq] = item_of(name, content)
            transfer.t_s = t_s
            self._complete(transfer, sysid, kind, t_s, from_vehicle)

    def incomplete(self) -> list[Held]:
        """Parts of plans that were not received whole: of the first ones, and of one by which the vehicle has another
        number of items than before."""
        parts = []
        for under_way in (self._uploads, self._downloads):
            for (sysid, kind), transfer in under_way.items():
                held = self._held.get((sysid, kind))
                other = held is None or (under_way is self._downloads and transfer.count not in (None, held.total))
                if transfer.items and other:
                    parts.append(transfer.held(transfer.t_s, sysid, kind))
        return parts

    def _complete(self, transfer: _Transfer, sysid: int, kind: int, t_s: float, from_vehicle: bool) -> None:
        if from_vehicle and transfer.count is not None and len(transfer.items) >= transfer.count:
            self._keep(transfer.held(t_s, sysid, kind))
            del self._downloads[sysid, kind]

    def _acknowledged(self, sysid: int, kind: int, t_s: float, *, accepted: bool) -> None:
        for one in KINDS if kind == ALL else (kind,):
            transfer = self._uploads.pop((sysid, one), None)
            if accepted and transfer is not None:
                self._keep(transfer.held(t_s, sysid, one))

    def _keep(self, held: Held) -> None:
        before = self._held.get((held.sysid, held.kind))
        self._held[held.sysid, held.kind] = held
        if before is None or repr(before.items) != repr(held.items):  # NaN is no change
            self._take(held)


def units_per(command: int, frame: int) -> float:
    """Units of MISSION_ITEM_INT's x and y for one of parameters 5 and 6: degrees, metres, or numbers of a command that
    has no place."""
    known = mav.COMMANDS.get(command)
    if known is not None and not known.has_place:
        return 1.0
    return _PER_DEGREE if frame in GLOBAL else _PER_METRE if frame in LOCAL else 1.0


def item_of(name: str, content: Any) -> MissionItem:
    """The item in the fields of a MISSION_ITEM or a MISSION_ITEM_INT."""
    x, y = float(content.x), float(content.y)
    if name == "MISSION_ITEM_INT":
        unit = units_per(content.command, content.frame)
        x, y = (math.nan if value in NOT_GIVEN else value / unit for value in (x, y))
    params = (content.param1, content.param2, content.param3, content.param4, x, y, content.z)
    return MissionItem(content.command, content.frame, params, bool(content.autocontinue), content.current == 1)


def plan_of(held: Held, *, has_home: bool) -> MissionPlan:
    """A vehicle's items as a plan; `has_home`: item 0 of its missions is home, as of an ArduPilot."""
    what = "one item was" if held.missing == 1 else f"{held.missing} items were"
    left_out = (f"{what} not recorded",) if held.missing else ()
    try:
        plan = sorted_out(held.items, has_home=has_home and held.kind == MISSION)
    except ItemError as error:
        return MissionPlan(left_out=(*left_out, f"item {error.index}: {error}"))
    return plan._replace(left_out=left_out + plan.left_out)
