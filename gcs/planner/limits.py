"""Limits of leaders: the floor; the leash that lets them wait for their vehicles; the way that they need to stop.

The last two seldom limit. Sums of squares tell of whom that is sure; for all others the very formula is computed,
vehicle by vehicle, since `distance` and `norm` round otherwise than the root of a sum.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from gcs.planner.leader import LeaderLimits, LeaderRows
from gcs.scenario.geometry import FloatArray
from skytender import elementary

FLOOR_M = 0.3
"""No leader of a vehicle that has a ground goes lower than this above it: only landing does."""
GROUND_ROUNDING_M = 0.1
"""Difference of a home from height 0 that the wire's rounding alone can cause."""


class Floors:
    """Greatest downs of leaders: above the scenario's height 0 and above the vehicles' own grounds, by their homes."""

    def __init__(self, rows: Iterable[int]) -> None:
        """rows: of vehicles that have a ground."""
        self.rows = np.array(sorted(rows), np.int64)
        self._ground = b""
        self._lowest_d = np.zeros(0)

    def at(self, ground_down_m: FloatArray) -> FloatArray:
        """(n,) m, for homes so far down (n,), NaN where that is unknown; infinite without a ground. Only to be read."""
        ground = ground_down_m.tobytes()
        if ground != self._ground:
            self._ground = ground
            own = ground_down_m[self.rows]
            self._lowest_d = np.full(len(ground_down_m), math.inf)
            self._lowest_d[self.rows] = -FLOOR_M + np.where(own < -GROUND_ROUNDING_M, own, 0.0)
        return self._lowest_d


class SpeedLimits:
    """Limits for n leaders; arrays have a row for each of them."""

    def __init__(self, n: int, leash_m: float, lookahead_s: float, brake_m_s2: float | None) -> None:
        """lookahead_s: by how much a vehicle is behind its leader anyhow. brake_m_s2: with which leaders brake before
        their goals; None where they need not."""
        self._leash_m, self._lookahead_s, self._brake_m_s2 = leash_m, lookahead_s, brake_m_s2
        brake = math.inf if brake_m_s2 is None else brake_m_s2
        self.sure = LeaderLimits(np.empty((2, n), np.int64), leash_m, lookahead_s, brake)
        """for `lead`"""

    def lower(self, leaders: LeaderRows, here_ned: FloatArray, asked: int, stopping: int) -> None:
        """Lower `leaders.speed_m_s` of so many whom `lead` has found; vehicles are at here_ned (n, 3)."""
        brake_m_s2, limited = self._brake_m_s2, self.sure.limited
        q, goal, goal_v, speed = leaders.q_ned, leaders.goal_ned, leaders.goal_v_ned, leaders.speed_m_s
        if stopping and brake_m_s2 is not None:
            some, twice = limited[1, :stopping], 2.0 * brake_m_s2
            columns = (goal_v[some].tolist(), q[some].tolist(), goal[some].tolist(), speed[some].tolist())
            speed[some] = [
                min(speed_m_s, elementary.norm(v) + math.sqrt(twice * elementary.distance(from_ned, to_ned)))
                for v, from_ned, to_ned, speed_m_s in zip(*columns, strict=True)
            ]
        if asked:
            some = limited[0, :asked]
            each = (column[some].tolist() for column in (q, here_ned, goal, goal_v, speed, leaders.route_m))
            speed[some] = list(map(self._limit, *each))

    def _limit(
        self, q: list[float], here: list[float], goal: list[float], goal_v: list[float], speed: float, route_m: float
    ) -> float:
        """Leashed; and where leaders brake, no faster than they can still stop."""
        slack_m = self._leash_m + self._lookahead_s * speed
        leashed = speed * min(max(2.0 * (1.0 - elementary.distance(q, here) / slack_m), 0.0), 1.0)
        if self._brake_m_s2 is None:
            return leashed
        way_m = elementary.distance(q, goal) if math.isnan(route_m) else route_m
        if math.isinf(way_m):
            return 0.0
        return min(leashed, elementary.norm(goal_v) + math.sqrt(2.0 * self._brake_m_s2 * way_m))
