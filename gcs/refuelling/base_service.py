"""A base's service, step by step: docs/protocol/energy.md#service-at-a-base.

    join (fly to above the base) → land → start receiver → transfer → catch up → stop receiver → take off → done

A vehicle that knows transfers is charged by the same protocol as in the air, with the ground station as its partner:
it receives where the base is and what it has given, and answers with its own counter. Its ledger and the base's so
close to the joule. One that does not is charged by the book: what the base gave is what the vehicle received.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from gcs.mavlink.autopilots import STEERABLE
from gcs.mavlink.codec import Message, message
from gcs.mavlink.ids import STATION
from gcs.refuelling.service import GiverReport, Phase, Service, TransferRole, token, unfit
from gcs.refuelling.settlement import EndedTransfer, ServiceSteps
from gcs.scenario.model import Base, Origin
from gcs.telemetry.state import FleetSnapshot, Vec3, VehicleView
from skytender import elementary, geodesy

POSITION_AND_VELOCITY = 0b11
STANDS = (0.0, 0.0, 0.0)
REACH_WITHIN_S = 60.0
"""beyond the time that the way to the base takes"""
LAND_WITHIN_S = 60.0
START_WITHIN_S = 5.0
CATCH_UP_S = 1.0
SILENCE_S = 1.0
ASK_AGAIN_S = 1.0
REFUSALS = 5
ENDS_BY_ITSELF_S = 2.0
"""[choice] A receiver that has not answered STOP ends its transfer when nothing of the base comes for 1 s; frames may
be on the way for as long again."""
EMPTY = "the base is empty"
ENDS = "the session ends"
_BREAKS_OFF = (Phase.JOIN, Phase.LAND, Phase.START_RECEIVER, Phase.TRANSFER)
_CHARGING = (Phase.LAND, Phase.START_RECEIVER, Phase.TRANSFER, Phase.CATCH_UP, Phase.STOP_RECEIVER)


class Stock:
    """A base and what it still has: initial = given − taken back + remaining."""

    def __init__(self, base: Base) -> None:
        self.base = base
        self.given_j = 0
        """its `XferOut`, which never falls"""
        self.taken_back_j = 0
        """given, and never credited by its receiver"""

    @property
    def remaining_j(self) -> float:
        """Energy that it holds; a part of a joule is never given."""
        return self.base.stock_j - self.given_j + self.taken_back_j

    def take_back(self, joules: int) -> None:
        """Book what has not arrived."""
        self.taken_back_j += joules


@dataclass
class BaseSteps(ServiceSteps):
    """Moves every base's service from the decision to its end."""

    stocks: Mapping[str, Stock]
    """by the base's name"""
    need_from: float
    booked: dict[int, int] = field(default_factory=dict)
    """joules given in this tick by the book, by receiver"""
    stays: set[int] = field(default_factory=set)
    """vehicles that stay on the ground: too empty to fly on, and nothing left to charge it with"""

    def grounded(self, services: Iterable[Service]) -> frozenset[int]:
        """Vehicles that are to be on the ground now."""
        self.stays -= self.out.keys()
        return frozenset(self.stays | {service.receiver for service in services if service.phase in _CHARGING})

    def stations(self, services: Iterable[Service]) -> dict[int, Vec3]:
        """Set points of those that still fly by them."""
        flies = (Phase.JOIN, Phase.LAND)
        return {service.receiver: self._base(service).above_m for service in services if service.phase in flies}

    def giver_reports(self, services: Iterable[Service], snapshot: FleetSnapshot) -> tuple[GiverReport, ...]:
        """Messages of the bases to vehicles that can receive them."""
        return tuple(
            GiverReport(service.receiver, self._base(service).position_m, self._stock(service).given_j)
            for service in services
            if service.phase in _CHARGING and snapshot.vehicle(service.receiver).battery_reported
        )

    def serve(self, service: Service, snapshot: FleetSnapshot) -> None:
        """Move one service to the snapshot's time."""
        receiver = snapshot.vehicle(service.receiver)
        if not receiver.alive:
            self.end(service, snapshot.time_s, "the receiver died")
            return
        if receiver.sysid in self.out and service.phase in _BREAKS_OFF:
            reason = f"{receiver.label} {self.out[receiver.sysid]}"
            if service.phase in (Phase.JOIN, Phase.LAND):
                self.end(service, snapshot.time_s, reason)
            else:
                self._stop(service, reason, snapshot.time_s)
            return
        _STEPS[service.phase](self, service, receiver, snapshot.time_s)

    def _join(self, service: Service, receiver: VehicleView, now_s: float) -> None:
        if (reason := unfit(receiver)) is not None:
            self.end(service, now_s, reason)
            return
        base = self._base(service)
        off_m, speed_m_s = elementary.distance(receiver.p_now_ned(), base.above_m), elementary.norm(receiver.v_ned)
        near = off_m <= 0.5 * base.radius_m and speed_m_s <= self.rules.relative_speed_m_s
        if service.has_held(near, now_s, self.rules.hold_s):
            service.go(Phase.LAND, now_s)
        elif now_s - service.phase_since_s > REACH_WITHIN_S + (service.meets_in_s or 0.0):
            self.end(service, now_s, "did not reach the base in time")

    def _land(self, service: Service, receiver: VehicleView, now_s: float) -> None:
        if receiver.landed and not receiver.armed and receiver.fresh:
            base = self._base(service)
            off_m = elementary.distance(receiver.p_now_ned()[:2], base.position_m[:2])
            if off_m > base.radius_m:
                self._leave(service, receiver, now_s, f"landed {off_m:.1f} m from the base")
                return
            if self.settlement.awaits(receiver.sysid, now_s):
                return
            self.settlement.begin(receiver.sysid)
            service.joined_at_s = now_s
            service.in_at_start_j = service.in_at_begin_j = service.reported_in_j = receiver.received_j
            self._begin(service, receiver, now_s)
        elif now_s - service.phase_since_s > LAND_WITHIN_S:
            self._leave(service, receiver, now_s, "did not land")

    def _begin(self, service: Service, receiver: VehicleView, now_s: float) -> None:
        stock = self._stock(service)
        room_j = self.rules.until * receiver.capacity_j - receiver.remaining_j
        limit_j = math.inf if self.rules.limit_j is None else self.rules.limit_j
        service.ordered_j = math.floor(max(min(room_j, limit_j, stock.remaining_j), 0.0))
        service.out_at_start_j = stock.given_j
        if service.ordered_j < 1:
            self._leave(service, receiver, now_s, "full" if stock.remaining_j >= 1.0 else EMPTY)
        elif now_s >= self.until_s:
            self._leave(service, receiver, now_s, ENDS)
        elif receiver.battery_reported:
            self._order(service, TransferRole.RECEIVE)
            service.go(Phase.START_RECEIVER, now_s)
        else:
            self._charge_from_now(service, now_s)

    def _start_receiver(self, service: Service, receiver: VehicleView, now_s: float) -> None:
        accepted = self.requests.accepted(token(service, "receive"))
        waited_s = now_s - service.phase_since_s
        if accepted:
            self._charge_from_now(service, now_s)
        elif waited_s > START_WITHIN_S or (accepted is False and waited_s >= ASK_AGAIN_S):
            service.refusals += 1
            if service.refusals >= REFUSALS:
                self._stop(service, "the receiver refused", now_s)
                return
            self._order(service, TransferRole.RECEIVE)
            service.go(Phase.START_RECEIVER, now_s)

    def _charge_from_now(self, service: Service, now_s: float) -> None:
        service.start_s = service.charged_s = service.progress_s = now_s
        self.requests.records.append({"kind": "transfer", **service.sides})
        service.go(Phase.TRANSFER, now_s)

    def _transfer(self, service: Service, receiver: VehicleView, now_s: float) -> None:
        counts = receiver.battery_reported
        if receiver.received_j > service.reported_in_j:
            service.reported_in_j, service.progress_s = receiver.received_j, now_s
        if receiver.armed or not receiver.landed:
            self._stop(service, f"{receiver.label} left the base", now_s)
        elif now_s >= self.until_s:
            self._stop(service, ENDS, now_s)
        elif counts and now_s - service.progress_s > SILENCE_S:
            self._stop(service, "the receiver takes no more", now_s)
        elif self._given_j(service) >= service.ordered_j:
            self._stop(service, self._why_enough(service, receiver), now_s)
        elif counts or receiver.fresh:
            joules = self._give(service, now_s - service.charged_s)
            if not counts:
                self.booked[receiver.sysid] = joules
        service.charged_s = now_s

    def _give(self, service: Service, span_s: float) -> int:
        """Whole joules that leave the base in a while; fractions carry over."""
        stock = self._stock(service)
        wanted_j = service.fraction_j + stock.base.rate_w * span_s
        whole_j = math.floor(min(wanted_j, service.ordered_j - self._given_j(service)))
        service.fraction_j = min(wanted_j - whole_j, 1.0)
        stock.given_j += whole_j
        return whole_j

    def _why_enough(self, service: Service, receiver: VehicleView) -> str:
        if self._stock(service).remaining_j < 1.0:
            return EMPTY
        limited = self.rules.limit_j is not None and service.ordered_j >= math.floor(self.rules.limit_j)
        return "limit" if limited else "full"

    def _stop(self, service: Service, reason: str, now_s: float) -> None:
        service.ended_by = reason
        service.go(Phase.CATCH_UP, now_s)

    def _catch_up(self, service: Service, receiver: VehicleView, now_s: float) -> None:
        if not receiver.battery_reported:
            self._leave(service, receiver, now_s, service.ended_by)
            return
        caught_up = receiver.received_j - service.in_at_begin_j >= self._given_j(service)
        if caught_up or now_s - service.phase_since_s >= CATCH_UP_S:
            self._order(service, TransferRole.STOP)
            service.go(Phase.STOP_RECEIVER, now_s)

    def _stop_receiver(self, service: Service, receiver: VehicleView, now_s: float) -> None:
        answered = self.requests.accepted(token(service, "stop receiver")) is not None
        if answered or now_s - service.phase_since_s > START_WITHIN_S:
            self.settlement.add(
                EndedTransfer(
                    service,
                    service.out_at_start_j,
                    service.in_at_begin_j,
                    now_s if answered else now_s + ENDS_BY_ITSELF_S,
                    given_j=self._given_j(service),
                    take_back=self._stock(service).take_back,
                )
            )
            self._leave(service, receiver, now_s, service.ended_by)

    def _leave(self, service: Service, receiver: VehicleView, now_s: float, reason: str) -> None:
        """Let it take off again, unless it would be back at once and there is nothing to come back for."""
        service.ended_by = reason
        if reason == EMPTY and receiver.need >= self.need_from:
            self.stays.add(receiver.sysid)
            self.end(service, now_s, f"{EMPTY}, and {receiver.label} stays on the ground")
        else:
            service.go(Phase.TAKE_OFF, now_s)

    def _take_off(self, service: Service, receiver: VehicleView, now_s: float) -> None:
        base = self._base(service)
        up = receiver.flying and receiver.mode in STEERABLE
        if up and elementary.distance(receiver.p_now_ned(), base.position_m) > base.radius_m:
            self.end(service, now_s, service.ended_by)

    def _base(self, service: Service) -> Base:
        return self._stock(service).base

    def _stock(self, service: Service) -> Stock:
        assert service.base is not None
        return self.stocks[service.base]

    def _given_j(self, service: Service) -> int:
        return self._stock(service).given_j - service.out_at_start_j

    def _order(self, service: Service, role: TransferRole) -> None:
        self.requests.order(
            service,
            service.receiver,
            "receive" if role is TransferRole.RECEIVE else "stop receiver",
            role,
            partner=STATION[0],
            limit_j=service.ordered_j,
            rate_w=self._base(service).rate_w,
            given_at_start_j=service.out_at_start_j,
        )


_STEPS = {
    Phase.JOIN: BaseSteps._join,
    Phase.LAND: BaseSteps._land,
    Phase.START_RECEIVER: BaseSteps._start_receiver,
    Phase.TRANSFER: BaseSteps._transfer,
    Phase.CATCH_UP: BaseSteps._catch_up,
    Phase.STOP_RECEIVER: BaseSteps._stop_receiver,
    Phase.TAKE_OFF: BaseSteps._take_off,
}


def giver_messages(report: GiverReport, origin: Origin, time_ms: int) -> list[Message]:
    """Its FOLLOW_TARGET and its XferOut at a session time; `origin` is the common frame's."""
    lat_deg, lon_deg, alt_m = geodesy.place_of(report.p_ned, (origin.lat_deg, origin.lon_deg, origin.alt_m))
    place = message(
        "FOLLOW_TARGET",
        timestamp=time_ms,
        est_capabilities=POSITION_AND_VELOCITY,
        lat=round(1e7 * lat_deg),
        lon=round(1e7 * lon_deg),
        alt=alt_m,
        vel=STANDS,
        acc=STANDS,
        attitude_q=(1.0, 0.0, 0.0, 0.0),
        rates=STANDS,
        position_cov=STANDS,
        custom_state=0,
    )
    return [place, message("NAMED_VALUE_INT", time_boot_ms=time_ms, name="XferOut", value=report.given_j)]
