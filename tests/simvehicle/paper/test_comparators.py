"""Truth: what each law's theory says of its limits, the implicit law in the limit of small steps, and scipy."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from simvehicle.law import differentiator
from simvehicle.paper import comparators


def explicit(x, v, dt_s):
    return np.array(comparators.explicit(*x, v, dt_s, 0.04))


def sliding_mode(x, v, dt_s):
    return np.array(comparators.sliding_mode(x[0], x[1], v, dt_s, 18.0, 6.0))


def high_gain(x, v, dt_s):
    return np.array(comparators.high_gain(*x, v, dt_s, 1.0, 2.0, 0.15))


def follow(step, signal, dt_s, width):
    x, rows = np.zeros(width), []
    for v in signal:
        x = step(x, v, dt_s)
        rows.append(x)
    return np.array(rows)


def test_the_explicit_law_becomes_the_implicit_one_as_the_step_goes_to_zero():
    apart = []
    for dt_s in (4e-4, 2e-4, 1e-4):
        t = dt_s * np.arange(1, round(1.0 / dt_s) + 1)
        signal = np.sin(t)
        x = np.zeros(3)
        for v in signal:
            x = differentiator.step(x, v, dt_s, epsilon=0.04)
        apart.append(np.abs(follow(explicit, signal, dt_s, 3)[-1, :2] - x[:2]).max())
    assert apart[2] < 1e-3
    assert apart[2] < apart[1] < apart[0]


def test_the_explicit_law_agrees_with_an_adaptive_solver():
    """Far from zero, where the powers are smooth: a signal that runs ahead."""

    def rate(_, x):
        a = x[0] - 5.0 + math.copysign(abs(0.04 * x[1]) ** (9 / 7), x[1])
        power = 2.0**0.6 * 4.0 * math.copysign(abs(a) ** (1 / 3), a)
        return [x[1], x[2], -(power + 4.0 * math.copysign(abs(0.04**2 * x[2]) ** 0.6, x[2])) / 0.04**3]

    start = np.array([0.0, 1.0, 50.0])
    truth = solve_ivp(rate, (0.0, 0.02), start, method="DOP853", rtol=1e-11, atol=1e-12).y[:, -1]
    errors = []
    for steps in (2000, 4000):
        x = start
        for _ in range(steps):
            x = explicit(x, 5.0, 0.02 / steps)
        errors.append(np.abs(x - truth).max() / np.abs(truth).max())
    assert errors[1] < 1e-3
    assert errors[0] / errors[1] == pytest.approx(2.0, abs=0.1)


def test_sliding_mode_errors_have_the_orders_that_levant_proved():
    """Sampled at h: the signal's error falls as h², the derivative's as h (Levant 1998, Theorem 3)."""
    errors = []
    for dt_s in (4e-3, 1e-3):
        t = dt_s * np.arange(1, round(6.0 / dt_s) + 1)
        x = follow(sliding_mode, np.sin(t), dt_s, 3)[t > 3.0]
        errors.append((np.abs(x[:, 0] - np.sin(t[t > 3.0] + dt_s)).max(), np.abs(x[:, 2] - np.cos(t[t > 3.0])).max()))
    orders = np.log(np.divide(*errors)) / np.log(4.0)
    assert orders == pytest.approx([2.0, 1.0], abs=0.25)


def test_sliding_mode_s_output_drives_its_estimate_and_its_integral_moves_at_alpha():
    rng = np.random.default_rng(2)
    for x, u1, v in rng.normal(size=(50, 3)):
        after = sliding_mode((x, u1, 0.0), v, 0.01)
        assert after[0] - x == pytest.approx(0.01 * after[2], abs=1e-15)
        assert abs(after[1] - u1) == pytest.approx(0.01 * 18.0)
        assert (after[1] - u1) * (x - v) < 0.0


def test_the_linear_law_on_a_sine_ends_on_its_frequency_response():
    dt_s = 1e-4
    t = dt_s * np.arange(1, 60_001)
    x = follow(high_gain, np.sin(t), dt_s, 2)
    a = np.array([[-1.0 / 0.15, 1.0], [-2.0 / 0.15**2, 0.0]])
    b = np.array([1.0 / 0.15, 2.0 / 0.15**2])
    response = np.linalg.solve(1j * np.eye(2) - a, b)
    late = t > 4.0
    assert x[late] == pytest.approx((response * np.exp(1j * (t[late] + dt_s))[:, np.newaxis]).imag, abs=1e-3)


def test_the_linear_law_from_rest_follows_the_matrix_exponential():
    dt_s = 1e-5
    x = np.array([1.0, -2.0])
    for _ in range(10_000):
        x = high_gain(x, 0.0, dt_s)
    a = np.array([[-1.0 / 0.15, 1.0], [-2.0 / 0.15**2, 0.0]])
    assert x == pytest.approx(expm(0.1 * a) @ [1.0, -2.0], abs=2e-3)


@pytest.mark.parametrize(("step", "width"), [(explicit, 3), (sliding_mode, 3), (high_gain, 2)])
def test_mirrored_signals_mirror(step, width):
    rng = np.random.default_rng(4)
    for x, v in zip(rng.normal(size=(10, width)), rng.normal(size=10), strict=True):
        mirrored = -step(-x, -v, 0.004)
        assert step(x, v, 0.004).tolist() == mirrored.tolist()
