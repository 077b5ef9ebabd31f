"""The scenario's fence for set points: its border as walls (skytender/geometry.py), and places brought inside.

The border is where it is allowed to be on one side and not on the other, whatever areas overlap or touch. A circle
counts as a polygon of `CIRCLE` corners, inscribed where it is to be stayed in, circumscribed where it is to be stayed
out of, so that both are kept. Heights do not matter: a fence is as high as the world. Frames NED, lengths in metres.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gcs.scenario.fence import CIRCLE, NO_FENCE, Area
from gcs.scenario.model import Scenario
from gcs.scenario.parts.mission import way_of
from gcs.telemetry.state import Vec3
from skytender import elementary, geometry
from skytender.geometry import FloatArray

Bools = NDArray[np.bool_]

_BESIDE_M = 1e-4
"""So far to either side of the border it is asked whether one may be there; shorter stretches are left out."""
_CORNER_MOVES = 3
"""[choice] In a corner a place clear of one side is moved off the other, too; in one too narrow it is left so."""
ABOVE_M = 2.0
"""[choice] So much higher than any place of the scenario routes are looked for."""


class FenceBorder:
    """Border and inside of a scenario's fence; without one, or without the safety layer, nothing is forbidden."""

    def __init__(self, scenario: Scenario, clearance_m: float) -> None:
        """clearance_m: how far inside a place is brought that lies beyond."""
        self._clearance_m = clearance_m
        rules = scenario.fence if scenario.planner.safety else NO_FENCE
        inside, outside = rules.inside, rules.outside
        self._inside = [_corners(area, inscribed=True) for area in inside]
        self._outside = [_corners(area, inscribed=False) for area in outside]
        self._a, self._b, self._inward = self._border()
        high_d, low_d = _heights(scenario)
        self.walls = geometry.table(
            [
                geometry.wall((a[0], a[1]), (b[0], b[1]), high_d, low_d)
                for a, b in zip(self._a.tolist(), self._b.tolist(), strict=True)
            ]
        )
        """obstacle table (m, COLUMNS) of the border"""

    def allows(self, p_ned: FloatArray) -> Bools:
        """Whether one may be at each of the places (k, 2) or (k, 3), (k,)."""
        kept_in = np.full(len(p_ned), not self._inside)
        for corners in self._inside:
            kept_in |= _covers(corners, p_ned)
        for corners in self._outside:
            kept_in &= ~_covers(corners, p_ned)
        return kept_in

    def brought_inside(self, p_ned: Vec3) -> Vec3:
        """The place itself where one may be there, else the place inside that is nearest to it, clear of the border."""
        if not len(self.walls) or self.allows(np.array([p_ned]))[0]:
            return p_ned
        here = np.array(p_ned[:2])
        foot, nearest, _ = self._nearest(here)
        here = foot + self._clearance_m * self._inward[nearest]
        for _ in range(_CORNER_MOVES):
            _, nearest, apart_m = self._nearest(here)
            if apart_m >= self._clearance_m:
                break
            here = here + (self._clearance_m - apart_m) * self._inward[nearest]
        return float(here[0]), float(here[1]), p_ned[2]

    def _nearest(self, here: FloatArray) -> tuple[FloatArray, int, float]:
        """Place of the border that is nearest to `here` (2,), on which stretch it lies, and how far away."""
        along = self._b - self._a
        share = np.clip(((here - self._a) * along).sum(axis=1) / (along * along).sum(axis=1), 0.0, 1.0)
        feet = self._a + share[:, None] * along
        apart_m = _lengths(feet - here)
        k = int(np.argmin(apart_m))
        return feet[k], k, float(apart_m[k])

    def _border(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Ends (m, 2), (m, 2) of each stretch of the border, and the unit vector (m, 2) from it to the inside."""
        rings = self._inside + self._outside
        if not rings:
            return np.zeros((0, 2)), np.zeros((0, 2)), np.zeros((0, 2))
        a = np.concatenate(rings)
        b = np.concatenate([np.roll(ring, -1, axis=0) for ring in rings])
        pieces = [_cut(a[k], b[k], a, b) for k in range(len(a))]
        a = np.concatenate([piece[:-1] for piece in pieces])
        b = np.concatenate([piece[1:] for piece in pieces])
        length = _lengths(b - a)
        a, b = a[length > 2.0 * _BESIDE_M], b[length > 2.0 * _BESIDE_M]
        along = (b - a) / _lengths(b - a)[:, None]
        left = np.column_stack([-along[:, 1], along[:, 0]])
        middle = (a + b) / 2.0
        on_left, on_right = (self.allows(middle + sign * _BESIDE_M * left) for sign in (1.0, -1.0))
        kept = on_left != on_right
        return a[kept], b[kept], np.where(on_left, 1.0, -1.0)[kept, None] * left[kept]


def _corners(area: Area, *, inscribed: bool) -> FloatArray:
    corners = np.array(area.border_ned)
    if area.circle_m is not None and not inscribed:
        centre = np.array(area.circle_m)
        corners = centre + (corners - centre) / elementary.cos(math.pi / CIRCLE)
    return corners


def _covers(corners: FloatArray, p_ned: FloatArray) -> Bools:
    """Whether a polygon covers each place (k,): a line from there to the east crosses it an odd number of times."""
    n, e = p_ned[:, 0, None], p_ned[:, 1, None]
    n0, e0 = corners.T
    n1, e1 = np.roll(corners, -1, axis=0).T
    level = (n0 > n) != (n1 > n)
    with np.errstate(divide="ignore", invalid="ignore"):
        crossed = level & (e < e0 + (e1 - e0) * (n - n0) / (n1 - n0))
    return crossed.sum(axis=1) % 2 == 1


def _lengths(v: FloatArray) -> FloatArray:
    """(m,) of vectors (m, 2)."""
    return np.asarray(np.sqrt(v[:, 0] * v[:, 0] + v[:, 1] * v[:, 1]))


def _cut(a: FloatArray, b: FloatArray, from_ne: FloatArray, to_ne: FloatArray) -> FloatArray:
    """The edge a-b (2,) cut where any of the edges (m, 2) meets it: its places (k, 2) in order, from a to b."""
    along, other, between = b - a, to_ne - from_ne, from_ne - a
    square = float(along[0] * along[0] + along[1] * along[1])
    if square == 0.0:
        return a[np.newaxis]
    across = along[0] * other[:, 1] - along[1] * other[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (between[:, 0] * other[:, 1] - between[:, 1] * other[:, 0]) / across
        u = (between[:, 0] * along[1] - between[:, 1] * along[0]) / across
    crossing = t[(across != 0.0) & (u >= 0.0) & (u <= 1.0)]
    aside = np.abs(between[:, 0] * along[1] - between[:, 1] * along[0])
    on_line = (across == 0.0) & (aside <= _BESIDE_M * math.sqrt(square))
    ends = [((end[on_line] - a) * along).sum(axis=1) / square for end in (from_ne, to_ne)]
    shares = np.concatenate([crossing, *ends])
    shares = np.unique(np.concatenate([[0.0], shares[(shares > 0.0) & (shares < 1.0)], [1.0]]))
    return a + shares[:, None] * along


def _heights(scenario: Scenario) -> tuple[float, float]:
    """Least and greatest down between which vehicles are expected."""
    downs = [0.0]
    for vehicle in scenario.vehicles.all:
        downs += [vehicle.start_m[2], vehicle.start_m[2] - vehicle.takeoff_m]
        for key in ("waypoints_m", "path_m"):
            downs += [place[2] for place in getattr(vehicle, key, ())]
        downs += [place[2] for place in way_of(vehicle, scenario)]
        home_m = getattr(vehicle, "home_m", None)
        downs += [home_m[2]] if home_m else []
    above_m = scenario.refuelling.height_m + abs(scenario.formation.height_m) + ABOVE_M
    return min(downs) - above_m, max(downs)
