"""Neighbour lists against brute force, and a plan with them against one without."""

import numpy as np
import pytest
from field import surface

from gcs.planner import fuzzy_escape, leader, neighbours
from gcs.planner.potential_field import FieldConstants
from skytender import geometry

FIELD = FieldConstants(k0=15.0, k1=2.0, a=0.5, b=0.5, attraction_range_m=1.0, repulsion_range_m=1.0, step_m=0.1)


def shapes(rng: np.random.Generator, count: int) -> np.ndarray:
    rows = []
    for i in range(count):
        at = rng.uniform(-40, 40, 3)
        rows.append(
            (
                geometry.point(at),
                geometry.sphere(at, rng.uniform(0.1, 2.0)),
                geometry.box(at, at + rng.uniform(0.1, 3.0, 3)),
                geometry.cylinder(at, rng.uniform(0.1, 2.0), rng.uniform(0.5, 4.0)),
            )[i % 4]
        )
    return geometry.table(rows)


def test_nothing_in_range_is_left_out_and_rows_ascend() -> None:
    rng = np.random.default_rng(3)
    table, q = shapes(rng, 300), rng.uniform(-40, 40, (200, 3))
    ranges, reach = rng.uniform(0.2, 2.0, 300), rng.uniform(0.0, 1.0, 200)
    rows, spans = neighbours.within_range(q, reach, table, ranges)
    assert len(rows) < 0.3 * 200 * 300
    for i in range(200):
        mine = rows[spans[i, 0] : spans[i, 1]]
        assert (np.diff(mine) > 0).all()
        distance_m, _ = surface(table, q[i])
        assert set(np.flatnonzero(distance_m <= ranges + reach[i])) <= set(mine)


@pytest.mark.parametrize("seed", range(3))
def test_the_plan_is_the_same_to_the_last_bit(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(seed)
    n, m = 150, 160
    at = rng.uniform(-15, 15, (n, 3))

    def plan() -> tuple[np.ndarray, ...]:
        return leader.advance(
            at,
            fuzzy_escape.new_memory(n),
            np.roll(at, 1, axis=0),
            rng_velocity,
            repulsors=table,
            moving=at,
            radii_m=0.6,
            ranges_m=np.full(n, 1.3),
            owner=np.arange(n),
            exempt=np.zeros((n, n), dtype=bool),
            field=FIELD,
            speed_m_s=2.0,
            period_s=0.1,
            escape=True,
        )

    table, rng_velocity = shapes(rng, m), rng.uniform(-1, 1, (n, 3))
    sparse = plan()
    monkeypatch.setattr(neighbours, "FEW", n * n * m)
    for one, other in zip(sparse, plan(), strict=True):
        assert one.tobytes() == other.tobytes()


def test_everything_is_a_neighbour_where_there_are_few() -> None:
    rows, spans = neighbours.within_range(np.zeros((2, 3)), np.zeros(2), geometry.points(1e4 * np.eye(3)), np.ones(3))
    assert (rows.tolist(), spans.tolist()) == ([0, 1, 2], [[0, 3], [0, 3]])
