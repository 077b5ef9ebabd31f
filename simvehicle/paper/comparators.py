"""What the finite-time differentiator is compared with (docs/model.md#comparison-differentiators): two others, and
itself stepped explicitly.

Every one is stepped by explicit Euler, as such laws usually are: state and signal of one time give the state a step
later. They serve the figures of paper.py; no vehicle flies them.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numba import njit
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

SLIDING_ALPHA = 18.0  # 1/s², α [lineage]
SLIDING_LAMBDA = 6.0  # 1/s, λ for signals of size 1 [lineage]
HIGH_GAIN_K1 = 1.0  # [lineage]
HIGH_GAIN_K2 = 2.0  # [lineage]
HIGH_GAIN_ALPHA = 0.15  # s [lineage]


@njit(cache=True, error_model="numpy")
def _sig(x: float, power: float) -> float:
    return math.copysign(abs(x) ** power, x)


@njit(cache=True, error_model="numpy")
def _sign(x: float) -> float:
    return 0.0 if x == 0.0 else math.copysign(1.0, x)


@njit(cache=True, error_model="numpy")
def explicit(x1: float, x2: float, x3: float, signal: float, dt: float, epsilon: float) -> tuple[float, float, float]:
    """One explicit Euler step of the finite-time differentiator (docs/model.md#differentiator) [lineage]: (X1+, X2+,
    X3+).

    ε³ X3' = -2^(3/5)·4·sig(X1 - v + sig(ε X2)^(9/7))^(1/3) - 4·sig(ε² X3)^(3/5)
    """
    angle = 2.0**0.6 * 4.0 * _sig(x1 - signal + _sig(epsilon * x2, 9.0 / 7.0), 1.0 / 3.0)
    slope = -(angle + 4.0 * _sig(epsilon * epsilon * x3, 0.6)) / (epsilon * epsilon * epsilon)
    return x1 + dt * x2, x2 + dt * x3, x3 + dt * slope


@njit(cache=True, error_model="numpy")
def sliding_mode(
    x: float, u1: float, signal: float, dt: float, alpha: float, lambda_: float
) -> tuple[float, float, float]:
    """One step of Levant's sliding-mode differentiator (docs/model.md#comparison-differentiators) [lineage]: (x+, u1+,
    u).

    x' = u = u1 - λ |x - v|^(1/2) sgn(x - v),   u1' = -α sgn(x - v);   u is the derivative's estimate
    """
    error = x - signal
    u = u1 - lambda_ * math.sqrt(abs(error)) * _sign(error)
    return x + dt * u, u1 - dt * alpha * _sign(error), u


@njit(cache=True, error_model="numpy")
def high_gain(
    x1: float, x2: float, signal: float, dt: float, k1: float, k2: float, alpha: float
) -> tuple[float, float]:
    """One step of the linear high-gain differentiator (docs/model.md#comparison-differentiators) [lineage]: (x1+, x2+).

    x1' = x2 - (k1/α) (x1 - v),   x2' = -(k2/α²) (x1 - v);   x2 is the derivative's estimate
    """
    error = x1 - signal
    return x1 + dt * (x2 - k1 / alpha * error), x2 - dt * k2 / (alpha * alpha) * error


def explicit_step(x: ArrayLike, signal: ArrayLike, dt_s: float, *, epsilon: float) -> Floats:
    """Finite-time differentiators by one explicit Euler step (docs/model.md#differentiator) [lineage].

    Arguments and result are those of `differentiator.step`, but the signal is that of the step's start.

    Raises:
        ValueError: ε or the step is not positive and finite, or the shapes are not (..., 3) and (...).
    """
    _require(dt_s=dt_s, epsilon=epsilon)
    return _rows(lambda row, v: explicit(row[0], row[1], row[2], v, dt_s, epsilon), x, signal, 3)


def sliding_mode_step(
    x: ArrayLike, signal: ArrayLike, dt_s: float, *, alpha: float = SLIDING_ALPHA, lambda_: float = SLIDING_LAMBDA
) -> Floats:
    """One explicit Euler step of Levant's sliding-mode differentiators (docs/model.md#comparison-differentiators)
    [lineage].

    Args:
        x: (..., 3), x, u1 and u: the signal's estimate and two of its derivative, in units of the signal and of the
            signal per s. Levant's output is u; it belongs to the step's start and is only written.
        signal: (...), the signal at the start of the step.
        dt_s: the step.
        alpha: α, units of the signal per s², greater than the size of the signal's second derivative.
        lambda_: λ, root of the units of the signal per s.

    Returns:
        (..., 3), one step later.

    Raises:
        ValueError: a gain or the step is not positive and finite, or the shapes are not (..., 3) and (...).
    """
    _require(dt_s=dt_s, alpha=alpha, lambda_=lambda_)
    return _rows(lambda row, v: sliding_mode(row[0], row[1], v, dt_s, alpha, lambda_), x, signal, 3)


def high_gain_step(
    x: ArrayLike,
    signal: ArrayLike,
    dt_s: float,
    *,
    k1: float = HIGH_GAIN_K1,
    k2: float = HIGH_GAIN_K2,
    alpha: float = HIGH_GAIN_ALPHA,
) -> Floats:
    """One explicit Euler step of linear high-gain differentiators (docs/model.md#comparison-differentiators) [lineage].

    Args:
        x: (..., 2), x1 and x2: estimates of the signal and of its derivative.
        signal: (...), the signal at the start of the step.
        dt_s: the step.
        k1, k2: gains without unit; alpha: α, s.

    Returns:
        (..., 2), one step later.

    Raises:
        ValueError: a gain or the step is not positive and finite, or the shapes are not (..., 2) and (...).
    """
    _require(dt_s=dt_s, k1=k1, k2=k2, alpha=alpha)
    return _rows(lambda row, v: high_gain(row[0], row[1], v, dt_s, k1, k2, alpha), x, signal, 2)


def _require(**positive: float) -> None:
    for name, value in positive.items():
        if not 0.0 < value < math.inf:
            raise ValueError(f"{name} is {value!r}, but it must be greater than 0 and finite")


def _rows(one: Callable[..., tuple[float, ...]], x: ArrayLike, signal: ArrayLike, width: int) -> Floats:
    memory, v = np.asarray(x, dtype=np.float64), np.asarray(signal, dtype=np.float64)
    if memory.shape[-1:] != (width,) or memory.shape[:-1] != v.shape:
        raise ValueError(f"x and signal have shapes {memory.shape} and {v.shape}, but need (..., {width}) and (...)")
    pairs = zip(memory.reshape(-1, width).tolist(), v.reshape(-1).tolist(), strict=True)
    return np.array([one(row, value) for row, value in pairs], dtype=np.float64).reshape(memory.shape)
