"""Ways by which vehicles come home, as boxes: whose may meet, and how high lies above all of them [choice]."""

from __future__ import annotations

import functools
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from gcs.scenario.accuracy import widest_m
from gcs.scenario.model import Obstacle, Scenario, VehicleBase
from gcs.scenario.parts.mission import way_of
from gcs.scenario.types import Vec3
from skytender.geometry import FloatArray, bounds, of_scenario

Flags = NDArray[np.bool_]
OVER_M = 1.5
"""[choice] Above the highest obstacle a launched vehicle returns, where its parameters do not say how high; and above
the highest place to which the scenario sends one."""
LAYER_SPARE_M = 0.4
"""[choice] Between two heights of returns beyond the separation: margins of both, and as much again."""


def places_of(vehicle: VehicleBase, scenario: Scenario) -> Iterator[Vec3]:
    """To where the scenario sends a vehicle, its start first."""
    yield vehicle.start_m
    n, e, d = vehicle.start_m
    yield (n, e, d - vehicle.takeoff_m)
    yield from getattr(vehicle, "waypoints_m", ())
    yield from getattr(vehicle, "path_m", ())
    yield from way_of(vehicle, scenario)
    if (home_m := getattr(vehicle, "home_m", None)) is not None:
        yield home_m
    for base in scenario.bases:
        yield base.above_m


def boxes_of(vehicles: Sequence[VehicleBase], scenario: Scenario) -> FloatArray:
    """(n, 4) least north and east, greatest north and east of where each may be when it begins to return, and of its
    home. Pursuers without way points are where targets are, tankers where pursuers are."""
    rows, targets, pursuers = [], np.empty((0, 3)), np.empty((0, 3))
    ring_m = scenario.formation.ring_m or 0.0
    places = {vehicle.sysid: np.array(list(places_of(vehicle, scenario))) for vehicle in vehicles}
    for role in ("target", "pursuer", "tanker"):
        for vehicle in vehicles:
            if vehicle.role != role:
                continue
            own = places[vehicle.sysid]
            if role == "pursuer" and not getattr(vehicle, "own_way", False) and len(targets):
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


def highest_place_m(vehicles: Sequence[VehicleBase], scenario: Scenario) -> float:
    """Height of the highest place to which the scenario sends any of them, above its height 0."""
    highest_m = max(-place[2] for vehicle in vehicles for place in places_of(vehicle, scenario))
    if scenario.vehicles.targets:
        highest_m += max(scenario.formation.height_m, 0.0)
    return highest_m + (scenario.refuelling.height_m if scenario.vehicles.tankers else 0.0)


def meeting(boxes: FloatArray) -> Flags:
    """(n, n) whose boxes (n, 4) overlap."""
    low, high = boxes[:, :2], boxes[:, 2:]
    begins = low[:, np.newaxis] <= high[np.newaxis]
    return np.all(begins & begins.transpose(1, 0, 2), axis=2)


def coloured(meet: Flags) -> list[int]:
    """A number for each row, different from those that it meets; the lowest that is free."""
    numbers: list[int] = []
    for i in range(len(meet)):
        taken = {numbers[j] for j in np.flatnonzero(meet[i, :i]).tolist()}
        numbers.append(next(k for k in range(i + 1) if k not in taken))
    return numbers


@functools.lru_cache(4)
def highest_obstacle_m(obstacles: tuple[Obstacle, ...]) -> float:
    """Height of the highest obstacle's top above the scenario's height 0; 0 without any."""
    low, _ = bounds(of_scenario(obstacles)) if obstacles else (np.zeros((1, 3)), None)
    return -float(low[:, 2].min())
