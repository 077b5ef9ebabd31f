"""For how long each pursuer has stayed with its target, or target has had its pursuer: one measure, taken tick by tick
while a session flies, and over all ticks of a recorded one."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from cython.cimports.libc.math import NAN, isnan
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class PursuitHeld:
    """The longest time so far for which each of `keys` was within a distance, from the first to the last tick of it."""

    def __init__(self, keys: Iterable[int], within_m: float) -> None:
        self.keys = list(keys)
        self._within_m = within_m
        self._since_s = np.full(len(self.keys), np.nan)
        self._held_s = np.zeros(len(self.keys))

    @property
    def held_s(self) -> dict[int, float]:
        """By key."""
        return dict(zip(self.keys, self._held_s.tolist(), strict=True))

    @property
    def worst_s(self) -> float:
        """The least of them; 0 without any."""
        return float(self._held_s.min()) if self.keys else 0.0

    def update(self, t_s: Floats, distance_m: Floats) -> Floats:
        """Go on with ticks at (k,), and distances (k, n) of the keys at them, NaN where not known; (k,) the least that
        any key had held by each."""
        worst_s = np.zeros(len(t_s))
        ticks, distances = np.ascontiguousarray(t_s), np.ascontiguousarray(distance_m)
        _update(ticks, distances, self._within_m, self._since_s, self._held_s, worst_s)
        return worst_s


def _update(t_s: Floats, distance_m: Floats, within_m: float, since_s: Floats, held_s: Floats, worst_s: Floats) -> None:
    """Fill worst_s (k,); since_s (n,), NaN for not held, and held_s (n,) go on from call to call."""
    for k in range(t_s.shape[0]):
        for i in range(held_s.shape[0]):
            if not distance_m[k, i] <= within_m:
                since_s[i] = NAN
            elif isnan(since_s[i]):
                since_s[i] = t_s[k]
            else:
                held_s[i] = max(held_s[i], t_s[k] - since_s[i])
        for i in range(held_s.shape[0]):
            worst_s[k] = held_s[i] if i == 0 else min(worst_s[k], held_s[i])
