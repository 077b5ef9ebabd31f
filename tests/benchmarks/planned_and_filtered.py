"""Figure 6, its second part: guide, potential field and safety filter of one tick, in a flight of many ticks."""

from __future__ import annotations

import statistics
import time

import numpy as np
from measure import Figure, Scale
from numpy.typing import NDArray

from gcs.planner import fuzzy_escape, leader
from gcs.planner.guide import RouteFollower
from gcs.planner.potential_field import FieldConstants
from gcs.planner.route import Router
from skytender import geometry
from skytender.safety.safety_filter import FilterSettings, Leaders, Others, filter_step

COUNT, SIDE_M = 1000, 100.0
SPEED_M_S, PERIOD_S, SEPARATION_M, CLEARANCE_M, ACCELERATION_M_S2 = 3.0, 0.1, 0.6, 0.3, 4.0
TICKS, WARM_TICKS, FLIGHTS = 200, 3, 3
FIELD = FieldConstants(k0=15.0, k1=2.0, a=0.5, b=0.5, attraction_range_m=1.0, repulsion_range_m=1.0, step_m=0.1)

Floats = NDArray[np.float64]


def figures(scale: Scale) -> list[Figure]:
    """1000 vehicles that cross a room among 1000 shapes, from the tick on in which none has a route yet."""
    flights = [_flight(np.random.default_rng(COUNT)) for _ in range(FLIGHTS)]
    # The same tick does the same work in each; what else the machine does then differs.
    spent = [min(tick) for tick in zip(*flights, strict=True)]
    goal = 30.0 / scale.cpu
    name = f"guide, planner and filter, {COUNT} vehicles among {COUNT} obstacles"
    return [
        Figure(6, name, statistics.median(spent), "CPU ms/tick", goal, True),
        Figure(6, "  the 99th of 100 ticks", sorted(spent)[round(0.99 * len(spent)) - 1], "CPU ms/tick", goal, True),
    ]


def _flight(rng: np.random.Generator) -> list[float]:
    """CPU milliseconds of each tick after the first."""
    table = _room(rng)
    starts, goals = _free(rng, table), _free(rng, table)
    starts = _apart(rng, table, starts)
    guide = RouteFollower(Router(table, 2.0 * (CLEARANCE_M + 0.1), floor_m=0.3))
    _ = guide._router.grid  # made once for a session
    p, v, memory = starts, np.zeros((COUNT, 3)), fuzzy_escape.new_memory(COUNT)
    ids, nobody = np.arange(COUNT), np.zeros((COUNT, COUNT), dtype=bool)
    settings = FilterSettings(PERIOD_S, SEPARATION_M, CLEARANCE_M)
    spent = []
    for tick in range(TICKS + WARM_TICKS):
        begun_s = time.process_time()
        aims = guide.aims(ids, p, goals).aim_ned
        _q, memory, wish = leader.advance(
            p, memory, aims, np.zeros((COUNT, 3)), repulsors=table, moving=p, radii_m=SEPARATION_M,
            ranges_m=np.full(COUNT, 0.5), owner=ids, exempt=nobody, field=FIELD, speed_m_s=SPEED_M_S,
            period_s=PERIOD_S, escape=True, obstacle_ranges_m=np.zeros(COUNT),
        )  # fmt: skip
        moved = filter_step(
            Leaders(ids, p, v, SPEED_M_S, ACCELERATION_M_S2, 0.1), wish, rules=settings, others=Others(),
            obstacles=table,
        )  # fmt: skip
        p, v = moved.p_next_ned, moved.v_next_ned
        if tick >= WARM_TICKS:
            spent.append(1e3 * (time.process_time() - begun_s))
    return spent


def _room(rng: np.random.Generator) -> Floats:
    """Spheres, boxes and columns on a ground of 100 x 100 m."""
    rows = []
    for _ in range(COUNT):
        at, kind = rng.uniform([0.0, 0.0, -12.0], [SIDE_M, SIDE_M, -0.5]), int(rng.integers(3))
        if kind == 0:
            rows.append(geometry.sphere(at, rng.uniform(0.3, 1.2)))
        elif kind == 1:
            rows.append(geometry.box(at - 1.0, at + 1.0))
        else:
            rows.append(geometry.cylinder([at[0], at[1], -4.0], rng.uniform(0.2, 0.8), 8.0))
    return geometry.table(rows)


def _free(rng: np.random.Generator, table: Floats) -> Floats:
    """Places that are clear of all shapes."""
    places: list[Floats] = []
    while sum(map(len, places)) < COUNT:
        tried = rng.uniform([0.0, 0.0, -12.0], [SIDE_M, SIDE_M, -1.0], (COUNT, 3))
        places.append(tried[geometry.clearance(table, tried) > 0.9])
    return np.vstack(places)[:COUNT]


def _apart(rng: np.random.Generator, table: Floats, places: Floats) -> Floats:
    """The places, those too near to another one exchanged for new ones."""
    while True:
        gaps = np.linalg.norm(places[:, None] - places[None], axis=2)
        np.fill_diagonal(gaps, np.inf)
        near = np.flatnonzero(np.triu(gaps < 1.2).any(axis=1))
        if not len(near):
            return places
        places[near] = _free(rng, table)[: len(near)]
