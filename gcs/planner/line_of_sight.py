"""Exact clearance of straight legs between static obstacles, over the obstacles near each leg.

The signed distance to a convex shape is a convex function along a line, with slope at most 1. So the least distance of
a leg to a point or sphere is a closed form, and to a box or cylinder it is found by golden section to 1 µm. [lineage]
Boyd, Vandenberghe, Convex Optimization, 2004, 3.2.5 (distance to a convex set is convex).

Obstacles are listed in square bins of the ground plane, each in every bin that it comes nearer to than `reach_m`. A leg
looks at the bins that it crosses, so its clearance is exact up to `reach_m` and cut off there. All lengths in metres,
frames NED. No state beyond the table, no clock.
"""

from __future__ import annotations

from typing import Any

import cython
import numpy as np
from cython.cimports.libc import math
from cython.cimports.skytender.geometry import BOX, CYLINDER, WALL, past_wall, shape_at, shape_surface
from numpy.typing import NDArray

from skytender.geometry import bounds

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

_GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0
_EXACT_M = 1e-6  # to which a least distance is found
_ROUNDING_M = 1e-7
_MOST_BINS = 128  # each way [choice]: lists stay short, the table small
_LEAST_BIN_M = 1.0


class Sight:
    """An obstacle table (m, COLUMNS) with its bins; `reach_m` is the greatest clearance that can be measured.

    first: (rows * columns + 1,), where each bin's list begins in `listed`.
    """

    bins: Any

    def __init__(
        self,
        table: FloatArray,
        first: IntArray,
        listed: IntArray,
        *,
        low_ne: tuple[float, float],
        bin_m: float,
        rows: int,
        columns: int,
        reach_m: float,
    ) -> None:
        self.table, self.first, self.listed = table, first, listed
        self.bins.low_n, self.bins.low_e = low_ne
        self.bins.bin_m, self.bins.rows, self.bins.columns, self.bins.reach_m = bin_m, rows, columns, reach_m
        _point(cython.address(self.bins), table, first, listed)


def _point(bins: Any, table: FloatArray, first: IntArray, listed: IntArray) -> None:
    bins.shapes, bins.first = shape_at(table, 0), cython.address(first[0])
    bins.listed, bins.count = cython.address(listed[0]), listed.shape[0]


def sight(table: FloatArray, reach_m: float) -> Sight:
    """Bins over an obstacle table (m, COLUMNS). ValueError unless reach_m is finite and above 0."""
    if not (math.isfinite(reach_m) and reach_m > 0):
        raise ValueError(f"reach_m is {reach_m!r}; it must be a finite length above 0 m")
    table = np.ascontiguousarray(table, dtype=np.float64)
    if not len(table):
        first, listed = np.zeros(2, dtype=np.int64), np.zeros(0, dtype=np.int64)
        return Sight(table, first, listed, low_ne=(0.0, 0.0), bin_m=1.0, rows=1, columns=1, reach_m=reach_m)
    low, high = bounds(table)
    low_n, low_e = low[:, 0].min() - reach_m, low[:, 1].min() - reach_m
    wide_n, wide_e = high[:, 0].max() + reach_m - low_n, high[:, 1].max() + reach_m - low_e
    # About one bin for each obstacle, but no finer than clearances.
    bin_m = max(math.sqrt(wide_n * wide_e / len(table)), max(wide_n, wide_e) / _MOST_BINS, reach_m, _LEAST_BIN_M)
    rows, columns = int(wide_n // bin_m) + 1, int(wide_e // bin_m) + 1
    from_n = np.clip((low[:, 0] - reach_m - low_n) // bin_m, 0, rows - 1).astype(np.int64)
    to_n = np.clip((high[:, 0] + reach_m - low_n) // bin_m, 0, rows - 1).astype(np.int64)
    from_e = np.clip((low[:, 1] - reach_m - low_e) // bin_m, 0, columns - 1).astype(np.int64)
    to_e = np.clip((high[:, 1] + reach_m - low_e) // bin_m, 0, columns - 1).astype(np.int64)
    first = np.zeros(rows * columns + 1, dtype=np.int64)
    _count(from_n, to_n, from_e, to_e, columns, first)
    first = np.cumsum(first)
    listed = np.empty(first[rows * columns], dtype=np.int64)
    _list(from_n, to_n, from_e, to_e, columns, first.copy(), listed)
    return Sight(table, first, listed, low_ne=(low_n, low_e), bin_m=bin_m, rows=rows, columns=columns, reach_m=reach_m)


def _count(from_n: IntArray, to_n: IntArray, from_e: IntArray, to_e: IntArray, columns: int, first: IntArray) -> None:
    """Add to first[1 + i] how many shapes bin i lists."""
    for i in range(from_n.shape[0]):
        for r in range(from_n[i], to_n[i] + 1):
            for c in range(from_e[i], to_e[i] + 1):
                first[r * columns + c + 1] += 1


def _list(
    from_n: IntArray,
    to_n: IntArray,
    from_e: IntArray,
    to_e: IntArray,
    columns: int,
    following: IntArray,
    listed: IntArray,
) -> None:
    """Write each bin's list from where it begins in `listed`; following: (rows * columns,), these places, written."""
    for i in range(from_n.shape[0]):
        for r in range(from_n[i], to_n[i] + 1):
            for c in range(from_e[i], to_e[i] + 1):
                listed[following[r * columns + c]] = i
                following[r * columns + c] += 1


def leg_clearance(
    s: Any, an: float, ae: float, ad: float, bn: float, be: float, bd: float, enough: float, stop: float
) -> float:
    """Least signed distance of the leg a-b to any surface, or `enough` (<= reach_m) where it is more.

    Once it is known to be below `stop`, any number below `stop` may be returned.
    """
    least = min(enough, s.reach_m)
    if s.count == 0:
        return least
    low, high = min(an, bn), max(an, bn)
    # The ends are counted to the outermost bins only if they lie in them: nothing is near beyond.
    if high < s.low_n or low > s.low_n + s.rows * s.bin_m:
        return least
    if max(ae, be) < s.low_e or min(ae, be) > s.low_e + s.columns * s.bin_m:
        return least
    first_row = max(cython.cast(cython.Py_ssize_t, math.floor((low - s.low_n) / s.bin_m)), 0)
    last_row = min(cython.cast(cython.Py_ssize_t, math.floor((high - s.low_n) / s.bin_m)), s.rows - 1)
    along_n, along_e = bn - an, be - ae
    for row in range(first_row, last_row + 1):
        t0, t1 = 0.0, 1.0
        if last_row > first_row or math.fabs(along_n) > s.bin_m:
            ta = (s.low_n + row * s.bin_m - an) / along_n
            tb = (s.low_n + (row + 1) * s.bin_m - an) / along_n
            t0, t1 = max(min(ta, tb), 0.0), min(max(ta, tb), 1.0)
        ea, eb = ae + t0 * along_e, ae + t1 * along_e
        from_e = math.floor((min(ea, eb) - _ROUNDING_M - s.low_e) / s.bin_m)
        to_e = math.floor((max(ea, eb) + _ROUNDING_M - s.low_e) / s.bin_m)
        first_column = max(cython.cast(cython.Py_ssize_t, from_e), 0)
        last_column = min(cython.cast(cython.Py_ssize_t, to_e), s.columns - 1)
        for column in range(first_column, last_column + 1):
            place = row * s.columns + column
            for k in range(s.first[place], s.first[place + 1]):
                least = min(least, _along(cython.address(s.shapes[s.listed[k]]), an, ae, ad, bn, be, bd, least, stop))
                if least < stop:
                    return least
    return least


def _along(
    shape: Any,
    an: float,
    ae: float,
    ad: float,
    bn: float,
    be: float,
    bd: float,
    enough: float,
    stop: float,
) -> float:
    """Least distance of the leg to a shape, or `enough` where it is more."""
    kind = shape.kind
    if kind == WALL:
        return min(enough, past_wall(shape, an, ae, bn, be)[0])
    un, ue, ud = bn - an, be - ae, bd - ad
    square = un * un + ue * ue + ud * ud
    cn, ce, cd = shape.north - an, shape.east - ae, shape.down - ad
    t = 0.0
    if square > 0.0:
        t = min(max((cn * un + ce * ue + cd * ud) / square, 0.0), 1.0)
    to_centre = math.sqrt((cn - t * un) ** 2 + (ce - t * ue) ** 2 + (cd - t * ud) ** 2)
    if kind not in (BOX, CYLINDER):
        return min(enough, to_centre - shape.size_1)
    reach = math.sqrt(shape.size_1**2 + shape.size_2**2 + shape.size_3**2)
    if to_centre - reach >= enough:
        return enough
    length = math.sqrt(square)
    best = min(
        shape_surface(shape, an, ae, ad)[0],
        shape_surface(shape, bn, be, bd)[0],
        shape_surface(shape, an + t * un, ae + t * ue, ad + t * ud)[0],
    )
    low, high = 0.0, 1.0
    x1, x2 = 1.0 - _GOLDEN, _GOLDEN
    f1 = shape_surface(shape, an + x1 * un, ae + x1 * ue, ad + x1 * ud)[0]
    f2 = shape_surface(shape, an + x2 * un, ae + x2 * ue, ad + x2 * ud)[0]
    while (high - low) * length > _EXACT_M:
        best = min(best, f1, f2)
        if best < stop:
            return best
        # No slope is above 1, and the least lies in the bracket or was met already.
        if min(best, min(f1, f2) - (high - low) * length) >= enough:
            return enough
        if f1 <= f2:
            high, x2, f2 = x2, x1, f1
            x1 = high - _GOLDEN * (high - low)
            f1 = shape_surface(shape, an + x1 * un, ae + x1 * ue, ad + x1 * ud)[0]
        else:
            low, x1, f1 = x1, x2, f2
            x2 = low + _GOLDEN * (high - low)
            f2 = shape_surface(shape, an + x2 * un, ae + x2 * ue, ad + x2 * ud)[0]
    return min(enough, best, f1, f2)


def sees(
    s: Any, an: float, ae: float, ad: float, bn: float, be: float, bd: float, level: float, floor_d: float
) -> bool:
    """Whether the leg a-b keeps `level` m from every surface and stays above the floor, as far as its ends do.

    An end nearer to a surface than `level` has a lead of twice what it lacks, where the leg need only keep the end's
    own distance: a vehicle beside a wall may leave it, and a goal beside a wall can be seen. An end below the floor
    counts as on it.
    """
    if bd > floor_d + _ROUNDING_M and bd > ad + _ROUNDING_M:
        return False
    length = math.sqrt((bn - an) ** 2 + (be - ae) ** 2 + (bd - ad) ** 2)
    level = min(level, s.reach_m)
    at_a = leg_clearance(s, an, ae, ad, an, ae, ad, level, -math.INFINITY)
    at_b = leg_clearance(s, bn, be, bd, bn, be, bd, level, -math.INFINITY)
    lead_a, lead_b = 2.0 * (level - at_a), 2.0 * (level - at_b)
    if lead_a <= 0.0 and lead_b <= 0.0:
        return leg_clearance(s, an, ae, ad, bn, be, bd, level, level) >= level
    if lead_a + lead_b >= length:
        least = min(at_a, at_b) - _ROUNDING_M
        return leg_clearance(s, an, ae, ad, bn, be, bd, level, least) >= least
    ta, tb = lead_a / length, 1.0 - lead_b / length
    fn, fe, fd = an + ta * (bn - an), ae + ta * (be - ae), ad + ta * (bd - ad)
    gn, ge, gd = an + tb * (bn - an), ae + tb * (be - ae), ad + tb * (bd - ad)
    if leg_clearance(s, fn, fe, fd, gn, ge, gd, level, level) < level:
        return False
    least_a, least_b = at_a - _ROUNDING_M, at_b - _ROUNDING_M
    if lead_a > 0.0 and leg_clearance(s, an, ae, ad, fn, fe, fd, level, least_a) < least_a:
        return False
    return lead_b <= 0.0 or leg_clearance(s, gn, ge, gd, bn, be, bd, level, least_b) >= least_b


def clearance_between(s: Any, a_ned: Any, b_ned: Any, enough: float, stop: float) -> float:
    """`leg_clearance` of the leg between two places (3,)."""
    return leg_clearance(s, a_ned[0], a_ned[1], a_ned[2], b_ned[0], b_ned[1], b_ned[2], enough, stop)


def sees_from(s: Any, a_ned: Any, b_ned: Any, level: float, floor_d: float) -> bool:
    """`sees` for two places (3,)."""
    return sees(s, a_ned[0], a_ned[1], a_ned[2], b_ned[0], b_ned[1], b_ned[2], level, floor_d)


def clear_m(s: Sight, a_ned: FloatArray, b_ned: FloatArray, enough: float, stop: float = -math.INFINITY) -> float:
    """Least signed distance in m of the leg between two places (3,) to any surface, as `leg_clearance` gives it."""
    return clearance_between(cython.address(s.bins), cython.address(a_ned[0]), cython.address(b_ned[0]), enough, stop)


def visible(s: Sight, a_ned: FloatArray, b_ned: FloatArray, level: float, floor_d: float) -> bool:
    """Whether the leg between two places (3,) keeps `level` m, as `sees` says."""
    return sees_from(cython.address(s.bins), cython.address(a_ned[0]), cython.address(b_ned[0]), level, floor_d)


def leg_clearances(s: Sight, path_ned: FloatArray) -> FloatArray:
    """Least distance of each leg of path_ned (k, 3), (k - 1,), cut off at reach_m."""
    legs = np.empty(max(len(path_ned) - 1, 0))
    clearances = legs
    for i in range(clearances.shape[0]):
        a, b = cython.address(path_ned[i, 0]), cython.address(path_ned[i + 1, 0])
        clearances[i] = clearance_between(cython.address(s.bins), a, b, s.bins.reach_m, -math.INFINITY)
    return legs
