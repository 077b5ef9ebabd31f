"""Acceleration that is safe whatever ways peers choose by themselves [choice].

Vehicles that filter different numbers, because their radios lose others, find different ways for each other. Each may
brake at any time. So no vehicle takes more than half of the distance that is to spare towards a peer that brakes. With
m the braking clearance (docs/model/safety.md#safety-filter) of vehicle and peer, u_b braking, D the distance required,

    m(u, peer brakes) >= min(m_b, (m_b + D) / 2),    m_b = m(u_b, peer brakes)

A peer of which nothing came for some periods may have braked in all of them. Both halves together leave D. u_b always
satisfies it, so that there is always an answer. NED, SI units.
"""

from __future__ import annotations

import numpy as np

from simvehicle.autopilot.vectors import Vec3
from skytender.geometry import COLUMNS
from skytender.safety.braking_clearance import FloatArray, IntArray, braking
from skytender.safety.safety_constraints import PAIR, clearances

SHARES = (1.0, 0.75, 0.5, 0.25)
"""Looked at, of the way from braking to the acceleration that is wanted."""
UNCHANGED_M, ENOUGH_M = 1e-6, 3.0
"""Beyond D from which a distance is not looked at: no period takes as much as half of it."""
_NOTHING_ELSE = (np.zeros((1, 8)), np.zeros((1, COLUMNS)), np.zeros((1, 6)))


def sure_acceleration(
    u_ned: FloatArray, p_ned: FloatArray, v_ned: FloatArray, brake_m_s2: FloatArray, required_m: FloatArray, dt: float
) -> Vec3:
    """The nearest to u (3,) of the first of n vehicles at p with velocities v (n, 3), which brake by brake_m_s2 (n,).

    required_m (n - 1,): D to each of the others; dt: the coming period.
    """
    n, enough_m = len(p_ned), float(required_m.max()) + ENOUGH_M
    pairs = np.array([(PAIR, 0, row) for row in range(1, n)], np.int64).reshape(-1, 3)
    rows = zip(v_ned.tolist(), brake_m_s2.tolist(), strict=True)
    u = np.array([braking(v[0], v[1], v[2], brake, dt) for v, brake in rows])
    stops = u[0].copy()
    braked_m = _least(pairs, enough_m, p_ned, v_ned, u, brake_m_s2, dt)
    least_m = np.minimum(braked_m, 0.5 * (braked_m + required_m)) - UNCHANGED_M
    for share in SHARES:
        u[0] = stops + share * (u_ned - stops)
        if (_least(pairs, enough_m, p_ned, v_ned, u, brake_m_s2, dt) >= least_m).all():
            return float(u[0, 0]), float(u[0, 1]), float(u[0, 2])
    return float(stops[0]), float(stops[1]), float(stops[2])


def braked(p_ned: Vec3, v_ned: Vec3, brake_m_s2: float, dt: float, periods: int) -> tuple[Vec3, Vec3]:
    """Place and velocity after so many periods of braking."""
    for _ in range(periods):
        u_ned = braking(*v_ned, brake_m_s2, dt)
        n, e, d = (p + dt * (v + 0.5 * dt * u) for p, v, u in zip(p_ned, v_ned, u_ned, strict=True))
        vn, ve, vd = (v + dt * u for v, u in zip(v_ned, u_ned, strict=True))
        p_ned, v_ned = (n, e, d), (vn, ve, vd)
    return p_ned, v_ned


def _least(
    pairs: IntArray,
    enough_m: float,
    p_ned: FloatArray,
    v_ned: FloatArray,
    u_ned: FloatArray,
    brake_m_s2: FloatArray,
    dt: float,
) -> FloatArray:
    """Clearance of each pair, m."""
    found: FloatArray = clearances(pairs, enough_m, p_ned, v_ned, u_ned, brake_m_s2, *_NOTHING_ELSE, dt, dt)
    return found[:, :2].min(axis=1)
