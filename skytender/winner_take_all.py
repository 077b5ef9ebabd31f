"""Winner-take-all competition (docs/model/competition.md#competition; paper eqs. 1, 2, 22) [lineage].

    v_i' = c (τ_i - Σ_j v_j^p) v_i

The largest τ wins: its v settles at τ^(1/p), every other goes to zero. v and τ have no unit.
"""

from __future__ import annotations

import math
import sys

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skytender import closed_form, elementary, elementwise

FloatArray = NDArray[np.float64]
_LARGEST, _SMALLEST = sys.float_info.max, math.ulp(0.0)


def advance(v: ArrayLike, tau: ArrayLike, dt_s: float, *, p: float, rate: float) -> FloatArray:
    """States (n,) after `dt_s` seconds with `tau` constant: the exact solution
    (docs/model/competition.md#exact-solution; paper eqs. 1, 2) [lineage].

    v (n,) >= 0 and tau (n,) > 0 have no unit, p >= 1, and rate = c > 0 in 1/s; all finite, else ValueError.
    Computed in logarithms relative to the leader, so neither growth nor decay overflows; a loser far below the smallest
    float becomes 0, and a v of 0 stays 0 (`revive` between calls prevents both).
    """
    v_now, drive = states_of(v), drive_of(tau, np.shape(v)[:1])
    require_exponent(p)
    require_positive("rate", rate)
    require_span(dt_s)
    if dt_s == 0 or not v_now.any():
        return v_now.copy()
    return elementwise.exponentials(
        closed_form.advanced(elementwise.logarithms(v_now), np.ascontiguousarray(drive), p * rate * dt_s, p)
    )


def advance_ln(ln_v: ArrayLike, tau: ArrayLike, dt_s: float, *, p: float, rate: float) -> FloatArray:
    """The same of the states' logarithms (n,), finite, so that no ratio is lost to the range of floats
    (docs/model/competition.md#k-winners)."""
    ln_now, drive = finite("ln_v", ln_v), drive_of(tau, np.shape(ln_v)[:1])
    require_exponent(p)
    require_positive("rate", rate)
    require_span(dt_s)
    if dt_s == 0 or not ln_now.size:
        return ln_now.copy()
    return closed_form.advanced(np.ascontiguousarray(ln_now), np.ascontiguousarray(drive), p * rate * dt_s, p)


def normalise(x: ArrayLike, *, low: float, high: float, largest_wins: bool = True) -> FloatArray:
    """Competition inputs τ (n,) in [low, high] by min-max (paper eq. 22) [lineage].

    The largest of `x` (n,) becomes `high` and the smallest `low`, or the reverse when the smallest is to win. When all
    are equal there is nothing to scale: the first becomes `high` and the others `low`, so that in the order of system
    ids the lowest is first (docs/protocol/energy.md#refuelling-schedule). One alone is `high`.
    ValueError unless x is finite and 0 < low < high, both finite.
    """
    values = finite("x", x)
    require_positive("low", low)
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
    (docs/protocol/energy.md#refuelling-schedule) [choice]."""
    require_positive("floor", floor)
    return np.asarray(np.maximum(finite("v", v), floor))


def share(v: ArrayLike, p: float, floor: float) -> float:
    """The winner's share, 0..1, of Σ v^p less the floor's own share (docs/protocol/energy.md#refuelling-schedule)
    [choice].

    What each v^p holds above floor^p counts, the winner's and the others' alike: 1 when all others lie on the floor, 0
    while no vehicle has left it. Without this, a thousand revived losers would outweigh any winner.
    ValueError unless v (n,) is finite and >= 0, p >= 1 and floor > 0.
    """
    require_positive("floor", floor)
    require_exponent(p)
    above = elementwise.powers(revive(v, floor), p) - elementary.pow(floor, p)
    total = float(above.sum())
    return float(above.max()) / total if total > 0 else 0.0


def finite(name: str, value: ArrayLike) -> FloatArray:
    array = np.asarray(value, dtype=np.float64)
    if array.ndim != 1:
        raise ValueError(f"competition: {name} has shape {array.shape}; it must be (n,)")
    if not closed_form.all_at_least(array, -_LARGEST):
        at = int(np.flatnonzero(~np.isfinite(array))[0])
        raise ValueError(f"competition: {name} is {array[at]!r} at {at}; it must be finite")
    return array


def states_of(v: ArrayLike, name: str = "v") -> FloatArray:
    states = finite(name, v)
    if not closed_form.all_at_least(states, 0.0):
        raise ValueError(f"competition: {name} is {states.min()!r} at {int(states.argmin())}; it must be at least 0")
    return states


def drive_of(tau: ArrayLike, shape: tuple[int, ...]) -> FloatArray:
    drive = finite("tau", tau)
    if drive.shape != shape:
        raise ValueError(f"competition: tau has shape {drive.shape} and v {shape}; they must agree")
    if not closed_form.all_at_least(drive, _SMALLEST):
        raise ValueError(f"competition: tau is {drive.min()!r} at {int(drive.argmin())}; it must be above 0")
    return drive


def require_span(dt_s: float) -> None:
    if not (math.isfinite(dt_s) and dt_s >= 0):
        raise ValueError(f"competition: dt_s is {dt_s!r}; it must be finite and at least 0")


def require_exponent(p: float) -> None:
    if not (math.isfinite(p) and p >= 1):
        raise ValueError(f"competition: p is {p!r}; it must be finite and at least 1")


def require_positive(name: str, value: float) -> None:
    if not (math.isfinite(value) and value > 0):
        raise ValueError(f"competition: {name} is {value!r}; it must be finite and above 0")
