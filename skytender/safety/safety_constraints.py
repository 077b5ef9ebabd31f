"""Constraints of the safety filter: clearance, linear form, and limits of acceleration and speed.

A constraint has a kind, a vehicle i and j, with what: the row of another vehicle, of the others, of the obstacle table,
or a wall 0-5. Only of a pair both sides move.
"""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.skytender.geometry import shape_at
from cython.cimports.skytender.safety.braking_clearance import (
    TINY,
    other_clearance,
    pair_clearance,
    plane_clearance,
    sensitivity,
    shape_clearance,
)
from cython.cimports.skytender.safety.constraints import Constraint, Moves, Other, Surroundings
from cython.cimports.skytender.safety.leaving import reach_clearance
from cython.cimports.skytender.safety.safety_constraints import OBSTACLE, OTHER, PAIR, REACH

from skytender.safety.braking_clearance import FloatArray, IntArray

PLANE: int
GOLDEN = 0.6180339887498949
_PLASTIC = 0.7548776662466927  # irrational, too, so that pairs of ids get different directions
_LIMIT_SWEEPS = 4


def clearance_of(c: Any, enough: float, m: Any, around: Any) -> Any:
    """Clearance of a constraint, cut off at `enough`, as braking_clearance.py gives it."""
    if c.kind == PAIR:
        return pair_clearance(m, c.i, c.j, around.dt, enough)
    if c.kind == OTHER:
        return other_clearance(m, c.i, cython.address(around.others[c.j]), around.dt, around.horizon, enough)
    if c.kind == REACH:
        other = cython.address(around.others[c.j])
        return reach_clearance(m, c.i, other, c.leave, around.dt, around.horizon, enough)
    if c.kind == OBSTACLE:
        return shape_clearance(m, c.i, cython.address(around.shapes[c.j]), around.dt, enough)
    return plane_clearance(m, c.i, c.j, around.walls[6 * c.i + c.j], around.dt)


def clearances(
    rows: IntArray, enough: float, p: FloatArray, v: FloatArray, u: FloatArray, brake: FloatArray, others: FloatArray,
    table: FloatArray, walls: FloatArray, dt: float, horizon: float,
) -> FloatArray:  # fmt: skip
    """Clearances (k, 6) of constraints (kind, i, j), rows (k, 3), with vehicles at p (n, 3).

    v, u: (n, 3); brake: (n,); others: (m, 9) place, velocity, radius, its growth, agility; walls: (n, 6). No kind is
    REACH, which leaving.py measures.
    """
    moves = Moves(
        p=cython.address(p[0, 0]), v=cython.address(v[0, 0]), u=cython.address(u[0, 0]),
        brake=cython.address(brake[0]), v_max=cython.NULL,
    )  # fmt: skip
    around = Surroundings(
        others=cython.cast(cython.pointer(Other), cython.address(others[0, 0])),
        shapes=shape_at(table, 0),
        walls=cython.address(walls[0, 0]),
        dt=dt,
        horizon=horizon,
    )
    c = cython.declare(Constraint)
    array = np.empty((len(rows), 6))
    found = array
    for k in range(rows.shape[0]):
        c.kind, c.i, c.j = rows[k, 0], rows[k, 1], rows[k, 2]
        first, after, when, nn, ne, nd = clearance_of(
            cython.address(c), enough, cython.address(moves), cython.address(around)
        )
        found[k, 0], found[k, 1], found[k, 2] = first, after, when
        found[k, 3], found[k, 4], found[k, 5] = nn, ne, nd
    return array


def into_ball(u: Any, cn: float, ce: float, cd: float, radius: float) -> None:
    dn, de, dd = u[0] - cn, u[1] - ce, u[2] - cd
    size = math.sqrt(dn * dn + de * de + dd * dd)
    if size > radius:
        k = radius / size
        u[0], u[1], u[2] = cn + k * dn, ce + k * de, cd + k * dd


def into_limits(u: Any, v: Any, u_b: Any, a_max: float, v_top: float, dt: float) -> None:
    """Bring an acceleration into both balls: nearly the nearest, and in the end between there and braking."""
    for _ in range(_LIMIT_SWEEPS):
        into_ball(u, -v[0] / dt, -v[1] / dt, -v[2] / dt, v_top / dt)
        into_ball(u, 0.0, 0.0, 0.0, a_max)
    a = b = c = 0.0
    for x in range(3):
        start = v[x] + dt * u_b[x]
        more = dt * (u[x] - u_b[x])
        a += more * more
        b += 2.0 * start * more
        c += start * start
    c -= v_top * v_top
    if a + b + c > 0.0 and a > 0.0:
        share = min(max((-b + math.sqrt(max(b * b - 4.0 * a * c, 0.0))) / (2.0 * a), 0.0), 1.0)
        for x in range(3):
            u[x] = u_b[x] + share * (u[x] - u_b[x])


def part_of_turn(x: float) -> float:
    """x modulo 1."""
    return x - math.floor(x)


def descent_of(sysid: int) -> float:
    """Share, from -1 (up) to 1 (down), by which a vehicle that cannot have what it wants evades up or down [choice]."""
    return 2.0 * part_of_turn(sysid * GOLDEN) - 1.0


def write_line(c: Any, after: float, when: float, nn: float, ne: float, nd: float, m: Any, dt: float, ids: Any) -> bool:
    """Write the linear constraint  A_i·u_i + A_j·u_j >= r;  False where nothing can be done."""
    u, v = m.u + 3 * c.i, m.v + 3 * c.i
    if nn == 0.0 and ne == 0.0 and nd == 0.0:  # in the same place: a direction by id, the same one in every period
        other = ids[c.j] if c.kind == PAIR else c.j
        turn = 2.0 * math.M_PI * part_of_turn(ids[c.i] * GOLDEN + other * _PLASTIC)
        ne, nn = elementary.sin_cos(turn)
        nd = 0.0
    vn, ve, vd = v[0] + dt * u[0], v[1] + dt * u[1], v[2] + dt * u[2]
    t, way = -1.0, when
    if c.kind <= OTHER:
        t, way = when, -1.0
    if c.kind == REACH:
        scale = 0.5 * dt * dt + dt * max(when, 0.5 * dt)
        an, ae, ad = scale * nn, scale * ne, scale * nd
    else:
        an, ae, ad = sensitivity(vn, ve, vd, m.brake[c.i], t, way, nn, ne, nd, dt)
    c.a[0], c.a[1], c.a[2] = an, ae, ad
    c.b[0] = c.b[1] = c.b[2] = 0.0
    c.r = c.target - after + an * u[0] + ae * u[1] + ad * u[2]
    c.square = an * an + ae * ae + ad * ad
    if c.kind == PAIR:
        u, v = m.u + 3 * c.j, m.v + 3 * c.j
        vn, ve, vd = v[0] + dt * u[0], v[1] + dt * u[1], v[2] + dt * u[2]
        an, ae, ad = sensitivity(vn, ve, vd, m.brake[c.j], t, way, -nn, -ne, -nd, dt)
        c.b[0], c.b[1], c.b[2] = an, ae, ad
        c.r += an * u[0] + ae * u[1] + ad * u[2]
        c.square += an * an + ae * ae + ad * ad
    return c.square > TINY * TINY
