"""At least how many receivers every schedule of an instance loses: by windows of time and by prices, whichever is more.

The bound by prices stands in gcs/benchmark/prices.py. That by windows is a relaxation, which CP-SAT solves to its
optimum. A receiver that is kept until b has got, between a and b, at least what it draws until b less what it can have
had at a, X. That takes givers' time between a and b, of which there is no more than (b - a) for each. The relaxation
keeps as many receivers as fit into every such window [a, b] at once. It loses no more than any schedule that the
verifier accepts:

- Let a visit be all of a giver's consecutive services of one receiver. In q visits that take s seconds beside their
  setup, a receiver gets at most rate · s, and at most q times what it holds and what it draws meanwhile. So
  s >= max(X / rate, (X - q · holds) / power), however slowly the energy flows and however many services there are.
- All visits that give energy between 0 and b begin after 0, each with its setup and the way to the receiver from
  another receiver, a tanker's start or a base: the least such way to it until b. Of those in a later window, the first
  may have begun before it, and the others' ways may lie before it; their setups do not, as a receiver is with one giver
  at a time.
- At a base a receiver gets the base's rate and does not draw, and needs no giver's way; a base's time counts as a
  tanker's. It may stay there, so the visits' number is no limit where there are bases.
- All that tankers and bases hold, and what vehicles do not draw at bases, is at least what the receivers that are kept
  need in all.
- Receivers that are lost need nothing. That they may be served until then only takes time from the others.

Ways are the least over samples of both paths, less what they can be shorter between samples. X is rounded down and the
windows up, by more than the verifier's tolerance allows over 1,000 services.
"""

from __future__ import annotations

import math
import time

import numpy as np

from gcs.benchmark import prices
from gcs.benchmark.arrays import Arrays, Floats
from gcs.extras import require

WINDOW_S = 4.0
SAMPLE_S = 1.0
MOST_VISITS = 40
SLACK_S = 0.1
"""More than a meeting is put later by, and what samples cut off a path's corners, over a tanker's speed."""
SLACK_J = 5.0
UNIT_S = 1e-3
"""The solver's numbers are integers."""
MOST_WORK = 1.0
"""[choice] In CP-SAT's deterministic time, which is no matter of a machine's load."""


def least_lost(arrays: Arrays, enough: int, seconds: float) -> int:
    """At least so many are lost. What is tried ends where `enough` are, or after about so many seconds of processor
    time. Raises MissingExtra."""
    require("a proven bound", {"ortools": "OR-Tools", "scipy": "SciPy"}, "benchmark")
    until_s = time.process_time() + seconds
    ways_s, first_s = _least_ways_s(arrays)
    lost, most_j = _by_windows(arrays, ways_s, first_s), _most_j(arrays)
    if lost < enough and most_j >= 0:  # with less, tankers do not last to the horizon whatever is done
        needs_j = np.maximum(_least_j(arrays, arrays.horizon_s), 0.0)
        lost = max(lost, prices.least_lost(arrays, ways_s, first_s, needs_j, most_j, enough, until_s))
    return lost


def _by_windows(arrays: Arrays, ways_s: Floats, first_s: Floats) -> int:
    from ortools.sat.python import cp_model  # noqa: PLC0415 - an extra

    model = cp_model.CpModel()
    keeps = [model.NewBoolVar("") for _ in range(arrays.n)]
    for work_s, most_s in _windows(arrays, ways_s, first_s):
        whole = [math.floor(one / UNIT_S) for one in work_s]
        if sum(whole) > (most := math.ceil((most_s + SLACK_S) / UNIT_S)):
            model.Add(sum(one * keep for one, keep in zip(whole, keeps, strict=True)) <= most)
    needs_j = np.maximum(_least_j(arrays, arrays.horizon_s), 0.0)
    model.Add(sum(math.floor(one) * keep for one, keep in zip(needs_j, keeps, strict=True)) <= _most_j(arrays))
    model.Maximize(sum(keeps))
    solver = cp_model.CpSolver()
    solver.parameters.max_deterministic_time = MOST_WORK
    solver.parameters.num_workers = 1
    solver.Solve(model)
    if solver.StatusName() not in ("OPTIMAL", "FEASIBLE"):
        return 0  # the solver's bound is none before it has a solution
    return arrays.n - math.floor(solver.BestObjectiveBound() + 1e-6)


def _least_j(arrays: Arrays, until_s: float) -> Floats:
    """(n,) what each must have got by then, if it still flies."""
    return np.asarray(arrays.power_w * (until_s - arrays.lands_s) - SLACK_J)


def _most_j(arrays: Arrays) -> int:
    """All that givers hold, and what is not drawn at bases."""
    saved_w = float(arrays.tanker_power_w.sum() + arrays.k * arrays.power_w.max()) if arrays.k else 0.0
    return math.ceil(arrays.spare_j.sum() + arrays.stock_j.sum() + saved_w * arrays.horizon_s + SLACK_J)


def _windows(arrays: Arrays, ways_s: Floats, first_s: Floats) -> list[tuple[Floats, float]]:
    """The giver's time (n,) that each receiver needs in a window, and how much there is."""
    found = []
    times = np.arange(WINDOW_S, arrays.horizon_s + 1e-9, WINDOW_S)
    givers = arrays.m + arrays.k
    fastest_w = max([arrays.rate_w, *arrays.base_rate_w]) + (arrays.power_w if arrays.k else 0.0)
    for until_s in (*times, arrays.horizon_s):
        way_s = ways_s[:, : math.ceil(until_s / SAMPLE_S) + 1].min(axis=1)
        for from_s in (0.0, *times[times < until_s]):
            had_j = np.minimum(
                arrays.capacity_j - arrays.energy_j + arrays.power_w * from_s,
                fastest_w * np.maximum(from_s - first_s - arrays.setup_s, 0.0),
            )
            needs_j = _least_j(arrays, until_s) - np.where(from_s > 0.0, had_j + SLACK_J, 0.0)
            visits = np.arange(1.0, MOST_VISITS)[:, None]
            if arrays.k:
                work_s = needs_j / fastest_w
            else:
                begun = visits if from_s == 0.0 else visits - 1.0
                each_s = arrays.setup_s + (way_s if from_s == 0.0 else 0.0)
                flows_s = np.maximum(needs_j / arrays.rate_w, (needs_j - visits * arrays.holds_j) / arrays.power_w)
                work_s = (begun * each_s + flows_s).min(axis=0)
            work_s = np.where(needs_j > 0.0, work_s, 0.0)
            found.append((work_s, givers * (until_s - from_s)))
    return found


def _least_ways_s(arrays: Arrays) -> tuple[Floats, Floats]:
    """(n, samples) the least way to each receiver that ends by about then, and (n,) when it is with a tanker or at a
    base at the soonest."""
    n, speed_m_s = arrays.n, float(arrays.speed_m_s.max(initial=0.0))
    times = np.arange(0.0, arrays.horizon_s + 2.0 * SAMPLE_S, SAMPLE_S)
    each = np.arange(n)
    meets_s = [arrays.meets_s(each, np.zeros(n), p, v) for p, v in zip(arrays.start_ned, arrays.speed_m_s, strict=True)]
    shorter_m = SAMPLE_S * arrays.fastest_m_s
    for base_ned in arrays.base_ned:
        away_m = np.sqrt(np.square(arrays.at(each[:, None], times) - base_ned).sum(axis=2))
        way_s = np.maximum(away_m - shorter_m, 0.0) / arrays.off_path_m_s[:, None]
        meets_s.append((times + way_s).min(axis=1))
    first_s = np.min(meets_s, axis=0)
    ways_s = np.full((n, len(times)), np.inf)
    for i in range(n):  # from where a receiver is within a sample's time, to the others as they come
        here = arrays.at(np.full(len(times), i), times)
        for j in range(n):
            if i != j:
                ways_s[j] = np.minimum(ways_s[j], _reaches_s(arrays, here, j, times, speed_m_s, shorter_m))
    for t in range(arrays.m):
        there = arrays.at(each[:, None], times)
        away_m = np.sqrt(np.square(there - arrays.start_ned[t]).sum(axis=2))
        ways_s = np.minimum(ways_s, np.maximum(away_m - shorter_m, 0.0) / speed_m_s)
    return ways_s, np.maximum(first_s - SLACK_S, 0.0)


def _reaches_s(
    arrays: Arrays, here: Floats, receiver: int, times: Floats, speed_m_s: float, shorter_m: float
) -> Floats:
    """(samples,) by the time of departure; a departure within half a sample of it, and a meeting, differ by less."""
    if speed_m_s <= arrays.fastest_m_s:
        return np.zeros(len(times))
    met_s = arrays.meets_s(np.full(len(times), receiver), times, here, speed_m_s) - times
    return np.asarray(np.maximum(met_s - SLACK_S - shorter_m / (speed_m_s - arrays.fastest_m_s), 0.0))
