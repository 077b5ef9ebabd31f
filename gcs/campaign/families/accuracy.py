"""Random scenarios in which vehicles know their places to 0.1 to 1 m, on rotors in wind, with room for that.

Vehicles change places across a ring, fly in a circle to the next place but one, or pass a gap one after the other.
Metres, NED.
"""

from __future__ import annotations

import math

import numpy as np

from gcs.campaign.families.parts import (
    BATTERY,
    MARGIN_M,
    TAKEOFF_M,
    Document,
    FloatArray,
    box_of,
    random_shapes,
    ring_places,
    rounded_m,
    separation_of,
)
from skytender import elementary

LEAST_ERROR_M, MOST_ERROR_M = 0.1, 1.0
FEWEST, MOST = 4, 12
SPREADS = 4.8
"""[choice] At least the factor of gcs/scenario/accuracy.py for so many vehicles and so long a session."""
LEAST_M_S, MOST_M_S = 1.5, 3.0
"""Cruise."""
SPARE_S, MOST_S = 30.0, 200.0
"""For ways that are longer than straight ones; the longest session."""


def accuracy(rng: np.random.Generator) -> Document:
    """4 to 12 vehicles with errors of their places, on a ring, in a circle, or through a gap."""
    error_m = round(LEAST_ERROR_M * elementary.pow(MOST_ERROR_M / LEAST_ERROR_M, float(rng.random())), 2)
    separation_m, cruise_m_s = separation_of(rng), round(float(rng.uniform(LEAST_M_S, MOST_M_S)), 2)
    n, kind = int(rng.integers(FEWEST, MOST + 1)), ("ring", "circle", "gap")[int(rng.integers(3))]
    alone_m = SPREADS * error_m + 0.5
    apart_m = separation_m + math.sqrt(2.0) * SPREADS * error_m + 2.0 * MARGIN_M
    height_m = TAKEOFF_M + alone_m + 1.0
    radius_m = max(4.0, apart_m / (2.0 * elementary.sin(math.pi / n)))
    ring = ring_places(rng, np.array([0.0, 0.0, -height_m]), n, radius_m)
    document: Document = {
        "vehicles": {"defaults": {"plant": "rotors", "sensors": {"position_m": error_m}, "battery": dict(BATTERY)}},
        "planner": {"cruise_m_s": cruise_m_s, "separation_m": separation_m},
        "refuelling": {"enabled": False},
        "wind": {"speed_m_s": round(float(rng.uniform(0.0, 6.0)), 1), "turbulence_m_s": round(float(rng.random()), 2)},
    }
    if kind == "gap":
        starts, ends, document["obstacles"] = _gap(n, apart_m, alone_m, height_m)
    else:
        starts, ends = ring, np.roll(ring, n // 2 if kind == "ring" else 2, axis=0)
        keep_m = np.full(2 * n, alone_m + 1.0)
        document["obstacles"] = random_shapes(rng, int(rng.integers(4)), np.vstack([starts, ends]), keep_m, 0.0)
    document["vehicles"]["pursuers"] = [
        {"sysid": i + 1, "start_m": rounded_m(starts[i]), "airborne": True, "waypoints_m": [rounded_m(ends[i])]}
        for i in range(n)
    ]
    longest_m = float(np.sqrt(((ends - starts) * (ends - starts)).sum(axis=1)).max())
    document["goal"] = {"duration_s": min(math.ceil(2.0 * longest_m / cruise_m_s + SPARE_S), MOST_S)}
    return document


def _gap(n: int, apart_m: float, alone_m: float, height_m: float) -> tuple[FloatArray, FloatArray, list[Document]]:
    """Two columns of starts before a wall with a gap that one vehicle can pass, and as many places behind it."""
    rows = np.arange(n)
    north, east = apart_m * (1.0 + rows // 2) + alone_m, apart_m * (rows % 2 - 0.5)
    before = np.column_stack([-north, east, np.full(n, -height_m)])
    behind = np.column_stack([north, -east, np.full(n, -height_m)])
    half_m, wide_m, top_m = 1.3 * alone_m + 0.5, 4.0 * alone_m + 2.0 * apart_m, 2.0 * height_m + 2.0 * alone_m
    walls = [
        box_of([-0.3, half_m, -top_m], [0.3, half_m + wide_m, 0.0]),
        box_of([-0.3, -half_m - wide_m, -top_m], [0.3, -half_m, 0.0]),
    ]
    return before, behind[::-1].copy(), walls
