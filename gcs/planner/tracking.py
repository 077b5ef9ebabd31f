"""Tracking error and lag of each vehicle, measured against the way of its virtual leader [choice].

A vehicle flies a lag behind its leader. The lag is the age of the nearest place on the leader's way, while the leader
moves. The error is the distance from where the leader was the fleet's average lag ago: a late vehicle is as wrong as
one that is aside.
"""

from __future__ import annotations

import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.gcs.planner.tracking import KEPT
from cython.cimports.libc import math
from numpy.typing import NDArray

_MOVING_M_S = 0.5
"""Only a leader that moves faster shows a lag."""
DECAY_S = 5.0
"""An error that is not measured again counts by 1/e less after so long."""
_LAG_SHARE = 0.1
"""Of a newly measured lag in the one that is kept."""
_MOST_LAG_S = 2.5

Floats = NDArray[np.float64]
IntArray = NDArray[np.int64]


class Tracking:
    """Errors and lags of n vehicles, a row each."""

    def __init__(self, n: int, lag_s: float) -> None:
        self.now_m = np.zeros(n)
        """error in the last tick"""
        self.error_m = np.zeros(n)
        """greatest error of late"""
        self.lag_s = np.full(n, lag_s)
        self._time_s = np.zeros((n, KEPT))
        self._way = np.zeros((n, KEPT, 3))
        self._count = np.zeros(n, dtype=np.int64)

    def lead(self, rows: IntArray, time_s: float, p_ned: Floats) -> None:
        """Append a place (k, 3) of the leader of each of these rows (k,), NED m, at a session time."""
        count = self._count[rows]
        at = count % KEPT
        self._time_s[rows, at], self._way[rows, at] = time_s, p_ned
        self._count[rows] = count + 1

    def measure(self, rows: IntArray, p_ned: Floats, time_s: float, period_s: float, lag_s: float) -> None:
        """Hold places (k, 3) of the vehicles of these rows (k,), NED m, at a session time against their leaders', the
        fleet's lag before."""
        if len(rows):
            _measure(
                rows, p_ned, time_s, elementary.exp(-period_s / DECAY_S), lag_s, self._time_s, self._way, self._count,
                self.now_m, self.error_m, self.lag_s,
            )  # fmt: skip

    def restart(self, row: int) -> None:
        """Forget a leader's way: it begins anew."""
        self._count[row] = 0
        self.now_m[row] = 0.0


def _measure(
    rows: IntArray, p: Floats, time_s: float, decay: float, lag_s: float, times: Floats, way: Floats,
    count: IntArray, now: Floats, error: Floats, lag: Floats,
) -> None:  # fmt: skip
    """Write `now`, `error` and `lag` of the rows."""
    for k in range(rows.shape[0]):
        row = rows[k]
        kept = min(count[row], KEPT)
        if kept < 2:
            continue
        first = count[row] - kept
        best, at_s, apart = math.INFINITY, time_s, math.INFINITY
        then_s = time_s - lag_s
        if then_s < times[row, first % KEPT]:
            continue  # the leader is ahead of its vehicle from the first, as it will be
        for i in range(kept - 1):
            a, b = (first + i) % KEPT, (first + i + 1) % KEPT
            dn, de, dd = (
                way[row, b, 0] - way[row, a, 0],
                way[row, b, 1] - way[row, a, 1],
                way[row, b, 2] - way[row, a, 2],
            )
            xn, xe, xd = p[k, 0] - way[row, a, 0], p[k, 1] - way[row, a, 1], p[k, 2] - way[row, a, 2]
            span = times[row, b] - times[row, a]
            share = min(max((xn * dn + xe * de + xd * dd) / max(dn * dn + de * de + dd * dd, 1e-12), 0.0), 1.0)
            square = (xn - share * dn) ** 2 + (xe - share * de) ** 2 + (xd - share * dd) ** 2
            if square <= best:
                best, at_s = square, times[row, a] + share * span
            then = (then_s - times[row, a]) / span
            if (then >= 0.0 or i == 0) and (then <= 1.0 or i == kept - 2):
                then = min(max(then, 0.0), 1.0)
                apart = math.sqrt((xn - then * dn) ** 2 + (xe - then * de) ** 2 + (xd - then * dd) ** 2)
        now[row] = apart
        error[row] = max(apart, error[row] * decay)
        a, b = first % KEPT, (first + kept - 1) % KEPT
        span = times[row, b] - times[row, a]
        moves = _apart(way, row, a, b) > _MOVING_M_S * span
        a = (first + kept - 2) % KEPT
        span = times[row, b] - times[row, a]
        if moves and _apart(way, row, a, b) > _MOVING_M_S * span:  # one that stands leaves its vehicle no lag
            lag[row] += _LAG_SHARE * (min(max(time_s - at_s, 0.0), _MOST_LAG_S) - lag[row])


def _apart(way: Floats, row: int, a: int, b: int) -> float:
    """Distance in m of two places of a way."""
    dn, de, dd = way[row, b, 0] - way[row, a, 0], way[row, b, 1] - way[row, a, 1], way[row, b, 2] - way[row, a, 2]
    return math.sqrt(dn * dn + de * de + dd * dd)
