"""From a session's start to an instance, and from a schedule back to a session.

Both say the same of what an instance has: paths, batteries, tankers, bases and rules of transfers. What it has not
(obstacles, wind, the radio, who keeps apart from whom) is left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import Any

from gcs.benchmark import format
from gcs.refuelling.policies import RefuellingRequest
from gcs.scenario.model import Pursuer, Scenario
from gcs.scenario.rules import PlannerRules
from gcs.telemetry.state import VehicleView
from skytender import elementary

OUTSIDE_SPEED_M_S = 3.0
"""[choice] Of a receiver off its path, where the scenario has no way points at a speed of their own."""
SLOWEST_M_S = 0.1
MEETS_S = 2.2
"""Of a service in flight beside the way, `hold_s` and the flow of energy: to come to rest above the receiver, and to
part."""
ALIKE = 1e-4
"""Shares of capacities that differ by less are one."""
EARLY_S = 1.0
"""A tanker sets out so long before its schedule needs it to."""


def instance_of(scenario: Scenario) -> format.Instance:
    """The instance of a session that begins now: receivers are its pursuers, the horizon is its end."""
    horizon_s, rules = scenario.goal.duration_s, scenario.refuelling
    receivers = [
        format.BenchmarkReceiver(
            one.sysid, _path(one, scenario), max(scenario.planner.cruise_m_s, SLOWEST_M_S), one.battery.capacity_j,
            one.battery.capacity_j * one.battery.initial_percent / 100.0, one.battery.hover_w + one.battery.avionics_w,
            rules.lands_at * one.battery.capacity_j,
        )
        for one in scenario.vehicles.pursuers
    ]  # fmt: skip
    tankers = [
        format.BenchmarkTanker(
            one.sysid, one.start_m if one.airborne else _above(one.start_m, one.takeoff_m), one.speed_m_s,
            one.battery.capacity_j, one.battery.capacity_j * one.battery.initial_percent / 100.0,
            one.battery.hover_w + one.battery.avionics_w, one.reserve_j,
        )
        for one in scenario.vehicles.tankers
    ]  # fmt: skip
    bases = [format.BenchmarkBase(base.name, base.above_m, float(base.stock_j), base.rate_w) for base in scenario.bases]
    return format.Instance(
        format.INSTANCE, scenario.name, "session", 0.0, scenario.seed, horizon_s, MEETS_S + rules.hold_s, rules.rate_w,
        receivers, tankers, bases,
    )  # fmt: skip


def _above(place: format.Vec3, height_m: float) -> format.Vec3:
    return (place[0], place[1], place[2] - height_m)


def _path(pursuer: Pursuer, scenario: Scenario) -> list[format.Corner]:
    """Where a pursuer flies: its way points at the planner's speed, or with its target."""
    start = pursuer.start_m if pursuer.airborne else _above(pursuer.start_m, pursuer.takeoff_m)
    sysid = None if pursuer.waypoints_m else scenario.vehicles.target_of(pursuer)
    if sysid is None:
        return _corners([start, *pursuer.waypoints_m], scenario.planner.cruise_m_s)
    target = next(one for one in scenario.vehicles.targets if one.sysid == sysid)
    laps = [*target.path_m, *([target.path_m[0]] if target.closed and target.path_m else [])]
    places = [
        target.path_m[0] if target.path_m else target.start_m,
        *(laps[1:] * (target.laps if target.closed else 1)),
    ]
    return _corners([_above(place, scenario.formation.height_m) for place in places], target.speed_m_s)


def _corners(places: Sequence[format.Vec3], speed_m_s: float) -> list[format.Corner]:
    corners: list[format.Corner] = [(0.0, *places[0])]
    for before, place in pairwise(places):
        way_m = elementary.distance(before, place)
        if way_m > 0.0:
            corners.append((corners[-1][0] + way_m / max(speed_m_s, SLOWEST_M_S), *place))
    return corners


def document_of(instance: format.Instance) -> dict[str, Any]:
    """A scenario file's content that flies an instance in lockstep; all that tells vehicles apart is kept.

    Where there are bases, vehicles start on the ground below, as they land there. Starts that are nearer to each other
    than vehicles keep apart are moved north. Raises FormatError where there is no vehicle, and for receivers that are
    lost at different shares of their capacity: a scenario has one.
    """
    if not instance.receivers and not instance.tankers:
        raise format.FormatError(f"{instance.name} has no receiver and no tanker; a session needs a vehicle")
    lands_at = [one.lands_at_j / one.capacity_j for one in instance.receivers]
    if lands_at and max(lands_at) - min(lands_at) > ALIKE:
        raise format.FormatError(
            f"{instance.name}: receivers are lost at {100.0 * min(lands_at):.1f} to {100.0 * max(lands_at):.1f} % of "
            "their capacity; a scenario has one share for all (refuelling.lands_at)"
        )
    legs = [
        (b[0] - a[0], elementary.distance(a[1:], b[1:])) for one in instance.receivers for a, b in pairwise(one.path)
    ]
    cruise_m_s = max((way_m / s for s, way_m in legs if s > 0.0), default=1.0)
    places = [*(one.path[0][1:] for one in instance.receivers), *(one.position_m for one in instance.tankers)]
    starts = _apart(_start(place, instance) for place in places)
    pursuers = [
        {
            "sysid": one.id, **next(starts),
            "waypoints_m": [list(corner[1:]) for corner in one.path[1:]] or [list(one.path[0][1:])],
            "battery": _battery(one.capacity_j, one.energy_j, one.power_w),
        }
        for one in instance.receivers
    ]  # fmt: skip
    tankers = [
        {
            "sysid": one.id, **next(starts), "home_m": list(one.position_m),
            "speed_m_s": one.speed_m_s, "reserve_j": one.reserve_j,
            "battery": _battery(one.capacity_j, one.energy_j, one.power_w),
        }
        for one in instance.tankers
    ]  # fmt: skip
    bases = [
        {
            "name": one.name, "position_m": [*one.position_m[:2], 0.0], "rate_w": one.rate_w, "stock_j": one.stock_j,
            **({"height_m": -one.position_m[2]} if one.position_m[2] < 0.0 else {}),
        }
        for one in instance.bases
    ]  # fmt: skip
    return {
        "schema": 1, "name": instance.name, "axes": "ned", "seed": instance.seed, "clock": {"mode": "lockstep"},
        "origin": {"lat_deg": 47.397742, "lon_deg": 8.545594, "alt_m": 488.0},
        "goal": {"duration_s": instance.horizon_s},
        "vehicles": {"pursuers": pursuers, "tankers": tankers},
        "vehicles_per_process": len(pursuers) + len(tankers),
        "planner": {"cruise_m_s": max(cruise_m_s, SLOWEST_M_S)},
        "competition": {"need_from": 0.0},
        "refuelling": {
            "rate_w": instance.rate_w, "hold_s": max(instance.setup_s - MEETS_S, 0.0),
            **({"lands_at": lands_at[0]} if lands_at else {}),
        },
        **({"bases": bases} if bases else {}),
    }  # fmt: skip


def _start(place: format.Vec3, instance: format.Instance) -> dict[str, Any]:
    if instance.bases and place[2] < 0.0:
        return {"start_m": [*place[:2], 0.0], "takeoff_m": -place[2]}
    return {"start_m": list(place), "airborne": True}


def _apart(starts: Iterable[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """The starts, each as far from those before it as the planner keeps vehicles."""
    least_m = PlannerRules().separation_m
    taken: list[format.Vec3] = []
    for start in starts:
        n, e, d = start["start_m"]
        while any(elementary.distance((n, e, d), other) < least_m for other in taken):
            n = round(n + least_m, 6)
        taken.append((n, e, d))
        yield {**start, "start_m": [n, e, d]}


def _battery(capacity_j: float, energy_j: float, power_w: float) -> dict[str, float]:
    return {
        "capacity_j": capacity_j, "initial_percent": min(100.0 * energy_j / capacity_j, 100.0),
        "hover_w": power_w, "avionics_w": 0.0,
    }  # fmt: skip


class Scheduled:
    """A refuelling policy that carries out a schedule's services in flight, each tanker its own in their order.

    A tanker is sent when its way takes as long as is left until a service is to begin. How much a receiver gets is the
    scenario's matter (`refuelling.until`, `limit_j`). Services of bases are not ordered by it.
    """

    def __init__(self, schedule: format.Schedule) -> None:
        self._left: dict[int, list[format.ScheduledService]] = {}
        for one in sorted(schedule.services, key=lambda one: one.start_s):
            if one.tanker is not None and one.receiver is not None:
                self._left.setdefault(one.tanker, []).append(one)

    def choose(self, request: RefuellingRequest) -> int | None:
        """The receiver of one tanker."""
        return self.assign(request).get(request.tanker.sysid)

    def assign(self, request: RefuellingRequest) -> dict[int, int]:
        """Receivers by tanker."""
        views: dict[int, VehicleView] = {view.sysid: view for view in request.candidates}
        found: dict[int, int] = {}
        for tanker in _by_id(request.free_tankers):
            waiting = self._left.get(tanker.sysid, [])
            while waiting and waiting[0].end_s < request.time_s:
                waiting.pop(0)
            receiver = waiting[0].receiver if waiting else None
            if receiver is None or receiver not in views or receiver in found.values():
                continue
            giver = next((one for one in request.givers if one.name == tanker.sysid), None)
            way_s = 0.0 if giver is None else giver.way_s(views[receiver])
            if request.time_s + way_s + EARLY_S >= waiting[0].start_s or math.isinf(way_s):
                waiting.pop(0)
                found[tanker.sysid] = receiver
        return found


def _by_id(views: Iterable[VehicleView]) -> list[VehicleView]:
    return sorted(views, key=lambda view: view.sysid)
