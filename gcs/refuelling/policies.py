"""Receiver policies other than the competition: shipped ones, or a user's own class.

    class MyPolicy:
        def __init__(self, scenario): ...
        def choose(self, request): return a system id, or None for none now

A scenario names one: `competition: {policy: optimal | … | MODULE:CLASS}`. With a policy that chooses for one tanker at
a time, a vehicle that would not last until a rendezvous goes first (docs/protocol/energy.md#refuelling-schedule).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from numbers import Real
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gcs.refuelling.giver import Giver, ServiceTimes, lasts_s, match
from gcs.refuelling.service_plan import plan_services
from gcs.scenario.guard import Guard, Nonsense, PluginFault, plain, shown
from gcs.scenario.model import RefuellingRules, Scenario
from gcs.telemetry.state import VehicleView
from skytender import elementary
from skytender.assignment import least_cost
from skytender.service_plan import LONGEST_S

WINNER_TAKE_ALL = "winner_take_all"
OPTIMAL = "optimal"
AUCTION_S = 0.01
"""How far a tanker raises its bid at least."""


@dataclass(frozen=True, slots=True)
class RefuellingRequest:
    """A tanker is free and at least one vehicle wants energy."""

    time_s: float
    tanker: VehicleView
    candidates: tuple[VehicleView, ...]
    """vehicles that may be served, in order of system id: in the air, below `competition.need_from`, not yet being
    served"""
    free_tankers: tuple[VehicleView, ...]
    """`tanker` first, and all that are free beside it"""
    speed_m_s: Mapping[int, float]
    """by tanker"""
    rules: RefuellingRules
    givers: tuple[Giver, ...] = ()
    """every tanker that serves, the busy ones with where and when they are free"""
    later: tuple[VehicleView, ...] = ()
    """vehicles that can be served but do not want it yet, in order of system id"""
    times: ServiceTimes | None = None
    """how long services take, as learnt so far"""
    left_s: float = math.inf
    """until the session ends"""


class RefuellingPolicy(Protocol):
    """One-method protocol; made once, as CLASS(scenario).

    One that chooses for all free tankers at once has `assign(request)` too, which returns system ids of receivers by
    tanker's and is then asked instead, and before any rule of urgency.
    """

    def choose(self, request: RefuellingRequest) -> int | None:
        """System id of the candidate that request.tanker is to serve; None: none, ask again in the next tick."""


class PolicyCalls(Protocol):
    """Calls of a policy, each of which may fail."""

    @property
    def assigns(self) -> bool:
        """Whether it chooses for all free tankers at once."""

    def pairs(self, request: RefuellingRequest) -> dict[int, int]:
        """Receiver by tanker, both candidates of the request; empty where there is no good answer, or no vehicle
        now."""

    def pop_faults(self) -> list[PluginFault]:
        """The problems since the last call."""


class GuardedPolicy(PolicyCalls):
    """A policy that is called here. See `PolicyCalls` for the methods."""

    def __init__(self, policy: RefuellingPolicy, guard: Guard) -> None:
        self._policy = policy
        self._assign: Callable[[RefuellingRequest], Any] | None = getattr(policy, "assign", None)
        self._guard = guard

    @property
    def assigns(self) -> bool:
        return self._assign is not None

    def pairs(self, request: RefuellingRequest) -> dict[int, int]:
        assign, tanker = self._assign, request.tanker.sysid
        self._guard.begin_tick(request.time_s)
        if assign is not None:
            return self._guard.call(tanker, lambda: _all_checked(assign(request), request)) or {}
        chosen = self._guard.call(tanker, lambda: _checked(self._policy.choose(request), request))
        return {} if chosen is None else {tanker: chosen}

    def pop_faults(self) -> list[PluginFault]:
        return self._guard.pop_faults()


def _all_checked(answer: Any, request: RefuellingRequest) -> dict[int, int]:
    """The answer as receivers by tanker. Raises Nonsense."""
    if not isinstance(answer, Mapping):
        raise Nonsense(f"returned {type(answer).__name__}, which is no mapping from tankers to receivers")
    found = {}
    for tanker, receiver in answer.items():
        free = _named(tanker, request.free_tankers)
        if free is None:
            raise Nonsense(f"returned {shown(tanker)}, which is no free tanker's system id")
        checked = _checked(receiver, request)
        if checked is not None:
            found[free] = checked
    if len(set(found.values())) < len(found):
        raise Nonsense("gave one vehicle to two tankers")
    return found


def _checked(answer: Any, request: RefuellingRequest) -> int | None:
    """The answer as a system id or None. Raises Nonsense."""
    if answer is None:
        return None
    found = _named(answer, request.candidates)
    if found is None:
        raise Nonsense(f"returned {shown(answer)}, which is no candidate's system id")
    return found


def _named(answer: Any, views: Iterable[VehicleView]) -> int | None:
    """System id of the vehicle that is meant by a number; True is no number, though it equals 1."""
    number = plain(answer)
    if isinstance(number, bool) or not isinstance(number, Real):
        return None
    return next((view.sysid for view in views if view.sysid == number), None)


class _Stateless:
    """Keeps nothing of the scenario."""

    def __init__(self, scenario: Scenario) -> None:
        pass


class _Assigning(_Stateless):
    """Chooses for all free tankers at once."""

    def assign(self, request: RefuellingRequest) -> dict[int, int]:
        """Receiver by free tanker."""
        raise NotImplementedError

    def choose(self, request: RefuellingRequest) -> int | None:
        """This tanker's of them."""
        return self.assign(request).get(request.tanker.sysid)


class GreedyNearest(_Stateless):
    """The candidate nearest to the tanker."""

    def choose(self, request: RefuellingRequest) -> int | None:
        """The nearest; of equals the lowest system id."""
        here = request.tanker.p_now_ned()
        return min(request.candidates, key=lambda view: (elementary.distance(here, view.p_now_ned()), view.sysid)).sysid


class MostEmptyFirst(_Stateless):
    """The candidate with the smallest share of its battery left."""

    def choose(self, request: RefuellingRequest) -> int | None:
        """The neediest; of equals the lowest system id."""
        return min(request.candidates, key=lambda view: (-view.need, view.sysid)).sysid


class Optimal(_Assigning):
    """Plans all services of all tankers ahead, for vehicles that want energy or soon will, and flies the first
    (skytender/rolling_horizon.py) [choice]."""

    def __init__(self, scenario: Scenario) -> None:
        self._need_from = scenario.competition.need_from

    def assign(self, request: RefuellingRequest) -> dict[int, int]:
        """Receiver by free tanker: the first ones of the best plan, matched by the least time."""
        views = in_order_of_landing((*request.candidates, *request.later), request.rules)
        free = _free(request)
        waiting = {view.sysid for view in request.candidates}
        winners = list(request.candidates)
        if len(winners) > len(free):
            assert request.times is not None
            best = plan_services(
                views,
                waiting,
                request.givers,
                request.times,
                request.rules,
                need_from=self._need_from,
                left_s=request.left_s,
            )
            named = [views[i] for i, s in zip(best.first, best.starts_s, strict=True) if i >= 0 and s == 0.0]
            winners = [view for view in named if view.sysid in waiting]
            others = [view for view in views if view.sysid in waiting and view not in winners]
            winners += others[: len(free) - len(winners)]  # vehicles that the plan gives up are better than none
        return _pairs(match(free, winners))


def in_order_of_landing(views: Iterable[VehicleView], rules: RefuellingRules) -> list[VehicleView]:
    """Vehicles, the first to land first."""
    return sorted(views, key=lambda view: (lasts_s(view, rules.lands_at), view.sysid))


class EarliestDeadline(_Assigning):
    """The first vehicles to land, matched to the free tankers by the least time (earliest deadline first)."""

    def assign(self, request: RefuellingRequest) -> dict[int, int]:
        """Receiver by free tanker."""
        free = _free(request)
        return _pairs(match(free, in_order_of_landing(request.candidates, request.rules)[: len(free)]))


class Hungarian(_Assigning):
    """Tankers and candidates paired so that the sum of the ways' times is least; what would not last `reserve_s` beyond
    the way comes before all that would."""

    def assign(self, request: RefuellingRequest) -> dict[int, int]:
        """Receiver by free tanker."""
        free, lands_at = _free(request), request.rules.lands_at
        cost_s = np.array([[giver.way_s(view) for view in request.candidates] for giver in free])
        left_s = np.array([min(lasts_s(view, lands_at), LONGEST_S) for view in request.candidates])
        cost_s[:, left_s - cost_s.min(axis=0) < request.rules.reserve_s] -= LONGEST_S
        rows, columns = least_cost(cost_s)
        return {int(free[i].name): request.candidates[j].sysid for i, j in zip(rows, columns, strict=True)}


class Auction(_Assigning):
    """Tankers bid for candidates: worth most is the one that lands soonest and is near, a second of the one for a
    second of the other."""

    def assign(self, request: RefuellingRequest) -> dict[int, int]:
        """Receiver by free tanker."""
        free, views, lands_at = _free(request), request.candidates, request.rules.lands_at
        if len(free) >= len(views):
            return _pairs(match(free, views))
        left_s = np.array([min(lasts_s(view, lands_at), LONGEST_S) for view in views])
        won = auction([[-giver.way_s(view) for view in views] - left_s for giver in free], AUCTION_S)
        return {int(giver.name): views[j].sysid for giver, j in zip(free, won, strict=True)}


def auction(benefit: ArrayLike, epsilon: float) -> NDArray[np.int64]:
    """Object (m,) of each of m bidders for benefit (m, n), m <= n, finite; the sum is within m·epsilon of the greatest
    (D. P. Bertsekas, Annals of Operations Research 14, 1988).

    Every bidder without an object bids for the one that is worth most to it at the present prices, and raises its price
    by what it prefers it to the second best, and epsilon; its previous holder is without one again.
    """
    worth = np.asarray(benefit, dtype=np.float64)
    bidders, objects = worth.shape
    if bidders > objects:
        raise ValueError(f"auction: {bidders} bidders for {objects} objects; there must be at least as many objects")
    price, holder, held = np.zeros(objects), np.full(objects, -1), np.full(bidders, -1)
    without = list(range(bidders))
    while without:
        bidder = without.pop()
        net = worth[bidder] - price
        best = int(net.argmax())
        second = float(np.delete(net, best).max()) if objects > 1 else float(net[best])
        price[best] += float(net[best]) - second + epsilon
        if holder[best] >= 0:
            held[holder[best]] = -1
            without.append(int(holder[best]))
        holder[best], held[bidder] = bidder, best
    return held


def _free(request: RefuellingRequest) -> list[Giver]:
    return [giver for giver in request.givers if giver.free_in_s == 0.0]


def _pairs(matched: Iterable[tuple[Giver, VehicleView]]) -> dict[int, int]:
    return {int(giver.name): view.sysid for giver, view in matched}


SHIPPED: dict[str, Callable[[Scenario], RefuellingPolicy]] = {
    "greedy_nearest": GreedyNearest,
    "most_empty_first": MostEmptyFirst,
    OPTIMAL: Optimal,
    "earliest_deadline": EarliestDeadline,
    "hungarian": Hungarian,
    "auction": Auction,
}
