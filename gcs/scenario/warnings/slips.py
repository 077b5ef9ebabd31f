"""Figures of a scenario that are valid and probably slips: shares for per cent, degrees for metres, speeds and
distances that no vehicle flies in the time there is, gains that do not take off."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from gcs.scenario.model import Scenario
from gcs.scenario.parts.vehicles import Tanker, Target, VehicleBase
from gcs.scenario.types import Vec3
from gcs.scenario.warnings.warning import ScenarioWarning
from skytender import elementary

LAUNCHED_M_S = 5.0
"""Greatest speed of a launched vehicle's guidance where its MPC_XY_VEL_MAX is not set."""
NEAR_DEG = 1.0
"""Metres that are as near to the origin's latitude and longitude, as numbers, are taken for degrees."""
FLOWN_SHARE = 0.5
"""A path of which less than this is flown, or that ends before this share of the session, is warned of."""


def warnings(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Those about units first."""
    for of in (_of_units, _of_gains, _of_speeds, _of_times):
        yield from of(scenario)


def _of_units(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Figures that look as if they were in another unit."""
    for vehicle in scenario.vehicles.all:
        percent = vehicle.battery.initial_percent
        if 0.0 < percent <= 1.0:
            yield ScenarioWarning(
                "battery",
                f"{vehicle.label} starts with {percent:g} % of its charge: battery.initial_percent is in per cent; "
                f"write {100.0 * percent:g} if that share is meant",
            )
    lat_deg, lon_deg = scenario.origin.lat_deg, scenario.origin.lon_deg
    if elementary.hypot(lat_deg, lon_deg) < 5.0 * NEAR_DEG:
        return
    for name, (north_m, east_m, _) in _places(scenario):
        near = max(
            abs(north_m - lat_deg), abs(abs(east_m) - abs(lon_deg))
        )  # the paper's axes turn the second one round
        if near < NEAR_DEG:
            yield ScenarioWarning(
                "place",
                f"{name} is [{north_m:g}, {east_m:g}] m from the origin, whose latitude and longitude are these very "
                "numbers: places are in metres, and [0, 0, 0] is the origin",
            )


def _of_gains(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Gain sets of the paper on the ground (docs/model/vehicle.md)."""
    for vehicle in scenario.vehicles.all:
        if vehicle.params.get("SIM_GAIN_SET") and not vehicle.airborne:
            yield ScenarioWarning(
                "take-off",
                f"{vehicle.label} starts on the ground, where the paper's gains (SIM_GAIN_SET 1 and 2) do not take "
                "off: give it airborne: true, or leave SIM_GAIN_SET out",
            )


def _of_speeds(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Speeds that a vehicle does not reach, or that its followers do not."""
    cruise_m_s = scenario.planner.cruise_m_s
    followed = {scenario.vehicles.target_of(pursuer) for pursuer in scenario.vehicles.pursuers}
    own_planner = scenario.planner.method != "potential_field"
    moving: tuple[Target | Tanker, ...] = (*scenario.vehicles.targets, *scenario.vehicles.tankers)
    for vehicle in moving:
        most_m_s = _most_m_s(vehicle)
        if vehicle.speed_m_s > most_m_s:
            yield ScenarioWarning(
                "speed",
                f"{vehicle.label} is to fly at {vehicle.speed_m_s:g} m/s, and its guidance flies {most_m_s:g} m/s at "
                "most: lower speed_m_s, or raise MPC_XY_VEL_MAX in its params",
            )
        if vehicle.sysid in followed and vehicle.speed_m_s > cruise_m_s and not own_planner:
            yield ScenarioWarning(
                "speed",
                f"{vehicle.label} flies at {vehicle.speed_m_s:g} m/s and its pursuers at {cruise_m_s:g} m/s at most: "
                "they fall behind; raise planner.cruise_m_s or lower speed_m_s",
            )


def _of_times(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Ways that are too long for the session, or end long before it."""
    duration_s = scenario.goal.duration_s
    for pursuer in scenario.vehicles.pursuers:
        way_m = _length_m((pursuer.start_m, *pursuer.waypoints_m))
        if pursuer.waypoints_m and way_m > scenario.planner.cruise_m_s * duration_s:
            yield ScenarioWarning(
                "waypoints",
                f"the way points of {pursuer.label} are {way_m:.0f} m of way, and at planner.cruise_m_s, "
                f"{scenario.planner.cruise_m_s:g} m/s, it flies {scenario.planner.cruise_m_s * duration_s:.0f} m in "
                f"goal.duration_s, {duration_s:g} s: is one too far away?",
            )
    for target in scenario.vehicles.targets:
        yield from _of_path(target, min(target.speed_m_s, _most_m_s(target)), duration_s)


def _of_path(target: Target, speed_m_s: float, duration_s: float) -> Iterator[ScenarioWarning]:
    if len(target.path_m) < 2 or speed_m_s <= 0.0:
        return
    corners = (*target.path_m, target.path_m[0]) if target.closed else target.path_m
    lap_m, flown_m = _length_m(corners), speed_m_s * duration_s
    if flown_m < FLOWN_SHARE * lap_m:
        yield ScenarioWarning(
            "path",
            f"the path of {target.label} is {lap_m:.0f} m long, and it flies {flown_m:.0f} m of it in goal.duration_s, "
            f"{duration_s:g} s: is a corner too far away?",
        )
    elif target.closed and "laps" not in target.model_fields_set and lap_m < FLOWN_SHARE * flown_m:
        yield ScenarioWarning(
            "path",
            f"{target.label} flies its closed path once, in {lap_m / speed_m_s:.0f} s, and then hovers until the end "
            f"at {duration_s:g} s: laps is how often it is flown, {math.ceil(flown_m / lap_m)} to fill the session",
        )


def _most_m_s(vehicle: VehicleBase) -> float:
    """Greatest speed of a vehicle's guidance; inf where an autopilot of another make flies it."""
    if vehicle.is_foreign:
        return math.inf
    return float(vehicle.params.get("MPC_XY_VEL_MAX", LAUNCHED_M_S))


def _length_m(corners: tuple[Vec3, ...]) -> float:
    return sum(elementary.distance(a, b) for a, b in pairwise(corners))


def _places(scenario: Scenario) -> Iterator[tuple[str, Vec3]]:
    """Starts, corners, way points and bases, by name."""
    for vehicle in scenario.vehicles.all:
        if vehicle.external is None:
            yield f"the start of {vehicle.label}", vehicle.start_m
    yield from sent_to(scenario)
    for base in scenario.bases:
        yield f"base {base.name}", base.position_m


def sent_to(scenario: Scenario) -> list[tuple[str, Vec3]]:
    """Places that vehicles are sent to, by name."""
    places: list[tuple[str, Vec3]] = []
    for vehicle in scenario.vehicles.all:
        for name, key in (("way point", "waypoints_m"), ("corner", "path_m")):
            route = getattr(vehicle, key, ())
            places += [(f"{name} {k} of {vehicle.label}", place) for k, place in enumerate(route, 1)]
        if home_m := getattr(vehicle, "home_m", None):
            places.append((f"the home of {vehicle.label}", home_m))
    return places
