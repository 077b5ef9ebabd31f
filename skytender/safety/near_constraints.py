"""Constraints of the safety filter that can matter within a period: whatever is too far for that is left out.

A constraint has a kind, a vehicle, with what, and its required distance, in order of kind, vehicle and with what.
Frames NED, lengths in metres.
"""

from __future__ import annotations

from typing import Any

import cython
from cython.cimports.libc.math import sqrt
from cython.cimports.libc.stdlib import qsort, realloc
from cython.cimports.libc.string import memset
from cython.cimports.skytender.geometry import WALL, write_bounds
from cython.cimports.skytender.safety.constraints import Box, Constraint
from cython.cimports.skytender.safety.safety_constraints import OBSTACLE, OTHER, PAIR, PLANE, REACH

_ROOM = 256
_ROUNDING_M = 1e-6


def find_constraints(near: Any, reach: Any, boxes: Any, found: Any) -> int:
    """Put into `found` all that n vehicles can come near to.

    reach: (n,), written; boxes: one for each vehicle or each shape, written. MemoryError where the list cannot grow.
    """
    for i in range(near.n):
        # No way is longer: the coming period, the braking after it, and what activates below.
        v, brake = near.v + 3 * i, near.brake[i]
        speed = sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2) + near.a_max[i] * near.dt
        reach[i] = near.dt * speed + speed**2 / (2.0 * brake) + brake * near.dt**2 / 8.0 + near.buffer
    if near.apart and near.n > 0:
        _find_pairs(near, reach, boxes, found)
    _find_others(near, reach, found)
    if near.shapes_count > 0:
        _find_shapes(near, reach, boxes, found)
    return _find_walls(near, reach, found)


def _find_pairs(near: Any, reach: Any, boxes: Any, found: Any) -> int:
    most_reach, most_margin = reach[0], near.margin[0] + near.spread[0]
    for i in range(near.n):
        most_reach, most_margin = max(most_reach, reach[i]), max(most_margin, near.margin[i] + near.spread[i])
    farthest = 2.0 * (most_reach + most_margin) + near.separation
    for k in range(near.pairs_count):
        farthest = max(farthest, 2.0 * most_reach + near.pairs[3 * k + 2])
    square = farthest * farthest
    for at in range(near.n):
        box = cython.address(boxes[at])
        box.low[0], box.j = near.p[3 * at], at
    qsort(boxes, near.n, cython.sizeof(Box), _by_south)
    for i in range(near.n):
        p, first = near.p + 3 * i, found.count
        begin = _first_from(boxes, near.n, p[0] - farthest - _ROUNDING_M, False)
        end = _first_from(boxes, near.n, p[0] + farthest + _ROUNDING_M, True)
        for at in range(begin, end):
            j = boxes[at].j
            q = near.p + 3 * j
            n, e, d = p[0] - q[0], p[1] - q[1], p[2] - q[2]
            if j > i and n * n + e * e + d * d <= square:
                spread = sqrt(near.spread[i] * near.spread[i] + near.spread[j] * near.spread[j])
                usual = near.separation + near.margin[i] + near.margin[j] + spread
                required = _of_pair(near.pairs, near.pairs_count, i, j, usual)
                if _distance(p, q) <= reach[i] + reach[j] + required:
                    _put(found, PAIR, i, j, required)
        _in_order(found, first)
    return 0


def _find_others(near: Any, reach: Any, found: Any) -> int:
    ahead = near.horizon + near.dt
    for i in range(near.n):
        for j in range(near.others_count):
            other = cython.address(near.others[j])
            if (other.agile > 0.0 and other.agile > near.v_max[i]) or (
                other.agile < 0.0 and -other.agile <= near.v_max[i]
            ):
                continue
            usual = other.radius + near.margin[i] + near.spread[i]
            d = _of_pair(near.singles, near.singles_count, i, j, usual)
            speed = sqrt(other.v[0] ** 2 + other.v[1] ** 2 + other.v[2] ** 2)
            far = speed * ahead + max(usual, d) + other.growth * ahead
            if other.agile > 0.0:
                v = near.v + 3 * i
                closing = other.agile + sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2) + near.a_max[i] * near.dt
                far = max(usual, d) + other.agile * near.dt + closing**2 / (2.0 * near.brake[i])
            # None of 0: a distance of 0 is one that a braking leader would have to keep too.
            if d > 0.0 and _distance(near.p + 3 * i, other.p) <= reach[i] + far:
                _put(found, REACH if other.agile > 0.0 else OTHER, i, j, d)
    return 0


def _find_shapes(near: Any, reach: Any, boxes: Any, found: Any) -> int:
    count = near.shapes_count
    widest = 0.0
    for at in range(count):
        box, shape = cython.address(boxes[at]), cython.address(near.shapes[at])
        write_bounds(shape, box.low, box.high)
        box.j, box.wall = at, shape.kind == WALL
        widest = max(widest, box.high[0] - box.low[0])
    qsort(boxes, count, cython.sizeof(Box), _by_south)
    for i in range(near.n):
        p, d, first = near.p + 3 * i, near.clearance + near.margin[i] + near.spread[i], found.count
        begin = _first_from(boxes, count, p[0] - reach[i] - d - widest, False)
        end = _first_from(boxes, count, p[0] + reach[i] + d, True)
        for at in range(begin, end):
            box = cython.address(boxes[at])
            if _outside(p, box) <= reach[i] + d and not (near.beyond[i] and box.wall):
                _put(found, OBSTACLE, i, box.j, d)
        _in_order(found, first)
    return 0


def _find_walls(near: Any, reach: Any, found: Any) -> int:
    for i in range(near.n):
        p, walls = near.p + 3 * i, near.walls + 6 * i
        for side in range(6):
            clear = p[side] - walls[side] if side < 3 else walls[side] - p[side - 3]
            if clear <= reach[i] + near.margin[i] + near.spread[i]:
                _put(found, PLANE, i, side, near.margin[i] + near.spread[i])
    return 0


def _put(found: Any, kind: int, i: int, j: int, required: float) -> int:
    if found.count == found.room:
        room = 2 * found.room if found.room > 0 else _ROOM
        longer = realloc(found.rows, room * cython.sizeof(Constraint))
        if longer == cython.NULL:
            raise MemoryError
        found.rows, found.room = cython.cast(cython.pointer(Constraint), longer), room
    c = cython.address(found.rows[found.count])
    memset(c, 0, cython.sizeof(Constraint))
    c.kind, c.i, c.j, c.required = kind, i, j, required
    found.count += 1
    return 0


def _in_order(found: Any, first: int) -> None:
    """Sort one vehicle's constraints, from `first` on, by what they are with."""
    if found.count > first + 1:
        qsort(cython.address(found.rows[first]), found.count - first, cython.sizeof(Constraint), _by_what)


def _of_pair(given: Any, count: int, i: int, j: int, usual: float) -> float:
    """Distance required of a pair, where one is given for it: the last one."""
    required = usual
    for k in range(count):
        if given[3 * k] == i and given[3 * k + 1] == j:
            required = given[3 * k + 2]
    return required


def _distance(a: Any, b: Any) -> float:
    return sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2)


def _outside(p: Any, box: Any) -> float:
    """Distance of a place from a box, 0 in it."""
    square = 0.0
    for axis in range(3):
        square += max(box.low[axis] - p[axis], p[axis] - box.high[axis], 0.0) ** 2
    return sqrt(square)


def _by_south(a: Any, b: Any) -> int:
    """Order of boxes by their south sides."""
    first, second = cython.cast("const Box *", a), cython.cast("const Box *", b)
    return (first.low[0] > second.low[0]) - (first.low[0] < second.low[0])


def _by_what(a: Any, b: Any) -> int:
    """Order of one vehicle's constraints."""
    first, second = cython.cast("const Constraint *", a), cython.cast("const Constraint *", b)
    return (first.j > second.j) - (first.j < second.j)


def _first_from(boxes: Any, count: int, north: float, beyond: bool) -> int:
    """The first of boxes in order whose south side is at `north` or farther; `beyond`: is farther."""
    low = 0
    while count > 0:
        middle = low + count // 2
        south = boxes[middle].low[0]
        if south < north or (beyond and south == north):
            count -= middle + 1 - low
            low = middle + 1
        else:
            count = middle - low
    return low
