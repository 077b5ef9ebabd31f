"""Closest approach between two ticks, from relative motion: of vehicles to each other, to traffic, to obstacles.

Between two ticks everything flies straight from place to place; where velocities are given too it flies the cubic curve
(Hermite) that has these places and velocities at both ends, looked at every FINE-th of the interval. One whose velocity
is not known at both ends flies straight then too.
All places are (n, 3), m, in the common NED frame; a share is the part of the interval that has passed, 0 to 1.
"""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.skytender.geometry as geometry
import numpy as np
from cython.cimports.gcs.telemetry.approach import (
    CLEAR_AT,
    CLEAR_M,
    CLEAR_PLACE,
    ENDS,
    FINE,
    V_BEGAN,
    V_ENDED,
    Pair,
    Seen,
)
from cython.cimports.libc import math
from numpy.typing import NDArray

from skytender.geometry import clearance

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Flags = NDArray[np.bool_]

MOST_FOUND = 64
"""Number of pairs that are too near reported of one interval."""
_CLOSING_M_S = 0.1  # a vehicle that is not ours comes too near only where ours closes in by more than this
_BULGE = 0.149  # s (1 - s)² is at most 4/27
STRAIGHT = np.empty((0, 3))
WAY = 14
"""Of a vehicle's way in an interval: the place where it began, the least clearance, its share and its place, and the
velocities at both ends, where ways are curved."""


def segment_gap2(rn: float, re: float, rd: float, dn: float, de: float, dd: float) -> tuple[float, float]:
    """Least square distance to zero on the way from r to r + d, and the share at which it is reached."""
    length2 = dn * dn + de * de + dd * dd
    share = 0.0
    if length2 > 0.0:
        share = min(max(-(rn * dn + re * de + rd * dd) / length2, 0.0), 1.0)
    n, e, d = rn + share * dn, re + share * de, rd + share * dd
    return n * n + e * e + d * d, share


def curve_gap2(r0: Any, r1: Any, v0: Any, v1: Any, period_s: float) -> tuple[float, float]:
    """The same on the cubic curve from r0 with velocity v0 to r1 with velocity v1, (3,) each."""
    best2, best_share = math.INFINITY, 0.0
    was_n = was_e = was_d = 0.0
    for step in range(FINE + 1):
        s = cython.cast(cython.double, step) / FINE
        h00, h10 = (1.0 + 2.0 * s) * ((1.0 - s) * (1.0 - s)), s * ((1.0 - s) * (1.0 - s)) * period_s
        h01, h11 = s * s * (3.0 - 2.0 * s), s * s * (s - 1.0) * period_s
        n = h00 * r0[0] + h10 * v0[0] + h01 * r1[0] + h11 * v1[0]
        e = h00 * r0[1] + h10 * v0[1] + h01 * r1[1] + h11 * v1[1]
        d = h00 * r0[2] + h10 * v0[2] + h01 * r1[2] + h11 * v1[2]
        if step > 0:
            gap2, share = segment_gap2(was_n, was_e, was_d, n - was_n, e - was_e, d - was_d)
            if gap2 < best2:
                best2, best_share = gap2, (step - 1 + share) / FINE
        was_n, was_e, was_d = n, e, d
    return best2, best_share


def _bulge(r0: Any, r1: Any, v0: Any, v1: Any, period_s: float) -> float:
    """How far that curve is from its chord at most, at equal shares."""
    at_0 = at_1 = 0.0
    for axis in range(3):
        begin, end = v0[axis] * period_s - (r1[axis] - r0[axis]), v1[axis] * period_s - (r1[axis] - r0[axis])
        at_0, at_1 = at_0 + begin * begin, at_1 + end * end
    return _BULGE * (math.sqrt(at_0) + math.sqrt(at_1))


def find_pair(
    before: Floats, now: Floats, v_before: Floats, v_now: Floats, n: int, curved: bool, period_s: float,
    ours: NDArray[np.uint8], exempt: Ints, exempted: int, limit_m: float, worth_m: float, found: Floats,
) -> Any:  # fmt: skip
    """The nearest two of the first n vehicles in an interval: their distance, rows and share, inf and -1 where there
    are none; and how many pairs came nearer than `limit_m`, of which `found` (k, 4) takes row, row, distance, share.

    One of the first `exempted` pairs in `exempt` (k, 2) is left out, as is one of which neither is `ours` (n,), and one
    of which one is, where that one does not close in. v_before, v_now: (n, 3), where ways are `curved`. Pairs that stay
    farther apart than both limit_m and worth_m need not be reported.
    """
    a = cython.declare(cython.double[3])
    b = cython.declare(cython.double[3])
    va = cython.declare(cython.double[3])
    vb = cython.declare(cython.double[3])
    pair = cython.declare(Pair)
    count = 0
    least, one, other, at = math.INFINITY, -1, -1, 0.0
    moved = slack = 0.0
    for i in range(n):
        dn, de, dd = now[i, 0] - before[i, 0], now[i, 1] - before[i, 1], now[i, 2] - before[i, 2]
        moved = max(moved, dn * dn + de * de + dd * dd)
        if curved:
            slack = max(slack, 2.0 * _bulge(
                cython.address(before[i, 0]), cython.address(now[i, 0]),
                cython.address(v_before[i, 0]), cython.address(v_now[i, 0]), period_s,
            ))  # fmt: skip
    moved = 2.0 * math.sqrt(moved)
    reach = max(limit_m, min(worth_m, 1e9)) + moved + slack
    for i in range(n):
        for j in range(i):
            rn, re, rd = now[i, 0] - now[j, 0], now[i, 1] - now[j, 1], now[i, 2] - now[j, 2]
            if rn * rn + re * re + rd * rd > reach * reach:
                continue
            bn, be, bd = before[i, 0] - before[j, 0], before[i, 1] - before[j, 1], before[i, 2] - before[j, 2]
            gap2, share = segment_gap2(bn, be, bd, rn - bn, re - be, rd - bd)
            nearest = max(limit_m, min(least, worth_m)) + slack
            if gap2 > nearest * nearest:
                continue
            left_out = not (ours[i] or ours[j])
            for k in range(exempted):
                if (exempt[k, 0] == i and exempt[k, 1] == j) or (exempt[k, 0] == j and exempt[k, 1] == i):
                    left_out = True
            if left_out:
                continue
            if ours[i] != ours[j]:
                own = i if ours[i] else j
                to = -1.0 if ours[i] else 1.0
                away = math.sqrt(bn * bn + be * be + bd * bd)
                closing = to * (
                    bn * (now[own, 0] - before[own, 0])
                    + be * (now[own, 1] - before[own, 1])
                    + bd * (now[own, 2] - before[own, 2])
                )
                if closing <= _CLOSING_M_S * period_s * away:
                    continue
            if curved:
                for axis in range(3):
                    a[axis], b[axis] = before[i, axis] - before[j, axis], now[i, axis] - now[j, axis]
                    va[axis], vb[axis] = v_before[i, axis] - v_before[j, axis], v_now[i, axis] - v_now[j, axis]
                gap2, share = curve_gap2(a, b, va, vb, period_s)
            gap = math.sqrt(gap2)
            if gap < limit_m:
                if count < found.shape[0]:
                    found[count, 0], found[count, 1], found[count, 2], found[count, 3] = j, i, gap, share
                count += 1
            if gap < least:
                least, one, other, at = gap, j, i, share
                reach = min(reach, max(limit_m, min(least, worth_m)) + moved + slack)
    pair.distance_m, pair.one, pair.other, pair.share, pair.count = least, one, other, at, count
    return pair


def nearest_to(
    before: Floats, now: Floats, v_before: Floats, v_now: Floats, others_before: Floats, others_now: Floats,
    period_s: float,
) -> tuple[Floats, Ints, Floats]:  # fmt: skip
    """For each of n vehicles the least distance (n,) to any of m others in an interval, which that is, and the share.

    v_before, v_now: (n, 3), or (0, 3) where ways are straight; the others' always are.
    """
    least, which, shares = np.full(len(now), np.inf), np.full(len(now), -1, np.int64), np.zeros(len(now))
    _find_nearest(before, now, v_before, v_now, others_before, others_now, period_s, least, which, shares)
    return least, which, shares


def _find_nearest(
    before: Floats, now: Floats, v_before: Floats, v_now: Floats, others_before: Floats, others_now: Floats,
    period_s: float, least: Floats, which: Ints, shares: Floats,
) -> None:  # fmt: skip
    a = cython.declare(cython.double[3])
    b = cython.declare(cython.double[3])
    va = cython.declare(cython.double[3])
    vb = cython.declare(cython.double[3])
    curved = v_now.shape[0] > 0 and period_s > 0.0
    for i in range(now.shape[0]):
        for j in range(others_now.shape[0]):
            for axis in range(3):
                a[axis], b[axis] = before[i, axis] - others_before[j, axis], now[i, axis] - others_now[j, axis]
                if curved:
                    v = (others_now[j, axis] - others_before[j, axis]) / period_s
                    va[axis], vb[axis] = v_before[i, axis] - v, v_now[i, axis] - v
            gap2, share = segment_gap2(a[0], a[1], a[2], b[0] - a[0], b[1] - a[1], b[2] - a[2])
            if curved and math.sqrt(gap2) - _bulge(a, b, va, vb, period_s) < least[i]:
                gap2, share = curve_gap2(a, b, va, vb, period_s)
            if gap2 < least[i] * least[i]:
                least[i], which[i], shares[i] = math.sqrt(gap2), j, share


def _clearance_between(
    shapes: Floats, r0: Any, r1: Any, v0: Any, v1: Any, curved: bool, period_s: float, reach: Floats, there: Any
) -> tuple[float, float]:
    """The least clearance on the way from r0 to r1, and the share; writes there (3,) where that is."""
    between = cython.declare(cython.double[ENDS])
    clear_m = cython.declare(cython.double[ENDS])
    least, at = math.INFINITY, 1.0
    low, high = 0.0, 1.0
    for _ in range(2):  # the second time closer around the nearest place of the first
        nearest = 0
        for step in range(FINE + 1):
            share = high if step == FINE else low + step * ((high - low) / FINE)
            between[step] = share
            north, east, down = _on_way(r0, r1, v0, v1, curved, period_s, share)
            clear_m[step] = geometry.clearance_at(shapes, reach, north, east, down)
            if clear_m[step] < clear_m[nearest]:
                nearest = step
        least, at = clear_m[nearest], between[nearest]
        low, high = between[max(nearest - 1, 0)], between[min(nearest + 1, FINE)]
    there[0], there[1], there[2] = _on_way(r0, r1, v0, v1, curved, period_s, at)
    return least, at


def _on_way(
    r0: Any, r1: Any, v0: Any, v1: Any, curved: bool, period_s: float, share: float
) -> tuple[float, float, float]:
    """The place at a share of the way from r0 to r1: on the chord, and so far beside it as the curve is."""
    rest = 1.0 - share
    h10, h11 = share * rest * rest, -share * share * rest
    place = cython.declare(cython.double[3])
    for axis in range(3):
        along = r1[axis] - r0[axis]
        place[axis] = r0[axis] + share * along
        if curved:
            place[axis] += h10 * (v0[axis] * period_s - along) + h11 * (v1[axis] * period_s - along)
    return place[0], place[1], place[2]


class FleetWatch:
    """Looks at a fleet of n, interval by interval.

    Tables are kept, and filled in place. last (2, n, 3): places and velocities at the last look, NaN where unknown.
    ways (n, WAY): of each; the least clearance is inf of those that are not `ours`. found (MOST_FOUND, 4), as
    `find_pair` has it. shapes: table of skytender/geometry.py.
    """

    def __init__(self, last: Floats, shapes: Floats, ways: Floats, found: Floats) -> None:
        count = last.shape[1]
        self._last, self._shapes, self._ways, self._found = last, shapes, ways, found
        self._rows, self._place = np.empty(count, np.int64), np.empty(count, np.int64)
        self._block, self._own = np.empty((4, count, 3)), np.empty(count, np.uint8)
        self._pairs, self._reach = np.empty((count, 2), np.int64), np.empty(len(shapes))

    def look(
        self,
        p: Floats,
        v: Floats,
        period_s: float,
        flying: Flags,
        ours: Flags,
        exempt: Ints,
        limit_m: float,
        worth_m: float,
        clear_limit_m: float,
        clear_worth_m: float,
    ) -> tuple[int, float, int, int, float, int, int]:
        """One interval: (vehicles that count, least separation, row, row, share, pairs too near, row of the least
        clearance), as `find_pair` has them with `limit_m` and `worth_m`. Vehicles count while they are `flying` and
        their place is known. The last is -1 where no clearance is less than `clear_limit_m` or `clear_worth_m`.

        p, v: (n, 3) now, NaN where unknown; v (0, 3) where ways are to be straight. exempt (k, 2): rows of pairs that
        are left out. Only what may be less than the two limits is worth a closer look.
        """
        if len(exempt) > self._pairs.shape[0]:
            self._pairs = np.empty((len(exempt), 2), np.int64)
        seen = _look(
            p, v, self._last, period_s, flying.view(np.uint8), ours.view(np.uint8), exempt, self._shapes, limit_m,
            worth_m, clear_limit_m, clear_worth_m, self._ways, self._found, self._rows, self._place, self._block,
            self._own, self._pairs, self._reach,
        )  # fmt: skip
        return (
            seen.count, seen.pair.distance_m, seen.pair.one, seen.pair.other, seen.pair.share, seen.pair.count,
            seen.clearest,
        )  # fmt: skip


def _look(
    p: Floats, v: Floats, last: Floats, period_s: float, flying: Any, ours: Any, exempt: Ints, shapes: Floats,
    limit_m: float, worth_m: float, clear_limit_m: float, clear_worth_m: float, ways: Floats, found: Floats,
    rows: Ints, place: Ints, block: Floats, own: Any, pairs: Ints, reach: Floats,
) -> Any:  # fmt: skip
    """`FleetWatch.look` with its scratch: rows, place and own (n,), block (4, n, 3), pairs (k or more, 2), reach
    (shapes,)."""
    seen = cython.declare(Seen)
    n = p.shape[0]
    now, was, v_now, v_was = block[0], block[1], block[2], block[3]
    count = 0
    for i in range(n):
        place[i] = -1
        if flying[i] and not math.isnan(p[i, 0]):
            rows[count], place[i] = i, count
            count += 1
    curved = count > 0 and v.shape[0] > 0
    for k in range(count):
        i = rows[k]
        own[k] = ours[i]
        known = curved and not (math.isnan(last[0, i, 0]) or math.isnan(last[1, i, 0]) or math.isnan(v[i, 0]))
        for axis in range(3):
            now[k, axis] = p[i, axis]
            was[k, axis] = p[i, axis] if math.isnan(last[0, i, axis]) else last[0, i, axis]
            ways[i, axis] = was[k, axis]
            if known:
                v_now[k, axis], v_was[k, axis] = v[i, axis], last[1, i, axis]
            elif curved:  # the chord's own velocity
                v_now[k, axis] = (now[k, axis] - was[k, axis]) / period_s if period_s > 0.0 else 0.0
                v_was[k, axis] = v_now[k, axis]
            if curved:
                ways[i, V_BEGAN + axis], ways[i, V_ENDED + axis] = v_was[k, axis], v_now[k, axis]
    kept = 0
    for k in range(exempt.shape[0]):
        if place[exempt[k, 0]] >= 0 and place[exempt[k, 1]] >= 0:
            pairs[kept, 0], pairs[kept, 1] = place[exempt[k, 0]], place[exempt[k, 1]]
            kept += 1
    pair = find_pair(was, now, v_was, v_now, count, curved, period_s, own, pairs, kept, limit_m, worth_m, found)
    if pair.one >= 0:
        pair.one, pair.other = rows[pair.one], rows[pair.other]
    for k in range(min(pair.count, found.shape[0])):
        found[k, 0] = rows[cython.cast(cython.Py_ssize_t, found[k, 0])]
        found[k, 1] = rows[cython.cast(cython.Py_ssize_t, found[k, 1])]
    for i in range(n):
        ways[i, CLEAR_M], ways[i, CLEAR_AT] = math.INFINITY, 1.0
    clearest = -1
    if shapes.shape[0] > 0:
        geometry.fill_reach(shapes, reach)
        clear_of_m = max(clear_limit_m, min(clear_worth_m, 1e9))
        least_m = max(clear_limit_m, clear_worth_m)
        for k in range(count):
            if not own[k]:
                continue
            i = rows[k]
            clear_m, share = geometry.clearance_at(shapes, reach, now[k, 0], now[k, 1], now[k, 2]), 1.0
            dn, de, dd = now[k, 0] - was[k, 0], now[k, 1] - was[k, 1], now[k, 2] - was[k, 2]
            r0, r1 = cython.address(was[k, 0]), cython.address(now[k, 0])
            v0, v1 = cython.address(v_was[k, 0]), cython.address(v_now[k, 0])
            there = cython.address(ways[i, CLEAR_PLACE])
            there[0], there[1], there[2] = now[k, 0], now[k, 1], now[k, 2]
            # A distance changes by no more than the way flown.
            flown_m = math.sqrt(dn * dn + de * de + dd * dd) + (_bulge(r0, r1, v0, v1, period_s) if curved else 0.0)
            if clear_m - flown_m < clear_of_m:
                clear_m, share = _clearance_between(shapes, r0, r1, v0, v1, curved, period_s, reach, there)
            ways[i, CLEAR_M], ways[i, CLEAR_AT] = clear_m, share
            if clear_m < least_m:
                clearest, least_m = i, clear_m
    for i in range(n):
        for axis in range(3):
            last[0, i, axis] = p[i, axis] if place[i] >= 0 else math.NAN
            if v.shape[0] > 0:
                last[1, i, axis] = v[i, axis]
    seen.count, seen.pair, seen.clearest = count, pair, clearest
    return seen


def pass_points(
    p: Floats, last: Floats, left_out: NDArray[np.uint8], points: Floats, ahead: Ints, end: Ints, within2: float
) -> int:
    """Let n vehicles pass way points on their straight ways of one interval; how many of them have some left.

    p: (n, 3) now, NaN where unknown. last: (n, 3) the same of the last interval, which is brought up to date. left_out:
    (n,) 1 where a vehicle passes none, and the straight line to where that ends does not count. points: (m, 3), those
    of row i from ahead[i], which is moved on, to end[i]. within2: square distance at which one is passed.
    """
    left = 0
    for i in range(p.shape[0]):
        if left_out[i]:
            left += ahead[i] < end[i]
            last[i, 0] = last[i, 1] = last[i, 2] = math.NAN
            continue
        if ahead[i] < end[i] and not math.isnan(p[i, 0]):
            known = not math.isnan(last[i, 0])
            n = last[i, 0] if known else p[i, 0]
            e = last[i, 1] if known else p[i, 1]
            d = last[i, 2] if known else p[i, 2]
            while ahead[i] < end[i]:
                k = ahead[i]
                rn, re, rd = n - points[k, 0], e - points[k, 1], d - points[k, 2]
                gap2, _ = segment_gap2(rn, re, rd, p[i, 0] - n, p[i, 1] - e, p[i, 2] - d)
                if gap2 > within2:
                    break
                ahead[i] += 1
        left += ahead[i] < end[i]
        last[i, 0], last[i, 1], last[i, 2] = p[i, 0], p[i, 1], p[i, 2]
    return left


def nearest_shape(shapes: Floats, place: Floats) -> int:
    """Which shape's surface is nearest to a place (3,)."""
    each = [float(clearance(shapes[k : k + 1], place[None])[0]) for k in range(len(shapes))]
    return int(np.argmin(each))
