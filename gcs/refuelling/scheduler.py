"""Refuelling scheduler: gives receivers to tankers and bases (docs/protocol/energy.md#refuelling-schedule).

The schedule is pure but for its own memory: a snapshot and the results of earlier commands go in, requests and records
come out. It never knows a socket or a clock. How one service goes on from its decision:
gcs/refuelling/tanker_service.py and gcs/refuelling/base_service.py.

Vehicles that cannot take energy in the air compete by themselves, for the places at bases: by the same rules, since a
tanker is of no use to them, nor a place at a base to the others.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from typing import Any

from gcs.mavlink.autopilots import STEERABLE
from gcs.refuelling.base_service import BaseSteps, Stock
from gcs.refuelling.bidding import NO_COMPETITION, Award, BiddingRule, CompetitionState, is_servable
from gcs.refuelling.capability import ReceiverCapability
from gcs.refuelling.giver import WORTH_J, Giver, ServiceTimes
from gcs.refuelling.participation import Participation
from gcs.refuelling.policy_bidding import make_competition
from gcs.refuelling.service import NOTHING_DECIDED, Decision, Phase, Service, ServiceRequests, by_text
from gcs.refuelling.settlement import Settlement
from gcs.refuelling.tanker_service import TankerSteps
from gcs.refuelling.target_assignment import meeting_s, way
from gcs.scenario.goal import is_refuelling
from gcs.scenario.model import Base, CompetitionRules, RefuellingRules, Tanker
from gcs.telemetry.state import FleetSnapshot, VehicleView
from skytender import elementary

RELAY_WITHIN_M = 15.0
UP_WITHIN_S = 1.0
"""So long after the first one the others may take before anything is decided."""
TANKER_TIMES = (3.0, 1.14, 0.5)
BASE_TIMES = (10.0, 1.2, 6.0)
"""First guesses of a, b and what passes after the last joule, s; measured in random sessions [choice]."""


class Scheduler:
    """The competition and all services of a session."""

    def __init__(
        self,
        competition: CompetitionRules,
        refuelling: RefuellingRules,
        tankers: Sequence[Tanker],
        own: BiddingRule | None = None,
        *,
        bases: Sequence[Base] = (),
        transfer_capable: Mapping[int, bool | None] | None = None,
        cruise_m_s: float = 1.5,
        transfers_until_s: float = math.inf,
    ) -> None:
        """`own` takes the competition's place for the tankers. `transfer_capable`: whether a vehicle can take energy in
        the air, by system id, None where it is to be found out; vehicles that are not named can. `cruise_m_s`: how fast
        they fly to a base. `transfers_until_s`: session time at which transfers are stopped."""
        competes = competition.enabled and refuelling.enabled
        self._bidding = (own or make_competition(competition, refuelling)) if competes else None
        self._base_bidding = (
            make_competition(competition, refuelling, transfers_until_s) if competes and bases else None
        )
        self._rules = refuelling
        self._cruise_m_s = cruise_m_s
        self._need_from = competition.need_from
        self._tankers = {tanker.sysid: tanker for tanker in tankers}
        self.services: list[Service] = []
        self.participation = Participation()
        self._requests = ServiceRequests()
        self._settlement = Settlement(self._requests)
        with_all = (refuelling, self._requests, self._settlement, self.participation.out, transfers_until_s)
        stocks = {base.name: Stock(base) for base in bases}
        self._steps = TankerSteps(*with_all, self._tankers)
        self._bases = BaseSteps(*with_all, stocks, competition.need_from)
        self._ability = ReceiverCapability(transfer_capable or {})
        self.tanker_times = ServiceTimes(*TANKER_TIMES)
        self.base_times = ServiceTimes(*BASE_TIMES)
        self._approaches: dict[int, int] = {}
        self._first_up_s: float | None = None
        self._last_s: float | None = None
        self._free: list[int | str] = []
        self.tanker_idle_s = 0.0
        """tankers' time, summed, in which they were free although a vehicle waited"""
        self._up: set[int] = set()
        self._settled = False

    @property
    def competition_state(self) -> CompetitionState:
        """The competition for the tankers as it stands, or, where no vehicle competes for them, the one for the
        bases."""
        by_tanker, by_base = self.competition_states
        return by_tanker if by_tanker.tau or not by_base.tau else by_base

    @property
    def competition_states(self) -> tuple[CompetitionState, CompetitionState]:
        """The competitions as they stand: for the tankers, and for the bases."""
        tanker, base = self._bidding, self._base_bidding
        return (
            NO_COMPETITION if tanker is None else tanker.competition_state,
            NO_COMPETITION if base is None else base.competition_state,
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
        """Services that count as refuellings."""
        return [service for service in self.services if is_refuelling(service.end_s, service.energy_j)]

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
        if self._nothing_to_do:
            self._last_s = snapshot.time_s
            self._requests.clear()
            return NOTHING_DECIDED
        dt_s = 0.0 if self._last_s is None else snapshot.time_s - self._last_s
        self._last_s = snapshot.time_s
        self._requests.clear()
        self._bases.booked = {}
        self.settle(snapshot)
        self._prune(snapshot)
        self._ability.decide(snapshot, self._requests)
        self._compete(snapshot)
        for service in self.open_services:
            (self._steps if service.base is None else self._bases).serve(service, snapshot)
        self._settlement.settle(snapshot)
        self.tanker_idle_s += dt_s * self._idle_tankers(snapshot)
        in_air = {s.tanker: s for s in self.open_services if s.tanker is not None}
        at_base = [service for service in self.open_services if service.base is not None]
        return Decision(
            rendezvous={**self._approaches, **{tanker: service.receiver for tanker, service in in_air.items()}},
            approaches=frozenset(self._approaches.keys() - in_air.keys()),
            requests=tuple(self._requests.requests),
            relays=tuple(
                (tanker, service.receiver)
                for tanker, service in in_air.items()
                if service.phase is not Phase.JOIN or self._distance_m(tanker, service, snapshot) < RELAY_WITHIN_M
            ),
            stations=self._bases.stations(at_base),
            grounded=self._bases.grounded(at_base),
            giver_reports=self._bases.giver_reports(at_base, snapshot),
            booked=self._bases.booked,
            records=tuple(self._requests.records),
        )

    @property
    def _nothing_to_do(self) -> bool:
        """Whether no vehicle is, was or can soon be served, so that time changes nothing."""
        if self._bidding is not None or self._base_bidding is not None:
            return False
        return not (self.services or self.participation.asked or self._ability.open)

    def _compete(self, snapshot: FleetSnapshot) -> None:
        """Move both competitions on, and give every free tanker and base its winner."""
        served = {service.receiver for service in self.open_services} | self.participation.out.keys()
        unable = self._ability.unable.keys()
        tankers, bases = self._tanker_givers(snapshot), self._base_givers(snapshot)
        self._free = [giver.name for giver in tankers if giver.free_in_s == 0.0]
        self.tanker_times.learn((s for s in self.services if s.base is None), lambda _: self._rules.rate_w)
        self.base_times.learn((s for s in self.services if s.base is not None), self._base_rate_w)
        if self._bidding is not None:
            others = served | unable | self._ability.unknown
            self._bidding.advance(snapshot, others, tankers, self.tanker_times)
            self._end_early(self._bidding, others, tankers, snapshot)
        if self._base_bidding is not None:
            able = snapshot.columns.row.keys() - unable
            self._base_bidding.advance(snapshot, served | able, bases, self.base_times)
        self._approaches = {}
        if not self._rules.enabled:
            return
        for bidding, givers in ((self._bidding, tankers), (self._base_bidding, bases)):
            free = self._award_asked([giver for giver in givers if giver.free_in_s == 0.0], bidding, snapshot)
            if bidding is None or not free:
                continue
            if bidding.waits_for_all and not self._settled:
                self._settled = self._all_are_up(snapshot)
                if not self._settled:
                    continue
            for award in bidding.awards(snapshot, free):
                self._award(award, bidding, snapshot)
                free = [giver for giver in free if giver.name != award.giver.name]
            if bidding is self._bidding:
                self._approaches = bidding.approaches(snapshot, free)

    def _end_early(
        self, bidding: BiddingRule, unavailable: Collection[int], tankers: Sequence[Giver], snapshot: FleetSnapshot
    ) -> None:
        """Mark transfers that are to end before their receivers are full. `unavailable`: vehicles that do not
        compete."""
        early, now_s = bidding.early_ends, snapshot.time_s
        if early is None or not (waiting := bidding.competition_state.need.keys()):
            return
        due = [service for service in self.open_services if early.due(service, now_s)]
        if not due:
            return
        pursuers = snapshot.of_role("pursuer")
        others = [view for view in pursuers if view.sysid not in unavailable and is_servable(view)]
        for service in due:
            receiver = snapshot.vehicle(service.receiver)
            service.ends_early = early.ends(service, receiver, others, waiting, tankers, self.tanker_times, now_s)

    def _all_are_up(self, snapshot: FleetSnapshot) -> bool:
        """Whether everyone could be served by now and its draw is known, or has had its time after the first one."""
        pursuers = [
            view for view in snapshot.of_role("pursuer") if view.alive and view.sysid not in self.participation.out
        ]
        able = [view for view in pursuers if is_servable(view)]
        if self._first_up_s is None and able:
            self._first_up_s = snapshot.time_s
        self._up |= {view.sysid for view in able if view.power_w > 0.0}
        waited = self._first_up_s is not None and snapshot.time_s - self._first_up_s >= UP_WITHIN_S
        return waited or all(view.sysid in self._up for view in pursuers)

    def _idle_tankers(self, snapshot: FleetSnapshot) -> int:
        """How many tankers are free after this tick's decisions although a vehicle waits for each, once all are up."""
        if self._bidding is None or not self._rules.enabled or (self._bidding.waits_for_all and not self._settled):
            return 0
        busy = {service.tanker for service in self.open_services} | self._approaches.keys()
        served = {service.receiver for service in self.open_services} | set(self._approaches.values())
        waiting = sum(
            view.need >= self._need_from and is_servable(view)
            for view in snapshot.of_role("pursuer")
            if view.sysid not in served
            and view.sysid not in self.participation.out
            and view.sysid not in self._ability.unable
        )
        free = sum(giver not in busy for giver in self._free)
        return min(free, waiting)

    def _tanker_givers(self, snapshot: FleetSnapshot) -> list[Giver]:
        """Every tanker that flies and has something to spare, busy ones from where and when their service ends."""
        serves = {service.tanker: service for service in self.open_services}
        found = []
        for view in map(snapshot.vehicle, sorted(self._tankers.keys() & snapshot.columns.row.keys())):
            if view.sysid in self.participation.out or not (view.flying and view.fresh):
                continue
            service, available_j = serves.get(view.sysid), self._steps.available_j(view, math.inf)
            speed_m_s, place, free_in_s = self._tankers[view.sysid].speed_m_s, view.p_now_ned(), 0.0
            if service is not None:
                receiver = snapshot.vehicle(service.receiver)
                place = receiver.p_now_ned() if receiver.p_ned is not None else place
                available_j -= max(self._rules.until * receiver.capacity_j - receiver.remaining_j, 0.0)
                until, rate_w = self._rules.until, self._rules.rate_w
                free_in_s = max(self.tanker_times.left_s(service, receiver, until, rate_w, snapshot.time_s), 0.1)
            elif view.mode not in STEERABLE:
                continue
            if available_j >= WORTH_J:
                found.append(Giver(view.sysid, place, free_in_s, speed_m_s, available_j, self._rules.rate_w))
        return found

    def _base_givers(self, snapshot: FleetSnapshot) -> list[Giver]:
        """Every base with something left, busy ones from when their service ends."""
        serves = {service.base: service for service in self.open_services}
        found = []
        for stock in self.stocks:
            base, service, free_in_s = stock.base, serves.get(stock.base.name), 0.0
            if service is not None:
                receiver, until = snapshot.vehicle(service.receiver), self._rules.until
                free_in_s = max(self.base_times.left_s(service, receiver, until, base.rate_w, snapshot.time_s), 0.1)
            if stock.remaining_j >= WORTH_J:
                found.append(
                    Giver(base.name, base.above_m, free_in_s, self._cruise_m_s, stock.remaining_j, base.rate_w)
                )
        return found

    def _base_rate_w(self, service: Service) -> float:
        assert service.base is not None
        return self._bases.stocks[service.base].base.rate_w

    def _prune(self, snapshot: FleetSnapshot) -> None:
        """Withdraw requests of vehicles that are dead or being served."""
        if asked := self.participation.asked:
            served = {service.receiver for service in self.open_services}
            self.participation.withdraw(served | {sysid for sysid in asked if not snapshot.vehicle(sysid).alive})

    def _asked_for(self, snapshot: FleetSnapshot, *, base: bool) -> int | None:
        """Vehicle that is asked for next of those that a base, or a tanker, can serve."""
        for sysid in self.participation.asked:
            known = sysid not in self._ability.unknown
            if known and (sysid in self.unable) == base and is_servable(snapshot.vehicle(sysid)):
                self.participation.withdraw({sysid})
                return sysid
        return None

    def _award_asked(self, free: Sequence[Giver], bidding: BiddingRule | None, snapshot: FleetSnapshot) -> list[Giver]:
        """Assign the nearest free givers to the vehicles that the operator asked for; the givers still free."""
        left = list(free)
        while left:
            asked = self._asked_for(snapshot, base=not left[0].is_tanker)
            if asked is None:
                break
            view = snapshot.vehicle(asked)
            giver = min(left, key=lambda one: one.way_s(view))
            left.remove(giver)
            self._award(Award(giver, asked, "operator"), bidding, snapshot)
        return left

    def _award(self, award: Award, bidding: BiddingRule | None, snapshot: FleetSnapshot) -> None:
        """Begin the service of a receiver by its giver."""
        competition_state, now_s = CompetitionState() if bidding is None else bidding.competition_state, snapshot.time_s
        if bidding is not None:
            bidding.award(award.receiver, now_s)
        view, giver = snapshot.vehicle(award.receiver), award.giver
        more: dict[str, Any] = {}
        tanker = int(giver.name) if giver.is_tanker else None
        service = self._decide(competition_state, view, tanker, award.by, now_s)
        if tanker is None:
            service.base, service.why_base = str(giver.name), self.unable[award.receiver]
            service.meets_in_s = elementary.distance(giver.p_ned, view.p_now_ned()) / self._cruise_m_s
            more = {"reason": f"cannot take a transfer: {service.why_base}"}
        else:
            offset = way(giver.p_ned, view.p_now_ned())
            service.meets_in_s = meeting_s(offset, view.v_ned, giver.speed_m_s)
            self._steps.begin(service)
        self._record_decision(service, competition_state, more)

    def _decide(
        self, competition_state: CompetitionState, view: VehicleView, tanker: int | None, by: str, now_s: float
    ) -> Service:
        bids = {sysid: competition_state.tau[sysid] for sysid in competition_state.v or competition_state.tau}
        service = Service(len(self.services) + 1, view.sysid, tanker, by, bids, now_s, phase_since_s=now_s)
        service.need, service.share = view.need, competition_state.share
        service.gain = competition_state.gain.get(view.sysid)
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
        return elementary.distance(snapshot.vehicle(service.receiver).p_now_ned(), snapshot.vehicle(tanker).p_now_ned())
