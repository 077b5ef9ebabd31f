"""Shortening and tightening of a path through a grid, so that its legs keep what they kept before.

Legs in a row that keep the clearance wanted, and legs in a row through a gap too narrow for it, are pulled each by
themselves: to the fewest places that see each other, legs of gaps then moved to the middle, then each place moved
towards the line between its neighbours, and what has become needless left out. Compiled; no leg crosses a fence's
wall; lengths in metres.
"""

from __future__ import annotations

import numpy as np

from gcs.kernels import kernel
from gcs.planner.line_of_sight import FloatArray, Sight, clear_m, leg_clearances

_TIGHTEN_ROUNDS, _HALVINGS = 4, 6  # [choice] routes are then within 3 % of the shortest
_CENTRE_STEPS = 12  # [choice] each halves the step where nothing is gained: 1/16 of a cell in the end


@kernel()
def _keeps(s: Sight, a: FloatArray, b: FloatArray, level: float) -> bool:
    """Kernel: whether the leg keeps `level` m."""
    least = level - 1e-7
    return clear_m(s, a, b, level, least) >= least


@kernel()
def pulled(s: Sight, path: FloatArray, clearance: float, narrow: float, cell: float, floor_d: float) -> FloatArray:
    """Kernel: the path with fewer places and shorter.

    Legs in a row that keep the clearance, and legs in a row through a gap, are pulled each by themselves, to keep the
    clearance or the least that the gap's legs had. Legs below `narrow`, out of an obstacle, are left as they are.
    """
    legs = leg_clearances(s, path)
    count = legs.shape[0]
    kept = np.empty_like(path)
    level = np.empty(count)
    kept[0] = path[0]
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
            while kind > 0 and to < end and _keeps(s, path[at], path[to + 1], least):
                to += 1
            level[size - 1] = least if kind > 0 else min(legs[at], clearance)
            kept[size] = path[to]
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
    return kept[:size].copy()


@kernel()
def _kind(leg: float, clearance: float, narrow: float) -> int:
    if leg >= clearance - 1e-7:
        return 2
    return 1 if leg >= narrow else 0


@kernel()
def _centre(
    s: Sight, kept: FloatArray, level: FloatArray, i: int, clearance: float, cell: float, floor_d: float
) -> None:
    """Kernel: move leg i, through a gap, sideways by less than a cell to where it keeps most; raises its level."""
    step = cell / 2.0
    for _ in range(_CENTRE_STEPS):
        moved = False
        for axis in range(3):
            for way in (-step, step):
                a, b = kept[i].copy(), kept[i + 1].copy()
                a[axis] += way
                b[axis] += way
                if max(a[2], b[2]) > floor_d or not _keeps(s, a, b, min(level[i] + 0.1 * step, clearance)):
                    continue
                if _keeps(s, kept[i - 1], a, level[i - 1]) and _keeps(s, b, kept[i + 2], level[i + 1]):
                    kept[i], kept[i + 1] = a, b
                    level[i] = clear_m(s, a, b, clearance)
                    moved = True
        if level[i] >= clearance:
            break
        if not moved:
            step /= 2.0


@kernel()
def _tighten(s: Sight, kept: FloatArray, level: FloatArray, i: int) -> None:
    """Kernel: move place i towards the line between its neighbours as far as both legs keep their level."""
    before, after, place = kept[i - 1], kept[i + 1], kept[i].copy()
    chord = after - before
    square = (chord**2).sum()
    t = 0.0 if square == 0.0 else min(max(((place - before) * chord).sum() / square, 0.0), 1.0)
    foot = before + t * chord
    low, high, middle = 0.0, 1.0, 1.0
    for _ in range(_HALVINGS):
        moved = place + middle * (foot - place)
        if _keeps(s, before, moved, level[i - 1]) and _keeps(s, moved, after, level[i]):
            low = middle
        else:
            high = middle
        if low == 1.0:
            break
        middle = (low + high) / 2.0
    kept[i] = place + low * (foot - place)


@kernel()
def _thinned(s: Sight, kept: FloatArray, level: FloatArray, size: int) -> int:
    """Kernel: leave out, in place, what the leg between its neighbours makes needless; how many are left."""
    count = 1
    for i in range(1, size):
        needed = i == size - 1
        if not needed:
            least = max(level[count - 1], level[i])
            if min(level[count - 1], level[i]) <= 0.0 or not _keeps(s, kept[count - 1], kept[i + 1], least):
                needed = True
        if needed:
            kept[count] = kept[i]
            if i < size - 1:
                level[count] = level[i]
            count += 1
        else:
            level[count - 1] = max(level[count - 1], level[i])
    return count
