"""Receiver policies other than the competition: nearest, most empty, optimal, or a user's own class.

    class MyPolicy:
        def __init__(self, scenario): ...
        def choose(self, request): return a system id, or None for none now

A scenario names one: `competition: {policy: greedy_nearest | most_empty_first | optimal | MODULE:CLASS}`. Whatever the
policy, a vehicle that would not last until a rendezvous goes first (docs/protocol.md#refuelling-schedule).
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from gcs.scenario.model import RefuellingRules, Scenario
from gcs.telemetry.state import VehicleView

WINNER_TAKE_ALL = "winner_take_all"
MOST_PLANNED = 6
"""Vehicles whose every order is tried: 6! = 720 orders, times the ways to share them among the free tankers."""


@dataclass(frozen=True, slots=True)
class RefuellingRequest:
    """A tanker is free and at least one vehicle wants energy."""

    time_s: float
    tanker: VehicleView
    candidates: tuple[VehicleView, ...]
    """who may be served, in order of system id: in the air, below `competition.need_from`, not yet being served"""
    free_tankers: tuple[VehicleView, ...]
    """`tanker` first, and all that are free beside it"""
    speed_m_s: Mapping[int, float]
    """by tanker"""
    rules: RefuellingRules


class RefuellingPolicy(Protocol):
    """One-method protocol; made once, as CLASS(scenario)."""

    def choose(self, request: RefuellingRequest) -> int | None:
        """The candidate whom request.tanker is to serve, by system id; None: none, ask again in the next tick."""


class GreedyNearest:
    """The candidate nearest to the tanker."""

    def __init__(self, scenario: Scenario) -> None:
        pass

    def choose(self, request: RefuellingRequest) -> int | None:
        """The nearest; of equals the lowest system id."""
        here = request.tanker.p_now_ned()
        return min(request.candidates, key=lambda view: (math.dist(here, view.p_now_ned()), view.sysid)).sysid


class MostEmptyFirst:
    """The candidate with the smallest share of its battery left."""

    def __init__(self, scenario: Scenario) -> None:
        pass

    def choose(self, request: RefuellingRequest) -> int | None:
        """The neediest; of equals the lowest system id."""
        return min(request.candidates, key=lambda view: (-view.need, view.sysid)).sysid


class Optimal:
    """The first step of the best of all orders, for small fleets [choice].

    Best is the order in which the vehicle that comes nearest to empty before its turn still has most endurance left;
    of equals the one that is done first, then the one that comes first by system ids. A service takes the way from the
    last receiver, `hold_s`, and what is missing up to `until` at `rate_w`; vehicles are taken to stay where they are.
    Of more than MOST_PLANNED candidates those with the least endurance are ordered.
    """

    def __init__(self, scenario: Scenario) -> None:
        pass

    def choose(self, request: RefuellingRequest) -> int | None:
        """This tanker's first receiver in the best plan; None where the best plan leaves them to another free one."""
        planned = sorted(request.candidates, key=lambda view: (view.endurance_s, view.sysid))[:MOST_PLANNED]
        best: tuple[tuple[float, float, list[list[int]]], int | None] | None = None
        for order in itertools.permutations(sorted(planned, key=lambda view: view.sysid)):
            for queues in _shares(order, len(request.free_tankers)):
                margin_s, done_s = self._worth(request, queues)
                rank = (-margin_s, done_s, [[view.sysid for view in queue] for queue in queues])
                if best is None or rank < best[0]:
                    best = rank, queues[0][0].sysid if queues[0] else None
        return None if best is None else best[1]

    @staticmethod
    def _worth(request: RefuellingRequest, queues: Sequence[Sequence[VehicleView]]) -> tuple[float, float]:
        """(least endurance left at the begin of a service, time until the last is done), s."""
        margin_s, done_s = math.inf, 0.0
        for tanker, queue in zip(request.free_tankers, queues, strict=True):
            here, time_s = tanker.p_now_ned(), 0.0
            for view in queue:
                there = view.p_now_ned()
                time_s += math.dist(here, there) / request.speed_m_s[tanker.sysid] + request.rules.hold_s
                margin_s = min(margin_s, view.endurance_s - time_s)
                missing_j = request.rules.until * view.capacity_j - view.remaining_j + view.power_w * time_s
                time_s += max(missing_j, 0.0) / request.rules.rate_w
                here = there
            done_s = max(done_s, time_s)
        return margin_s, done_s


def _shares(order: Sequence[VehicleView], queues: int) -> Iterator[list[Sequence[VehicleView]]]:
    """Every way to cut an order into so many queues, empty ones too."""
    for cuts in itertools.combinations_with_replacement(range(len(order) + 1), queues - 1):
        edges = [0, *cuts, len(order)]
        yield [order[a:b] for a, b in itertools.pairwise(edges)]


SHIPPED: dict[str, Callable[[Scenario], RefuellingPolicy]] = {
    "greedy_nearest": GreedyNearest,
    "most_empty_first": MostEmptyFirst,
    "optimal": Optimal,
}
