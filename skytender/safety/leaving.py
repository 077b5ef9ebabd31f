"""Leaving: how near a vehicle comes to what may turn any way, if it leaves at once.

Traffic that flies at up to w may be anywhere within w t of its place after t. A vehicle leaves it along a direction e:
its velocity becomes V e, with V its greatest speed, at its brake b and on the straight line between the two, so that
what leads aside into another aircraft is braked too. It keeps D while

    m(e) = min over 0 <= t <= H of  |Δ(t)| - w t  >=  D,   Δ the way of leaving less the place                (1)

where the coming period is flown with u and H is the filter's horizon. A period of leaving does not lower m(e),
whatever the other does meanwhile: its next place is within w T, and the rest of the way is the same. e is the one of
`DIRECTIONS`, and of those straight away from each aircraft, with the greatest least m(e) - D over all aircraft, less
what other vehicles stand in the way: between two aircraft a vehicle leaves aside before they close in. From one alone
it is n, straight away, and if v is along n

    m(n) = |Δ⁺| - w T - max(w - n·v⁺, 0)²/(2 b)                                                              (2)

[lineage] of the closing speed that brakes take off: Wang, Ames, Egerstedt, IEEE
T-RO 33(3), 2017; of reachable sets of what others may do: Fraichard, Asama, Advanced Robotics 18(10), 2004. Form
[choice]. Frames NED, SI units.
"""

from __future__ import annotations

from typing import Any

import cython
from cython.cimports.libc import math
from cython.cimports.skytender.safety.braking_clearance import TINY, period_bound
from cython.cimports.skytender.safety.constraints import Moves, Other
from cython.cimports.skytender.safety.safety_constraints import OTHER, REACH

from skytender.safety.braking_clearance import FloatArray

DIRECTIONS = 17
"""level and 45 degrees up by each eighth of a turn, and up; none is down, where the ground is"""
FREE_M, PEER_M, NEARBY_M = 1.5, 1.0, 0.2
_HALF = 0.7071067811865476
_NORTH = [1.0, _HALF, 0.0, -_HALF, -1.0, -_HALF, 0.0, _HALF]


def way_clearance(
    xn: float, xe: float, xd: float, vn: float, ve: float, vd: float, brake: float, v_max: float, w: float, e: Any,
    dt: float, horizon: float,
) -> Any:  # fmt: skip
    """m(e) of (1) from a relative place and a velocity on, as braking_clearance.py gives clearances; the first is 0."""
    un, ue, ud = v_max * e[0] - vn, v_max * e[1] - ve, v_max * e[2] - vd
    left = math.sqrt(un * un + ue * ue + ud * ud) / brake  # until it flies along e at its greatest speed
    if left > TINY:
        un, ue, ud = un / left, ue / left, ud / left
    least, when, nn, ne, nd, t = math.INFINITY, 0.0, 0.0, 0.0, 0.0, 0.0
    while t < horizon:
        span = dt
        if left <= TINY:
            un, ue, ud, span = 0.0, 0.0, 0.0, horizon - t
        elif left < dt:
            span = left
        bound, _, at, dn, de, dd = period_bound(xn, xe, xd, vn, ve, vd, un, ue, ud, span, w)
        bound -= w * t
        if bound < least:
            least, when, nn, ne, nd = bound, t + at, dn, de, dd
        xn += span * (vn + 0.5 * span * un)
        xe += span * (ve + 0.5 * span * ue)
        xd += span * (vd + 0.5 * span * ud)
        vn, ve, vd, t = vn + span * un, ve + span * ue, vd + span * ud, t + span
        left -= span
    return 0.0, least, when, nn, ne, nd


def reach_clearance(m: Any, i: int, other: Any, leave: Any, dt: float, horizon: float, enough: float) -> Any:
    """Clearance of i, which leaves along `leave`, and of what turns at up to `agile`."""
    p, v, u, w, brake = m.p + 3 * i, m.v + 3 * i, m.u + 3 * i, other.agile, m.brake[i]
    xn, xe, xd = p[0] - other.p[0], p[1] - other.p[1], p[2] - other.p[2]
    first, _, _, _, _, _ = period_bound(xn, xe, xd, v[0], v[1], v[2], u[0], u[1], u[2], dt, w)
    xn += dt * (v[0] + 0.5 * dt * u[0])
    xe += dt * (v[1] + 0.5 * dt * u[1])
    xd += dt * (v[2] + 0.5 * dt * u[2])
    vn, ve, vd = v[0] + dt * u[0], v[1] + dt * u[1], v[2] + dt * u[2]
    _, after, when, nn, ne, nd = way_clearance(xn, xe, xd, vn, ve, vd, brake, m.v_max[i], w, leave, dt, horizon)
    return min(first, enough), min(after - w * dt, enough), when, nn, ne, nd


def clearance_leaving(
    p: FloatArray, v: FloatArray, u: FloatArray, w: float, e: FloatArray, brake: float, v_max: float, dt: float,
    horizon: float,
) -> tuple[float, float]:  # fmt: skip
    """Clearances in the coming period and after it of a vehicle at p that leaves along e (all (3,)) what is at 0."""
    moves = Moves(
        p=cython.address(p[0]), v=cython.address(v[0]), u=cython.address(u[0]), brake=cython.address(brake),
        v_max=cython.address(v_max),
    )  # fmt: skip
    other = Other(p=[0.0, 0.0, 0.0], v=[0.0, 0.0, 0.0], radius=0.0, growth=0.0, agile=w)
    first, after, _, _, _, _ = reach_clearance(
        cython.address(moves), 0, cython.address(other), cython.address(e[0]), dt, horizon, math.INFINITY
    )
    return first, after


def choose_directions(s: Any) -> None:
    """Write the direction in which each vehicle leaves what may turn beside it."""
    best, e = cython.declare(cython.double[3]), cython.declare(cython.double[3])
    k = 0
    while k < s.count:
        end = k + 1
        if s.constraints[k].kind == REACH:
            i, most = s.constraints[k].i, -math.INFINITY
            while end < s.count and s.constraints[end].i == i and s.constraints[end].kind in (OTHER, REACH):
                end += 1
            for number in range(DIRECTIONS + end - k):
                if number < DIRECTIONS:
                    write_direction(number, e)
                elif not _write_away(s, k + number - DIRECTIONS, e):
                    continue
                least = _least_of(s, k, end, e, most) - _hindrance(s, i, e)
                if least > most:
                    most = least
                    best[0], best[1], best[2] = e[0], e[1], e[2]
            for at in range(k, end):
                s.constraints[at].leave[0], s.constraints[at].leave[1] = best[0], best[1]
                s.constraints[at].leave[2] = best[2]
        k = end


def _write_away(s: Any, k: int, e: Any) -> bool:
    """Write the direction straight away from an aircraft that may turn; False in its place, and of what may not."""
    c = cython.address(s.constraints[k])
    other, p = cython.address(s.around.others[c.j]), s.p + 3 * c.i
    xn, xe, xd = p[0] - other.p[0], p[1] - other.p[1], p[2] - other.p[2]
    distance = math.sqrt(xn * xn + xe * xe + xd * xd)
    if c.kind != REACH or distance < TINY:
        return False
    e[0], e[1], e[2] = xn / distance, xe / distance, xd / distance
    return True


def _least_of(s: Any, begin: int, end: int, e: Any, enough: float) -> float:
    """Least m(e) - D over the aircraft of a vehicle's constraints, or something below `enough`."""
    least = math.INFINITY
    for k in range(begin, end):
        c = cython.address(s.constraints[k])
        if c.kind == REACH and least > enough:
            other, p, v = cython.address(s.around.others[c.j]), s.p + 3 * c.i, s.v + 3 * c.i
            _, after, _, _, _, _ = way_clearance(
                p[0] - other.p[0], p[1] - other.p[1], p[2] - other.p[2], v[0], v[1], v[2], s.brake[c.i], s.v_max[c.i],
                other.agile, e, s.rules.dt, s.rules.horizon,
            )  # fmt: skip
            least = min(least, after - c.required)
    return least


def _hindrance(s: Any, i: int, e: Any) -> float:
    """How much a direction counts less as another vehicle stands in it: `PEER_M` right beside, 0 from `FREE_M` on."""
    p, near, free = s.p + 3 * i, s.rules.separation + NEARBY_M, FREE_M
    if s.rules.apart:
        for j in range(s.n):
            q = s.p + 3 * j
            xn, xe, xd = q[0] - p[0], q[1] - p[1], q[2] - p[2]
            along = xn * e[0] + xe * e[1] + xd * e[2]
            aside = near * near - (xn * xn + xe * xe + xd * xd - along * along)
            if along > 0.0 and aside > 0.0 and j != i:
                free = min(free, max(along - math.sqrt(aside), 0.0))
    return PEER_M * (1.0 - free / FREE_M)


def write_direction(number: int, e: Any) -> None:
    """Write one of `DIRECTIONS`."""
    eighth, level = number % 8, 1.0
    if number == DIRECTIONS - 1:
        e[0], e[1], e[2] = 0.0, 0.0, -1.0
        return
    if number >= 8:
        level = _HALF
    e[0], e[1] = level * _NORTH[eighth], level * _NORTH[(eighth + 6) % 8]
    e[2] = 0.0 if number < 8 else -_HALF
