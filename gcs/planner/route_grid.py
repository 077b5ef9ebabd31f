"""Search for the cheapest path through a grid of cells around static obstacles, with fields shared by goals.

A cell's distance is that of its centre to the nearest surface. Cells nearer than the least clearance are blocked; those
nearer than the clearance wanted cost more, the more the nearer, so that a path keeps the clearance where it can and the
middle of a gap where it cannot. Moves go to the 26 neighbours, a slanted one only if every cell of its block is free,
so that no corner is cut and what is connected is connected through faces.

Search: A* from the goal [lineage: Hart, Nilsson, Raphael, IEEE Trans. SSC 4(2), 1968], whose settled costs are kept. A
later start for the same goal goes on from where the last stopped, with its own heuristic: costs once settled are exact,
whatever heuristic settled them. A search ends when every cell that can lie on a cheapest path is settled, ties too, so
that the path found depends on the goal and the start alone and not on who asked before. It can be paused after any
number of cells: what is open stays open.
"""

from __future__ import annotations

import heapq
import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gcs.kernels import kernel
from gcs.planner.line_of_sight import FloatArray, IntArray
from gcs.scenario.geometry import DOWN, KIND, SIZE_3, WALL, bounds, shape_surface

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
    wanted_m = math.hypot(clearance_m, cell_m * math.sqrt(3.0) / 2.0)
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


@kernel()
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
    for i in range(table.shape[0]):
        a = np.empty(3, dtype=np.int64)
        b = np.empty(3, dtype=np.int64)
        for axis in range(3):
            a[axis] = max(math.ceil((low[i, axis] - wanted_m - first[axis]) / cell_m), 0)
            b[axis] = min(math.floor((high[i, axis] + wanted_m - first[axis]) / cell_m), distance.shape[axis] - 1)
        for n in range(a[0], b[0] + 1):
            for e in range(a[1], b[1] + 1):
                for d in range(a[2], b[2] + 1):
                    at = shape_surface(table, i, first[0] + n * cell_m, first[1] + e * cell_m, first[2] + d * cell_m)[0]
                    if table[i, KIND] == WALL:
                        at -= thicker_m
                    distance[n, e, d] = min(distance[n, e, d], at)


def connected_parts(weight: Weights) -> Labels:
    """Number of the part of the free space, from 1 as they are met, of each cell; free cells share a face with a part.

    weight: (n, e, d), 0 where blocked, as all outer layers are. Returns (n * e * d,), 0 where blocked.
    """
    _, count_e, count_d = weight.shape
    return _connected_parts(weight.ravel(), count_d, count_e * count_d)


@kernel()
def _connected_parts(weight: Weights, row: int, layer: int) -> Labels:
    part = np.zeros(len(weight), dtype=np.int32)
    # The number given to a part's cell → a lower one of the same part, or itself.
    lower = np.zeros(1024, dtype=np.int32)
    count = 0
    for cell in range(len(weight)):
        if weight[cell] == 0:
            continue
        number = 0
        for back in (1, row, layer):
            other = part[cell - back]
            if other == 0:
                continue
            while lower[other] != other:
                lower[other] = lower[lower[other]]
                other = lower[other]
            if number == 0:
                number = other
            elif number != other:
                number, other = min(number, other), max(number, other)
                lower[other] = number
        if number == 0:
            count += 1
            if count == len(lower):
                longer = np.zeros(2 * count, dtype=np.int32)
                longer[:count] = lower
                lower = longer
            number = lower[count] = count
        part[cell] = number
    final = 0
    for number in range(1, count + 1):
        if lower[number] == number:
            final += 1
            lower[number] = final
        else:
            lower[number] = lower[lower[number]]
    for cell in range(len(part)):
        part[cell] = lower[part[cell]]
    return part


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
    open_cells: IntArray
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
            return _descend(grid, self.cost, start, self.goal)
        self.open_cells, seen, settled, found = _settle(grid, self.cost, self.open_cells, start, most)
        self.seen.append(seen)
        self.settled += settled
        self.paused = -1 if found else start
        return _descend(grid, self.cost, start, self.goal) if found else None


@kernel()
def _estimate(dn: int, de: int, dd: int) -> int:
    """Kernel: the cost of the shortest free path between cells so far apart."""
    a, b, c = abs(dn), abs(de), abs(dd)
    least, most = min(a, b, c), max(a, b, c)
    middle = a + b + c - least - most
    return 2 * (_CORNER * least + _SLANT * (middle - least) + _STRAIGHT * (most - middle))


@kernel()
def _allowed(weight: Weights, cell: int, around: IntArray, free: IntArray) -> None:
    """Kernel: free[k] = weight of the k-th cell around `cell`, 0 where no move leads there."""
    blocked = 0
    for k in range(27):
        free[k] = weight[cell + around[k]]
        blocked += free[k] == 0
    if blocked == 0:
        return
    # Index 13 is the cell itself; n, e, d add 9, 3, 1. An edge needs its two faces, a corner its three edges.
    for a, b in ((9, 3), (9, 1), (3, 1)):
        for i in (-a, a):
            for j in (-b, b):
                if free[13 + i] == 0 or free[13 + j] == 0:
                    free[13 + i + j] = 0
    for i in (-9, 9):
        for j in (-3, 3):
            for d in (-1, 1):
                if free[13 + i + j] == 0 or free[13 + i + d] == 0 or free[13 + j + d] == 0:
                    free[13 + i + j + d] = 0


@kernel()
def _moves(stride_n: int, stride_e: int) -> tuple[IntArray, IntArray]:
    """Kernel: where the 27 cells around a cell lie from it, and half the cost of the move there at weight 1."""
    around = np.zeros(27, dtype=np.int64)
    costs = np.zeros(27, dtype=np.int64)
    k = 0
    for n in range(-1, 2):
        for e in range(-1, 2):
            for d in range(-1, 2):
                around[k] = n * stride_n + e * stride_e + d
                axes = abs(n) + abs(e) + abs(d)
                costs[k] = (0, _STRAIGHT, _SLANT, _CORNER)[axes]
                k += 1
    return around, costs


@kernel()
def _settle(
    grid: Cells, cost: Costs, open_cells: IntArray, start: int, most: int
) -> tuple[IntArray, IntArray, int, bool]:
    """Kernel: settle every cell that can lie on a cheapest path from `start`, or `most` of them.

    Returns the cells that stay open, those that were not seen before, how many were settled, and whether that was all.
    """
    settled = 0
    limit = np.int64(1) << 62
    if cost[start] > 0:
        limit = np.int64(cost[start])
    seen = [start][:0]
    weight = grid.weight
    stride_e = grid.count_d
    stride_n = grid.count_d * grid.count_e
    start_n, start_e, start_d = start // stride_n, start // stride_e % grid.count_e, start % stride_e
    around, moves = _moves(stride_n, stride_e)
    free = np.empty(27, dtype=np.int64)
    heap = [start][:0]
    for cell in open_cells:
        n, e, d = cell // stride_n, cell // stride_e % grid.count_e, cell % stride_e
        f = -cost[cell] + _estimate(n - start_n, e - start_e, d - start_d)
        heapq.heappush(heap, f << 32 | cell)
    while len(heap) > 0 and heap[0] >> 32 <= limit and settled < most:
        cell = heapq.heappop(heap) & 0xFFFFFFFF
        own = -np.int64(cost[cell])
        if own < 0:
            continue
        cost[cell] = own
        settled += 1
        if cell == start:
            limit = own
        _allowed(weight, cell, around, free)
        n, e, d = cell // stride_n - start_n, cell // stride_e % grid.count_e - start_e, cell % stride_e - start_d
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
                        seen.append(other)
                    if known == 0 or -known > new:
                        cost[other] = -new
                        heapq.heappush(heap, (new + _estimate(n + dn, e + de, d + dd)) << 32 | other)
    found = len(heap) == 0 or bool(heap[0] >> 32 > limit)
    kept = np.array([key & 0xFFFFFFFF for key in heap], dtype=np.int64)
    return np.unique(kept[cost[kept] < 0]), np.array(seen, dtype=np.int64), settled, found


@kernel()
def _descend(grid: Cells, cost: Costs, start: int, goal: int) -> IntArray:
    """Kernel: cells from `start` to `goal` down the settled costs, of equal ones the first in order."""
    around, moves = _moves(grid.count_d * grid.count_e, grid.count_d)
    free = np.empty(27, dtype=np.int64)
    path = [start]
    cell = start
    while cell != goal:
        _allowed(grid.weight, cell, around, free)
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


@kernel()
def nearest_in_part(grid: Cells, part: int, dearest: int, p_ned: FloatArray) -> int:
    """Kernel: the cell of a part, no dearer than given, whose centre is nearest to a place; -1 where none is."""
    counts = np.array([grid.count_n, grid.count_e, grid.count_d])
    at = np.empty(3)
    for axis in range(3):
        at[axis] = min(max((p_ned[axis] - grid.low_ned[axis]) / grid.cell_m, 0.0), counts[axis] - 1.0)
    wide = 4
    while True:
        low = np.maximum(np.floor(at).astype(np.int64) - wide, 0)
        high = np.minimum(np.floor(at).astype(np.int64) + wide + 1, counts - 1)
        best, nearest = math.inf, -1
        for n in range(low[0], high[0] + 1):
            for e in range(low[1], high[1] + 1):
                for d in range(low[2], high[2] + 1):
                    square = (n - at[0]) ** 2 + (e - at[1]) ** 2 + (d - at[2]) ** 2
                    cell = (n * grid.count_e + e) * grid.count_d + d
                    if square < best and grid.part[cell] == part and grid.weight[cell] <= dearest:
                        best, nearest = square, cell
        # What lies outside of the box is farther than its half width.
        if best <= wide * wide or wide > counts.max():
            return nearest
        wide *= 2
