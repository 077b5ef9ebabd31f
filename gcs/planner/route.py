"""Global routes around static obstacles: way points that keep a clearance from each surface where that is possible.

A route is the straight line if that is free, else the cheapest path through a grid, shortened and
tightened against the exact distances: legs that kept the clearance still keep it, legs through a gap too narrow for it
keep at least what the path through the gap had. Routes depend on the world, the start and the goal alone.

A `Router` is one immutable world; when the world changes, make another. Frames NED, lengths in metres, no clock.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections import OrderedDict
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from gcs.planner.line_of_sight import FloatArray, IntArray, clear_m, leg_clearances, sight, visible
from gcs.planner.route_grid import ALL_CELLS, Cells, CostField, cell_at, cells, centre, nearest_in_part
from gcs.planner.route_shortening import pulled
from skytender.geometry import COLUMNS, KIND, WALL

LEAST_SHARE = 0.5
"""[choice] Of the clearance wanted: what a route keeps in a gap. 0.6 m wanted passes gaps of 0.9 m and more."""
CELL_SHARE = 0.95
"""[choice] Of the least clearance: a cell. The middle of a gap of 3 least clearances then always holds a cell."""
FIELD_BYTES = 128_000_000
"""[choice] Memory for fields kept, at two to 64 of them."""
_ROUNDING_M = 1e-6


@dataclass(frozen=True, slots=True)
class Route:
    """Way points (k, 3) after the start, each leg's least distance to a surface (k,), cut off at the clearance wanted.

    `reaches_goal` is False where the goal is nearer than the least clearance to a surface, or inside: the route then
    leads to the place nearest to it that can be reached.
    """

    points_ned: FloatArray
    legs_m: FloatArray
    length_m: float
    reaches_goal: bool = True


class SearchPaused(Exception):
    """A search has settled as many cells as it was allowed; the same one goes on from there."""


class Router:
    """Routes in one world of static obstacles.

    table: obstacle table (m, COLUMNS). clearance_m: wanted from each surface. least_clearance_m: kept in gaps, half of
    it if not given. floor_m: the height above z = 0 below which no route leads; None without ground. cell_m: of the
    grid, from the least clearance if not given. ValueError names what is wrong.
    """

    def __init__(
        self,
        table: FloatArray,
        clearance_m: float,
        *,
        floor_m: float | None = None,
        least_clearance_m: float | None = None,
        cell_m: float | None = None,
    ) -> None:
        table = np.array(table, dtype=np.float64)
        if table.ndim != 2 or table.shape[1] != COLUMNS or not np.isfinite(table).all():
            raise ValueError(f"table has shape {table.shape}; it must be a finite obstacle table (m, {COLUMNS})")
        least_m = LEAST_SHARE * clearance_m if least_clearance_m is None else least_clearance_m
        if not 0.0 < least_m <= clearance_m < math.inf:
            raise ValueError(f"least_clearance_m is {least_m!r}; it must be above 0 and at most {clearance_m!r}")
        if cell_m is not None and not 0.0 < cell_m < math.inf:
            raise ValueError(f"cell_m is {cell_m!r}; it must be a finite length above 0 m")
        if floor_m is not None and not math.isfinite(floor_m):
            raise ValueError(f"floor_m is {floor_m!r}; it must be finite, or None where there is no ground")
        self.clearance_m, self.least_clearance_m = float(clearance_m), float(least_m)
        self.floor_d = math.inf if floor_m is None else -float(floor_m)
        self.sight = sight(table, self.clearance_m)
        self._cell_m = CELL_SHARE * least_m if cell_m is None else cell_m
        self._walled = bool((table[:, KIND] == WALL).any())
        self._grid: Cells | None = None
        self._fields: OrderedDict[int, CostField] = OrderedDict()
        self.settled = 0
        """cells settled by all searches so far, the measure of their cost that is the same on every machine"""

    @property
    def grid(self) -> Cells:
        """The cells, made when they are first needed; their `cell_m` is larger than asked for in a huge region."""
        if self._grid is None:
            self._grid = cells(
                self.sight.table,
                clearance_m=self.clearance_m,
                least_m=self.least_clearance_m,
                cell_m=self._cell_m,
                margin_m=self.clearance_m + 4.0 * self._cell_m,
                floor_d=self.floor_d,
            )
        return self._grid

    def prepare(self) -> None:
        """Make the cells now: in a wide world they take half a second, which no flight has to spare."""
        _ = self.grid

    def plan(self, start_ned: ArrayLike, goal_ned: ArrayLike, most_cells: int = ALL_CELLS) -> Route | None:
        """The route from the start to the goal; None where there is no way. ValueError unless both are three finite
        numbers.

        Raises SearchPaused once it has settled `most_cells`; the same call goes on from there.
        """
        start, goal = self._place("start_ned", start_ned), self._place("goal_ned", goal_ned)
        goal[2] = min(goal[2], self.floor_d)
        reachable = self._clearance_m(goal) >= self.least_clearance_m - _ROUNDING_M
        if reachable and visible(self.sight, start, goal, self.clearance_m, self.floor_d):
            return self._route(start, goal[np.newaxis], reaches_goal=True)
        return self._around(start, goal, most_cells, reachable=reachable)

    def _around(self, start: FloatArray, goal: FloatArray, most_cells: int, *, reachable: bool) -> Route | None:
        """The route through the grid; `reachable` says whether the goal itself is clear of obstacles."""
        grid = self.grid
        begin = self._entries(start, goal)
        if reachable:
            end = self._entries(goal, start)
            pairs = [(a, b) for a, b in itertools.product(begin, end) if grid.part[a] == grid.part[b]]
            if not pairs:
                return None
            from_cell, to_cell = pairs[0]
        else:
            if not begin:
                return None
            from_cell, part = begin[0], grid.part[begin[0]]
            to_cell = nearest_in_part(grid, part, 1, goal)
            if to_cell < 0:
                to_cell = nearest_in_part(grid, part, 255, goal)
            goal = self._towards(centre(grid, to_cell), goal)
        path = np.vstack([start, self._cell_path(from_cell, to_cell, most_cells), goal])
        path = path[np.concatenate(([True], np.linalg.norm(np.diff(path, axis=0), axis=1) > _ROUNDING_M))]
        path = pulled(self.sight, path, self.clearance_m, 0.8 * self.least_clearance_m, grid.cell_m, self.floor_d)
        return self._route(start, path[1:] if len(path) > 1 else goal[np.newaxis], reaches_goal=reachable)

    def _cell_path(self, start: int, goal: int, most_cells: int) -> FloatArray:
        """Centres (k, 3) of the cells from one to another. Raises SearchPaused."""
        field = self._fields.pop(goal, None)
        if field is None:
            cost = None
            if len(self._fields) >= min(max(FIELD_BYTES // (4 * len(self.grid.weight)), 2), 64):
                cost = self._fields.popitem(last=False)[1].cleared()
            field = CostField.towards(self.grid, goal, cost)
        self._fields[goal] = field
        before = field.settled
        grid = self.grid
        path = field.path(grid, start, most_cells)
        self.settled += field.settled - before
        if path is None:
            raise SearchPaused
        rest, d = np.divmod(path, grid.count_d)
        n, e = np.divmod(rest, grid.count_e)
        return np.array(grid.low_ned) + np.column_stack([n, e, d]) * grid.cell_m

    def _entries(self, p_ned: FloatArray, other_ned: FloatArray) -> list[int]:
        """Free cells from which the grid is entered from a place, the best of each part first; [] where none is near.

        A start within a surface, or too near to one, enters where the way comes no nearer.
        """
        grid = self.grid
        inside = self._clipped(p_ned, other_ned)
        cell = cell_at(grid, inside)
        own_m = self._clearance_m(p_ned)
        wanted = min(own_m, self.least_clearance_m) - 0.3 * grid.cell_m
        if own_m < self.least_clearance_m:
            wanted = own_m - _ROUNDING_M
        around = _around_cell(min(math.ceil((self.least_clearance_m - min(own_m, 0.0)) / grid.cell_m) + 1, 8))
        n, rest = divmod(cell, grid.count_e * grid.count_d)
        around = np.array([n, *divmod(rest, grid.count_d)]) + around
        counts = np.array([grid.count_n, grid.count_e, grid.count_d])
        around = around[((around >= 1) & (around <= counts - 2)).all(axis=1)]
        found: dict[int, int] = {}
        for at in (around @ [grid.count_e * grid.count_d, grid.count_d, 1]).tolist():
            part = int(grid.part[at])
            if part and part not in found:
                place = centre(grid, at)
                if clear_m(self.sight, inside, place, self.clearance_m, wanted) >= wanted:
                    found[part] = at
        return list(found.values())

    def _clipped(self, p_ned: FloatArray, other_ned: FloatArray) -> FloatArray:
        """Point where the line from a place to another enters the region; the place itself, or nearest to it,
        without.

        Where there are walls it is the nearest: above the region they go on, so the line may have crossed one.
        """
        grid = self.grid
        low = np.array(grid.low_ned) + grid.cell_m
        high = low + (np.array([grid.count_n, grid.count_e, grid.count_d]) - 3) * grid.cell_m
        if ((low <= p_ned) & (p_ned <= high)).all():
            return p_ned
        if self._walled:
            return np.clip(p_ned, low, high)
        along = other_ned - p_ned
        with np.errstate(divide="ignore", invalid="ignore"):
            t1, t2 = (low - p_ned) / along, (high - p_ned) / along
        begin = np.nanmax(np.append(np.minimum(t1, t2), 0.0))
        end = np.nanmin(np.append(np.maximum(t1, t2), 1.0))
        return np.clip(p_ned + (begin if begin <= end else 0.0) * along, low, high)

    def _towards(self, from_ned: FloatArray, to_ned: FloatArray) -> FloatArray:
        """The farthest place on the line that keeps what `from_ned` keeps of the clearance."""
        least = min(self._clearance_m(from_ned), self.clearance_m)
        low, high = 0.0, 1.0
        for _ in range(20):
            middle = (low + high) / 2
            place = from_ned + middle * (to_ned - from_ned)
            clear = clear_m(self.sight, from_ned, place, self.clearance_m, least) >= least - _ROUNDING_M
            low, high = (middle, high) if clear else (low, middle)
        return from_ned + low * (to_ned - from_ned)

    def _clearance_m(self, p_ned: FloatArray) -> float:
        return float(clear_m(self.sight, p_ned, p_ned, self.clearance_m))

    def _route(self, start: FloatArray, points: FloatArray, *, reaches_goal: bool) -> Route:
        whole = np.vstack([start, points])
        length_m = float(np.linalg.norm(np.diff(whole, axis=0), axis=1).sum())
        return Route(points, leg_clearances(self.sight, whole), length_m, reaches_goal)

    def _place(self, name: str, value: ArrayLike) -> FloatArray:
        place = np.array(value, dtype=np.float64)
        if place.shape != (3,) or not np.isfinite(place).all():
            raise ValueError(f"{name} must hold three finite numbers: north, east, down in metres")
        return place


@functools.cache
def _around_cell(wide: int) -> IntArray:
    """Offsets (k, 3) in cells, at most `wide` each way, from the nearest to the farthest."""
    offsets = np.array(list(itertools.product(range(-wide, wide + 1), repeat=3)))
    return offsets[np.argsort(np.square(offsets).sum(axis=1), kind="stable")]
