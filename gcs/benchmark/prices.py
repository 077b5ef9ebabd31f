"""At least how many receivers every schedule loses, by prices of the tankers' time: for instances without bases.

Let time have a price p(t), in receivers a second, and energy a price e, in receivers a joule. The receivers that a
schedule keeps use no more than the m tankers have, so with c_i, the least that receiver i can pay to be kept,

    lost >= sum_i min(1, c_i) - m · (integral of p from 0 to the horizon) - e · (what tankers can give)

for all prices (Lagrangian relaxation; M. L. Fisher, Management Science 27, 1981). Any prices prove a bound; good ones
are the dual values of a linear program over the cheapest plans found so far (column generation: L. R. Ford, D. R.
Fulkerson, Management Science 5, 1958), between those and the best so far (P. Wentges, ITOR 4, 1997).

c_i is found by dynamic programming over time and over when a receiver would land. Each schedule that the verifier
accepts is one of its plans, at no greater price:

- A visit is all services of one receiver by one tanker between which neither has another. A tanker serves no other
  for a visit's time, nor before it for the least way to the receiver, at the time of its coming, from any other
  receiver or a tanker's start. Where it comes back after another tanker has served its receiver, it has waited for a
  setup at least; so no way counts for more than a setup.
- A visit begins no later than a setup before the receiver would land, gives energy at the rate for what it takes
  beside the setup at most, and ends when the receiver holds no more than it can.
- Visits begin in steps of time, each at the cheapest time in its step.
- When a receiver would land is rounded up to units. A visit that takes it from one of them to another gives it more
  than one unit less than the difference.
- With all that is needed to the horizon less the first charge, a receiver that is kept pays for its energy.

Where bases are, a receiver needs no tanker, and this bound is 0.
"""

from __future__ import annotations

import math
import time

import numpy as np
from numpy.typing import ArrayLike

from gcs.benchmark.arrays import Arrays, Floats, Ints

STEP_S = 1.0
UNIT_S = 4.0
"""[choice] Of the time at which a receiver would land, about: a whole number of them leads to the horizon."""
PRICED_S = 5.0
"""[choice] A price lasts for so long."""
SLACK_S = 0.01
"""More than the verifier's tolerance allows in any time."""
CERTAIN = 1e-4
"""Of a receiver: more than the sums are wrong by."""
NEVER = 1e9
TOWARDS = 0.4
"""[choice] Of the way from the best prices to the program's."""
UNIFORM = (0.6, 0.9)
"""[choice] First prices, the same at all times: shares of those at which the receivers pay for all time there is."""


class CheapestPlans:
    """The cheapest plans of the receivers that would land before the horizon: n of them, steps of time, j units."""

    def __init__(self, arrays: Arrays, ways_s: Floats, first_s: Floats) -> None:
        self.receivers = np.flatnonzero(arrays.lands_s < arrays.horizon_s - SLACK_S)
        at, horizon_s = self.receivers, arrays.horizon_s
        self.n, self.steps = len(at), math.ceil(horizon_s / STEP_S)
        self._horizon_s, self._setup_s, self._first_s = horizon_s, arrays.setup_s, first_s[at]
        self._grid_s = STEP_S * np.arange(self.steps + 1)
        lacks_s = horizon_s - SLACK_S - arrays.lands_s[at]
        units = np.ceil(lacks_s / UNIT_S).astype(np.int64)
        self._unit_s, self._j = lacks_s / units, int(units.max())
        self._from = self._j - units
        left = np.arange(self._j + 1) - self._j
        self._lands_s = horizon_s + left * self._unit_s[:, None]
        rounded_s = np.where(left < 0, self._unit_s[:, None], 0.0) + 2.0 * SLACK_S
        self._full_s = self._lands_s - rounded_s - (arrays.holds_j / arrays.power_w)[at, None]
        """(n, j) a visit that ends there ends no sooner"""
        more = np.maximum(np.arange(self._j + 1)[None, :] - np.arange(self._j + 1)[:, None], 0)
        self._more = more
        gained_s = np.maximum(np.arange(self._j + 2) - 1, 0) * self._unit_s[:, None] - SLACK_S
        flow = arrays.power_w[at, None] / arrays.rate_w
        self._takes_s = arrays.setup_s + np.maximum(gained_s, 0.0) * flow
        """(n, units + 1) a visit that gives so many; the last one of a plan is not rounded, and takes one unit more"""
        self._index = np.where((more > 0) & (np.arange(self._j + 1) == self._j), more + 1, more)
        before = math.ceil(arrays.setup_s / STEP_S) + 1
        spans = [slice(max(0, t - before), t + 3) for t in range(self.steps)]
        self._way_s = np.minimum([ways_s[at, span].min(axis=1) for span in spans], arrays.setup_s)
        """(steps, n)"""

    def cheapest(self, price: Floats) -> tuple[Floats, Floats]:
        """(n,) what each receiver pays, and (n, steps) the tankers' time that it uses, s; `price` (steps,) a second."""
        paid = np.concatenate([[0.0], np.cumsum(price) * STEP_S])
        left = np.full((self.steps + 2, self.n, self._j + 1), NEVER)
        left[:, :, self._j] = 0.0
        chosen = np.full((self.steps, self.n, self._j + 1), -1)
        begun: dict[int, tuple[Floats, Floats]] = {}
        each, to = np.arange(self.n)[:, None, None], np.arange(self._j + 1)[None, None, :]
        full_paid = _until(self._full_s, paid)
        full_step = np.clip(self._full_s // STEP_S, 0, self.steps).astype(np.int64)
        for t in range(self.steps - 1, -1, -1):
            begun[t] = self._begun(t, paid)
            cost = begun[t][1]
            end = np.clip((t * STEP_S + self._takes_s) // STEP_S, t + 1, self.steps).astype(np.int64)
            after = np.maximum(end[:, self._index], full_step[:, None, :])
            last_paid = _until((t + 1) * STEP_S - self._way_s[t], paid)
            costs = np.maximum(cost[:, self._index], full_paid[:, None, :] - last_paid[:, None, None])
            costs = costs + left[after, each, to]
            may = (self._more > 0) & (self._lands_s + SLACK_S >= t * STEP_S + self._setup_s)[:, :, None]
            costs = np.where(may, costs, NEVER)
            best = costs.argmin(axis=2)
            value = np.take_along_axis(costs, best[:, :, None], 2)[:, :, 0]
            visits = value < left[t + 1]
            left[t] = np.where(visits, value, left[t + 1])
            chosen[t] = np.where(visits, best, -1)
        used_s = np.stack([self._used_s(i, chosen[:, i], paid, begun) for i in range(self.n)])
        return left[0, np.arange(self.n), self._from], used_s

    def _begun(self, t: int, paid: Floats) -> tuple[Floats, Floats]:
        """(n, units) the cheapest beginning of a visit in a step, and what it costs: the price is constant in a step,
        so that a beginning is cheapest where the step, or that of the way's beginning or the visit's end, ends."""
        low_s, high_s, way_s = t * STEP_S, (t + 1) * STEP_S, self._way_s[t][:, None]
        takes_s = self._takes_s
        at_s = np.stack([
            np.full_like(takes_s, low_s), np.full_like(takes_s, high_s),
            np.clip(np.ceil((low_s + takes_s) / STEP_S) * STEP_S - takes_s, low_s, high_s),
            np.clip(np.ceil((low_s - way_s) / STEP_S) * STEP_S + way_s + 0.0 * takes_s, low_s, high_s),
        ])  # fmt: skip
        costs = _until(at_s + takes_s, paid) - _until(at_s - way_s, paid)
        best = costs.argmin(axis=0)[None]
        may = (high_s >= self._first_s[:, None]) & (low_s + takes_s <= self._horizon_s + SLACK_S)
        cost = np.where(may, np.take_along_axis(costs, best, 0)[0], NEVER)
        return np.take_along_axis(at_s, best, 0)[0], cost

    def _used_s(self, i: int, chosen: Ints, paid: Floats, begun: dict[int, tuple[Floats, Floats]]) -> Floats:
        """(steps,) the time that one receiver's plan uses."""
        used_s, t, j = np.zeros(self.steps), 0, int(self._from[i])
        while j < self._j and t < self.steps:
            to = int(chosen[t, j])
            if to < 0:
                t += 1
                continue
            unit = int(self._index[j, to])
            begins_s, cost = (float(one[i, unit]) for one in begun[t])
            ends_s, way_s = begins_s + self._takes_s[i, unit], self._way_s[t, i]
            last_s, full_s = (t + 1) * STEP_S, float(self._full_s[i, to])
            if _until(full_s, paid) - _until(last_s - way_s, paid) > cost:
                begins_s, ends_s = last_s, full_s
            held_s = np.minimum(ends_s, self._grid_s[1:]) - np.maximum(begins_s - way_s, self._grid_s[:-1])
            used_s += np.clip(held_s, 0.0, None)
            end_s = max(t * STEP_S + self._takes_s[i, unit], full_s)
            t, j = max(min(int(end_s // STEP_S), self.steps), t + 1), to
        return used_s


def least_lost(
    arrays: Arrays, ways_s: Floats, first_s: Floats, needs_j: Floats, most_j: float, enough: int, until_s: float
) -> int:
    """At least so many are lost; looked for until `enough` are, no more can be found, or `until_s` on
    time.process_time's clock. `ways_s` (n, samples of a second) and `first_s` (n,) are the least ways to receivers and
    when a tanker can be there; `needs_j` (n,) and `most_j` what each must get, and all can give."""
    if arrays.k or arrays.setup_s < STEP_S or not (arrays.lands_s < arrays.horizon_s - SLACK_S).any():
        return 0
    plans = CheapestPlans(arrays, ways_s, first_s)
    needs_j = needs_j[plans.receivers]
    span = np.arange(plans.steps) // math.ceil(PRICED_S / STEP_S)
    spans = int(span[-1]) + 1
    has_s = arrays.m * np.bincount(span, np.full(plans.steps, STEP_S))
    has = np.concatenate([has_s, [most_j]])
    best, best_prices = 0.0, np.zeros(spans + 1)
    columns: list[Floats] = []
    uniform = plans.n / (arrays.m * arrays.horizon_s)
    ahead = [np.append(np.full(spans, share * uniform), 0.0) for share in UNIFORM]
    while time.process_time() < until_s:
        if not ahead:
            prices, most = _dual(np.array(columns), plans.n, has)
            if math.ceil(best - CERTAIN) >= min(enough, math.ceil(most - CERTAIN)):
                break
            ahead = [best_prices + TOWARDS * (prices - best_prices)]
        prices = ahead.pop()
        pays, used_s = plans.cheapest(prices[:spans][span])
        lost = float(np.minimum(pays + prices[spans] * needs_j, 1.0).sum() - has @ prices)
        if lost > best:
            best, best_prices = lost, prices
        columns += [
            np.concatenate([np.bincount(span, row), [needs_j[i]], np.arange(plans.n) == i])
            for i, row in enumerate(used_s)
        ]
    return math.ceil(best - CERTAIN)


def _dual(columns: Floats, n: int, has: Floats) -> tuple[Floats, float]:
    """The prices at which the plans found so far are best, and the bound that they would prove: (columns, uses and n
    that are 1 where a plan is a receiver's) of which each receiver has one at most."""
    from scipy.optimize import linprog  # noqa: PLC0415 - an extra

    found = linprog(-np.ones(len(columns)), A_ub=columns.T, b_ub=np.concatenate([has, np.ones(n)]), method="highs")
    return np.maximum(-found.ineqlin.marginals[: len(has)], 0.0), n + float(found.fun)


def _until(at_s: ArrayLike, paid: Floats) -> Floats:
    """Payments until some times, from the sums until each end of a step."""
    steps = np.clip(np.asarray(at_s, np.float64) / STEP_S, 0.0, len(paid) - 1.0)
    whole = np.minimum(steps.astype(np.int64), len(paid) - 2)
    return np.asarray(paid[whole] + (steps - whole) * (paid[whole + 1] - paid[whole]))
