"""Warnings of gaps between obstacles through which a straight way leads, without room for errors of places.

A vehicle passes between two obstacles only where the segment between their nearest places is at least twice as long as
the distance that it keeps: each place of a shorter one is too near to one of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, pairwise
from typing import NamedTuple

from gcs.scenario.accuracy import spreads_m
from gcs.scenario.model import Obstacle, Scenario, Target, VehicleBase
from gcs.scenario.types import Vec3
from gcs.scenario.warnings.near_obstacles import obstacle_name
from gcs.scenario.warnings.room import why_kept
from gcs.scenario.warnings.warning import ScenarioWarning
from skytender import elementary

STEP_M, MOST_LOOKS = 0.05, 20_000
"""Between places of ways at which they are looked for obstacles; how many of these there are at most, in all."""
OPPOSITE_COS, ACROSS_COS = -0.5, 0.7
"""A way leads between two obstacles that lie on opposite sides of it, and across the segment between them."""
TURN_M = 1e-4


class _Leg(NamedTuple):
    """A straight way of a vehicle, and what it keeps from obstacles."""

    what: str
    a: Vec3
    b: Vec3
    kept_m: float


class _Gap(NamedTuple):
    """A gap without room; the one that lacks most comes first."""

    lacks_m: float
    wide_m: float
    kept_m: float
    what: str
    between: tuple[str, str]


def warnings(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """The gap that lacks most room, and how many others do."""
    spreads = spreads_m(scenario)
    if not any(spreads.values()) or not scenario.planner.safety or len(scenario.obstacles) < 2:
        return
    import numpy as np  # noqa: PLC0415 - gcs run, which reads every scenario, starts without it

    from skytender import geometry  # noqa: PLC0415

    legs = [leg for vehicle in scenario.vehicles.all for leg in _legs(vehicle, scenario, spreads[vehicle.sysid])]
    length_m = sum(elementary.distance(leg.a, leg.b) for leg in legs)
    shapes = geometry.of_scenario(scenario.obstacles)
    low, high = geometry.bounds(shapes)
    found: dict[tuple[str, tuple[str, str]], _Gap] = {}
    for leg in legs:
        count = max(1, round(elementary.distance(leg.a, leg.b) / max(STEP_M, length_m / MOST_LOOKS)))
        places = np.linspace(leg.a, leg.b, count + 1)
        clear_m = geometry.clearance(shapes, places)
        for place in places[(clear_m >= 0.0) & (clear_m < leg.kept_m)]:
            beside = np.all((low < place + 2.0 * leg.kept_m) & (high > place - 2.0 * leg.kept_m), axis=1)
            obstacles = [scenario.obstacles[k] for k in np.flatnonzero(beside).tolist()]
            for gap in _gaps_at(tuple(place.tolist()), leg, obstacles, scenario):
                found[gap.what, gap.between] = min(gap, found.get((gap.what, gap.between), gap))
    if found:
        worst = min(found.values())
        more = f", the narrowest of {len(found)} such gaps" if len(found) > 1 else ""
        yield ScenarioWarning(
            "accuracy",
            f"{worst.what} leads straight between the obstacles {worst.between[0]} and {worst.between[1]}, which leave "
            f"{worst.wide_m:.2f} m{more}: {why_kept(scenario, worst.kept_m)} on each side, so that the vehicle has to "
            "fly around; widen the gap, or give a way point beside it",
        )


def _legs(vehicle: VehicleBase, scenario: Scenario, spread_m: float) -> Iterator[_Leg]:
    """Straight ways of a vehicle from above its start on; an external one's start is not known."""
    corners: tuple[Vec3, ...] = getattr(vehicle, "waypoints_m", ()) or getattr(vehicle, "path_m", ())
    numbers, name = list(range(1, len(corners) + 1)), "corner" if isinstance(vehicle, Target) else "way point"
    if not corners or not spread_m:
        return
    if isinstance(vehicle, Target) and vehicle.closed:
        corners, numbers = (*corners, corners[0]), [*numbers, 1]
    if vehicle.external is None:
        n, e, d = vehicle.start_m
        corners, numbers = ((n, e, d if vehicle.airborne else d - vehicle.takeoff_m), *corners), [0, *numbers]
    for (a, b), number in zip(pairwise(corners), numbers[1:], strict=True):
        yield _Leg(f"the way of {vehicle.label} to {name} {number}", a, b, scenario.planner.clearance_m + spread_m)


def _gaps_at(place: Vec3, leg: _Leg, obstacles: list[Obstacle], scenario: Scenario) -> Iterator[_Gap]:
    """Gaps without room that a leg crosses at a place."""
    along = _unit(tuple(b - a for a, b in zip(leg.a, leg.b, strict=True)))
    sides = [(one, one.clearance_m(place), _away(place, one)) for one in obstacles]
    for (one, near_m, here), (other, far_m, there) in combinations(sides, 2):
        if near_m < 0.0 or far_m < 0.0 or _dot(here, there) > OPPOSITE_COS:
            continue
        across = tuple(near_m * x - far_m * y for x, y in zip(here, there, strict=True))
        wide_m = elementary.norm(across)
        if wide_m < 2.0 * leg.kept_m and abs(_dot(along, _unit(across))) < ACROSS_COS:
            between = obstacle_name(scenario, one), obstacle_name(scenario, other)
            yield _Gap(wide_m - 2.0 * leg.kept_m, wide_m, leg.kept_m, leg.what, between)


def _away(place: Vec3, obstacle: Obstacle) -> tuple[float, ...]:
    """Unit vector from an obstacle's nearest place to this one."""
    slopes = []
    for k in range(3):
        ahead, behind = list(place), list(place)
        ahead[k] += TURN_M
        behind[k] -= TURN_M
        slopes.append(obstacle.clearance_m(_vec(ahead)) - obstacle.clearance_m(_vec(behind)))
    return _unit(tuple(slopes))


def _vec(values: list[float]) -> Vec3:
    return (values[0], values[1], values[2])


def _unit(vector: tuple[float, ...]) -> tuple[float, ...]:
    size = elementary.norm(vector)
    return tuple(x / size for x in vector) if size else vector


def _dot(a: tuple[float, ...], b: tuple[float, ...]) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))
