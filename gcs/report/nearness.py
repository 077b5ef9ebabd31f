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


def fill_errors(t_s: Floats, plan: Floats, at: Floats, longest_s: float, memory: int, found: Floats) -> None:
    """Fill the distance (k,) of places (k, 3) to the polyline of the `memory` latest points of a plan (k, 3); it stays
    as it is where there are not yet so many without a pause longer than `longest_s`, or the place is not known."""
    since = 0
    for k in range(t_s.shape[0]):
        if k > 0 and t_s[k] - t_s[k - 1] > longest_s:
            since = k
        if k - since + 1 >= memory and not math.isnan(at[k, 0]):
            path = cython.address(plan[k - memory + 1, 0])
            found[k] = distance_to_path(path, memory, 0, at[k, 0], at[k, 1], at[k, 2])
