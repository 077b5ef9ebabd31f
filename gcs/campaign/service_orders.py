"""Whether some order of services keeps every vehicle: a search over all orders, depth first, by estimated service times
(docs/model/competition.md#service-orders) [choice].

Tankers obey the same rules as under the policies: a free one takes one of the vehicles that want energy, or waits for
the first that will. A branch is cut off where a vehicle would land unserved in any case. After MOST_NODES the search
ends without a result.
Times in s from the session's start, energies in J above the charge at which a vehicle lands.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

from gcs.refuelling.giver import WORTH_J
from gcs.refuelling.scheduler import TANKER_TIMES
from gcs.scenario.model import Scenario
from skytender import elementary

MOST_NODES = 200_000
EARLY_S = 0.5
"""A service must begin so long before its receiver lands: times are estimates, batteries are reported to 100 J."""

_T = TypeVar("_T")
Place = tuple[float, float, float]
State = tuple[tuple[float, ...], tuple[Place, ...], tuple[float, ...], tuple[float, ...]]
"""When each tanker is free, and where; what it can still give; when each vehicle lands."""


@dataclass(frozen=True)
class _Receiver:
    place: Place
    power_w: float
    full_j: float
    wants_s: float
    """so long before it lands it wants energy"""


class _Search:
    def __init__(self, scenario: Scenario) -> None:
        rules, need_from = scenario.refuelling, scenario.competition.need_from
        self.end_s, self.rate_w = scenario.goal.duration_s, rules.rate_w
        self.start_s, self.per_way, self.ends_s = TANKER_TIMES
        self.speed = [tanker.speed_m_s for tanker in scenario.vehicles.tankers]
        self.receivers, lands = [], []
        for pursuer in scenario.vehicles.pursuers:
            battery, power_w = pursuer.battery, pursuer.battery.hover_w + pursuer.battery.avionics_w
            least_j = rules.lands_at * battery.capacity_j
            n, e, d = pursuer.start_m
            wants_j = (1.0 - need_from) * battery.capacity_j - least_j
            full_j = rules.until * battery.capacity_j - least_j
            self.receivers.append(_Receiver((n, e, d - rules.height_m), power_w, full_j, wants_j / power_w))
            lands.append((0.01 * battery.initial_percent * battery.capacity_j - least_j) / power_w)
        tankers = scenario.vehicles.tankers
        spare = [0.01 * t.battery.initial_percent * t.battery.capacity_j - t.reserve_j for t in tankers]
        self.first: State = ((0.0,) * len(tankers), tuple(t.start_m for t in tankers), tuple(spare), tuple(lands))
        self.nodes = 0

    def keeps_all(self, state: State) -> bool:
        """Whether everyone can be kept from here on; False also once the search has been cut off."""
        free, places, spare, lands = state
        if min(lands) >= self.end_s:
            return True
        self.nodes += 1
        if self.nodes > MOST_NODES:
            return False
        j = min((k for k in range(len(free)) if spare[k] >= WORTH_J), key=lambda k: free[k], default=None)
        if j is None or min(lands) < free[j] + self.start_s + EARLY_S:
            return False
        wants = [land - one.wants_s for land, one in zip(lands, self.receivers, strict=True)]
        now = max(free[j], min(wants))
        for i in sorted(range(len(lands)), key=lambda k: lands[k]):
            if wants[i] > now + 1e-9:
                continue
            one = self.receivers[i]
            begins = now + self.start_s + self.per_way * elementary.distance(places[j], one.place) / self.speed[j]
            if begins > lands[i] - EARLY_S:
                continue
            missing_j = one.full_j - (lands[i] - begins) * one.power_w
            flows_s = min(max(missing_j, 0.0) / (self.rate_w - one.power_w), spare[j] / self.rate_w)
            gained_s = flows_s * self.rate_w / one.power_w
            after = (
                _with(free, j, max(begins + flows_s + self.ends_s, now + 1.0)),
                _with(places, j, one.place),
                _with(spare, j, spare[j] - flows_s * self.rate_w),
                _with(lands, i, lands[i] + gained_s),
            )
            if self.keeps_all(after):
                return True
        return False


def tankers_alone_serve(scenario: Scenario) -> bool:
    """Whether tankers serve pursuers, all from the start and none at bases, as bounds and searches over tankers take
    it."""
    vehicles = scenario.vehicles
    late = any(vehicle.join_s > 0.0 for vehicle in (*vehicles.pursuers, *vehicles.tankers))
    return bool(vehicles.pursuers and vehicles.tankers) and not scenario.bases and not late


def some_order_keeps_all(scenario: Scenario) -> bool | None:
    """Whether the search found an order that keeps every pursuer until the end; None where it was cut off before it
    had seen all, where not tankers alone serve, all from the start, or where they give less than vehicles draw."""
    if not tankers_alone_serve(scenario):
        return None
    search = _Search(scenario)
    if search.rate_w <= max(one.power_w for one in search.receivers):
        return None
    if search.keeps_all(search.first):
        return True
    return None if search.nodes > MOST_NODES else False


def _with(values: tuple[_T, ...], at: int, value: _T) -> tuple[_T, ...]:
    return (*values[:at], value, *values[at + 1 :])
