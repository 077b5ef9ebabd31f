"""Neighbour lists from a k-d tree of what can repel whom within a period: N log N per tick, not N².

Only what cannot come into range is left out, so a sum over a leader's neighbours, in their order, is bit for bit the
sum over everything.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from gcs.scenario.geometry import BOX, CYLINDER, DOWN, KIND, NORTH, SIZE_1, SIZE_2, SIZE_3, FloatArray

IntArray = NDArray[np.int64]

FEW = 2_000
"""Up to so many pairs, looking at each costs less than a tree."""
_ROUNDING_M = 1e-6


def everyone(n: int, m: int) -> tuple[IntArray, IntArray, IntArray]:
    """The list in which each of n leaders has all m shapes: rows, and where each leader's begin and end."""
    return np.arange(m), np.zeros(n, dtype=np.int64), np.full(n, m, dtype=np.int64)


def within_range(
    q_ned: FloatArray, reach_m: FloatArray, table: FloatArray, ranges_m: FloatArray
) -> tuple[IntArray, IntArray, IntArray]:
    """For each leader at q_ned (n, 3), all shapes whose range it can come into when it moves by reach_m (n,) at most.

    table: (m, COLUMNS), ranges_m: (m,), m from the surface. Returns rows (k,), ascending for each leader, and where
    each leader's begin and end (n,), in rows.
    """
    n, m = len(q_ned), len(table)
    if n * m <= FEW:
        return everyone(n, m)
    around_m = _extent_m(table) + ranges_m
    near = cKDTree(table[:, NORTH : DOWN + 1]).query_ball_point(
        q_ned, reach_m + (around_m.max() + _ROUNDING_M), return_sorted=True
    )
    end = np.cumsum([len(rows) for rows in near])
    rows = np.fromiter((row for rows in near for row in rows), dtype=np.int64, count=int(end[-1]))
    return rows, np.concatenate(([0], end[:-1])), end


def _extent_m(table: FloatArray) -> FloatArray:
    """Reach of each shape from its centre (m,), m."""
    kind = table[:, KIND]
    box = np.linalg.norm(table[:, SIZE_1 : SIZE_3 + 1], axis=1)
    cylinder = np.hypot(table[:, SIZE_1], table[:, SIZE_2])
    return np.where(kind == BOX, box, np.where(kind == CYLINDER, cylinder, table[:, SIZE_1]))
