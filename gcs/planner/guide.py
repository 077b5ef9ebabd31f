"""Aims for many vehicles that follow routes: at each tick the place that each one is to fly to now.

Straight to the goal while neither obstacle nor fence lies between; else along a route (route.py), towards the farthest
place on its next two legs that can be seen, so that a vehicle rounds a corner instead of stopping at it. A route is
kept as long as it holds:

- a goal that moves takes the route's end along while the last leg stays free, and asks for a new search once it has
  moved by `_MOVED_M` out of sight, or by `_REFRESH_M` in any case;
- a new route replaces one that still leads there only if it is shorter by `_SHORTER_SHARE`, so that a vehicle does not
  flip between two equal ones; a straight line once free is kept until it is blocked by more than `_SLACK_SHARE`;
- a vehicle that was pushed out of sight of its next way point is given a new route from where it is.

Searches in a tick are made, longest waiting first, until they have settled so many cells of the grid that a tick has
time for the rest of its work (`cells` and `few_cells`); the last one goes on in the next tick. Cells, not seconds, so
that they are the same searches on every machine; a vehicle that waits keeps its last aim. State is per vehicle and is
forgotten when a tick leaves the vehicle out. Same calls, same aims; frames NED, lengths in metres, no clock.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import cython
import numpy as np
from cython.cimports.gcs.planner.guide import MOST_POINTS, NO_ROUTE, PARTIAL, ROUTED, STRAIGHT, WAITING
from cython.cimports.gcs.planner.line_of_sight import clearance_between, sees_from
from cython.cimports.libc.math import INFINITY, sqrt
from numpy.typing import ArrayLike, NDArray

from gcs.planner.line_of_sight import FloatArray, IntArray, Sight, visible
from gcs.planner.route import Route, Router, SearchPaused

"""States of `Aims`: flies straight; along a route; along one to the place nearest to a goal that lies within a surface;
holds, for there is no way; keeps its last aim until there is time to search."""
"""[choice] Way points kept of a route; at the end of a longer one the rest is searched."""
_MOVED_M, _REFRESH_M, _SHORTER_SHARE = 0.5, 3.0, 0.1  # [choice] when to search again, and when to change over
_SLACK_SHARE, _REACHED_SHARE = 0.2, 0.25  # [choice] of the clearance wanted
_HALVINGS = 5
_SEARCH_CELLS = 3_000  # [choice] what a search costs beside the cells that it settles, about 1 ms
_CELLS_OF_A_VEHICLE = 80  # [choice] what planning and filtering cost each, in the same measure
_NEVER = math.inf
_THERE_M = 0.05  # [choice] a way point is reached, whatever can be seen from here
_LEAST_SLACK = 0.25  # [choice] share of the slack that is left in the narrowest gap
_LOST_SHARE = 0.2  # [choice] of _MOVED_M: a vehicle without a way point in sight searches again after this way

States = NDArray[np.int8]


class Aims(NamedTuple):
    """For each vehicle: where to fly now (n, 3), how far the goal is along the route (n,), and its state (n,)."""

    aim_ned: FloatArray
    remaining_m: FloatArray
    state: States


_KEPT = np.dtype(
    [
        ("points", np.float64, (MOST_POINTS, 3)),
        ("legs", np.float64, MOST_POINTS),
        ("searched_from", np.float64, 3),
        ("searched_to", np.float64, 3),
        ("aim", np.float64, 3),
        ("size", np.int64),
        ("at", np.int64),
        ("waits", np.int64),
        ("state", np.int64),
    ]
)
"""State kept of each vehicle: the struct Kept of guide.pxd."""


class RouteFollower:
    """Routes of all vehicles in one world; `aims` is called once in each tick."""

    def __init__(self, router: Router, cells: int = 15_000, few_cells: int = 60_000) -> None:
        """A tick may settle `cells` [choice] at least, `few_cells` for a few vehicles, whose other work is short."""
        self._router, self._cells, self._few_cells = router, cells, few_cells
        self._rows: dict[int, int] = {}
        self._asked: tuple[int, ...] | None = None
        self._asked_rows = np.zeros(0, np.int64)
        """of the vehicles asked for last"""
        self._kept = _new_routes(0)
        self._paused: dict[int, tuple[FloatArray, FloatArray]] = {}
        self.searches = 0
        """made so far"""

    def aims(self, sysids: Sequence[int], p_ned: ArrayLike, goals_ned: ArrayLike) -> Aims:
        """Aims of the vehicles `sysids` (n), at p_ned (n, 3), whose goals are goals_ned (n, 3).

        ValueError where shapes differ, an id comes twice, or a place is not finite.
        """
        p, goals = np.array(p_ned, dtype=np.float64), np.array(goals_ned, dtype=np.float64)
        if p.shape != (len(sysids), 3) or goals.shape != p.shape:
            raise ValueError(f"p_ned is {p.shape} and goals_ned {goals.shape}; they must be {(len(sysids), 3)}")
        if not (np.isfinite(p).all() and np.isfinite(goals).all()):
            raise ValueError("p_ned or goals_ned holds a value that is not finite; leave that vehicle out")
        router = self._router
        goals[:, 2] = np.minimum(goals[:, 2], router.floor_d)
        rows = self._rows_of(sysids, p)
        aims, remaining, wanted = self._step(rows, p, goals)
        asking = np.flatnonzero(wanted)
        if len(asking):
            turn = asking[np.argsort(-self._kept["waits"][rows[asking]], kind="stable")]
            left = max(self._cells, self._few_cells - _CELLS_OF_A_VEHICLE * len(sysids))
            count = 0
            while count < len(turn) and left > 0:
                before = router.settled
                try:
                    self._search(int(rows[turn[count]]), p[turn[count]], goals[turn[count]], left)
                except SearchPaused:
                    break
                count += 1
                left -= router.settled - before + _SEARCH_CELLS
            served, unserved = turn[:count], turn[count:]
            aims[served], remaining[served], _ = self._step(rows[served], p[served], goals[served])
            self._kept["waits"][rows[served]] = 0
            self._kept["waits"][rows[unserved]] += 1
        self._kept["aim"][rows] = aims
        return Aims(aims, remaining, self._kept["state"][rows].astype(np.int8))

    def _step(self, rows: IntArray, p: FloatArray, goals: FloatArray) -> tuple[FloatArray, FloatArray, States]:
        router = self._router
        aims, remaining, wanted = p.copy(), np.zeros(len(p)), np.zeros(len(p), dtype=np.int8)
        limits = {
            "clearance": router.clearance_m,
            "least": router.least_clearance_m,
            "slack": _SLACK_SHARE * router.clearance_m,
            "reached": _REACHED_SHARE * router.clearance_m,
            "floor_d": router.floor_d,
        }
        _advance(router.sight, self._kept, rows, p, goals, limits, aims, remaining, wanted)
        return aims, remaining, wanted

    def _search(self, row: int, p: FloatArray, goal: FloatArray, most_cells: int) -> None:
        """A route from p to the goal, unless the present one, led on to the goal, is as good. Raises SearchPaused.

        A paused search goes on with its own start and goal, wherever both have moved since.
        """
        kept = self._kept[row]
        p, goal = self._paused.get(row, (p, goal))
        self._paused = {row: (p.copy(), goal.copy())}
        found = self._router.plan(p, goal, most_cells)
        at, count = int(kept["at"]), int(kept["size"])
        if found is not None and found.reaches_goal and at < count - 1 and self._sees_next(row, p):
            before = np.vstack([p, kept["points"][at : count - 1]])
            onward = self._router.plan(before[len(before) - 1], goal, most_cells)
            if onward is not None and onward.reaches_goal:
                length_m = float(np.linalg.norm(np.diff(before, axis=0), axis=1).sum()) + onward.length_m
                if found.length_m >= (1.0 - _SHORTER_SHARE) * length_m:
                    legs = np.concatenate((kept["legs"][at : count - 1], onward.legs_m))
                    found = Route(np.vstack([before[1:], onward.points_ned]), legs, length_m)
        self._paused.clear()
        self.searches += 1
        kept["searched_from"], kept["searched_to"] = p, goal
        kept["at"] = 0
        kept["size"] = 0 if found is None else min(len(found.points_ned), MOST_POINTS)
        kept["state"] = NO_ROUTE if found is None else ROUTED if found.reaches_goal else PARTIAL
        if found is not None:
            kept["points"][: kept["size"]] = found.points_ned[:MOST_POINTS]
            kept["legs"][: kept["size"]] = found.legs_m[:MOST_POINTS]

    def _sees_next(self, row: int, p: FloatArray) -> bool:
        router, at = self._router, int(self._kept["at"][row])
        leg_m = float(self._kept["legs"][row, at])
        slack_m = _SLACK_SHARE * router.clearance_m
        level = leg_m - slack_of(leg_m, router.clearance_m, router.least_clearance_m, slack_m)
        return bool(visible(router.sight, p, self._kept["points"][row, at], level, router.floor_d))

    def _rows_of(self, sysids: Sequence[int], p: FloatArray) -> IntArray:
        """A row for each vehicle; those left out are forgotten."""
        if sysids is self._asked:
            return self._asked_rows
        if len(set(sysids)) != len(sysids):
            raise ValueError("sysids names a vehicle twice; each has one route")
        if self._rows.keys() != set(sysids):
            known, old = self._rows, self._kept
            self._rows = {sysid: row for row, sysid in enumerate(sysids)}
            self._kept = _new_routes(len(sysids))
            self._paused.clear()
            self._kept["aim"][:] = p
            for sysid, row in self._rows.items():
                if sysid in known:
                    self._kept[row] = old[known[sysid]]
        self._asked = sysids if isinstance(sysids, tuple) else None
        self._asked_rows = np.array([self._rows[sysid] for sysid in sysids], dtype=np.int64)
        return self._asked_rows


def _new_routes(rows: int) -> NDArray[Any]:
    kept = np.zeros(rows, dtype=_KEPT)
    kept["state"] = WAITING
    kept["searched_from"] = kept["searched_to"] = _NEVER
    return kept


def _apart(a: Any, b: Any) -> float:
    return sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2)


def _copy(place: Any, to: Any) -> None:
    to[0], to[1], to[2] = place[0], place[1], place[2]


def slack_of(leg: float, clearance: float, least: float, slack: float) -> float:
    """How much less than its route's leg a vehicle may keep: all of it in the open, little in a narrow gap."""
    share = (leg - least) / (clearance - least) if clearance > least else 1.0
    return max(slack * min(max(share, 0.0), 1.0), _LEAST_SLACK * slack)


def _advance(
    sight: Sight,
    kept: NDArray[Any],
    rows: IntArray,
    p: FloatArray,
    goals: FloatArray,
    rules: Any,
    aims: FloatArray,
    remaining: FloatArray,
    wanted: States,
) -> None:
    """Aims, ways remaining and whether a search is wanted; moves each route on to the point flown to."""
    for i in range(rows.shape[0]):
        wanted[i] = _advance_one(
            cython.address(sight.bins),
            cython.address(kept[rows[i]]),
            cython.address(p[i, 0]),
            cython.address(goals[i, 0]),
            cython.address(rules),
            cython.address(aims[i, 0]),
            cython.address(remaining[i]),
        )


def _advance_one(s: Any, kept: Any, here: Any, goal: Any, rules: Any, aim: Any, remaining: Any) -> bool:
    level = rules.clearance - rules.slack if kept.state == STRAIGHT else rules.clearance
    at_goal = clearance_between(s, goal, goal, rules.clearance, -INFINITY)
    if at_goal >= rules.least - 1e-6 and sees_from(s, here, goal, level, rules.floor_d):
        kept.state, kept.size = STRAIGHT, 0
        _copy(goal, aim)
        remaining[0] = _apart(here, goal)
        return False
    goal_moved = _apart(goal, kept.searched_to)
    self_moved = _apart(here, kept.searched_from)
    if kept.size == 0:
        # Compared this way round because infinity less infinity is no number: never searched, never near.
        elsewhere = not (goal_moved <= _MOVED_M and self_moved <= _MOVED_M)
        remaining[0] = INFINITY
        if kept.state == NO_ROUTE:
            return elsewhere
        kept.state = WAITING
        _copy(kept.aim, aim)
        return True
    points, legs = cython.address(kept.points[0][0]), kept.legs
    last = kept.size - 1
    at = kept.at
    wanted = False
    if kept.state == ROUTED and _apart(points + 3 * last, goal) > 0.0:
        if sees_from(s, here if last == 0 else points + 3 * (last - 1), goal, legs[last], rules.floor_d):
            _copy(goal, points + 3 * last)
            wanted = goal_moved > _REFRESH_M
        else:
            wanted = goal_moved > _MOVED_M or (at == last and self_moved > _MOVED_M)
    elif kept.state == PARTIAL:
        wanted = goal_moved > _MOVED_M
    while True:
        level = legs[at] - slack_of(legs[at], rules.clearance, rules.least, rules.slack)
        seen = sees_from(s, here, points + 3 * at, level, rules.floor_d)
        if at == last:
            break
        near, level = _apart(here, points + 3 * at), min(legs[at], legs[at + 1])
        if near <= rules.reached or not seen:
            level -= slack_of(level, rules.clearance, rules.least, rules.slack)
        if near > _THERE_M and not sees_from(s, here, points + 3 * (at + 1), level, rules.floor_d):
            break
        at += 1
    kept.at = at
    if not seen and not self_moved <= _LOST_SHARE * _MOVED_M:
        wanted = True
    _copy(points + 3 * at, aim)
    if at < last:
        level = min(legs[at], legs[at + 1])
        level -= slack_of(level, rules.clearance, rules.least, rules.slack)
        low, high, middle = 0.0, 1.0, 0.5
        place = [0.0, 0.0, 0.0]
        for _ in range(_HALVINGS):
            for axis in range(3):
                place[axis] = points[3 * at + axis] + middle * (points[3 * (at + 1) + axis] - points[3 * at + axis])
            if sees_from(s, here, place, level, rules.floor_d):
                low = middle
                _copy(place, aim)
            else:
                high = middle
            middle = (low + high) / 2.0
    length = _apart(here, points + 3 * at)
    for j in range(at, last):
        length += _apart(points + 3 * j, points + 3 * (j + 1))
    remaining[0] = length
    return wanted
