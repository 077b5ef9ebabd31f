"""Warnings of places that lie too near to each other for vehicles that do not know exactly where they are."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations

from gcs.scenario.accuracy import spreads_m
from gcs.scenario.model import Scenario
from gcs.scenario.warnings.warning import ScenarioWarning
from skytender import elementary


def warnings(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Starts, last way points and rings without room for errors of places."""
    rules, spreads = scenario.planner, spreads_m(scenario)
    if not any(spreads.values()):
        return
    if not rules.safety:
        yield ScenarioWarning(
            "accuracy",
            f"vehicles know their places to {_worst_m(scenario):g} m, and without the safety filter nothing keeps them "
            "farther apart for that: leave planner.safety on",
        )
        return
    if rules.vehicles_repel:
        yield from _of_pairs(scenario, spreads)
        yield from _of_rings(scenario, spreads)


def _worst_m(scenario: Scenario) -> float:
    return max(vehicle.sensors.position_m for vehicle in scenario.vehicles.all if vehicle.sensors is not None)


def why_kept(scenario: Scenario, kept_m: float) -> str:
    """Reason for a distance that is kept between places that are not known exactly."""
    return (
        f"with places known to {_worst_m(scenario):g} m at least {kept_m:.2f} m are kept "
        f"(planner.confidence {scenario.planner.confidence:g})"
    )


def _of_pairs(scenario: Scenario, spreads: dict[int, float]) -> Iterator[ScenarioWarning]:
    """Starts of vehicles that begin together, and last way points."""
    launched = scenario.vehicles.launched
    starts = [(v.label, v.sysid, v.start_m, v.join_s) for v in launched]
    ends = [(v.label, v.sysid, v.waypoints_m[-1], 0.0) for v in scenario.vehicles.pursuers if v.waypoints_m]
    for what, places in (("start", starts), ("end", ends)):
        near = []
        for (one, a, here, at_s), (other, b, there, joins_s) in combinations(places, 2):
            kept_m = scenario.planner.separation_m + elementary.hypot(spreads[a], spreads[b])
            apart_m = elementary.distance(here, there)
            if at_s == joins_s and apart_m < kept_m:
                near.append((apart_m - kept_m, apart_m, kept_m, one, other))
        if near:
            _, apart_m, kept_m, one, other = min(near)
            more = f", the nearest of {len(near)} such pairs" if len(near) > 1 else ""
            yield ScenarioWarning(
                "accuracy", f"{one} and {other} {what} {apart_m:.2f} m apart{more}: {why_kept(scenario, kept_m)}"
            )


def _of_rings(scenario: Scenario, spreads: dict[int, float]) -> Iterator[ScenarioWarning]:
    """Rings whose places are too near to each other or to their target."""
    vehicles, ring_m = scenario.vehicles, scenario.formation.ring_m
    if not ring_m or scenario.planner.method != "potential_field" or scenario.pursuit.by != "all":
        return
    followers: dict[int, list[int]] = {}
    for pursuer in vehicles.pursuers:
        if (target := vehicles.target_of(pursuer)) is not None:
            followers.setdefault(target, []).append(pursuer.sysid)
    labels = {vehicle.sysid: vehicle.label for vehicle in vehicles.all}
    for target, around in followers.items():
        widest_m = max(spreads[sysid] for sysid in around)
        inside_m = elementary.hypot(ring_m, scenario.formation.height_m)
        beside_m = 2.0 * ring_m * elementary.sin(math.pi / len(around)) if len(around) > 1 else math.inf
        separation_m = scenario.planner.separation_m
        for gap_m, what, kept_m in (
            (beside_m, "each other", separation_m + elementary.hypot(widest_m, widest_m)),
            (inside_m, labels[target], separation_m + elementary.hypot(widest_m, spreads[target])),
        ):
            if gap_m < kept_m:
                yield ScenarioWarning(
                    "accuracy",
                    f"on the ring around {labels[target]} vehicles are {gap_m:.2f} m from {what}: "
                    f"{why_kept(scenario, kept_m)}; widen formation.ring_m",
                )
                break
