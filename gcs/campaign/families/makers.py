"""Scenario families: random scenarios of one kind each, as documents that `gcs` loads from YAML.

`family(name, seed)` draws from `numpy.random.SeedSequence` of the name and the seed alone, so that a document depends
on nothing else. Every scenario allows what is wanted of it: no start and no last way point lies nearer than the
separation and `MARGIN_M` to another's, nor nearer than `OBSTACLE_M` to an obstacle, nor does the way up to fly.
Rings have room for their vehicles, gaps are wide enough for one. Lengths in metres, NED.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable

import numpy as np

from gcs.campaign.families import parts
from gcs.campaign.families.accuracy import accuracy
from gcs.campaign.families.dense import big_circle, cube, forest, streets
from gcs.campaign.families.silence import silence
from gcs.campaign.families.silent_ways import SILENT_FROM_S, clearance_over, floats_over
from gcs.campaign.families.tight import tight, tight_gusts
from gcs.campaign.families.turning import silent_traffic, turning
from skytender import elementary, elementwise
from skytender import geometry as shapes

FIRST_SERVED_S, SERVICE_S = 20.0, 13.0
"""[choice] Until a tanker gives its first joule, and from one receiver to the next: charges last so long."""
LANDS_AT, HOVERS_W = 0.05, 213.0
"""Share of the battery at which vehicles land, and what they draw."""


def family(name: str, seed: int) -> parts.Document:
    """The scenario of a family for a seed. ValueError unless the name is in `FAMILIES` and the seed is at least 0."""
    if name not in _MAKERS:
        raise ValueError(f"family is {name!r}; it must be one of {', '.join(FAMILIES)}")
    if seed < 0:
        raise ValueError(f"seed is {seed!r}; it must be at least 0")
    rng = np.random.default_rng(np.random.SeedSequence([seed, *name.encode()]))
    document = _MAKERS[name](rng)
    named = {"schema": 1, "name": f"{name}-{seed}", "axes": "ned", "seed": int(seed), "origin": dict(parts.ORIGIN)}
    return named | {"clock": {"mode": "lockstep", "period_s": 0.1}, "truth": True} | document


def _circles(rng: np.random.Generator) -> parts.Document:
    """4 to 24 vehicles on a circle, each to the place opposite; half of the circles regular, half not."""
    n, separation_m = int(rng.integers(4, 25)), parts.separation_of(rng)
    apart_m = separation_m + parts.MARGIN_M + float(rng.uniform(0.1, 0.5))
    radius_m = max(float(rng.uniform(4.0, 8.0)), apart_m / (2.0 * elementary.sin(math.pi / n)))
    angle = rng.uniform(0.0, 2 * math.pi) + 2 * math.pi * np.arange(n) / n
    if rng.random() < 0.5:
        spare = max(0.0, math.pi / n - elementary.asin(min(1.0, (separation_m + parts.MARGIN_M) / (2.0 * radius_m))))
        angle = angle + rng.uniform(-0.9, 0.9, n) * spare
    out = radius_m * np.column_stack([elementwise.cosines(angle), elementwise.sines(angle), np.zeros(n)])
    middle = np.array([0.0, 0.0, -5.0])
    return parts.to_way_points(
        rng, middle + out, middle - out, way_m=2.0 * radius_m, separation_m=separation_m, airborne=True
    )


def _head_on(rng: np.random.Generator) -> parts.Document:
    """Two rows of 1 to 6 that face each other and change places; half of them exactly face to face."""
    k, separation_m, way_m = int(rng.integers(1, 7)), parts.separation_of(rng), float(rng.uniform(10.0, 20.0))
    east = (np.arange(k) - (k - 1) / 2) * (separation_m + parts.MARGIN_M + rng.uniform(0.0, 0.8))
    shift = 0.0 if rng.random() < 0.5 else rng.uniform(-0.5, 0.5)
    one = np.column_stack([np.full(k, -way_m / 2), east, np.full(k, -5.0)])
    other = np.column_stack([np.full(k, way_m / 2), east + shift, np.full(k, -5.0)])
    aside = np.array([0.0, shift, 0.0])
    ends = np.vstack([other - aside, one + aside])
    return parts.to_way_points(
        rng, np.vstack([one, other]), ends, way_m=way_m, separation_m=separation_m, airborne=True
    )


def _crossings(rng: np.random.Generator) -> parts.Document:
    """Two columns of 1 to 5 that cross at 40 to 140 degrees."""
    k, separation_m, way_m = int(rng.integers(1, 6)), parts.separation_of(rng), float(rng.uniform(12.0, 20.0))
    apart_m = separation_m + parts.MARGIN_M + float(rng.uniform(0.1, 1.0))
    starts, ends = [], []
    for heading in (0.0, float(rng.uniform(math.radians(40), math.radians(140)))):
        ahead = np.array([elementary.cos(heading), elementary.sin(heading), 0.0])
        # Behind the crossing by more than the other column is wide, so that the starts of both lie apart.
        for i in range(k):
            starts.append(-ahead * (way_m / 2 + i * apart_m) + [0.0, 0.0, -5.0])
            ends.append(ahead * (way_m / 2 + (k - 1 - i) * apart_m) + [0.0, 0.0, -5.0])
    return parts.to_way_points(rng, starts, ends, way_m=way_m + k * apart_m, separation_m=separation_m, airborne=True)


def _row_in_pocket(rng: np.random.Generator, most: int, separation_m: float) -> parts.FloatArray:
    """1 to `most` places in a row along east about the origin, on the ground."""
    n = int(rng.integers(1, most + 1))
    east = (np.arange(n) - (n - 1) / 2) * (separation_m + parts.MARGIN_M + float(rng.uniform(0.2, 0.6)))
    return np.column_stack([np.zeros(n), east, np.zeros(n)])


def _walls(rng: np.random.Generator) -> parts.Document:
    """1 to 4 vehicles in the pocket of an L or a U, some with a closed ceiling, to places behind the wall."""
    separation_m, kind = parts.separation_of(rng), ("L", "U", "ceiling")[int(rng.integers(3))]
    starts = _row_in_pocket(rng, 4, separation_m)
    half_m = float(np.abs(starts[:, 1]).max() + rng.uniform(1.5, 4.0))
    far_m, thick_m, top_m = float(rng.uniform(3.0, 6.0)), float(rng.uniform(0.2, 0.6)), float(rng.uniform(5.0, 9.0))
    deep_m = float(rng.uniform(2.0, 8.0))  # how far the arms reach back behind the starts
    boxes = [parts.box_of([far_m, -half_m, -top_m], [far_m + thick_m, half_m, 0.0])]
    boxes.append(parts.box_of([-deep_m, half_m, -top_m], [far_m + thick_m, half_m + thick_m, 0.0]))
    if kind != "L":
        boxes.append(parts.box_of([-deep_m, -half_m - thick_m, -top_m], [far_m + thick_m, -half_m, 0.0]))
    if kind == "ceiling":
        roof = ([-deep_m, -half_m - thick_m, -top_m - thick_m], [far_m + thick_m, half_m + thick_m, -top_m])
        boxes.append(parts.box_of(*roof))
    ends = starts + np.array([far_m + thick_m + float(rng.uniform(2.0, 5.0)), 0.0, -parts.TAKEOFF_M])
    way_m = 2.0 * (deep_m + half_m + far_m) if kind != "L" else 2.0 * half_m + far_m + 6.0
    return parts.to_way_points(
        rng, starts, ends, way_m=way_m, separation_m=separation_m, airborne=False, obstacles=boxes
    )


def _gaps(rng: np.random.Generator) -> parts.Document:
    """1 to 5 vehicles from one closed room to another through a gap of 1.5 to 3 separations."""
    separation_m = parts.separation_of(rng)
    gap_m, starts = separation_m * float(rng.uniform(1.5, 3.0)), _row_in_pocket(rng, 5, separation_m)
    wide_m = float(np.abs(starts[:, 1]).max() + rng.uniform(2.0, 4.0))
    wall_m, thick_m, top_m = float(rng.uniform(3.0, 5.0)), float(rng.uniform(0.2, 0.5)), float(rng.uniform(4.0, 6.0))
    near_m, end_m = -2.5, 2.0 * wall_m + thick_m + 2.5
    at_m = float(rng.uniform(-1.0, 1.0)) * (wide_m - gap_m / 2 - 0.5)
    left, right = at_m - gap_m / 2, at_m + gap_m / 2
    out = thick_m
    boxes = [
        parts.box_of([wall_m, -wide_m, -top_m], [wall_m + thick_m, left, 0.0]),
        parts.box_of([wall_m, right, -top_m], [wall_m + thick_m, wide_m, 0.0]),
        parts.box_of([near_m - out, -wide_m, -top_m], [near_m, wide_m, 0.0]),
        parts.box_of([end_m, -wide_m, -top_m], [end_m + out, wide_m, 0.0]),
        parts.box_of([near_m - out, -wide_m - out, -top_m], [end_m + out, -wide_m, 0.0]),
        parts.box_of([near_m - out, wide_m, -top_m], [end_m + out, wide_m + out, 0.0]),
        parts.box_of([near_m - out, -wide_m - out, -top_m - out], [end_m + out, wide_m + out, -top_m]),
    ]
    ends = starts + np.array([2.0 * wall_m + thick_m, 0.0, -parts.TAKEOFF_M])
    way_m = 2.0 * elementary.hypot(wall_m, wide_m) + 2.0 * len(starts)
    return parts.to_way_points(
        rng, starts, ends, way_m=way_m, separation_m=separation_m, airborne=False, obstacles=boxes
    )


def _tracked(
    rng: np.random.Generator,
    *,
    most: int,
    obstacles: tuple[int, int],
    share: tuple[float, float],
    turn_rad: tuple[float, float],
) -> parts.Document:
    """3 to `most` pursuers on a ring about a target that flies legs with turns between `turn_rad`, either way."""
    n, separation_m, cruise = int(rng.integers(3, most + 1)), parts.separation_of(rng), parts.speed_of(rng)
    apart_m = separation_m + parts.MARGIN_M + 0.2
    ring_m = max(float(rng.uniform(1.5, 3.0)), apart_m / (2.0 * elementary.sin(math.pi / n)), apart_m)
    speed = round(cruise * float(rng.uniform(*share)), 2)
    duration_s = float(rng.integers(35, 51))
    heading, path = rng.uniform(0.0, 2 * math.pi), [np.array([0.0, 0.0, -3.0])]
    way_m, fly_m = 0.0, min(speed * duration_s, 90.0)
    while way_m < fly_m:
        leg_m = float(rng.uniform(4.0, 10.0))
        ahead = np.array([leg_m * elementary.cos(heading), leg_m * elementary.sin(heading), 0.0])
        path.append(path[-1] + ahead)
        path[-1][2] = rng.uniform(-5.0, -2.5)
        heading += float(rng.choice([-1.0, 1.0])) * float(rng.uniform(*turn_rad))
        way_m += leg_m
    starts = parts.ring_places(rng, np.zeros(3), n, ring_m)
    airborne = bool(rng.random() < 0.5)
    if airborne:
        starts[:, 2] = -3.0
    start = np.array([0.0, 0.0, -3.0 if airborne else 0.0])
    along = np.vstack([a + (b - a) * np.linspace(0.0, 1.0, 25)[:, None] for a, b in itertools.pairwise(path)])
    up = np.array([0.0, 0.0, 0.0] if airborne else [0.0, -parts.TAKEOFF_M / 2, -parts.TAKEOFF_M])
    columns = np.vstack([np.vstack([starts, start]) + np.array([0.0, 0.0, h]) for h in up])
    keep = np.vstack([along, columns])
    keep_m = np.concatenate([np.full(len(along), 1.3), np.full(len(columns), parts.OBSTACLE_M + 0.9)])
    placed = parts.random_shapes(rng, int(rng.integers(*obstacles)), keep, keep_m, ring_m)
    target = {
        "sysid": 101,
        "start_m": parts.rounded_m(start),
        "airborne": airborne,
        "path_m": [parts.rounded_m(p) for p in path],
        "speed_m_s": speed,
    }
    pursuers = [{"sysid": i + 1, "start_m": parts.rounded_m(p), "airborne": airborne} for i, p in enumerate(starts)]
    return {
        "goal": {"duration_s": duration_s, "pursue": {"within_m": round(ring_m + 1.5, 2), "for_s": 5.0}},
        "vehicles": {"defaults": {"battery": dict(parts.BATTERY)}, "pursuers": pursuers, "targets": [target]},
        "obstacles": placed,
        "planner": {"cruise_m_s": cruise, "separation_m": separation_m},
        "formation": {"ring_m": round(ring_m, 3)},
        "refuelling": {"enabled": False},
    }


def _tracking(rng: np.random.Generator) -> parts.Document:
    """A ring about a moving target among 3 to 20 obstacles."""
    return _tracked(rng, most=12, obstacles=(3, 21), share=(0.3, 0.7), turn_rad=(0.0, 1.2))


def _fast_targets(rng: np.random.Generator) -> parts.Document:
    """A ring about a target nearly as fast as its pursuers that turns by 90 to 180 degrees."""
    return _tracked(rng, most=8, obstacles=(0, 4), share=(0.7, 0.95), turn_rad=(math.pi / 2, math.pi))


def _tankers(rng: np.random.Generator) -> parts.Document:
    """A ring of 3 to 6, low in charge, about a slow target, refuelled by 1 to 3 tankers among some obstacles."""
    document = _tracked(rng, most=6, obstacles=(0, 6), share=(0.2, 0.4), turn_rad=(0.0, 0.8))
    cruise, separation_m = document["planner"]["cruise_m_s"], document["planner"]["separation_m"]
    airborne = document["vehicles"]["targets"][0]["airborne"]
    for pursuer in document["vehicles"]["pursuers"]:
        charge = round(float(rng.uniform(35.0, 90.0)), 1)
        pursuer["battery"] = {**parts.BATTERY, "capacity_j": 24000.0, "initial_percent": charge}
    low = min(document["vehicles"]["pursuers"], key=lambda p: p["battery"]["initial_percent"])
    low["battery"]["initial_percent"] = round(float(rng.uniform(35.0, 48.0)), 1)
    table, ring_m = parts.table_of(document), document["formation"]["ring_m"]
    tankers: list[parts.Document] = []
    for _ in range(parts.TRIES):
        if len(tankers) == int(document["goal"]["duration_s"]) % 3 + 1:
            break
        angle, out = rng.uniform(0.0, 2 * math.pi), ring_m + rng.uniform(2.0, 5.0)
        home = np.array([out * elementary.cos(angle), out * elementary.sin(angle), -rng.uniform(6.5, 8.0)])
        column = home * [1.0, 1.0, 0.0] + np.linspace(0.0, 1.0, 12)[:, None] * [0.0, 0.0, home[2]]
        apart = [elementary.distance(home[:2], other["home_m"][:2]) for other in tankers]
        if (
            shapes.clearance(table, column).min() < parts.OBSTACLE_M + 0.5
            or min(apart, default=math.inf) < separation_m + 1.5
        ):
            continue
        start = home if airborne else home * [1.0, 1.0, 0.0]
        tanker = {
            "sysid": 201 + len(tankers),
            "start_m": parts.rounded_m(start),
            "airborne": airborne,
            "home_m": parts.rounded_m(home),
        }
        tankers.append(tanker | {"speed_m_s": cruise, "battery": {**parts.BATTERY, "capacity_j": 150000.0}})
    document["vehicles"]["tankers"] = tankers
    batteries = [pursuer["battery"] for pursuer in document["vehicles"]["pursuers"]]
    for k, battery in enumerate(sorted(batteries, key=lambda battery: battery["initial_percent"])):
        served_s = FIRST_SERVED_S + SERVICE_S * (k // max(len(tankers), 1))
        least = round(100.0 * (LANDS_AT + HOVERS_W * served_s / battery["capacity_j"]), 1)
        battery["initial_percent"] = max(battery["initial_percent"], least)
    document["goal"] |= {"duration_s": parts.LONGEST_S, "refuelled_at_least": 1}
    document["refuelling"] = {"enabled": True}
    return document


def _traffic(rng: np.random.Generator) -> parts.Document:
    """2 to 6 vehicles hover at way points while 1 to 3 aircraft that give no way pass through those places."""
    n, separation_m = int(rng.integers(2, 7)), parts.separation_of(rng)
    starts = parts.ring_places(rng, np.array([0.0, 0.0, -5.0]), n, max(2.5, n * (separation_m + 1.0) / (2 * math.pi)))
    document = parts.to_way_points(rng, starts, starts, way_m=10.0, separation_m=separation_m, airborne=True)
    movers = []
    for i in range(int(rng.integers(1, 4))):
        through, heading = starts[int(rng.integers(n))], rng.uniform(0.0, 2 * math.pi)
        speed = parts.speed_of(rng)
        ahead = np.array([elementary.cos(heading), elementary.sin(heading), 0.0])
        # It comes through 8 s after its start, when the one before it is gone, and turns round after the end.
        path = [parts.rounded_m(through - ahead * 8.0 * speed), parts.rounded_m(through + ahead * 40.0 * speed)]
        movers.append({"callsign": f"PASS{i + 1}", "path_m": path, "speed_m_s": speed, "start_s": 12.0 * i})
    document["traffic"] = movers
    document["goal"]["duration_s"] = 12.0 * len(movers) + 10.0
    return document


def _any_of(rng: np.random.Generator) -> parts.Document:
    """A family that others change: circles, head-on rows, crossings or a ring among obstacles."""
    makers = (_circles, _head_on, _crossings, _tracking)
    return makers[int(rng.integers(len(makers)))](rng)


def _loss(rng: np.random.Generator) -> parts.Document:
    """Circles, rows, crossings or a ring with 30 % of all frames lost each way."""
    return _any_of(rng) | {"radio": {"loss": 0.3}}


def _delay(rng: np.random.Generator) -> parts.Document:
    """The same with 0.5 s of delay each way, and more time, since reports are a second old."""
    document = _any_of(rng) | {"radio": {"delay_s": 0.5}}
    document["goal"]["duration_s"] = 2.0 * parts.LONGEST_S if "pursue" in document["goal"] else parts.LONGEST_S
    return document


def _blackout(rng: np.random.Generator) -> parts.Document:
    """A ring among obstacles, one vehicle of which loses its link, both ways, for 30 s. Alone with its failsafe it
    climbs, flies home above everything and lands, which the station cannot prevent: nothing floats over where it may
    begin to climb, and its way down home is clear."""
    clear: list[int] = []
    for _ in range(parts.TRIES):
        document = _tracking(rng)
        table = parts.table_of(document)
        clear = [
            pursuer["sysid"]
            for pursuer in document["vehicles"]["pursuers"]
            if clearance_over(table, pursuer["start_m"][:2], 0.0) >= parts.OBSTACLE_M
            and not floats_over(table, document, pursuer)
        ]
        if clear:
            break
    silent = clear[int(rng.integers(len(clear)))]
    document["goal"]["duration_s"] = parts.LONGEST_S
    return document | {"radio": {"blackouts": [{"sysid": silent, "from_s": SILENT_FROM_S, "to_s": 45.0}]}}


def _poor_tracking(rng: np.random.Generator) -> parts.Document:
    """Circles, rows, crossings or a ring with vehicles that brake and tilt less and follow their set points late."""
    document = _any_of(rng)
    document["vehicles"]["defaults"]["params"] = {
        "MPC_ACC_HOR": round(float(rng.uniform(2.0, 4.0)), 2),
        "MPC_TILTMAX_AIR": round(float(rng.uniform(15.0, 25.0)), 1),
        "SIM_GAIN_SPEED": round(float(rng.uniform(1.0, 2.0)), 2),
    }
    return document


_MAKERS: dict[str, Callable[[np.random.Generator], parts.Document]] = {
    "tracking": _tracking,
    "circles": _circles,
    "head_on": _head_on,
    "crossings": _crossings,
    "walls": _walls,
    "gaps": _gaps,
    "fast_targets": _fast_targets,
    "tankers": _tankers,
    "traffic": _traffic,
    "loss": _loss,
    "delay": _delay,
    "blackout": _blackout,
    "poor_tracking": _poor_tracking,
    "tight": tight,
    "tight_gusts": tight_gusts,
    "silence": silence,
    "accuracy": accuracy,
    "turning": turning,
    "silent_traffic": silent_traffic,
    "cube": cube,
    "forest": forest,
    "streets": streets,
    "big_circle": big_circle,
}
FAMILIES = tuple(_MAKERS)
"""Names that `family` knows."""
