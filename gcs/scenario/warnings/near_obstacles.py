"""Warnings of places and ways up that lie in obstacles, or nearer to them than vehicles keep."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from gcs.scenario import goal
from gcs.scenario.accuracy import spreads_m
from gcs.scenario.model import Obstacle, Scenario, VehicleBase
from gcs.scenario.types import Vec3
from gcs.scenario.warnings.room import why_kept
from gcs.scenario.warnings.slips import sent_to
from gcs.scenario.warnings.warning import ScenarioWarning
from skytender import geometry

STEP_M, MOST_STEPS = 0.1, 1000
"""Between places of a way up at which it is looked for obstacles; how many there are at most."""
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
    near = [place for place in _places(scenario) if place.clear_m < wide_m - ROUNDING_M]
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


def _places(scenario: Scenario) -> list[_Place]:
    """Starts, ways up and places that vehicles are sent to; a way up by its place that is nearest to an obstacle."""
    shapes, found = geometry.of_scenario(scenario.obstacles), []
    for vehicle in scenario.vehicles.launched:
        places = _way_up(vehicle)
        clear_m = geometry.clearance(shapes, places)
        k = int(np.argmin(clear_m))
        name = f"{WAY_UP} of {vehicle.label}" if k else f"the start of {vehicle.label}"
        found.append(_Place(float(clear_m[k]), name, places[k]))
    if sent := sent_to(scenario):
        clear_m = geometry.clearance(shapes, [place for _, place in sent])
        found += [_Place(metres, name, at) for metres, (name, at) in zip(clear_m.tolist(), sent, strict=True)]
    return found


def _way_up(vehicle: VehicleBase) -> list[Vec3]:
    """Places from a launched vehicle's start to where it has taken off; its start alone where it begins in the air."""
    n, e, d = vehicle.start_m
    count = 0 if vehicle.airborne else min(math.ceil(vehicle.takeoff_m / STEP_M), MOST_STEPS)
    return [(n, e, d), *((n, e, d - vehicle.takeoff_m * k / count) for k in range(1, count + 1))]
