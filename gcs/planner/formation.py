"""Places of pursuers around their moving target: slots on a ring, one each, and the way there [choice]."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from gcs.assignment import least_cost

Vec3 = tuple[float, float, float]


def ring_offsets(count: int, ring_m: float, height_m: float) -> NDArray[np.float64]:
    """Offsets (count, 3) from the target, NED m: evenly spaced on a level ring, the first one to the north."""
    angles = 2.0 * math.pi * np.arange(count) / max(count, 1)
    return np.column_stack((ring_m * np.cos(angles), ring_m * np.sin(angles), np.full(count, -height_m)))


def assign(positions_ned: Mapping[int, Vec3], slots_ned: NDArray[np.float64]) -> dict[int, int]:
    """Slot of each vehicle, by system id, such that the squared distances add up to the least; so paths cross least."""
    sysids = sorted(positions_ned)
    here = np.array([positions_ned[sysid] for sysid in sysids]).reshape(-1, 1, 3)
    cost = ((here - slots_ned[np.newaxis]) ** 2).sum(axis=2)
    rows, columns = least_cost(cost)
    return {sysids[row]: int(column) for row, column in zip(rows, columns, strict=True)}


class ConstantSpeedPath:
    """A polyline flown at constant speed; an open one ends at its last point, a closed one goes round `laps` times."""

    def __init__(self, points_ned: Sequence[Vec3], *, closed: bool, laps: int) -> None:
        corners = [*points_ned, points_ned[0]] if closed else list(points_ned)
        self._corners = np.array(corners, dtype=float)
        lengths = np.linalg.norm(np.diff(self._corners, axis=0), axis=1)
        self._marks = np.concatenate(([0.0], np.cumsum(lengths)))
        self.length_m = float(self._marks[-1]) * (laps if closed else 1)

    def at(self, way_m: float) -> tuple[Vec3, Vec3]:
        """Position at a way along the path, and the unit vector of the direction there (zero at the end)."""
        if way_m >= self.length_m or self._marks[-1] == 0.0:
            end = self._corners[-1]
            return (float(end[0]), float(end[1]), float(end[2])), (0.0, 0.0, 0.0)
        way_m = max(way_m, 0.0) % float(self._marks[-1])
        leg = int(np.searchsorted(self._marks, way_m, side="right")) - 1
        a, b = self._corners[leg], self._corners[leg + 1]
        direction = (b - a) / (self._marks[leg + 1] - self._marks[leg])
        p = a + direction * (way_m - self._marks[leg])
        return (float(p[0]), float(p[1]), float(p[2])), (float(direction[0]), float(direction[1]), float(direction[2]))
