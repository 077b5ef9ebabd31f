"""Refuelling scheduler: gives receivers to tankers and bases (docs/protocol.md#refuelling-schedule).

The schedule is pure but for its own memory: a snapshot and the results of earlier commands go in, requests and records
come out. It never knows a socket or a clock. How one service goes on from its decision: gcs/refuelling/tanker.py and
gcs/refuelling/base.py.

Vehicles that cannot take energy in the air compete by themselves, for the places at bases: by the same rules, since a
tanker is of no use to them, nor a place at a base to the others.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from gcs.mavlink.autopilots import STEERABLE
from gcs.refuelling.base import BaseSteps, Stock
from gcs.refuelling.bidding import Bidding, CompetitionState, is_servable
from gcs.refuelling.capability import ReceiverCapability
from gcs.refuelling.service import Decision, Phase, Service, ServiceRequests, by_text
from gcs.refuelling.tanker import TankerSteps
from gcs.refuelling.target_assignment import meeting_s
from gcs.scenario.model import Base, CompetitionRules, RefuellingRules, Tanker
from gcs.telemetry.state import FleetSnapshot, VehicleView

RELAY_WITHIN_M = 15.0
WORTH_J = 500.0


class Scheduler:
    """The competition and all services of a session."""

    def __init__(
        self,
        competition: CompetitionRules,
        refuelling: RefuellingRules,
        tankers: Sequence[Tanker],
        own: Bidding | None = None,
        *,
        bases: Sequence[Base] = (),
        transfer_capable: Mapping[int, bool | None] | None = None,
        cruise_m_s: float = 1.5,
    ) -> None:
        """`own` takes the competition's place for the tankers. `transfer_capable`: whether a vehicle can take energy in
        the air, by system id, None where it is to be found out; those who are not named can. `cruise_m_s`: how fast
        they fly to a base."""
        competes = competition.enabled and refuelling.enabled
        self._contest = (own or Bidding(competition)) if competes else None
        self._base_contest = Bidding(competition) if competes and bases else None
        self._rules = refuelling
        self._cruise_m_s = cruise_m_s
        self._tankers = {tanker.sysid: tanker for tanker in tankers}
        self.services: list[Service] = []
        self.out: dict[int, str] = {}
        """who neither competes, is served nor serves, and why; a service of theirs is broken off"""
        self.asked: list[int] = []
        """who is served before anybody else, in this order"""
        self._requests = ServiceRequests()
        self._steps = TankerSteps(refuelling, self._tankers, self._requests, self.out)
        self._bases = BaseSteps(refuelling, bases, self._requests, self.out, need_from=competition.need_from)
        self._ability = ReceiverCapability(transfer_capable or {})

    @property
    def competition_state(self) -> CompetitionState:
        """The competition for the tankers as it stands, or, where no vehicle competes for them, the one for the
        bases."""
        by_tanker, by_base = self.competition_states
        return by_tanker if by_tanker.tau or not by_base.tau else by_base

    @property
    def competition_states(self) -> tuple[CompetitionState, CompetitionState]:
        """The competitions as they stand: for the tankers, and for the bases."""
        tanker, base = self._contest, self._base_contest
        return (
            CompetitionState() if tanker is None else tanker.competition_state,
            CompetitionState() if base is None else base.competition_state,
        )

    @property
    def unable(self) -> Mapping[int, str]:
        """Vehicles that cannot take energy in the air, and how that is known: only a base can serve them."""
        return self._ability.unable

    @property
    def stocks(self) -> list[Stock]:
        """The bases, in the scenario's order, and what they have."""
        return list(self._bases.stocks.values())

    @property
    def open_services(self) -> list[Service]:
        """Services that have not ended."""
        return [service for service in self.services if service.phase is not Phase.DONE]

    @property
    def refuelled(self) -> list[Service]:
        """Services that ended with energy on board of the receiver."""
        return [service for service in self.services if service.phase is Phase.DONE and service.energy_j > 0]

    def settle(self, snapshot: FleetSnapshot) -> None:
        """Book on each service what its receiver's counter shows by now: the last joules may be reported late."""
        newest = {service.receiver: service for service in self.services if service.joined_at_s is not None}
        for receiver, service in newest.items():
            service.energy_j = snapshot.vehicle(receiver).received_j - service.in_at_start_j

    def bound(self, sysid: int) -> bool:
        """Whether a vehicle is needed until its service has been broken off in the order that saves every joule."""
        for service in self.open_services:
            if sysid == service.receiver and service.phase not in (Phase.JOIN, Phase.LAND, Phase.TAKE_OFF):
                return True
            if sysid == service.tanker and service.phase in (Phase.START_GIVER, Phase.TRANSFER, Phase.STOP_GIVER):
                return True
        return False

    def result(self, token: str, accepted: bool) -> None:
        """The result of a command whose request carried this token."""
        self._requests.receive_result(token, accepted)

    def decide(self, snapshot: FleetSnapshot) -> Decision:
        """Move the competition and every service to the snapshot's time."""
        self._requests.clear()
        self._bases.booked = {}
        self.settle(snapshot)
        self._prune(snapshot)
        self._ability.decide(snapshot, self._requests)
        self._compete(snapshot)
        for service in self.open_services:
            (self._steps if service.base is None else self._bases).serve(service, snapshot)
        in_air = {s.tanker: s for s in self.open_services if s.tanker is not None}
        at_base = [service for service in self.open_services if service.base is not None]
        return Decision(
            rendezvous={tanker: service.receiver for tanker, service in in_air.items()},
            requests=tuple(self._requests.requests),
            relays=tuple(
                (tanker, service.receiver)
                for tanker, service in in_air.items()
                if service.phase is not Phase.JOIN or self._distance_m(tanker, service, snapshot) < RELAY_WITHIN_M
            ),
            partners=tuple((tanker, service.receiver) for tanker, service in in_air.items()),
            stations=self._bases.stations(at_base),
            grounded=self._bases.grounded(at_base),
            giver_reports=self._bases.giver_reports(at_base, snapshot),
            booked=self._bases.booked,
            records=tuple(self._requests.records),
        )

    def _compete(self, snapshot: FleetSnapshot) -> None:
        """Move both competitions on, and give every free tanker and base who is decided for it."""
        served = {service.receiver for service in self.open_services} | self.out.keys()
        unable = self._ability.unable.keys()
        if self._contest is not None:
            self._contest.advance(snapshot, served | unable | self._ability.unknown)
        if self._base_contest is not None:
            self._base_contest.advance(snapshot, served | {v.sysid for v in snapshot.vehicles} - unable)
        if self._rules.enabled:
            free = self._free_tankers(snapshot)
            for i in range(len(free)):
                self._award(free[i:], snapshot)
            while self._award_base(snapshot):
                pass

    def _free_tankers(self, snapshot: FleetSnapshot) -> list[VehicleView]:
        busy = {service.tanker for service in self.open_services}
        return [
            view
            for view in snapshot.of_role("tanker")
            if view.sysid not in busy
            and view.sysid not in self.out
            and view.flying
            and view.fresh
            and view.mode in STEERABLE
            and self._steps.available_j(view, math.inf) >= WORTH_J
        ]

    def _prune(self, snapshot: FleetSnapshot) -> None:
        """Withdraw requests of vehicles that are dead, out or being served."""
        served = {service.receiver for service in self.open_services}
        gone = served | self.out.keys()
        self.asked = [sysid for sysid in self.asked if sysid not in gone and snapshot.vehicle(sysid).alive]

    def _asked_for(self, snapshot: FleetSnapshot, *, base: bool) -> int | None:
        """Vehicle that is asked for next of those that a base, or a tanker, can serve."""
        for sysid in self.asked:
            known = sysid not in self._ability.unknown
            if known and (sysid in self.unable) == base and is_servable(snapshot.vehicle(sysid)):
                self.asked.remove(sysid)
                return sysid
        return None

    def _next(self, free: Sequence[VehicleView], snapshot: FleetSnapshot) -> tuple[int, str] | None:
        """System id that the first free tanker serves next, and by what; None while undecided."""
        asked = self._asked_for(snapshot, base=False)
        if asked is not None or self._contest is None:
            return None if asked is None else (asked, "operator")
        speed_m_s = self._tankers[free[0].sysid].speed_m_s
        reserve_s = self._rules.hold_s + self._rules.reserve_s
        return self._contest.winner(snapshot, free[0], speed_m_s, reserve_s, free)

    def _award(self, free: Sequence[VehicleView], snapshot: FleetSnapshot) -> None:
        """Give the first of the free tankers its next receiver, if one is decided."""
        competition_state, tanker = self.competition_states[0], free[0]
        won = self._next(free, snapshot)
        if won is None:
            return
        receiver, by = won
        if self._contest is not None:
            self._contest.award(receiver, snapshot.time_s)
        view = snapshot.vehicle(receiver)
        service = self._decide(competition_state, view, tanker.sysid, by, snapshot.time_s)
        way = np.subtract(view.p_now_ned(), tanker.p_now_ned())
        service.meets_in_s = meeting_s(way, np.asarray(view.v_ned), self._tankers[tanker.sysid].speed_m_s)
        self._steps.begin(service)
        self._record_decision(service, competition_state)

    def _award_base(self, snapshot: FleetSnapshot) -> bool:
        """Give a free base its next receiver, the nearest base to who is decided; whether there was any."""
        busy = {service.base for service in self.open_services}
        free = [stock.base for stock in self.stocks if stock.base.name not in busy and stock.remaining_j >= WORTH_J]
        competition_state, contest = self.competition_states[1], self._base_contest
        asked = self._asked_for(snapshot, base=True) if free else None
        won = None if asked is None else (asked, "operator")
        if free and won is None and contest is not None:
            reserve_s = self._rules.hold_s + self._rules.reserve_s
            won = contest.winner_at([base.above_m for base in free], snapshot, self._cruise_m_s, reserve_s)
        if won is None:
            return False
        receiver, by = won
        if contest is not None:
            contest.award(receiver, snapshot.time_s)
        view = snapshot.vehicle(receiver)
        base = min(free, key=lambda base: math.dist(base.above_m, view.p_now_ned()))
        service = self._decide(competition_state, view, None, by, snapshot.time_s)
        service.base, service.why_base = base.name, self.unable[receiver]
        service.meets_in_s = math.dist(base.above_m, view.p_now_ned()) / self._cruise_m_s
        self._record_decision(service, competition_state, {"reason": f"cannot take a transfer: {service.why_base}"})
        return True

    def _decide(
        self, competition_state: CompetitionState, view: VehicleView, tanker: int | None, by: str, now_s: float
    ) -> Service:
        bids = {sysid: competition_state.tau[sysid] for sysid in competition_state.v or competition_state.tau}
        service = Service(len(self.services) + 1, view.sysid, tanker, by, bids, now_s, phase_since_s=now_s)
        service.need, service.share = view.need, competition_state.share
        service.need_is_largest = view.need >= max(competition_state.need.values(), default=0.0)
        self.services.append(service)
        return service

    def _record_decision(
        self, service: Service, competition_state: CompetitionState, more: Mapping[str, Any] | None = None
    ) -> None:
        self._requests.records.append(
            {
                "kind": "decided",
                **service.sides,
                **(more or {}),
                "by": service.by,
                "bids": by_text(service.bids),
                "v": by_text(competition_state.v),
                "need": by_text(competition_state.need),
                "share": competition_state.share,
            }
        )

    def _distance_m(self, tanker: int, service: Service, snapshot: FleetSnapshot) -> float:
        return math.dist(snapshot.vehicle(service.receiver).p_now_ned(), snapshot.vehicle(tanker).p_now_ned())
