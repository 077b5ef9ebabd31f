"""Places, shapes and rings as scenario documents have them, drawn at random for scenario families. Metres, NED."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gcs.scenario.model import Obstacle
from skytender import elementwise
from skytender import geometry as shapes

Document = dict[str, Any]
FloatArray = NDArray[np.float64]

MARGIN_M = 0.4
"""[choice] Beyond the separation, between two starts or two last way points: a ring's or row's slots are no tighter."""
OBSTACLE_M = 0.9
"""[choice] From starts and last way points to obstacles."""
LEAST_SPEED_M_S, MOST_SPEED_M_S = 1.5, 5.0
LONGEST_S = 60.0
TAKEOFF_M = 2.5
TRIES = 2000
ORIGIN = {"lat_deg": 47.397742, "lon_deg": 8.545594, "alt_m": 488.0}
BATTERY = {"capacity_j": 60000.0, "hover_w": 200.0, "avionics_w": 10.0}


def table_of(document: Document) -> FloatArray:
    """Obstacle table (m, COLUMNS) of a document in NED axes."""
    return shapes.of_scenario(map(Obstacle.model_validate, document.get("obstacles", [])))


def rounded_m(place: ArrayLike) -> list[float]:
    """A place as a document has it, to 1 mm."""
    return [round(float(x), 3) + 0.0 for x in np.asarray(place, dtype=np.float64)]


def speed_of(rng: np.random.Generator) -> float:
    return round(float(rng.uniform(LEAST_SPEED_M_S, MOST_SPEED_M_S)), 2)


def separation_of(rng: np.random.Generator) -> float:
    return round(float(rng.uniform(0.6, 1.0)), 2)


def box_of(low: ArrayLike, high: ArrayLike) -> Document:
    return {"box_m": [rounded_m(low), rounded_m(high)]}


def random_shape(rng: np.random.Generator, low: FloatArray, high: FloatArray) -> Document:
    """One shape of any kind with its centre between two corners; boxes and cylinders stand on the ground."""
    at, kind = rng.uniform(low, high), int(rng.integers(4))
    if kind == 0:
        return {"point_m": rounded_m(at)}
    if kind == 1:
        return {"sphere_m": rounded_m(at), "radius_m": round(float(rng.uniform(0.2, 1.2)), 3)}
    top_m = float(rng.uniform(2.0, 7.0))
    if kind == 2:
        half = rng.uniform(0.2, 1.5, 2)
        return box_of([*(at[:2] - half), -top_m], [*(at[:2] + half), 0.0])
    radius_m = round(float(rng.uniform(0.15, 0.8)), 3)
    return {"cylinder_m": rounded_m(at[:2]), "radius_m": radius_m, "bottom_m": 0.0, "top_m": round(-top_m, 3)}


def random_shapes(
    rng: np.random.Generator, count: int, keep: FloatArray, keep_m: FloatArray, wide_m: float
) -> list[Document]:
    """`count` shapes, each at least keep_m (k,) from the places keep (k, 3); fewer where there is no room."""
    low = np.array([*(keep[:, :2].min(axis=0) - wide_m), -6.0])
    high = np.array([*(keep[:, :2].max(axis=0) + wide_m), -0.5])
    placed: list[Document] = []
    for _ in range(TRIES):
        if len(placed) == count:
            break
        shape = random_shape(rng, low, high)
        if (shapes.clearance(table_of({"obstacles": [shape]}), keep) >= keep_m).all():
            placed.append(shape)
    return placed


def ring_places(rng: np.random.Generator, centre: FloatArray, n: int, ring_m: float) -> FloatArray:
    angle = rng.uniform(0.0, 2 * math.pi) + 2 * math.pi * np.arange(n) / n
    return centre + ring_m * np.column_stack([elementwise.cosines(angle), elementwise.sines(angle), np.zeros(n)])


def pursuers_of(starts: FloatArray, ends: FloatArray, *, airborne: bool) -> list[Document]:
    """Pursuers 1, 2, … each with one way point."""
    rows = []
    for i, (start, end) in enumerate(zip(starts, ends, strict=True)):
        rows.append(
            {"sysid": i + 1, "start_m": rounded_m(start), "airborne": airborne, "waypoints_m": [rounded_m(end)]}
        )
    return rows


def to_way_points(
    rng: np.random.Generator,
    starts: ArrayLike,
    ends: ArrayLike,
    *,
    way_m: float,
    separation_m: float,
    airborne: bool,
    obstacles: list[Document] | None = None,
    longest_s: float = LONGEST_S,
) -> Document:
    """A scenario in which each vehicle flies to its way point, a way of about `way_m`."""
    speed = speed_of(rng)
    duration_s = min(max(20.0, 2.0 * way_m / speed + (4.0 if airborne else 14.0)), longest_s)
    return {
        "goal": {"duration_s": float(math.ceil(duration_s))},
        "vehicles": {
            "defaults": {"battery": dict(BATTERY)},
            "pursuers": pursuers_of(np.array(starts), np.array(ends), airborne=airborne),
        },
        "obstacles": obstacles or [],
        "planner": {"cruise_m_s": speed, "separation_m": separation_m},
        "refuelling": {"enabled": False},
    }
