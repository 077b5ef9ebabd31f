"""The limits against their formulas, computed for every leader by itself with what Python rounds as."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gcs.planner import fuzzy_escape
from gcs.planner.floors import FLOOR_M, Floors
from gcs.planner.leader import LeaderRows, limit_speeds

LEASH_M, LOOKAHEAD_S, BRAKE_M_S2 = 2.0, 0.37, 1.2
N = 400


def leaders(rng: np.random.Generator) -> LeaderRows:
    goal_v = rng.uniform(-1.0, 1.0, (N, 3)) * (rng.random((N, 1)) < 0.5)
    made = LeaderRows(N, 1.0, fuzzy_escape.new_memory(N))
    made.q_ned[:], made.goal_v_ned[:] = rng.uniform(-9.0, 9.0, (N, 3)), goal_v
    made.speed_m_s[:] = rng.choice([0.0, 0.5, 1.0, 2.5], N)
    return made


def directions(rng: np.random.Generator) -> np.ndarray:
    way = rng.normal(size=(N, 3))
    return np.asarray(way / np.linalg.norm(way, axis=1)[:, None])


def length(v: list[float]) -> float:
    return math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])


def distance(a: list[float], b: list[float]) -> float:
    return length([p - q for p, q in zip(a, b, strict=True)])


def expected(some: LeaderRows, row: int, here: np.ndarray, route_m: float, brake_m_s2: float | None) -> float:
    """docs/model/planner.md#planned-point: the leader waits for who is behind by more than the leash, and can stop at
    its goal."""
    speed, q = float(some.speed_m_s[row]), some.q_ned[row].tolist()
    behind_m = distance(q, here[row].tolist())
    speed *= min(max(2.0 * (1.0 - behind_m / (LEASH_M + LOOKAHEAD_S * speed)), 0.0), 1.0)
    if brake_m_s2 is None:
        return speed
    way_m = distance(q, some.goal_ned[row].tolist()) if math.isnan(route_m) else route_m
    if math.isinf(way_m):
        return 0.0
    return min(speed, length(some.goal_v_ned[row].tolist()) + math.sqrt(2.0 * brake_m_s2 * way_m))


@pytest.mark.parametrize("brake_m_s2", [None, BRAKE_M_S2])
@pytest.mark.parametrize("seed", range(3))
def test_limits_are_those_of_the_formula_to_the_last_bit(seed: int, brake_m_s2: float | None) -> None:
    """Also where each of them just begins to limit, by a rounding more or less."""
    rng = np.random.default_rng(seed)
    some, rows = leaders(rng), np.sort(rng.choice(N, N - 20, replace=False))
    speed = some.speed_m_s.copy()
    free_m, stop_m = 0.5 * (LEASH_M + LOOKAHEAD_S * speed), speed**2 / (2.0 * BRAKE_M_S2)
    near = np.array([0.0, 0.5, 1.0 - 1e-15, 1.0, 1.0 + 1e-15, 1.0 + 1e-8, 1.9, 2.5])
    here = some.q_ned + directions(rng) * (rng.choice(near, N) * free_m)[:, None]
    some.goal_ned[:] = some.q_ned + directions(rng) * (rng.choice(near, N) * stop_m)[:, None]
    some.route_m[:] = np.where(rng.random(N) < 0.7, math.nan, rng.choice([0.0, 0.3, 50.0, math.inf], N))
    wanted = [expected(some, row, here, float(some.route_m[row]), brake_m_s2) for row in rows.tolist()]
    limit_speeds(rows, some.table, here, LEASH_M, LOOKAHEAD_S, math.inf if brake_m_s2 is None else brake_m_s2)
    assert some.speed_m_s[rows].tolist() == wanted
    left = np.setdiff1d(np.arange(N), rows)
    assert (some.speed_m_s[left] == speed[left]).all()
    assert 0 < np.count_nonzero(np.array(wanted) < speed[rows]) < len(rows)


def test_floors_follow_the_grounds_of_those_that_have_one() -> None:
    floors = Floors([2, 0, 1])
    grounds = np.array([math.nan, -0.05, -12.0, -12.0])
    assert floors.at(grounds).tolist() == [-FLOOR_M, -FLOOR_M, -FLOOR_M - 12.0, math.inf]
    grounds[0] = -3.0
    assert floors.at(grounds)[0] == -FLOOR_M - 3.0
    assert floors.at(np.array([0.0, 4.0, -3.0, 0.0])).tolist() == [-FLOOR_M, -FLOOR_M, -FLOOR_M - 3.0, math.inf]
