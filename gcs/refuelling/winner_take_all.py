"""Winner-take-all competition (docs/model.md#competition; paper eqs. 1, 2, 22, 26-28) [lineage].

    v_i' = c (τ_i - Σ_j v_j^p) v_i

The largest τ wins: its v settles at τ^(1/p), every other goes to zero. `advance` is exact and what the scheduler uses;
`simulate` also knows noise, delay and a τ that changes, for the paper's Figs. 11, 13 and 14. v and τ have no unit.
"""

import math
from collections.abc import Callable
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gcs.refuelling.winner_take_all_steps import step_block
from skytender import elementary, elementwise
from skytender.normal import standard_normal

FloatArray = NDArray[np.float64]
TauOfTime = Callable[[float], ArrayLike]

_LONGEST_STEP_S = 0.001
_SHORTEST_STEP_S = 1e-6
_BLOCK = 1024  # steps between two returns to Python: bounds the memory of noise and τ
_FASTEST = 0.5  # of a step: what the law may change its states by


def advance(v: ArrayLike, tau: ArrayLike, dt_s: float, *, p: float, rate: float) -> FloatArray:
    """States (n,) after `dt_s` seconds with `tau` constant: the exact solution (docs/model.md#exact-solution; paper
    eqs. 1, 2) [lineage].

    v (n,) >= 0 and tau (n,) > 0 have no unit, p >= 1, and rate = c > 0 in 1/s; all finite, else ValueError.
    Computed in logarithms relative to the leader, so neither growth nor decay overflows; a loser far below the smallest
    float becomes 0, and a v of 0 stays 0 (`revive` between calls prevents both).

    With w = v^p, a = p c, and k the largest of w_i e^(a τ_i t):
    ln w_i = z_i - ln(e^(-x_k)/w_k + Σ_j e^(z_j) (1 - e^(-x_j))/τ_j),  x_j = a τ_j t,  z_i = ln(w_i/w_k) + x_i - x_k
    """
    v_now, drive = _states(v), _drive(tau, np.shape(v)[:1])
    _exponent(p)
    _positive("rate", rate)
    _span(dt_s)
    if dt_s == 0 or not v_now.any():
        return v_now.copy()
    with np.errstate(divide="ignore", under="ignore"):
        return elementwise.exponentials(_advanced(elementwise.logarithms(v_now), drive, dt_s, p, rate))


def advance_ln(ln_v: ArrayLike, tau: ArrayLike, dt_s: float, *, p: float, rate: float) -> FloatArray:
    """The same of the states' logarithms (n,), finite, so that no ratio is lost to the range of floats
    (docs/model.md#k-winners)."""
    ln_now, drive = _finite("ln_v", ln_v), _drive(tau, np.shape(ln_v)[:1])
    _exponent(p)
    _positive("rate", rate)
    _span(dt_s)
    if dt_s == 0 or not ln_now.size:
        return ln_now.copy()
    with np.errstate(under="ignore"):
        return _advanced(ln_now, drive, dt_s, p, rate)


def _advanced(ln_v: FloatArray, drive: FloatArray, dt_s: float, p: float, rate: float) -> FloatArray:
    at = p * rate * dt_s
    ln_w = p * ln_v
    x = at * drive
    k = int((ln_w + x).argmax())
    z = (ln_w - ln_w[k]) + at * (drive - drive[k])
    shares = z + elementwise.logarithms([-elementary.expm1(-one) for one in x]) - elementwise.logarithms(drive)
    start = -(ln_w[k] + x[k])
    top = max(start, shares.max())
    ln_sum = top + elementary.log(elementary.exp(start - top) + elementwise.exponentials(shares - top).sum())
    return np.asarray((z - ln_sum) / p)


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
    """States (k, n) at `times_s` (k,) of a competition with noise, delay or changing τ (docs/model.md#noise-and-delay)
    [lineage].

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
    start, times = _states(v0, "v0"), _finite("times_s", times_s)
    _exponent(p)
    _positive("rate", rate)
    _positive("noise_hold_s", noise_hold_s)
    if times.size == 0 or (np.diff(times) <= 0).any():
        raise ValueError("competition: times_s must hold at least one time, and increase")
    if not (math.isfinite(noise_variance) and noise_variance >= 0):
        raise ValueError(f"competition: noise_variance is {noise_variance!r}; it must be finite and at least 0")
    if noise not in {"held", "sde", None} or (noise is None and noise_variance > 0):
        raise ValueError(f"competition: noise is {noise!r}; with a variance it must be 'held' or 'sde'")
    delays = np.zeros(start.size) if delay_s is None else _finite("delay_s", delay_s)
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


def normalise(x: ArrayLike, *, low: float, high: float, largest_wins: bool = True) -> FloatArray:
    """Competition inputs τ (n,) in [low, high] by min-max (paper eq. 22) [lineage].

    The largest of `x` (n,) becomes `high` and the smallest `low`, or the reverse when the smallest is to win. When all
    are equal there is nothing to scale: the first becomes `high` and the others `low`, so that in the order of system
    ids the lowest is first (docs/protocol.md#refuelling-schedule). One alone is `high`.
    ValueError unless x is finite and 0 < low < high, both finite.
    """
    values = _finite("x", x)
    _positive("low", low)
    if not (math.isfinite(high) and high > low):
        raise ValueError(f"competition: high is {high!r}; it must be finite and above low, {low!r}")
    if values.size == 0:
        return values.copy()
    least, most = values.min(), values.max()
    if least == most:
        tau = np.full(values.shape, float(low))
        tau[0] = high
        return tau
    above = (values - least if largest_wins else most - values) / (most - least)
    return np.asarray(low * (1.0 - above) + high * above)


def revive(v: ArrayLike, floor: float) -> FloatArray:
    """States (n,) with every one lifted to `floor` > 0, so that a loser can win later
    (docs/protocol.md#refuelling-schedule) [choice]."""
    _positive("floor", floor)
    return np.asarray(np.maximum(_finite("v", v), floor))


def share(v: ArrayLike, p: float, floor: float) -> float:
    """The winner's share, 0..1, of Σ v^p less the floor's own share (docs/protocol.md#refuelling-schedule) [choice].

    What each v^p holds above floor^p counts, the winner's and the others' alike: 1 when all others lie on the floor, 0
    while no vehicle has left it. Without this, a thousand revived losers would outweigh any winner.
    ValueError unless v (n,) is finite and >= 0, p >= 1 and floor > 0.
    """
    _positive("floor", floor)
    _exponent(p)
    above = elementwise.powers(revive(v, floor), p) - elementary.pow(floor, p)
    total = float(above.sum())
    return float(above.max()) / total if total > 0 else 0.0


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
        return np.array([_drive(row, start.shape) for row in array])
    return _drive(array, start.shape)[np.newaxis]


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
        nodes = np.array([_drive(tau(float(t)), shape) for t in nodes_s])
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


def _finite(name: str, value: ArrayLike) -> FloatArray:
    array = np.asarray(value, dtype=np.float64)
    if array.ndim != 1:
        raise ValueError(f"competition: {name} has shape {array.shape}; it must be (n,)")
    if not np.isfinite(array).all():
        at = int(np.flatnonzero(~np.isfinite(array))[0])
        raise ValueError(f"competition: {name} is {array[at]!r} at {at}; it must be finite")
    return array


def _states(v: ArrayLike, name: str = "v") -> FloatArray:
    states = _finite(name, v)
    if (states < 0).any():
        raise ValueError(f"competition: {name} is {states.min()!r} at {int(states.argmin())}; it must be at least 0")
    return states


def _drive(tau: ArrayLike, shape: tuple[int, ...]) -> FloatArray:
    drive = _finite("tau", tau)
    if drive.shape != shape:
        raise ValueError(f"competition: tau has shape {drive.shape} and v {shape}; they must agree")
    if (drive <= 0).any():
        raise ValueError(f"competition: tau is {drive.min()!r} at {int(drive.argmin())}; it must be above 0")
    return drive


def _span(dt_s: float) -> None:
    if not (math.isfinite(dt_s) and dt_s >= 0):
        raise ValueError(f"competition: dt_s is {dt_s!r}; it must be finite and at least 0")


def _exponent(p: float) -> None:
    if not (math.isfinite(p) and p >= 1):
        raise ValueError(f"competition: p is {p!r}; it must be finite and at least 1")


def _positive(name: str, value: float) -> None:
    if not (math.isfinite(value) and value > 0):
        raise ValueError(f"competition: {name} is {value!r}; it must be finite and above 0")
