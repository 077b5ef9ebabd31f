"""A vehicle's `mission`: the items of a file of QGroundControl, Mission Planner or MAVProxy, which its autopilot flies.

They become the vehicle's items as the scenario is read, so that nothing else needs to know of the file. The session
keeps a vehicle apart by where its items lead it: items whose way is not known are refused.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from pydantic import Field

from gcs.scenario.document import Conflict, Document, KeyPath, Problem, ScenarioError
from gcs.scenario.parts.plan_file import read_plan
from gcs.scenario.parts.reach import Shown
from gcs.scenario.types import Exact, Flag, Number, Part, Vec3
from skytender import elementary, geodesy

if TYPE_CHECKING:
    from gcs.missions.items import MissionPlan

FARTHEST_FIRST_M = 900.0
"""From a vehicle's start to its first item: what PX4 allows by default (MIS_DIST_1WP of its older versions)."""
ALONG_M = 0.5
"""Between places of a leg at which it is looked for obstacles."""
LEAST_HEIGHT_M = 0.3


class _Numbers(NamedTuple):
    """MAVLink's numbers of what is flown, by what is known of it."""

    above_sea: frozenset[int]
    above_home: frozenset[int]
    """frames, by what heights are counted from"""
    with_place: frozenset[int]
    watched: frozenset[int]
    """commands whose way is known"""
    homeward: frozenset[int]


@functools.cache
def _numbers() -> _Numbers:
    from skytender import mavlink as mav  # noqa: PLC0415 - so that a scenario is read without MAVLink

    with_place = frozenset({mav.MAV_CMD_NAV_WAYPOINT, mav.MAV_CMD_NAV_LOITER_TIME, mav.MAV_CMD_NAV_LOITER_UNLIM})
    return _Numbers(
        above_sea=frozenset({mav.MAV_FRAME_GLOBAL, mav.MAV_FRAME_GLOBAL_INT}),
        above_home=frozenset({mav.MAV_FRAME_GLOBAL_RELATIVE_ALT, mav.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT}),
        with_place=with_place,
        watched=with_place | {mav.MAV_CMD_NAV_TAKEOFF, mav.MAV_CMD_NAV_DELAY, mav.MAV_CMD_DO_CHANGE_SPEED},
        homeward=frozenset({mav.MAV_CMD_NAV_RETURN_TO_LAUNCH, mav.MAV_CMD_NAV_LAND}),
    )


class FlownItem(Part):
    """One item of a mission."""

    command: Annotated[int, Exact(ge=0, le=65535)]
    """MAV_CMD"""
    frame: Annotated[int, Exact(ge=0, le=255)] = 3
    """MAV_FRAME; by default GLOBAL_RELATIVE_ALT"""
    params: Annotated[tuple[Number | None, ...], Field(min_length=7, max_length=7)]
    """its seven parameters, 5 and 6 in degrees; empty where none is given"""
    autocontinue: Flag = True
    """whether the autopilot goes on by itself to the next one"""

    @property
    def name(self) -> str:
        """`NAV_WAYPOINT`"""
        from skytender import mavlink as mav  # noqa: PLC0415 - so that a scenario is read without MAVLink

        return mav.command_name(self.command)

    def place_ned(self, origin: tuple[float, float, float], home_down_m: float) -> Vec3 | None:
        """Place in the common frame; None where it has none. A take-off goes straight up: its north and east are NaN.

        origin: of the common frame, deg, deg, m. home_down_m: of the vehicle's home, in the common frame.
        """
        from skytender import mavlink as mav  # noqa: PLC0415 - so that a scenario is read without MAVLink

        numbers = _numbers()
        if self.command not in numbers.with_place and self.command != mav.MAV_CMD_NAV_TAKEOFF:
            return None
        lat_deg, lon_deg, height_m = (0.0 if value is None else value for value in self.params[4:])
        down_m = origin[2] - height_m if self.frame in numbers.above_sea else home_down_m - height_m
        if self.command == mav.MAV_CMD_NAV_TAKEOFF:
            return (math.nan, math.nan, down_m)
        north_m, east_m, _ = geodesy.ned_of(lat_deg, lon_deg, origin[2], origin)
        return (north_m, east_m, down_m)

    def fault(self, *, first: bool, last: bool) -> str:
        """Reason that keeps it from being flown here, as a sentence without its subject; empty where there is none."""
        from skytender import mavlink as mav  # noqa: PLC0415 - so that a scenario is read without MAVLink

        numbers = _numbers()
        if self.command in numbers.homeward:
            return f"is {self.name}: the session takes its vehicles home by itself; leave it out"
        if self.command not in numbers.watched:
            known = ", ".join(sorted(mav.command_name(command) for command in numbers.watched))
            return f"is {self.name}, whose way is not known; known are {known}"
        if self.command == mav.MAV_CMD_NAV_TAKEOFF and not first:
            return "is a take-off, which only the first item can be"
        if self.command == mav.MAV_CMD_NAV_LOITER_UNLIM and not last:
            return "is NAV_LOITER_UNLIM, after which no item is reached"
        placed = self.command in numbers.with_place | {mav.MAV_CMD_NAV_TAKEOFF}
        if placed and self.frame not in numbers.above_sea | numbers.above_home:
            frame = mav.ENUMS["MAV_FRAME"].get(self.frame, f"frame {self.frame}").removeprefix("MAV_FRAME_")
            return f"has its place in {frame}: give its height above home or the sea"
        if self.command in numbers.with_place and (None in self.params[4:] or self.params[4] == self.params[5] == 0.0):
            return "has no place"
        return ""


Mission = (
    Annotated[str, Shown(), Field(min_length=1, max_length=4096)]
    | Annotated[tuple[FlownItem, ...], Field(min_length=1)]
    | None
)


def fill(document: Document, vehicles: Iterable[tuple[KeyPath, dict[str, Any]]]) -> None:
    """Replace each file that a `mission` names by its items. Raises ScenarioError."""
    problems: list[Problem] = []
    read: dict[str, list[dict[str, Any]]] = {}
    for path, vehicle in vehicles:
        value = vehicle.get("mission")
        if not isinstance(value, str):
            continue
        try:
            if value not in read:
                plan = read_plan(document, value, (*path, "mission"))
                read[value] = [
                    {
                        "command": int(item.command),
                        "frame": int(item.frame),
                        "params": [None if math.isnan(number) else float(number) for number in item.params],
                        "autocontinue": item.autocontinue,
                    }
                    for item in plan.mission
                ]
                if not read[value]:
                    at = document.problem((*path, "mission"), f"{value} holds no mission item")
                    raise ScenarioError([at])
        except ScenarioError as error:
            problems += error.problems
        else:
            vehicle["mission"] = read[value]
    if problems:
        raise ScenarioError(problems)


def items_of(vehicle: Any) -> tuple[FlownItem, ...]:
    """A vehicle's items; none where it flies no mission."""
    mission = getattr(vehicle, "mission", None)
    return mission if isinstance(mission, tuple) else ()


def plan_of(vehicle: Any) -> MissionPlan:
    """A vehicle's mission as a plan; an empty one where it has none."""
    from gcs.missions.items import MissionItem, MissionPlan  # noqa: PLC0415 - so that a scenario is read without MAVLink

    def item(one: FlownItem) -> MissionItem:
        p1, p2, p3, p4, x, y, z = (math.nan if value is None else value for value in one.params)
        return MissionItem(one.command, one.frame, (p1, p2, p3, p4, x, y, z), autocontinue=one.autocontinue)

    return MissionPlan(tuple(map(item, items_of(vehicle))))


def way_of(vehicle: Any, scenario: Any) -> list[Vec3]:
    """Places to which a vehicle's items lead it from above its start, home at the scenario's height 0."""
    origin = scenario.origin
    n, e, d = vehicle.start_m[0], vehicle.start_m[1], vehicle.start_m[2] - vehicle.takeoff_m
    way: list[Vec3] = []
    for item in items_of(vehicle):
        place = item.place_ned((origin.lat_deg, origin.lon_deg, origin.alt_m), 0.0)
        if place is not None:
            n, e, d = (n, e, min(d, place[2])) if math.isnan(place[0]) else place
            way.append((n, e, d))
    return way


def conflicts(path: KeyPath, vehicle: Any, scenario: Any) -> Iterator[Conflict]:
    """First reason that keeps a vehicle from flying its mission."""
    sentence = next(_faults(vehicle, scenario), None)
    if sentence is not None:
        yield Conflict((*path, "mission"), sentence)


def _faults(vehicle: Any, scenario: Any) -> Iterator[str]:
    label, items, rules = vehicle.label, items_of(vehicle), scenario.planner
    if isinstance(vehicle.mission, str):
        yield "mission is read with a scenario's file, beside which it lies: load the scenario by gcs.load"
    if vehicle.mission is None or isinstance(vehicle.mission, str):
        return
    if vehicle.waypoints_m or vehicle.target is not None:
        yield f"{label} has a mission and {'waypoints_m' if vehicle.waypoints_m else 'a target'}; leave one out"
    if not (rules.safety and rules.vehicles_repel):
        yield "a vehicle on a mission is kept apart by the safety filter: set 'planner: {safety: true}'"
    if scenario.competition.where == "vehicles":
        yield "a vehicle on a mission does not compete on board: leave it out, or where: supervisor"
    if vehicle.transfer:
        yield f"{label} is not refuelled while it flies its mission: leave out transfer, or the mission"
    for number, item in enumerate(items, 1):
        fault = item.fault(first=number == 1, last=number == len(items))
        if fault:
            yield f"item {number} of the mission {fault}"
            return
    if not way_of(vehicle, scenario):
        yield "the mission leads nowhere: none of its items has a place"
    yield from _wrong_places(vehicle, scenario)


def _wrong_places(vehicle: Any, scenario: Any) -> Iterator[str]:
    """Places that are too low, too far or beyond the fence, and legs that pass an obstacle."""
    way, launched = way_of(vehicle, scenario), vehicle.external is None
    numbers = [number for number, item in enumerate(items_of(vehicle), 1) if item.command in _numbers().with_place]
    numbers = [1] * (len(way) - len(numbers)) + numbers
    if launched and elementary.distance(vehicle.start_m, way[0]) > FARTHEST_FIRST_M:
        away_m = elementary.distance(vehicle.start_m, way[0])
        yield f"item {numbers[0]} of the mission lies {away_m:.0f} m from its start, more than {FARTHEST_FIRST_M:.0f} m"
    before = vehicle.start_m if vehicle.airborne else (*vehicle.start_m[:2], vehicle.start_m[2] - vehicle.takeoff_m)
    for number, place in zip(numbers, way, strict=True):
        if -place[2] < LEAST_HEIGHT_M:
            yield f"item {number} of the mission lies {-place[2]:.1f} m above the ground, below {LEAST_HEIGHT_M} m"
        if not scenario.fence.allows(*place[:2]):
            yield f"item {number} of the mission lies beyond the fence"
        for obstacle in scenario.obstacles if launched or place != way[0] else ():
            near_m = min(map(_clearance_of(obstacle), _along(before, place)))
            if not obstacle.fault() and near_m < scenario.planner.clearance_m:
                what = obstacle.name or obstacle.kind
                wanted = f"{scenario.planner.clearance_m:g} m (planner.clearance_m)"
                yield f"the way to item {number} of the mission passes {near_m:.1f} m from {what}, nearer than {wanted}"
        before = place


def _clearance_of(obstacle: Any) -> Callable[[Vec3], float]:
    return lambda place: float(obstacle.clearance_m(place))


def _along(a: Sequence[float], b: Sequence[float]) -> list[Vec3]:
    count = max(math.ceil(elementary.distance(a, b) / ALONG_M), 1)
    shares = [k / count for k in range(count + 1)]
    return [(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])) for t in shares]
