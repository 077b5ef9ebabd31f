"""Leaving traffic that may turn any way. Ways are followed densely in numpy, and pursuers do their worst."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from skytender.safety.intruders import SQUEEZED_M
from skytender.safety.leaving import clearance_leaving
from skytender.safety.safety_filter import FilterSettings, Leaders, Others, filter_step

DT, RULES, A, MARGIN = 0.1, FilterSettings(), 4.0, 0.1
B = 0.8 * A
seeds = st.integers(0, 2**32 - 1)
fixed = settings(derandomize=True, deadline=None, max_examples=30, database=None)


def unit(x):
    return x / np.linalg.norm(x)


def kernel(p, v, u, q, w, e, fastest=99.0):
    return clearance_leaving(p - q, v, u, w, e, B, fastest, DT, RULES.horizon_s)


@fixed
@given(seeds)
def test_straight_away_the_clearance_is_the_closed_form(seed):
    rng = np.random.default_rng(seed)
    w, p, v = rng.uniform(0.5, 3), rng.normal(size=3) * 4, rng.normal(size=3)
    v = unit(p) * rng.uniform(-2, 1)  # on the line of sight, so that the bound |Δ| >= n·Δ is exact
    away_m, speed = np.linalg.norm(p) + DT * (unit(p) @ v), unit(p) @ v
    if away_m < 4:
        return
    expected = away_m - w * DT - max(w - speed, 0.0) ** 2 / (2 * B)
    after = kernel(p, v, np.zeros(3), np.zeros(3), w, unit(p))[1]
    assert after == pytest.approx(expected, abs=1e-6)


@fixed
@given(seeds)
def test_the_clearance_is_the_least_distance_of_the_way_and_no_greater(seed):
    rng = np.random.default_rng(seed)
    w, e = rng.uniform(0.5, 3), unit(rng.normal(size=3))
    p, v, u, fastest = rng.normal(size=3) * 4, rng.normal(size=3), rng.normal(size=3), rng.uniform(3, 6)
    t, end, from_ = np.linspace(0, RULES.horizon_s, 2000)[:, None], p + DT * v + DT * DT / 2 * u, v + DT * u
    turn = fastest * e - from_
    turned = np.minimum(t, np.linalg.norm(turn) / B)  # so long its velocity changes
    on = end + t * from_ + B * unit(turn) * turned * (t - turned / 2)
    least = float((np.linalg.norm(on, axis=1) - w * (t[:, 0] + DT)).min())
    after = kernel(p, v, u, np.zeros(3), w, e, fastest)[1]
    assert after <= least + 1e-9
    assert after >= least - B * DT * DT / 8 - w * 0.1 - 0.02


@fixed
@given(seeds)
def test_a_period_of_leaving_never_lowers_it_whatever_the_other_does(seed):
    rng = np.random.default_rng(seed)
    w, p, v, q, e = rng.uniform(0.5, 3), rng.normal(size=3) * 3, rng.normal(size=3) * 0.5, np.zeros(3), None
    e = unit(p)
    last = -math.inf
    for _ in range(12):
        now = min(kernel(p, v, B * e, q, w, e))
        assert now >= last - 1e-9
        p, v, last = p + DT * v + DT * DT / 2 * B * e, v + DT * B * e, now
        q = q + w * DT * unit(p - q if rng.random() < 0.5 else rng.normal(size=3))


def test_what_leads_aside_into_another_aircraft_is_braked_too():
    """Row 198 of the campaign `turning`, seed 20261211: 1.17 times as fast as one aircraft, on its way to another."""
    v, east = np.array([1.27, -1.16, 0.0]), np.array([0.0, 1.0, 0.0])
    one, other = np.array([1.4, 1.5, 0.0]), np.array([-4.0, -0.7, 1.9])
    for p in (one, other):
        assert kernel(p, v, np.zeros(3), np.zeros(3), 1.49, east, fastest=1.74)[1] > 0.0


def chased(p, pursuers, w, fast, periods=150):
    """Least distance between vehicles at p (n, 3) that hover and pursuers that fly at the nearest of them."""
    home, v, q, nearest = p.copy(), np.zeros_like(p), np.array(pursuers, float), math.inf
    apart = math.inf
    for _ in range(periods):
        out = filter_step(
            Leaders(np.arange(len(p)), p, v, fast, A, MARGIN), np.clip(home - p, -1, 1), rules=RULES,
            others=Others(q, np.zeros_like(q), 0.8, 0.0, w),
        )  # fmt: skip
        for s in np.linspace(0, DT, 5):
            at = p + s * v + s * s / 2 * out.u_ned
            away = at[None] - q[:, None]
            nearest = min(nearest, float(np.linalg.norm(away, axis=2).min()) - w * s)
            apart = min(apart, float((np.linalg.norm(at[None] - at[:, None], axis=2) + 99 * np.eye(len(p))).min()))
        p, v = out.p_next_ned, out.v_next_ned
        for k in range(len(q)):
            near = p[np.argmin(np.linalg.norm(p - q[k], axis=1))]
            q[k] += min(w * DT, np.linalg.norm(near - q[k])) * unit(near - q[k] + 1e-9)
    return nearest, apart


@pytest.mark.parametrize("seed", range(3))
def test_who_hovers_outruns_one_that_flies_at_it(seed):
    rng = np.random.default_rng(seed)
    w = rng.uniform(1, 3)
    side = unit(rng.normal(size=3) * (1, 1, 0.3))
    nearest, _ = chased(np.array([[0.0, 0, -9]]), [np.array([0.0, 0, -9]) + 9 * side], w, w / 0.9)
    assert nearest >= 0.8 + MARGIN - 0.02


@pytest.mark.parametrize("seed", range(3))
def test_between_two_that_come_from_opposite_sides_it_leaves_aside_in_time(seed):
    rng = np.random.default_rng(seed)
    w, side = rng.uniform(1, 2.5), unit(rng.normal(size=3) * (1, 1, 0.2))
    nearest, _ = chased(np.array([[0.0, 0, -9]]), [[0, 0, -9] + 9 * side, [0, 0, -9] - 9 * side], w, 5.0)
    assert nearest >= 0.8 + MARGIN - SQUEEZED_M


@pytest.mark.parametrize("seed", range(3))
def test_a_ring_opens_and_stays_apart(seed):
    rng = np.random.default_rng(seed)
    angle = np.arange(8) / 8 * 2 * math.pi
    ring = np.column_stack([2 * np.cos(angle), 2 * np.sin(angle), np.full(8, -9.0)])
    nearest, apart = chased(ring, [[9.0, rng.normal(), -9]], 2.5, 4.0)
    assert apart >= RULES.separation_m + 2 * MARGIN - 1e-6
    assert nearest >= 0.8 + MARGIN - SQUEEZED_M
