"""Winner-take-all competition (docs/model/competition.md#competition; paper eqs. 1, 2, 22, 26-28) [lineage].

    v_i' = c (τ_i - Σ_j v_j^p) v_i

`simulate` knows noise, delay and a τ that changes, for the paper's Figs. 11, 13 and 14;
`skytender.winner_take_all` is the law without them. v and τ have no unit.
"""

import math
from collections.abc import Callable
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from gcs.refuelling.simulated_steps import step_block
from skytender import elementwise
from skytender.normal import standard_normal
from skytender.winner_take_all import (
    FloatArray,
    advance,
    drive_of,
    finite,
    require_exponent,
    require_positive,
    states_of,
)

TauOfTime = Callable[[float], ArrayLike]

_LONGEST_STEP_S = 0.001
_SHORTEST_STEP_S = 1e-6
_BLOCK = 1024  # steps between two returns to Python: bounds the memory of noise and τ
_FASTEST = 0.5  # of a step: what the law may change its states by


def simulate(
    v0: ArrayLike,
    tau: ArrayLike | TauOfTime,
    times_s: ArrayLike,
    *,
    p: float,
    rate: float,
    noise_variance: float = 0.0,
    noise_hold_s: float = 0.001,
    noise: Literal["held", "sde"] | None = None,
    delay_s: ArrayLike | None = None,
    seed: int = 0,
) -> FloatArray:
    """States (k, n) at `times_s` (k,) of a competition with noise, delay or changing τ
    (docs/model/competition.md#noise-and-delay) [lineage].

        v_i' = c (τ_i(t) - Σ_j |v_j(t)|^p) v_i(t - d_i) + ϑ_i(t),    v(t) = v0 up to the first time

    That is the paper's robustness analysis (Figs. 13, 14): noise is added to each v_i', and a delay sits in v_i alone,
    not in the norm. With noise or delay v may cross zero, hence |v|.

    Args:
        v0: (n,), >= 0, the states at times_s[0], without unit.
        tau: without unit, > 0: (n,) constant; (k, n), row j from times_s[j] until times_s[j + 1]; or a function of the
            time in s that gives (n,), smooth within a step.
        times_s: (k,), s, increasing.
        p: exponent of the norm, >= 1.
        rate: c, 1/s, > 0.
        noise_variance: σ², variance of ϑ_i in 1/s² where it is held; where noise is "sde" its intensity, in 1/s.
        noise_hold_s: how long a sample of held noise lasts, s.
        noise: "held" draws ϑ_i from N(0, σ²) afresh after every noise_hold_s; "sde" is dv_i = … dt + σ dW_i.
        delay_s: (n,), d_i >= 0, s; None is no delay.
        seed: of the noise. The same seed gives the same path whatever `times_s` within it are asked for.

    Returns:
        (k, n); the first row is v0. With neither noise, delay nor a function of time it is `advance`, exact; else steps
        of at most 1 ms by the classic Runge-Kutta method, where delayed states are interpolated to its order.

    Raises:
        ValueError: an argument out of its range or of the wrong shape, by name; or a law too fast for the steps.
        ArithmeticError: the states grew beyond all bounds, as too long a delay makes them.
    """
    start, times = states_of(v0, "v0"), finite("times_s", times_s)
    require_exponent(p)
    require_positive("rate", rate)
    require_positive("noise_hold_s", noise_hold_s)
    if times.size == 0 or (np.diff(times) <= 0).any():
        raise ValueError("competition: times_s must hold at least one time, and increase")
    if not (math.isfinite(noise_variance) and noise_variance >= 0):
        raise ValueError(f"competition: noise_variance is {noise_variance!r}; it must be finite and at least 0")
    if noise not in {"held", "sde", None} or (noise is None and noise_variance > 0):
        raise ValueError(f"competition: noise is {noise!r}; with a variance it must be 'held' or 'sde'")
    delays = np.zeros(start.size) if delay_s is None else finite("delay_s", delay_s)
    if delays.shape != start.shape or (delays < 0).any():
        raise ValueError(f"competition: delay_s is {delays!r}; it must be ({start.size},) and at least 0")
    rows = None if callable(tau) else _rows_of_tau(tau, start, times)
    if rows is not None and noise_variance == 0 and not delays.any():
        return _exact(start, rows, times, p, rate)

    step_s, steps_of_hold = _grid(delays, noise_hold_s if noise == "held" and noise_variance > 0 else None)
    deviation = math.sqrt(noise_variance / (1.0 if noise == "held" else step_s))
    generator = np.random.default_rng(seed)
    v, out = start.copy(), np.empty((times.size, start.size))
    history = np.zeros((3, math.ceil(delays.max(initial=0.0) / step_s) + 2, start.size))
    held, drawn = np.zeros((1, start.size)), 0  # the present sample of the noise, and how many there were
    wanted = (times - times[0]) / step_s
    following = 0
    for first in range(0, math.floor(wanted[-1]) + 1, _BLOCK):
        steps = first + np.arange(min(_BLOCK, math.floor(wanted[-1]) + 1 - first))
        drive = _drive_of_steps(tau, rows, times, times[0] + step_s * steps, step_s, start.shape)
        if first == 0:
            _require_slow(v, drive, p, rate, step_s)
        sample = steps // steps_of_hold + 1
        pool = np.concatenate([held, deviation * standard_normal(generator, int(sample[-1]) - drawn, start.size)])
        draws = pool[sample - drawn]
        held, drawn = pool[-1:], int(sample[-1])
        following = step_block(
            v,
            history,
            start,
            drive,
            draws,
            delays / step_s,
            wanted,
            out,
            first,
            following,
            step_s,
            float(p),
            float(rate),
        )
        if not np.isfinite(v).all():
            raise ArithmeticError(
                f"competition: the states grew beyond all bounds before {times[0] + step_s * steps[-1]:g} s"
            )
    out[0] = start
    return out


def _exact(start: FloatArray, rows: FloatArray, times: FloatArray, p: float, rate: float) -> FloatArray:
    """`advance` at every time: from the start where τ is constant, else from time to time."""
    out = np.empty((times.size, start.size))
    out[0] = start
    for k in range(1, times.size):
        origin, since = (start, times[0]) if len(rows) == 1 else (out[k - 1], times[k - 1])
        drive = rows[0] if len(rows) == 1 else rows[k - 1]
        out[k] = advance(origin, drive, float(times[k] - since), p=p, rate=rate)
    return out


def _rows_of_tau(tau: ArrayLike, start: FloatArray, times: FloatArray) -> FloatArray:
    """τ as (1, n) where it is constant, or (k, n)."""
    array = np.asarray(tau, dtype=np.float64)
    if array.ndim == 2:
        if array.shape != (times.size, start.size):
            raise ValueError(f"competition: tau has shape {array.shape}; it must be ({times.size}, {start.size})")
        return np.array([drive_of(row, start.shape) for row in array])
    return drive_of(array, start.shape)[np.newaxis]


def _drive_of_steps(
    tau: ArrayLike | TauOfTime,
    rows: FloatArray | None,
    times: FloatArray,
    starts_s: FloatArray,
    step_s: float,
    shape: tuple[int, ...],
) -> FloatArray:
    """τ (m, 3, n) at the start, middle and end of m steps; a row of it counts for the steps whose middles it holds."""
    if callable(tau):
        nodes_s = np.append(np.repeat(starts_s, 2), starts_s[-1] + step_s)
        nodes_s[1::2] += 0.5 * step_s
        nodes = np.array([drive_of(tau(float(t)), shape) for t in nodes_s])
        return np.stack([nodes[:-1:2], nodes[1::2], nodes[2::2]], axis=1)
    assert rows is not None
    at = np.searchsorted(times, starts_s + 0.5 * step_s, side="right") - 1
    of_steps = rows[np.minimum(at, len(rows) - 1)]
    return np.repeat(of_steps[:, np.newaxis], 3, axis=1)


def _grid(delays: FloatArray, hold_s: float | None) -> tuple[float, int]:
    """Step, and steps that one sample of noise lasts: no step is longer than a delay or than what is held."""
    longest = min(_LONGEST_STEP_S, float(delays[delays > 0].min(initial=math.inf)))
    if longest < _SHORTEST_STEP_S:
        raise ValueError(f"competition: delay_s is {longest!r}; it must be 0 or at least {_SHORTEST_STEP_S:g} s")
    if hold_s is None:
        return longest, 1
    if hold_s < _SHORTEST_STEP_S:
        raise ValueError(f"competition: noise_hold_s is {hold_s!r}; it must be at least {_SHORTEST_STEP_S:g} s")
    steps = math.ceil(hold_s / longest * (1.0 - 1e-12))
    return hold_s / steps, steps


def _require_slow(v: FloatArray, drive: FloatArray, p: float, rate: float, step_s: float) -> None:
    with np.errstate(over="ignore"):
        fastest = rate * max(float(drive.max(initial=0.0)), p * float(elementwise.powers(np.abs(v), p).sum()))
    if not fastest * step_s <= _FASTEST:
        raise ValueError(
            f"competition: rate * max(tau, p * sum(v**p)) is {fastest:.3g} 1/s; noise, delay and a tau of time are "
            f"computed in steps of {step_s:g} s, so it must be at most {_FASTEST / step_s:g}"
        )
