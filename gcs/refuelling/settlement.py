"""Joules that were on the way when a transfer ended: they come back to their giver
(docs/protocol/energy.md#settlement).

A transfer over a slow or bad radio ends with more given than credited. Once both sides have ended it and have reported
their counters since, what is missing is known for good, and the tanker is ordered to take it back; a base's books are
the supervisor's own. Until then neither side begins another transfer, so that a counter means one transfer only.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from gcs.mavlink.autopilots import FlightMode
from gcs.refuelling.service import Phase, Service, ServiceRequests, TransferRole, token
from gcs.scenario.faults import RADIO
from gcs.scenario.model import RefuellingRules, Scenario
from gcs.scenario.parts.radio import PERFECT
from gcs.telemetry.state import FleetSnapshot, VehicleView

WAIT_S = 10.0
"""No next transfer waits for longer."""
ASK_AGAIN_S = 5.0
MOST_ASKED = 20
"""A tanker that accepts no order of so many keeps its books as they are."""
SETTLES_S, SETTLES_BY_LOSS_S, SETTLES_WAYS = 3.0, 24.0, 4
"""[choice] How long it takes to stop and settle a transfer, by the share of frames lost and the delay of one way: with
half of all frames lost both stops, both counters and the settlement, each asked for again until answered, took 10 s."""


@dataclass
class EndedTransfer:
    """A transfer that has ended, and what is known for good of both of its ends; J."""

    service: Service
    out_at_start_j: int
    in_at_start_j: int
    since_s: float
    """no counter rises after that"""
    given_j: int | None = None
    credited_j: int | None = None
    take_back: Callable[[int], None] | None = None
    """for a base: books what comes back"""
    asked: int = 0
    asked_s: float = 0.0

    @property
    def what(self) -> str:
        """Name of its order in the token by which the result is known."""
        return f"settle {self.out_at_start_j}"

    @property
    def missing_j(self) -> int | None:
        """Given and never credited; None while that is not known for good."""
        return None if self.given_j is None or self.credited_j is None else self.given_j - self.credited_j


class Settlement:
    """Transfers of a session that have ended and are not settled yet."""

    def __init__(self, requests: ServiceRequests) -> None:
        self._requests = requests
        self._open: list[EndedTransfer] = []

    def add(self, ended: EndedTransfer) -> None:
        """A transfer has just ended: both sides were ordered to stop, and have acknowledged or been waited for."""
        self._open.append(ended)

    def awaits(self, sysid: int, now_s: float) -> bool:
        """Whether a vehicle's counter still belongs to an earlier transfer, for a while."""
        return any(_unknown(one, sysid) and now_s - one.since_s < WAIT_S for one in self._open)

    def begin(self, sysid: int) -> None:
        """A vehicle begins another transfer: what is not known of its earlier ones by now never will be."""
        self._open = [one for one in self._open if not _unknown(one, sysid)]

    def settle(self, snapshot: FleetSnapshot) -> None:
        """Take in what is known by now, and let tankers take back what has not arrived."""
        self._open = [one for one in self._open if not self._settled(one, snapshot)]

    def _settled(self, one: EndedTransfer, snapshot: FleetSnapshot) -> bool:
        service = one.service
        receiver = snapshot.vehicle(service.receiver)
        tanker = None if service.tanker is None else snapshot.vehicle(service.tanker)
        if (tanker is not None and not tanker.alive) or (not receiver.alive and one.credited_j is None):
            return True
        gave = tanker is not None and one.given_j is None and _has_ended(tanker)
        if tanker is not None and gave and tanker.given_reported_s > one.since_s:
            one.given_j = tanker.given_j - one.out_at_start_j
        if one.credited_j is None and _has_ended(receiver) and receiver.received_reported_s > one.since_s:
            one.credited_j = receiver.received_j - one.in_at_start_j
        missing_j = one.missing_j
        if missing_j is None:
            return False
        if missing_j <= 0 or one.asked > MOST_ASKED:
            return True
        if one.take_back is not None:
            one.take_back(missing_j)
        elif not self._requests.accepted(token(service, one.what)):
            if tanker is not None and tanker.fresh:
                self._ask(one, snapshot.time_s)
            return False
        self._requests.records.append({"kind": "settled", **service.sides, "energy_j": missing_j})
        return True

    def _ask(self, one: EndedTransfer, now_s: float) -> None:
        """Order the tanker to take back what its receiver has not credited, unless it was lately."""
        service = one.service
        if service.tanker is None or (one.asked and now_s - one.asked_s <= ASK_AGAIN_S):
            return
        one.asked, one.asked_s = one.asked + 1, now_s
        self._requests.order(
            service,
            service.tanker,
            one.what,
            TransferRole.SETTLE,
            partner=service.receiver,
            limit_j=one.credited_j or 0,
            rate_w=0.0,
            given_at_start_j=one.out_at_start_j,
        )


@dataclass
class ServiceSteps:
    """Common part of the moves of every service from the decision to its end."""

    rules: RefuellingRules
    requests: ServiceRequests
    settlement: Settlement
    out: Mapping[int, str]
    """vehicles that are not served and do not serve, and why; a service of theirs is broken off"""
    until_s: float
    """session time at which transfers are stopped, so that they can be settled before the end"""

    def end(self, service: Service, now_s: float, reason: str) -> None:
        """End a service, and record it."""
        service.phase, service.end_s, service.ended_by = Phase.DONE, now_s, reason
        self.requests.records.append({"kind": "served", "reason": reason, **service.record()})


def _unknown(one: EndedTransfer, sysid: int) -> bool:
    service = one.service
    return (service.tanker == sysid and one.given_j is None) or (service.receiver == sysid and one.credited_j is None)


def _has_ended(view: VehicleView) -> bool:
    """Whether a vehicle is received, and in no transfer."""
    return view.fresh and view.mode is not FlightMode.REFUEL


def transfers_until_s(scenario: Scenario) -> float:
    """Session time at which transfers are stopped, so that they are settled before the end; inf where a transfer cannot
    end with joules on the way, because nothing passes a radio, real or simulated."""
    radio, faults = scenario.radio, [one for one in scenario.faults if one.fault in RADIO]
    if not (scenario.vehicles.external or faults or radio != PERFECT):
        return math.inf
    loss = max([radio.loss, *(one.share or 0.0 for one in faults if one.fault == "loss")])
    late_s = max([radio.delay_s + radio.jitter_s, *(one.delay_s or 0.0 for one in faults)])
    return scenario.goal.duration_s - SETTLES_S - SETTLES_BY_LOSS_S * loss - SETTLES_WAYS * late_s
