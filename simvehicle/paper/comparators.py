"""Comparators of the finite-time differentiator (docs/model/control.md#comparison-differentiators): two others, and
itself stepped explicitly.

Every one is stepped by explicit Euler, as such laws usually are: state and signal of one time give the state a step
later. They serve the figures of studies.py; no vehicle flies them.
"""

from __future__ import annotations

from cython.cimports.libc import math

SLIDING_ALPHA = 18.0  # 1/s², α [lineage]
SLIDING_LAMBDA = 6.0  # 1/s, λ for signals of size 1 [lineage]
HIGH_GAIN_K1 = 1.0  # [lineage]
HIGH_GAIN_K2 = 2.0  # [lineage]
HIGH_GAIN_ALPHA = 0.15  # s [lineage]


def _sig(x: float, power: float) -> float:
    return math.copysign(math.fabs(x) ** power, x)


def _sign(x: float) -> float:
    return 0.0 if x == 0.0 else math.copysign(1.0, x)


def explicit(x1: float, x2: float, x3: float, signal: float, dt: float, epsilon: float) -> tuple[float, float, float]:
    """One explicit Euler step of the finite-time differentiator (docs/model/control.md#differentiator) [lineage]: (X1+,
    X2+, X3+).

    ε³ X3' = -2^(3/5)·4·sig(X1 - v + sig(ε X2)^(9/7))^(1/3) - 4·sig(ε² X3)^(3/5)
    """
    angle = 2.0**0.6 * 4.0 * _sig(x1 - signal + _sig(epsilon * x2, 9.0 / 7.0), 1.0 / 3.0)
    slope = -(angle + 4.0 * _sig(epsilon * epsilon * x3, 0.6)) / (epsilon * epsilon * epsilon)
    return x1 + dt * x2, x2 + dt * x3, x3 + dt * slope


def sliding_mode(
    x: float, u1: float, signal: float, dt: float, alpha: float, lambda_: float
) -> tuple[float, float, float]:
    """One step of Levant's sliding-mode differentiator (docs/model/control.md#comparison-differentiators) [lineage]:
    (x+, u1+, u).

    x' = u = u1 - λ |x - v|^(1/2) sgn(x - v),   u1' = -α sgn(x - v);   u is the derivative's estimate
    """
    error = x - signal
    u = u1 - lambda_ * math.sqrt(math.fabs(error)) * _sign(error)
    return x + dt * u, u1 - dt * alpha * _sign(error), u


def high_gain(
    x1: float, x2: float, signal: float, dt: float, k1: float, k2: float, alpha: float
) -> tuple[float, float]:
    """One step of the linear high-gain differentiator (docs/model/control.md#comparison-differentiators) [lineage]:
    (x1+, x2+).

    x1' = x2 - (k1/α) (x1 - v),   x2' = -(k2/α²) (x1 - v);   x2 is the derivative's estimate
    """
    error = x1 - signal
    return x1 + dt * (x2 - k1 / alpha * error), x2 - dt * k2 / (alpha * alpha) * error
