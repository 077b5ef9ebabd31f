"""Givers of energy, tankers and bases alike: when each is free, and how long a vehicle's way to it takes.

How long services take beside the way is learnt in the session: the time from the decision to the first joule is fitted
by least squares as a + b · way, and what passes between the last joule and the end is averaged
(docs/model/competition.md#service-times) [choice].
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gcs.refuelling.service import Phase, Service
from gcs.refuelling.target_assignment import meeting_s, way
from gcs.scenario.model import RefuellingRules
from gcs.telemetry.state import Vec3, VehicleView
from skytender import elementary
from skytender.assignment import least_cost

WORTH_J = 500.0
"""A giver with less to spare takes no receiver."""
FloatArray = NDArray[np.float64]

PRIOR_WEIGHT = 4.0
"""As many services as the first guess counts for."""


class Giver(NamedTuple):
    """A tanker, or a base with a place above it; common NED frame."""

    name: int | str
    """system id, or the base's name"""
    p_ned: Vec3
    """where it is when it is free"""
    free_in_s: float
    """0 while it serves no vehicle"""
    speed_m_s: float
    """of the tanker, or of the vehicle that flies to the base"""
    available_j: float
    """what it can spare then"""
    rate_w: float

    @property
    def is_tanker(self) -> bool:
        """Whether it flies to its receiver; a base waits for it."""
        return isinstance(self.name, int)

    def way_s(self, view: VehicleView) -> float:
        """Time until the two are together from when it is free on; the vehicle flies straight on meanwhile."""
        offset = way(self.p_ned, view.p_now_ned())
        straight_s = elementary.norm(offset) / self.speed_m_s
        if not self.is_tanker:
            return straight_s
        met_s = meeting_s(offset, view.v_ned, self.speed_m_s)
        return straight_s if met_s is None else met_s


class ServiceTimes:
    """How long services take, from those that have ended."""

    def __init__(self, start_s: float, per_way: float, end_s: float) -> None:
        """The first guess: a, s; b; and what passes after the last joule, s."""
        ways = np.array([1.0, 5.0])
        weight = 0.5 * PRIOR_WEIGHT
        self._gram = np.zeros((2, 2))
        self._moment = np.zeros(2)
        for way_s in ways:
            row = np.array([1.0, way_s])
            self._gram += weight * np.outer(row, row)
            self._moment += weight * row * (start_s + per_way * way_s)
        self._ends, self._end_sum_s = PRIOR_WEIGHT, PRIOR_WEIGHT * end_s
        self._learnt: set[int] = set()
        self._fit()

    def learn(self, services: Iterable[Service], rate_w: Callable[[Service], float]) -> None:
        """Learn service times from services that have ended regularly.

        rate_w: power at which the giver of a service transfers energy. Time that was lost because a transfer was broken
        off counts as time after the last joule.
        """
        for service in services:
            if service.number in self._learnt or service.phase is not Phase.DONE:
                continue
            self._learnt.add(service.number)
            if service.start_s is None or service.end_s is None or service.meets_in_s is None:
                continue
            begun_s = service.start_s
            if service.breaks:
                begun_s = service.decided_at_s + self.begins_in_s(service.meets_in_s)
            else:
                row = np.array([1.0, service.meets_in_s])
                self._gram += np.outer(row, row)
                self._moment += row * (service.start_s - service.decided_at_s)
            self._ends += 1.0
            self._end_sum_s += max(service.end_s - begun_s - service.energy_j / rate_w(service), 0.0)
            self._fit()

    def _fit(self) -> None:
        (count, ways), (_, squares) = self._gram.tolist()
        starts, products = self._moment.tolist()
        determinant = count * squares - ways * ways  # by hand: LAPACK's last bit is another on another processor
        self.start_s = (starts * squares - products * ways) / determinant
        self.per_way = (count * products - ways * starts) / determinant
        self.end_s = self._end_sum_s / self._ends

    def begins_in_s(self, way_s: float) -> float:
        """From the decision to the first joule."""
        return max(self.start_s + self.per_way * way_s, 0.0)

    def flows_s(self, missing_j: float, power_w: float, rate_w: float) -> float:
        """How long energy flows until what is missing has come, while the receiver draws."""
        return max(missing_j, 0.0) / max(rate_w - power_w, 0.1 * rate_w)

    def left_s(self, service: Service, receiver: VehicleView, until: float, rate_w: float, now_s: float) -> float:
        """How long a service that has been decided still takes."""
        missing_j = until * receiver.capacity_j - receiver.remaining_j
        flow_s = self.flows_s(missing_j, receiver.power_w, rate_w)
        if service.phase in (Phase.JOIN, Phase.LAND, Phase.START_RECEIVER, Phase.START_GIVER):
            begins_s = self.begins_in_s(service.meets_in_s or 0.0) - (now_s - service.decided_at_s)
            return max(begins_s, 0.5) + flow_s + self.end_s
        if service.phase is Phase.TRANSFER:
            return flow_s + self.end_s
        return max(self.end_s - (now_s - service.phase_since_s), 0.0)


def match(givers: Sequence[Giver], receivers: Sequence[VehicleView]) -> list[tuple[Giver, VehicleView]]:
    """Pairs, as many as there can be, of which the sum of the ways' times is least (H. W. Kuhn, Naval Research
    Logistics Quarterly 2, 1955); in the givers' order.

    Of equal sums the one that `least_cost` names, which depends on nothing but the numbers.
    """
    if not givers or not receivers:
        return []
    cost_s = np.array([[giver.way_s(view) for view in receivers] for giver in givers])
    rows, columns = least_cost(cost_s)
    return [(givers[i], receivers[j]) for i, j in zip(rows, columns, strict=True)]


def nearest_s(givers: Sequence[Giver], view: VehicleView, times: ServiceTimes) -> float:
    """Time until energy can flow into a vehicle, from the giver that is with it first; inf where there is none."""
    place = view.p_now_ned()
    ways = (g.free_in_s + times.begins_in_s(elementary.distance(g.p_ned, place) / g.speed_m_s) for g in givers)
    return min(ways, default=math.inf)


def lasts_s(view: VehicleView, lands_at: float) -> float:
    """Time until a vehicle lands by itself at its present draw, s."""
    left_j = max(view.remaining_j - lands_at * view.capacity_j, 0.0)
    return left_j / view.power_w if view.power_w > 0.0 else math.inf


def ways_s(givers: Sequence[Giver], views: Sequence[VehicleView]) -> list[float]:
    """Time that the way to each vehicle takes the nearest of those givers that are free first, s; 0 without any."""
    soonest_s = min((giver.free_in_s for giver in givers), default=0.0)
    first = [giver for giver in givers if giver.free_in_s == soonest_s]
    return [min((elementary.distance(g.p_ned, v.p_now_ned()) / g.speed_m_s for g in first), default=0.0) for v in views]


def served_if_passed_over_s(
    givers: Sequence[Giver], views: Sequence[VehicleView], times: ServiceTimes, rules: RefuellingRules
) -> FloatArray:
    """(n,) time until energy could flow into each of n vehicles if another of them were served first by the giver that
    is free first, any of the others as likely; a giver that is free later may take it before any other. Without givers,
    or for one alone, the time until it is served at all."""
    n = len(views)
    if not givers or n < 2:
        return np.array([nearest_s(givers, view, times) if givers else 0.0 for view in views])
    at = np.array([view.p_now_ned() for view in views])
    free_s = np.array([giver.free_in_s for giver in givers])
    speed_m_s = np.array([giver.speed_m_s for giver in givers])
    away_m = np.linalg.norm(np.array([giver.p_ned for giver in givers])[:, None] - at, axis=2)
    begins_s = free_s[:, None] + times.start_s + times.per_way * away_m / speed_m_s[:, None]
    apart_m = np.linalg.norm(at[:, None] - at, axis=2)
    missing_j = np.array([rules.until * view.capacity_j - view.remaining_j for view in views])
    power_w = np.array([view.power_w for view in views])
    found = np.full(n, math.inf)
    for g, giver in enumerate(givers):
        if free_s[g] > free_s.min():
            found = np.minimum(found, begins_s[g])
            continue
        net_w = np.maximum(giver.rate_w - power_w, 0.1 * giver.rate_w)
        ends_s = begins_s[g] + np.maximum(missing_j + power_w * begins_s[g], 0.0) / net_w + times.end_s
        after_s = ends_s[:, None] + times.start_s + times.per_way * apart_m / speed_m_s[g]
        np.fill_diagonal(after_s, 0.0)
        found = np.minimum(found, after_s.sum(axis=0) / (n - 1))
    return found
