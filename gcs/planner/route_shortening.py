"""Shortening and tightening of a path through a grid, so that its legs keep what they kept before.

Legs in a row that keep the clearance wanted, and legs in a row through a gap too narrow for it, are pulled each by
themselves: to the fewest places that see each other, legs of gaps then moved to the middle, then each place moved
towards the line between its neighbours, and what has become needless left out. No leg crosses a fence's
wall; lengths in metres.
"""

from __future__ import annotations

from typing import Any

import cython
import numpy as np
from cython.cimports.gcs.planner.line_of_sight import clearance_between
from cython.cimports.libc import math

from gcs.planner.line_of_sight import FloatArray, Sight, leg_clearances

_ROUNDING_M = 1e-7
_TIGHTEN_ROUNDS, _HALVINGS = 4, 6  # [choice] routes are then within 3 % of the shortest
_CENTRE_STEPS = 12  # [choice] each halves the step where nothing is gained: 1/16 of a cell in the end


def _keeps(s: Any, a: Any, b: Any, level: float) -> bool:
    """Whether the leg between two places keeps `level` m."""
    least = level - _ROUNDING_M
    return clearance_between(s, a, b, level, least) >= least


def pulled(s: Sight, path: FloatArray, clearance: float, narrow: float, cell: float, floor_d: float) -> FloatArray:
    """The path (k, 3) with fewer places and shorter.

    Legs in a row that keep the clearance, and legs in a row through a gap, are pulled each by themselves, to keep the
    clearance or the least that the gap's legs had. Legs below `narrow`, out of an obstacle, are left as they are.
    """
    legs = leg_clearances(s, path)
    count = legs.shape[0]
    places = np.empty((count + 1, 3))
    kept, level = places, np.empty(count)
    size = _pull(
        cython.address(s.bins), cython.address(path[0, 0]), cython.address(legs[0]), count, clearance, narrow, cell,
        floor_d, cython.address(kept[0, 0]), cython.address(level[0]),
    )  # fmt: skip
    return places[:size].copy()


def _pull(
    s: Any, path: Any, legs: Any, count: int, clearance: float, narrow: float, cell: float, floor_d: float, kept: Any,
    level: Any,
) -> int:  # fmt: skip
    """Write the places kept, (count + 1, 3), and their legs' levels, (count,); how many places these are."""
    _copy(path, kept)
    size = 1
    first = 0
    while first < count:
        kind = _kind(legs[first], clearance, narrow)
        end = first + 1
        least = legs[first]
        while end < count and _kind(legs[end], clearance, narrow) == kind:
            least = min(least, legs[end])
            end += 1
        at = first
        while at < end:
            to = at + 1
            while kind > 0 and to < end and _keeps(s, path + 3 * at, path + 3 * (to + 1), least):
                to += 1
            level[size - 1] = least if kind > 0 else min(legs[at], clearance)
            _copy(path + 3 * to, kept + 3 * size)
            size += 1
            at = to
        first = end
    for i in range(1, size - 2):
        if level[i] < clearance:
            _centre(s, kept, level, i, clearance, cell, floor_d)
    for _ in range(_TIGHTEN_ROUNDS):
        for i in range(1, size - 1):
            _tighten(s, kept, level, i)
        size = _thinned(s, kept, level, size)
    return size


def _copy(place: Any, to: Any) -> None:
    to[0], to[1], to[2] = place[0], place[1], place[2]


def _kind(leg: float, clearance: float, narrow: float) -> int:
    if leg >= clearance - _ROUNDING_M:
        return 2
    return 1 if leg >= narrow else 0


def _centre(s: Any, kept: Any, level: Any, i: int, clearance: float, cell: float, floor_d: float) -> None:
    """Move leg i, through a gap, sideways by less than a cell to where it keeps most; raises its level."""
    before, first, second, after = kept + 3 * (i - 1), kept + 3 * i, kept + 3 * (i + 1), kept + 3 * (i + 2)
    a, b = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
    step = cell / 2.0
    for _ in range(_CENTRE_STEPS):
        moved = False
        for axis in range(3):
            for side in range(2):
                way = step if side == 1 else -step
                _copy(first, a)
                _copy(second, b)
                a[axis] += way
                b[axis] += way
                if max(a[2], b[2]) > floor_d or not _keeps(s, a, b, min(level[i] + 0.1 * step, clearance)):
                    continue
                if _keeps(s, before, a, level[i - 1]) and _keeps(s, b, after, level[i + 1]):
                    _copy(a, first)
                    _copy(b, second)
                    level[i] = clearance_between(s, a, b, clearance, -math.INFINITY)
                    moved = True
        if level[i] >= clearance:
            break
        if not moved:
            step /= 2.0


def _tighten(s: Any, kept: Any, level: Any, i: int) -> None:
    """Move place i towards the line between its neighbours as far as both legs keep their level."""
    before, at, after = kept + 3 * (i - 1), kept + 3 * i, kept + 3 * (i + 1)
    place, chord, foot, moved = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
    _copy(at, place)
    square = along = 0.0
    for axis in range(3):
        chord[axis] = after[axis] - before[axis]
        square += chord[axis] * chord[axis]
        along += (place[axis] - before[axis]) * chord[axis]
    t = 0.0 if square == 0.0 else min(max(along / square, 0.0), 1.0)
    for axis in range(3):
        foot[axis] = before[axis] + t * chord[axis]
    low, high, middle = 0.0, 1.0, 1.0
    for _ in range(_HALVINGS):
        for axis in range(3):
            moved[axis] = place[axis] + middle * (foot[axis] - place[axis])
        if _keeps(s, before, moved, level[i - 1]) and _keeps(s, moved, after, level[i]):
            low = middle
        else:
            high = middle
        if low == 1.0:
            break
        middle = (low + high) / 2.0
    for axis in range(3):
        at[axis] = place[axis] + low * (foot[axis] - place[axis])


def _thinned(s: Any, kept: Any, level: Any, size: int) -> int:
    """Leave out, in place, what the leg between its neighbours makes needless; how many are left."""
    count = 1
    for i in range(1, size):
        needed = i == size - 1
        if not needed:
            least = max(level[count - 1], level[i])
            lowest = min(level[count - 1], level[i])
            needed = lowest <= 0.0 or not _keeps(s, kept + 3 * (count - 1), kept + 3 * (i + 1), least)
        if needed:
            _copy(kept + 3 * i, kept + 3 * count)
            if i < size - 1:
                level[count] = level[i]
            count += 1
        else:
            level[count - 1] = max(level[count - 1], level[i])
    return count
