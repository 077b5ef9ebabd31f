"""Who is refuelled next and by whom: contract.md, Competition in the schedule.

The schedule is pure but for its own memory: a snapshot and the results of earlier commands go in, wishes and records
come out. It never knows a socket or a clock. How one service goes on from its decision: gcs/tanker_service.py.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from gcs.contest import Contest, Standing, can_receive
from gcs.fleet import Snapshot, VehicleView
from gcs.profiles import STEERABLE
from gcs.pursuit import meeting_s
from gcs.scenario import Competition, Refuelling, Tanker
from gcs.service import Decision, Desk, Phase, Service, by_text
from gcs.tanker_service import TankerSteps

RELAY_WITHIN_M = 15.0
WORTH_J = 500.0


class Schedule:
    """The competition and all services of a session."""

    def __init__(
        self, competition: Competition, refuelling: Refuelling, tankers: Sequence[Tanker], own: Contest | None = None
    ) -> None:
        self._contest = (own or Contest(competition)) if competition.enabled and refuelling.enabled else None
        self._rules = refuelling
        self._tankers = {tanker.sysid: tanker for tanker in tankers}
        self.services: list[Service] = []
        self.out: dict[int, str] = {}
        """who neither competes, is served nor serves, and why; a service of theirs is broken off"""
        self.asked: list[int] = []
        """who is served before anybody else, in this order"""
        self._desk = Desk()
        self._steps = TankerSteps(refuelling, self._tankers, self._desk, self.out)

    @property
    def standing(self) -> Standing:
        """The competition as it stands."""
        return Standing() if self._contest is None else self._contest.standing

    @property
    def open_services(self) -> list[Service]:
        """Services that have not ended."""
        return [service for service in self.services if service.phase is not Phase.DONE]

    @property
    def refuelled(self) -> list[Service]:
        """Services that ended with energy on board of the receiver."""
        return [service for service in self.services if service.phase is Phase.DONE and service.energy_j > 0]

    def settle(self, snapshot: Snapshot) -> None:
        """Book on each service what its receiver's counter shows by now: the last joules may be told late."""
        newest = {service.receiver: service for service in self.services if service.joined_at_s is not None}
        for receiver, service in newest.items():
            service.energy_j = snapshot.vehicle(receiver).received_j - service.in_at_start_j

    def bound(self, sysid: int) -> bool:
        """Whether a vehicle is needed until its service has been broken off in the order that saves every joule."""
        for service in self.open_services:
            if sysid == service.receiver and service.phase is not Phase.JOIN:
                return True
            if sysid == service.tanker and service.phase in (Phase.START_GIVER, Phase.TRANSFER, Phase.STOP_GIVER):
                return True
        return False

    def result(self, token: str, accepted: bool) -> None:
        """The result of a command whose wish carried this token."""
        self._desk.hear(token, accepted)

    def decide(self, snapshot: Snapshot) -> Decision:
        """Move the competition and every service to the snapshot's time."""
        self._desk.clear()
        self.settle(snapshot)
        self._prune(snapshot)
        if self._contest is not None:
            served = {service.receiver for service in self.open_services}
            self._contest.advance(snapshot, served | self.out.keys())
        if self._rules.enabled:
            free = self._free_tankers(snapshot)
            for i in range(len(free)):
                self._award(free[i:], snapshot)
        for service in self.open_services:
            self._steps.serve(service, snapshot)
        open_services = self.open_services
        return Decision(
            rendezvous={service.tanker: service.receiver for service in open_services},
            wishes=tuple(self._desk.wishes),
            relays=tuple(
                (service.tanker, service.receiver)
                for service in open_services
                if service.phase is not Phase.JOIN or self._distance_m(service, snapshot) < RELAY_WITHIN_M
            ),
            partners=tuple((service.tanker, service.receiver) for service in open_services),
            records=tuple(self._desk.records),
        )

    # the decision

    def _free_tankers(self, snapshot: Snapshot) -> list[VehicleView]:
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

    def _prune(self, snapshot: Snapshot) -> None:
        """Who is dead, out or being served is asked for no more."""
        served = {service.receiver for service in self.open_services}
        gone = served | self.out.keys()
        self.asked = [sysid for sysid in self.asked if sysid not in gone and snapshot.vehicle(sysid).alive]

    def _next(self, free: Sequence[VehicleView], snapshot: Snapshot) -> tuple[int, str] | None:
        """Who the first of the free tankers serves next, and by what; None while undecided."""
        for sysid in self.asked:
            if can_receive(snapshot.vehicle(sysid)):
                self.asked.remove(sysid)
                return sysid, "operator"
        if self._contest is None:
            return None
        speed_m_s = self._tankers[free[0].sysid].speed_m_s
        reserve_s = self._rules.hold_s + self._rules.reserve_s
        return self._contest.winner(snapshot, free[0], speed_m_s, reserve_s, free)

    def _award(self, free: Sequence[VehicleView], snapshot: Snapshot) -> None:
        """Give the first of the free tankers its next receiver, if one is decided."""
        now_s, standing, tanker = snapshot.time_s, self.standing, free[0]
        won = self._next(free, snapshot)
        if won is None:
            return
        receiver, by = won
        if self._contest is not None:
            self._contest.award(receiver, now_s)
        bids = {sysid: standing.tau[sysid] for sysid in standing.v or standing.tau}
        service = Service(len(self.services) + 1, receiver, tanker.sysid, by, bids, now_s, phase_since_s=now_s)
        view = snapshot.vehicle(receiver)
        service.need, service.share = view.need, standing.share
        service.need_is_largest = view.need >= max(standing.need.values(), default=0.0)
        way = np.subtract(view.p_now_ned(), tanker.p_now_ned())
        service.meets_in_s = meeting_s(way, np.asarray(view.v_ned), self._tankers[tanker.sysid].speed_m_s)
        self.services.append(service)
        self._steps.begin(service)
        self._desk.records.append(
            {
                "kind": "decided",
                "receiver": receiver,
                "tanker": tanker.sysid,
                "by": by,
                "bids": by_text(bids),
                "v": by_text(standing.v),
                "need": by_text(standing.need),
                "share": standing.share,
            }
        )

    def _distance_m(self, service: Service, snapshot: Snapshot) -> float:
        receiver, tanker = snapshot.vehicle(service.receiver), snapshot.vehicle(service.tanker)
        return math.dist(receiver.p_now_ned(), tanker.p_now_ned())
