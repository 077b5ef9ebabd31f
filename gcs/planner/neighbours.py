"""Neighbour lists: what can repel whom within a period.

Only what cannot come into range is left out, so a sum over a leader's neighbours, in their order, is bit for bit the
sum over everything. Looked at is what lies in reach from south to north.
"""

import functools

import numpy as np
from numpy.typing import NDArray

from gcs.kernels import kernel
from gcs.scenario.geometry import BOX, CYLINDER, DOWN, KIND, NORTH, SIZE_1, SIZE_2, SIZE_3, FloatArray

IntArray = NDArray[np.int64]

FEW = 2_000
"""Up to so many pairs, having all of them costs less than choosing."""
_ROUNDING_M = 1e-6
_ROOM = 256


@functools.lru_cache(maxsize=64)
def everyone(n: int, m: int) -> tuple[IntArray, IntArray]:
    """The list in which each of n leaders has all m shapes: rows, and where each leader's begin and end (n, 2); only to
    be read."""
    return np.arange(m), np.tile(np.array([0, m]), (n, 1))


def within_range(
    q_ned: FloatArray, reach_m: FloatArray, table: FloatArray, ranges_m: FloatArray | float
) -> tuple[IntArray, IntArray]:
    """For each leader at q_ned (n, 3), all shapes whose range it can come into when it moves by reach_m (n,) at most.

    table: (m, COLUMNS), ranges_m: (m,), or one for all, m from the surface. Returns rows (k,), ascending for each
    leader, and where each leader's begin and end (n, 2), in rows.
    """
    n, m = len(q_ned), len(table)
    if n * m <= FEW:
        return everyone(n, m)
    around_m = _extent_m(table) + ranges_m + _ROUNDING_M
    spans = np.empty((n, 2), dtype=np.int64)
    rows = _within(q_ned, reach_m, np.ascontiguousarray(table[:, NORTH : DOWN + 1]), around_m, spans)
    return rows, spans


@kernel()
def _within(
    q_ned: FloatArray, reach_m: FloatArray, centre_ned: FloatArray, around_m: FloatArray, spans: IntArray
) -> IntArray:
    order = np.argsort(centre_ned[:, 0])
    centre, around = centre_ned[order], around_m[order]
    south, widest_m = centre[:, 0].copy(), around_m.max()
    rows = np.empty(_ROOM, dtype=np.int64)
    count = 0
    for i in range(len(q_ned)):
        first = np.searchsorted(south, q_ned[i, 0] - reach_m[i] - widest_m)
        last = np.searchsorted(south, q_ned[i, 0] + reach_m[i] + widest_m, side="right")
        if count + last - first > len(rows):
            longer = np.empty(2 * (count + last - first), dtype=np.int64)
            longer[:count] = rows[:count]
            rows = longer
        begin = count
        for k in range(first, last):
            n, e, d = q_ned[i, 0] - centre[k, 0], q_ned[i, 1] - centre[k, 1], q_ned[i, 2] - centre[k, 2]
            if n * n + e * e + d * d <= (reach_m[i] + around[k]) ** 2:
                j, at = order[k], count
                while at > begin and rows[at - 1] > j:
                    rows[at] = rows[at - 1]
                    at -= 1
                rows[at] = j
                count += 1
        spans[i, 0], spans[i, 1] = begin, count
    return rows[:count].copy()


def _extent_m(table: FloatArray) -> FloatArray:
    """Reach of each shape from its centre (m,), m."""
    kind = table[:, KIND]
    box = np.linalg.norm(table[:, SIZE_1 : SIZE_3 + 1], axis=1)
    cylinder = np.hypot(table[:, SIZE_1], table[:, SIZE_2])
    return np.where(kind == BOX, box, np.where(kind == CYLINDER, cylinder, table[:, SIZE_1]))
