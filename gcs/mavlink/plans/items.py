"""Items of a mission, a fence and rally points as the wire carries them: made of a plan, and where two differ."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from gcs.mavlink.plans.habits import PlanHabits
from gcs.missions import transfers
from gcs.missions.items import (
    GLOBAL,
    ItemError,
    MissionItem,
    MissionPlan,
    Params,
    fence_items,
    joined,
    mission_items,
    numbered,
    rally_items,
)
from gcs.missions.transfers import NOT_GIVEN, UNKNOWN, units_per
from skytender import mavlink as mav

MISSION = int(mav.MAV_MISSION_TYPE_MISSION)
FENCE = int(mav.MAV_MISSION_TYPE_FENCE)
RALLY = int(mav.MAV_MISSION_TYPE_RALLY)
KINDS = {"mission": MISSION, "fence": FENCE, "rally": RALLY}
"""MAV_MISSION_TYPE by the name of each part of a plan."""
SAME_UNITS = 1
"""An autopilot may keep degrees as floating point: one unit of degE7 (11 mm) is rounding."""
SAME_M = 0.05
"""Of heights and radii, of which some keep whole centimetres."""
SAME = 1e-6
"""Of other parameters: of the value, and of 1. They are floats of 32 bits."""
_MOST = 3.4e38
_COMPARED = {FENCE: (1, 5, 6), RALLY: (5, 6, 7)}
"""Parameters that mean something, where not all do."""


class PlanItem(NamedTuple):
    """One item as MISSION_ITEM_INT carries it: x and y in degE7, in 1e-4 m or in the parameter's own unit, as the frame
    and the command want it; z in m. UNKNOWN and NaN: not given."""

    command: int
    frame: int
    param1: float
    x: int
    y: int
    z: float
    param2: float = 0.0
    param3: float = 0.0
    param4: float = 0.0
    autocontinue: int = 1
    current: int = 0

    @property
    def params(self) -> Params:
        """Its seven parameters, 5 and 6 in the wire's units."""
        x, y = (math.nan if value in NOT_GIVEN else float(value) for value in (self.x, self.y))
        return self.param1, self.param2, self.param3, self.param4, x, y, self.z


def plan_of(parts: Mapping[int, Sequence[PlanItem]], habits: PlanHabits) -> MissionPlan:
    """One plan of a vehicle's items of each kind (MAV_MISSION_TYPE)."""
    return joined(
        transfers.plan_of(
            transfers.Held(0.0, 0, kind, tuple(transfers.item_of("MISSION_ITEM_INT", item) for item in items)),
            has_home=habits.begin_with_home,
        )
        for kind, items in parts.items()
    )


def as_sent(kind: int, item: PlanItem, habits: PlanHabits) -> PlanItem:
    """A mission's item without parameters that its autopilot has no use for and may refuse; a rally point with its
    height rounded up to what the autopilot keeps."""
    if kind == RALLY and habits.whole_rally_m:
        return item._replace(z=float(math.ceil(item.z)))
    if kind != MISSION:
        return item
    names = [f"param{number}" for number in habits.not_sent.get(item.command, "")]
    return PlanItem(**item._asdict() | {name: math.nan for name in names if getattr(item, name) != 0.0})


class PlanDifference(NamedTuple):
    """One thing in which an item reads otherwise than it should."""

    name: str
    """the dialect's name of the parameter, `frame`, `command` or `autocontinue`"""
    wanted: float | str
    found: float | str
    lost: bool = False
    """whether that is only what the autopilot has no use for, or a height that it keeps in whole metres"""

    @property
    def text(self) -> str:
        """`Hold 5 is 0`."""
        wanted, found = (one if isinstance(one, str) else f"{one:.9g}" for one in (self.wanted, self.found))
        return f"{self.name} {wanted} is {found}"


def wire_items(plan: MissionPlan, kind: int, habits: PlanHabits, not_given: float = math.nan) -> list[PlanItem]:
    """A plan's items of one kind (MAV_MISSION_TYPE) as a vehicle is given them; `not_given` is what its autopilot wants
    for a parameter that is not. Raises ItemError for a number that the wire cannot carry.

    A mission has home before it where the autopilot counts that, by which its jumps count then.
    """
    if kind == MISSION:
        items = mission_items(plan) if habits.begin_with_home else list(numbered(plan, 0).mission)
        items = items if plan.mission else []
    else:
        items = fence_items(plan) if kind == FENCE else rally_items(plan)
    wired = [_wired(index, item, not_given) for index, item in enumerate(items)]
    return [item._replace(current=int(kind == MISSION and index == 0)) for index, item in enumerate(wired)]


def _wired(index: int, item: MissionItem, not_given: float) -> PlanItem:
    known = mav.COMMANDS.get(item.command)
    placed = known is None or known.has_place
    unit = units_per(item.command, item.frame)
    first, second, third, fourth = (not_given if math.isnan(value) else value for value in item.params[:4])
    x, y, z = (not_given if math.isnan(value) and not placed else value for value in item.params[4:])
    whole_x, whole_y = (UNKNOWN if math.isnan(value) else round(unit * value) for value in (x, y))
    if max(abs(whole_x), abs(whole_y)) > UNKNOWN or any(abs(one) > _MOST for one in (first, second, third, fourth, z)):
        raise ItemError(index, f"{item.name} has a number that is too large for MAVLink")
    return PlanItem(item.command, item.frame, first, whole_x, whole_y, z, second, third, fourth, int(item.autocontinue))


def differences(kind: int, own: PlanItem, other: PlanItem, habits: PlanHabits = PlanHabits()) -> list[PlanDifference]:  # noqa: B008
    """Differences of an item that was read from `own`. A parameter that is not given in `own` makes none, nor do frames
    that say the same."""
    if own.command != other.command:
        return [PlanDifference("command", mav.command_name(own.command), mav.command_name(other.command))]
    return list(_differences(kind, own, other, habits))


def _differences(kind: int, own: PlanItem, other: PlanItem, habits: PlanHabits) -> Iterator[PlanDifference]:
    known = mav.COMMANDS.get(own.command)
    placed = known is None or known.has_place
    labels = known.labels if known else {}
    if placed and kind != FENCE and GLOBAL.get(own.frame, own.frame) != GLOBAL.get(other.frame, other.frame):
        yield PlanDifference("frame", _frame(own.frame), _frame(other.frame))
    unit = units_per(own.command, own.frame)
    for number in _COMPARED.get(kind, range(1, 8)):
        wanted, found = own.params[number - 1], other.params[number - 1]
        name = labels.get(number, f"parameter {number}")
        if math.isnan(wanted) or _same(number, wanted, found, kind, name, placed=placed):
            continue
        if habits.loses(own.command, number) and (math.isnan(found) or found in (-1.0, 0.0, 1.0)):
            if wanted != 0.0:
                yield PlanDifference(name, wanted, found, lost=True)
            continue
        if number == 7 and kind == RALLY and habits.whole_rally_m and found == math.ceil(wanted):
            yield PlanDifference(name, wanted, found, lost=True)
            continue
        scale = unit if number in (5, 6) else 1.0
        yield PlanDifference(name, wanted / scale, found / scale)
    if kind == MISSION and own.autocontinue != other.autocontinue:
        yield PlanDifference("autocontinue", own.autocontinue, other.autocontinue, lost=not habits.keeps_autocontinue)


def _same(number: int, wanted: float, found: float, kind: int, name: str, *, placed: bool) -> bool:
    apart = wanted - found
    if number in (5, 6):
        return abs(apart) <= SAME_UNITS
    if name.startswith("Yaw"):
        apart = math.remainder(apart, 360.0) if math.isfinite(apart) else apart
    metres = kind != MISSION or (number == 7 and placed)
    return abs(apart) <= (SAME_M if metres else SAME * max(1.0, abs(wanted)) * (360.0 if name[:3] == "Yaw" else 1.0))


def _frame(frame: int) -> str:
    return mav.ENUMS["MAV_FRAME"].get(frame, str(frame)).removeprefix("MAV_FRAME_")
