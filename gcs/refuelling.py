"""Who is refuelled next, by whom, and each step of the service: contract.md, Competition in the schedule and Transfer.

    decided → join → start receiver → start giver → transfer → stop giver → catch up → stop receiver → done
                ▲                                      broken off by either side │
                └─────────────────────────────────────────────────────────────────┘

The schedule is pure but for its own memory: a snapshot and the results of earlier commands go in, wishes and records
come out. It never knows a socket or a clock.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from pymavlink.dialects.v20 import common as mav

from gcs.contest import Contest, Standing, can_receive
from gcs.fleet import Snapshot, VehicleView
from gcs.pilot import Wish
from gcs.profiles import STEERABLE, FlightMode
from gcs.pursuit import meeting_s
from gcs.scenario import Competition, Refuelling, Tanker
from gcs.service import Decision, Phase, Service, by_text

STOP, GIVE, RECEIVE = 0, 1, 2
RELAY_WITHIN_M = 15.0
CATCH_UP_S = 1.0
COUNTER_SETTLES_S = 0.5
"""A giver's counter is trusted as a transfer's start when it was heard this long after the last one ended."""
JOIN_WITHIN_S = 60.0
START_WITHIN_S = 5.0
BREAKS = 5
"""A service that was broken off so often ends; the receiver competes again, and so may the others."""
REFUSALS = 5
"""So often in a row a receiver may refuse before its service is given up: others wait for the tanker."""
WORTH_J = 500.0
FOLLOW_EVERY_US = 100_000.0
COMMAND_TOKENS = "refuel"


class Schedule:
    """The competition and all services of a session."""

    def __init__(
        self, competition: Competition, refuelling: Refuelling, tankers: Sequence[Tanker], own: Contest | None = None
    ) -> None:
        self._contest = (own or Contest(competition)) if competition.enabled and refuelling.enabled else None
        self._rules = refuelling
        self._tankers = {tanker.sysid: tanker for tanker in tankers}
        self._results: dict[str, bool] = {}
        self._wishes: list[Wish] = []
        self._records: list[dict[str, Any]] = []
        self.services: list[Service] = []
        self.out: dict[int, str] = {}
        """who neither competes, is served nor serves, and why; a service of theirs is broken off"""
        self.asked: list[int] = []
        """who is served before anybody else, in this order"""

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
        self._results[token] = accepted

    def decide(self, snapshot: Snapshot) -> Decision:
        """Move the competition and every service to the snapshot's time."""
        now_s = snapshot.time_s
        self._wishes, self._records = [], []
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
            self._serve(service, snapshot, now_s)
        open_services = self.open_services
        return Decision(
            rendezvous={service.tanker: service.receiver for service in open_services},
            wishes=tuple(self._wishes),
            relays=tuple(
                (service.tanker, service.receiver)
                for service in open_services
                if service.phase is not Phase.JOIN or self._distance_m(service, snapshot) < RELAY_WITHIN_M
            ),
            partners=tuple((service.tanker, service.receiver) for service in open_services),
            records=tuple(self._records),
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
            and self._available_j(view, math.inf) >= WORTH_J
        ]

    def _available_j(self, tanker: VehicleView, limit_j: float) -> float:
        """What a tanker may give and still get home with its reserve."""
        rules = self._tankers[tanker.sysid]
        way_home_j = math.dist(tanker.p_now_ned(), rules.home_m or rules.start_m) / rules.speed_m_s * tanker.power_w
        return min(tanker.remaining_j - rules.reserve_j - way_home_j, limit_j)

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
        self._ask(
            tanker.sysid, mav.MAV_CMD_SET_MESSAGE_INTERVAL, self._token(service, "stream"), _FOLLOW, FOLLOW_EVERY_US
        )
        self._records.append(
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

    # one service

    def _serve(self, service: Service, snapshot: Snapshot, now_s: float) -> None:
        receiver, tanker = snapshot.vehicle(service.receiver), snapshot.vehicle(service.tanker)
        if not receiver.alive or not tanker.alive:
            self._finish(service, receiver, tanker, now_s, "a side died")
            return
        if service.phase is not Phase.JOIN:
            service.seen_refuel |= receiver.mode is FlightMode.REFUEL
            service.seen_giving |= tanker.mode is FlightMode.REFUEL
        _STEPS[service.phase](self, service, receiver, tanker, now_s)

    def _join(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        reason = self._unfit(receiver, tanker)
        if reason is not None:
            self._finish(service, receiver, tanker, now_s, reason)
            return
        distance_m = math.dist(receiver.p_now_ned(), tanker.p_now_ned())
        relative_m_s = math.dist(receiver.v_ned, tanker.v_ned)
        inside = distance_m <= self._rules.capture_m and relative_m_s <= self._rules.relative_speed_m_s
        if not inside:
            service.near_since_s = None
        elif service.near_since_s is None:
            service.near_since_s = now_s
        counter_known = tanker.given_told_s >= service.phase_since_s + COUNTER_SETTLES_S
        held = service.near_since_s is not None and now_s - service.near_since_s >= self._rules.hold_s
        if held and counter_known:
            if service.joined_at_s is None:
                service.joined_at_s = now_s
                service.in_at_start_j = receiver.received_j
            service.near_since_s = None
            service.seen_refuel = service.seen_giving = False
            service.out_at_start_j, service.in_at_begin_j = tanker.given_j, receiver.received_j
            self._order(service, receiver, RECEIVE, self._limit_j(service, receiver, tanker))
            self._go(service, Phase.START_RECEIVER, now_s)
        elif now_s - service.phase_since_s > JOIN_WITHIN_S:
            self._finish(service, receiver, tanker, now_s, "no rendezvous in time")

    def _start_receiver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        if (out := self._out(receiver, tanker)) is not None:
            service.ended_by = out
            self._stop(service, receiver, now_s)
            return
        accepted = self._answer(service, "receive")
        if accepted:
            service.refusals = 0
            limit_j = self._limit_j(service, receiver, tanker)
            service.ordered_j = math.floor(limit_j)
            self._order(service, tanker, GIVE, limit_j)
            self._go(service, Phase.START_GIVER, now_s)
        elif accepted is False or now_s - service.phase_since_s > START_WITHIN_S:
            service.refusals += 1
            if service.refusals >= REFUSALS:
                self._finish(service, receiver, tanker, now_s, "the receiver refused")
                return
            self._order(service, receiver, STOP, 0.0)  # it may have begun, and its acknowledgements been lost
            self._go(service, Phase.JOIN, now_s)

    def _start_giver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        accepted = self._answer(service, "give")
        if accepted:
            service.start_s = now_s if service.start_s is None else service.start_s
            self._records.append({"kind": "transfer", "receiver": receiver.sysid, "tanker": tanker.sysid})
            self._go(service, Phase.TRANSFER, now_s)
            return
        out = self._out(receiver, tanker)
        if out or accepted is False or now_s - service.phase_since_s > START_WITHIN_S:
            service.ended_by = out or "the giver refused"
            self._order(service, tanker, STOP, 0.0)  # it may have begun, and its acknowledgements been lost
            self._go(service, Phase.STOP_GIVER, now_s)

    def _transfer(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        late = now_s - service.phase_since_s > START_WITHIN_S
        receives = receiver.mode is FlightMode.REFUEL or not (service.seen_refuel or late)
        gives = tanker.mode is FlightMode.REFUEL or not (service.seen_giving or late)
        reason = None
        if receiver.remaining_j >= self._rules.until * receiver.capacity_j:
            reason = "full"
        elif self._rules.limit_j is not None and service.energy_j >= self._rules.limit_j:
            reason = "limit"
        elif self._available_j(tanker, math.inf) <= 0.0:
            reason = "tanker at its reserve"
        elif (unfit := self._unfit(receiver, tanker)) is not None:
            reason = unfit
        elif not gives and tanker.given_j - service.out_at_start_j >= service.ordered_j:
            reason = "limit"
        elif not (gives and receives):
            reason = f"broken off by the {'receiver' if gives else 'giver'}"
            service.broken_off = True
        if reason is not None:
            service.ended_by = reason
            self._order(service, tanker, STOP, 0.0)
            self._go(service, Phase.STOP_GIVER, now_s)

    def _stop_giver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        if self._answer(service, "stop giver") is not None or now_s - service.phase_since_s > START_WITHIN_S:
            self._go(service, Phase.CATCH_UP, now_s)

    def _catch_up(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        told = tanker.given_told_s > service.phase_since_s
        caught_up = told and receiver.received_j - service.in_at_begin_j >= tanker.given_j - service.out_at_start_j
        if caught_up or now_s - service.phase_since_s >= CATCH_UP_S or receiver.mode is not FlightMode.REFUEL:
            self._stop(service, receiver, now_s)

    def _stop_receiver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        if self._answer(service, "stop receiver") is None and now_s - service.phase_since_s <= START_WITHIN_S:
            return
        service.breaks += service.broken_off
        if service.broken_off and service.breaks < BREAKS:
            service.broken_off = False
            self._records.append({"kind": "broken off", "receiver": receiver.sysid, "tanker": tanker.sysid})
            self._go(service, Phase.JOIN, now_s)
        else:
            self._finish(service, receiver, tanker, now_s, service.ended_by)

    def _stop(self, service: Service, receiver: VehicleView, now_s: float) -> None:
        self._order(service, receiver, STOP, 0.0)
        self._go(service, Phase.STOP_RECEIVER, now_s)

    def _finish(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float, reason: str) -> None:
        if service.phase not in (Phase.JOIN, Phase.STOP_RECEIVER):
            for view in (tanker, receiver):
                if view.alive:
                    self._order(service, view, STOP, 0.0)
        service.phase, service.end_s, service.ended_by = Phase.DONE, now_s, reason
        if tanker.alive:
            self._ask(tanker.sysid, mav.MAV_CMD_SET_MESSAGE_INTERVAL, self._token(service, "unstream"), _FOLLOW, 0.0)
        self._records.append({"kind": "served", "reason": reason, **service.record()})

    def _go(self, service: Service, phase: Phase, now_s: float) -> None:
        service.phase, service.phase_since_s = phase, now_s

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
        for view in (receiver, tanker):
            if not view.fresh:
                return f"no word from {view.label}"
            if not view.flying or view.mode not in STEERABLE:
                return f"{view.label} left formation flight"
        return None

    # geometry and commands

    def _distance_m(self, service: Service, snapshot: Snapshot) -> float:
        receiver, tanker = snapshot.vehicle(service.receiver), snapshot.vehicle(service.tanker)
        return math.dist(receiver.p_now_ned(), tanker.p_now_ned())

    def _limit_j(self, service: Service, receiver: VehicleView, tanker: VehicleView) -> float:
        room_j = receiver.capacity_j - receiver.remaining_j
        left_j = math.inf if self._rules.limit_j is None else self._rules.limit_j - service.energy_j
        return max(self._available_j(tanker, min(room_j, left_j)), 1.0)

    def _order(self, service: Service, view: VehicleView, role: int, limit_j: float) -> None:
        giver = view.sysid == service.tanker
        partner = service.receiver if giver else service.tanker
        what = {GIVE: "give", RECEIVE: "receive", STOP: "stop giver" if giver else "stop receiver"}[role]
        token = self._token(service, what)
        self._results.pop(token, None)
        self._ask(
            view.sysid,
            mav.MAV_CMD_USER_1,
            token,
            float(partner),
            float(role),
            float(math.floor(limit_j)),
            self._rules.rate_w,
            float(service.number),
            float(service.out_at_start_j),
        )

    def _ask(self, sysid: int, command: int, token: str, *params: float) -> None:
        filled = (*params, *(0.0 for _ in range(7 - len(params))))
        self._wishes.append(Wish(sysid, command, filled, token))  # type: ignore[arg-type]

    def _answer(self, service: Service, what: str) -> bool | None:
        return self._results.get(self._token(service, what))

    @staticmethod
    def _token(service: Service, what: str) -> str:
        return f"{COMMAND_TOKENS} {service.number} {what}"


_FOLLOW = float(mav.MAVLINK_MSG_ID_FOLLOW_TARGET)
_STEPS = {
    Phase.JOIN: Schedule._join,
    Phase.START_RECEIVER: Schedule._start_receiver,
    Phase.START_GIVER: Schedule._start_giver,
    Phase.TRANSFER: Schedule._transfer,
    Phase.STOP_GIVER: Schedule._stop_giver,
    Phase.CATCH_UP: Schedule._catch_up,
    Phase.STOP_RECEIVER: Schedule._stop_receiver,
}
