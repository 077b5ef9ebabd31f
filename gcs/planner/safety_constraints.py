"""Constraints of the safety filter: clearance, linear form, and limits of acceleration and speed.

A constraint is a row (kind, vehicle, with what): with the row of another vehicle, of the others, of the obstacle table,
or with a wall 0-5. Only of a pair both sides move.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gcs.kernels import inner
from gcs.planner.braking_clearance import (
    TINY,
    Clearance,
    FloatArray,
    IntArray,
    other_clearance,
    pair_clearance,
    plane_clearance,
    sensitivity,
    shape_clearance,
)

BoolArray = NDArray[np.bool_]

PAIR, OTHER, OBSTACLE, PLANE = 1, 2, 3, 4
GOLDEN = 0.6180339887498949
_PLASTIC = 0.7548776662466927  # irrational, too, so that pairs of ids get different directions
_LIMIT_SWEEPS = 4


@inner(error_model="numpy")
def clearance_of(
    rows: IntArray, c: int, enough: float, p: FloatArray, v: FloatArray, u: FloatArray, brake: FloatArray,
    others: FloatArray, table: FloatArray, walls: FloatArray, dt: float, horizon: float,
) -> Clearance:  # fmt: skip
    kind, i, j = rows[c, 0], rows[c, 1], rows[c, 2]
    if kind == PAIR:
        return pair_clearance(p, v, u, brake, i, j, dt, enough)
    if kind == OTHER:
        return other_clearance(p, v, u, brake, i, others, j, dt, horizon, enough)
    if kind == OBSTACLE:
        return shape_clearance(p, v, u, brake, i, table, j, dt, enough)
    return plane_clearance(p, v, u, brake, i, j, walls[i, j], dt)


@inner(error_model="numpy")
def into_ball(u: FloatArray, i: int, cn: float, ce: float, cd: float, radius: float) -> None:
    dn, de, dd = u[i, 0] - cn, u[i, 1] - ce, u[i, 2] - cd
    size = math.sqrt(dn * dn + de * de + dd * dd)
    if size > radius:
        k = radius / size
        u[i, 0], u[i, 1], u[i, 2] = cn + k * dn, ce + k * de, cd + k * dd


@inner(error_model="numpy")
def within_limits(
    u: FloatArray, live: BoolArray, v: FloatArray, u_b: FloatArray, a_max: FloatArray, v_top: FloatArray, dt: float
) -> None:
    """Bring accelerations within both balls: nearly the nearest, and in the end between there and braking."""
    for i in range(len(u)):
        if not live[i]:
            continue
        for _ in range(_LIMIT_SWEEPS):
            into_ball(u, i, -v[i, 0] / dt, -v[i, 1] / dt, -v[i, 2] / dt, v_top[i] / dt)
            into_ball(u, i, 0.0, 0.0, 0.0, a_max[i])
        a = b = c = 0.0
        for x in range(3):
            start = v[i, x] + dt * u_b[i, x]
            more = dt * (u[i, x] - u_b[i, x])
            a += more * more
            b += 2.0 * start * more
            c += start * start
        c -= v_top[i] * v_top[i]
        if a + b + c > 0.0 and a > 0.0:
            share = min(max((-b + math.sqrt(max(b * b - 4.0 * a * c, 0.0))) / (2.0 * a), 0.0), 1.0)
            for x in range(3):
                u[i, x] = u_b[i, x] + share * (u[i, x] - u_b[i, x])


@inner(error_model="numpy")
def line_of(
    rows: IntArray, c: int, target: float, after: float, when: float, nn: float, ne: float, nd: float,
    v: FloatArray, u: FloatArray, brake: FloatArray, dt: float, ids: IntArray, line: FloatArray,
) -> bool:  # fmt: skip
    """Write the linear constraint  A_i·u_i + A_j·u_j >= r  as (A_i, A_j, r, |A|²); False where nothing can be done."""
    kind, i, j = rows[c, 0], rows[c, 1], rows[c, 2]
    if nn == 0.0 and ne == 0.0 and nd == 0.0:  # in the same place: a direction by id, the same one in every period
        turn = 2.0 * math.pi * ((ids[i] * GOLDEN + (ids[j] if kind == PAIR else j) * _PLASTIC) % 1.0)
        nn, ne, nd = math.cos(turn), math.sin(turn), 0.0
    vn, ve, vd = v[i, 0] + dt * u[i, 0], v[i, 1] + dt * u[i, 1], v[i, 2] + dt * u[i, 2]
    t, way = (when, -1.0) if kind <= OTHER else (-1.0, when)
    an, ae, ad = sensitivity(vn, ve, vd, brake[i], t, way, nn, ne, nd, dt)
    line[0], line[1], line[2] = an, ae, ad
    line[3] = line[4] = line[5] = 0.0
    line[6] = target - after + an * u[i, 0] + ae * u[i, 1] + ad * u[i, 2]
    line[7] = an * an + ae * ae + ad * ad
    if kind == PAIR:
        vn, ve, vd = v[j, 0] + dt * u[j, 0], v[j, 1] + dt * u[j, 1], v[j, 2] + dt * u[j, 2]
        an, ae, ad = sensitivity(vn, ve, vd, brake[j], t, way, -nn, -ne, -nd, dt)
        line[3], line[4], line[5] = an, ae, ad
        line[6] += an * u[j, 0] + ae * u[j, 1] + ad * u[j, 2]
        line[7] += an * an + ae * ae + ad * ad
    enabled: bool = line[7] > TINY * TINY
    return enabled
