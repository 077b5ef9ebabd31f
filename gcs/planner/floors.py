"""How low leaders may go."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from skytender.geometry import FloatArray

FLOOR_M = 0.3
"""No leader of a vehicle that has a ground goes lower than this above it: only landing does."""
GROUND_ROUNDING_M = 0.1
"""Difference of a home from height 0 that the wire's rounding alone can cause."""


class Floors:
    """Greatest downs of leaders: above the scenario's height 0 and above the vehicles' own grounds, by their homes."""

    def __init__(self, rows: Iterable[int]) -> None:
        """rows: of vehicles that have a ground."""
        self.rows = np.array(sorted(rows), np.int64)
        self._ground = b""
        self._lowest_d = np.zeros(0)

    def at(self, ground_down_m: FloatArray) -> FloatArray:
        """(n,) m, for homes so far down (n,), NaN where that is unknown; infinite without a ground. Only to be read."""
        ground = ground_down_m.tobytes()
        if ground != self._ground:
            self._ground = ground
            own = ground_down_m[self.rows]
            self._lowest_d = np.full(len(ground_down_m), math.inf)
            self._lowest_d[self.rows] = -FLOOR_M + np.where(own < -GROUND_ROUNDING_M, own, 0.0)
        return self._lowest_d
