"""Vehicles that know nothing of the wishes of others, or of whom they see, keep apart by halves of what is spare."""

from __future__ import annotations

import numpy as np
import pytest

from simvehicle.fleet.spare_distance import braked, sure_acceleration

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


def test_a_peer_of_which_nothing_came_has_braked_as_far_as_it_can_have() -> None:
    """3 m/s and 3.2 m/s²: by hand, v t - b t²/2, and a stand after v²/2b, up to b T²/8 beyond it."""
    start, v_ned = (1.0, 2.0, -5.0), (0.0, 0.0, -3.0)
    p_ned, left_ned = braked(start, v_ned, BRAKE, DT, 4)
    assert p_ned == pytest.approx((1.0, 2.0, -5.0 - (3.0 * 0.4 - 0.5 * BRAKE * 0.4**2)))
    assert left_ned == pytest.approx((0.0, 0.0, -3.0 + BRAKE * 0.4))
    p_ned, left_ned = braked(start, v_ned, BRAKE, DT, 20)
    assert p_ned[2] == pytest.approx(-5.0 - 3.0**2 / (2.0 * BRAKE), abs=BRAKE * DT**2 / 8.0)
    assert left_ned == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)
    assert braked(start, v_ned, BRAKE, DT, 0) == (start, v_ned)
