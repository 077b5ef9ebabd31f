"""Neighbour lists: which vehicles and obstacles can repel a vehicle within a period.

Only what cannot come into range is left out, so a sum over a leader's neighbours, in their order, is bit for bit the
sum over everything. Looked at is what lies in reach from south to north.
"""

import functools

import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.skytender.geometry import BOX, CYLINDER, shape_at
from numpy.typing import NDArray

from skytender.geometry import NORTH, FloatArray

IntArray = NDArray[np.int64]

FEW = 2_000
"""Up to so many pairs, having all of them costs less than choosing."""
_ROUNDING_M = 1e-6


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
    q, reach = np.ascontiguousarray(q_ned), np.ascontiguousarray(reach_m)
    order = table[:, NORTH].argsort(kind="stable")
    spheres, spans = np.empty((m, 4)), np.empty((n, 2), np.int64)
    spheres[:, 3] = ranges_m if isinstance(ranges_m, float) else ranges_m[order]
    rows = np.empty(_look(q, reach, table, order, spheres, spans), np.int64)
    return rows[: _choose(q, reach, order, spheres, spans, rows)].copy(), spans


def _look(
    q_ned: FloatArray, reach_m: FloatArray, table: FloatArray, order: IntArray, spheres: FloatArray, spans: IntArray
) -> int:
    """Fill spheres (m, 4), centres and radii in an order from south to north, and spans (n, 2): which of them lie in
    reach of each leader from south to north. How many those are in all.

    Radii are ranges at first, to which the reach of each shape from its centre is added.
    """
    widest_m = 0.0
    for k in range(order.shape[0]):
        shape = shape_at(table, order[k])
        extent = shape.size_1
        if shape.kind == BOX:
            extent = math.sqrt(shape.size_1 * shape.size_1 + shape.size_2 * shape.size_2 + shape.size_3 * shape.size_3)
        elif shape.kind == CYLINDER:
            extent = elementary.hypot(shape.size_1, shape.size_2)
        spheres[k, 0], spheres[k, 1], spheres[k, 2] = shape.north, shape.east, shape.down
        spheres[k, 3] = extent + spheres[k, 3] + _ROUNDING_M
        widest_m = max(widest_m, spheres[k, 3])
    count = 0
    for i in range(q_ned.shape[0]):
        spans[i, 0] = _place(spheres, q_ned[i, 0] - reach_m[i] - widest_m, False)
        spans[i, 1] = _place(spheres, q_ned[i, 0] + reach_m[i] + widest_m, True)
        count += spans[i, 1] - spans[i, 0]
    return count


def _place(spheres: FloatArray, north: float, beyond: bool) -> int:
    """How many spheres are south of a north, or not north of it."""
    low, high = 0, spheres.shape[0]
    while low < high:
        middle = (low + high) // 2
        if spheres[middle, 0] < north or (beyond and spheres[middle, 0] == north):
            low = middle + 1
        else:
            high = middle
    return low


def _choose(
    q_ned: FloatArray, reach_m: FloatArray, order: IntArray, spheres: FloatArray, spans: IntArray, rows: IntArray
) -> int:
    """Fill `rows`, and `spans` with where those of each leader begin and end; how many rows there are."""
    count = 0
    for i in range(q_ned.shape[0]):
        begin = count
        for k in range(spans[i, 0], spans[i, 1]):
            n, e, d = q_ned[i, 0] - spheres[k, 0], q_ned[i, 1] - spheres[k, 1], q_ned[i, 2] - spheres[k, 2]
            if n * n + e * e + d * d <= (reach_m[i] + spheres[k, 3]) ** 2:
                j, at = order[k], count
                while at > begin and rows[at - 1] > j:
                    rows[at] = rows[at - 1]
                    at -= 1
                rows[at] = j
                count += 1
        spans[i, 0], spans[i, 1] = begin, count
    return count
