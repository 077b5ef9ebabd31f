"""How near vehicles of a recording came to each other and to their plans, over all ticks."""

from __future__ import annotations

from typing import Any

import cython
import numpy as np
from cython.cimports.gcs.telemetry.approach import find_pair
from cython.cimports.gcs.telemetry.metrics import distance_to_path
from cython.cimports.libc import math
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
_ROUNDING_S = 1e-6


def fill_separations(at: Floats, t_s: Floats, partners: Floats, separation: Floats, pair: Ints) -> None:
    """Fill the least distance (k,) in the interval up to each tick, and the rows of its pair (k, 2), from places
    (k, n, 3), NaN for not flying.

    partners (m, 4): rows of a pair, and from when to when its distance does not count.
    """
    n = at.shape[1]
    here, before = np.empty((2, n, 3))
    rows, place = np.empty((2, n), np.int64)
    close = np.empty((len(partners), 2), np.int64)
    straight, found, ours = np.empty((0, 3)), np.empty((0, 4)), np.ones(n, np.uint8)
    at = np.ascontiguousarray(at)
    _fill(at, t_s, partners, separation, pair, here, before, rows, place, close, straight, found, ours)


def _fill(
    at: Floats, t_s: Floats, partners: Floats, separation: Floats, pair: Ints, here: Floats, before: Floats, rows: Ints,
    place: Ints, close: Ints, straight: Floats, found: Floats, ours: Any,
) -> None:  # fmt: skip
    for k in range(at.shape[0]):
        count = 0
        for row in range(at.shape[1]):
            place[row] = -1
            if math.isnan(at[k, row, 0]):
                continue
            rows[count], place[row] = row, count
            began = k > 0 and not math.isnan(at[k - 1, row, 0])
            for axis in range(3):
                here[count, axis] = at[k, row, axis]
                before[count, axis] = at[k - 1, row, axis] if began else at[k, row, axis]
            count += 1
        kept = 0
        for s in range(partners.shape[0]):
            until_s = partners[s, 3] - 1e-6
            ceased = k > 0 and t_s[k - 1] < until_s  # they were partners when the interval began
            if partners[s, 2] - 1e-6 <= t_s[k] and (t_s[k] < until_s or ceased):
                close[kept, 0] = place[cython.cast(cython.Py_ssize_t, partners[s, 0])]
                close[kept, 1] = place[cython.cast(cython.Py_ssize_t, partners[s, 1])]
                kept += 1
        least = find_pair(
            before, here, straight, straight, count, False, 0.0, ours, close, kept, 0.0, math.INFINITY, found
        )
        if least.one >= 0:
            separation[k] = least.distance_m
            pair[k, 0], pair[k, 1] = rows[least.one], rows[least.other]


def fill_errors(
    t_s: Floats,
    plan: Floats,
    reported_s: Floats,
    at: Floats,
    period_s: float,
    pause_s: float,
    memory: int,
    found: Floats,
) -> None:
    """Fill the distance (n,) of places (n, 3), reported as of reported_s (n,), to the polyline of the `memory` latest
    points by then of a plan (k, 3) with times t_s (k,). It stays as it is where the last of them holds no more, or they
    are not so many without a pause."""
    since, k = 0, -1
    for i in range(reported_s.shape[0]):
        while k + 1 < t_s.shape[0] and t_s[k + 1] <= reported_s[i] + _ROUNDING_S:
            k += 1
            if k > 0 and t_s[k] - t_s[k - 1] > pause_s:
                since = k
        if k - since + 1 >= memory and reported_s[i] - t_s[k] < period_s - _ROUNDING_S:
            path = cython.address(plan[k - memory + 1, 0])
            found[i] = distance_to_path(path, memory, 0, memory, at[i, 0], at[i, 1], at[i, 2])
