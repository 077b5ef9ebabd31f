"""Winner-take-all competition (model.md 8; paper eqs. 1, 2, 22, 26-28) [lineage].

    v_i' = c (τ_i - Σ_j v_j^p) v_i

The largest τ wins: its v settles at τ^(1/p), every other goes to zero.
"""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]


def advance(v: ArrayLike, tau: ArrayLike, dt_s: float, *, p: float, rate: float) -> FloatArray:
    """States (n,) after `dt_s` seconds with `tau` constant: the exact solution (model.md 8) [lineage].

    v (n,) >= 0, tau (n,) > 0, p > 0 (the paper's are at least 1) and rate = c > 0 in 1/s; all finite, else ValueError.
    Computed in logarithms relative to the leader, so neither growth nor decay overflows; a loser far below the smallest
    float becomes 0, and a v of 0 stays 0 (`revive` between calls prevents both).

    With w = v^p, a = p c, and k the largest of w_i e^(a τ_i t):
    ln w_i = z_i - ln(e^(-x_k)/w_k + Σ_j e^(z_j) (1 - e^(-x_j))/τ_j),  x_j = a τ_j t,  z_i = ln(w_i/w_k) + x_i - x_k
    """
    v_now, drive = _finite("v", v), _finite("tau", tau)
    if v_now.shape != drive.shape:
        raise ValueError(f"competition: v has shape {v_now.shape} and tau {drive.shape}; they must agree")
    if (v_now < 0).any():
        raise ValueError(f"competition: v is {v_now.min()!r} at {int(v_now.argmin())}; it must be at least 0")
    if (drive <= 0).any():
        raise ValueError(f"competition: tau is {drive.min()!r} at {int(drive.argmin())}; it must be above 0")
    _positive("p", p)
    _positive("rate", rate)
    if not (math.isfinite(dt_s) and dt_s >= 0):
        raise ValueError(f"competition: dt_s is {dt_s!r}; it must be finite and at least 0")
    if dt_s == 0 or not v_now.any():
        return v_now.copy()

    at = p * rate * dt_s
    with np.errstate(divide="ignore", under="ignore"):
        ln_w = p * np.log(v_now)
        x = at * drive
        k = int((ln_w + x).argmax())
        z = (ln_w - ln_w[k]) + at * (drive - drive[k])
        shares = z + np.log(-np.expm1(-x)) - np.log(drive)
        start = -(ln_w[k] + x[k])
        top = max(start, shares.max())
        ln_sum = top + math.log(math.exp(start - top) + np.exp(shares - top).sum())
        return np.asarray(np.exp((z - ln_sum) / p))


def normalise(x: ArrayLike, *, low: float, high: float, largest_wins: bool = True) -> FloatArray:
    """Competition inputs τ (n,) in [low, high] by min-max (paper eq. 22) [lineage].

    The largest of `x` (n,) becomes `high` and the smallest `low`, or the reverse when the smallest is to win. When all
    are equal there is nothing to scale: the first becomes `high` and the others `low`, so that in the order of system
    ids the lowest is first (contract.md). One alone is `high`.
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
    """States (n,) with every one lifted to `floor` > 0, so that a loser can win later (contract.md) [choice]."""
    _positive("floor", floor)
    return np.asarray(np.maximum(_finite("v", v), floor))


def share(v: ArrayLike, p: float, floor: float) -> float:
    """The winner's share, 0..1, of Σ v^p less the floor's own share (contract.md) [choice].

    What each v^p holds above floor^p counts, the winner's and the others' alike: 1 when all others lie on the floor, 0
    while nobody has left it. Without this, a thousand revived losers would outweigh any winner.
    ValueError unless v (n,) is finite and >= 0, p > 0 and floor > 0.
    """
    _positive("floor", floor)
    _positive("p", p)
    above = revive(v, floor) ** p - float(floor) ** p
    total = float(above.sum())
    return float(above.max()) / total if total > 0 else 0.0


def _finite(name: str, value: ArrayLike) -> FloatArray:
    array = np.asarray(value, dtype=np.float64)
    if array.ndim != 1:
        raise ValueError(f"competition: {name} has shape {array.shape}; it must be (n,)")
    if not np.isfinite(array).all():
        at = int(np.flatnonzero(~np.isfinite(array))[0])
        raise ValueError(f"competition: {name} is {array[at]!r} at {at}; it must be finite")
    return array


def _positive(name: str, value: float) -> None:
    if not (math.isfinite(value) and value > 0):
        raise ValueError(f"competition: {name} is {value!r}; it must be finite and above 0")
