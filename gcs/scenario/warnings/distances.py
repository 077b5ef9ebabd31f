"""Warnings of speed, latency, ranges and separations that do not fit."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from gcs.scenario import goal
from gcs.scenario.model import Scenario
from gcs.scenario.types import Vec3
from gcs.scenario.warnings.slips import sent_to
from gcs.scenario.warnings.warning import ScenarioWarning
from skytender import elementary, elementwise, geometry

LAG_S = 0.37
"""Distance that a vehicle flies behind its planned point (docs/model/control.md#guidance)."""
LAUNCHED_M_S2 = 5.0
"""The greatest horizontal acceleration of a launched vehicle."""
EXTERNAL_ERROR_M = 1.0
"""Distance of real autopilots from their set points in sharp turns (docs/how-to/external-autopilots.md)."""
FILTERED_M_S = 5.0
"""Speed up to which the safety filter keeps vehicles apart (docs/model/safety.md#safety-layer)."""
CROSSED_SHARE = 0.5
"""With the safety filter a ring is warned of where it loses more than this share of its places at once."""
RING_LOOKS, PATH_STEP_M = 36, 0.25
MOST_LOOKS = 200_000
"""Places of rings at which obstacles are looked for, in all; long paths are looked at more coarsely."""


def latency_s(scenario: Scenario) -> float:
    """From what happens until a vehicle's answer to it: a period, the vehicle's lag, the radio to and fro."""
    radio_s = 2.0 * (scenario.radio.delay_s + 0.5 * scenario.radio.jitter_s)
    return scenario.clock.period_s + LAG_S + radio_s


def stopping_m(scenario: Scenario, speed_m_s: float) -> float:
    """The way that a vehicle flies before it stands: through the latency, then braking, v²/(2a)."""
    return speed_m_s * latency_s(scenario) + speed_m_s * speed_m_s / (2.0 * LAUNCHED_M_S2)


def warnings(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Those about distances first."""
    for of in (_of_speed, _of_places, _of_the_ring, _of_the_pursuit, _of_the_fence, _of_the_ground, _of_the_charge):
        yield from of(scenario)


def _of_speed(scenario: Scenario) -> Iterator[ScenarioWarning]:
    rules, vehicles = scenario.planner, scenario.vehicles
    separation_m = goal.separation_m(scenario)
    speed_m_s = rules.cruise_m_s
    if rules.safety and speed_m_s <= FILTERED_M_S:
        yield from _of_filtered(scenario)
        return
    need_m = stopping_m(scenario, speed_m_s)
    how = (
        f"at {speed_m_s:g} m/s a vehicle needs {need_m:.1f} m to stand ({latency_s(scenario):.2f} s of latency: "
        f"period, {LAG_S} s of lag, radio to and fro; braking at {LAUNCHED_M_S2:g} m/s²)"
    )
    if vehicles.pursuers and separation_m and 2.0 * need_m > separation_m + 2.0 * rules.repulsion_range_m:
        yield ScenarioWarning(
            "separation",
            f"{how}; two that meet head on need {2.0 * need_m:.1f} m, and repel each other from {separation_m:g} m + "
            f"2 · {rules.repulsion_range_m:g} m on: lower planner.cruise_m_s or widen planner.repulsion_range_m",
        )
    if vehicles.pursuers and scenario.obstacles and need_m > rules.repulsion_range_m:
        yield ScenarioWarning(
            "clearance",
            f"{how}, and obstacles repel from planner.repulsion_range_m, {rules.repulsion_range_m:g} m, on",
        )
    fastest = max((mover.speed_m_s for mover in scenario.traffic if not mover.attracts), default=0.0)
    traffic_m = goal.traffic_m(scenario)
    if traffic_m and vehicles.pursuers and traffic_m + fastest * latency_s(scenario) > rules.repulsion_range_m:
        yield ScenarioWarning(
            "traffic",
            f"traffic at {fastest:g} m/s flies {fastest * latency_s(scenario):.1f} m before a vehicle answers; with "
            f"the {traffic_m:g} m that the goal wants this is more than planner.repulsion_range_m, "
            f"{rules.repulsion_range_m:g} m",
        )
    yield from _of_external(scenario)


def _of_filtered(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Approaches that the safety filter cannot prevent: of traffic that is faster, and of real autopilots in turns."""
    fastest = max((mover.speed_m_s for mover in scenario.traffic if not mover.attracts), default=0.0)
    if scenario.vehicles.pursuers and goal.traffic_m(scenario) and fastest > scenario.planner.cruise_m_s:
        yield ScenarioWarning(
            "traffic",
            f"traffic at {fastest:g} m/s is faster than planner.cruise_m_s, {scenario.planner.cruise_m_s:g} m/s: a "
            "vehicle in its way may not get out of it",
        )
    yield from _of_external(scenario)


def _of_external(scenario: Scenario) -> Iterator[ScenarioWarning]:
    separation_m = goal.separation_m(scenario)
    if scenario.vehicles.external and separation_m and separation_m < 2.0 * EXTERNAL_ERROR_M:
        yield ScenarioWarning(
            "separation",
            f"external autopilots fly up to about {EXTERNAL_ERROR_M:g} m beside their set points in sharp turns: a "
            f"separation of {separation_m:g} m is less than two of them can be off",
        )


def _of_places(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Pursuers whose place is their target's, and rings on which there is no room."""
    vehicles, ring_m = scenario.vehicles, scenario.formation.ring_m
    separation_m = goal.separation_m(scenario)
    if separation_m is None or (scenario.planner.method != "potential_field"):
        return
    followers: dict[int, list[str]] = {}
    for pursuer in vehicles.pursuers:
        if (target := vehicles.target_of(pursuer)) is not None:
            followers.setdefault(target, []).append(pursuer.label)
    offset_m = elementary.hypot(ring_m or 0.0, scenario.formation.height_m)
    for target, labels in followers.items():
        chosen = labels if scenario.pursuit.by == "all" else labels[:1]
        if offset_m < separation_m:
            who = labels[0] if len(labels) == 1 else f"{labels[0]} and {len(labels) - 1} more"
            where = "is the target's own" if not offset_m else f"is {offset_m:g} m from the target"
            yield ScenarioWarning(
                "separation",
                f"the place of {who} {where} ({target}), and the goal wants {separation_m:g} m: give formation.ring_m",
            )
        elif ring_m and len(chosen) > 1 and 2.0 * ring_m * elementary.sin(math.pi / len(chosen)) < separation_m:
            gap_m = 2.0 * ring_m * elementary.sin(math.pi / len(chosen))
            yield ScenarioWarning(
                "separation",
                f"on a ring of {ring_m:g} m {len(chosen)} pursuers of {target} are {gap_m:.2f} m apart, and the goal "
                f"wants {separation_m:g} m: widen formation.ring_m",
            )


def _of_the_ring(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Obstacles that the ring comes too near while the target flies its path."""
    ring_m, clearance_m = scenario.formation.ring_m, goal.clearance_m(scenario)
    if not ring_m or clearance_m is None or scenario.planner.method != "potential_field":
        return
    shapes = geometry.of_scenario(scenario.obstacles)
    angles = 2.0 * math.pi * np.arange(RING_LOOKS) / RING_LOOKS
    down_m = np.full(RING_LOOKS, -scenario.formation.height_m)
    ring = np.column_stack((ring_m * elementwise.cosines(angles), ring_m * elementwise.sines(angles), down_m))
    followed = {scenario.vehicles.target_of(pursuer) for pursuer in scenario.vehicles.pursuers}
    for target in scenario.vehicles.targets:
        if target.sysid not in followed:
            continue
        places = _along(target.path_m, closed=target.closed)
        places = places[:: max(1, len(places) * RING_LOOKS * len(shapes) // (100 * MOST_LOOKS))]
        everywhere = (places[:, None] + ring[None]).reshape(-1, 3)
        crossed, taken = [], np.zeros(len(everywhere), dtype=np.bool_)
        for k, shape in enumerate(scenario.obstacles):
            inside = geometry.clearance(shapes[k : k + 1], everywhere) < max(clearance_m, PATH_STEP_M / 2.0)
            if inside.any():
                crossed.append(shape.name or f"{shape.kind} {k + 1}")
                taken |= inside
        if scenario.planner.safety and taken.reshape(-1, RING_LOOKS).mean(axis=1).max(initial=0.0) <= CROSSED_SHARE:
            continue
        if crossed:
            more = f" and {len(crossed) - 1} more" if len(crossed) > 1 else ""
            yield ScenarioWarning(
                "clearance",
                f"the ring of {ring_m:g} m around {target.label} crosses {crossed[0]}{more} on the target's way: who "
                "has that place must leave it",
            )


def _of_the_pursuit(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """A goal that wants pursuers nearer to their targets than their places are."""
    wanted, place_m = (
        scenario.goal.pursue,
        elementary.hypot(scenario.formation.ring_m or 0.0, scenario.formation.height_m),
    )
    followers = [one for one in scenario.vehicles.pursuers if scenario.vehicles.target_of(one) is not None]
    if wanted is None or not followers or scenario.planner.method != "potential_field":
        return
    if place_m > wanted.within_m:
        yield ScenarioWarning(
            "pursue",
            f"the places of pursuers are {place_m:g} m from their target, and goal.pursue wants them within "
            f"{wanted.within_m:g} m: widen within_m or lower formation.ring_m and height_m",
        )


def _of_the_fence(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Places for vehicles that the fence forbids."""
    places: list[tuple[str, Sequence[float]]] = [
        *((f"base {base.name}", base.position_m) for base in scenario.bases),
        *((f"rally point {k}", place) for k, place in enumerate(scenario.rally_m, 1)),
    ]
    for vehicle in scenario.vehicles.launched:
        places.append((f"the start of {vehicle.label}", vehicle.start_m))
    places += sent_to(scenario)
    beyond = [name for name, place in places if not scenario.fence.allows(place[0], place[1])]
    if beyond:
        kept = (
            "a vehicle sent there stops at it"
            if scenario.planner.safety
            else "without the safety layer the planner does not know it, and vehicles keep it by themselves"
        )
        which = f"{beyond[0]} and {len(beyond) - 1} more lie" if len(beyond) > 1 else f"{beyond[0]} lies"
        yield ScenarioWarning(
            "fence",
            f"{which} beyond the fence: {kept}; move them or the fence",
        )


def _of_the_ground(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Places below the zero of heights that a vehicle is sent to: nearly always a wrong sign."""
    below = [(name, place[2]) for name, place in sent_to(scenario) if place[2] > 0.0]
    if below:
        (name, down_m), others = below[0], len(below) - 1
        which = f"{name} and {others} more lie below the ground, the first" if others else f"{name} lies"
        yield ScenarioWarning(
            "ground",
            f"{which} {down_m:g} m below the zero of heights, where vehicles launched stand: is the sign wrong? "
            "In ned axes the third number is down",
        )


def _of_the_charge(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """A service after which its receiver wants the next one at once, and bases that no vehicle may use."""
    rules, competition, pursuers = scenario.refuelling, scenario.competition, scenario.vehicles.pursuers
    givers = scenario.vehicles.tankers or scenario.bases
    if scenario.bases and not scenario.vehicles.tankers and pursuers and all(p.transfer_capable for p in pursuers):
        yield ScenarioWarning(
            "refuelling",
            "no vehicle is served at a base: vehicles that take energy in flight are served by tankers, and there is "
            "none; give those that are to land at bases 'transfer: false'",
        )
    competes_at = 1.0 - competition.need_from
    if givers and rules.enabled and competition.enabled and rules.until <= competes_at:
        yield ScenarioWarning(
            "refuelling",
            f"refuelling.until fills a battery to {100.0 * rules.until:g} %, and from {100.0 * competes_at:g} % down a "
            "vehicle competes: it wants the next service at once; raise until or competition.need_from",
        )


def _along(path: tuple[Vec3, ...], *, closed: bool) -> geometry.FloatArray:
    """Places along a path, PATH_STEP_M apart."""
    corners = [*path, path[0]] if closed else list(path)
    legs = [np.array([corners[0]], dtype=np.float64)]
    for a, b in pairwise(corners):
        count = max(2, min(math.ceil(elementary.distance(a, b) / PATH_STEP_M) + 1, 100_000))
        legs.append(np.linspace(a, b, count)[1:])
    return np.concatenate(legs)
