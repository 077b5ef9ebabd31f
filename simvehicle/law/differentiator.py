"""Finite-time third-order differentiator (docs/model.md#differentiator, paper eq. 21) [lineage], values [seed],
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

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
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
@cython.returns((cython.double, cython.double, cython.double, cython.double, cython.bint))
@cython.locals(
    s=cython.double, low=cython.double, high=cython.double, width=cython.double, evaluations=cython.int,
    x1=cython.double, x2=cython.double, x3=cython.double, signal=cython.double, dt=cython.double,
    epsilon=cython.double, stiffness=cython.double, tolerance=cython.double,
)  # fmt: skip
def _improve(
    s: float, low: float, high: float, width: float, evaluations: int,
    x1: float, x2: float, x3: float, signal: float, dt: float, epsilon: float, stiffness: float, tolerance: float,
) -> tuple[float, float, float, float, bool]:  # fmt: skip
    """Evaluate G at s: the next s, the bracket of the root, the bracket's width as it was before, and whether s is it.

    `evaluations`: their number, this one counted; `stiffness`: h/ε³.
    """
    k_angle = _K_ANGLE * stiffness
    k_acceleration = _K_ACCELERATION * stiffness
    x2_next = x2 + dt * s
    speed = epsilon * x2_next
    power = elementary.pow(max(math.fabs(speed), _TINY), 2.0 / 7.0)
    a = x1 + dt * x2_next - signal + speed * power
    a_slope = dt * dt + 9.0 / 7.0 * epsilon * dt * power
    size = max(math.fabs(s) * epsilon * epsilon, _TINY)
    root = elementary.pow(size, 0.6)
    b = (s - x3 + k_acceleration * math.copysign(root, s)) / k_angle
    b_slope = (1.0 + k_acceleration * 0.6 * epsilon * epsilon * root / size) / k_angle
    g = a + b * b * b
    following = s - g / (a_slope + 3.0 * b * b * b_slope)
    if math.fabs(g) <= tolerance * a_slope:
        return following, low, high, width, True
    # A' >= h² bounds the distance of the root, so the bracket is finite from the first evaluation on.
    if g > 0.0:
        high = s
        low = max(low, s - g / (dt * dt))
    else:
        low = s
        high = min(high, s - g / (dt * dt))
    if not low < following < high or (high - low > 0.5 * width and evaluations % 4 == 0):
        following = 0.5 * (low + high)
    return following, low, high, high - low, following == s


def solve(
    x1: float, x2: float, x3: float, signal: float, dt: float, epsilon: float, tolerance: float
) -> tuple[float, float, float, int]:
    """One implicit step: (X1+, X2+, X3+, evaluations of G)."""
    s, low, high, width, done = x3, -math.INFINITY, math.INFINITY, math.INFINITY, False
    stiffness = dt / (epsilon * epsilon * epsilon)
    evaluations = 0
    while not done and evaluations < _MOST_EVALUATIONS:
        evaluations += 1
        s, low, high, width, done = _improve(
            s, low, high, width, evaluations, x1, x2, x3, signal, dt, epsilon, stiffness, tolerance
        )
    x2_next = x2 + dt * s
    return x1 + dt * x2_next, x2_next, s, evaluations


def solve_two(
    x1: float, x2: float, x3: float, x: float, y1: float, y2: float, y3: float, y: float,
    dt: float, epsilon: float, tolerance: float,
) -> tuple[float, float]:  # fmt: skip
    """X3+ of two differentiators with signals x and y, each as `solve` finds it. Evaluations take turns: neither waits
    for the other, so that the processor works on both at once."""
    s, low, high, width, done = x3, -math.INFINITY, math.INFINITY, math.INFINITY, False
    s_y, low_y, high_y, width_y, done_y = y3, -math.INFINITY, math.INFINITY, math.INFINITY, False
    stiffness = dt / (epsilon * epsilon * epsilon)
    evaluations = 0
    while not (done and done_y) and evaluations < _MOST_EVALUATIONS:
        evaluations += 1
        if not done:
            s, low, high, width, done = _improve(
                s, low, high, width, evaluations, x1, x2, x3, x, dt, epsilon, stiffness, tolerance
            )
        if not done_y:
            s_y, low_y, high_y, width_y, done_y = _improve(
                s_y, low_y, high_y, width_y, evaluations, y1, y2, y3, y, dt, epsilon, stiffness, tolerance
            )
    return s, s_y


@cython.wraparound(True)
def step(x: ArrayLike, signal: ArrayLike, dt_s: float, *, epsilon: float) -> NDArray[np.float64]:
    """One implicit step of differentiators (docs/model.md#differentiator, paper eq. 21) [lineage].

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
