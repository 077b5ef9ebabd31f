"""Winner-take-all competition as a vehicle runs it (docs/model.md#exact-solution, docs/model.md#k-winners) [lineage].

    v_i' = c (τ_i - Σ_j v_j^p) v_i

The ground station has the same law in a module of its own, since neither program imports the other; a test holds both
together to the last bit, and to the closed form. States are kept as logarithms.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skytender import elementary, elementwise

FloatArray = NDArray[np.float64]


class Bidder(NamedTuple):
    """A competitor; `time_s` is its bid on the absolute scale, the least is the greatest bid. `rank`: in which order
    those who tie are taken, the least first; no two are alike."""

    sysid: int
    ln_v: float
    time_s: float
    rank: tuple[float, ...]


class Standing(NamedTuple):
    """The k first, in the order of their places; who ties with the last of them; and what that one holds of its own v^p
    and of the next one's that does not tie with it, 0.5 to 1."""

    winners: tuple[int, ...]
    ties: frozenset[int]
    share: float


def advance_ln(ln_v: ArrayLike, tau: ArrayLike, dt_s: float, *, p: float, rate: float) -> FloatArray:
    """Logarithms of the states (n,) after `dt_s` seconds with `tau` (n,) > 0 constant: the exact solution.

    With w = v^p, a = p c, and k the largest of w_i e^(a τ_i t):
    ln w_i = z_i - ln(e^(-x_k)/w_k + Σ_j e^(z_j) (1 - e^(-x_j))/τ_j),  x_j = a τ_j t,  z_i = ln(w_i/w_k) + x_i - x_k
    """
    ln_now, drive = np.asarray(ln_v, dtype=np.float64), np.asarray(tau, dtype=np.float64)
    if dt_s == 0 or not ln_now.size:
        return ln_now.copy()
    with np.errstate(under="ignore"):
        at = p * rate * dt_s
        ln_w = p * ln_now
        x = at * drive
        k = int((ln_w + x).argmax())
        z = (ln_w - ln_w[k]) + at * (drive - drive[k])
        shares = z + elementwise.logarithms([-elementary.expm1(-one) for one in x]) - elementwise.logarithms(drive)
        start = -(ln_w[k] + x[k])
        top = max(start, shares.max())
        ln_sum = top + elementary.log(elementary.exp(start - top) + elementwise.exponentials(shares - top).sum())
        return np.asarray((z - ln_sum) / p)


def bounded(ln_v: ArrayLike, places: int, floor: float) -> FloatArray:
    """Logarithms of states (n,) drawn together, so that who is behind can come back: among the first `places` + 1 none
    lies further behind the one before it than `floor` < 1, and the others no further behind the last of these."""
    values = np.asarray(ln_v, dtype=np.float64)
    if values.size < 2:
        return values.copy()
    order = np.argsort(-values, kind="stable")
    gaps = -np.diff(values[order])
    deepest = -elementary.log(floor)
    gaps[:places] = np.minimum(gaps[:places], deepest)
    below = np.concatenate([[0.0], np.cumsum(gaps)])
    last = below[min(places, len(below) - 1)]
    below = np.minimum(below, last + deepest)
    drawn = np.empty_like(values)
    drawn[order] = values[order[0]] - below
    return drawn


def standing(bidders: Sequence[Bidder], k: int, *, p: float, tie_s: float) -> Standing:
    """The k greatest, 1 <= k < n, by their states; those whose bids lie within `tie_s` of the k-th's take what places
    they hold among them in the order of `rank`."""
    ordered = sorted(bidders, key=lambda one: (-one.ln_v, one.rank))
    last = ordered[k - 1]
    ties = frozenset(one.sysid for one in ordered if abs(one.time_s - last.time_s) <= tie_s)
    clear = [one.sysid for one in ordered[:k] if one.sysid not in ties]
    tied = sorted((one for one in ordered if one.sysid in ties), key=lambda one: one.rank)
    winners = (*clear, *(one.sysid for one in tied[: k - len(clear)]))
    ahead = next((one for one in ordered[k:] if one.sysid not in ties), None)
    return Standing(winners, ties, 1.0 if ahead is None else share_of(last.ln_v - ahead.ln_v, p))


def share_of(ln_ratio: float, p: float) -> float:
    """Share that the first of two holds of the sum of their v^p, for the logarithm of their ratio."""
    return 1.0 / (1.0 + elementary.exp(-min(p * ln_ratio, 700.0))) if ln_ratio > -700.0 / p else 0.0
