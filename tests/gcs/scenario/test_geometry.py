"""Truth: hand-computed distances, and the nearest of a dense sampling of each shape's surface."""

import math

import numpy as np
import pytest
from field import surface

from skytender import geometry

UP = (0.0, 0.0, -1.0)

CASES = {
    "point, 3-4-5": (geometry.point((1, 2, 3)), (4, 6, 3), 5.0, (0.6, 0.8, 0)),
    "point, at its centre": (geometry.point((1, 2, 3)), (1, 2, 3), 0.0, UP),
    "sphere, outside": (geometry.sphere((0, 0, 0), 2), (0, 5, 0), 3.0, (0, 1, 0)),
    "sphere, inside": (geometry.sphere((0, 0, 0), 2), (0, 0.5, 0), -1.5, (0, 1, 0)),
    "sphere, at its centre": (geometry.sphere((0, 0, 0), 2), (0, 0, 0), -2.0, UP),
    "box, over its roof": (geometry.box((0, 0, -4), (2, 6, 0)), (1, 3, -6), 2.0, UP),
    "box, off an edge": (geometry.box((0, 0, -4), (2, 6, 0)), (5, 10, -2), 5.0, (0.6, 0.8, 0)),
    "box, off a corner": (geometry.box((0, 0, -4), (2, 6, 0)), (3, 8, -6), 3.0, (1 / 3, 2 / 3, -2 / 3)),
    "box, inside": (geometry.box((0, 0, -4), (2, 6, 0)), (1.7, 3, -2), -0.3, (1, 0, 0)),
    "box, on its roof": (geometry.box((0, 0, -4), (2, 6, 0)), (1, 3, -4), 0.0, UP),
    "cylinder, beside": (geometry.cylinder((0, 0, -5), 1, 10), (3, 4, -2), 4.0, (0.6, 0.8, 0)),
    "cylinder, above": (geometry.cylinder((0, 0, -5), 1, 10), (0.5, 0, -12), 2.0, UP),
    "cylinder, off its rim": (geometry.cylinder((0, 0, -5), 1, 10), (4, 0, -14), 5.0, (0.6, 0, -0.8)),
    "cylinder, inside, wall is near": (geometry.cylinder((0, 0, -5), 1, 10), (0, 0.8, -5), -0.2, (0, 1, 0)),
    "cylinder, inside, lid is near": (geometry.cylinder((0, 0, -5), 1, 10), (0, 0.5, -9.9), -0.1, UP),
}


@pytest.mark.parametrize("case", CASES)
def test_distance_and_direction_are_the_hand_computed(case: str) -> None:
    row, q, distance_m, direction = CASES[case]
    got_distance, got_direction = surface(geometry.table([row]), q)
    assert got_distance[0] == pytest.approx(distance_m, abs=1e-12)
    assert got_direction[0] == pytest.approx(direction, abs=1e-12)


def sampled_box(rng: np.random.Generator) -> np.ndarray:
    """Points on the box (-1,-2,-3)..(1,2,3)."""
    half = np.array([1.0, 2.0, 3.0])
    p = rng.uniform(-half, half, (60_000, 3))
    axis = rng.integers(0, 3, len(p))
    rows = np.arange(len(p))
    p[rows, axis] = half[axis] * rng.choice([-1, 1], len(p))
    return p


def sampled_cylinder(rng: np.random.Generator) -> np.ndarray:
    """Points on the cylinder of radius 1.5 and height 4 about the origin."""
    angle, r = rng.uniform(0, 2 * np.pi, 60_000), 1.5 * np.sqrt(rng.uniform(0, 1, 60_000))
    down, wall = rng.uniform(-2, 2, 60_000), rng.random(60_000) < 0.5
    r[wall], down[~wall] = 1.5, 2 * np.sign(down[~wall])
    return np.stack([r * np.cos(angle), r * np.sin(angle), down], axis=1)


@pytest.mark.parametrize(
    ("row", "sample"),
    [
        (geometry.box((-1, -2, -3), (1, 2, 3)), sampled_box),
        (geometry.cylinder((0, 0, 0), 1.5, 4), sampled_cylinder),
    ],
    ids=["box", "cylinder"],
)
def test_distance_is_that_of_the_nearest_sampled_surface_point(row: np.ndarray, sample: object) -> None:
    rng = np.random.default_rng(3)
    on_surface = sample(rng)  # type: ignore[operator]
    table = geometry.table([row])
    for q in rng.uniform(-4, 4, (40, 3)):
        distance, direction = surface(table, q)
        assert abs(distance[0]) == pytest.approx(np.linalg.norm(on_surface - q, axis=1).min(), abs=0.06)
        assert np.linalg.norm(direction[0]) == pytest.approx(1, abs=1e-12)
        foot, _ = surface(table, q - distance[0] * direction[0])
        assert foot[0] == pytest.approx(0, abs=1e-9)


def test_clearance_is_the_least_distance_to_any_shape() -> None:
    table = geometry.table([geometry.point((0, 0, 0)), geometry.sphere((10, 0, 0), 2)])
    assert geometry.clearance(table, [(3, 0, 0), (7, 0, 0), (9, 0, 0)]) == pytest.approx([3, 1, -1])


def test_clearance_of_many_shapes_is_to_the_last_bit_the_least_of_their_distances_one_by_one() -> None:
    rng = np.random.default_rng(3)
    at = rng.uniform(-30, 30, size=(10, 3))
    size, aside = np.array([8, 1, 3]), np.array([20, -20, 0])
    rows = [geometry.point(p) for p in at] + [geometry.sphere(p, 2) for p in at + 40]
    rows += [geometry.box(p, p + size) for p in at - 25] + [geometry.cylinder(p, 1, 20) for p in at + aside]
    table = geometry.table(rows)
    # Among them places due north and due east of centres, and inside shapes.
    places = np.concatenate(
        [
            rng.uniform(-60, 80, size=(500, 3)),
            table[:, 1:4] + np.array([9, 0, 0]),
            table[:, 1:4] + np.array([0, 0.4, 0]),
        ]
    )
    least = [min(surface(row[np.newaxis], place)[0][0] for row in table) for place in places]
    assert np.array_equal(geometry.clearance(table, places), least)


def test_clearance_without_obstacles_is_infinite() -> None:
    assert geometry.clearance(geometry.table([]), [(0, 0, 0)])[0] == math.inf


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: geometry.sphere((0, 0, 0), 0), "radius_m"),
        (lambda: geometry.sphere((0, 0, math.nan), 1), "centre_ned"),
        (lambda: geometry.box((0, 0, 0), (1, 1, -1)), "down"),
        (lambda: geometry.cylinder((0, 0, 0), 1, -1), "height_m"),
        (lambda: geometry.point((0, 0)), "p_ned"),
        (lambda: geometry.points([(0, 0, math.inf)]), "positions_ned"),
    ],
)
def test_a_shape_that_is_none_is_refused_by_name(make: object, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        make()  # type: ignore[operator]
