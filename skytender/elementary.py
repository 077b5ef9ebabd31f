"""Elementary functions whose results are the same to the last bit on every processor.

A C library picks one of several versions of its sine or power by what the processor can do, and these differ in the
last bit. The functions here consist of IEEE 754's basic operations and square root alone, in the order in which they
stand, so that a session's digest does not depend on the processor (docs/contributing/native.md#equal-bytes). What IEEE
754 defines exactly (sqrt, fabs, floor, fmod, copysign) is the C library's.

Angles in rad. NaN gives NaN, as outside a function's range; the sine of -0 is 0. Methods:

- sin, cos, tan: the nearest multiple of π/2 is subtracted in three parts (Cody and Waite 1980), then Taylor's
  polynomials on ±π/4. An angle beyond 10⁶ is first taken modulo the double nearest to 2π, which changes the result as
  a relative error of 2⁻⁵⁴ in the angle would.
- exp, expm1, pow: 2^x from a table of 2^(j/128) and Taylor's polynomial (Tang 1989).
- log, pow: log2 of the nearest m/128 from a table and Taylor's polynomial for the rest (Tang 1990). `pow` keeps the
  logarithm in two parts, so that its product with the exponent loses nothing.
- atan, atan2, asin: arctangent of the nearest m/16 from a table and Taylor's polynomial for the rest.

Largest errors in units in the last place (tests/skytender/test_elementary.py): 1 of sin, cos, exp and pow, 3 of a sine
or cosine below 10⁻¹⁵ and of tan, 2 of the others.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import cython
from cython.cimports.libc import math
from cython.cimports.libc.string import memcpy
from cython.cimports.skytender.elementary import (
    _ARCTANGENT,
    _ARCTANGENT_REST,
    _INVERSE,
    _LOG,
    _LOG_REST,
    _POWER,
    _POWER_REST,
    TOGETHER,
)

from skytender import elementary_tables as tables

if TYPE_CHECKING:  # what needs no arrays starts without NumPy
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray

    Vector = Sequence[float] | NDArray[np.float64]


_ROUND = 1.5 * 2.0**52
"""A number below 2^51 becomes the nearest whole one when this is added and subtracted again."""
_FAR = 1e6
_TINY = 2.0**-27
_LEAST_NORMAL = 2.0**-1022
_FRACTION = (1 << 52) - 1
_ONE = 1023 << 52
_FIRST_BITS = -1 << 27
"""Bits of a double that leave 26 of its fraction."""
_STEPS = float(tables.POWER_STEPS)
_TWO_OVER_PI = 2 * tables.ONE / tables.PI
_STEPS_OVER_LN_2 = tables.POWER_STEPS * tables.ONE / tables.LN_2
_LN_2 = tables.LN_2 / tables.ONE
_INVERSE_LN_2 = tables.ONE / tables.LN_2
_TWO_PI = 2 * tables.PI / tables.ONE
_PI, _PI_REST = tables.parts(tables.PI, 51)
_PI_HALVES_1, _PI_HALVES_2, _PI_HALVES_3 = tables.parts(tables.PI // 2, 31, 62)
_LN_2_1, _LN_2_2 = tables.parts(tables.LN_2, 27)
_STEP_1, _STEP_2 = tables.parts(tables.LN_2 // tables.POWER_STEPS, 41)


def _fill() -> None:
    for j, value in enumerate(tables.powers()):
        _POWER[j], _POWER_REST[j] = tables.parts(value, 52)
        _POWER_REST[j] /= _POWER[j]
    for m, value in enumerate(tables.logarithms()):
        _INVERSE[m] = tables.LOG_STEPS / (tables.LOG_STEPS + m)
        _LOG[m], _LOG_REST[m] = tables.parts(value, 15)
    for m, value in enumerate(tables.arctangents()):
        _ARCTANGENT[m], _ARCTANGENT_REST[m] = tables.parts(value, 52)


_fill()


def _reduced(x: float) -> tuple[float, float, int]:
    """x less a multiple of π/2, in two parts, and that multiple modulo 4."""
    if math.fabs(x) <= 0.25 * _PI:
        return x, 0.0, 0
    if not math.fabs(x) <= _FAR:
        if not math.fabs(x) < math.INFINITY:
            return math.NAN, 0.0, 0
        x = math.fmod(x, _TWO_PI)
    n = (x * _TWO_OVER_PI + _ROUND) - _ROUND
    a = x - n * _PI_HALVES_1  # exact, as the product is
    b = n * _PI_HALVES_2
    t = a - b
    z = t - a
    c = ((a - (t - z)) - (b + z)) - n * _PI_HALVES_3
    r = t + c
    return r, (t - r) + c, cython.cast(cython.int, n) & 3


def _sine_near_0(r: float, rest: float) -> float:
    """sin(r + rest) on ±π/4."""
    z = r * r
    w = z * z
    even = -1.0 / 6.0 + w * (-1.0 / 5040.0 + w * (-1.0 / 39916800.0 + w * (-1.0 / 1307674368000.0)))
    odd = 1.0 / 120.0 + w * (1.0 / 362880.0 + w * (1.0 / 6227020800.0 + w * (1.0 / 355687428096000.0)))
    return r + (r * (z * (even + z * odd)) + rest * (1.0 - 0.5 * z))


def _cosine_near_0(r: float, rest: float) -> float:
    """cos(r + rest) on ±π/4."""
    z = r * r
    w = z * z
    even = 1.0 / 24.0 + w * (1.0 / 40320.0 + w * (1.0 / 479001600.0 + w * (1.0 / 20922789888000.0)))
    odd = -1.0 / 720.0 + w * (-1.0 / 3628800.0 + w * (-1.0 / 87178291200.0 + w * (-1.0 / 6402373705728000.0)))
    half = 0.5 * z
    one = 1.0 - half
    return one + (((1.0 - one) - half) + (w * (even + z * odd) - r * rest))


def sin_cos(x: float) -> tuple[float, float]:
    """Sine and cosine."""
    r, rest, quarter = _reduced(x)
    s = _sine_near_0(r, rest)
    c = _cosine_near_0(r, rest)
    if quarter & 1:
        s, c = c, -s
    if quarter & 2:
        s, c = -s, -c
    return s, c


def sin_cos_of_each(x: Any, sines: Any, cosines: Any) -> None:
    """`sin_cos` of TOGETHER angles. The processor works on all at once where they are small, and need no reduction.

    Below 2⁻²⁷ an angle is its sine, and 1 its cosine: products of tiny numbers take many times as long as others."""
    small = cython.declare(cython.bint, True)
    tiny = cython.declare(cython.bint, True)
    for i in range(TOGETHER):
        small &= math.fabs(x[i]) <= 0.25 * _PI
        tiny &= math.fabs(x[i]) <= _TINY
    if tiny:
        for i in range(TOGETHER):
            sines[i] = x[i] + 0.0  # no -0
            cosines[i] = 1.0
    elif small:
        for i in range(TOGETHER):
            sines[i] = _sine_near_0(x[i], 0.0)
            cosines[i] = _cosine_near_0(x[i], 0.0)
    else:
        for i in range(TOGETHER):
            sines[i], cosines[i] = sin_cos(x[i])


def sin(x: float) -> float:
    """Sine."""
    r, rest, quarter = _reduced(x)
    s = _cosine_near_0(r, rest) if quarter & 1 else _sine_near_0(r, rest)
    return -s if quarter & 2 else s


def cos(x: float) -> float:
    """Cosine."""
    r, rest, quarter = _reduced(x)
    c = _sine_near_0(r, rest) if quarter & 1 else _cosine_near_0(r, rest)
    return -c if (quarter + 1) & 2 else c


def tan(x: float) -> float:
    """Tangent."""
    s, c = sin_cos(x)
    return s / c


def _grown(u: float) -> float:
    """e^u - 1 with |u| up to ln 2/256."""
    w = u * u
    return u + w * ((0.5 + u * (1.0 / 6.0)) + w * (1.0 / 24.0 + u * (1.0 / 120.0)))


@cython.cfunc
@cython.inline
@cython.nogil
@cython.exceptval(check=False)
@cython.returns(cython.double)
@cython.locals(exponent=cython.longlong)
def _power_of_2(exponent: int) -> float:
    """2^exponent where that is a normal number."""
    bits = cython.declare(cython.longlong, (exponent + 1023) << 52)
    power = cython.declare(cython.double)
    memcpy(cython.address(power), cython.address(bits), 8)
    return power


def _scaled(x: float, exponent: int) -> float:
    """x·2^exponent."""
    if -1022 <= exponent <= 1023:
        return x * _power_of_2(exponent)
    return math.ldexp(x, cython.cast(cython.int, exponent))


def exp(x: float) -> float:
    """e^x; 0 and infinity where it is too small or too great."""
    if not math.fabs(x) < 746.0:
        return x + math.INFINITY if not x < 0.0 else 0.0
    n = (x * _STEPS_OVER_LN_2 + _ROUND) - _ROUND
    steps = cython.cast(cython.longlong, n)
    step = _POWER[steps & 127]
    return _scaled(step + step * (_POWER_REST[steps & 127] + _grown((x - n * _STEP_1) - n * _STEP_2)), steps >> 7)


def expm1(x: float) -> float:
    """e^x - 1, without the loss of digits near 0."""
    if not math.fabs(x) < 700.0 or x == 0.0:
        return x if x == 0.0 else exp(x) - 1.0
    n = (x * _STEPS_OVER_LN_2 + _ROUND) - _ROUND
    steps = cython.cast(cython.longlong, n)
    step = _scaled(_POWER[steps & 127], steps >> 7)
    return (step - 1.0) + step * (_POWER_REST[steps & 127] + _grown((x - n * _STEP_1) - n * _STEP_2))


@cython.cfunc
@cython.inline
@cython.nogil
@cython.exceptval(check=False)
@cython.returns((cython.double, cython.int, cython.int))
@cython.locals(x=cython.double, at=cython.int, exponent=cython.int)
def _significand(x: float) -> tuple[float, int, int]:
    """(z, m, exponent), x = z·2^exponent, of a normal positive number; z, from 1 to 2, is nearest to 1 + m/128."""
    bits = cython.declare(cython.longlong)
    z = cython.declare(cython.double)
    memcpy(cython.address(bits), cython.address(x), 8)
    at = ((bits >> 44 & 255) + 1) >> 1
    exponent = (bits >> 52) - 1023
    bits = bits & _FRACTION | _ONE
    memcpy(cython.address(z), cython.address(bits), 8)
    return z, at, exponent


@cython.cfunc
@cython.inline
@cython.nogil
@cython.exceptval(check=False)
@cython.returns((cython.double, cython.double, cython.double))
@cython.locals(z=cython.double, at=cython.int, exponent=cython.int, r=cython.double)
def _log2_of(z: float, at: int, exponent: int) -> tuple[float, float, float]:
    """`_log2` of a number that has been taken apart."""
    r = (z - (1.0 + at * 0.0078125)) * _INVERSE[at]
    w = r * r
    series = (0.5 - r * (1.0 / 3.0)) + w * ((0.25 - r * 0.2) + w * (1.0 / 6.0 - r * (1.0 / 7.0)))
    return exponent + _LOG[at], _LOG_REST[at], r - w * series


@cython.cfunc
@cython.inline
@cython.nogil
@cython.exceptval(check=False)
@cython.returns((cython.double, cython.double, cython.double))
@cython.locals(x=cython.double, at=cython.int, exponent=cython.int)
def _log2(x: float) -> tuple[float, float, float]:
    """(a, b, c), log2 x = a + b + c/ln 2 with a of 26 bits, of a positive finite number."""
    if x < _LEAST_NORMAL:
        z, at, exponent = _significand(x * 2.0**54)
        return _log2_of(z, at, exponent - 54)
    z, at, exponent = _significand(x)
    return _log2_of(z, at, exponent)


def log(x: float) -> float:
    """Natural logarithm; -infinity of 0."""
    if not 0.0 < x < math.INFINITY:
        return x if x > 0.0 else -math.INFINITY if x == 0.0 else math.NAN
    a, b, c = _log2(x)
    return a * _LN_2_1 + (a * _LN_2_2 + (b * _LN_2 + c))


@cython.cfunc
@cython.inline
@cython.nogil
@cython.exceptval(check=False)
@cython.returns((cython.double, cython.double))
@cython.locals(a=cython.double, b=cython.double, c=cython.double, y=cython.double)
def _times(a: float, b: float, c: float, y: float) -> tuple[float, float]:
    """y (a + b + c/ln 2) in two parts."""
    bits = cython.declare(cython.longlong)
    first = cython.declare(cython.double)
    memcpy(cython.address(bits), cython.address(y), 8)
    bits &= _FIRST_BITS
    memcpy(cython.address(first), cython.address(bits), 8)
    return first * a, (y - first) * a + y * (b + c * _INVERSE_LN_2)  # the first is exact: 26 bits each


def pow(x: float, y: float) -> float:
    """x^y of x not below 0."""
    if not (0.0 < x < math.INFINITY and math.fabs(y) < math.INFINITY):
        return _limit_of_pow(x, y)
    a, b, c = _log2(x)
    whole, rest = _times(a, b, c, y)
    n = ((whole + rest) * _STEPS + _ROUND) - _ROUND
    if not math.fabs(n) < 1075.0 * _STEPS:
        return math.INFINITY if n > 0.0 else 0.0
    steps = cython.cast(cython.int, n)
    step = _POWER[steps & 127]
    more = _POWER_REST[steps & 127] + _grown(((whole - n * 0.0078125) + rest) * _LN_2)
    return _scaled(step + step * more, steps >> 7)


def pow_of_each(x: Any, y: Any, made: Any) -> None:
    """`pow` of TOGETHER pairs into `made`. All of them are carried from part to part, so that the processor works on
    all at once."""
    at = cython.declare(cython.int[TOGETHER])
    exponent = cython.declare(cython.int[TOGETHER])
    z = cython.declare(cython.double[TOGETHER])
    n = cython.declare(cython.double[TOGETHER])
    u = cython.declare(cython.double[TOGETHER])
    ordinary = cython.declare(cython.bint, True)
    for i in range(TOGETHER):
        z[i], at[i], exponent[i] = _significand(x[i])
        ordinary &= (x[i] >= _LEAST_NORMAL) & (x[i] < math.INFINITY)
    for i in range(TOGETHER):
        a, b, c = _log2_of(z[i], at[i], exponent[i])
        whole, rest = _times(a, b, c, y[i])
        n[i] = ((whole + rest) * _STEPS + _ROUND) - _ROUND
        u[i] = ((whole - n[i] * 0.0078125) + rest) * _LN_2
        ordinary &= math.fabs(n[i]) < 1022.0 * _STEPS
    if not ordinary:
        for i in range(TOGETHER):
            made[i] = pow(x[i], y[i])
        return
    for i in range(TOGETHER):
        steps = cython.cast(cython.int, n[i])
        step = _POWER[steps & 127]
        made[i] = (step + step * (_POWER_REST[steps & 127] + _grown(u[i]))) * _power_of_2(steps >> 7)


def _limit_of_pow(x: float, y: float) -> float:
    """x^y where one is 0 or infinite, or x below 0."""
    if y == 0.0 or x == 1.0:
        return 1.0
    if not x >= 0.0 or math.isnan(y):
        return math.NAN
    return 0.0 if (x < 1.0) == (y > 0.0) else math.INFINITY


@cython.cfunc
@cython.inline
@cython.nogil
@cython.exceptval(check=False)
@cython.returns((cython.double, cython.double))
@cython.locals(t=cython.double, at=cython.int)
def _arctangent_to_1(t: float) -> tuple[float, float]:
    """atan t of t from 0 to 1, in two parts."""
    at = cython.cast(cython.int, t * 16.0 + 0.5)
    c = at * 0.0625
    u = (t - c) / (1.0 + c * t)
    w = u * u
    series = u * (w * (-1.0 / 3.0 + w * (0.2 + w * (-1.0 / 7.0 + w * (1.0 / 9.0 - w * (1.0 / 11.0))))))
    return _ARCTANGENT[at], u + (series + _ARCTANGENT_REST[at])


def atan2(y: float, x: float) -> float:
    """Angle of (x, y), from -π to π; signed zeros and infinities as in C."""
    a, b = math.fabs(y), math.fabs(x)
    if math.isnan(a) or math.isnan(b):
        return math.NAN
    less, more = (a, b) if a < b else (b, a)
    first, rest = _arctangent_to_1(0.0 if more == 0.0 else 1.0 if less == math.INFINITY else less / more)
    if a > b:
        first, rest = 0.5 * _PI - first, 0.5 * _PI_REST - rest
    if math.signbit(x):
        first, rest = _PI - first, _PI_REST - rest
    return math.copysign(first + rest, y)


def atan(x: float) -> float:
    """Arctangent."""
    t = math.fabs(x)
    if t <= 1.0:
        first, rest = _arctangent_to_1(t)
    elif t > 1.0:
        first, rest = _arctangent_to_1(1.0 / t)
        first, rest = 0.5 * _PI - first, 0.5 * _PI_REST - rest
    else:
        return x
    return math.copysign(first + rest, x)


def asin(x: float) -> float:
    """Arcsine, from -π/2 to π/2."""
    return math.NAN if not math.fabs(x) <= 1.0 else atan2(x, math.sqrt((1.0 - x) * (1.0 + x)))


def hypot(x: float, y: float) -> float:
    """√(x² + y²); neither square may overflow."""
    return math.sqrt(x * x + y * y)


def norm(vector: Vector) -> float:
    """Length of a vector of any size: the root of its sum of squares, added in order."""
    square = 0.0
    for k in range(len(vector)):
        part = cython.cast(cython.double, vector[k])
        square += part * part
    return math.sqrt(square)


def distance(a: Vector, b: Vector) -> float:
    """Length of a - b, two vectors of the same size.

    Raises:
        ValueError: the sizes differ.
    """
    if len(a) != len(b):
        raise ValueError(f"vectors have {len(a)} and {len(b)} components, but need the same number")
    square = 0.0
    for k in range(len(a)):
        part = cython.cast(cython.double, a[k]) - cython.cast(cython.double, b[k])
        square += part * part
    return math.sqrt(square)
