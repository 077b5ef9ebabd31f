"""Least distances so far: between vehicles, to traffic, obstacles and ground; vehicles too near now; way points passed.

Fed tick by tick, alike with what vehicles report and with what they themselves knew (gcs/supervisor/goal_watch.py).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from gcs.mavlink.autopilots import FlightMode
from gcs.scenario import goal
from gcs.scenario.goal import Nearest
from gcs.scenario.model import Scenario
from gcs.telemetry import approach
from gcs.telemetry.approach import Flags, Floats, Ints
from gcs.telemetry.state import FleetSnapshot, Vec3
from skytender import elementary, geometry

GROUND_M = 0.05
"""A vehicle in flight that is no higher than this above its ground touches it."""
MOST_REPORTED = 20
"""Breaches of one part that are reported one by one; of further ones only the least distance is kept."""


PRESENT = ("separation", "clearance")
"""Parts whose breaches last: vehicles that broke them are measured again while they fly."""


@dataclass(frozen=True, eq=False)
class Airspace:
    """Of which vehicles what counts at a tick; rows in order of system id."""

    flying: Flags
    ours: Flags
    """flown by us: only then their clearance counts (docs/protocol/result.md#goal)"""
    up: Flags
    """vehicles that must not touch the ground"""
    exempt: Ints
    """(k, 2) rows of pairs that may come near each other"""
    by_failsafe: Flags
    """flown by their failsafes: they pass no way points"""


@dataclass(frozen=True)
class Breach:
    """A part of the goal that has just been broken, and by what."""

    part: str
    nearest: Nearest


class Places(NamedTuple):
    """Positions of everything at a tick, common NED frame, m: (n, 3) and NaN where unknown."""

    p_ned: Floats
    height_m: Floats
    """(n,) above each vehicle's own ground"""
    traffic: Mapping[str, Vec3]
    v_ned: Floats = approach.STRAIGHT
    """m/s, NaN where unknown; (0, 3) where all ways between ticks are to be straight"""


class Proximity:
    """The least distances so far; `update` returns what has just come too near."""

    def __init__(self, scenario: Scenario, shapes: Floats) -> None:
        self.separation, self.clearance = Nearest(), Nearest()
        self.traffic, self.ground = Nearest(), Nearest()
        self._sysids = [vehicle.sysid for vehicle in scenario.vehicles.all]
        self._draws = {mover.callsign for mover in scenario.traffic if mover.attracts}
        asked = goal.asked(scenario)
        self._separation_m, self._traffic_m = asked.get("separation", 0.0), asked.get("traffic", 0.0)
        self._ground = "ground" in asked
        self._reported: set[tuple[object, ...]] = set()
        count = len(self._sysids)
        self._found = np.empty((approach.MOST_FOUND, 4))
        self._of_last = np.zeros((2, count, 3))
        self._of_last[0] = np.nan
        ways = self._ways = np.empty((count, approach.WAY))
        self._before, self._clear_m, self._clear_at = ways[:, :3], ways[:, approach.CLEAR_M], ways[:, approach.CLEAR_AT]
        self._clear_place, self._v_began, self._v_ended = (
            ways[:, at : at + 3] for at in (approach.CLEAR_PLACE, approach.V_BEGAN, approach.V_ENDED)
        )
        self.surround(scenario, shapes)
        self._last: tuple[float, Mapping[str, Vec3]] | None = None
        """time, and places of the traffic"""

    def surround(self, scenario: Scenario, shapes: Floats) -> None:
        """Let a scenario's obstacles, of which `shapes` is the table, be there from now on."""
        self._shapes = shapes
        self._names = [shape.name or f"{shape.kind} {k + 1}" for k, shape in enumerate(scenario.obstacles)]
        self._clearance_m = goal.asked(scenario).get("clearance", -math.inf)
        self._watch = approach.FleetWatch(self._of_last, shapes, self._ways, self._found)

    def update(self, t_s: float, airspace: Airspace, places: Places) -> list[Breach]:
        """Count the interval since the last tick; what has come too near in it, each pair once in a session."""
        period_s, traffic_before = 0.0, places.traffic
        if self._last is not None:
            period_s, traffic_before = t_s - self._last[0], self._last[1]
        self._last = (t_s, places.traffic)
        limit_m = self._clearance_m
        count, least_m, one, other, share, near, clearest = self._watch.look(
            places.p_ned,
            places.v_ned,
            period_s,
            airspace.flying,
            airspace.ours,
            airspace.exempt,
            self._separation_m,
            self.separation.m,
            limit_m,
            self.clearance.m,
        )
        breaches: list[Breach] = []
        if least_m < self.separation.m:
            self.separation = self._nearest(least_m, (one, other), t_s - (1.0 - share) * period_s)
        if near:
            breaches += self._between(t_s, period_s, near)
        if clearest >= 0:
            breaches += self._to_shapes(t_s, period_s, clearest)
        if count and places.traffic:
            breaches += self._to_traffic(t_s, period_s, airspace, places, traffic_before)
        if self._ground:
            breaches += self._to_ground(t_s, airspace.up, places.height_m)
        return breaches

    def _between(self, t_s: float, period_s: float, count: int) -> list[Breach]:
        near = []
        for i, j, gap_m, at in self._found[: min(count, len(self._found))].tolist():
            near.append(self._nearest(gap_m, (int(i), int(j)), t_s - (1.0 - at) * period_s))
        return self._new("separation", near)

    def _to_shapes(self, t_s: float, period_s: float, nearest: int) -> list[Breach]:
        near = []
        for row in {nearest, *np.flatnonzero(self._clear_m < self._clearance_m).tolist()}:
            what = self._names[approach.nearest_shape(self._shapes, self._clear_place[row])]
            at_s = t_s - (1.0 - self._clear_at[row]) * period_s
            near.append(self._nearest(self._clear_m[row], (row,), at_s, what))
        self.clearance = _least(self.clearance, near)
        return self._new("clearance", [found for found in near if found.m < self._clearance_m])

    def _to_traffic(
        self, t_s: float, period_s: float, airspace: Airspace, places: Places, traffic_before: Mapping[str, Vec3]
    ) -> list[Breach]:
        traffic = places.traffic
        names = [name for name in traffic if name not in self._draws]
        rows = np.flatnonzero(airspace.flying & airspace.ours & ~np.isnan(places.p_ned[:, 0]))
        if not names or not len(rows):
            return []
        there = np.array([traffic[name] for name in names])
        was = np.array([traffic_before.get(name, traffic[name]) for name in names])
        curve = (self._v_began[rows], self._v_ended[rows]) if len(places.v_ned) else (approach.STRAIGHT,) * 2
        least, which, shares = approach.nearest_to(self._before[rows], places.p_ned[rows], *curve, was, there, period_s)
        near = []
        k = int(least.argmin())
        for i in {k, *np.flatnonzero(least < self._traffic_m).tolist()}:
            at_s = t_s - (1.0 - shares[i]) * period_s
            near.append(self._nearest(float(least[i]), (rows[i],), at_s, names[int(which[i])]))
        self.traffic = _least(self.traffic, near)
        return self._new("traffic", [found for found in near if found.m < self._traffic_m])

    def _to_ground(self, t_s: float, up: Flags, height_m: Floats) -> list[Breach]:
        rows = np.flatnonzero(up & (height_m <= GROUND_M))
        if not len(rows):
            return []
        near = [self._nearest(float(height_m[row]), (row,), t_s) for row in rows.tolist()]
        self.ground = _least(self.ground, near)
        return self._new("ground", near)

    def _nearest(self, m: float, rows: tuple[int, ...], t_s: float, what: str = "") -> Nearest:
        return Nearest(float(m), tuple(sorted(self._sysids[int(row)] for row in rows)), float(t_s), what)

    def _new(self, part: str, near: list[Nearest]) -> list[Breach]:
        """Breaches that have not been reported yet, in an order that depends on nothing else."""
        breaches = []
        for found in sorted(near, key=lambda one: (one.sysids, one.what)):
            key = (part, found.sysids, found.what)
            if key not in self._reported and sum(one[0] == part for one in self._reported) < MOST_REPORTED:
                self._reported.add(key)
                breaches.append(Breach(part, found))
        return breaches


def too_near(breaches: Iterable[Mapping[str, Any]], snapshot: FleetSnapshot, scenario: Scenario) -> dict[int, str]:
    """Vehicles that are now nearer than the goal wants to what they have been too near to, and how near, in words.

    `breaches`: violations of the parts in PRESENT, as decisions hold them. In a transfer two may be near each other.
    """
    shapes = {shape.name or f"{shape.kind} {k + 1}": shape for k, shape in enumerate(scenario.obstacles)}
    found: dict[int, str] = {}
    for breach in breaches:
        views, limit_m = [snapshot.vehicle(sysid) for sysid in breach["sysids"]], breach["limit"]
        if not all(view.flying and view.fresh and view.mode is not FlightMode.REFUEL for view in views):
            continue
        places = [view.p_now_ned() for view in views]
        if breach["part"] == "separation":
            near_m = elementary.distance(*places)
            others = [view.label for view in reversed(views)]
        else:
            shape = shapes.get(breach["what"])
            near_m = math.inf if shape is None else float(geometry.clearance(geometry.of_scenario([shape]), places)[0])
            others = [breach["what"]]
        if near_m < limit_m:
            words = [f"{goal.metres(near_m, limit_m)} from {other}" for other in others]
            found.update(zip(breach["sysids"], words, strict=True))
    return found


def _least(so_far: Nearest, found: list[Nearest]) -> Nearest:
    return min((so_far, *found), key=lambda one: one.m)


class WayPoints:
    """Which way points each pursuer has passed, in their order."""

    def __init__(self, scenario: Scenario) -> None:
        vehicles = scenario.vehicles
        of_each = {p.sysid: p.waypoints_m for p in vehicles.pursuers if p.waypoints_m}
        ways = [of_each.get(vehicle.sysid, ()) for vehicle in vehicles.all]
        self._within_m = max(scenario.goal.waypoint_within_m, scenario.planner.step_m)
        self._points = np.array([point for way in ways for point in way], np.float64).reshape(-1, 3)
        counts = np.array([len(way) for way in ways], np.int64)
        self._end: Ints = np.cumsum(counts)
        self._next: Ints = self._end - counts
        self._rows = {vehicle.sysid: row for row, vehicle in enumerate(vehicles.all) if vehicle.sysid in of_each}
        self._last = np.full((len(ways), 3), np.nan)
        self._left = len(self._points) > 0

    @property
    def missed(self) -> dict[int, int]:
        """Number of way points that each has not passed yet."""
        left = (self._end - self._next).tolist()
        return {sysid: left[row] for sysid, row in self._rows.items()}

    def update(self, p_ned: Floats, by_failsafe: Flags) -> None:
        """Count the way since the last tick, straight; p_ned: (n, 3) of each vehicle, NaN where it is unknown or does
        not fly. What is flown `by_failsafe` (n,) does not count, nor the straight line to where that ends."""
        if self._left:
            left_out, within2 = by_failsafe.view(np.uint8), self._within_m * self._within_m
            rows = self._points, self._next, self._end
            self._left = approach.pass_points(p_ned, self._last, left_out, *rows, within2) > 0
