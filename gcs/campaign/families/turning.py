"""Random scenarios through whose fleets other aircraft fly that turn: to and fro, in circles, to places at random.

Aircraft fly at up to 3 m/s, no faster than `OUTRUN` of the vehicles' cruise, and come from `FAR_M` beyond the fleet.
Vehicles hover on a ring, change places across a circle, or fly to and fro in two lanes of a street. Metres, NED.
"""

from __future__ import annotations

import math

import numpy as np

from gcs.campaign.families.parts import (
    BATTERY,
    MARGIN_M,
    Document,
    FloatArray,
    ring_places,
    rounded_m,
    separation_of,
    speed_of,
)
from skytender import elementary

LEAST_M_S, MOST_M_S, OUTRUN = 1.0, 3.0, 0.9
FEWEST, MOST, DURATION_S = 4, 16, 45.0
SILENT_FROM_S, SILENCE_S = (8.0, 20.0), 15.0
HEIGHT_M, FAR_M, CORNERS = 7.0, 8.0, 16


def turning(rng: np.random.Generator) -> Document:
    """4 to 16 vehicles in a ring, a circle or a street, and one to three aircraft that turn among them."""
    separation_m, cruise_m_s = separation_of(rng), speed_of(rng)
    n, kind = int(rng.integers(FEWEST, MOST + 1)), ("ring", "circle", "street")[int(rng.integers(3))]
    apart_m = separation_m + MARGIN_M + float(rng.uniform(0.2, 2.0))
    middle = np.array([0.0, 0.0, -HEIGHT_M])
    if kind == "street":
        ways = _street(n, apart_m)
    else:
        ring = ring_places(rng, middle, n, max(3.0, apart_m / (2.0 * elementary.sin(math.pi / n))))
        ways = np.stack([ring] if kind == "ring" else [2.0 * middle - ring, ring], axis=1)
    pursuers = []
    for i, way in enumerate(ways):
        flown = way.tolist() * (1 if kind == "ring" else 1 + math.ceil(DURATION_S / 8.0))
        pursuers.append(
            {"sysid": i + 1, "start_m": rounded_m(way[-1]), "airborne": True, "waypoints_m": [*map(rounded_m, flown)]}
        )
    fast = min(MOST_M_S, OUTRUN * cruise_m_s)
    movers = []
    for i in range(int(rng.integers(1, 4))):
        speed_m_s = round(max(fast * float(rng.uniform(0.5, 1.0)), LEAST_M_S), 2)
        path = _path(rng, ways[:, -1], middle, speed_m_s * DURATION_S)
        movers.append({"callsign": f"TURN{i + 1}", "path_m": [*map(rounded_m, path)], "speed_m_s": speed_m_s})
    return {
        "goal": {"duration_s": DURATION_S, "waypoints": "none"},
        "vehicles": {"defaults": {"battery": dict(BATTERY)}, "pursuers": pursuers},
        "planner": {"cruise_m_s": cruise_m_s, "separation_m": separation_m},
        "refuelling": {"enabled": False},
        "traffic": movers,
    }


def silent_traffic(rng: np.random.Generator) -> Document:
    """The same while the station is silent: for a while in the middle of the session, or from then on."""
    document = turning(rng)
    from_s = round(float(rng.uniform(*SILENT_FROM_S)), 1)
    to_s = from_s + (SILENCE_S if rng.random() < 0.5 else DURATION_S)
    return document | {"radio": {"ground_blackouts": [{"from_s": from_s, "to_s": round(to_s, 1)}]}}


def _street(n: int, apart_m: float) -> FloatArray:
    """(n, 2, 3): to and fro along two lanes, against each other."""
    rows = np.arange(n)
    along, lane = apart_m * (rows // 2), apart_m * (rows % 2 - 0.5)
    one = np.column_stack([along, lane, np.full(n, -HEIGHT_M)])
    way_m = 10.0 * np.where(rows % 2, -1.0, 1.0)
    return np.stack([one + way_m[:, None] * [1.0, 0.0, 0.0], one], axis=1)


def _path(rng: np.random.Generator, places: FloatArray, middle: FloatArray, way_m: float) -> list[FloatArray]:
    """Corners from outside of the fleet, and then for `way_m` to and fro, around, or to places at random."""
    angle = float(rng.uniform(0.0, 2 * math.pi))
    ahead = np.array([elementary.cos(angle), elementary.sin(angle), 0.0])
    out_m = max(elementary.distance(place.tolist(), middle.tolist()) for place in places)
    path = [middle + (out_m + FAR_M) * ahead]
    kind, near = int(rng.integers(3)), places[int(rng.integers(len(places)))] + _aside(rng, 1.0)
    if kind == 0:
        leg = _aside(rng, 1.0)
        leg *= float(rng.uniform(1.0, 4.0)) / max(elementary.norm(leg.tolist()), 0.1)
        turns = [near + leg, near - leg]
    elif kind == 1:
        radius_m = float(rng.uniform(0.8, 1.2)) * out_m if rng.random() < 0.5 else float(rng.uniform(1.0, 4.0))
        turns = list(ring_places(rng, near if radius_m <= 4.0 else middle, CORNERS, radius_m))
    else:
        chosen = rng.integers(len(places), size=200)
        turns = [places[k] + _aside(rng, 1.0) for k in chosen]
    flown_m, k = 0.0, 0
    while flown_m < way_m:
        path.append(turns[k % len(turns)])
        flown_m += elementary.distance(path[-1].tolist(), path[-2].tolist())
        k += 1
    return path


def _aside(rng: np.random.Generator, most_m: float) -> FloatArray:
    return rng.uniform(-most_m, most_m, 3)
