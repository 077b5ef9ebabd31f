"""A vehicle as a member of a fleet that refuels itself: what it reports, decides and flies, tick by tick.

    reports of peers → service → own bid → competition → own report → flight while the ground station is silent

Time is the vehicle's own; what it wants to send waits in `reports`, `services` and `orders`.
"""

from __future__ import annotations

from collections.abc import Mapping

from simvehicle.autopilot.modes import STEERED
from simvehicle.autopilot.vectors import Vec3
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.bids import Offer, offers, own_bid
from simvehicle.fleet.competition import FleetCompetition
from simvehicle.fleet.loss_bids import LossBids
from simvehicle.fleet.peers import PeerReport, Peers, PeerStage, ServiceReport, as_sent
from simvehicle.fleet.receiver import OrderToPeer, Receiver, ReceiverPhase
from simvehicle.fleet.routes import Surroundings, meeting_place, route
from simvehicle.fleet.rules import FleetRules
from simvehicle.fleet.silent_flight import SilentFlight
from simvehicle.fleet.tanker import TankerDuty
from skytender import elementary

PERIOD_MS = 100
UP_WITHIN_S = 1.0
"""So long after the first one the others may take before anything is decided."""
REPORTS_BEFORE = 2
"""[choice] Reports of each vehicle, once all are up, before anything is decided: the first bids know no tankers yet."""
POWER_KEPT = 0.9
"""Share of the smoothed draw that a tick keeps: about a second's mean [choice]."""
SERVICE_EVERY_S = 0.5
TRANSIT_APART_M = 1.5
"""Between the heights at which two tankers travel."""
LOOK_EVERY_S = 1.0
"""A receiver that has found no place to be met looks again after so long."""
SAME_M = 0.1


class FleetMember:
    """One vehicle of the fleet."""

    def __init__(self, vehicle: Vehicle, sysid: int, rules: FleetRules) -> None:
        self._vehicle = vehicle
        self._sysid = sysid
        self._rules = rules
        self.peers = Peers()
        self._competition = FleetCompetition(rules)
        self._loss_bids = LossBids(sysid, rules) if rules.bids == "losses" else None
        self.receiver = Receiver(vehicle, sysid, rules) if sysid in rules.pursuers else None
        self.tanker = TankerDuty(vehicle, sysid, rules) if sysid in rules.tankers else None
        level = sorted(rules.tankers).index(sysid) if sysid in rules.tankers else 0
        self._transit_down_m = -(rules.transit_height_m + TRANSIT_APART_M * level)
        self._flight = SilentFlight(vehicle)
        self._own = PeerReport(0.0)
        self._power_w = 0.0
        self._tick_ms: int | None = None
        self._report_s = 0.0
        self._service_s = 0.0
        self._next_service = 0
        self._first_up_s: float | None = None
        self._all_up_s: float | None = None
        self._seen_up: set[int] = set()
        self._settled = False
        self._goal_ned: Vec3 | None = None
        self._meet_ned: Vec3 | None = None
        self._look_s = 0.0
        self.reports: list[PeerReport] = []
        self.services: list[ServiceReport] = []
        self.orders: list[OrderToPeer] = []

    def receive(self, sysid: int, report: PeerReport) -> None:
        """A peer's report has come. Who hears a peer is not cut off: its failsafe for a lost link waits."""
        self.peers.receive(sysid, report)
        self._vehicle.receive_gcs_heartbeat()

    def receive_answer(self, sysid: int, accepted: bool) -> None:
        """A tanker's acknowledgement of an order."""
        if self.receiver is not None:
            self.receiver.receive_answer(sysid, accepted)

    def led(self) -> None:
        """A set point has come from the ground station."""
        self._flight.led(self._vehicle.time_s)

    def tick(self) -> None:
        """Do what is due at the vehicle's time."""
        vehicle = self._vehicle
        if self._tick_ms is not None and vehicle.time_ms - self._tick_ms < PERIOD_MS:
            return
        if self._tick_ms is None:
            self._report_s = vehicle.time_s + PERIOD_MS / 1e3 * (self._sysid % 2)
        self._tick_ms = vehicle.time_ms
        now_s, peers = vehicle.time_s, self.peers.fresh(vehicle.time_s)
        self._power_w += (1.0 - (POWER_KEPT if self._power_w else 0.0)) * (vehicle.power_w - self._power_w)
        up = vehicle.armed and not vehicle.landed and vehicle.mode in STEERED
        self._note_up(now_s, peers, up)
        before = (self._own.stage, self._own.partner)
        if self.tanker is not None:
            self.tanker.step(now_s, peers, up)
        if self.receiver is not None:
            self.receiver.step(now_s, peers)
            if up:
                self._compete(now_s, peers)
            self.orders += self.receiver.orders
            self.receiver.orders.clear()
        self._fly(now_s, peers)
        self._report(now_s, peers, up, before)

    def _note_up(self, now_s: float, peers: Mapping[int, PeerReport], up: bool) -> None:
        """Whether all could be served, and have said their bids since, or have had their time after the first."""
        if self._settled:
            return
        self._seen_up |= {sysid for sysid in self._rules.pursuers if sysid in peers and peers[sysid].up}
        if up and self.receiver is not None and self._power_w > 0.0:
            self._seen_up.add(self._sysid)
        if self._seen_up and self._first_up_s is None:
            self._first_up_s = now_s
        if self._all_up_s is None and self._seen_up.issuperset(self._rules.pursuers):
            self._all_up_s = now_s
        waited = self._first_up_s is not None and now_s - self._first_up_s >= UP_WITHIN_S
        said_s = REPORTS_BEFORE * self._rules.report_every_s
        self._settled = waited or (self._all_up_s is not None and now_s - self._all_up_s >= said_s)

    def _compete(self, now_s: float, peers: Mapping[int, PeerReport]) -> None:
        """Run the competition over the bids that are known, and call the tanker where it is won."""
        assert self.receiver is not None
        givers = offers(now_s, peers, self._rules)
        competing = {sysid: peer for sysid, peer in peers.items() if peer.stage is PeerStage.COMPETES}
        if self.receiver.phase is ReceiverPhase.NONE and self._own.stage is PeerStage.COMPETES:
            competing[self._sysid] = self._own
        self._competition.advance(now_s, competing, len(givers))
        if self._sysid not in competing or not self._settled:
            return
        for won in self._competition.winners(now_s, self._free(now_s, peers, givers)):
            if won.receiver == self._sysid:
                self.receiver.call(won, now_s)

    def _free(self, now_s: float, peers: Mapping[int, PeerReport], givers: list[Offer]) -> list[Offer]:
        """Tankers that serve no vehicle, that no vehicle calls, and that answer."""
        assert self.receiver is not None
        called = {peer.partner for sysid, peer in peers.items() if sysid not in self._rules.tankers}
        return [
            giver
            for giver in givers
            if peers[giver.sysid].stage is PeerStage.FREE
            and giver.sysid not in called
            and not self.receiver.blocked(giver.sysid, now_s)
        ]

    # what it says

    def _report(self, now_s: float, peers: Mapping[int, PeerReport], up: bool, before: tuple[PeerStage, int]) -> None:
        stage, partner = PeerStage.APART, 0
        if self.tanker is not None:
            stage, partner = self.tanker.stage, self.tanker.receiver
        elif self.receiver is not None:
            stage, partner = self.receiver.stage, self.receiver.tanker
        changed = (stage, partner) != (PeerStage.APART if before[0] is PeerStage.COMPETES else before[0], before[1])
        if now_s >= self._report_s or changed or stage is PeerStage.CALLS:
            if now_s >= self._report_s:
                self._report_s += self._rules.report_every_s
            self._own = as_sent(self._described(now_s, peers, up, stage, partner))
            self.reports.append(self._own)
        if self.tanker is not None:
            self._report_services(now_s, changed)

    def _described(
        self, now_s: float, peers: Mapping[int, PeerReport], up: bool, stage: PeerStage, partner: int
    ) -> PeerReport:
        vehicle = self._vehicle
        report = PeerReport(
            now_s,
            stage,
            partner,
            up,
            vehicle.p_ned,
            vehicle.v_ned,
            vehicle.remaining_j if self.tanker is None else self.tanker.available_j,
            vehicle.capacity_j,
            self._power_w,
            given_j=vehicle.given_j,
            meet_ned=self._meet_ned or vehicle.p_ned,
        )
        if self.tanker is not None:
            return report._replace(since_s=self.tanker.since_s)
        if self.receiver is None:
            return report
        if stage is not PeerStage.APART:
            own = self._own
            return report._replace(
                since_s=self.receiver.since_s,
                by=self.receiver.by,
                bid_s=own.bid_s,
                slack_s=own.slack_s,
                way_s=own.way_s,
            )
        others = {sysid: peer for sysid, peer in peers.items() if peer.stage is PeerStage.COMPETES}
        givers = offers(now_s, peers, self._rules)
        bid = own_bid(now_s, report, others, givers, self._rules)
        if bid.competes and self._loss_bids is not None:
            bid = bid._replace(bid_s=self._loss_bids.bid_s(now_s, report, peers, givers))
        return report._replace(
            stage=PeerStage.COMPETES if up and bid.competes and self._power_w > 0.0 else PeerStage.APART,
            bid_s=bid.bid_s,
            slack_s=bid.slack_s,
            way_s=bid.way_s,
            ln_v=self._competition.ln_v_of(self._sysid),
        )

    def _report_services(self, now_s: float, changed: bool) -> None:
        """The present service, and in turn the earlier ones: who was cut off learns of all."""
        assert self.tanker is not None
        services = self.tanker.services
        if not services or (now_s < self._service_s and not changed):
            return
        self._service_s = now_s + SERVICE_EVERY_S
        self.services.append(services[-1])
        if len(services) > 1:
            self._next_service = (self._next_service + 1) % (len(services) - 1)
            self.services.append(services[self._next_service])

    # where it flies by itself

    def _fly(self, now_s: float, peers: Mapping[int, PeerReport]) -> None:
        if not self._flight.take_over(now_s):
            self._goal_ned = self._meet_ned = None
            return
        if self.tanker is not None:
            self._aim_tanker(peers)
        elif self.receiver is not None:
            self._aim_receiver(now_s, peers)
        self._flight.go(self._goal_ned, now_s, lambda here, there: self._route(here, there, peers))
        self._meet_ned = self._goal_ned or self._flight.hold_ned

    def _aim_tanker(self, peers: Mapping[int, PeerReport]) -> None:
        """Above the place where its receiver waits, until energy flows; a tanker without a receiver stays."""
        assert self.tanker is not None
        receiver = peers.get(self.tanker.receiver)
        if not self.tanker.receiver:
            self._goal_ned = None
        elif receiver is not None and receiver.partner == self._sysid and self._vehicle.transfer is None:
            north, east, down = receiver.meet_ned
            self._goal_ned = (north, east, down - self._rules.height_m)

    def _aim_receiver(self, now_s: float, peers: Mapping[int, PeerReport]) -> None:
        """Nearest place at which its tanker can come to it, chosen once for each service."""
        assert self.receiver is not None
        if self.receiver.phase is ReceiverPhase.NONE:
            self._goal_ned = None
        tanker = peers.get(self.receiver.tanker)
        if self.receiver.phase is not ReceiverPhase.MEET or tanker is None or self._goal_ned is not None:
            return
        if now_s < self._look_s or self.receiver.is_near(now_s):
            return
        self._look_s = now_s + LOOK_EVERY_S
        around = self._around(peers, self.receiver.tanker)
        here = self._flight.hold_ned
        assert here is not None
        self._goal_ned = meeting_place(
            here, tanker.p_at(now_s), self._rules.height_m, around, -self._rules.transit_height_m
        )

    def _route(self, here: Vec3, there: Vec3, peers: Mapping[int, PeerReport]) -> list[Vec3] | None:
        if self.tanker is None:
            return [there]
        others = [sysid for sysid in peers if sysid in self._rules.tankers and sysid != self._sysid]
        high = any(peers[sysid].stage is PeerStage.MEETS for sysid in others) and elementary.distance(here, there) > 1.0
        return route(here, there, self._around(peers, self.tanker.receiver), self._transit_down_m, high=high)

    def _around(self, peers: Mapping[int, PeerReport], partner: int) -> Surroundings:
        places = []
        for sysid, peer in peers.items():
            if sysid not in (self._sysid, partner):
                places.append(peer.p_ned)
                if elementary.distance(peer.meet_ned, peer.p_ned) > SAME_M:
                    places.append(peer.meet_ned)
        return Surroundings(self._rules.obstacles, self._rules.clearance_m, places, self._rules.separation_m)
