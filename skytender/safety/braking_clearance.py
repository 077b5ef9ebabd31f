"""Braking clearance: how near a vehicle comes to something when it flies one more period and then brakes to a stand.

A vehicle at p with velocity v flies one period T with a constant acceleration u and then *brakes*: in every further
period with  u = -b v/|v|,  and in the last one, where |v| <= b T, with  u = -v/T, so that it stands exactly. The way
is a straight line; a braking vehicle that is asked again a period later brakes along the rest of the same way. The
clearance m is the least distance on the way, so brakes never lower it (docs/model/safety.md#safety-filter):

    m(state after a period of braking) >= m(state)                                                            (1)

Pairs of braking vehicles are followed period by period in relative motion, others with constant velocity. In a period
the distance |Δ(t)|, Δ(t) = Δ + Δ' t + Δu t²/2, is bounded from below by the largest of

    |chord(t)| - |Δu| T²/8,    0    and    min over t of n·Δ(t),   n the direction at the chord's nearest point   (2)

Each bound depends on its period alone, so that (1) holds for the bounds too. The distance to a shape is convex along a
straight line; its least value is enclosed by tangents. [lineage] of barriers made of braking: Wang, Ames, Egerstedt,
Safety barrier certificates for collisions-free multirobot systems, IEEE T-RO 33(3), 2017; of braking as a contingency
that is checked ahead: Fraichard, Asama, Inevitable collision states, Advanced Robotics 18(10), 2004. Form [choice].

Frames NED, SI units. Functions take the moves of n vehicles and row numbers. A clearance is a tuple:
in the coming period, after it, when after its end in s, and the direction (n, e, d) to where the distance grows.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from cython.cimports.libc import math
from cython.cimports.skytender.geometry import BOX, CYLINDER, WALL, past_wall, shape_surface
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

TINY = 1e-12
_GAP_M = 1e-10  # between the tangents and the distance: small against the filter's tolerance
_TANGENTS = 60


def braking(vn: float, ve: float, vd: float, brake: float, dt: float) -> tuple[float, float, float]:
    """Acceleration of one period of braking."""
    speed = math.sqrt(vn * vn + ve * ve + vd * vd)
    k = 1.0 / dt if speed <= brake * dt else brake / speed
    return -k * vn, -k * ve, -k * vd


def stop_distance(speed: float, brake: float, dt: float) -> float:
    """Upper bound of the way to a stand; the exact one is at most brake dt²/8 shorter."""
    return speed * speed / (2.0 * brake) + brake * dt * dt / 8.0


def stop_way(speed: float, brake: float, dt: float) -> float:
    """Way to a stand, exactly: whole periods of braking and the last, shorter one."""
    whole = math.ceil(speed / (brake * dt)) - 1.0
    rest = speed - max(whole, 0.0) * brake * dt
    return (speed * speed - rest * rest) / (2.0 * brake) + 0.5 * rest * dt


def period_bound(
    an: float, ae: float, ad: float, bn: float, be: float, bd: float, cn: float, ce: float, cd: float,
    span: float, growth: float,
) -> Any:  # fmt: skip
    """Lower bound (2) of |a + b t + c t²/2| - growth t for 0 <= t <= span: (bound, chord's value, t, direction)."""
    en, ee, ed = bn + 0.5 * cn * span, be + 0.5 * ce * span, bd + 0.5 * cd * span
    square = en * en + ee * ee + ed * ed
    along = an * en + ae * ee + ad * ed
    if square < TINY * TINY:
        t = span if growth > 0.0 else 0.0
    elif growth > 0.0 and growth * growth >= square:
        t = span
    else:
        t = -along / square
        if growth > 0.0:
            aside = max(an * an + ae * ae + ad * ad - along * along / square, 0.0)
            t += growth * math.sqrt(aside / (square * (square - growth * growth)))
        t = min(max(t, 0.0), span)
    xn, xe, xd = an + en * t, ae + ee * t, ad + ed * t
    distance = math.sqrt(xn * xn + xe * xe + xd * xd)
    bound = distance - growth * t - 0.125 * span * span * math.sqrt(cn * cn + ce * ce + cd * cd)
    bound = max(bound, -growth * span)
    if distance < TINY:
        return bound, distance - growth * t, t, 0.0, 0.0, 0.0
    xn, xe, xd = xn / distance, xe / distance, xd / distance
    a, b, c = xn * an + xe * ae + xd * ad, xn * bn + xe * be + xd * bd - growth, xn * cn + xe * ce + xd * cd
    return max(bound, _least(a, b, c, span)), distance - growth * t, t, xn, xe, xd


def _least(a: float, b: float, c: float, span: float) -> float:
    """Least value of a + b t + c t²/2 for 0 <= t <= span."""
    least = min(a, a + b * span + 0.5 * c * span * span)
    if c > 0.0 and b < 0.0 and -b < c * span:
        least = min(least, a - 0.5 * b * b / c)
    return least


def pair_clearance(m: Any, i: int, j: int, dt: float, enough: float) -> Any:
    """Least distance of i and j in the coming period, and after it with both braking; both cut at `enough`."""
    p, q, v, w, a, b = m.p + 3 * i, m.p + 3 * j, m.v + 3 * i, m.v + 3 * j, m.u + 3 * i, m.u + 3 * j
    xn, xe, xd = p[0] - q[0], p[1] - q[1], p[2] - q[2]
    vin, vie, vid, vjn, vje, vjd = v[0], v[1], v[2], w[0], w[1], w[2]
    uin, uie, uid, ujn, uje, ujd = a[0], a[1], a[2], b[0], b[1], b[2]
    first, after, when, nn, ne, nd, t = enough, enough, 0.0, 0.0, 0.0, 0.0, -dt
    bi, bj = m.brake[i], m.brake[j]
    while True:
        an, ae, ad = uin - ujn, uie - uje, uid - ujd
        bn, be, bd = vin - vjn, vie - vje, vid - vjd
        bound, _, at, dn, de, dd = period_bound(xn, xe, xd, bn, be, bd, an, ae, ad, dt, 0.0)
        if t < 0.0:
            first = min(bound, enough)
        elif bound < after:
            after, when, nn, ne, nd = bound, t + at, dn, de, dd
        xn += dt * (bn + 0.5 * dt * an)
        xe += dt * (be + 0.5 * dt * ae)
        xd += dt * (bd + 0.5 * dt * ad)
        t += dt
        vin, vie, vid = vin + dt * uin, vie + dt * uie, vid + dt * uid
        vjn, vje, vjd = vjn + dt * ujn, vje + dt * uje, vjd + dt * ujd
        si = math.sqrt(vin * vin + vie * vie + vid * vid)
        sj = math.sqrt(vjn * vjn + vje * vje + vjd * vjd)
        if si < TINY and sj < TINY:
            distance = math.sqrt(xn * xn + xe * xe + xd * xd)
            if distance < after:
                after, when = distance, t
                if distance >= TINY:
                    nn, ne, nd = xn / distance, xe / distance, xd / distance
            break
        left = stop_distance(si, bi, dt) + stop_distance(sj, bj, dt)
        if math.sqrt(xn * xn + xe * xe + xd * xd) - left >= after:
            break
        uin, uie, uid = braking(vin, vie, vid, bi, dt)
        ujn, uje, ujd = braking(vjn, vje, vjd, bj, dt)
    return first, after, when, nn, ne, nd


def other_clearance(m: Any, i: int, other: Any, dt: float, horizon: float, enough: float) -> Any:
    """The same of i and of another, which flies straight on; its growth per second times t is taken off."""
    p, v, u, brake = m.p + 3 * i, m.v + 3 * i, m.u + 3 * i, m.brake[i]
    wn, we, wd, growth = other.v[0], other.v[1], other.v[2], other.growth
    xn, xe, xd = p[0] - other.p[0], p[1] - other.p[1], p[2] - other.p[2]
    vn, ve, vd, un, ue, ud = v[0], v[1], v[2], u[0], u[1], u[2]
    first, after, when, nn, ne, nd, t = enough, enough, 0.0, 0.0, 0.0, 0.0, -dt
    while True:
        stands = t >= 0.0 and un == 0.0 and ue == 0.0 and ud == 0.0
        span = max(horizon - t, dt) if stands else dt
        bound, _, at, dn, de, dd = period_bound(xn, xe, xd, vn - wn, ve - we, vd - wd, un, ue, ud, span, growth)
        bound -= growth * (t + dt)
        if t < 0.0:
            first = min(bound, enough)
        elif bound < after:
            after, when, nn, ne, nd = bound, t + at, dn, de, dd
        t += span
        if stands or t >= horizon:
            break
        xn += dt * (vn - wn + 0.5 * dt * un)
        xe += dt * (ve - we + 0.5 * dt * ue)
        xd += dt * (vd - wd + 0.5 * dt * ud)
        vn, ve, vd = vn + dt * un, ve + dt * ue, vd + dt * ud
        if vn * vn + ve * ve + vd * vd < TINY * TINY:
            vn = ve = vd = 0.0
        un, ue, ud = braking(vn, ve, vd, brake, dt)
    return first, after, when, nn, ne, nd


def _segment(shape: Any, n0: float, e0: float, d0: float, n1: float, e1: float, d1: float, enough: float) -> Any:
    """Least distance from a straight line to a shape's surface: (lower bound, value, share of the line, direction)."""
    mn, me, md = n1 - n0, e1 - e0, d1 - d0
    length = math.sqrt(mn * mn + me * me + md * md)
    if shape.kind == WALL:
        value, share, gn, ge = past_wall(shape, n0, e0, n1, e1)
        return value, value, share, gn, ge, 0.0
    low_value, gn, ge, gd = shape_surface(shape, n0, e0, d0)
    if low_value - length >= enough or length < TINY:
        return low_value - length, low_value, 0.0, gn, ge, gd
    if shape.kind not in (BOX, CYLINDER):  # about a point the nearest place is known
        along = (shape.north - n0) * mn + (shape.east - e0) * me + (shape.down - d0) * md
        share = min(max(along / (length * length), 0.0), 1.0)
        value, gn, ge, gd = shape_surface(shape, n0 + share * mn, e0 + share * me, d0 + share * md)
        return value, value, share, gn, ge, gd
    low_slope = gn * mn + ge * me + gd * md
    if low_slope >= 0.0:
        return low_value, low_value, 0.0, gn, ge, gd
    high_value, hn, he, hd = shape_surface(shape, n1, e1, d1)
    high_slope = hn * mn + he * me + hd * md
    if high_slope <= 0.0:
        return high_value, high_value, 1.0, hn, he, hd
    low, high = 0.0, 1.0
    bound, value, share = low_value, low_value, 0.0
    for _ in range(_TANGENTS):
        share = (high_value - low_value + low * low_slope - high * high_slope) / (low_slope - high_slope)
        share = min(max(share, low), high)
        bound = low_value + low_slope * (share - low)
        value, gn, ge, gd = shape_surface(shape, n0 + share * mn, e0 + share * me, d0 + share * md)
        if value - bound <= _GAP_M:
            break
        slope = gn * mn + ge * me + gd * md
        if slope < 0.0:
            low, low_value, low_slope = share, value, slope
        else:
            high, high_value, high_slope = share, value, slope
            if slope == 0.0:
                bound = value
                break
    return min(bound, value), value, share, gn, ge, gd


def shape_clearance(m: Any, i: int, shape: Any, dt: float, enough: float) -> Any:
    """The same of i and of a shape's surface; instead of when, the way from the period's end to the nearest place.

    That way is -1 where the nearest place is the stand.
    """
    p, v, u, brake = m.p + 3 * i, m.v + 3 * i, m.u + 3 * i, m.brake[i]
    half = 0.5 * dt * dt
    vn, ve, vd = v[0] + dt * u[0], v[1] + dt * u[1], v[2] + dt * u[2]
    n0, e0, d0 = p[0], p[1], p[2]
    n1, e1, d1 = n0 + dt * v[0] + half * u[0], e0 + dt * v[1] + half * u[1], 0.0
    d1 = d0 + dt * v[2] + half * u[2]
    # The curve leaves its chord by no more than this. A braking one lies on it, and (1) needs that to be seen exactly.
    mn, me, md = n1 - n0, e1 - e0, d1 - d0
    square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2]
    length = math.sqrt(mn * mn + me * me + md * md)
    if v[0] * mn + v[1] * me + v[2] * md >= 0.0 and vn * mn + ve * me + vd * md >= 0.0 and length > TINY:
        square -= ((u[0] * mn + u[1] * me + u[2] * md) / length) ** 2
    bow = 0.25 * half * math.sqrt(max(square, 0.0))
    low, value, share, gn, ge, gd = _segment(shape, n0, e0, d0, n1, e1, d1, enough + bow)
    first = low - bow
    if first < enough:
        xn, xe, xd = n0 + share * (n1 - n0), e0 + share * (e1 - e0), d0 + share * (d1 - d0)
        a = value + gn * (n0 - xn) + ge * (e0 - xe) + gd * (d0 - xd)
        b = gn * v[0] + ge * v[1] + gd * v[2]
        first = max(first, _least(a, b, gn * u[0] + ge * u[1] + gd * u[2], dt))
    speed = math.sqrt(vn * vn + ve * ve + vd * vd)
    way = stop_way(speed, brake, dt)
    s = way / speed if speed > TINY else 0.0
    after, value, share, gn, ge, gd = _segment(shape, n1, e1, d1, n1 + s * vn, e1 + s * ve, d1 + s * vd, enough)
    where = -1.0 if share >= 1.0 else share * way
    return min(first, enough), min(after, enough), where, gn, ge, gd


def plane_clearance(m: Any, i: int, axis: int, limit: float, dt: float) -> Any:
    """The same of i and of a wall across `axis` at `limit`: axis 0-2 the lower side of it, 3-5 the upper one."""
    p, v, u, brake = m.p + 3 * i, m.v + 3 * i, m.u + 3 * i, m.brake[i]
    k = axis % 3
    sign = 1.0 if axis < 3 else -1.0
    vn, ve, vd = v[0] + dt * u[0], v[1] + dt * u[1], v[2] + dt * u[2]
    speed = math.sqrt(vn * vn + ve * ve + vd * vd)
    s = stop_way(speed, brake, dt) / speed if speed > TINY else 0.0
    at = p[k] + dt * (v[k] + 0.5 * dt * u[k])
    stand = at + s * (v[k] + dt * u[k])
    first = _least(sign * (p[k] - limit), sign * v[k], sign * u[k], dt)
    after = sign * (stand - limit)
    here = sign * (at - limit)
    north, east, down = sign if k == 0 else 0.0, sign if k == 1 else 0.0, sign if k == 2 else 0.0
    return first, min(here, after), -1.0, north, east, down


def sensitivity(
    vn: float, ve: float, vd: float, brake: float, t: float, way: float, nn: float, ne: float, nd: float, dt: float
) -> tuple[float, float, float]:
    """Change of n·x per acceleration of the coming period, x where a vehicle is that brakes from velocity v.

    x is at time t after the period's end, or where `way` >= 0 that far along its way; t < 0 is the stand. The braking
    way s(|v|, t) v/|v| gives  dt²/2 n + dt (∂s/∂|v| along v + s/|v| across v).
    """
    speed = math.sqrt(vn * vn + ve * ve + vd * vd)
    stop = speed / brake
    along = stop if t < 0.0 else min(t, stop)
    across = way / speed if way >= 0.0 and speed > TINY else along * (1.0 - 0.5 * along * brake / max(speed, TINY))
    least = 0.5 * (dt if t < 0.0 or t > dt or way >= 0.0 else t)
    along, across = max(along, least), max(across, least)
    scale = 0.5 * dt * dt + dt * across
    more = 0.0
    if speed > TINY:
        more = dt * (along - across) * (nn * vn + ne * ve + nd * vd) / (speed * speed)
    return scale * nn + more * vn, scale * ne + more * ve, scale * nd + more * vd
