"""Least distances so far: between vehicles, to traffic, obstacles and ground; and way points passed.

Fed tick by tick, alike with what vehicles report and with what they themselves knew (gcs/supervisor/goal_watch.py).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from gcs.scenario import geometry, goal
from gcs.scenario.goal import Nearest
from gcs.scenario.model import Scenario
from gcs.telemetry import approach
from gcs.telemetry.approach import Flags, Floats, Ints

GROUND_M = 0.05
"""A vehicle in flight that is no higher than this above its ground touches it."""
MOST_REPORTED = 20
"""Breaches of one part that are reported one by one; of further ones only the least distance is kept."""


@dataclass(frozen=True, eq=False)
class Airspace:
    """Of which vehicles what counts at a tick; rows in order of system id."""

    flying: Flags
    ours: Flags
    """flown by us: only then their clearance counts (docs/protocol.md#goal)"""
    up: Flags
    """who must not touch the ground"""
    exempt: Ints
    """(k, 2) rows of pairs that may come near each other"""

    def same(self, other: Airspace) -> bool:
        """Whether both say the same."""
        pairs = ((self.flying, other.flying), (self.ours, other.ours), (self.up, other.up), (self.exempt, other.exempt))
        return all(np.array_equal(a, b) for a, b in pairs)


@dataclass(frozen=True)
class Breach:
    """A part of the goal that has just been broken, and by what."""

    part: str
    nearest: Nearest


@dataclass(frozen=True, eq=False)
class Places:
    """Positions of everything at a tick, common NED frame, m: (n, 3) and NaN where unknown."""

    p_ned: Floats
    height_m: Floats
    """(n,) above each vehicle's own ground"""
    v_ned: Floats = field(default_factory=lambda: approach.STRAIGHT)
    """m/s; (0, 3) where ways between ticks are to be straight"""
    traffic: Mapping[str, tuple[float, float, float]] = field(default_factory=dict)


class Proximity:
    """The least distances so far; `update` returns what has just come too near."""

    def __init__(self, scenario: Scenario, shapes: Floats) -> None:
        self.separation, self.clearance = Nearest(), Nearest()
        self.traffic, self.ground = Nearest(), Nearest()
        self._sysids = [vehicle.sysid for vehicle in scenario.vehicles.all]
        self._shapes = shapes
        self._names = [shape.name or f"{shape.kind} {k + 1}" for k, shape in enumerate(scenario.obstacles)]
        self._draws = {mover.callsign for mover in scenario.traffic if mover.attracts}
        asked = goal.asked(scenario)
        self._separation_m = asked.get("separation", 0.0)
        self._clearance_m, self._traffic_m = asked.get("clearance", -math.inf), asked.get("traffic", 0.0)
        self._ground = "ground" in asked
        self._near: dict[str, set[tuple[object, ...]]] = {}
        self._reported: set[tuple[object, ...]] = set()
        self._count: dict[str, int] = {}
        self._found = np.empty((approach.MOST_FOUND, 4))
        self._last: tuple[float, Floats, Floats, Mapping[str, tuple[float, float, float]]] | None = None

    def update(self, t_s: float, airspace: Airspace, places: Places) -> list[Breach]:
        """Count the interval since the last tick; what has come too near in it, each pair once in a session."""
        known = airspace.flying & ~np.isnan(places.p_ned[:, 0])
        rows = np.flatnonzero(known)
        now = places.p_ned[rows]
        period_s, before = 0.0, now
        v_before, v_now, traffic_before = approach.STRAIGHT, approach.STRAIGHT, places.traffic
        if self._last is not None:
            last_s, p_before, v_last, traffic_before = self._last
            period_s = t_s - last_s
            unknown = np.isnan(p_before[rows])
            before = np.where(unknown, now, p_before[rows])
            if len(places.v_ned) and not unknown.any():
                v_before, v_now = v_last[rows], places.v_ned[rows]
        kept = np.where(known[:, None], places.p_ned, np.nan)
        self._last = (t_s, kept, places.v_ned, places.traffic)
        breaches: list[Breach] = []
        if len(rows):
            breaches += self._between(t_s, period_s, airspace, rows, (before, now, v_before, v_now))
            ours = rows[airspace.ours[rows]]
            if len(ours):
                own = airspace.ours[rows]
                breaches += self._to_shapes(t_s, period_s, ours, before[own], now[own])
                breaches += self._to_traffic(t_s, period_s, ours, before[own], now[own], traffic_before, places.traffic)
        return breaches + self._to_ground(t_s, airspace.up, places.height_m)

    def _between(
        self, t_s: float, period_s: float, airspace: Airspace, rows: Ints, ways: tuple[Floats, Floats, Floats, Floats]
    ) -> list[Breach]:
        place = np.full(len(airspace.flying), -1, dtype=np.int64)
        place[rows] = np.arange(len(rows))
        exempt = place[airspace.exempt]
        exempt = exempt[(exempt >= 0).all(axis=1)]
        least_m, one, other, share, count = approach.nearest_pair(
            *ways, period_s, airspace.ours[rows], exempt, self._separation_m, self.separation.m, self._found
        )
        if least_m < self.separation.m:
            self.separation = self._nearest(least_m, (rows[one], rows[other]), t_s - (1.0 - share) * period_s)
        near = []
        for i, j, gap_m, at in self._found[: min(count, len(self._found))].tolist():
            pair = (int(rows[int(i)]), int(rows[int(j)]))
            near.append(self._nearest(gap_m, pair, t_s - (1.0 - at) * period_s))
        return self._new("separation", near)

    def _to_shapes(self, t_s: float, period_s: float, rows: Ints, before: Floats, now: Floats) -> list[Breach]:
        if not len(self._shapes):
            return []
        limit_m = self._clearance_m
        least, shares = approach.clearances(self._shapes, before, now, max(limit_m, min(self.clearance.m, 1e9)))
        near = []
        k = int(least.argmin())
        for i in {k, *np.flatnonzero(least < limit_m).tolist()}:
            if i == k and least[k] >= self.clearance.m and least[k] >= limit_m:
                continue
            there = before[i] + shares[i] * (now[i] - before[i])
            what = self._names[approach.nearest_shape(self._shapes, there)]
            found = self._nearest(float(least[i]), (rows[i],), t_s - (1.0 - shares[i]) * period_s, what)
            if found.m < self.clearance.m:
                self.clearance = found
            if found.m < limit_m:
                near.append(found)
        return self._new("clearance", near)

    def _to_traffic(
        self,
        t_s: float,
        period_s: float,
        rows: Ints,
        before: Floats,
        now: Floats,
        traffic_before: Mapping[str, tuple[float, float, float]],
        traffic: Mapping[str, tuple[float, float, float]],
    ) -> list[Breach]:
        names = [name for name in traffic if name not in self._draws]
        if not names:
            return []
        there = np.array([traffic[name] for name in names])
        was = np.array([traffic_before.get(name, traffic[name]) for name in names])
        least, which, shares = approach.nearest_to(before, now, was, there)
        near = []
        k = int(least.argmin())
        for i in {k, *np.flatnonzero(least < self._traffic_m).tolist()}:
            at_s = t_s - (1.0 - shares[i]) * period_s
            found = self._nearest(float(least[i]), (rows[i],), at_s, names[int(which[i])])
            if found.m < self.traffic.m:
                self.traffic = found
            if found.m < self._traffic_m:
                near.append(found)
        return self._new("traffic", near)

    def _to_ground(self, t_s: float, up: Flags, height_m: Floats) -> list[Breach]:
        if not self._ground:
            return []
        rows = np.flatnonzero(up & (height_m <= GROUND_M))
        near = [self._nearest(float(height_m[row]), (row,), t_s) for row in rows.tolist()]
        for found in near:
            if found.m < self.ground.m:
                self.ground = found
        return self._new("ground", near)

    def _nearest(self, m: float, rows: tuple[int, ...], t_s: float, what: str = "") -> Nearest:
        return Nearest(float(m), tuple(sorted(self._sysids[int(row)] for row in rows)), float(t_s), what)

    def _new(self, part: str, near: list[Nearest]) -> list[Breach]:
        """Breaches that have not been reported yet, in an order that depends on nothing else."""
        breaches = []
        for found in sorted(near, key=lambda one: (one.sysids, one.what)):
            key = (part, found.sysids, found.what)
            if key not in self._reported and self._count.get(part, 0) < MOST_REPORTED:
                self._reported.add(key)
                self._count[part] = self._count.get(part, 0) + 1
                breaches.append(Breach(part, found))
        return breaches


class WayPoints:
    """Which way points each pursuer has passed, in their order."""

    def __init__(self, scenario: Scenario) -> None:
        self._within_m = max(scenario.goal.waypoint_within_m, scenario.planner.step_m)
        rows = {vehicle.sysid: row for row, vehicle in enumerate(scenario.vehicles.all)}
        self._left = {p.sysid: list(p.waypoints_m) for p in scenario.vehicles.pursuers if p.waypoints_m}
        self._rows = {sysid: rows[sysid] for sysid in self._left}
        self._last: dict[int, Floats] = {}

    @property
    def missed(self) -> dict[int, int]:
        """Number of way points that each has not passed yet."""
        return {sysid: len(left) for sysid, left in self._left.items()}

    def update(self, flying: Flags, p_ned: Floats) -> None:
        """Count the way since the last tick, straight."""
        for sysid, left in self._left.items():
            row = self._rows[sysid]
            now = p_ned[row]
            if not flying[row] or math.isnan(now[0]):
                self._last.pop(sysid, None)
                continue
            before = self._last.get(sysid, now)
            self._last[sysid] = now
            while left:
                r, d = before - np.array(left[0]), now - before
                gap2, _ = approach.segment_gap2(*r.tolist(), *d.tolist())
                if gap2 > self._within_m**2:
                    break
                left.pop(0)


def shapes_of(scenario: Scenario) -> Floats:
    """The scenario's obstacles as a table."""
    return geometry.of_scenario(scenario.obstacles)
