"""Neighbour lists: what can repel whom within a period.

Only what cannot come into range is left out, so a sum over a leader's neighbours, in their order, is bit for bit the
sum over everything. All pairs are looked at, compiled: 254 vehicles are 32 000 pairs and 0.1 ms.
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


@functools.lru_cache(maxsize=64)
def everyone(n: int, m: int) -> tuple[IntArray, IntArray, IntArray]:
    """The list in which each of n leaders has all m shapes: rows, and where each leader's begin and end; only to be
    read."""
    return np.arange(m), np.zeros(n, dtype=np.int64), np.full(n, m, dtype=np.int64)


def within_range(
    q_ned: FloatArray, reach_m: FloatArray, table: FloatArray, ranges_m: FloatArray | float
) -> tuple[IntArray, IntArray, IntArray]:
    """For each leader at q_ned (n, 3), all shapes whose range it can come into when it moves by reach_m (n,) at most.

    table: (m, COLUMNS), ranges_m: (m,), or one for all, m from the surface. Returns rows (k,), ascending for each
    leader, and where each leader's begin and end (n,), in rows.
    """
    n, m = len(q_ned), len(table)
    if n * m <= FEW:
        return everyone(n, m)
    around_m = _extent_m(table) + ranges_m + _ROUNDING_M
    end = np.empty(n, dtype=np.int64)
    rows = _within(q_ned, reach_m, np.ascontiguousarray(table[:, NORTH : DOWN + 1]), around_m, end)
    return rows, np.concatenate(([0], end[:-1])), end


@kernel()
def _within(
    q_ned: FloatArray, reach_m: FloatArray, centre_ned: FloatArray, around_m: FloatArray, end: IntArray
) -> IntArray:
    rows = [0][:0]
    for i in range(len(q_ned)):
        for j in range(len(centre_ned)):
            n, e, d = q_ned[i, 0] - centre_ned[j, 0], q_ned[i, 1] - centre_ned[j, 1], q_ned[i, 2] - centre_ned[j, 2]
            if n * n + e * e + d * d <= (reach_m[i] + around_m[j]) ** 2:
                rows.append(j)
        end[i] = len(rows)
    return np.array(rows, dtype=np.int64)


def _extent_m(table: FloatArray) -> FloatArray:
    """Reach of each shape from its centre (m,), m."""
    kind = table[:, KIND]
    box = np.linalg.norm(table[:, SIZE_1 : SIZE_3 + 1], axis=1)
    cylinder = np.hypot(table[:, SIZE_1], table[:, SIZE_2])
    return np.where(kind == BOX, box, np.where(kind == CYLINDER, cylinder, table[:, SIZE_1]))
