"""A tanker's service, step by step: docs/protocol/energy.md#service-by-a-tanker.

    join → start receiver → start giver → transfer → stop giver → catch up → stop receiver → done
      ▲                                      broken off by either side │
      └────────────────────────────────────────────────────────────────┘

Pure but for each service's own memory: a snapshot and the results of earlier commands go in, requests and records come
out as `ServiceRequests`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from gcs.mavlink.autopilots import STEERABLE, FlightMode
from gcs.mavlink.command_protocol import CommandRequest
from gcs.refuelling.service import Phase, Service, TransferRole, token, unfit
from gcs.refuelling.settlement import EndedTransfer, ServiceSteps
from gcs.scenario.model import Tanker
from gcs.telemetry.state import FleetSnapshot, VehicleView
from skytender import elementary
from skytender import mavlink as mav

CATCH_UP_S = 1.0
COUNTER_SETTLES_S = 0.5
"""A giver's counter is trusted as a transfer's start when it was received this long after the last one ended."""
JOIN_WITHIN_S = 60.0
START_WITHIN_S = 5.0
BEGINS_WITHIN_S = 2.0
"""[choice] What a receiver draws in so long before its first joule is ordered too."""
BREAKS = 5
"""A service that was broken off so often ends; the receiver competes again, and so may the others."""
STANDS_S, STANDS_J = 1.0, 2
"""[choice] A receiver whose mode does not show a transfer has ended it when what it counts stands for so long while its
tanker gives this much."""
REFUSALS = 5
"""Refusals of a receiver in a row after which its service is given up: others wait for the tanker."""
FOLLOW_EVERY_US = 100_000.0
_FOLLOW = float(mav.MAVLINK_MSG_ID_FOLLOW_TARGET)


@dataclass
class TankerSteps(ServiceSteps):
    """Moves every tanker's service from the decision to its end."""

    tankers: Mapping[int, Tanker]

    def available_j(self, tanker: VehicleView, limit_j: float) -> float:
        """Energy that a tanker may give and still get home with its reserve."""
        rules = self.tankers[tanker.sysid]
        way_home_j = (
            elementary.distance(tanker.p_now_ned(), rules.home_m or rules.start_m) / rules.speed_m_s * tanker.power_w
        )
        return min(tanker.remaining_j - rules.reserve_j - way_home_j, limit_j)

    def begin(self, service: Service) -> None:
        """The tanker is to report its position often enough for its receiver."""
        assert service.tanker is not None
        stream = token(service, "stream")
        self.requests.request(_follow_target_every(FOLLOW_EVERY_US, service.tanker, stream))

    def serve(self, service: Service, snapshot: FleetSnapshot) -> None:
        """Move one service to the snapshot's time."""
        assert service.tanker is not None
        now_s = snapshot.time_s
        receiver, tanker = snapshot.vehicle(service.receiver), snapshot.vehicle(service.tanker)
        if not receiver.alive or not tanker.alive:
            self._finish(service, receiver, tanker, now_s, "a side died")
            return
        if service.phase is not Phase.JOIN:
            _watch(service, receiver, tanker, now_s)
            service.seen_refuel |= _takes(service, receiver, tanker)
            service.seen_giving |= tanker.mode is FlightMode.REFUEL
        _STEPS[service.phase](self, service, receiver, tanker, now_s)

    def _join(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        reason = self._unfit(receiver, tanker)
        if reason is not None:
            self._finish(service, receiver, tanker, now_s, reason)
            return
        distance_m = elementary.distance(receiver.p_now_ned(), tanker.p_now_ned())
        relative_m_s = elementary.distance(receiver.v_ned, tanker.v_ned)
        inside = distance_m <= self.rules.capture_m and relative_m_s <= self.rules.relative_speed_m_s
        held = service.has_held(inside, now_s, self.rules.hold_s)
        counter_known = tanker.given_reported_s >= service.phase_since_s + COUNTER_SETTLES_S
        settled = not any(self.settlement.awaits(view.sysid, now_s) for view in (receiver, tanker))
        if held and counter_known and settled and now_s < self.until_s:
            for view in (receiver, tanker):
                self.settlement.begin(view.sysid)
            if service.joined_at_s is None:
                service.joined_at_s = now_s
                service.in_at_start_j = receiver.received_j
            service.near_since_s = None
            service.seen_refuel = service.seen_giving = False
            service.out_at_start_j, service.in_at_begin_j = tanker.given_j, receiver.received_j
            service.reported_in_j, service.progress_s = receiver.received_j, math.inf
            self._order(service, receiver, TransferRole.RECEIVE, self._limit_j(service, receiver, tanker))
            service.go(Phase.START_RECEIVER, now_s)
        elif now_s - service.phase_since_s > JOIN_WITHIN_S:
            self._finish(service, receiver, tanker, now_s, "no rendezvous in time")

    def _start_receiver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        if (out := self._out(receiver, tanker)) is not None:
            service.ended_by = out
            self._stop(service, receiver, now_s)
            return
        accepted = self.requests.accepted(token(service, "receive"))
        if accepted:
            service.refusals = 0
            limit_j = self._limit_j(service, receiver, tanker)
            service.ordered_j = math.floor(limit_j)
            self._order(service, tanker, TransferRole.GIVE, limit_j)
            service.go(Phase.START_GIVER, now_s)
        elif accepted is False or now_s - service.phase_since_s > START_WITHIN_S:
            service.refusals += 1
            if service.refusals >= REFUSALS:
                self._finish(service, receiver, tanker, now_s, "the receiver refused")
                return
            # it may have begun, and its acknowledgements been lost
            self._order(service, receiver, TransferRole.STOP, 0.0)
            service.go(Phase.JOIN, now_s)

    def _start_giver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        accepted = self.requests.accepted(token(service, "give"))
        if accepted:
            service.start_s = now_s if service.start_s is None else service.start_s
            self.requests.records.append({"kind": "transfer", **service.sides})
            service.go(Phase.TRANSFER, now_s)
            return
        out = self._out(receiver, tanker)
        if out or accepted is False or now_s - service.phase_since_s > START_WITHIN_S:
            service.ended_by = out or "the giver refused"
            # it may have begun, and its acknowledgements been lost
            self._order(service, tanker, TransferRole.STOP, 0.0)
            service.go(Phase.STOP_GIVER, now_s)

    def _transfer(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        late = now_s - service.phase_since_s > START_WITHIN_S
        receives = _takes(service, receiver, tanker) or not (service.seen_refuel or late)
        gives = tanker.mode is FlightMode.REFUEL or not (service.seen_giving or late)
        reason = None
        if receiver.remaining_j >= self.rules.until * receiver.capacity_j:
            reason = "full"
        elif self.rules.limit_j is not None and service.energy_j >= self.rules.limit_j:
            reason = "limit"
        elif self.available_j(tanker, math.inf) <= 0.0:
            reason = "tanker at its reserve"
        elif (unfit := self._unfit(receiver, tanker)) is not None:
            reason = unfit
        elif not gives and tanker.given_j - service.out_at_start_j >= service.ordered_j:
            reason = "limit"
        elif now_s >= self.until_s:
            reason = "the session ends"
        elif service.ends_early:
            reason = "others need it more"
        elif not (gives and receives):
            reason = f"broken off by the {'receiver' if gives else 'giver'}"
            service.broken_off = True
        if reason is not None:
            service.ended_by = reason
            self._order(service, tanker, TransferRole.STOP, 0.0)
            service.go(Phase.STOP_GIVER, now_s)

    def _stop_giver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        answered = self.requests.accepted(token(service, "stop giver")) is not None
        if answered or now_s - service.phase_since_s > START_WITHIN_S:
            service.go(Phase.CATCH_UP, now_s)

    def _catch_up(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        counter_reported = tanker.given_reported_s > service.phase_since_s
        caught_up = (
            counter_reported and receiver.received_j - service.in_at_begin_j >= tanker.given_j - service.out_at_start_j
        )
        if caught_up or now_s - service.phase_since_s >= CATCH_UP_S or not _takes(service, receiver, tanker):
            self._stop(service, receiver, now_s)

    def _stop_receiver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        answered = self.requests.accepted(token(service, "stop receiver")) is not None
        if not answered and now_s - service.phase_since_s <= START_WITHIN_S:
            return
        self.settlement.add(EndedTransfer(service, service.out_at_start_j, service.in_at_begin_j, now_s))
        service.breaks += service.broken_off
        if service.broken_off and service.breaks < BREAKS:
            service.broken_off = False
            self.requests.records.append({"kind": "broken off", **service.sides})
            service.go(Phase.JOIN, now_s)
        else:
            self._finish(service, receiver, tanker, now_s, service.ended_by)

    def _stop(self, service: Service, receiver: VehicleView, now_s: float) -> None:
        self._order(service, receiver, TransferRole.STOP, 0.0)
        service.go(Phase.STOP_RECEIVER, now_s)

    def _finish(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float, reason: str) -> None:
        if service.phase not in (Phase.JOIN, Phase.STOP_RECEIVER):
            for view in (tanker, receiver):
                if view.alive:
                    self._order(service, view, TransferRole.STOP, 0.0)
        if tanker.alive:
            self.requests.request(_follow_target_every(0.0, tanker.sysid, token(service, "unstream")))
        self.end(service, now_s, reason)

    def _out(self, receiver: VehicleView, tanker: VehicleView) -> str | None:
        """Why one of the two is to take no part."""
        for view in (receiver, tanker):
            if view.sysid in self.out:
                return f"{view.label} {self.out[view.sysid]}"
        return None

    def _unfit(self, receiver: VehicleView, tanker: VehicleView) -> str | None:
        """Why the two cannot keep formation any more, or are not to."""
        if (out := self._out(receiver, tanker)) is not None:
            return out
        return unfit(receiver) or unfit(tanker)

    def _limit_j(self, service: Service, receiver: VehicleView, tanker: VehicleView) -> float:
        room_j = receiver.capacity_j - receiver.remaining_j
        if self.rules.tops_up:
            net_w = max(self.rules.rate_w - receiver.power_w, 0.1 * self.rules.rate_w)
            room_j += receiver.power_w * (BEGINS_WITHIN_S + room_j / net_w)
        left_j = math.inf if self.rules.limit_j is None else self.rules.limit_j - service.energy_j
        return max(self.available_j(tanker, min(room_j, left_j)), 1.0)

    def _order(self, service: Service, view: VehicleView, role: TransferRole, limit_j: float) -> None:
        assert service.tanker is not None
        giver = view.sysid == service.tanker
        partner = service.receiver if giver else service.tanker
        what = {
            TransferRole.GIVE: "give",
            TransferRole.RECEIVE: "receive",
            TransferRole.STOP: "stop giver" if giver else "stop receiver",
        }[role]
        self.requests.order(
            service,
            view.sysid,
            what,
            role,
            partner=partner,
            limit_j=limit_j,
            rate_w=self.rules.rate_w,
            given_at_start_j=service.out_at_start_j,
        )


def _watch(service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
    """Keep when the receiver's counter last rose; progress_s is inf before its first joule of a transfer."""
    if receiver.received_j > service.reported_in_j:
        service.reported_in_j, service.progress_s = receiver.received_j, now_s
        service.out_at_progress_j = tanker.given_j


def _takes(service: Service, receiver: VehicleView, tanker: VehicleView) -> bool:
    """Whether a receiver takes energy, by its mode. One whose battery is apart does as long as it follows set points
    and its counter rises with its tanker's."""
    if not receiver.battery_apart:
        return receiver.mode is FlightMode.REFUEL
    stands_s = receiver.received_reported_s - service.progress_s
    stands = stands_s >= STANDS_S and tanker.given_j - service.out_at_progress_j >= STANDS_J
    return receiver.mode in STEERABLE and not stands


def _follow_target_every(interval_us: float, sysid: int, token: str) -> CommandRequest:
    return CommandRequest(sysid, mav.MAV_CMD_SET_MESSAGE_INTERVAL, (_FOLLOW, interval_us), token)


_STEPS = {
    Phase.JOIN: TankerSteps._join,
    Phase.START_RECEIVER: TankerSteps._start_receiver,
    Phase.START_GIVER: TankerSteps._start_giver,
    Phase.TRANSFER: TankerSteps._transfer,
    Phase.STOP_GIVER: TankerSteps._stop_giver,
    Phase.CATCH_UP: TankerSteps._catch_up,
    Phase.STOP_RECEIVER: TankerSteps._stop_receiver,
}
