"""Constraints of the safety filter that can matter within a period: whatever is too far for that is left out.

A constraint is a row (kind, vehicle, with what) and its required distance, in order of kind, vehicle and with what.
Frames NED, lengths in metres.
"""

from __future__ import annotations

import math

import numpy as np

from gcs.kernels import inner
from gcs.planner.braking_clearance import FloatArray, IntArray
from gcs.planner.safety_constraints import OBSTACLE, OTHER, PAIR, PLANE, BoolArray
from gcs.scenario.geometry import KIND, WALL, bounds

_ROOM = 256


@inner(error_model="numpy")
def constraints_within_reach(
    p: FloatArray, v: FloatArray, a_max: FloatArray, brake: FloatArray, margin: FloatArray, others: FloatArray,
    table: FloatArray, beyond: BoolArray, walls: FloatArray, pair_required: FloatArray, other_required: FloatArray,
    apart: bool, separation: float, clearance: float, dt: float, horizon: float, buffer: float,
) -> tuple[IntArray, FloatArray]:  # fmt: skip
    """Rows (k, 3) and required distances (k,) of all that n leaders can come near to (arguments as in `filter_step`).

    others (m, 8): p, v, radius, growth. walls (n, 6). pair_required, other_required: rows (i, j, m), i < j of a pair.
    """
    n = len(p)
    reach = np.empty(n)  # no way is longer: the coming period, the braking after it, and what activates below
    for i in range(n):
        speed = math.sqrt(v[i, 0] ** 2 + v[i, 1] ** 2 + v[i, 2] ** 2) + a_max[i] * dt
        reach[i] = dt * speed + speed**2 / (2.0 * brake[i]) + brake[i] * dt**2 / 8.0 + buffer
    rows, required, count = np.empty((_ROOM, 3), dtype=np.int64), np.empty(_ROOM), 0
    if apart:
        farthest = 2.0 * (reach.max() + margin.max()) + separation if n else 0.0
        for k in range(len(pair_required)):
            farthest = max(farthest, 2.0 * reach.max() + pair_required[k, 2])
        for i, j in _near_pairs(p, farthest):
            d = _of_pair(pair_required, i, j, separation + margin[i] + margin[j])
            if _distance(p, i, p, j) <= reach[i] + reach[j] + d:
                rows, required, count = _put(rows, required, count, PAIR, i, j, d)
    ahead = horizon + dt
    for i in range(n):
        for j in range(len(others)):
            d = _of_pair(other_required, i, j, others[j, 6] + margin[i])
            speed = math.sqrt(others[j, 3] ** 2 + others[j, 4] ** 2 + others[j, 5] ** 2)
            far = speed * ahead + max(others[j, 6] + margin[i], d) + others[j, 7] * ahead
            # None of 0: a distance of 0 is one that a braking leader would have to keep too.
            if d > 0.0 and _distance(p, i, others, j) <= reach[i] + far:
                rows, required, count = _put(rows, required, count, OTHER, i, j, d)
    if len(table):
        low, high, order, south, widest = _from_the_south(table)
        for i in range(n):
            d, first = clearance + margin[i], count
            begin = np.searchsorted(south, p[i, 0] - reach[i] - d - widest)
            for at in range(begin, np.searchsorted(south, p[i, 0] + reach[i] + d, side="right")):
                j = order[at]
                if _outside(p, i, low, high, j) <= reach[i] + d and not (beyond[i] and table[j, KIND] == WALL):
                    rows, required, count = _put(rows, required, count, OBSTACLE, i, j, d)
            _in_order(rows, first, count)
    for i in range(n):
        for side in range(6):
            clear = p[i, side] - walls[i, side] if side < 3 else walls[i, side] - p[i, side - 3]
            if clear <= reach[i] + margin[i]:
                rows, required, count = _put(rows, required, count, PLANE, i, side, margin[i])
    return rows[:count], required[:count]


@inner(error_model="numpy")
def _near_pairs(p: FloatArray, within: float) -> list[tuple[int, int]]:
    """Pairs i < j of places that are no farther apart, ascending; a loop of its own, since one that does more is
    compiled to a ninth of its speed."""
    pairs = [(0, 0)][:0]
    for i in range(len(p)):
        for j in range(i + 1, len(p)):
            n, e, d = p[i, 0] - p[j, 0], p[i, 1] - p[j, 1], p[i, 2] - p[j, 2]
            if n * n + e * e + d * d <= within * within:
                pairs.append((i, j))
    return pairs


@inner(error_model="numpy")
def _in_order(rows: IntArray, first: int, end: int) -> None:
    """Sort the last column of a few rows in place."""
    for k in range(first + 1, end):
        j, at = rows[k, 2], k
        while at > first and rows[at - 1, 2] > j:
            rows[at, 2] = rows[at - 1, 2]
            at -= 1
        rows[at, 2] = j


@inner(error_model="numpy")
def _put(
    rows: IntArray, required: FloatArray, count: int, kind: int, i: int, j: int, d: float
) -> tuple[IntArray, FloatArray, int]:
    if count == len(rows):
        longer, more = np.empty((2 * count, 3), dtype=np.int64), np.empty(2 * count)
        longer[:count], more[:count] = rows, required
        rows, required = longer, more
    rows[count, 0], rows[count, 1], rows[count, 2], required[count] = kind, i, j, d
    return rows, required, count + 1


@inner(error_model="numpy")
def _of_pair(given: FloatArray, i: int, j: int, usual: float) -> float:
    """Distance required of a pair, where one is given for it: the last one."""
    for k in range(len(given) - 1, -1, -1):
        if given[k, 0] == i and given[k, 1] == j:
            return float(given[k, 2])
    return usual


@inner(error_model="numpy")
def _distance(a: FloatArray, i: int, b: FloatArray, j: int) -> float:
    return math.sqrt((a[i, 0] - b[j, 0]) ** 2 + (a[i, 1] - b[j, 1]) ** 2 + (a[i, 2] - b[j, 2]) ** 2)


@inner(error_model="numpy")
def _outside(p: FloatArray, i: int, low: FloatArray, high: FloatArray, j: int) -> float:
    """Distance of a place from a box, 0 in it."""
    square = 0.0
    for axis in range(3):
        square += max(low[j, axis] - p[i, axis], p[i, axis] - high[j, axis], 0.0) ** 2
    return math.sqrt(square)


@inner(error_model="numpy")
def _from_the_south(table: FloatArray) -> tuple[FloatArray, FloatArray, IntArray, FloatArray, float]:
    """Bounding boxes (m, 3), (m, 3), their order by their south sides, those in this order, and the widest one."""
    low, high = bounds(table)
    order = np.argsort(low[:, 0])
    return low, high, order, low[order, 0], (high[:, 0] - low[:, 0]).max()
