"""Transfers that end before their receivers are full, because vehicles that wait would be lost meanwhile
(docs/model/competition.md#early-ends) [choice].

All services of all givers are planned twice: as though the transfer went on until its receiver is full, and as though
it ended now. It ends where the second plan costs less.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from gcs.refuelling.giver import Giver, ServiceTimes
from gcs.refuelling.service import Phase, Service
from gcs.refuelling.service_plan import plan_services
from gcs.scenario.model import RefuellingRules
from gcs.telemetry.state import VehicleView
from skytender.service_plan import AGAIN_S

WORTH = 0.5
"""[choice] What the plan that ends a transfer must cost less: 1.6 times the probability that all vehicles are kept."""
SOONEST_S = 0.1
"""A tanker is free no sooner."""
_ROUNDING_S = 1e-6


class EarlyEnds:
    """When each transfer was planned for."""

    def __init__(self, rules: RefuellingRules, need_from: float, end_s: float) -> None:
        """`need_from`: need from which a vehicle waits. `end_s`: session time at which the session ends."""
        self._rules, self._need_from, self._end_s = rules, need_from, end_s
        self._planned_s: dict[int, float] = {}

    def due(self, service: Service, now_s: float) -> bool:
        """Whether a service is to be planned for now: a transfer by a tanker that no operator asked for, each
        AGAIN_S."""
        if service.phase is not Phase.TRANSFER or service.tanker is None or service.by == "operator":
            return False
        last_s = self._planned_s.get(service.number)
        return last_s is None or now_s - last_s >= AGAIN_S - _ROUNDING_S

    def ends(
        self,
        service: Service,
        receiver: VehicleView,
        others: Sequence[VehicleView],
        waiting: Collection[int],
        givers: Sequence[Giver],
        times: ServiceTimes,
        now_s: float,
    ) -> bool:
        """Whether a transfer is to end at `now_s`.

        others: vehicles without a giver. waiting: system ids of the others that want energy. givers: all givers, with
        the one of this transfer.
        """
        self._planned_s[service.number] = now_s
        giver = next((one for one in givers if one.name == service.tanker), None)
        if giver is None or not waiting:
            return False
        missing_j = max(self._rules.until * receiver.capacity_j - receiver.remaining_j, 0.0)
        flows_s = max(giver.free_in_s - times.end_s, 0.0)
        full = receiver._replace(received_j=receiver.received_j + round(missing_j + receiver.power_w * flows_s))
        free = giver._replace(free_in_s=max(times.end_s, SOONEST_S), available_j=giver.available_j + missing_j)
        wanting = {*waiting, receiver.sysid} if receiver.need >= self._need_from else waiting
        freed = [free if one is giver else one for one in givers]
        goes_on = self._cost([*others, full], waiting, givers, times, now_s)
        if goes_on <= WORTH:  # no plan costs less than nothing
            return False
        return self._cost([*others, receiver], wanting, freed, times, now_s) < goes_on - WORTH

    def _cost(
        self,
        views: Sequence[VehicleView],
        waiting: Collection[int],
        givers: Sequence[Giver],
        times: ServiceTimes,
        now_s: float,
    ) -> float:
        left_s = max(self._end_s - now_s, 0.0)
        return plan_services(views, waiting, givers, times, self._rules, need_from=self._need_from, left_s=left_s).cost
