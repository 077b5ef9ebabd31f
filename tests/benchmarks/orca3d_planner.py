"""Yardstick for dense fleets: A* way points and ORCA in three dimensions as a planner of a user's own.

    planner: {method: "orca3d_planner:AStarOrca3d", safety: false}

As `orca_planner` in all else. Each pair of vehicles shares the least change of its relative velocity that leads it out
of the velocities by which both meet within the horizon, a ball at the end of a cone. Each vehicle's velocity is then
the one nearest to its wish within its half-spaces and its speed [lineage: van den Berg, Guy, Lin, Manocha, Reciprocal
n-body collision avoidance, ISRR 2009; three dimensions as in the authors' library RVO2-3D, which has no package]. The
problem is solved exactly: among all places at which up to three limits meet. Where none is within all half-spaces,
that velocity is taken which leaves them least.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from orca_planner import HORIZON_S, MARGIN_M, NEIGHBOUR_M, AStarOrca, FloatArray
from scipy.optimize import linprog
from scipy.spatial import cKDTree

from gcs.planner.request import Situation

_NEIGHBOURS = 10
_WITHIN = 1e-7
_FACETS = np.array([v for v in itertools.product((-1.0, 0.0, 1.0), repeat=3) if any(v)])
_FACETS /= np.linalg.norm(_FACETS, axis=1, keepdims=True)


class AStarOrca3d(AStarOrca):
    """Leaders of all pursuers, moved together once a tick; each evades in all three directions."""

    def _reciprocal(
        self, situation: Situation, led: Sequence[int], p: FloatArray, v: FloatArray, wish: FloatArray, speed: float
    ) -> FloatArray:
        places, velocities = self._everything(situation, led, p, v)
        between_m = self._scenario.planner.separation_m + MARGIN_M
        count = min(_NEIGHBOURS + 1, len(places))
        away_m, beside = cKDTree(places).query(p, k=count, distance_upper_bound=NEIGHBOUR_M)
        chosen = wish.copy()
        away_m, beside = away_m.reshape(len(p), -1), beside.reshape(len(p), -1)
        for i in range(len(p)):
            rows = beside[i][np.isfinite(away_m[i]) & (beside[i] != i)]
            if len(rows):
                normals, offsets = half_spaces(
                    places[rows] - p[i], v[i] - velocities[rows], v[i], between_m, HORIZON_S, situation.period_s
                )
                chosen[i] = nearest(normals, offsets, wish[i], speed)
        return chosen


def half_spaces(
    away: FloatArray, relative: FloatArray, v: FloatArray, between_m: float, horizon_s: float, period_s: float
) -> tuple[FloatArray, FloatArray]:
    """Normals (k, 3) and offsets (k,) of velocities w with normal · w >= offset that each of k neighbours leaves.

    away, relative: (k, 3) from the vehicle to each, m, and its velocity less theirs, m/s.
    """
    square = (away * away).sum(axis=1)
    meets = square <= between_m * between_m
    ends_s = np.where(meets, period_s, horizon_s)[:, None]
    w = relative - away / ends_s
    w_size = np.maximum(np.linalg.norm(w, axis=1), 1e-9)
    towards = (w * away).sum(axis=1)
    on_ball = meets | ((towards < 0.0) & (towards * towards > between_m * between_m * w_size * w_size))
    normals = w / w_size[:, None]
    missing = between_m / ends_s[:, 0] - w_size
    for k in np.flatnonzero(~on_ball).tolist():  # beside the cone: the nearest place on its mantle
        a, b = square[k], away[k] @ relative[k]
        cross = np.cross(away[k], relative[k])
        c = relative[k] @ relative[k] - cross @ cross / (a - between_m * between_m)
        t = (b + np.sqrt(max(b * b - a * c, 0.0))) / a
        out = relative[k] - t * away[k]
        size = max(float(np.linalg.norm(out)), 1e-9)
        normals[k], missing[k] = out / size, between_m * t - size
    return normals, normals @ v + 0.5 * missing


def nearest(normals: FloatArray, offsets: FloatArray, wish: FloatArray, speed: float) -> FloatArray:
    """The velocity (3,) nearest to a wish within half-spaces and a speed; where there is none, the one that leaves
    half-spaces least."""
    found = [wish[None], *_on_planes(normals, offsets, wish), *_on_ball(normals, offsets, wish, speed)]
    tried = np.concatenate(found)
    tried = tried[np.isfinite(tried).all(axis=1)]
    within = (tried @ normals.T >= offsets - _WITHIN).all(axis=1)
    within &= np.linalg.norm(tried, axis=1) <= speed + _WITHIN
    if within.any():
        inside = tried[within]
        best: FloatArray = inside[np.linalg.norm(inside - wish, axis=1).argmin()]
        return best
    left = linprog(  # the greatest violation, least
        [0.0, 0.0, 0.0, 1.0],
        A_ub=np.block([[-normals, -np.ones((len(normals), 1))], [_FACETS, np.zeros((len(_FACETS), 1))]]),
        b_ub=np.concatenate([-offsets, np.full(len(_FACETS), speed)]),
        bounds=[(None, None)] * 3 + [(0.0, None)],
    ).x[:3]
    slowed: FloatArray = left * min(1.0, speed / max(float(np.linalg.norm(left)), 1e-9))
    return slowed


def _on_planes(normals: FloatArray, offsets: FloatArray, wish: FloatArray) -> list[FloatArray]:
    """The wish moved to each plane, to where each two meet, and where each three do."""
    found = []
    for size in (1, 2, 3):
        rows = np.array(list(itertools.combinations(range(len(normals)), size)), np.int64).reshape(-1, size)
        of = normals[rows]
        gram = of @ of.transpose(0, 2, 1)
        sure = np.abs(np.linalg.det(gram)) > 1e-9
        missing = offsets[rows[sure]] - of[sure] @ wish
        shares = np.linalg.solve(gram[sure], missing[..., None])
        found.append(wish + (of[sure] * shares).sum(axis=1))
    return found


def _on_ball(normals: FloatArray, offsets: FloatArray, wish: FloatArray, speed: float) -> list[FloatArray]:
    """The places nearest to the wish at full speed: anywhere, on each plane, and where each two planes meet."""
    found = [wish[None] * (speed / max(float(np.linalg.norm(wish)), 1e-9))]
    with np.errstate(invalid="ignore"):  # a plane, or a line, that the ball does not meet
        middle = normals * offsets[:, None]
        aside = wish - normals * (normals @ wish)[:, None]
        radius = np.sqrt(speed * speed - offsets * offsets)
        found.append(middle + aside * (radius / np.maximum(np.linalg.norm(aside, axis=1), 1e-9))[:, None])
        rows = np.array(list(itertools.combinations(range(len(normals)), 2)), np.int64).reshape(-1, 2)
        along = np.cross(normals[rows[:, 0]], normals[rows[:, 1]])
        sure = np.linalg.norm(along, axis=1) > 1e-6
        rows, along = rows[sure], along[sure] / np.linalg.norm(along[sure], axis=1, keepdims=True)
        of = normals[rows]
        shares = np.linalg.solve(of @ of.transpose(0, 2, 1), offsets[rows][..., None])
        foot = (of * shares).sum(axis=1)
        reach = np.sqrt(speed * speed - (foot * foot).sum(axis=1))[:, None]
    return [*found, foot + reach * along, foot - reach * along]
