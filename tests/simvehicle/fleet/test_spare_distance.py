"""Vehicles that know nothing of the wishes of others, or of whom they see, keep apart by halves of what is spare."""

from __future__ import annotations

import numpy as np

from simvehicle.fleet.spare_distance import sure_acceleration

DT, BRAKE, REQUIRED_M = 0.1, 3.2, 1.0


def test_vehicles_that_wish_at_random_and_choose_by_themselves_stay_apart() -> None:
    """By the places alone: four double integrators in a box of 3 m that is 1.7 times as wide as what they keep."""
    rng = np.random.default_rng(1)
    p = np.array([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.5], [2.0, 2.0, -0.5]])
    v, wish, nearest_m = np.zeros((4, 3)), np.zeros((4, 3)), np.inf
    brakes, required_m = np.full(4, BRAKE), np.full(3, REQUIRED_M)
    for tick in range(600):
        if tick % 10 == 0:
            wish = rng.uniform(-3.0, 3.0, (4, 3)) - (p - 1.0)
        u = np.empty((4, 3))
        for i in range(4):
            order = [i, *(j for j in range(4) if j != i)]
            wanted = (wish[i] - v[i]) / DT
            wanted *= min(1.0, 4.0 / max(float(np.linalg.norm(wanted)), 1e-9))
            u[i] = sure_acceleration(wanted, p[order], v[order], brakes, required_m, DT)
        for share in (0.25, 0.5, 0.75, 1.0):
            t = share * DT
            q = p + t * v + 0.5 * t * t * u
            nearest_m = min(nearest_m, *(float(np.linalg.norm(q[i] - q[j])) for i in range(4) for j in range(i)))
        p, v = p + DT * v + 0.5 * DT * DT * u, v + DT * u
    assert REQUIRED_M - 0.05 <= nearest_m < 2.0 * REQUIRED_M
