"""The 300 instances, and as many others for tuning: drawn by seed alone, the same on every machine.

Three kinds of 100: `tankers` have nothing else; in `reloads` tankers carry half of what is needed and fetch the rest at
bases; in `bases` receivers may go to bases as well. Within a kind receivers grow from 4 to 40 and, independently of
that, tightness from 0 to 1: the load of tankers from 0.4 to 1.1, stocks from 1.6 times what is needed to 1.05 times
[choice]. Of the arithmetic, only sums, products, quotients and square roots are used, and Python's own generator.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator

from gcs.benchmark.format import INSTANCE, BenchmarkBase, BenchmarkReceiver, BenchmarkTanker, Corner, Instance, Vec3

KINDS = ("tankers", "reloads", "bases")
OF_A_KIND = 100
FEWEST, MOST, MOST_TANKERS, MOST_BASES = 4, 40, 8, 3
TUNING_SEED = 100_000
"""Added to the seeds of the 300."""
SETUP_S = 6.0
"""Of a service beside the way and the flow of energy, as flown sessions need it."""
FULL, LANDS_AT = 0.9, 0.05
"""Shares of the capacity: up to where services are counted, and at which a receiver lands."""
APART_M = 9.0
"""Of the field: a square with so much room for each receiver and half of it on every side."""


def instances(tuning: bool = False) -> Iterator[Instance]:
    """All, in order."""
    for kind in KINDS:
        for number in range(OF_A_KIND):
            yield instance(kind, number, tuning)


def instance(kind: str, number: int, tuning: bool = False) -> Instance:
    """Number 0 to 99 of a kind: of the 300, or of those on which parameters may be chosen."""
    seed = 1000 * (KINDS.index(kind) + 1) + number + (TUNING_SEED if tuning else 0)
    draw = random.Random(seed)
    count = FEWEST + (MOST - FEWEST) * number // (OF_A_KIND - 1)
    tightness = (number * 37 % OF_A_KIND) / (OF_A_KIND - 1)
    horizon_s, speed_m_s = float(draw.randrange(90, 211, 10)), _rounded(draw.uniform(0.5, 1.5))
    half_m = 0.5 * APART_M * math.sqrt(count)
    receivers = [_receiver(draw, i + 1, horizon_s, speed_m_s, half_m) for i in range(count)]
    needed = [_needed_j(one, horizon_s) for one in receivers]
    services = sum(math.ceil(j / (0.7 * one.capacity_j)) for j, one in zip(needed, receivers, strict=True))
    load, spare = 0.4 + 0.7 * tightness, 1.6 - 0.55 * tightness
    flown_s = SETUP_S + 0.5 * half_m / 4.5
    tankers = min(max(round(count / 4.5 + draw.uniform(-0.5, 1.0)), 1), MOST_TANKERS)
    flows_s = max(load * tankers * horizon_s - services * flown_s, 0.1 * tankers * horizon_s)
    rate_w = min(max(_rounded(sum(needed) / flows_s), 400.0), 6000.0)
    carried = {"tankers": 1.0, "reloads": 0.5, "bases": 0.7}[kind] * spare * sum(needed) / tankers
    bases = 0 if kind == "tankers" else draw.randint(1, MOST_BASES)
    fast_w, stock_j = 2.0 * rate_w, float(round(0.6 * spare * sum(needed) / max(bases, 1)))
    name = f"{'tuning-' if tuning else ''}{kind}-{number:03}"
    return Instance(
        INSTANCE, name, kind, round(tightness, 3), seed, horizon_s, SETUP_S, rate_w, receivers,
        [_tanker(draw, 201 + k, horizon_s, half_m, carried) for k in range(tankers)],
        [
            BenchmarkBase(f"base-{k + 1}", _place(draw, half_m, 0.0, 0.0), stock_j, fast_w)
            for k in range(bases)
        ],
    )  # fmt: skip


def _receiver(draw: random.Random, number: int, horizon_s: float, speed_m_s: float, half_m: float) -> BenchmarkReceiver:
    """One that flies from place to place, with a charge of its own."""
    capacity_j, power_w = float(draw.randrange(14_000, 30_001, 100)), _rounded(draw.uniform(190.0, 230.0))
    here, t_s = _place(draw, half_m, -12.0, -4.0), 0.0
    path: list[Corner] = [(0.0, *here)]
    while t_s < horizon_s:
        there = _place(draw, half_m, -12.0, -4.0)
        way_m = math.sqrt(sum((b - a) * (b - a) for a, b in zip(here, there, strict=True)))
        t_s = round(t_s + way_m / speed_m_s, 3)
        path.append((t_s, *there))
        here = there
    energy_j = float(round(draw.uniform(0.28, 0.85) * capacity_j))
    return BenchmarkReceiver(number, path, 3.0, capacity_j, energy_j, power_w, LANDS_AT * capacity_j)


def _tanker(draw: random.Random, number: int, horizon_s: float, half_m: float, carried_j: float) -> BenchmarkTanker:
    power_w, reserve_j = _rounded(draw.uniform(190.0, 260.0)), float(draw.randrange(5_000, 15_001, 500))
    energy_j = float(round(reserve_j + power_w * horizon_s + carried_j * draw.uniform(0.8, 1.2)))
    at = _place(draw, half_m, -16.0, -14.0)
    return BenchmarkTanker(number, at, _rounded(draw.uniform(3.0, 6.0)), energy_j, energy_j, power_w, reserve_j)


def _needed_j(one: BenchmarkReceiver, horizon_s: float) -> float:
    """Energy that a receiver lacks to fly to the horizon, J."""
    return max(one.power_w * horizon_s + one.lands_at_j - one.energy_j, 0.0)


def _place(draw: random.Random, half_m: float, highest_down_m: float, lowest_down_m: float) -> Vec3:
    n, e, d = draw.uniform(-half_m, half_m), draw.uniform(-half_m, half_m), draw.uniform(highest_down_m, lowest_down_m)
    return (_rounded(n), _rounded(e), _rounded(d))


def _rounded(number: float) -> float:
    return round(number, 2)
