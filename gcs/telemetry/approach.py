"""Closest approach between two ticks, from relative motion: of vehicles to each other, to traffic, to obstacles.

Between two ticks everything flies straight from place to place; where velocities are given too it flies the cubic curve
(Hermite) that has these places and velocities at both ends, looked at every FINE-th of the interval.
All places are (n, 3), m, in the common NED frame; a share is the part of the interval that has passed, 0 to 1.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gcs.kernels import UNCOUNTED, kernel
from gcs.scenario import geometry

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Flags = NDArray[np.bool_]

FINE = 25
"""Looks per interval on a curve: 4 ms, the vehicles' own step, of a period of 0.1 s."""
MOST_FOUND = 64
"""Number of pairs that are too near reported of one interval."""
CLOSING_M_S = 0.1
"""A vehicle that is not ours comes too near only where ours closes in by more than this."""
CURVED_M = 0.1
"""A curve is nearer than its chord by at most this much: at 5 m/s² each and 0.1 s it is 0.0125 m."""
STRAIGHT = np.empty((0, 3))
WAY = 5
CLEAR_M, CLEAR_AT = 3, 4
"""Of a vehicle's way in an interval, behind the place where it began."""


@kernel()
def segment_gap2(rn: float, re: float, rd: float, dn: float, de: float, dd: float) -> tuple[float, float]:
    """Least square distance to zero on the way from r to r + d, and the share at which it is reached."""
    length2 = dn * dn + de * de + dd * dd
    share = 0.0
    if length2 > 0.0:
        share = min(max(-(rn * dn + re * de + rd * dd) / length2, 0.0), 1.0)
    n, e, d = rn + share * dn, re + share * de, rd + share * dd
    return n * n + e * e + d * d, share


@kernel()
def curve_gap2(r0: Floats, r1: Floats, v0: Floats, v1: Floats, period_s: float) -> tuple[float, float]:
    """The same on the cubic curve from r0 with velocity v0 to r1 with velocity v1, (3,) each."""
    best2, best_share = math.inf, 0.0
    before = np.empty(3)
    for step in range(FINE + 1):
        s = step / FINE
        h00, h10 = (1.0 + 2.0 * s) * (1.0 - s) ** 2, s * (1.0 - s) ** 2 * period_s
        h01, h11 = s * s * (3.0 - 2.0 * s), s * s * (s - 1.0) * period_s
        n = h00 * r0[0] + h10 * v0[0] + h01 * r1[0] + h11 * v1[0]
        e = h00 * r0[1] + h10 * v0[1] + h01 * r1[1] + h11 * v1[1]
        d = h00 * r0[2] + h10 * v0[2] + h01 * r1[2] + h11 * v1[2]
        if step > 0:
            gap2, share = segment_gap2(before[0], before[1], before[2], n - before[0], e - before[1], d - before[2])
            if gap2 < best2:
                best2, best_share = gap2, (step - 1 + share) / FINE
        before[0], before[1], before[2] = n, e, d
    return best2, best_share


@kernel()
def nearest_pair(
    before: Floats,
    now: Floats,
    v_before: Floats,
    v_now: Floats,
    period_s: float,
    ours: Flags,
    exempt: Ints,
    limit_m: float,
    worth_m: float,
    found: Floats,
) -> tuple[float, int, int, float, int]:
    """The nearest two of n vehicles in an interval: (distance, row, row, share), inf and -1 where there are none; and
    how many pairs came nearer than `limit_m`, of which `found` (k, 4) takes row, row, distance, share.

    A pair in `exempt` (k, 2) is left out, as is one of which neither is `ours` (n,), and one of which one is, where
    that one does not close in. v_before, v_now: (n, 3), or (0, 3) for straight ways. Pairs that stay farther apart than
    both limit_m and worth_m need not be reported.
    """
    n = now.shape[0]
    count = 0
    least, one, other, at = math.inf, -1, -1, 0.0
    moved = 0.0
    for i in range(n):
        step = (now[i, 0] - before[i, 0]) ** 2 + (now[i, 1] - before[i, 1]) ** 2 + (now[i, 2] - before[i, 2]) ** 2
        moved = max(moved, step)
    moved = 2.0 * math.sqrt(moved)
    curved = v_now.shape[0] > 0
    slack = CURVED_M if curved else 0.0
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
            for k in range(exempt.shape[0]):
                left_out |= (exempt[k, 0] == i and exempt[k, 1] == j) or (exempt[k, 0] == j and exempt[k, 1] == i)
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
                if closing <= CLOSING_M_S * period_s * away:
                    continue
            if curved:
                gap2, share = curve_gap2(
                    before[i] - before[j], now[i] - now[j], v_before[i] - v_before[j], v_now[i] - v_now[j], period_s
                )
            gap = math.sqrt(gap2)
            if gap < limit_m:
                if count < found.shape[0]:
                    found[count, 0], found[count, 1], found[count, 2], found[count, 3] = j, i, gap, share
                count += 1
            if gap < least:
                least, one, other, at = gap, j, i, share
                reach = min(reach, max(limit_m, min(least, worth_m)) + moved + slack)
    return least, one, other, at, count


@kernel()
def nearest_to(before: Floats, now: Floats, others_before: Floats, others_now: Floats) -> tuple[Floats, Ints, Floats]:
    """For each of n vehicles the least distance (n,) to any of m others in an interval, which that is, and the share;
    straight ways."""
    least = np.full(now.shape[0], np.inf)
    which = np.full(now.shape[0], -1, dtype=np.int64)
    shares = np.zeros(now.shape[0])
    for i in range(now.shape[0]):
        for j in range(others_now.shape[0]):
            bn, be, bd = (
                before[i, 0] - others_before[j, 0],
                before[i, 1] - others_before[j, 1],
                before[i, 2] - others_before[j, 2],
            )
            rn, re, rd = (
                now[i, 0] - others_now[j, 0],
                now[i, 1] - others_now[j, 1],
                now[i, 2] - others_now[j, 2],
            )
            gap2, share = segment_gap2(bn, be, bd, rn - bn, re - be, rd - bd)
            if gap2 < least[i] * least[i]:
                least[i], which[i], shares[i] = math.sqrt(gap2), j, share
    return least, which, shares


@kernel()
def clearances(shapes: Floats, before: Floats, now: Floats, worth_m: float) -> tuple[Floats, Floats]:
    """For each of n vehicles the least clearance (n,) to any shape in an interval, and the share; straight ways.

    A distance changes by no more than the way flown: only those that may have come nearer than `worth_m` between the
    ticks are looked at there.
    """
    least = np.empty(now.shape[0])
    geometry.fill_clearances(shapes, now, least)
    shares = np.ones(now.shape[0])
    for i in range(now.shape[0]):
        n, e, d = now[i, 0] - before[i, 0], now[i, 1] - before[i, 1], now[i, 2] - before[i, 2]
        if least[i] - math.sqrt(n * n + e * e + d * d) < worth_m:
            least[i], shares[i] = _clearance_between(shapes, before[i], n, e, d)
    return least, shares


@kernel()
def _clearance_between(shapes: Floats, before: Floats, n: float, e: float, d: float) -> tuple[float, float]:
    """The least clearance on the straight way from a place (3,) on, and the share."""
    between, there, clear_m = np.empty(FINE + 1), np.empty((FINE + 1, 3)), np.empty(FINE + 1)
    least, at = math.inf, 1.0
    low, high = 0.0, 1.0
    for _ in range(2):  # the second time closer around the nearest place of the first
        for step in range(FINE + 1):
            share = high if step == FINE else low + step * ((high - low) / FINE)
            between[step] = share
            there[step, 0], there[step, 1] = before[0] + share * n, before[1] + share * e
            there[step, 2] = before[2] + share * d
        geometry.fill_clearances(shapes, there, clear_m)
        k = int(clear_m.argmin())
        least, at = clear_m[k], between[k]
        low, high = between[max(k - 1, 0)], between[min(k + 1, FINE)]
    return least, at


@kernel()
def look(
    p: Floats,
    v: Floats,
    last: Floats,
    period_s: float,
    flying: Flags,
    ours: Flags,
    exempt: Ints,
    shapes: Floats,
    limit_m: float,
    worth_m: float,
    clear_limit_m: float,
    clear_worth_m: float,
    ways: Floats,
    found: Floats,
) -> tuple[int, float, int, int, float, int, int]:
    """One interval of a fleet of n: (vehicles that count, least separation, row, row, share, pairs too near, row of the
    least clearance), as `nearest_pair` has them with `limit_m` and `worth_m`, of those who are `flying` and whose place
    is known. The last is -1 where no clearance is less than `clear_limit_m` or `clear_worth_m`.

    p, v: (n, 3) now, NaN where unknown, v also (0, 3). last (2, n, 3): both at the last tick, NaN where unknown; at the
    end they are those of now. exempt (k, 2): rows of pairs that are left out. ways (n, WAY): filled with where each way
    began, and the least clearance of those who are `ours`, inf for others, and its share; only what may be less than
    the two limits is worth a closer look.
    """
    n = p.shape[0]
    numbers = np.empty((2, n), dtype=np.int64)
    rows, place, p_last, v_last = numbers[0], numbers[1], last[0], last[1]
    place[:] = -1
    count = 0
    known = True
    for i in range(n):
        if flying[i] and not math.isnan(p[i, 0]):
            rows[count], place[i] = i, count
            count += 1
            known &= not (math.isnan(p_last[i, 0]) or math.isnan(p_last[i, 1]) or math.isnan(p_last[i, 2]))
    curved = count if known and v.shape[0] > 0 else 0
    block, own = np.empty((2 * (count + curved), 3)), np.empty(count, dtype=np.bool_)
    now, was = block[:count], block[count : 2 * count]
    v_now, v_was = block[2 * count : 2 * count + curved], block[2 * count + curved :]
    own_count = 0
    for k in range(count):
        i = rows[k]
        own[k] = ours[i]
        own_count += ours[i]
        for axis in range(3):
            now[k, axis] = p[i, axis]
            was[k, axis] = p[i, axis] if math.isnan(p_last[i, axis]) else p_last[i, axis]
            ways[i, axis] = was[k, axis]
            if curved > 0:
                v_now[k, axis], v_was[k, axis] = v[i, axis], v_last[i, axis]
    pairs = np.empty_like(exempt)
    kept = 0
    for k in range(exempt.shape[0]):
        if place[exempt[k, 0]] >= 0 and place[exempt[k, 1]] >= 0:
            pairs[kept, 0], pairs[kept, 1] = place[exempt[k, 0]], place[exempt[k, 1]]
            kept += 1
    least, one, other, share, near = nearest_pair(
        was, now, v_was, v_now, period_s, own, pairs[:kept], limit_m, worth_m, found
    )
    if one >= 0:
        one, other = rows[one], rows[other]
    for k in range(min(near, found.shape[0])):
        found[k, 0], found[k, 1] = rows[int(found[k, 0])], rows[int(found[k, 1])]
    for i in range(n):
        ways[i, CLEAR_M], ways[i, CLEAR_AT] = math.inf, 1.0
    clearest = -1
    if shapes.shape[0] > 0:
        clear_of_m = max(clear_limit_m, min(clear_worth_m, 1e9))
        if own_count < count:
            rows, was, now = rows[:count][own], was[own], now[own]
        of_each, at_share = clearances(shapes, was, now, clear_of_m)
        least_m = max(clear_limit_m, clear_worth_m)
        for k in range(own_count):
            i = rows[k]
            ways[i, CLEAR_M], ways[i, CLEAR_AT] = of_each[k], at_share[k]
            if of_each[k] < least_m:
                clearest, least_m = i, of_each[k]
    for i in range(n):
        for axis in range(3):
            p_last[i, axis] = p[i, axis] if place[i] >= 0 else math.nan
            if v.shape[0] > 0:
                v_last[i, axis] = v[i, axis]
    return count, least, one, other, share, near, clearest


@kernel(**UNCOUNTED)
def pass_points(p: Floats, last: Floats, points: Floats, ahead: Ints, end: Ints, within2: float) -> int:
    """Let n vehicles pass way points on their straight ways of one interval; how many of them have some left.

    p: (n, 3) now, NaN where unknown. last: (n, 3) the same of the last interval, which is brought up to date. points:
    (m, 3), those of row i from ahead[i], which is moved on, to end[i]. within2: square distance at which one is passed.
    """
    left = 0
    for i in range(len(p)):
        if ahead[i] < end[i] and not math.isnan(p[i, 0]):
            begin = p[i] if math.isnan(last[i, 0]) else last[i]
            dn, de, dd = p[i, 0] - begin[0], p[i, 1] - begin[1], p[i, 2] - begin[2]
            while ahead[i] < end[i]:
                point = points[ahead[i]]
                gap2, _ = segment_gap2(begin[0] - point[0], begin[1] - point[1], begin[2] - point[2], dn, de, dd)
                if gap2 > within2:
                    break
                ahead[i] += 1
        left += ahead[i] < end[i]
        last[i, 0], last[i, 1], last[i, 2] = p[i, 0], p[i, 1], p[i, 2]
    return left


def nearest_shape(shapes: Floats, place: Floats) -> int:
    """Which shape's surface is nearest to a place (3,)."""
    each = [float(geometry.clearance(shapes[k : k + 1], place[None])[0]) for k in range(len(shapes))]
    return int(np.argmin(each))
