"""Failsafes of launched vehicles, by which they come home when the ground station is lost: plan B [choice].

If the station falls silent for all at once, they return without it, by one timetable: up, each to a height of its
own where its way home may meet another's; level, when all are up; down over their own homes, when all are there.
What can meet is coloured: two vehicles whose boxes around their places and homes overlap have different heights. All
heights are above the places to which the scenario sends any of them: one that could not climb in time, because another
hangs over it, stays below all ways until the others have landed.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gcs.scenario.accuracy import widest_m
from gcs.scenario.model import Obstacle, Scenario, VehicleBase, keeps_apart
from gcs.scenario.types import Vec3
from skytender import elementary
from skytender.geometry import FloatArray, bounds, of_scenario
from skytender.safety.silence import MOST_LOST_S, Failsafe

Flags = NDArray[np.bool_]
LOST_AFTER_PERIODS, LEAST_LOST_S = 5, 0.1
"""[choice] Periods without a set point after which a launched vehicle holds; the shortest wait that it can be set
to."""
GONE_AFTER_PERIODS = 2
"""[choice] The same where none is lost or late by itself: two that are missing were kept from it."""
OVER_M = 1.5
"""[choice] Above the highest obstacle a launched vehicle returns, where its parameters do not say how high; and above
the highest place to which the scenario sends one."""
LEAST_ALTITUDE_M, MOST_ALTITUDE_M = 1.0, 150.0
"""Least and greatest RTL_RETURN_ALT of our vehicles."""
LAYER_SPARE_M = 0.4
"""[choice] Between two heights of returns beyond the separation: margins of both, and as much again."""
SLACK_S = 4.0
"""[choice] Beyond the time of a leg at its speed: to set out and to come to rest, and for a heartbeat that was lost."""
DESCEND_M = 5.0
"""[choice] Above home: from there vehicles that return by the timetable land."""


def failsafes_of(scenario: Scenario) -> dict[int, Failsafe]:
    """Failsafe of each launched vehicle of ours, by system id."""
    vehicles = [vehicle for vehicle in scenario.vehicles.launched if vehicle.real is None]
    alone = {vehicle.sysid: failsafe_of(vehicle, scenario) for vehicle in vehicles}
    return _timetable(vehicles, alone, scenario) if keeps_apart(scenario) else alone


def shared_heights(scenario: Scenario) -> list[tuple[int, ...]]:
    """System ids of vehicles that have to return at one height though their ways may meet, as there is no other; those
    of each such height."""
    if not keeps_apart(scenario):
        return []
    vehicles = [vehicle for vehicle in scenario.vehicles.launched if vehicle.real is None]
    heights = {sysid: failsafe.altitude_m for sysid, failsafe in failsafes_of(scenario).items()}
    meet, found = _meeting(_boxes(vehicles, scenario)), dict[float, set[int]]()
    pair_m, _ = widest_m(scenario)
    for i, j in np.argwhere(np.triu(meet, 1)).tolist():
        one, other = vehicles[i], vehicles[j]
        height_m = heights[one.sysid] - one.start_m[2]
        if abs(height_m - heights[other.sysid] + other.start_m[2]) < scenario.planner.separation_m + pair_m:
            found.setdefault(round(height_m, 3), set()).update((one.sysid, other.sysid))
    return [tuple(sorted(sysids)) for _, sysids in sorted(found.items())]


def facts(scenario: Scenario) -> list[str]:
    """Plan B in sentences, for people: heights and times, and for which vehicles there is none."""
    lines = []
    found = failsafes_of(scenario)
    if keeps_apart(scenario):
        heights_m = sorted(failsafe.altitude_m for failsafe in found.values())
        one = next(iter(found.values()))
        lines.append(
            f"plan B: without the station {len(found)} vehicles return {heights_m[0]:.1f} to {heights_m[-1]:.1f} m "
            f"above home, level after {one.level_after_s:.1f} s, down after {one.down_after_s:.1f} s"
        )
    for sysids in shared_heights(scenario):
        lines.append(f"plan B: {_named(sysids)} return at one height, and keep apart there by their radio alone")
    if others := [vehicle.sysid for vehicle in scenario.vehicles.all if vehicle.sysid not in found]:
        lines.append(f"plan B: none for {_named(others)}: autopilots that are not ours return by their own parameters")
    return lines


def _named(sysids: Sequence[int]) -> str:
    return f"vehicle{'s' * (len(sysids) > 1)} {', '.join(map(str, sysids))}"


def _timetable(vehicles: Sequence[VehicleBase], alone: dict[int, Failsafe], scenario: Scenario) -> dict[int, Failsafe]:
    """Heights and times of a fleet's return; a height that a vehicle's own parameters give stays."""
    boxes = _boxes(vehicles, scenario)
    layers = _coloured(_meeting(boxes))
    gap_m = scenario.planner.separation_m + widest_m(scenario)[0] + LAYER_SPARE_M
    over_m = max(
        _highest_place_m(vehicles, scenario) + OVER_M, *(alone[v.sysid].altitude_m - v.start_m[2] for v in vehicles)
    )
    found = {}
    for vehicle, layer in zip(vehicles, layers, strict=True):
        failsafe = alone[vehicle.sysid]
        if "RTL_RETURN_ALT" not in vehicle.params:
            altitude_m = over_m + gap_m * layer + vehicle.start_m[2]
            altitude_m = min(max(altitude_m, LEAST_ALTITUDE_M), MOST_ALTITUDE_M)
            failsafe = replace(failsafe, altitude_m=altitude_m)
        found[vehicle.sysid] = replace(failsafe, descend_m=DESCEND_M)
    slowest = min(failsafe.speed_m_s for failsafe in found.values())
    highest_m = max(failsafe.altitude_m for failsafe in found.values())
    wide_m = max(elementary.hypot(*(box[2:] - box[:2]).tolist()) for box in boxes)
    level_s = highest_m / slowest + SLACK_S
    down_s = level_s + wide_m / slowest + SLACK_S
    lands_s = max(min(one.descend_m, one.altitude_m) / one.sink_m_s for one in found.values())
    again_s = down_s + highest_m / slowest + lands_s + SLACK_S
    times = {"level_after_s": level_s, "down_after_s": down_s, "again_after_s": again_s}
    return {sysid: replace(failsafe, **times) for sysid, failsafe in found.items()}


def _places(vehicle: VehicleBase, scenario: Scenario) -> Iterator[Vec3]:
    """To where the scenario sends a vehicle, its start first."""
    yield vehicle.start_m
    n, e, d = vehicle.start_m
    yield (n, e, d - vehicle.takeoff_m)
    yield from getattr(vehicle, "waypoints_m", ())
    yield from getattr(vehicle, "path_m", ())
    if (home_m := getattr(vehicle, "home_m", None)) is not None:
        yield home_m
    for base in scenario.bases:
        yield base.above_m


def _boxes(vehicles: Sequence[VehicleBase], scenario: Scenario) -> FloatArray:
    """(n, 4) least north and east, greatest north and east of where each may be when it begins to return, and of its
    home. Pursuers without way points are where targets are, tankers where pursuers are."""
    rows, targets, pursuers = [], np.empty((0, 3)), np.empty((0, 3))
    ring_m = scenario.formation.ring_m or 0.0
    places = {vehicle.sysid: np.array(list(_places(vehicle, scenario))) for vehicle in vehicles}
    for role in ("target", "pursuer", "tanker"):
        for vehicle in vehicles:
            if vehicle.role != role:
                continue
            own = places[vehicle.sysid]
            if role == "pursuer" and not getattr(vehicle, "waypoints_m", ()) and len(targets):
                own = np.vstack([own, targets - ring_m, targets + ring_m])
            if role == "tanker":
                own = np.vstack([own, pursuers])
            places[vehicle.sysid] = own
        of_role = [places[vehicle.sysid] for vehicle in vehicles if vehicle.role == role]
        if of_role and role == "target":
            targets = np.vstack(of_role)
        elif of_role and role == "pursuer":
            every = np.vstack(of_role)
            pursuers = np.array([every.min(axis=0), every.max(axis=0)])
    for vehicle in vehicles:
        own = places[vehicle.sysid][:, :2]
        rows.append([*own.min(axis=0), *own.max(axis=0)])
    half_m = 0.5 * (scenario.planner.separation_m + widest_m(scenario)[0]) + LAYER_SPARE_M
    return np.array(rows) + np.array([-half_m, -half_m, half_m, half_m])


def _highest_place_m(vehicles: Sequence[VehicleBase], scenario: Scenario) -> float:
    """Height of the highest place to which the scenario sends any of them, above its height 0."""
    highest_m = max(-place[2] for vehicle in vehicles for place in _places(vehicle, scenario))
    if scenario.vehicles.targets:
        highest_m += max(scenario.formation.height_m, 0.0)
    return highest_m + (scenario.refuelling.height_m if scenario.vehicles.tankers else 0.0)


def _meeting(boxes: FloatArray) -> Flags:
    """(n, n) whose boxes (n, 4) overlap."""
    low, high = boxes[:, :2], boxes[:, 2:]
    begins = low[:, np.newaxis] <= high[np.newaxis]
    meet: Flags = np.all(begins & begins.transpose(1, 0, 2), axis=2)
    return meet


def _coloured(meet: Flags) -> list[int]:
    """A number for each row, different from those that it meets; the lowest that is free."""
    numbers: list[int] = []
    for i in range(len(meet)):
        taken = {numbers[j] for j in np.flatnonzero(meet[i, :i]).tolist()}
        numbers.append(next(k for k in range(i + 1) if k not in taken))
    return numbers


def failsafe_of(vehicle: VehicleBase, scenario: Scenario) -> Failsafe:
    """Failsafe of a launched vehicle that is alone: by its parameters, and else one for who knows of no obstacle.

    It returns above all of them. Without set points it flies on as it did, where the next one might have led it around
    something, so that it waits no longer than for a few that were lost, or for the radio's jitter.
    """
    params, usual = vehicle.params, Failsafe()
    altitude_m = params.get("RTL_RETURN_ALT")
    if altitude_m is None:
        over_m = _highest_m(scenario.obstacles) + OVER_M + vehicle.start_m[2]
        altitude_m = min(max(usual.altitude_m, math.ceil(over_m)), MOST_ALTITUDE_M)
    radio, lockstep = scenario.radio, scenario.clock.mode == "lockstep"
    frames_go_missing = (
        radio.loss or radio.reorder or any(fault.fault in ("loss", "delay") for fault in scenario.faults)
    )
    flies_itself = scenario.competition.where == "vehicles"  # and begins to a moment before it would hold
    sure = lockstep and not frames_go_missing and not flies_itself
    periods = GONE_AFTER_PERIODS if sure else LOST_AFTER_PERIODS
    waits_s = periods * scenario.clock.period_s + radio.jitter_s
    return Failsafe(
        params.get("COM_DL_LOSS_T", usual.loss_s),
        params.get("COM_OF_LOSS_T", min(max(waits_s, LEAST_LOST_S), MOST_LOST_S)),
        altitude_m,
        params.get("MPC_XY_CRUISE", usual.speed_m_s),
        params.get("MPC_LAND_SPEED", usual.sink_m_s),
    )


@functools.lru_cache(4)
def _highest_m(obstacles: tuple[Obstacle, ...]) -> float:
    """Height of the highest obstacle's top above the scenario's height 0; 0 without any."""
    low, _ = bounds(of_scenario(obstacles)) if obstacles else (np.zeros((1, 3)), None)
    return -float(low[:, 2].min())
