import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from simvehicle.law import differentiator

EPSILON = 0.04
H = 0.004


def sig(x, power):
    return math.copysign(abs(x) ** power, x)


def slope_of_x3(x1, x2, x3, v):
    """X3' as the paper prints it (docs/model/control.md#differentiator), for oracles: a root finder, and the explicit
    step."""
    angle = 2.0**0.6 * 4.0 * sig(x1 - v + sig(EPSILON * x2, 9 / 7), 1 / 3)
    return -(angle + 4.0 * sig(EPSILON**2 * x3, 3 / 5)) / EPSILON**3


def follow(signal, x=(0.0, 0.0, 0.0)):
    rows = []
    for v in signal:
        x = differentiator.step(x, v, H, epsilon=EPSILON)
        rows.append(x)
    return np.array(rows)


def test_five_sin_t_gives_the_published_errors():
    t = H * np.arange(1, 5001)
    x = follow(5.0 * np.sin(t))
    late = t > 3.0
    assert np.abs(x[late, 0] - 5.0 * np.sin(t[late])).max() == pytest.approx(0.126, abs=0.001)
    assert np.abs(x[late, 1] - 5.0 * np.cos(t[late])).max() == pytest.approx(0.126, abs=0.001)
    assert np.sqrt(np.mean((x[late, 2] + 5.0 * np.sin(t[late])) ** 2)) == pytest.approx(0.19, abs=0.005)


def test_a_constant_is_reached_in_finite_time():
    x = follow(np.full(500, 0.7))
    assert x[-1] == pytest.approx([0.7, 0.0, 0.0], abs=1e-9)


def test_a_ramp_gives_its_slope_and_the_bias_that_the_law_has():
    x = follow(1.5 * H * np.arange(1, 1001))
    assert x[-1, 1:] == pytest.approx([1.5, 0.0], abs=1e-6)
    assert x[-1, 0] == pytest.approx(1.5 * H * 1000 - (EPSILON * 1.5) ** (9 / 7), abs=1e-9)


@pytest.mark.parametrize("a", [0.4, -2.0])
def test_a_parabola_gives_the_bias_that_the_law_has(a):
    """With X3' = 0 the law reads X1 = v - sig(ε X2)^(9/7) - 2^(-9/5) sig(ε² X3)^(9/5); X1' = X2 and X2' = X3 follow."""
    t = H * np.arange(1, 5001)
    x1, x2, x3 = follow(0.5 * a * t**2)[-1]
    lag = sig(EPSILON * x2, 9 / 7) + 2.0**-1.8 * sig(EPSILON**2 * a, 9 / 5)
    assert 0.5 * a * t[-1] ** 2 - x1 == pytest.approx(lag, rel=2e-3)
    bias = 9 / 7 * EPSILON * abs(EPSILON * x2) ** (2 / 7) * a + 0.5 * H * a  # a step's difference is its middle's slope
    assert a * t[-1] - x2 == pytest.approx(bias, rel=5e-3)
    assert x3 == pytest.approx(a, rel=2e-3)


value = st.floats(-3.0, 3.0)


@given(value, st.floats(-20.0, 20.0), st.floats(-200.0, 200.0), value)
def test_a_mirrored_signal_is_differentiated_mirrored(x1, x2, x3, v):
    x = differentiator.step((x1, x2, x3), v, H, epsilon=EPSILON)
    mirrored = differentiator.step((-x1, -x2, -x3), -v, H, epsilon=EPSILON)
    assert mirrored == pytest.approx(-x, rel=1e-12, abs=1e-12)


@settings(max_examples=300, deadline=None)
@given(value, st.floats(-20.0, 20.0), st.floats(-200.0, 200.0), value)
@example(0.0, 0.0, 0.0, 0.0)
@example(0.0, 0.0, 0.0, 1.0)
@example(0.0, 0.0, 1e-3, 0.0)
@example(0.1, 0.0, -1e-9, 0.1)
def test_a_step_is_the_root_of_the_implicit_equation(x1, x2, x3, v):
    def residual(s):
        x2_next = x2 + H * s
        return s - x3 - H * slope_of_x3(x1 + H * x2_next, x2_next, s, v)

    reach = abs(residual(x3)) + 1e-9
    truth = brentq(residual, x3 - reach, x3 + reach, xtol=1e-13, rtol=1e-13)
    x = differentiator.step((x1, x2, x3), v, H, epsilon=EPSILON)
    assert x[2] == pytest.approx(truth, abs=1e-7, rel=1e-9)
    assert x[1] == pytest.approx(x2 + H * x[2], abs=1e-15)
    assert x[0] == pytest.approx(x1 + H * x[1], abs=1e-15)


def test_a_smooth_signal_takes_three_evaluations_a_solve():
    x, evaluations = (0.0, 0.3, 0.0), 0
    for k in range(2000):
        *x, count = differentiator.solve(*x, 0.3 * math.sin(k * H), H, EPSILON, 1e-6)
        evaluations += count
    assert evaluations / 2000 <= 3.1


@settings(max_examples=200, deadline=None)
@given(st.lists(st.floats(-1e6, 1e6), min_size=4, max_size=4), st.floats(1e-5, 0.1), st.floats(1e-3, 1.0))
def test_the_solve_ends_on_anything(x_and_signal, h, epsilon):
    *x, evaluations = differentiator.solve(*x_and_signal, h, epsilon, 1e-6)
    assert np.isfinite(x).all()
    assert evaluations < 200


def test_two_solved_together_are_the_same_bit_for_bit_as_each_alone():
    rng = np.random.default_rng(4)
    for scale in (0.0, 1e-3, 1.0):  # at once, after a few evaluations, after many
        for x, y in scale * rng.normal(size=(200, 2, 4)) * (1.0, 3.0, 30.0, 1.0):
            alone = [differentiator.solve(*given, H, EPSILON, 1e-6)[2] for given in (x, y)]
            assert differentiator.solve_two(*x, *y, H, EPSILON, 1e-6)[:2] == tuple(alone)


def test_explicit_steps_chatter_where_implicit_ones_rest():
    x1, x2, x3 = 0.1001, 0.0, 0.0
    explicit = []
    for _ in range(1000):
        x1, x2, x3 = x1 + H * x2, x2 + H * x3, x3 + H * slope_of_x3(x1, x2, x3, 0.1)
        explicit.append(x3)
    implicit = follow(np.full(1000, 0.1), (0.1001, 0.0, 0.0))[:, 2]
    assert np.sqrt(np.mean(np.square(explicit[500:]))) > 10.0
    assert np.sqrt(np.mean(np.square(implicit[500:]))) < 1e-7


def test_many_differentiators_step_as_each_alone():
    rng = np.random.default_rng(3)
    x, v = rng.normal(size=(2, 4, 3)), rng.normal(size=(2, 4))
    together = differentiator.step(x, v, H, epsilon=EPSILON)
    for index in np.ndindex(v.shape):
        assert np.array_equal(together[index], differentiator.step(x[index], v[index], H, epsilon=EPSILON))


def test_wrong_shapes_are_refused():
    with pytest.raises(ValueError, match="but need"):
        differentiator.step(np.zeros((2, 3)), 0.0, H, epsilon=EPSILON)


@pytest.mark.parametrize("epsilon", [0.0, -0.04, math.nan, math.inf])
def test_an_epsilon_that_is_not_positive_is_refused(epsilon):
    with pytest.raises(ValueError, match=r"^epsilon is .*, but it must be greater than 0 and finite"):
        differentiator.step(np.zeros(3), 0.0, H, epsilon=epsilon)
    with pytest.raises(ValueError, match=r"^dt_s is 0\.0, but"):
        differentiator.step(np.zeros(3), 0.0, 0.0, epsilon=EPSILON)
