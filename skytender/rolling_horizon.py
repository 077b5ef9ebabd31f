"""Services planned ahead for all givers over a rolling horizon (docs/model/competition.md#planned-services) [choice].

A plan lists the vehicles that each giver serves one after another. The giver that is free first takes one of the
vehicles that want energy then; none waits that a free giver could serve. A service that begins s before its receiver
would land keeps it with the probability q = 1/(1 + e^(-(s - s0)/σ)), since times are estimates, the worse the further
ahead they lie: σ = σ0 + σ1 t of a service that begins t from now. A plan costs the sum of
-ln q, at most COST for each, which is least where most likely no vehicle is lost; and COST for each that lands unserved
within the horizon. Plans grow service by service and the best of each length are kept (beam search), so that the time
to plan is bounded for every fleet.

Times in s from now, energies in J above the charge at which a vehicle lands; n vehicles, m givers.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc.math import INFINITY, sqrt
from cython.cimports.skytender.rolling_horizon import WIDTH
from numpy.typing import NDArray

from skytender.elementwise import exponentials

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

COST = 8.0
"""[choice] Of one that is lost, where a service that begins at the very last moment costs ln 2."""
_COST = COST
_SIGMA_S, _SIGMA_GROWS, _EARLY_S = 0.35, 0.05, 0.5
"""[choice] How wrong the begin of a service is that begins now, and more for each second until then; and how much
sooner a vehicle lands than its reports of 100 J tell."""
_TOO_LATE_S = 3.0
"""A vehicle that would have landed so long before is not flown to."""
_SHORTEST_S = 1.0
"""No service takes less: plans are of bounded length."""
_WAITS_S = 1.0
"""So long a giver waits that reaches none of the vehicles that want energy."""
_FORESEEN_S = 6.0
"""[choice] Of two plans of one length, the better leaves more time than this to more of the others."""
_WORTH_J = 500.0
"""A giver with less to spare takes no receiver."""
_ROUNDING_S = 1e-9


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
class Givers:
    """Tankers and bases."""

    p_ned: FloatArray
    """(m, 3), where each is when it is free, common NED frame, m"""
    free_s: FloatArray
    """(m,) when it is free"""
    speed_m_s: FloatArray
    """(m,) of the tanker, or of a vehicle that flies to the base"""
    available_j: FloatArray
    """(m,) what it can spare"""
    rate_w: FloatArray
    """(m,) greatest power of a transfer"""
    flies: NDArray[np.bool_]
    """(m,) whether it flies to its receivers"""


class Durations(NamedTuple):
    """How long a service takes: START_S + PER_WAY · way to its first joule, and END_S from the last one on."""

    start_s: float
    per_way: float
    end_s: float


@dataclass(frozen=True)
class Planned:
    """The best plan found, and what other beginnings cost."""

    first: IntArray
    """(m,) index of the vehicle that each giver serves first; -1: none within the horizon"""
    starts_s: FloatArray
    """(m,) when it sets off; inf where it serves no vehicle"""
    cost: float
    served_cost: FloatArray
    """(n,) of the best plan in which the givers that are free first set off to this vehicle at once; inf without one"""
    passed_over_cost: FloatArray
    """(n,) of the best plan in which they do not; inf without one"""


def plan(receivers: Receivers, givers: Givers, takes: Durations, *, horizon_s: float) -> Planned:
    """The plan of the least cost that was found, of at least one vehicle and one giver."""
    search = Search(receivers, givers, takes, horizon_s)
    search.run()
    return Planned(
        np.asarray(search.first),
        np.asarray(search.starts),
        search.least,
        np.asarray(search.served),
        np.asarray(search.passed_over),
    )


def _risk(late_s: float, begin_s: float) -> float:
    """-ln q of a service that begins so much later than it should, `begin_s` from now."""
    x = late_s / (_SIGMA_S + _SIGMA_GROWS * begin_s)
    return min(max(x, 0.0) + elementary.log(1.0 + elementary.exp(-abs(x))), _COST)


class _Plans:
    """Plans of one length."""

    def __init__(self, n: int, m: int) -> None:
        self.count = 0
        most = WIDTH + n
        self.cost = np.zeros(most)
        self.lands, self.fading = np.zeros((most, n)), np.zeros((most, n))
        """when each receiver lands, and e^(-that/_FORESEEN_S)"""
        self.free, self.left = np.zeros((most, m)), np.zeros((most, m))
        self.place, self.starts = np.zeros((most, m, 3)), np.full((most, m), np.inf)
        self.first, self.root = np.full((most, m), -1), np.full(most, -1)
        """the vehicle that each giver serves first, and the one that is served first of all"""

    def begin(self, lands_s: FloatArray, givers: Givers) -> None:
        """The plan without a service."""
        self.count = 1
        np.asarray(self.lands)[0] = lands_s
        np.asarray(self.fading)[0] = exponentials(-lands_s / _FORESEEN_S)
        np.asarray(self.free)[0], np.asarray(self.left)[0] = givers.free_s, givers.available_j
        np.asarray(self.place)[0] = givers.p_ned

    def copy(self, to: int, others: _Plans, k: int) -> None:
        self.cost[to], self.root[to] = others.cost[k], others.root[k]
        self.lands[to, :], self.fading[to, :] = others.lands[k, :], others.fading[k, :]
        self.free[to, :], self.left[to, :] = others.free[k, :], others.left[k, :]
        self.place[to, :, :] = others.place[k, :, :]
        self.starts[to, :], self.first[to, :] = others.starts[k, :], others.first[k, :]


class _Steps:
    """Services by which plans of one length go on; -1 chosen: the giver waits."""

    def __init__(self, most: int) -> None:
        self.count = 0
        self.parent, self.chosen, self.giver = np.zeros((3, most), np.int64)
        self.sets_off, self.begin, self.flow, self.cost, self.score = np.zeros((5, most))


class Search:
    """Beam search over plans."""

    def __init__(self, receivers: Receivers, givers: Givers, takes: Durations, horizon_s: float) -> None:
        n, m = len(receivers.lands_s), len(givers.free_s)
        self.n, self.m, self.horizon_s = n, m, horizon_s
        self.start_s, self.per_way, self.end_s = takes
        self.p = np.ascontiguousarray(receivers.p_ned, np.float64)
        self.power, self.full = receivers.power_w, receivers.full_j
        self.wants = receivers.wants_j / receivers.power_w
        self.speed, self.rate, self.flies = givers.speed_m_s, givers.rate_w, givers.flies.view(np.uint8)
        self.free_at_first, self.soonest_s = givers.free_s, givers.free_s.min()
        self.mark, self.kept = np.zeros(n, np.uint8), list[int]()
        self.plans, self.longer, self.steps = _Plans(n, m), _Plans(n, m), _Steps((WIDTH + n) * n)
        self.plans.begin(receivers.lands_s, givers)
        self.served, self.passed_over = np.full(n, np.inf), np.full(n, np.inf)
        self.least, self.first, self.starts = np.inf, np.full(m, -1), np.full(m, np.inf)

    def run(self) -> None:
        """Let plans grow until all have come to the horizon."""
        while self.plans.count:
            self.steps.count = 0
            for k in range(self.plans.count):
                self._branch(k)
            self._choose()
            for to, which in enumerate(self.kept):
                self._step(to, which)
            self.longer.count = len(self.kept)
            self.plans, self.longer = self.longer, self.plans

    def _choose(self) -> None:
        """Keep the best plans, and of each vehicle that may be served first the best."""
        steps, plans = self.steps, self.plans
        order = np.argsort(np.asarray(steps.score)[: steps.count], kind="stable").tolist()
        self.kept = order[:WIDTH]
        if len(order) <= WIDTH:
            return
        for i in range(self.n):
            self.mark[i] = 0
        for rank, which in enumerate(order):
            root = plans.root[steps.parent[which]]
            if root < 0:
                root = steps.chosen[which]
            if root >= 0 and not self.mark[root]:
                self.mark[root] = 1
                if rank >= WIDTH:
                    self.kept.append(which)

    def _end(self, k: int) -> None:
        """Take in a plan that has come to the horizon."""
        plans = self.plans
        cost = plans.cost[k]
        for i in range(self.n):
            self.mark[i] = 0
            if plans.lands[k, i] < self.horizon_s:
                cost += _COST
        if cost < self.least:
            self.least = cost
            self.first[:], self.starts[:] = plans.first[k, :], plans.starts[k, :]
        for j in range(self.m):
            at_once = plans.starts[k, j] <= self.soonest_s + _ROUNDING_S
            if plans.first[k, j] >= 0 and self.free_at_first[j] == self.soonest_s and at_once:
                self.mark[plans.first[k, j]] = 1
        for i in range(self.n):
            if self.mark[i]:
                self.served[i] = min(self.served[i], cost)
            else:
                self.passed_over[i] = min(self.passed_over[i], cost)

    def _branch(self, k: int) -> None:
        """All services by which a plan may go on."""
        plans, steps = self.plans, self.steps
        t = 0
        for j in range(1, self.m):
            if plans.free[k, j] < plans.free[k, t]:
                t = j
        now, soonest = plans.free[k, t], INFINITY
        for i in range(self.n):
            if plans.lands[k, i] > now - _TOO_LATE_S:
                soonest = min(soonest, plans.lands[k, i] - self.wants[i])
        sets_off = max(now, soonest)
        if not sets_off < self.horizon_s:
            self._end(k)
            return
        others = INFINITY
        for j in range(self.m):
            if j != t:
                others = min(others, plans.free[k, j])
        foreseen = self._foreseen(k, others)
        waits = True
        for i in range(self.n):
            north, east = self.p[i, 0] - plans.place[k, t, 0], self.p[i, 1] - plans.place[k, t, 1]
            down = self.p[i, 2] - plans.place[k, t, 2]
            way_s = sqrt(north * north + east * east + down * down) / self.speed[t]
            begin = sets_off + max(self.start_s + self.per_way * way_s, 0.0)
            lands = plans.lands[k, i]
            spare = lands - begin
            # Rounding must not make a vehicle that wants energy at this very time want it no more.
            if lands - self.wants[i] > sets_off + _ROUNDING_S or spare <= -_TOO_LATE_S:
                continue
            waits = False
            net_w = max(self.rate[t] - self.power[i], 0.1 * self.rate[t])
            missing_j = max(self.full[i] - max(spare, 0.0) * self.power[i], 0.0)
            flow = min(missing_j / net_w, plans.left[k, t] / self.rate[t])
            gained_j = flow * self.rate[t]
            free = max(begin + flow + self.end_s, sets_off + _SHORTEST_S)
            if plans.left[k, t] - gained_j < _WORTH_J:
                free = INFINITY
            at = steps.count
            steps.parent[at], steps.chosen[at], steps.giver[at] = k, i, t
            steps.sets_off[at], steps.begin[at], steps.flow[at] = sets_off, begin, flow
            steps.cost[at] = plans.cost[k] + _risk(_EARLY_S - spare, begin)
            soonest = min(free, others)
            rest = foreseen if soonest == others else self._foreseen(k, soonest)
            rest -= self._rest(lands, soonest)
            rest += self._rest(max(lands, begin) + gained_j / self.power[i], soonest)
            steps.score[at] = steps.cost[at] + rest
            steps.count += 1
        if waits:
            at = steps.count
            steps.parent[at], steps.chosen[at], steps.giver[at] = k, -1, t
            steps.sets_off[at], steps.begin[at], steps.flow[at] = sets_off, 0.0, 0.0
            steps.cost[at] = plans.cost[k]
            steps.score[at] = steps.cost[at] + self._foreseen(k, min(now + _WAITS_S, others))
            steps.count += 1

    def _rest(self, lands: float, free: float) -> float:
        """What a vehicle that lands then is likely to cost if no giver is free before: COST if it lands before that,
        and the less the more time is left."""
        if lands >= self.horizon_s:
            return 0.0
        return _COST if lands < free else elementary.exp((free - lands) / _FORESEEN_S)

    def _foreseen(self, k: int, free: float) -> float:
        """The same of all vehicles of a plan."""
        plans, total = self.plans, 0.0
        grown = elementary.exp(free / _FORESEEN_S) if free < self.horizon_s else 0.0
        for i in range(self.n):
            if plans.lands[k, i] < free:
                total += _COST if plans.lands[k, i] < self.horizon_s else 0.0
            elif plans.lands[k, i] < self.horizon_s:
                total += plans.fading[k, i] * grown
        return total

    def _step(self, to: int, which: int) -> None:
        """Write a plan that has gone on by a service."""
        steps, longer = self.steps, self.longer
        t, i = steps.giver[which], steps.chosen[which]
        longer.copy(to, self.plans, steps.parent[which])
        if i < 0:
            longer.free[to, t] += _WAITS_S
            return
        begin, flow = steps.begin[which], steps.flow[which]
        gained_j = flow * self.rate[t]
        longer.cost[to] = steps.cost[which]
        longer.lands[to, i] = max(longer.lands[to, i], begin) + gained_j / self.power[i]
        longer.fading[to, i] = elementary.exp(-longer.lands[to, i] / _FORESEEN_S)
        longer.left[to, t] -= gained_j
        longer.free[to, t] = max(begin + flow + self.end_s, steps.sets_off[which] + _SHORTEST_S)
        if longer.left[to, t] < _WORTH_J:
            longer.free[to, t] = INFINITY
        if self.flies[t]:
            longer.place[to, t, :] = self.p[i, :]
        if longer.root[to] < 0:
            longer.root[to] = i
        if longer.first[to, t] < 0:
            longer.first[to, t], longer.starts[to, t] = i, steps.sets_off[which]
