"""Limits of leaders: the floor; the leash that lets them wait for their vehicles; the way that they need to stop.

The last two seldom limit. Sums of squares tell of whom that is sure; for all others the very formula is computed,
vehicle by vehicle, since `math.dist` and `math.hypot` round otherwise than the root of a sum.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from gcs.kernels import kernel
from gcs.planner.leader import LeaderRows
from gcs.planner.neighbours import IntArray
from gcs.scenario.geometry import FloatArray

FLOOR_M = 0.3
"""No leader of a vehicle that has a ground goes lower than this above it: only landing does."""
GROUND_ROUNDING_M = 0.1
"""Difference of a home from height 0 that the wire's rounding alone can cause."""
_SURE = 1.0 - 1e-9


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
        self._asked = np.empty(n, dtype=np.int64)

    def apply(self, leaders: LeaderRows, rows: IntArray, here_ned: FloatArray, route_m: FloatArray) -> None:
        """Lower `leaders.speed_m_s` of these rows (k,), whose vehicles are at here_ned (n, 3). route_m (n,): way that
        is left on a route, NaN where the way is straight."""
        brakes = math.inf if self._brake_m_s2 is None else self._brake_m_s2
        count = _limited(
            rows, leaders.q_ned, here_ned, leaders.goal_ned, leaders.speed_m_s, route_m, self._leash_m,
            self._lookahead_s, brakes, self._asked,
        )  # fmt: skip
        if not count:
            return
        some = self._asked[:count]
        columns = (leaders.q_ned, here_ned, leaders.goal_ned, leaders.goal_v_ned, leaders.speed_m_s, route_m)
        leaders.speed_m_s[some] = [
            self._limit(*of_one) for of_one in zip(*(column[some].tolist() for column in columns), strict=True)
        ]

    def _limit(
        self, q: list[float], here: list[float], goal: list[float], goal_v: list[float], speed: float, route_m: float
    ) -> float:
        """Leashed; and where leaders brake, no faster than they can still stop."""
        slack_m = self._leash_m + self._lookahead_s * speed
        leashed = speed * min(max(2.0 * (1.0 - math.dist(q, here) / slack_m), 0.0), 1.0)
        if self._brake_m_s2 is None:
            return leashed
        way_m = math.dist(q, goal) if math.isnan(route_m) else route_m
        if math.isinf(way_m):
            return 0.0
        return min(leashed, math.hypot(*goal_v) + math.sqrt(2.0 * self._brake_m_s2 * way_m))


@kernel()
def _limited(
    rows: IntArray, q: FloatArray, here: FloatArray, goal: FloatArray, speed: FloatArray, route: FloatArray,
    leash: float, lookahead: float, brake: float, asked: IntArray,
) -> int:  # fmt: skip
    """Kernel: writes into `asked` the rows that are not surely within both limits; how many."""
    count = 0
    for row in rows:
        n, e, d = q[row, 0] - here[row, 0], q[row, 1] - here[row, 1], q[row, 2] - here[row, 2]
        half = 0.5 * (leash + lookahead * speed[row])
        free = n * n + e * e + d * d <= _SURE * half * half
        if free and brake < math.inf:
            way = route[row]
            if math.isnan(way):
                n, e, d = q[row, 0] - goal[row, 0], q[row, 1] - goal[row, 1], q[row, 2] - goal[row, 2]
                way = math.sqrt(n * n + e * e + d * d)
            free = way < math.inf and speed[row] * speed[row] <= _SURE * 2.0 * brake * way
        if not free:
            asked[count] = row
            count += 1
    return count
