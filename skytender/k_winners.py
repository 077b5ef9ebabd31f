"""The k greatest at once, read off the winner-take-all law as it is (docs/model/competition.md#k-winners) [choice].

    v_i(t)/v_j(t) = v_i(0)/v_j(0) · e^(c (τ_i - τ_j) t)

The law's norm acts on all states alike, so that the ratio of any two is what their bids make it, whatever p is and
whichever vehicle leads. The k greatest are decided once the last of them has left the next one behind. States are kept
as logarithms: a loser's v soon is smaller than any float, its ratio to another loser is not.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skytender import elementary

FloatArray = NDArray[np.float64]


class Competitor(NamedTuple):
    """A competitor and its bid: `time_s`, on an absolute scale; the least is the greatest bid."""

    sysid: int
    ln_v: float
    time_s: float
    rank: tuple[float, ...]
    """in which order vehicles that tie are taken, the least first; no two are alike"""


class Reading(NamedTuple):
    """The k first as the states have it."""

    winners: tuple[int, ...]
    """by system id, in the order of their places"""
    ties: frozenset[int]
    """those that tie with the last of them, that one included"""
    share: float
    """what the last of them holds of its own v^p and of the next one's that does not tie with it, 0.5 to 1"""


def bounded(ln_v: ArrayLike, places: int, floor: float) -> FloatArray:
    """Logarithms of states (n,) drawn together, so that those behind can come back: among the first `places` + 1 none
    lies further behind the one before it than `floor` < 1, and the others no further behind the last of these.

    A state that is drawn up takes all below with it: their ratios stay, unless they reach that end.
    """
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


def read(competitors: Sequence[Competitor], k: int, *, p: float, tie_s: float) -> Reading:
    """The k greatest, 1 <= k < n, by their states; vehicles with bids within `tie_s` of the k-th's take the places
    that they hold among them in the order of `rank`."""
    ordered = sorted(competitors, key=lambda one: (-one.ln_v, one.rank))
    last = ordered[k - 1]
    ties = frozenset(one.sysid for one in ordered if abs(one.time_s - last.time_s) <= tie_s)
    clear = [one.sysid for one in ordered[:k] if one.sysid not in ties]
    tied = sorted((one for one in ordered if one.sysid in ties), key=lambda one: one.rank)
    winners = (*clear, *(one.sysid for one in tied[: k - len(clear)]))
    ahead = next((one for one in ordered[k:] if one.sysid not in ties), None)
    return Reading(winners, ties, 1.0 if ahead is None else share_of(last.ln_v - ahead.ln_v, p))


def meant(competitors: Sequence[Competitor], k: int, *, p: float, tie_s: float) -> Reading:
    """The k that the law comes to name if the bids stay as they are."""
    return read([one._replace(ln_v=-one.time_s) for one in competitors], k, p=p, tie_s=tie_s)


class Standings:
    """Since when each number of winners has been clear without a break: when the states name them, by the share that
    is asked, and the bids mean the same ones."""

    def __init__(self, *, p: float, tie_s: float, share: float) -> None:
        self._p, self._tie_s, self._share = p, tie_s, share
        self._readings: dict[int, Reading] = {}
        self._since_s: dict[int, float] = {}

    def advance(self, competitors: Sequence[Competitor], places: int, now_s: float) -> None:
        """Read the competition at a time, for every k up to `places` that leaves a loser."""
        before, self._readings = self._readings, {}
        for k in range(1, min(places, len(competitors) - 1) + 1):
            now = self._readings[k] = read(competitors, k, p=self._p, tie_s=self._tie_s)
            was, by_bids = before.get(k), meant(competitors, k, p=self._p, tie_s=self._tie_s)
            changed = was is None or not (set(was.winners) ^ set(now.winners)) <= now.ties
            clear = now.share >= self._share and set(now.winners) ^ set(by_bids.winners) <= by_bids.ties
            if changed or not clear:
                self._since_s.pop(k, None)
            if clear:
                self._since_s.setdefault(k, now_s)

    def reading(self, k: int) -> Reading | None:
        """The k first as they were last read; None where all win."""
        return self._readings.get(k)

    def clear_s(self, k: int, now_s: float) -> float:
        """For how long they have been clear; below 0 while they are not."""
        return now_s - self._since_s[k] if k in self._since_s else -1.0

    def without(self, sysid: int) -> None:
        """One has left: what was clear of k places is clear of one less without it."""
        others = {k - 1: now for k, now in self._readings.items() if k > 1 and sysid in now.winners}
        self._since_s = {k: self._since_s[k + 1] for k in others if k + 1 in self._since_s}
        self._readings = {
            k: now._replace(winners=tuple(one for one in now.winners if one != sysid)) for k, now in others.items()
        }


def share_of(ln_ratio: float, p: float) -> float:
    """Share of the first of two in the sum of their v^p, from the logarithm of their ratio."""
    return 1.0 / (1.0 + elementary.exp(-min(p * ln_ratio, 700.0))) if ln_ratio > -700.0 / p else 0.0
