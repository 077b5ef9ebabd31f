"""What a session amounts to, gathered tick by tick from snapshots: paths, pursuit, and how near things came."""

from __future__ import annotations

import itertools
import math
from collections import deque
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from gcs.fleet import Snapshot, Vec3
from gcs.planner import obstacles
from gcs.planner.plan import SetPoint
from gcs.scenario import Scenario

PLAN_MEMORY = 20
"""Set points against which a vehicle's way is held: it flies a few ticks behind its plan."""


class Metrics:
    """Running figures of one session."""

    def __init__(self, scenario: Scenario, obstacle_table: NDArray[np.float64]) -> None:
        self._obstacles = obstacle_table
        self.target_of = _targets(scenario)
        self._within_m = scenario.goal.pursue.within_m if scenario.goal.pursue else math.inf
        self._last: dict[int, Vec3] = {}
        self._plans: dict[int, deque[Vec3]] = {}
        self._held_since_s: dict[int, float] = {}
        self.held_s: dict[int, float] = dict.fromkeys(self.target_of, 0.0)
        self.path_length_m: dict[int, float] = {}
        self.max_tracking_error_m: dict[int, float] = {}
        self.min_separation_m = math.inf
        self.min_clearance_m = math.inf

    def take(self, snapshot: Snapshot, set_points: Iterable[SetPoint], partners: Iterable[tuple[int, int]]) -> None:
        """Count one tick; `partners` are pairs that may come close to each other."""
        here = {view.sysid: view.p_now_ned() for view in snapshot.vehicles if view.flying}
        self._measure_paths(here, {point.sysid: point.p_ned for point in set_points})
        self._measure_distances(snapshot, here, {frozenset(pair) for pair in partners})
        self._measure_pursuit(snapshot.time_s, here)

    @property
    def pursuit_held_s(self) -> float:
        """The longest time for which even the worst pursuer stayed with its target."""
        return min(self.held_s.values(), default=0.0)

    def _measure_paths(self, here: dict[int, Vec3], planned: dict[int, Vec3]) -> None:
        for sysid, p_ned in here.items():
            if sysid in self._last:
                self.path_length_m[sysid] = self.path_length_m.get(sysid, 0.0) + math.dist(p_ned, self._last[sysid])
        self._last = here
        for sysid in self._plans.keys() - planned.keys():
            del self._plans[sysid]
        for sysid, point in planned.items():
            plan = self._plans.setdefault(sysid, deque(maxlen=PLAN_MEMORY))
            plan.append(point)
            if sysid in here and len(plan) == PLAN_MEMORY:
                error_m = min(_distance_to_leg(here[sysid], a, b) for a, b in itertools.pairwise(plan))
                self.max_tracking_error_m[sysid] = max(self.max_tracking_error_m.get(sysid, 0.0), error_m)

    def _measure_distances(self, snapshot: Snapshot, here: dict[int, Vec3], partners: set[frozenset[int]]) -> None:
        for (a, p_a), (b, p_b) in itertools.combinations(here.items(), 2):
            if frozenset((a, b)) not in partners:
                self.min_separation_m = min(self.min_separation_m, math.dist(p_a, p_b))
        if not here:
            return
        at = np.array(list(here.values()))
        if len(self._obstacles):
            self.min_clearance_m = min(self.min_clearance_m, float(obstacles.clearance(self._obstacles, at).min()))
        for aircraft in snapshot.traffic:
            there = [p + v * aircraft.age_s for p, v in zip(aircraft.p_ned, aircraft.v_ned, strict=True)]
            nearest = float(np.linalg.norm(at - np.array(there), axis=1).min())
            self.min_clearance_m = min(self.min_clearance_m, nearest)

    def _measure_pursuit(self, now_s: float, here: dict[int, Vec3]) -> None:
        for sysid, target in self.target_of.items():
            near = sysid in here and target in here and math.dist(here[sysid], here[target]) <= self._within_m
            if not near:
                self._held_since_s.pop(sysid, None)
                continue
            since_s = self._held_since_s.setdefault(sysid, now_s)
            self.held_s[sysid] = max(self.held_s[sysid], now_s - since_s)


def _targets(scenario: Scenario) -> dict[int, int]:
    vehicles = scenario.vehicles
    return {p.sysid: target for p in vehicles.pursuers if (target := vehicles.target_of(p)) is not None}


def _distance_to_leg(p: Vec3, a: Vec3, b: Vec3) -> float:
    along = [y - x for x, y in zip(a, b, strict=True)]
    length2 = sum(c * c for c in along)
    share = 0.0
    if length2 > 0.0:
        share = min(max(sum((z - x) * c for x, z, c in zip(a, p, along, strict=True)) / length2, 0.0), 1.0)
    return math.dist(p, [x + share * c for x, c in zip(a, along, strict=True)])
