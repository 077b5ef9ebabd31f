"""Warnings of heights at which vehicles that have lost the ground station return into something: plan B.

Heights are above the scenario's height 0. Where a scenario does not give a vehicle's RTL_RETURN_ALT, its height lies
above all places and obstacles, and apart from others, unless the greatest height that it can be set to ends that.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from gcs.planner.failsafes import MOST_ALTITUDE_M, failsafes_of, shared_heights
from gcs.planner.return_ways import boxes_of, places_of
from gcs.scenario.model import Pursuer, Scenario, Tanker, VehicleBase
from gcs.scenario.warnings.warning import ScenarioWarning
from skytender import geometry

RETURN_ALTITUDE = "RTL_RETURN_ALT"
NAMED = 3
"""Of many vehicles so many are named."""
ROUNDING_M = 1e-6


class _Return(NamedTuple):
    """A vehicle's return by its height, and whether the scenario gives that."""

    vehicle: VehicleBase
    given: bool
    above_home_m: float
    height_m: float


class _TooLow(NamedTuple):
    """A return that is too low, below what."""

    limit_m: float
    what: str
    one: _Return


def warnings(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Shared heights first, then heights that are too low."""
    failsafes = failsafes_of(scenario)
    returns = []
    for vehicle in scenario.vehicles.launched:
        if (failsafe := failsafes.get(vehicle.sysid)) is not None:
            height_m = failsafe.altitude_m - vehicle.start_m[2]
            returns.append(_Return(vehicle, RETURN_ALTITUDE in vehicle.params, failsafe.altitude_m, height_m))
    yield from _of_shared(returns, scenario)
    # A height that is not given is too low only where it is cut.
    fixed = [one for one in returns if one.given or one.above_home_m >= MOST_ALTITUDE_M]
    yield from _of_places(fixed, scenario)
    yield from _of_obstacles(fixed, scenario)


def given_heights(scenario: Scenario) -> list[str]:
    """Sentences of `warnings` for a session that begins; none, and at once, where the scenario gives no height."""
    given = any(RETURN_ALTITUDE in vehicle.params for vehicle in scenario.vehicles.launched)
    return [f"Plan B: {warning.text}" for warning in warnings(scenario)] if given else []


def _of_shared(returns: Sequence[_Return], scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Heights at which vehicles return whose ways home may meet: given ones, and those where heights end."""
    by_sysid = {one.vehicle.sysid: one for one in returns}
    given: list[list[_Return]] = []
    ended: list[list[_Return]] = []
    for sysids in shared_heights(scenario):
        group = [by_sysid[sysid] for sysid in sysids]
        (given if any(one.given for one in group) else ended).append(group)
    for groups, why in (
        (given, f"leave {RETURN_ALTITUDE} out of their params, and each gets a height of its own"),
        (
            ended,
            f"heights end at {MOST_ALTITUDE_M:g} m, the greatest {RETURN_ALTITUDE}: fly fewer vehicles, or move their "
            "places apart so that their ways home do not cross",
        ),
    ):
        if groups:
            most = max(groups, key=len)
            height_m = round(most[0].height_m, 2)
            more = f", one of {len(groups)} such heights" if len(groups) > 1 else ""
            yield _warning(
                f"{_named([one.vehicle for one in most])} return at one height, {height_m:g} m{more}, their "
                f"ways home may meet, and they keep apart there by their radio alone: {why}"
            )


def _of_places(fixed: Sequence[_Return], scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Heights below a place that the vehicle is sent to: it returns at that place's height, whatever else does."""
    low = [_TooLow(_highest_m(one.vehicle, scenario), "highest place", one) for one in fixed]
    low = [one for one in low if one.one.height_m < one.limit_m - ROUNDING_M]
    yield from _of_low(low, "below the highest place that {it_is} sent to", "move the places")


def _of_obstacles(fixed: Sequence[_Return], scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Heights at which an obstacle stands where the way home may lead."""
    if not scenario.obstacles or not fixed:
        return
    every = scenario.vehicles.all
    boxes = {vehicle.sysid: box for vehicle, box in zip(every, boxes_of(every, scenario), strict=True)}
    low_ned, high_ned = geometry.bounds(geometry.of_scenario(scenario.obstacles))
    kept_m = scenario.planner.clearance_m if scenario.planner.safety else 0.0
    low = []
    for one in fixed:
        box, highest_m = boxes[one.vehicle.sysid], max(one.height_m, _highest_m(one.vehicle, scenario))
        beside = np.all((low_ned[:, :2] <= box[2:]) & (high_ned[:, :2] >= box[:2]), axis=1)
        as_high = (-low_ned[:, 2] > one.height_m - kept_m) & (-high_ned[:, 2] < highest_m + kept_m)
        if (found := np.flatnonzero(beside & as_high)).size:
            k = int(found[np.argmin(low_ned[found, 2])])
            obstacle = scenario.obstacles[k]
            low.append(_TooLow(-float(low_ned[k, 2]), obstacle.name or f"{obstacle.kind} {k + 1}", one))
    yield from _of_low(low, "below the top of an obstacle where {way} home may lead", "move the obstacle or the places")


def _of_low(low: Sequence[_TooLow], below: str, move: str) -> Iterator[ScenarioWarning]:
    """One sentence on heights that can be raised, and one on heights at their limit."""
    can = [one for one in low if one.one.above_home_m < MOST_ALTITUDE_M]
    cannot = [one for one in low if one not in can]
    for group, advice in (
        (can, f"leave {RETURN_ALTITUDE} out of params, or raise it"),
        (cannot, f"{RETURN_ALTITUDE} is {MOST_ALTITUDE_M:g} m at most, so {move}"),
    ):
        if not group:
            continue
        worst, several = max(group, key=lambda one: one.limit_m - one.one.height_m), len(group) > 1
        height_m, limit_m = round(worst.one.height_m, 2), round(worst.limit_m, 2)
        where = below.format(it_is="they are" if several else "it is", way="their ways" if several else "its way")
        yield _warning(
            f"{_named([one.one.vehicle for one in group])} return{'' if several else 's'} {where} "
            f"({worst.one.vehicle.label} at {height_m:g} m, {worst.what} at {limit_m:g} m): {advice}"
        )


def _highest_m(vehicle: VehicleBase, scenario: Scenario) -> float:
    """Height of the highest place to which the scenario sends a vehicle: a pursuer to its target, a tanker to the
    pursuers."""
    highest_m = max(-place[2] for place in places_of(vehicle, scenario))
    if isinstance(vehicle, Pursuer):
        target = scenario.vehicles.target_of(vehicle)
        above_m = scenario.formation.height_m
        followed = [_highest_m(one, scenario) + above_m for one in scenario.vehicles.targets if one.sysid == target]
        highest_m = max([highest_m, *followed])
    if isinstance(vehicle, Tanker) and scenario.refuelling.enabled:
        above_m = scenario.refuelling.height_m
        highest_m = max([highest_m, *(_highest_m(one, scenario) + above_m for one in scenario.vehicles.pursuers)])
    return highest_m


def _named(vehicles: Sequence[VehicleBase]) -> str:
    """`pursuer 1, pursuer 2, pursuer 3 and 47 more`"""
    names, others = [vehicle.label for vehicle in vehicles[:NAMED]], len(vehicles) - NAMED
    if others > 0:
        return f"{', '.join(names)} and {others} more"
    return " and ".join(part for part in (", ".join(names[:-1]), names[-1]) if part)


def _warning(text: str) -> ScenarioWarning:
    return ScenarioWarning("plan B", text)
