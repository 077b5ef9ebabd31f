"""Values drawn for one session of a campaign: each key has a stream of its own, from campaign seed, session and key.

A value therefore depends on nothing else: not on other keys, combinations, workers or the order of sessions.
"""

from __future__ import annotations

import zlib
from statistics import NormalDist
from typing import Any

import numpy as np

from gcs.campaign.families.parts import rounded_m
from gcs.campaign.model import Draw, RandomObstacles
from gcs.scenario.model import Obstacle, Scenario
from skytender import elementary, geometry

TRIES = 2000
"""Places that are tried for each obstacle before it is left out."""


def seed_of(campaign_seed: int, session: int) -> int:
    """The seed of a session, 0 to 2^32 - 1."""
    return int(np.random.SeedSequence(campaign_seed, spawn_key=(session,)).generate_state(1)[0])


def stream(campaign_seed: int, session: int, key: str) -> np.random.Generator:
    """The random numbers of one key in one session."""
    spawned = np.random.SeedSequence(campaign_seed, spawn_key=(session, zlib.crc32(key.encode())))
    return np.random.default_rng(spawned)


def value(draw: Draw, rng: np.random.Generator) -> Any:
    """One value; plain data as a scenario file has it."""
    if draw.choice is not None:
        return draw.choice[int(rng.integers(len(draw.choice)))]
    if draw.integers is not None:
        return int(rng.integers(draw.integers[0], draw.integers[1] + 1))
    return scaled(draw, float(rng.random()))


def scaled(draw: Draw, u: float) -> Any:
    """The value at a share `u` of a draw's distribution, 0 to 1."""
    if draw.choice is not None:
        return draw.choice[min(int(u * len(draw.choice)), len(draw.choice) - 1)]
    if draw.integers is not None:
        low, high = draw.integers
        return min(low + int(u * (high - low + 1)), high)
    if draw.normal is not None:
        x = draw.normal[0] + draw.normal[1] * NormalDist().inv_cdf(min(max(u, 1e-9), 1.0 - 1e-9))
        return x if draw.clip is None else min(max(x, draw.clip[0]), draw.clip[1])
    if draw.log_uniform is not None:
        ln_low, ln_high = map(elementary.log, draw.log_uniform)
        return elementary.exp(ln_low + (ln_high - ln_low) * u)
    assert draw.uniform is not None
    return draw.uniform[0] + (draw.uniform[1] - draw.uniform[0]) * u


def obstacles(wanted: RandomObstacles, rng: np.random.Generator, scenario: Scenario, *, paper: bool) -> list[Obstacle]:
    """Random obstacles in NED that keep clear of where a scenario needs room; fewer where there is none.

    paper: the corners of `within_m` are in paper axes.
    """
    corners = np.array(wanted.within_m, dtype=np.float64)
    if paper:
        corners *= [1.0, -1.0, -1.0]
    low, high = corners.min(axis=0), corners.max(axis=0)
    free = np.array(_needed(scenario))
    placed: list[Obstacle] = []
    count = int(rng.integers(wanted.count[0], wanted.count[1] + 1))
    for _ in range(TRIES * count):
        if len(placed) == count:
            break
        made = _shape(rng, wanted.kinds[int(rng.integers(len(wanted.kinds)))], rng.uniform(low, high))
        if not len(free) or geometry.clearance(geometry.of_scenario([made]), free).min() >= wanted.apart_m:
            placed.append(made)
    return placed


def _shape(rng: np.random.Generator, kind: str, at: np.ndarray[Any, Any]) -> Obstacle:
    """One obstacle of a kind round a place; its numbers are whole millimetres."""
    place = rounded_m(at)
    keys: dict[str, Any] = {}
    if kind == "point":
        keys = {"point_m": place}
    elif kind == "sphere":
        keys = {"sphere_m": place, "radius_m": round(float(rng.uniform(0.2, 1.2)), 3)}
    elif kind == "box":
        half, top_m = rng.uniform(0.2, 1.5, 2), float(rng.uniform(2.0, 7.0))
        keys = {"box_m": [rounded_m([*(at[:2] - half), -top_m]), rounded_m([*(at[:2] + half), 0.0])]}
    else:
        radius_m, top_m = round(float(rng.uniform(0.15, 0.8)), 3), round(float(rng.uniform(2.0, 7.0)), 3)
        keys = {"cylinder_m": place[:2], "radius_m": radius_m, "bottom_m": 0.0, "top_m": -top_m}
    return Obstacle.model_validate(keys)


def _needed(scenario: Scenario) -> list[tuple[float, float, float]]:
    """Places in NED that must stay free: starts and the way up, way points, paths, homes, bases."""
    found: list[tuple[float, float, float]] = []
    for vehicle in scenario.vehicles.launched:
        n, e, d = vehicle.start_m
        found += [(n, e, d - float(up)) for up in np.linspace(0.0, 0.0 if vehicle.airborne else vehicle.takeoff_m, 4)]
    for pursuer in scenario.vehicles.pursuers:
        found += pursuer.waypoints_m
    for target in scenario.vehicles.targets:
        path = [*target.path_m, target.path_m[0]] if target.closed else list(target.path_m)
        for a, b in zip(path, path[1:] or path, strict=False):
            found += [tuple(map(float, p)) for p in np.linspace(a, b, 12)]  # type: ignore[misc]
    for tanker in scenario.vehicles.tankers:
        found += [] if tanker.home_m is None else [tanker.home_m]
    for base in scenario.bases:
        found += [base.position_m, base.above_m]
    return found
