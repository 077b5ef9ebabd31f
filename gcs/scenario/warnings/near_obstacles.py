"""Warnings of places and ways up that lie in obstacles, or nearer to them than vehicles keep."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from gcs.scenario import goal
from gcs.scenario.accuracy import spreads_m
from gcs.scenario.model import Obstacle, Scenario
from gcs.scenario.types import Vec3
from gcs.scenario.warnings.room import why_kept
from gcs.scenario.warnings.slips import sent_to
from gcs.scenario.warnings.warning import ScenarioWarning

STEP_M = 0.1
"""Between places of a way up at which obstacles are looked for."""
ROUNDING_M = 1e-6
WAY_UP = "the way up"


class _Place(NamedTuple):
    """A place by how near it is to an obstacle."""

    clear_m: float
    name: str
    at_ned: Vec3


def warnings(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Places that are too near for any vehicle first, then those too near for one that does not know its place."""
    if not scenario.obstacles:
        return
    kept_m, key = _kept(scenario)
    spread_m = max(spreads_m(scenario).values(), default=0.0) if scenario.planner.safety else 0.0
    wide_m = max(kept_m, scenario.planner.clearance_m + spread_m) if spread_m else kept_m
    near = [place for place in _places(scenario, wide_m) if place.clear_m < wide_m - ROUNDING_M]
    within = [place for place in near if place.clear_m < kept_m - ROUNDING_M]
    if within:
        nearest = min(within)
        what = obstacle_name(scenario, _nearest(scenario, nearest.at_ned))
        inside = "leads through" if nearest.name.startswith(WAY_UP) else "is inside"
        where = inside if nearest.clear_m < 0.0 else f"is {nearest.clear_m:.2f} m from"
        yield ScenarioWarning(
            "clearance",
            f"{nearest.name} {where} the obstacle {what}{_more(len(within))}, and {kept_m:g} m are kept ({key}): "
            "move it or the obstacle",
        )
    if beyond := [place for place in near if place not in within]:
        nearest = min(beyond)
        yield ScenarioWarning(
            "accuracy",
            f"{nearest.name} is {nearest.clear_m:.2f} m from an obstacle{_more(len(beyond))}: "
            f"{why_kept(scenario, wide_m)}",
        )


def obstacle_name(scenario: Scenario, obstacle: Obstacle) -> str:
    """An obstacle's name; for one without a name its kind and number in the scenario."""
    return obstacle.name or f"{obstacle.kind} {scenario.obstacles.index(obstacle) + 1}"


def _kept(scenario: Scenario) -> tuple[float, str]:
    """Distance to obstacles that vehicles keep or the goal wants, m, and the key that says so."""
    wanted_m = goal.clearance_m(scenario) or 0.0
    if scenario.planner.safety and scenario.planner.clearance_m >= wanted_m:
        return scenario.planner.clearance_m, "planner.clearance_m"
    return wanted_m, "goal.clearance_m"


def _more(count: int) -> str:
    return f", the nearest of {count} such places" if count > 1 else ""


def _nearest(scenario: Scenario, place: Vec3) -> Obstacle:
    return min(scenario.obstacles, key=lambda obstacle: obstacle.clearance_m(place))


def _places(scenario: Scenario, wide_m: float) -> list[_Place]:
    """Starts, ways up and places that vehicles are sent to; a way up that leads nearer than `wide_m` to an obstacle by
    its place that is nearest."""
    found = []
    for vehicle in scenario.vehicles.launched:
        rise_m = 0.0 if vehicle.airborne else vehicle.takeoff_m
        clear_m, up_m = min(
            _nearest_of_way_up(vehicle.start_m, rise_m, obstacle, wide_m) for obstacle in scenario.obstacles
        )
        n, e, d = vehicle.start_m
        found.append(_Place(clear_m, f"{WAY_UP if up_m else 'the start'} of {vehicle.label}", (n, e, d - up_m)))
    for name, place in sent_to(scenario):
        found.append(_Place(min(obstacle.clearance_m(place) for obstacle in scenario.obstacles), name, place))
    return found


def _nearest_of_way_up(start_m: Vec3, rise_m: float, obstacle: Obstacle, wide_m: float) -> tuple[float, float]:
    """Distance from an obstacle, and height above the start, of the nearest place of a way straight up, as far as that
    is nearer than `wide_m`."""
    n, e, d = start_m
    clear_m = obstacle.clearance_m(start_m)
    nearest, up_m = (clear_m, 0.0), 0.0
    while up_m < rise_m:
        up_m = min(up_m + max(clear_m - wide_m, STEP_M), rise_m)  # before that it is farther
        clear_m = obstacle.clearance_m((n, e, d - up_m))
        nearest = min(nearest, (clear_m, up_m))
    return nearest
