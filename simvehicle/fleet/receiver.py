"""A receiver's side of a service that it arranges itself: docs/protocol/onboard.md#competition-on-board.

    call → meet → start giver → transfer → stop giver → catch up → done
             ▲                                  │ broken off (at most 5 times)
             └──────────────────────────────────┘

The winner calls a tanker, waits for it, and commands the transfer of both sides by the same order that a ground station
gives. Time is an argument; what the tanker is sent waits in `orders`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from enum import Enum, auto
from typing import NamedTuple

from simvehicle.autopilot.energy_transfer import TransferOrder, TransferSide, refusal
from simvehicle.autopilot.modes import STEERED, Severity
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.competition import FleetAward
from simvehicle.fleet.peers import DecidedBy, PeerReport, PeerStage
from simvehicle.fleet.rules import FleetRules
from simvehicle.fleet.settlement import ReceiverSettlement

CALL_WITHIN_S = 3.0
"""A tanker that has not answered a call for so long is not called by this vehicle for as long again."""
MEET_WITHIN_S = 60.0
SILENT_S = 5.0
"""A tanker that has been silent for so long is waited for no more."""
ANSWER_WITHIN_S = 5.0
REPEAT_S = 0.5
CATCH_UP_S = 1.0
BREAKS = 5
BEGINS_WITHIN_S = 2.0
"""[choice] What it draws in so long before its first joule is ordered too."""
LEAST_NET_SHARE = 0.1


class ReceiverPhase(Enum):
    """Phase of the service."""

    NONE = auto()
    CALL = auto()
    MEET = auto()
    START = auto()
    TRANSFER = auto()
    STOP = auto()
    CATCH_UP = auto()


_STAGES = {
    ReceiverPhase.NONE: PeerStage.APART,
    ReceiverPhase.CALL: PeerStage.CALLS,
    ReceiverPhase.MEET: PeerStage.MEETS,
}


class OrderToPeer(NamedTuple):
    """A transfer order for another vehicle."""

    sysid: int
    order: TransferOrder


class Receiver:
    """A vehicle that can be refuelled."""

    def __init__(self, vehicle: Vehicle, sysid: int, rules: FleetRules) -> None:
        self._vehicle = vehicle
        self._sysid = sysid
        self._rules = rules
        self.phase = ReceiverPhase.NONE
        self.tanker = 0
        self.by = DecidedBy.NONE
        self.since_s = 0.0
        self.orders: list[OrderToPeer] = []
        self.refused_calls = 0
        """calls that a tanker has answered with another receiver: double claims that were lost"""
        self._blocked_s: dict[int, float] = {}
        self._phase_since_s = 0.0
        self._received_s = 0.0
        self._near_since_s: float | None = None
        self._refused = False
        self._asked_s = -math.inf
        self._order: TransferOrder | None = None
        self._number = 0
        self._in_at_start_j = 0
        self._in_at_call_j = 0
        self._breaks = 0
        self._again = False
        self._settlement = ReceiverSettlement()

    @property
    def stage(self) -> PeerStage:
        """The stage in this vehicle's report."""
        return _STAGES.get(self.phase, PeerStage.TRANSFERS)

    def blocked(self, tanker: int, now_s: float) -> bool:
        """Whether a tanker has lately not answered."""
        return now_s < self._blocked_s.get(tanker, -math.inf)

    def call(self, won: FleetAward, now_s: float) -> None:
        """Call the tanker that was won."""
        self.tanker, self.by, self.since_s, self._breaks = won.tanker, won.by, now_s, 0
        self._in_at_call_j = self._vehicle.received_j
        self._go(ReceiverPhase.CALL, now_s)
        self._vehicle.announce(Severity.INFO, f"Calls tanker {won.tanker}: {won.by.name.lower()}")

    def receive_answer(self, sysid: int, accepted: bool) -> None:
        """An acknowledgement of an order. Only a refusal counts: that energy flows, or does so no more, is what the
        tanker's reports say."""
        self._refused |= sysid == self.tanker and not accepted
        self._settlement.receive_answer(sysid, accepted)

    def step(self, now_s: float, peers: Mapping[int, PeerReport]) -> None:
        """Move the service to a time."""
        self.orders += [OrderToPeer(*ask) for ask in self._settlement.due(now_s, peers)]
        if self.phase is ReceiverPhase.NONE:
            return
        tanker = peers.get(self.tanker)
        if tanker is not None:
            self._received_s = now_s
            if tanker.time_s <= self._phase_since_s:
                tanker = None  # what it said before this phase began decides nothing in it
        if self._vehicle.mode not in STEERED or not self._vehicle.armed:
            self._end(now_s)
        elif self.phase is ReceiverPhase.CALL:
            self._call(now_s, tanker)
        elif now_s - self._received_s > SILENT_S:
            self._end(now_s)
        elif self.phase is ReceiverPhase.MEET:
            self._meet(now_s, tanker)
        elif self.phase is ReceiverPhase.START:
            self._start(now_s, tanker)
        elif self.phase is ReceiverPhase.TRANSFER:
            self._transfer(now_s, tanker)
        elif self.phase is ReceiverPhase.STOP:
            self._stop(now_s, tanker)
        else:
            self._catch_up(now_s, tanker)

    def is_near(self, now_s: float) -> bool:
        """Whether the tanker is where, and as slow as, a transfer needs it."""
        vehicle = self._vehicle
        neighbour = vehicle.exchange.neighbours.get(self.tanker)
        return refusal(neighbour, vehicle.p_ned, now_s, vehicle.envelope()) is None

    def _call(self, now_s: float, tanker: PeerReport | None) -> None:
        if tanker is not None and tanker.partner:
            if tanker.partner == self._sysid:
                self._go(ReceiverPhase.MEET, now_s)
            else:
                self.refused_calls += 1
                self._go(ReceiverPhase.NONE, now_s)
        elif now_s - self.since_s > CALL_WITHIN_S:
            self._blocked_s[self.tanker] = now_s + CALL_WITHIN_S
            self._go(ReceiverPhase.NONE, now_s)

    def _meet(self, now_s: float, tanker: PeerReport | None) -> None:
        left = tanker is not None and tanker.partner != self._sysid
        if left or now_s - self._phase_since_s > MEET_WITHIN_S:
            self._end(now_s)
            return
        if not self.is_near(now_s):
            self._near_since_s = None
        elif self._near_since_s is None:
            self._near_since_s = now_s
        held = self._near_since_s is not None and now_s - self._near_since_s >= self._rules.hold_s
        held &= now_s < self._rules.transfers_until_s
        if not held or tanker is None or tanker.stage is not PeerStage.MEETS:
            return
        self._number += 1
        limit_j = float(math.floor(self._limit_j(tanker)))
        order = TransferOrder(
            self.tanker,
            TransferSide.RECEIVE,
            limit_j,
            self._rules.rate_w,
            1000 * self._sysid + self._number % 1000,
            tanker.given_j,
        )
        self._in_at_start_j = self._vehicle.received_j
        if self._vehicle.order(order) is not None:
            self._near_since_s = None
            return
        self._order = order
        self._go(ReceiverPhase.START, now_s)
        self._ask(now_s, TransferSide.GIVE)

    def _limit_j(self, tanker: PeerReport) -> float:
        vehicle, rules = self._vehicle, self._rules
        room_j = vehicle.capacity_j - vehicle.remaining_j
        if rules.tops_up:
            net_w = max(rules.rate_w - vehicle.power_w, LEAST_NET_SHARE * rules.rate_w)
            room_j += vehicle.power_w * (BEGINS_WITHIN_S + room_j / net_w)
        left_j = math.inf if rules.limit_j is None else rules.limit_j - (vehicle.received_j - self._in_at_call_j)
        return max(min(room_j, left_j, tanker.remaining_j), 1.0)

    def _start(self, now_s: float, tanker: PeerReport | None) -> None:
        if tanker is not None and tanker.stage is PeerStage.TRANSFERS:
            self._go(ReceiverPhase.TRANSFER, now_s)
        elif self._refused or now_s - self._phase_since_s > ANSWER_WITHIN_S or self._vehicle.transfer is None:
            self._break_off(now_s)
        else:
            self._ask(now_s, TransferSide.GIVE)

    def _transfer(self, now_s: float, tanker: PeerReport | None) -> None:
        vehicle, rules = self._vehicle, self._rules
        received_j = vehicle.received_j - self._in_at_call_j
        settled = tanker is not None and tanker.time_s > self._phase_since_s + REPEAT_S
        limited = rules.limit_j is not None and received_j >= rules.limit_j
        ends = now_s >= rules.transfers_until_s
        if ends or limited or vehicle.remaining_j >= rules.until * vehicle.capacity_j:
            self._go(ReceiverPhase.STOP, now_s)
        elif vehicle.transfer is None:
            self._break_off(now_s)
        elif settled and tanker is not None and tanker.stage is not PeerStage.TRANSFERS:
            self._go(ReceiverPhase.CATCH_UP, now_s)
            self._catch_up(now_s, tanker)

    def _break_off(self, now_s: float) -> None:
        self._breaks += 1
        self._again = self._breaks < BREAKS
        self._go(ReceiverPhase.STOP, now_s)

    def _stop(self, now_s: float, tanker: PeerReport | None) -> None:
        stopped = tanker is not None and tanker.stage is not PeerStage.TRANSFERS
        if stopped or now_s - self._phase_since_s > ANSWER_WITHIN_S:
            self._go(ReceiverPhase.CATCH_UP, now_s)
            self._catch_up(now_s, tanker)
        else:
            self._ask(now_s, TransferSide.STOP)

    def _catch_up(self, now_s: float, tanker: PeerReport | None) -> None:
        assert self._order is not None
        caught_up = (
            tanker is not None
            and self._vehicle.received_j - self._in_at_start_j >= tanker.given_j - self._order.giver_start_j
        )
        if caught_up or self._vehicle.transfer is None or now_s - self._phase_since_s >= CATCH_UP_S:
            again, self._again = self._again, False
            self._stop_own(now_s)
            self._go(ReceiverPhase.MEET if again else ReceiverPhase.NONE, now_s)

    def _ask(self, now_s: float, role: TransferSide) -> None:
        """Send the tanker its order, again and again until it answers."""
        assert self._order is not None
        if now_s - self._asked_s < REPEAT_S:
            return
        self._asked_s = now_s
        self.orders.append(OrderToPeer(self.tanker, replace(self._order, partner=self._sysid, role=role)))

    def _stop_own(self, now_s: float) -> None:
        """End the own side of a transfer, however the other side ended; what it credited is known for good."""
        self._vehicle.end_transfer("stopped")
        if self._order is not None:
            credited_j = self._vehicle.received_j - self._in_at_start_j
            self._settlement.add(self.tanker, replace(self._order, partner=self._sysid), credited_j, now_s)
            self._order = None

    def _end(self, now_s: float) -> None:
        """Give the service up; the tanker sees it by the next reports."""
        self._stop_own(now_s)
        self._again = False
        self._go(ReceiverPhase.NONE, now_s)

    def _go(self, phase: ReceiverPhase, now_s: float) -> None:
        self.phase, self._phase_since_s, self._received_s = phase, now_s, now_s
        self._refused, self._asked_s, self._near_since_s = False, -math.inf, None
        if phase is ReceiverPhase.NONE:
            self.tanker = 0
