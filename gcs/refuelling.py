"""Who is refuelled next, by whom, and each step of the service: contract.md, Competition in the schedule and Transfer.

    competition → decided → join formation → start receiver → start giver → transfer → stop giver → catch up → stop receiver

The schedule is pure but for its own memory: a snapshot and the results of earlier commands go in, wishes and records come
out. It never knows a socket or a clock.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

import numpy as np
from pymavlink.dialects.v20 import common as mav

from gcs.competition import advance, normalise, revive, share
from gcs.fleet import Snapshot, Vec3, VehicleView
from gcs.pilot import Wish
from gcs.profiles import STEERABLE, FlightMode
from gcs.scenario import Competition, Refuelling, Tanker

STOP, GIVE, RECEIVE = 0, 1, 2
RELAY_WITHIN_M = 15.0
CATCH_UP_S = 1.0
JOIN_WITHIN_S = 60.0
START_WITHIN_S = 5.0
WORTH_J = 500.0
FOLLOW_EVERY_US = 100_000.0
COMMAND_TOKENS = "refuel"


class Phase(StrEnum):
    """How far one service is."""

    JOIN = "join"
    START_RECEIVER = "start receiver"
    START_GIVER = "start giver"
    TRANSFER = "transfer"
    STOP_GIVER = "stop giver"
    CATCH_UP = "catch up"
    STOP_RECEIVER = "stop receiver"
    DONE = "done"


@dataclass
class Service:
    """One tanker serving one receiver, from the decision to the end."""

    number: int
    receiver: int
    tanker: int
    by: str
    bids: dict[int, float]
    decided_at_s: float
    phase: Phase = Phase.JOIN
    phase_since_s: float = 0.0
    near_since_s: float | None = None
    joined_at_s: float | None = None
    start_s: float | None = None
    end_s: float | None = None
    out_at_start_j: int = 0
    in_at_start_j: int = 0
    energy_j: int = 0
    lost_j: int = 0
    ended_by: str = ""

    def record(self) -> dict[str, Any]:
        """The service as the summary tells it."""
        return {
            "receiver": self.receiver,
            "tanker": self.tanker,
            "by": self.by,
            "decided_at_s": self.decided_at_s,
            "joined_at_s": self.joined_at_s,
            "start_s": self.start_s,
            "end_s": self.end_s,
            "energy_j": self.energy_j,
            "bids": {str(sysid): tau for sysid, tau in sorted(self.bids.items())},
        }


@dataclass(frozen=True)
class Decision:
    """What the schedule wants now: goals of tankers (position and velocity, NED), commands, and records of what happened."""

    goals: dict[int, tuple[Vec3, Vec3]] = field(default_factory=dict)
    wishes: tuple[Wish, ...] = ()
    relays: tuple[tuple[int, int], ...] = ()
    """(giver, receiver) pairs between which frames are relayed"""
    partners: tuple[tuple[int, int], ...] = ()
    """(tanker, receiver) pairs that need not keep their distance from each other"""
    records: tuple[dict[str, Any], ...] = ()


@dataclass(frozen=True)
class Standing:
    """The competition as it stands: state, bid and need of each competitor, and who leads."""

    v: dict[int, float]
    tau: dict[int, float]
    need: dict[int, float]
    leader: int | None
    share: float


class Schedule:
    """The competition and all services of a session."""

    def __init__(self, competition: Competition, refuelling: Refuelling, tankers: Sequence[Tanker]) -> None:
        self._competition = competition
        self._rules = refuelling
        self._tankers = {tanker.sysid: tanker for tanker in tankers}
        self._v: dict[int, float] = {}
        self._leader: int | None = None
        self._leading_since_s = 0.0
        self._competing_since_s: float | None = None
        self._last_s: float | None = None
        self._count = 0
        self._results: dict[str, bool] = {}
        self._wishes: list[Wish] = []
        self._records: list[dict[str, Any]] = []
        self.services: list[Service] = []
        self.standing = Standing({}, {}, {}, None, 0.0)

    @property
    def open_services(self) -> list[Service]:
        """Services that have not ended."""
        return [service for service in self.services if service.phase is not Phase.DONE]

    def result(self, token: str, accepted: bool) -> None:
        """The result of a command whose wish carried this token."""
        self._results[token] = accepted

    def decide(self, snapshot: Snapshot) -> Decision:
        """Move the competition and every service to the snapshot's time."""
        now_s = snapshot.time_s
        self._wishes, self._records = [], []
        free = self._free_tankers(snapshot)
        if self._rules.enabled and self._competition.enabled:
            bids = self._compete(snapshot, now_s)
            for tanker in free:
                self._award(tanker, bids, snapshot, now_s)
        for service in self.open_services:
            self._serve(service, snapshot, now_s)
        self._last_s = now_s
        open_services = self.open_services
        return Decision(
            goals={service.tanker: self._rendezvous(service, snapshot) for service in open_services},
            wishes=tuple(self._wishes),
            relays=tuple(
                (service.tanker, service.receiver)
                for service in open_services
                if service.phase is not Phase.JOIN or self._distance_m(service, snapshot) < RELAY_WITHIN_M
            ),
            partners=tuple((service.tanker, service.receiver) for service in open_services),
            records=tuple(self._records),
        )

    # the competition

    def _free_tankers(self, snapshot: Snapshot) -> list[VehicleView]:
        busy = {service.tanker for service in self.open_services}
        return [
            view
            for view in snapshot.of_role("tanker")
            if view.sysid not in busy
            and view.flying
            and view.mode in STEERABLE
            and self._available_j(view, math.inf) >= WORTH_J
        ]

    def _available_j(self, tanker: VehicleView, limit_j: float) -> float:
        """What a tanker may give and still get home with its reserve."""
        rules = self._tankers[tanker.sysid]
        home = rules.home_m or rules.start_m
        assert tanker.p_ned is not None
        way_home_j = math.dist(tanker.p_ned, home) / rules.speed_m_s * tanker.power_w
        return min(tanker.remaining_j - rules.reserve_j - way_home_j, limit_j)

    def _competitors(self, snapshot: Snapshot) -> list[VehicleView]:
        served = {service.receiver for service in self.open_services}
        return [
            view
            for view in snapshot.of_role("pursuer")
            if view.sysid not in served
            and view.flying
            and view.mode in STEERABLE
            and view.need >= self._competition.need_from
        ]

    def _compete(self, snapshot: Snapshot, now_s: float) -> dict[int, float]:
        """Advance the competition to now; the bids (normalised needs) by system id."""
        rules = self._competition
        competitors = self._competitors(snapshot)
        if not competitors:
            self._v, self._leader, self._competing_since_s = {}, None, None
            self.standing = Standing({}, {}, {}, None, 0.0)
            return {}
        if self._competing_since_s is None:
            self._competing_since_s = now_s
        sysids = [view.sysid for view in competitors]
        needs = [view.need for view in competitors]
        tau = normalise(needs, low=rules.floor, high=rules.high)
        v = np.array([self._v.get(sysid, rules.floor) for sysid in sysids])
        dt_s = now_s - self._last_s if self._last_s is not None else 0.0
        v = revive(advance(v, tau, dt_s, p=rules.p, rate=rules.rate), rules.floor)
        self._v = dict(zip(sysids, map(float, v), strict=True))
        leader = sysids[int(v.argmax())]
        held = share(v, rules.p, rules.floor)
        if leader != self._leader or held < rules.share:
            self._leader, self._leading_since_s = leader, now_s
        bids = dict(zip(sysids, map(float, tau), strict=True))
        self.standing = Standing(dict(self._v), bids, dict(zip(sysids, needs, strict=True)), leader, held)
        return bids

    def _award(self, tanker: VehicleView, bids: dict[int, float], snapshot: Snapshot, now_s: float) -> None:
        """Give a free tanker its next receiver, if one is decided."""
        chosen = self._chosen(tanker, bids, snapshot, now_s)
        if chosen is None:
            return
        receiver, by = chosen
        self._count += 1
        service = Service(self._count, receiver, tanker.sysid, by, dict(bids), now_s, phase_since_s=now_s)
        self.services.append(service)
        self._v.pop(receiver, None)
        bids.pop(receiver, None)
        self._leader, self._leading_since_s, self._competing_since_s = None, now_s, None
        self._ask(tanker.sysid, mav.MAV_CMD_SET_MESSAGE_INTERVAL, self._token(service, "stream"), _FOLLOW, FOLLOW_EVERY_US)
        self._records.append(
            {
                "kind": "decided",
                "receiver": receiver,
                "tanker": tanker.sysid,
                "by": by,
                "bids": {str(sysid): value for sysid, value in service.bids.items()},
                "v": {str(sysid): value for sysid, value in self.standing.v.items()},
                "need": {str(sysid): value for sysid, value in self.standing.need.items()},
                "share": self.standing.share,
            }
        )

    def _chosen(
        self, tanker: VehicleView, bids: dict[int, float], snapshot: Snapshot, now_s: float
    ) -> tuple[int, str] | None:
        if not bids:
            return None
        speed_m_s = self._tankers[tanker.sysid].speed_m_s
        assert tanker.p_ned is not None
        urgent = []
        for sysid in bids:
            view = snapshot.vehicle(sysid)
            assert view.p_ned is not None
            rendezvous_s = math.dist(tanker.p_ned, view.p_ned) / speed_m_s + self._rules.hold_s
            if view.endurance_s < rendezvous_s + self._rules.reserve_s:
                urgent.append((view.endurance_s, sysid))
        if urgent:
            return min(urgent)[1], "urgency"
        if self._leader in bids and now_s - self._leading_since_s >= self._competition.dwell_s:
            if self.standing.share >= self._competition.share:
                return self._leader, "competition"
        if self._competing_since_s is not None and now_s - self._competing_since_s >= self._competition.decide_within_s:
            return max(bids, key=lambda sysid: (self._v.get(sysid, 0.0), -sysid)), "timeout"
        return None

    # one service

    def _serve(self, service: Service, snapshot: Snapshot, now_s: float) -> None:
        receiver, tanker = snapshot.vehicle(service.receiver), snapshot.vehicle(service.tanker)
        if not receiver.alive or not tanker.alive:
            self._finish(service, receiver, tanker, now_s, "a side died")
            return
        service.energy_j = receiver.received_j - service.in_at_start_j if service.start_s is not None else 0
        _STEPS[service.phase](self, service, receiver, tanker, now_s)

    def _join(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        if not (receiver.flying and tanker.flying and receiver.mode in STEERABLE and tanker.mode in STEERABLE):
            self._finish(service, receiver, tanker, now_s, "a side left formation flight")
            return
        distance_m = math.dist(receiver.p_now_ned(), tanker.p_now_ned())
        relative_m_s = math.dist(receiver.v_ned, tanker.v_ned)
        inside = distance_m <= self._rules.capture_m and relative_m_s <= self._rules.relative_speed_m_s
        if not inside:
            service.near_since_s = None
        elif service.near_since_s is None:
            service.near_since_s = now_s
        if service.near_since_s is not None and now_s - service.near_since_s >= self._rules.hold_s:
            if service.joined_at_s is None:
                service.joined_at_s = now_s
            service.near_since_s = None
            service.out_at_start_j, service.in_at_start_j = tanker.given_j, receiver.received_j
            self._order(service, receiver, RECEIVE, self._limit_j(receiver, tanker))
            self._go(service, Phase.START_RECEIVER, now_s)
        elif now_s - service.phase_since_s > JOIN_WITHIN_S:
            self._finish(service, receiver, tanker, now_s, "no rendezvous in time")

    def _start_receiver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        accepted = self._answer(service, "receive")
        if accepted:
            self._order(service, tanker, GIVE, self._limit_j(receiver, tanker))
            self._go(service, Phase.START_GIVER, now_s)
        elif accepted is False or now_s - service.phase_since_s > START_WITHIN_S:
            self._go(service, Phase.JOIN, now_s)

    def _start_giver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        accepted = self._answer(service, "give")
        if accepted:
            service.start_s = now_s
            self._records.append({"kind": "transfer", "receiver": receiver.sysid, "tanker": tanker.sysid})
            self._go(service, Phase.TRANSFER, now_s)
        elif accepted is False or now_s - service.phase_since_s > START_WITHIN_S:
            service.ended_by = "the giver refused"
            self._stop(service, receiver, now_s)

    def _transfer(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        reason = None
        if receiver.remaining_j >= self._rules.until * receiver.capacity_j:
            reason = "full"
        elif self._rules.limit_j is not None and service.energy_j >= self._rules.limit_j:
            reason = "limit"
        elif self._available_j(tanker, math.inf) <= 0.0:
            reason = "tanker at its reserve"
        elif now_s - service.phase_since_s > START_WITHIN_S / 2 and FlightMode.REFUEL not in (receiver.mode, tanker.mode):
            reason = "the vehicles ended it"
        elif receiver.mode not in STEERABLE or tanker.mode not in STEERABLE:
            reason = "a side left formation flight"
        elif receiver.mode is FlightMode.OFFBOARD and now_s - service.phase_since_s > START_WITHIN_S / 2:
            reason = "the receiver ended it"
        if reason is not None:
            service.ended_by = reason
            self._order(service, tanker, STOP, 0.0)
            self._go(service, Phase.STOP_GIVER, now_s)

    def _stop_giver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        if self._answer(service, "stop giver") is not None or now_s - service.phase_since_s > START_WITHIN_S:
            self._go(service, Phase.CATCH_UP, now_s)

    def _catch_up(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        given_j = tanker.given_j - service.out_at_start_j
        waited_s = now_s - service.phase_since_s
        if (service.energy_j >= given_j and waited_s > 0.3) or waited_s >= CATCH_UP_S:
            self._stop(service, receiver, now_s)

    def _stop_receiver(self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float) -> None:
        if self._answer(service, "stop receiver") is not None or now_s - service.phase_since_s > START_WITHIN_S:
            self._finish(service, receiver, tanker, now_s, service.ended_by)

    def _stop(self, service: Service, receiver: VehicleView, now_s: float) -> None:
        self._order(service, receiver, STOP, 0.0)
        self._go(service, Phase.STOP_RECEIVER, now_s)

    def _finish(
        self, service: Service, receiver: VehicleView, tanker: VehicleView, now_s: float, reason: str
    ) -> None:
        if service.phase not in (Phase.JOIN, Phase.STOP_RECEIVER):
            for view in (tanker, receiver):
                if view.alive:
                    self._order(service, view, STOP, 0.0)
        service.phase, service.end_s, service.ended_by = Phase.DONE, now_s, reason
        if service.start_s is not None:
            service.energy_j = receiver.received_j - service.in_at_start_j
        if tanker.alive:
            self._ask(tanker.sysid, mav.MAV_CMD_SET_MESSAGE_INTERVAL, self._token(service, "unstream"), _FOLLOW, 0.0)
        self._records.append({"kind": "served", "reason": reason, **service.record()})

    def _go(self, service: Service, phase: Phase, now_s: float) -> None:
        service.phase, service.phase_since_s = phase, now_s

    # geometry and commands

    def _rendezvous(self, service: Service, snapshot: Snapshot) -> tuple[Vec3, Vec3]:
        """The place above the receiver and its velocity: where it will be, so that the tanker arrives beside it."""
        receiver = snapshot.vehicle(service.receiver)
        assert receiver.p_ned is not None
        n, e, d = receiver.p_now_ned()
        return (n, e, d - self._rules.height_m), receiver.v_ned

    def _distance_m(self, service: Service, snapshot: Snapshot) -> float:
        receiver, tanker = snapshot.vehicle(service.receiver), snapshot.vehicle(service.tanker)
        return math.dist(receiver.p_now_ned(), tanker.p_now_ned())

    def _limit_j(self, receiver: VehicleView, tanker: VehicleView) -> float:
        room_j = receiver.capacity_j - receiver.remaining_j
        return max(self._available_j(tanker, min(room_j, self._rules.limit_j or math.inf)), 1.0)

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
