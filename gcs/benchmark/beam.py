"""Schedules of an instance by beam search: services are added in the order of time, and the best beginnings kept.

The giver that is free first does one of what it may do (gcs/benchmark/moves.py), or waits. Beginnings are compared at
equal times, by what is lost so far and what is likely to be.
"""

from __future__ import annotations

import math
import time

import numpy as np

from gcs.benchmark.arrays import Arrays, Floats, Ints, net_w
from gcs.benchmark.format import SCHEDULE, Schedule, ScheduledService
from gcs.benchmark.moves import NONE, Beginnings, Moves, Weights, grown_by, lands, moves_of
from skytender import elementwise

PORTFOLIO = (
    Weights(),
    Weights(1.0, 1.0, 0.0, 0.8, 5.0, 0.1, 0.03, 0.55, 0.3, 4.0, 3.0),
    Weights(5.0, 2.0, 0.3, 0.4, 20.0, 0.1, 0.0, 0.0, 0.5, 2.0, 2.0),
    Weights(1.0, 1.0, 0.1, 0.2, 5.0, 0.05, 0.0, 0.55, 0.3, 4.0, 2.0),
    Weights(5.0, 2.0, 0.1, 0.4, 10.0, 0.2, 0.03, 0.55, 0.3, 2.0, 3.0),
)


def search(arrays: Arrays, weights: Weights, width: int, until_s: float = math.inf) -> Schedule:
    """The best schedule found before `until_s` on time.process_time's clock; what is not finished then is dropped."""
    g = arrays.m + arrays.k
    state = Beginnings(
        arrays.lands_s[None], np.zeros((1, arrays.n)), np.zeros((1, g)),
        np.vstack([arrays.start_ned, arrays.base_ned])[None], np.concatenate([arrays.spare_j, arrays.stock_j])[None],
        np.array([-1]),
    )  # fmt: skip
    tried: list[Moves] = []
    parents: list[Ints] = []
    count, now_s = 0, 0.0
    fewest, best = arrays.n + 1, -1
    while len(state.last) and time.process_time() < until_s:
        free_s = state.free_s.min(axis=1)
        ended = _ended(arrays, state, free_s)
        if ended.any():
            lost = np.where(ended, lands(arrays, state).sum(axis=1), arrays.n + 1)
            if lost.min() < fewest:
                fewest, best = int(lost.min()), int(state.last[lost.argmin()])
            if fewest == 0:
                break
            state, free_s = state.of(~ended), free_s[~ended]
            continue
        first = free_s <= now_s
        if not first.any():
            state = _kept(arrays, state, weights, width)
            now_s = max(now_s + weights.window_s, float(state.free_s.min()))
            continue
        moves = moves_of(arrays, state.of(first), weights)
        grown = grown_by(arrays, state.of(first), moves, weights)
        fresh = _distinct(grown)
        if len(fresh) > width:
            fresh = fresh[np.argsort(_score(arrays, grown.of(fresh), weights), kind="stable")[:width]]
        moves, grown = moves.of(fresh), grown.of(fresh)
        parents.append(grown.last)
        tried.append(moves)
        grown = grown._replace(last=count + np.arange(len(fresh)))
        count += len(fresh)
        state = state.of(~first).with_others(grown)
    return _schedule(arrays, best, tried, parents)


def _ended(arrays: Arrays, state: Beginnings, free_s: Floats) -> np.ndarray:
    """(b,) whether no service can change anything any more."""
    too_late = (state.lands_s < free_s[:, None]) & (state.busy_s <= free_s[:, None])
    return np.asarray((~lands(arrays, state) | too_late).all(axis=1) | (free_s >= arrays.horizon_s - arrays.setup_s))


def _distinct(state: Beginnings) -> Ints:
    """Rows, one for each of those that differ in what can still be done."""
    mixed = np.linspace(1.1, 2.3, state.lands_s.shape[1])
    key = np.round(1e3 * (state.lands_s * mixed).sum(axis=1)) + np.round(7919.0 * np.square(state.free_s).sum(axis=1))
    return np.unique(key, return_index=True)[1]


def _kept(arrays: Arrays, state: Beginnings, weights: Weights, width: int) -> Beginnings:
    if len(state.last) <= width:
        return state
    return state.of(np.argsort(_score(arrays, state, weights), kind="stable")[:width])


def _score(arrays: Arrays, state: Beginnings, weights: Weights) -> Floats:
    """(b,) how bad a beginning is, in services."""
    lands_s, free_s, horizon_s = state.lands_s, state.free_s, arrays.horizon_s
    first_s = free_s.min(axis=1)[:, None]
    landing = lands(arrays, state)
    alive = (lands_s >= first_s + arrays.setup_s) | (state.busy_s > first_s)
    lacks_j = np.where(alive, np.maximum(arrays.power_w * (horizon_s - lands_s), 0.0), 0.0)
    services = np.ceil(lacks_j / (arrays.holds_j * arrays.rate_w / net_w(arrays.rate_w, arrays.power_w)) - 1e-9)
    takes_s = arrays.setup_s + weights.way_s
    work_s = (lacks_j / arrays.rate_w + services * takes_s).sum(axis=1)
    next_s = np.where(services > 0, np.minimum(lacks_j, arrays.holds_j) / arrays.rate_w + takes_s, 0.0)
    order = np.argsort(np.where(services > 0, lands_s, math.inf), axis=1, kind="stable")
    deadline_s, each_s = np.take_along_axis(lands_s, order, 1), np.take_along_axis(next_s, order, 1)
    done_s = np.cumsum(each_s, axis=1) - 0.7 * each_s  # of a service, its beginning must be in time
    can_s = np.maximum(deadline_s[:, :, None] - free_s[:, None, :], 0.0).sum(axis=2)
    late_s = np.where(deadline_s < horizon_s - 1e-6, np.maximum(done_s - can_s, 0.0), 0.0).max(axis=1)
    beyond_s = np.maximum(work_s - np.maximum(horizon_s - free_s, 0.0).sum(axis=1), 0.0)
    near = np.where(
        landing & alive, elementwise.exponentials(-np.maximum(lands_s - first_s, 0.0) / weights.near_s), 0.0
    ).sum(axis=1)
    short_j = np.maximum(lacks_j.sum(axis=1) - state.spare_j.sum(axis=1), 0.0)
    service_s = takes_s + 0.6 * arrays.holds_j.mean() / arrays.rate_w
    return np.asarray(
        weights.lost * (landing & ~alive).sum(axis=1)
        + (weights.late * late_s + 0.3 * beyond_s + weights.work * work_s + weights.time * free_s.sum(axis=1))
        / service_s
        + weights.near * near
        + 1.4 * short_j / arrays.holds_j.mean()
    )


def _schedule(arrays: Arrays, last: int, tried: list[Moves], parents: list[Ints]) -> Schedule:
    """The services that led to one of those tried."""
    one = arrays.instance
    ends = np.cumsum([len(moves.row) for moves in tried])
    services = []
    while last >= 0:
        block = int(np.searchsorted(ends, last, side="right"))
        moves, i = tried[block], last - (int(ends[block - 1]) if block else 0)
        giver, receiver = int(moves.giver[i]), int(moves.receiver[i])
        base = int(moves.base[i]) if giver < arrays.m else giver - arrays.m
        goes = giver >= arrays.m
        if receiver != NONE:
            services.append(
                ScheduledService(
                    float(moves.start_s[i]), float(moves.end_s[i]), float(moves.energy_j[i]),
                    one.receivers[receiver].id if receiver >= 0 else None,
                    None if goes else one.tankers[giver].id,
                    one.bases[base].name if base >= 0 else None,
                    float(moves.leave_s[i]) if goes else None, float(moves.back_s[i]) if goes else None,
                )
            )  # fmt: skip
        last = int(parents[block][i])
    return Schedule(SCHEDULE, one.name, services[::-1])
