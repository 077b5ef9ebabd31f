"""Finite-time third-order differentiator (docs/model/control.md#differentiator, paper eq. 21) [lineage], values [seed],
discretised implicitly.

One implicit Euler step of h is one scalar equation in s = X3+, with X2+ = X2 + h s and X1+ = X1 + h X2+:

    s - X3 = -k (h/ε³) sig(A)^(1/3) - 4 (h/ε³) sig(ε² s)^(3/5),   A = X1+ - v + sig(ε X2+)^(9/7),   k = 4·2^(3/5)

It is solved with the cube root turned over, which takes its infinite slope away and leaves an almost straight line:

    G(s) = A(s) + B(s)³ = 0,   B = (s - X3 + 4 (h/ε³) sig(ε² s)^(3/5)) / (k h/ε³)

G rises strictly, with A' >= h², so its root is unique and Newton from s = X3, held inside the bracket that the signs
of G leave, cannot fail. The solve ends when |G| <= tolerance·A', that is when the correction still to come is no
more than `tolerance` rad/s², and makes that correction: what remains is of the order of its square.
"""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.simvehicle.law.differentiator import BOTH
from cython.cimports.skytender.elementary import TOGETHER
from numpy.typing import ArrayLike, NDArray

from simvehicle.law.params import SOLVE_TOLERANCE

ORDER = 3
_K_ANGLE = 4.0 * elementary.pow(2.0, 0.6)
_K_ACCELERATION = 4.0
_TINY = 1e-200
_MOST_EVALUATIONS = 200


@cython.cfunc
@cython.inline
@cython.nogil
@cython.exceptval(check=False)
@cython.returns(cython.void)
@cython.locals(
    s="const double*", x1="const double*", x2="const double*", x3="const double*", signals="const double*",
    dt=cython.double, epsilon=cython.double, stiffness=cython.double, g=cython.p_double, g_slope=cython.p_double,
    a_slope=cython.p_double,
)  # fmt: skip
def _evaluate(
    s: Any, x1: Any, x2: Any, x3: Any, signals: Any, dt: float, epsilon: float, stiffness: float, g: Any, g_slope: Any,
    a_slope: Any,
) -> None:  # fmt: skip
    """G, G' and A' at s, (BOTH,) each; stiffness: h/ε³."""
    k_angle = _K_ANGLE * stiffness
    k_acceleration = _K_ACCELERATION * stiffness
    bases = cython.declare(cython.double[TOGETHER])
    exponents = cython.declare(cython.double[TOGETHER])
    powers = cython.declare(cython.double[TOGETHER])
    for i in range(BOTH):
        bases[i] = max(math.fabs(epsilon * (x2[i] + dt * s[i])), _TINY)
        bases[BOTH + i] = max(math.fabs(s[i]) * epsilon * epsilon, _TINY)
        exponents[i], exponents[BOTH + i] = 2.0 / 7.0, 0.6
    elementary.pow_of_each(bases, exponents, powers)
    for i in range(BOTH):
        power, size, root = powers[i], bases[BOTH + i], powers[BOTH + i]
        x2_next = x2[i] + dt * s[i]
        a = x1[i] + dt * x2_next - signals[i] + epsilon * x2_next * power
        a_slope[i] = dt * dt + 9.0 / 7.0 * epsilon * dt * power
        b = (s[i] - x3[i] + k_acceleration * math.copysign(root, s[i])) / k_angle
        b_slope = (1.0 + k_acceleration * 0.6 * epsilon * epsilon * root / size) / k_angle
        g[i] = a + b * b * b
        g_slope[i] = a_slope[i] + 3.0 * b * b * b_slope


def _solve(x1: Any, x2: Any, x3: Any, signals: Any, dt: float, epsilon: float, tolerance: float, s: Any) -> int:
    """X3+ of two differentiators, (BOTH,), into s; evaluations of G. Neither waits for the other, so that the processor
    works on both at once."""
    low = cython.declare(cython.double[BOTH])
    high = cython.declare(cython.double[BOTH])
    width = cython.declare(cython.double[BOTH])
    done = cython.declare(cython.bint[BOTH])
    g = cython.declare(cython.double[BOTH])
    g_slope = cython.declare(cython.double[BOTH])
    a_slope = cython.declare(cython.double[BOTH])
    for i in range(BOTH):
        s[i], low[i], high[i], width[i], done[i] = x3[i], -math.INFINITY, math.INFINITY, math.INFINITY, False
    stiffness = dt / (epsilon * epsilon * epsilon)
    evaluations = 0
    while not (done[0] and done[1]) and evaluations < _MOST_EVALUATIONS:
        evaluations += 1
        _evaluate(s, x1, x2, x3, signals, dt, epsilon, stiffness, g, g_slope, a_slope)
        for i in range(BOTH):
            if done[i]:
                continue
            following = s[i] - g[i] / g_slope[i]
            if math.fabs(g[i]) <= tolerance * a_slope[i]:
                s[i], done[i] = following, True
                continue
            # A' >= h²: the root lies between s and this, so the bracket is finite from the first evaluation on.
            beyond = s[i] - g[i] / (dt * dt)
            low[i], high[i] = max(low[i], min(s[i], beyond)), min(high[i], max(s[i], beyond))
            narrowed = high[i] - low[i]
            if not low[i] < following < high[i] or (narrowed > 0.5 * width[i] and evaluations % 4 == 0):
                following = 0.5 * (low[i] + high[i])
            s[i], width[i], done[i] = following, narrowed, following == s[i]
    return evaluations


def solve(
    x1: float, x2: float, x3: float, signal: float, dt: float, epsilon: float, tolerance: float
) -> tuple[float, float, float, int]:
    """One implicit step: (X1+, X2+, X3+, evaluations of G)."""
    s, _, evaluations = solve_two(x1, x2, x3, signal, x1, x2, x3, signal, dt, epsilon, tolerance)
    x2_next = x2 + dt * s
    return x1 + dt * x2_next, x2_next, s, evaluations


def solve_two(
    x1: float, x2: float, x3: float, x: float, y1: float, y2: float, y3: float, y: float,
    dt: float, epsilon: float, tolerance: float,
) -> tuple[float, float, int]:  # fmt: skip
    """X3+ of two differentiators with signals x and y, each as `solve` finds it, and evaluations of G."""
    first = cython.declare(cython.double[BOTH])
    second = cython.declare(cython.double[BOTH])
    third = cython.declare(cython.double[BOTH])
    signals = cython.declare(cython.double[BOTH])
    s = cython.declare(cython.double[BOTH])
    first[0], second[0], third[0], signals[0] = x1, x2, x3, x
    first[1], second[1], third[1], signals[1] = y1, y2, y3, y
    evaluations = _solve(first, second, third, signals, dt, epsilon, tolerance, s)
    return s[0], s[1], evaluations


@cython.wraparound(True)
def step(x: ArrayLike, signal: ArrayLike, dt_s: float, *, epsilon: float) -> NDArray[np.float64]:
    """One implicit step of differentiators (docs/model/control.md#differentiator, paper eq. 21) [lineage].

    Args:
        x: (..., 3), X1, X2, X3: the signal's estimate and its first two derivatives, in units of the signal per s^k.
        signal: (...), the signal at the end of the step.
        dt_s: the step.
        epsilon: ε, s.

    Returns:
        (..., 3), one step later.

    Raises:
        ValueError: x does not end in 3, or the signal's shape is not that of x without its last axis; ε or the step is
            not greater than 0 and finite.
    """
    for name, value in (("epsilon", epsilon), ("dt_s", dt_s)):
        if not 0.0 < value < math.INFINITY:
            raise ValueError(f"{name} is {value!r}, but it must be greater than 0 and finite")
    memory = np.asarray(x, dtype=np.float64)
    v = np.asarray(signal, dtype=np.float64)
    if memory.shape[-1:] != (ORDER,) or memory.shape[:-1] != v.shape:
        raise ValueError(f"x and signal have shapes {memory.shape} and {v.shape}, but need (..., 3) and (...)")
    rows = zip(memory.reshape(-1, ORDER).tolist(), v.reshape(-1).tolist(), strict=True)
    stepped = [solve(x1, x2, x3, value, dt_s, epsilon, SOLVE_TOLERANCE)[:ORDER] for (x1, x2, x3), value in rows]
    return np.array(stepped, dtype=np.float64).reshape(memory.shape)
