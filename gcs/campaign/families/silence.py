"""Random scenarios in which the ground station falls silent for every vehicle at once, for 30 s or for good.

All start on a grid of 2 m. At a random time, while they climb, cross in rings, stacks and cubes, or are refuelled in
the air and at bases, the station's radio dies. Some radios lose frames, and some part the fleet into two that do not
receive each other. Obstacles stand on the ground, so that the way up is free everywhere. Metres, NED.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from gcs.campaign.families import parts
from skytender import elementary
from skytender import geometry as shapes

GRID_M = 2.0
FEWEST, MOST, MOST_SERVED = 4, 40, 10
SILENT_FROM_S, SILENT_BEFORE_S = 5.0, 35.0
SILENCE_S, COMES_DOWN_S, GOES_ON_S = 30.0, 160.0, 25.0
"""Of a silence that ends; after one that does not, until all have landed; after one that does."""
PAD_NED = np.array([-4.0, 0.0, 0.0])
FAR_M = 4.0
"""From the grid's edge to where the fleet flies."""
STANDING = ("box_m", "cylinder_m")


def silence(rng: np.random.Generator) -> parts.Document:
    """4 to 40 vehicles in a ring, stacks or a cube, or up to 10 with their tankers and bases."""
    separation_m, kind = parts.separation_of(rng), ("ring", "stack", "cube", "tankers")[int(rng.integers(4))]
    n = FEWEST + int((MOST - FEWEST + 1) * elementary.pow(float(rng.random()), 2.0))
    n = min(n, MOST_SERVED) if kind == "tankers" else n
    tankers = int(rng.integers(1, 4)) if kind == "tankers" else 0
    starts = _grid(rng, n + tankers)
    apart_m = separation_m + parts.MARGIN_M + 0.2
    ways = {"ring": _rings, "stack": _stacks}.get(kind, _cubes)(rng, n, apart_m if kind != "tankers" else 3.0)
    ways[:, :, 0] += float(starts[:, 0].max()) + FAR_M - ways[:, :, 0].min()
    document: parts.Document = {
        "goal": {"duration_s": 0.0},
        "vehicles": {"defaults": {"battery": dict(parts.BATTERY)}},
        "vehicles_per_process": FEWEST + MOST,
        "planner": {"cruise_m_s": parts.speed_of(rng), "separation_m": separation_m},
        "refuelling": {"enabled": bool(tankers)},
    }
    document["vehicles"]["pursuers"] = [
        {"sysid": i + 1, "start_m": parts.rounded_m(starts[i]), "waypoints_m": [parts.rounded_m(p) for p in ways[i]]}
        for i in range(n)
    ]
    if rng.random() < 0.4:
        document["obstacles"] = _obstacles(rng, starts, ways)
    if tankers:
        _refuel(rng, document, starts[n:])
    return document | _silent(rng, document, n + tankers)


def _silent(rng: np.random.Generator, document: parts.Document, n: int) -> parts.Document:
    """The radio, and the duration that it asks for."""
    from_s = round(float(rng.uniform(SILENT_FROM_S, SILENT_BEFORE_S)), 1)
    ends = bool(rng.random() < 0.5)
    duration_s = math.ceil(from_s + (SILENCE_S + GOES_ON_S if ends else COMES_DOWN_S))
    to_s = from_s + SILENCE_S if ends else duration_s + 1.0
    radio: parts.Document = {"ground_blackouts": [{"from_s": from_s, "to_s": round(to_s, 1)}]}
    if rng.random() < 0.5:
        radio["loss"] = float(rng.choice([0.1, 0.3]))
    if rng.random() < 1 / 3:
        sysids = [v["sysid"] for group in ("pursuers", "tankers") for v in document["vehicles"].get(group, [])]
        part = sorted(int(sysid) for sysid in rng.permutation(sysids)[: n // 2])
        begins_s = round(from_s + float(rng.uniform(0.0, 10.0)), 1)
        ends_s = round(begins_s + float(rng.uniform(5.0, 30.0)), 1)
        radio["splits"] = [{"sysids": part, "from_s": begins_s, "to_s": ends_s}]
    return {"radio": radio, "goal": {"duration_s": float(duration_s)}}


def _grid(rng: np.random.Generator, n: int) -> parts.FloatArray:
    """n places on the ground, in rows and columns, in random order."""
    wide = math.ceil(math.sqrt(n))
    places = [[GRID_M * (k // wide), GRID_M * (k % wide - (wide - 1) / 2), 0.0] for k in range(n)]
    return np.array(places)[rng.permutation(n)]


def _rings(rng: np.random.Generator, n: int, apart_m: float) -> parts.FloatArray:
    """(n, 2, 3): to places on a ring, and on to the ones opposite."""
    radius_m = max(3.0, apart_m / (2.0 * elementary.sin(math.pi / n)))
    ring = parts.ring_places(rng, np.array([0.0, 0.0, -5.0]), n, radius_m)
    opposite = ring * [-1.0, -1.0, 1.0]
    order = rng.permutation(n)
    return np.stack([ring[order], opposite[order]], axis=1)


def _stacks(rng: np.random.Generator, n: int, apart_m: float) -> parts.FloatArray:
    """(n, 2, 3): to places in stacks of up to five, and on to others' places in them."""
    high, columns = 5, math.ceil(n / 5)
    wide = math.ceil(math.sqrt(columns))
    slots = np.array(
        [
            [2.0 * apart_m * (k // high // wide), 2.0 * apart_m * (k // high % wide), -2.5 - apart_m * (k % high)]
            for k in range(n)
        ]
    )
    return np.stack([slots[rng.permutation(n)], slots[rng.permutation(n)]], axis=1)


def _cubes(rng: np.random.Generator, n: int, apart_m: float) -> parts.FloatArray:
    """(n, 2, 3): to random places in a cube, and on to others."""
    return np.stack([_apart(rng, n, apart_m), _apart(rng, n, apart_m)], axis=1)


def _apart(rng: np.random.Generator, n: int, apart_m: float) -> parts.FloatArray:
    side_m = max(4.0, 1.6 * apart_m * elementary.pow(float(n), 1.0 / 3.0))
    found: list[parts.FloatArray] = []
    while len(found) < n:
        place = rng.uniform(0.0, 1.0, 3) * side_m * [1.0, 1.0, -1.0] - [0.0, 0.0, 2.5]
        if all(elementary.distance(place.tolist(), other.tolist()) >= apart_m for other in found):
            found.append(place)
    return np.array(found)


def _obstacles(rng: np.random.Generator, starts: parts.FloatArray, ways: parts.FloatArray) -> list[parts.Document]:
    """1 to 6 boxes and cylinders that stand on the ground, away from starts and from what is over way points."""
    columns = [p * [1.0, 1.0, 0.0] + [0.0, 0.0, -h] for p in (*starts, *ways.reshape(-1, 3)) for h in range(9)]
    keep = np.array(columns)
    low, high = [*(keep[:, :2].min(axis=0) - 3.0), -6.0], [*(keep[:, :2].max(axis=0) + 3.0), -0.5]
    wanted, placed = int(rng.integers(1, 7)), list[parts.Document]()
    for _ in range(parts.TRIES):
        if len(placed) == wanted:
            break
        shape = parts.random_shape(rng, np.array(low), np.array(high))
        if not any(key in shape for key in STANDING):
            continue
        if (shapes.clearance(parts.table_of({"obstacles": [shape]}), keep) >= parts.OBSTACLE_M).all():
            placed.append(shape)
    return placed


def _refuel(rng: np.random.Generator, document: parts.Document, starts: ArrayLike) -> None:
    """Low batteries, tankers that start on the grid, and for some a base."""
    for pursuer in document["vehicles"]["pursuers"]:
        percent = round(float(rng.uniform(35.0, 70.0)), 1)
        pursuer["battery"] = {**parts.BATTERY, "capacity_j": 40000.0, "initial_percent": percent}
    tankers = []
    for i, start in enumerate(np.array(starts)):
        home = [start[0], start[1], -7.0 - 1.5 * i]
        tanker = {"sysid": 201 + i, "start_m": parts.rounded_m(start), "home_m": parts.rounded_m(home)}
        tankers.append(
            tanker | {"speed_m_s": parts.speed_of(rng), "battery": {**parts.BATTERY, "capacity_j": 150000.0}}
        )
    document["vehicles"]["tankers"] = tankers
    solid = parts.table_of({"obstacles": document.get("obstacles", [])})
    if rng.random() < 0.4 and shapes.clearance(solid, PAD_NED[np.newaxis])[0] >= parts.OBSTACLE_M:
        document["bases"] = [{"name": "pad", "position_m": parts.rounded_m(PAD_NED), "stock_j": 100000.0}]
