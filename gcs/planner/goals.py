"""Goals of leaders: slots on a ring around a moving target, one each, places on a path, and own way points [choice]."""

from __future__ import annotations

import bisect
import math
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from gcs.planner.neighbours import IntArray
from skytender import elementary, elementwise
from skytender.assignment import least_cost
from skytender.geometry import FloatArray

Vec3 = tuple[float, float, float]


def ring_offsets(count: int, ring_m: float, height_m: float) -> NDArray[np.float64]:
    """Offsets (count, 3) from the target, NED m: evenly spaced on a level ring, the first one to the north."""
    angles = 2.0 * math.pi * np.arange(count) / max(count, 1)
    north, east = elementwise.cosines(angles), elementwise.sines(angles)
    return np.column_stack((ring_m * north, ring_m * east, np.full(count, -height_m)))


def assign(positions_ned: Mapping[int, Vec3], slots_ned: NDArray[np.float64]) -> dict[int, int]:
    """Slot of each vehicle, by system id, such that the squared distances add up to the least; so paths cross least."""
    sysids = sorted(positions_ned)
    here = np.array([positions_ned[sysid] for sysid in sysids]).reshape(-1, 1, 3)
    cost = np.square(here - slots_ned[np.newaxis]).sum(axis=2)
    rows, columns = least_cost(cost)
    return {sysids[row]: int(column) for row, column in zip(rows, columns, strict=True)}


class ConstantSpeedPath:
    """A polyline flown at constant speed; an open one ends at its last point, a closed one goes round `laps` times."""

    def __init__(self, points_ned: Sequence[Vec3], *, closed: bool, laps: int) -> None:
        corners = np.array([*points_ned, points_ned[0]] if closed else points_ned, np.float64)
        ways = np.diff(corners, axis=0)
        lengths = np.linalg.norm(ways, axis=1)
        marks = np.concatenate(([0.0], np.cumsum(lengths)))
        with np.errstate(invalid="ignore"):  # of a leg without a length, on which no way ends
            directions = ways / np.diff(marks)[:, np.newaxis]
        self._corners: list[Vec3] = [(n, e, d) for n, e, d in corners.tolist()]
        self._directions: list[Vec3] = [(n, e, d) for n, e, d in directions.tolist()]
        self._marks: list[float] = marks.tolist()
        self.length_m = self._marks[-1] * (laps if closed else 1)

    def at(self, way_m: float) -> tuple[Vec3, Vec3]:
        """Position at a way along the path, and the unit vector of the direction there (zero at the end)."""
        if way_m >= self.length_m or self._marks[-1] == 0.0:
            return self._corners[-1], (0.0, 0.0, 0.0)
        way_m = max(way_m, 0.0) % self._marks[-1]
        leg = bisect.bisect_right(self._marks, way_m) - 1
        (n, e, d), (vn, ve, vd), on_m = self._corners[leg], self._directions[leg], way_m - self._marks[leg]
        return (n + vn * on_m, e + ve * on_m, d + vd * on_m), (vn, ve, vd)


class Courses:
    """Way points left of n vehicles, where they have any; arrays have a row for each of the n."""

    def __init__(self, n: int, courses: Mapping[int, Sequence[Vec3]], reached_m: float, *, keeps_last: bool) -> None:
        """courses: by row. keeps_last: a vehicle that is pushed from its last way point comes back to it; else the
        course ends there, and the vehicle stays where it is."""
        self.rows = np.array(sorted(courses), dtype=np.int64)
        self.goal_ned = np.zeros((n, 3))
        """(n, 3) m, of those with way points left"""
        self.ended = np.zeros(n, dtype=np.bool_)
        """(n,) True for vehicles that have left their last way point behind"""
        self._left = {row: list(course) for row, course in courses.items()}
        self.reached_m = reached_m
        self._least_left = 1 if keeps_last else 0
        for row, course in courses.items():
            self.goal_ned[row] = course[0]

    def go_on(self, rows: IntArray, q_ned: FloatArray) -> bool:
        """Leave behind the way point that a leader of these rows (k,), at q_ned (n, 3), has come to; whether any has.
        A leader has come to no more than one in a tick."""
        passed = False
        for row, here in zip(rows.tolist(), q_ned[rows].tolist(), strict=True):
            left = self._left[row]
            if len(left) > self._least_left and elementary.distance(here, left[0]) <= self.reached_m:
                left.pop(0)
                passed = True
                if left:
                    self.goal_ned[row] = left[0]
                else:
                    self.ended[row] = True
        return passed

    def goes_on(self, row: int) -> bool:
        """Whether a row may still come to a way point to be left behind."""
        return len(self._left[row]) > self._least_left
