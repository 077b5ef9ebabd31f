"""Dense random scenarios of 40 to 100 vehicles that change places: a cube, a forest, streets, a circle. Metres, NED.

Places lie as near to each other as a start may, and a little more. A cube has 20 vehicles at least.
"""

from __future__ import annotations

import math

import numpy as np

from gcs.campaign.families.parts import (
    MARGIN_M,
    OBSTACLE_M,
    Document,
    FloatArray,
    box_of,
    ring_places,
    rounded_m,
    separation_of,
    table_of,
    to_way_points,
)
from skytender import elementary
from skytender import geometry as shapes

FEWEST, MOST, DENSE_S = 40, 100, 120.0
LEAST_FULL, MOST_FULL = 0.1, 0.3
"""Of a volume: the share of it that cubes as wide as places lie apart take."""
LOWEST_M = 2.0
TREES, TREE_TOP_M, TOWERS, TOWER_M, TOWER_TOP_M = (30, 60), 9.0, 4, 3.0, 9.0


def cube(rng: np.random.Generator) -> Document:
    """20 to 100 vehicles change places in a cube."""
    n, separation_m, apart_m = _drawn(rng, fewest=20)
    side_m = apart_m * elementary.pow(n / float(rng.uniform(LEAST_FULL, MOST_FULL)), 1.0 / 3.0)
    low = np.array([0.0, 0.0, -LOWEST_M - side_m])
    starts = _places(rng, n, low, low + side_m, apart_m, np.zeros((0, shapes.COLUMNS)))
    return _exchanged(rng, starts, separation_m)


def forest(rng: np.random.Generator) -> Document:
    """40 to 100 vehicles change places among trees."""
    n, separation_m, apart_m = _drawn(rng)
    high_m, trees = 5.0, int(rng.integers(TREES[0], TREES[1] + 1))
    side_m = math.sqrt(n * apart_m * apart_m * apart_m / (float(rng.uniform(LEAST_FULL, 0.2)) * high_m))
    obstacles = []
    for place in rng.uniform(0.0, side_m, (trees, 2)):
        radius_m = round(float(rng.uniform(0.15, 0.5)), 3)
        obstacles.append({"cylinder_m": rounded_m(place), "radius_m": radius_m, "bottom_m": 0.0, "top_m": -TREE_TOP_M})
    low, high = np.array([0.0, 0.0, -LOWEST_M - high_m]), np.array([side_m, side_m, -LOWEST_M])
    starts = _places(rng, n, low, high, apart_m, table_of({"obstacles": obstacles}))
    return _exchanged(rng, starts, separation_m, obstacles)


def streets(rng: np.random.Generator) -> Document:
    """40 to 100 vehicles around and between 16 towers change places along streets two to three separations wide."""
    n, separation_m, apart_m = _drawn(rng)
    street_m = separation_m * float(rng.uniform(2.0, 3.0)) + 2.0 * MARGIN_M
    pitch_m, high_m = TOWER_M + street_m, 5.0
    corners = [pitch_m * np.array([k // TOWERS, k % TOWERS, 0.0]) for k in range(TOWERS * TOWERS)]
    obstacles = [
        box_of(at - np.array([0.0, 0.0, TOWER_TOP_M]), at + np.array([TOWER_M, TOWER_M, 0.0])) for at in corners
    ]
    out_m = 6.0
    low = np.array([-out_m, -out_m, -LOWEST_M - high_m])
    high = np.array([TOWERS * pitch_m + out_m, TOWERS * pitch_m + out_m, -LOWEST_M])
    starts = _places(rng, n, low, high, apart_m, table_of({"obstacles": obstacles}))
    return _exchanged(rng, starts, separation_m, obstacles)


def big_circle(rng: np.random.Generator) -> Document:
    """40 to 100 vehicles on a circle, each to the place opposite."""
    n, separation_m, apart_m = _drawn(rng)
    radius_m = apart_m / (2.0 * elementary.sin(math.pi / n))
    middle = np.array([0.0, 0.0, -6.0])
    starts = ring_places(rng, middle, n, radius_m)
    return to_way_points(
        rng, starts, 2.0 * middle - starts, way_m=2.0 * radius_m, separation_m=separation_m, airborne=True,
        longest_s=DENSE_S,
    )  # fmt: skip


def _drawn(rng: np.random.Generator, fewest: int = FEWEST) -> tuple[int, float, float]:
    """How many, the separation, and how far places lie apart."""
    separation_m = separation_of(rng)
    return int(rng.integers(fewest, MOST + 1)), separation_m, separation_m + MARGIN_M + float(rng.uniform(0.0, 0.2))


def _places(
    rng: np.random.Generator, n: int, low: FloatArray, high: FloatArray, apart_m: float, table: FloatArray
) -> FloatArray:
    """n places (n, 3) between two corners, apart from each other and from obstacles."""
    found = np.zeros((0, 3))
    while len(found) < n:
        place = rng.uniform(low, high)
        apart = ((found - place) * (found - place)).sum(axis=1) >= apart_m * apart_m
        if apart.all() and shapes.clearance(table, place[None])[0] >= OBSTACLE_M:
            found = np.vstack([found, place])
    return found


def _exchanged(
    rng: np.random.Generator, starts: FloatArray, separation_m: float, obstacles: list[Document] | None = None
) -> Document:
    ends = starts[rng.permutation(len(starts))]
    longest_m = float(np.sqrt(((ends - starts) * (ends - starts)).sum(axis=1).max()))
    return to_way_points(
        rng, starts, ends, way_m=longest_m, separation_m=separation_m, airborne=True, obstacles=obstacles,
        longest_s=DENSE_S,
    )  # fmt: skip
