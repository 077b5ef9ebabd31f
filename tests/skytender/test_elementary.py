"""Elementary functions against mpmath's 60 digits, and against the C library where a limit decides."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator

import mpmath
import numpy as np
import pytest

from skytender import elementary, elementwise

N = 900
Args = tuple[float, ...]


def between(low: float, high: float) -> list[float]:
    rng = random.Random(f"{low} {high}")
    return [rng.uniform(low, high) for _ in range(N)]


def sizes(low: float, high: float) -> list[float]:
    """Of either sign, evenly by their exponents of ten."""
    rng = random.Random(f"{low} {high}")
    return [rng.choice((-1.0, 1.0)) * 10.0 ** rng.uniform(low, high) for _ in range(N)]


def positive(low: float, high: float) -> list[float]:
    return [abs(x) for x in sizes(low, high)]


ANGLES = [*between(-1, 1), *between(-100, 100), *between(-1e6, 1e6), *sizes(-300, 0)]


def farthest_ulp(ours: Callable[..., float], exact: Callable[..., mpmath.mpf], arguments: Iterator[Args]) -> float:
    """Largest error in units in the last place."""
    farthest = 0.0
    with mpmath.workdps(60):
        for one in arguments:
            reference = exact(*map(mpmath.mpf, one))
            farthest = max(farthest, float(abs(mpmath.mpf(ours(*one)) - reference) / math.ulp(float(reference))))
    return farthest


@pytest.mark.parametrize(
    ("name", "arguments", "most"),
    [
        ("sin", ANGLES, 1.0),
        ("cos", ANGLES, 1.0),
        ("tan", ANGLES, 3.0),
        ("exp", [*between(-1, 1), *between(-700, 700), *sizes(-300, 0)], 1.0),
        ("expm1", [*between(-1, 1), *between(-30, 700), *sizes(-300, 0)], 2.0),
        ("log", [*between(0.5, 2), *positive(-320, 300)], 2.0),
        ("log", [1.0 + x for x in sizes(-15, -1)], 2.0),
        ("atan", [*between(-2, 2), *sizes(-300, 300)], 2.0),
        ("asin", [*between(-1, 1), *sizes(-300, 0)], 2.0),
    ],
)
def test_a_function_of_one_number_is_right_to_its_last_places(name: str, arguments: list[float], most: float) -> None:
    ours, exact = getattr(elementary, name), getattr(mpmath, name)
    assert farthest_ulp(ours, exact, ((x,) for x in arguments)) < most


@pytest.mark.parametrize("y", [2.0 / 7.0, 0.6, 1.0 / 3.0, 0.4, 1.2, 0.5, 2.0, 3.0, -1.5, 37.3, 5.2558])
def test_a_power_is_right_to_its_last_place(y: float) -> None:
    bases = [*positive(-8, 8), *between(0.9, 1.1), *positive(-300, 300)]
    arguments = ((x, y) for x in bases if -700 < y * math.log(x) < 700)
    assert farthest_ulp(elementary.pow, mpmath.power, arguments) < 1.0


def test_an_angle_of_a_vector_is_right_to_its_last_places() -> None:
    arguments = zip([*between(-1, 1), *sizes(-9, 9)], [*between(-2, 2), *sizes(-8, 9)], strict=True)
    assert farthest_ulp(elementary.atan2, mpmath.atan2, arguments) < 2.0


def test_a_multiple_of_a_right_angle_keeps_its_small_sine() -> None:
    multiples = [k * math.pi / 2.0 for k in range(1, 2000)]
    assert farthest_ulp(elementary.sin, mpmath.sin, ((x,) for x in multiples[1::2])) < 3.0
    assert farthest_ulp(elementary.cos, mpmath.cos, ((x,) for x in multiples[0::2])) < 3.0


def test_a_far_angle_is_right_to_what_its_own_last_place_means() -> None:
    for x in sizes(6, 300):
        with mpmath.workdps(400):
            turn = 2 * mpmath.pi
            error = abs(mpmath.mpf(elementary.sin(x)) - mpmath.sin(mpmath.mpf(x)))
            assert error <= min(2.0, 2.0**-53 * abs(x) + 1e-15), turn


@pytest.mark.parametrize("name", ["sin", "cos", "tan", "exp", "expm1", "atan"])
def test_zero_and_what_is_no_number_are_as_in_c(name: str) -> None:
    ours, c = getattr(elementary, name), getattr(math, name)
    assert ours(0.0) == c(0.0)
    assert math.isnan(ours(math.nan))


def test_limits_are_as_in_c() -> None:
    assert elementary.exp(-math.inf) == elementary.exp(-800.0) == 0.0
    assert elementary.exp(math.inf) == elementary.exp(800.0) == math.inf
    assert elementary.exp(-745.0) == math.exp(-745.0)
    assert elementary.expm1(-math.inf) == elementary.expm1(-800.0) == -1.0
    assert elementary.expm1(math.inf) == math.inf
    assert elementary.log(0.0) == -math.inf
    assert elementary.log(math.inf) == math.inf
    assert elementary.log(5e-324) == pytest.approx(math.log(5e-324), rel=1e-15)
    assert elementary.log(1.0) == 0.0
    assert elementary.atan(math.inf) == math.pi / 2.0
    assert elementary.asin(1.0) == math.pi / 2.0
    for outside in (elementary.sin(math.inf), elementary.log(-1.0), elementary.asin(1.5), elementary.pow(-1.0, 0.5)):
        assert math.isnan(outside)


LIMITS = (0.0, -0.0, 1.0, -1.0, math.inf, -math.inf, math.nan)


@pytest.mark.parametrize("x", [0.0, 0.3, 1.0, 2.5, math.inf, math.nan])
def test_limits_of_a_power_are_as_in_c(x: float) -> None:
    for y in (-math.inf, -2.5, 0.0, 0.5, math.inf, math.nan):
        expected = math.inf if x == 0.0 and y < 0.0 else math.pow(x, y)  # Python raises where C gives infinity
        assert elementary.pow(x, y) == pytest.approx(expected, rel=1e-15, nan_ok=True), y


@pytest.mark.parametrize("x", LIMITS)
def test_the_angle_of_each_quadrant_is_as_in_c(x: float) -> None:
    for y in LIMITS:
        ours, c = elementary.atan2(y, x), math.atan2(y, x)
        assert ours == pytest.approx(c, rel=3e-16, nan_ok=True), y
        assert math.isnan(c) or math.copysign(1.0, ours) == math.copysign(1.0, c), y


def test_arrays_hold_what_numbers_give() -> None:
    x = np.array(list(between(0.1, 5.0))).reshape(3, -1)
    for many, one in (
        (elementwise.sines, elementary.sin),
        (elementwise.cosines, elementary.cos),
        (elementwise.exponentials, elementary.exp),
        (elementwise.logarithms, elementary.log),
    ):
        assert many(x).tolist() == [[one(a) for a in row] for row in x.tolist()]
        assert many(x.T).tolist() == many(x).T.tolist()
    assert elementwise.powers(x, 1.7).tolist() == [[elementary.pow(a, 1.7) for a in row] for row in x.tolist()]


@pytest.mark.parametrize("y", [2.0 / 7.0, 0.6, -1.5, 37.3, 900.0, 0.0, math.inf, -math.inf, math.nan])
def test_powers_of_many_are_those_of_each(y: float) -> None:
    special = [0.0, 5e-324, 1e-310, 2.0**-1022, 1.0, 1.0 + 2.0**-52, 1.8e308, math.inf, math.nan]
    for x in (special, [*positive(-300, 300)], [7.0, *special, 0.3]):
        alone = np.array([elementary.pow(a, y) for a in x])
        for count in range(len(x) - 8, len(x) + 1):
            assert elementwise.powers(x[:count], y).tobytes() == alone[:count].tobytes()


def test_lengths() -> None:
    assert elementary.hypot(3.0, 4.0) == elementary.norm((3.0, 4.0)) == elementary.distance((1, 1), [4, 5]) == 5.0
    assert elementary.norm(np.array([2.0, 3.0, 6.0])) == 7.0
    with pytest.raises(ValueError, match="2 and 3 components"):
        elementary.distance((1.0, 2.0), (1.0, 2.0, 3.0))
