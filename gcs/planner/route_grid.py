"""Search for the cheapest path through a grid of cells around static obstacles, with fields shared by goals.

A cell's distance is that of its centre to the nearest surface. Cells nearer than the least clearance are blocked; those
nearer than the clearance wanted cost more, the more the nearer, so that a path keeps the clearance where it can and the
middle of a gap where it cannot. Moves go to the 26 neighbours, a slanted one only if every cell of its block is free,
so that no corner is cut and what is connected is connected through faces.

Search: A* from the goal [lineage: Hart, Nilsson, Raphael, IEEE Trans. SSC 4(2), 1968], whose settled costs are kept. A
later start for the same goal goes on from where the last stopped, with its own heuristic: costs once settled are exact,
whatever heuristic settled them. A search ends when every cell that can lie on a cheapest path is settled, ties too, so
that the path found depends on the goal and the start alone and not on earlier requests. It can be paused after any
number of cells: what is open stays open.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.gcs.planner.search import Front
from cython.cimports.libc.math import INFINITY, ceil, floor
from cython.cimports.skytender.geometry import WALL, shape_at, shape_surface
from numpy.typing import NDArray

from gcs.planner.line_of_sight import FloatArray, IntArray
from skytender.geometry import DOWN, KIND, SIZE_3, bounds

Costs = NDArray[np.int32]
Weights = NDArray[np.uint8]
Labels = NDArray[np.int32]

MOST_CELLS = 8_000_000
"""[choice] A larger region is given larger cells, so that memory stays below 100 MB; gaps may then be missed."""
WALL_SHARE = 0.75
"""[choice] Of a cell, that a wall blocks on either side at least: from half of one on none is passed between cells."""
ALL_CELLS = 1 << 40
"""More than there are: a search without a pause."""
DEAREST = 9
"""[choice] How many metres of free path a metre at the least clearance is worth."""
_CELL = 0xFFFFFFFF  # of a key in the heap: its estimate lies above
_STRAIGHT, _SLANT, _CORNER = 35, 50, 61
"""Half the cost of a move between neighbours by face, edge and corner, weight 1: 35 (1, 1.41, 1.73), 1 % off."""


class Cells(NamedTuple):
    """Cells of a region, each of `cell_m`, flat with north slowest; the outermost layer is blocked."""

    weight: Weights
    """0: blocked, 1: free, more: nearer to something than wanted"""
    part: Labels
    """which connected part of the free space a cell belongs to; 0: blocked"""
    low_ned: tuple[float, float, float]
    """centre of the cell (0, 0, 0)"""
    cell_m: float
    count_n: int
    count_e: int
    count_d: int


def cells(
    table: FloatArray, *, clearance_m: float, least_m: float, cell_m: float, margin_m: float, floor_d: float
) -> Cells:
    """Cells around all obstacles (at least one) and `margin_m` more, none of whose centres lies below floor_d."""
    low, high = bounds(table)
    tops_d, feet_d = low[:, 2].copy(), high[:, 2].copy()
    walls = table[:, KIND] == WALL
    tops_d[walls] = table[walls, DOWN] - table[walls, SIZE_3]
    feet_d[walls] = table[walls, DOWN] + table[walls, SIZE_3]
    low_ned = np.array([*low[:, :2].min(axis=0), tops_d.min()]) - margin_m
    high_ned = np.array([*high[:, :2].max(axis=0), feet_d.max()]) + margin_m
    if math.isfinite(floor_d):
        high_ned[2] = floor_d
        low_ned[2] = min(low_ned[2], floor_d - margin_m)
    extent = high_ned - low_ned
    while math.prod(math.ceil(x / cell_m) + 3 for x in extent) > MOST_CELLS:
        cell_m *= 1.02
    counts = tuple(math.ceil(x / cell_m) + 3 for x in extent)
    spare = (np.array(counts) - 3) * cell_m - extent
    first = low_ned - spare / 2 - cell_m
    first[2] = high_ned[2] - (counts[2] - 2) * cell_m  # the lowest layer lies on the floor
    # The longest move between cells that keep so much keeps the clearance.
    wanted_m = elementary.hypot(clearance_m, cell_m * math.sqrt(3.0) / 2.0)
    distance = np.full(counts, wanted_m, dtype=np.float32)
    _rasterise(table, low, high, distance, first, cell_m, wanted_m, max(WALL_SHARE * cell_m - least_m, 0.0))
    share = np.clip((wanted_m - distance) / max(wanted_m - least_m, 1e-9), 0.0, 1.0)
    weight = np.where(distance < least_m, 0, 1 + np.ceil(share * (DEAREST - 1))).astype(np.uint8)
    for axis in range(3):
        edge = [slice(None)] * 3
        for end in (0, -1):
            edge[axis] = end  # type: ignore[call-overload]
            weight[tuple(edge)] = 0
    place = (float(first[0]), float(first[1]), float(first[2]))
    return Cells(weight.ravel(), connected_parts(weight), place, cell_m, *counts)


def _rasterise(
    table: FloatArray,
    low: FloatArray,
    high: FloatArray,
    distance: NDArray[np.float32],
    first: FloatArray,
    cell_m: float,
    wanted_m: float,
    thicker_m: float,
) -> None:
    a, b = [0, 0, 0], [0, 0, 0]
    for i in range(table.shape[0]):
        shape = shape_at(table, i)
        for axis in range(3):
            south = ceil((low[i, axis] - wanted_m - first[axis]) / cell_m)
            north = floor((high[i, axis] + wanted_m - first[axis]) / cell_m)
            a[axis] = max(cython.cast(cython.Py_ssize_t, south), 0)
            b[axis] = min(cython.cast(cython.Py_ssize_t, north), distance.shape[axis] - 1)
        for n in range(a[0], b[0] + 1):
            for e in range(a[1], b[1] + 1):
                for d in range(a[2], b[2] + 1):
                    at = shape_surface(shape, first[0] + n * cell_m, first[1] + e * cell_m, first[2] + d * cell_m)[0]
                    if shape.kind == WALL:
                        at -= thicker_m
                    distance[n, e, d] = min(distance[n, e, d], at)


def connected_parts(weight: Weights) -> Labels:
    """Number of the part of the free space, from 1 as they are met, of each cell; free cells share a face with a part.

    weight: (n, e, d), 0 where blocked, as all outer layers are. Returns (n * e * d,), 0 where blocked.
    """
    _, count_e, count_d = weight.shape
    return _connected_parts(weight.ravel(), count_d, count_e * count_d)


def _connected_parts(weight: Weights, row: int, layer: int) -> Labels:
    labels = np.zeros(len(weight), dtype=np.int32)
    part = labels
    # The number given to a part's cell → a lower one of the same part, or itself.
    lower = np.zeros(1024, dtype=np.int32)
    back = [1, row, layer]
    count = 0
    for cell in range(part.shape[0]):
        if weight[cell] == 0:
            continue
        number = met = 0
        for axis in range(3):
            other = part[cell - back[axis]]
            if other in (0, met):
                continue
            met = other
            while lower[other] != other:
                lower[other] = lower[lower[other]]
                other = lower[other]
            if number == 0:
                number = other
            elif number != other:
                lower[max(number, other)] = min(number, other)
                number = min(number, other)
        if number == 0:
            count += 1
            if count == lower.shape[0]:
                lower = np.resize(lower, 2 * count)
            number = lower[count] = count
        part[cell] = number
    final = 0
    for number in range(1, count + 1):
        if lower[number] == number:
            final += 1
            lower[number] = final
        else:
            lower[number] = lower[lower[number]]
    for cell in range(part.shape[0]):
        part[cell] = lower[part[cell]]
    return labels


def cell_at(grid: Cells, p_ned: FloatArray) -> int:
    """The cell whose centre is nearest to p_ned; of the nearest inner layer where p_ned lies outside."""
    counts = (grid.count_n, grid.count_e, grid.count_d)
    n, e, d = (
        min(max(round((float(x) - low) / grid.cell_m), 1), count - 2)
        for x, low, count in zip(p_ned, grid.low_ned, counts, strict=True)
    )
    return (n * grid.count_e + e) * grid.count_d + d


def centre(grid: Cells, cell: int) -> FloatArray:
    """Centre (3,) of a cell, NED."""
    rest, d = divmod(cell, grid.count_d)
    n, e = divmod(rest, grid.count_e)
    return np.array(grid.low_ned) + np.array([n, e, d]) * grid.cell_m


@dataclass(slots=True)
class CostField:
    """Costs to one goal cell: 0 not seen, above 0 settled, below 0 minus the least so far of a cell yet to settle."""

    goal: int
    cost: Costs
    keys: IntArray
    """heap of the last search: estimate of the whole path << 32 | cell yet to settle; some are settled since"""
    seen: list[IntArray]
    """every cell whose cost is not 0"""
    settled: int = 0
    paused: int = -1
    """start whose search is not at its end; -1: none"""

    @classmethod
    def towards(cls, grid: Cells, goal: int, cost: Costs | None = None) -> CostField:
        """A field in which nothing is settled; `cost` is an array of zeros that may be used for it."""
        if cost is None:
            cost = np.zeros(len(grid.weight), dtype=np.int32)
        cost[goal] = -1
        begin = np.array([goal], dtype=np.int64)
        return cls(goal, cost, begin, [begin])

    def cleared(self) -> Costs:
        """The array of costs, zero again, for another field: in a huge region far cheaper than a new one."""
        for cells_seen in self.seen:
            self.cost[cells_seen] = 0
        return self.cost

    def path(self, grid: Cells, start: int, most: int = ALL_CELLS) -> IntArray | None:
        """Cells from `start` to the goal; it must be in the same part. None: the search was paused after `most`."""
        if self.cost[start] > 0 and self.paused != start:
            return self._down(grid, start)
        if self.paused != start:
            self.keys = _keyed(self._open_cells(), self.cost, grid.count_e, grid.count_d, start)
        self.keys, seen, settled, found = _settle(
            grid.weight, grid.count_e, grid.count_d, self.cost, self.keys, start, most
        )
        self.seen.append(seen)
        self.settled += settled
        self.paused = -1 if found else start
        return self._down(grid, start) if found else None

    def _open_cells(self) -> IntArray:
        """Cells yet to settle, in order."""
        kept = np.unique(self.keys & _CELL)
        return kept[self.cost[kept] < 0]

    def _down(self, grid: Cells, start: int) -> IntArray:
        return _descend(grid.weight, grid.count_e, grid.count_d, self.cost, start, self.goal)


def _estimate(dn: int, de: int, dd: int) -> int:
    """The cost of the shortest free path between cells so far apart."""
    a, b, c = abs(dn), abs(de), abs(dd)
    least, most = min(a, b, c), max(a, b, c)
    middle = a + b + c - least - most
    return 2 * (_CORNER * least + _SLANT * (middle - least) + _STRAIGHT * (most - middle))


def _edge(free: Any, i: int, j: int) -> None:
    if free[13 + i] == 0 or free[13 + j] == 0:
        free[13 + i + j] = 0


def _corner(free: Any, i: int, j: int, d: int) -> None:
    if free[13 + i + j] == 0 or free[13 + i + d] == 0 or free[13 + j + d] == 0:
        free[13 + i + j + d] = 0


def _allowed(weight: Any, cell: int, around: Any, free: Any) -> None:
    """free[k] = weight of the k-th cell around `cell`, 0 where no move leads there."""
    blocked = 0
    for k in range(27):
        free[k] = weight[cell + around[k]]
        blocked += free[k] == 0
    if blocked == 0:
        return
    # Index 13 is the cell itself; n, e, d add 9, 3, 1. An edge needs its two faces, a corner its three edges.
    for s in range(-1, 2, 2):
        for t in range(-1, 2, 2):
            _edge(free, 9 * s, 3 * t)
            _edge(free, 9 * s, t)
            _edge(free, 3 * s, t)
    for s in range(-1, 2, 2):
        for t in range(-1, 2, 2):
            _corner(free, 9 * s, 3 * t, -1)
            _corner(free, 9 * s, 3 * t, 1)


def _moves(stride_n: int, stride_e: int, around: Any, costs: Any) -> None:
    """Where the 27 cells around a cell lie from it, and half the cost of the move there at weight 1."""
    k = 0
    for n in range(-1, 2):
        for e in range(-1, 2):
            for d in range(-1, 2):
                around[k] = n * stride_n + e * stride_e + d
                axes = abs(n) + abs(e) + abs(d)
                costs[k] = 0 if axes == 0 else _STRAIGHT if axes == 1 else _SLANT if axes == 2 else _CORNER
                k += 1


def _push(heap: Any, size: int, key: int) -> None:
    """Put a key into a binary heap of so many, the least first."""
    while size > 0 and heap[(size - 1) >> 1] > key:
        heap[size] = heap[(size - 1) >> 1]
        size = (size - 1) >> 1
    heap[size] = key


def _pop(heap: Any, size: int) -> int:
    """Take the least key out of a heap of so many, at least one."""
    least, last = heap[0], heap[size - 1]
    at = 0
    child = 1
    while child < size - 1:
        if child + 1 < size - 1 and heap[child + 1] < heap[child]:
            child += 1
        heap[at] = heap[child]
        at, child = child, 2 * child + 1
    # Most of what was last belongs low again, so the way down takes no comparisons with it.
    while at > 0 and heap[(at - 1) >> 1] > last:
        heap[at] = heap[(at - 1) >> 1]
        at = (at - 1) >> 1
    heap[at] = last
    return least


def _keyed(open_cells: IntArray, cost: Costs, count_e: int, count_d: int, start: int) -> IntArray:
    """Heap of the open cells by their estimates of a path from `start`."""
    stride_e, stride_n = count_d, count_d * count_e
    start_n, start_e, start_d = start // stride_n, start // stride_e % count_e, start % stride_e
    keys = np.empty(len(open_cells), dtype=np.int64)
    heap = keys
    for i in range(open_cells.shape[0]):
        cell = open_cells[i]
        n, e, d = cell // stride_n, cell // stride_e % count_e, cell % stride_e
        f = -cost[cell] + _estimate(n - start_n, e - start_e, d - start_d)
        _push(cython.address(heap[0]), i, f << 32 | cell)
    return keys


def _settle(
    weight: Weights, count_e: int, count_d: int, cost: Costs, keys: IntArray, start: int, most: int
) -> tuple[IntArray, IntArray, int, bool]:
    """Settle every cell that can lie on a cheapest path from `start`, or `most` of them; keys: a heap for that start.

    Returns the heap that is left, the cells that were not seen before, how many were settled, and whether that was all.
    """
    stride_e = count_d
    stride_n = count_d * count_e
    front = cython.declare(Front)
    front.limit = cost[start] if cost[start] > 0 else 1 << 62
    front.size = keys.shape[0]
    front.met = front.settled = 0
    front.count_e, front.stride_n, front.stride_e, front.start = count_e, stride_n, stride_e, start
    _moves(stride_n, stride_e, front.around, front.moves)
    seen = np.empty(1024, dtype=np.int64)
    heap = np.resize(keys, len(keys) + 1024)
    while True:
        front.heap, front.heap_room = cython.address(heap[0]), heap.shape[0]
        front.seen, front.seen_room = cython.address(seen[0]), seen.shape[0]
        if _advance(cython.address(front), cython.address(weight[0]), cython.address(cost[0]), most):
            break
        if front.size + 27 > front.heap_room:
            heap = np.resize(heap, 2 * heap.shape[0])
        if front.met + 27 > front.seen_room:
            seen = np.resize(seen, 2 * seen.shape[0])
    found = front.size == 0 or heap[0] >> 32 > front.limit
    return np.asarray(heap)[: front.size].copy(), np.asarray(seen)[: front.met].copy(), front.settled, found


def _advance(front: Any, weight: Any, cost: Any, most: int) -> bool:
    """Settle cells until the search ends, or `most` are settled; False once a list has no room for more."""
    heap, seen, around, moves = front.heap, front.seen, front.around, front.moves
    size, met, settled, limit = front.size, front.met, front.settled, front.limit
    stride_n, stride_e, count_e, start = front.stride_n, front.stride_e, front.count_e, front.start
    start_n, start_e, start_d = start // stride_n, start // stride_e % count_e, start % stride_e
    free = [0] * 27
    ended = True
    while size > 0 and heap[0] >> 32 <= limit and settled < most:
        if size + 27 > front.heap_room or met + 27 > front.seen_room:
            ended = False
            break
        cell = _pop(heap, size) & _CELL
        size -= 1
        own = -cost[cell]
        if own < 0:
            continue
        cost[cell] = own
        settled += 1
        if cell == start:
            limit = own
        _allowed(weight, cell, around, free)
        n, e, d = cell // stride_n - start_n, cell // stride_e % count_e - start_e, cell % stride_e - start_d
        here = free[13]
        k = -1
        for dn in range(-1, 2):
            for de in range(-1, 2):
                for dd in range(-1, 2):
                    k += 1
                    if free[k] == 0:
                        continue
                    other = cell + around[k]
                    known = cost[other]
                    if known > 0:
                        continue
                    new = own + moves[k] * (here + free[k])
                    if known == 0:
                        seen[met] = other
                        met += 1
                    if known == 0 or -known > new:
                        cost[other] = -new
                        _push(heap, size, (new + _estimate(n + dn, e + de, d + dd)) << 32 | other)
                        size += 1
    front.size, front.met, front.settled, front.limit = size, met, settled, limit
    return ended


def _descend(weight: Weights, count_e: int, count_d: int, cost: Costs, start: int, goal: int) -> IntArray:
    """Cells from `start` to `goal` down the settled costs, of equal ones the first in order."""
    around, moves, free = [0] * 27, [0] * 27, [0] * 27
    _moves(count_d * count_e, count_d, around, moves)
    path = [start]
    cell = start
    while cell != goal:
        _allowed(cython.address(weight[0]), cell, around, free)
        following = -1
        for k in range(27):
            other = cell + around[k]
            if k == 13 or free[k] == 0 or cost[other] <= 0:
                continue
            if cost[other] + moves[k] * (free[13] + free[k]) == cost[cell]:
                following = other
                break
        if following < 0:
            raise ValueError("the field holds no way from this start; its part of the free space is another")
        cell = following
        path.append(cell)
    return np.array(path)


def nearest_in_part(grid: Cells, part: int, dearest: int, p_ned: FloatArray) -> int:
    """The cell of a part, no dearer than given, whose centre is nearest to a place; -1 where none is."""
    low_n, low_e, low_d = grid.low_ned
    n, e, d = (p_ned[0] - low_n) / grid.cell_m, (p_ned[1] - low_e) / grid.cell_m, (p_ned[2] - low_d) / grid.cell_m
    return _nearest(grid.weight, grid.part, grid.count_n, grid.count_e, grid.count_d, n, e, d, part, dearest)


def _nearest(
    weight: Weights, parts: Labels, count_n: int, count_e: int, count_d: int, north: float, east: float, down: float,
    part: int, dearest: int,
) -> int:  # fmt: skip
    """The same for a place so many cells from the first one's centre."""
    counts, at = [count_n, count_e, count_d], [north, east, down]
    low, high = [0, 0, 0], [0, 0, 0]
    for axis in range(3):
        at[axis] = min(max(at[axis], 0.0), counts[axis] - 1.0)
    wide = 4
    while True:
        for axis in range(3):
            low[axis] = max(cython.cast(cython.Py_ssize_t, at[axis]) - wide, 0)
            high[axis] = min(cython.cast(cython.Py_ssize_t, at[axis]) + wide + 1, counts[axis] - 1)
        best, nearest = INFINITY, -1
        for n in range(low[0], high[0] + 1):
            for e in range(low[1], high[1] + 1):
                for d in range(low[2], high[2] + 1):
                    square = (n - at[0]) ** 2 + (e - at[1]) ** 2 + (d - at[2]) ** 2
                    cell = (n * count_e + e) * count_d + d
                    if square < best and parts[cell] == part and weight[cell] <= dearest:
                        best, nearest = square, cell
        # What lies outside of the box is farther than its half width.
        if best <= wide * wide or wide > max(counts[0], counts[1], counts[2]):
            return nearest
        wide *= 2
