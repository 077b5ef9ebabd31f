"""Services planned ahead for all tankers over a rolling horizon (docs/model/competition.md#planned-services) [choice].

A plan lists the vehicles that each tanker serves one after another. The tanker that is free first takes one of the
vehicles that want energy then; none waits that a free tanker could serve. A service that begins s before its receiver
would land keeps it with the probability q = 1/(1 + e^(-(s - s0)/σ)), since times are estimates. A plan costs the sum of
-ln q, at most COST for each, which is least where most likely no vehicle is lost; and COST for each that lands unserved
within the horizon. Plans grow service by service and the best of each length are kept (beam search), so that the time
to plan is bounded for every fleet.

Times in s from now, energies in J above the charge at which a vehicle lands; n vehicles, m tankers, b plans.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gcs.refuelling.giver import Giver, ServiceTimes
from skytender import elementwise

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

SIGMA_S = 0.35
EARLY_S = 0.5
"""[choice] How wrong the begin of a service is, and how much sooner a vehicle lands than its reports of 100 J tell."""
COST = 8.0
"""[choice] Of one that is lost, where a service that begins at the very last moment costs ln 2."""
TOO_LATE_S = 3.0
"""A vehicle that would have landed so long before is not flown to."""
SHORTEST_S = 1.0
"""No service takes less: plans are of bounded length."""
WIDTH = 64
"""Plans kept of each length."""
FORESEEN_S = 6.0
"""[choice] Of two plans of one length, the better leaves more time than this to more of the others."""


@dataclass(frozen=True)
class Receivers:
    """Vehicles that may be served."""

    p_ned: FloatArray
    """(n, 3), common NED frame, m"""
    lands_s: FloatArray
    """(n,) when each lands if it is not served"""
    power_w: FloatArray
    """(n,) draw, above 0"""
    full_j: FloatArray
    """(n,) what it holds after a service"""
    wants_j: FloatArray
    """(n,) it wants energy from this on down"""


@dataclass(frozen=True)
class Planned:
    """The best plan found."""

    first: IntArray
    """(m,) index of the vehicle that each tanker serves first; -1: none within the horizon"""
    starts_s: FloatArray
    """(m,) when it sets off; inf where it serves no vehicle"""
    cost: float


def plan(
    fleet: Receivers, tankers: Sequence[Giver], takes: ServiceTimes, *, rate_w: float, horizon_s: float
) -> Planned:
    """The plan of the least cost that was found, of at least one vehicle and one tanker; rate_w: of one transfer, W."""
    m = len(tankers)
    lands = fleet.lands_s[None, :].copy()
    free = np.array([[tanker.free_in_s for tanker in tankers]])
    place = np.array([[tanker.p_ned for tanker in tankers]])
    left_j = np.array([[tanker.available_j for tanker in tankers]])
    speed_m_s = np.array([tanker.speed_m_s for tanker in tankers])
    cost = np.zeros(1)
    first, starts = np.full((1, m), -1), np.full((1, m), math.inf)
    wants_s = fleet.wants_j / fleet.power_w  # so long before it lands
    net_w = np.maximum(rate_w - fleet.power_w, 0.1 * rate_w)
    best: Planned | None = None
    while True:
        tanker = free.argmin(axis=1)
        rows = np.arange(len(free))
        now = free[rows, tanker]
        wanted = lands - wants_s
        alive = lands > now[:, None] - TOO_LATE_S
        soonest = np.where(alive, wanted, math.inf).min(axis=1)
        sets_off = np.maximum(now, soonest)
        ended = ~(sets_off < horizon_s)
        if ended.any():
            best = _better(best, cost[ended] + _unserved(lands[ended], horizon_s), first[ended], starts[ended])
        going = ~ended
        if not going.any():
            break
        rows = np.flatnonzero(going)
        tanker, sets_off = tanker[rows], sets_off[rows]
        away = fleet.p_ned[None, :, :] - place[rows, tanker][:, None, :]
        way_s = np.sqrt(np.square(away).sum(axis=2)) / speed_m_s[tanker][:, None]
        begins = sets_off[:, None] + np.maximum(takes.start_s + takes.per_way * way_s, 0.0)
        spare = lands[rows] - begins
        # Rounding must not make a vehicle that wants energy at this very time want it no more.
        may = (wanted[rows] <= sets_off[:, None] + 1e-9) & (spare > -TOO_LATE_S)
        missing_j = fleet.full_j - np.maximum(spare, 0.0) * fleet.power_w
        flows = np.minimum(np.maximum(missing_j, 0.0) / net_w, left_j[rows, tanker][:, None] / rate_w)
        stuck = ~may.any(axis=1)
        if stuck.any():  # none that wants energy is reached in time: the tanker waits until another does
            free[rows[stuck], tanker[stuck]] += 1.0
            if stuck.all():
                continue
        parent, chosen = np.nonzero(may)
        of = rows[parent]
        by = tanker[parent]
        begin, flow = begins[parent, chosen], flows[parent, chosen]
        late = -(spare[parent, chosen] - EARLY_S) / SIGMA_S
        new_cost = cost[of] + np.minimum(_softplus(late), COST)
        each = np.arange(len(of))
        new_lands, new_free, new_left = lands[of], free[of], left_j[of]
        gained_s = flow * rate_w / fleet.power_w[chosen]
        new_lands[each, chosen] = np.maximum(new_lands[each, chosen], begin) + gained_s
        new_free[each, by] = np.maximum(begin + flow + takes.end_s, sets_off[parent] + SHORTEST_S)
        new_left[each, by] -= flow * rate_w
        new_free[each, by] = np.where(new_left[each, by] < 500.0, math.inf, new_free[each, by])
        new_place, new_first, new_starts = place[of], first[of], starts[of]
        new_place[each, by] = fleet.p_ned[chosen]
        fresh = new_first[each, by] < 0
        new_first[each[fresh], by[fresh]] = chosen[fresh]
        new_starts[each[fresh], by[fresh]] = sets_off[parent][fresh]
        if stuck.any():
            held = rows[stuck]
            new_lands, new_free = np.vstack([new_lands, lands[held]]), np.vstack([new_free, free[held]])
            new_left, new_cost = np.vstack([new_left, left_j[held]]), np.concatenate([new_cost, cost[held]])
            new_place = np.concatenate([new_place, place[held]])
            new_first, new_starts = np.vstack([new_first, first[held]]), np.vstack([new_starts, starts[held]])
        if len(new_cost) > WIDTH:
            kept = np.argsort(new_cost + _foreseen(new_lands, new_free, horizon_s), kind="stable")[:WIDTH]
            new_lands, new_free, new_left, new_cost = new_lands[kept], new_free[kept], new_left[kept], new_cost[kept]
            new_place, new_first, new_starts = new_place[kept], new_first[kept], new_starts[kept]
        lands, free, left_j, cost = new_lands, new_free, new_left, new_cost
        place, first, starts = new_place, new_first, new_starts
    assert best is not None
    return best


def _better(best: Planned | None, cost: FloatArray, first: IntArray, starts: FloatArray) -> Planned:
    i = int(cost.argmin())
    if best is not None and best.cost <= cost[i]:
        return best
    return Planned(first[i], starts[i], float(cost[i]))


def _unserved(lands: FloatArray, horizon_s: float) -> FloatArray:
    """(b,) how many land within the horizon."""
    return COST * np.asarray((lands < horizon_s).sum(axis=1), dtype=np.float64)


def _softplus(x: FloatArray) -> FloatArray:
    """ln(1 + e^x), of each."""
    return np.maximum(x, 0.0) + elementwise.logarithms(1.0 + elementwise.exponentials(-np.abs(x)))


def _foreseen(lands: FloatArray, free: FloatArray, horizon_s: float) -> FloatArray:
    """(b,) what the rest is likely to cost: 1 for one that lands before a tanker is free, the less the more time is
    left."""
    left_s = lands - free.min(axis=1)[:, None]
    risk = np.where(left_s < 0.0, COST, elementwise.exponentials(-np.maximum(left_s, 0.0) / FORESEEN_S))
    return np.asarray((risk * (lands < horizon_s)).sum(axis=1))
