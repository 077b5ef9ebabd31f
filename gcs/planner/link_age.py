"""Silent and slow links, by the age of vehicles' reports [choice].

A link that loses nothing brings a report in every period: four periods without one are an outage, in which the vehicle
no longer obeys. Where frames are lost or vehicles report seldom, reports are as old as that often. On a slow link all
are old, the newest too.
"""

from __future__ import annotations

import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from numpy.typing import NDArray

from skytender.geometry import FloatArray

_LEAST_S, _MOST_S = 0.35, 1.0
"""Age of a report from which a vehicle is silent, at least and at most."""
_USUAL_SHARE, _SPARE_S = 1.5, 0.2
"""Of the oldest report of late, and beyond it."""
FIRST_S = 0.5
"""Taken for the oldest report before there was one."""
DECAY_S = 10.0
"""The oldest report of late counts by 1/e less after so long."""
SLOW_S = 0.4
"""Age of the newest reports from which a link is slow."""
RISE = 0.1
"""s/s: so slowly the age of the newest report of late rises, so that a second of silence makes no slow link."""


class LinkAge:
    """Oldest report of late of each of n vehicles, at the time when the next one came."""

    def __init__(self, n: int) -> None:
        self._oldest_s = np.full(n, FIRST_S)
        self._last_s = np.full(n, np.nan)
        self.silent = np.zeros(n, np.bool_)
        """(n,) whose last report is older than the link explains"""

    def receive(self, age_s: FloatArray, period_s: float) -> None:
        """Take in the vehicles' ages (n,), once a period."""
        _receive(age_s, period_s, elementary.exp(-period_s / DECAY_S), self._last_s, self._oldest_s, self.silent)


class SlowLinks:
    """Age of the newest report of late of each of n vehicles."""

    def __init__(self, n: int) -> None:
        self._newest_s = np.full(n, np.inf)

    def receive(self, age_s: FloatArray, period_s: float) -> None:
        """Take in the vehicles' ages (n,), once a period."""
        self._newest_s += RISE * period_s
        np.minimum(age_s, self._newest_s, out=self._newest_s)

    def slow(self) -> NDArray[np.bool_]:
        """(n,) of which vehicles whatever they report has been flown long ago; of none before the first ages."""
        return (self._newest_s >= SLOW_S) & (self._newest_s < np.inf)


def _receive(
    age: FloatArray, period: float, decay: float, last: FloatArray, oldest: FloatArray, silent: NDArray[np.bool_]
) -> None:
    """Write the last three; `last` is NaN before there was an age."""
    for row in range(age.shape[0]):
        before = age[row] if math.isnan(last[row]) else last[row]
        most = oldest[row] * decay
        if age[row] < before + 0.5 * period:  # a report has come
            most = max(most, before, age[row])
        last[row], oldest[row] = age[row], min(most, _MOST_S)
        silent[row] = age[row] > min(max(_USUAL_SHARE * oldest[row] + _SPARE_S, _LEAST_S), _MOST_S)
