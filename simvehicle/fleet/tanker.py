"""A tanker's side of services that receivers arrange: it takes one caller at a time and leaves with its reserve.

The tanker is the one place where two claims meet: the pursuer that its report names has it, and every peer receives the
same (docs/protocol/onboard.md#competition-on-board).
"""

from __future__ import annotations

from collections.abc import Mapping

from simvehicle.autopilot.modes import Severity
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.bids import HOPELESS_S, WORTH_J
from simvehicle.fleet.peers import PeerReport, PeerStage, ServiceReport
from simvehicle.fleet.rules import FleetRules
from skytender import elementary

CALLED_WITHIN_S = 1.0
"""A call is repeated ten times a second: an older one may have been given up."""
SILENT_S = 5.0
MEET_WITHIN_S = 65.0
"""The receiver gives up after 60 s; this is for the case that it cannot say so."""


class TankerDuty:
    """A vehicle that gives energy."""

    def __init__(self, vehicle: Vehicle, sysid: int, rules: FleetRules) -> None:
        self._vehicle = vehicle
        self._sysid = sysid
        self._rules = rules
        self._own = rules.tankers[sysid]
        self.receiver = 0
        self.since_s = 0.0
        self.services: list[ServiceReport] = []
        self._received_s = 0.0
        self._given_at_start_j = 0
        self._free = False

    @property
    def stage(self) -> PeerStage:
        """The stage in this vehicle's report."""
        if self.receiver:
            return PeerStage.MEETS if self._vehicle.transfer is None else PeerStage.TRANSFERS
        return PeerStage.FREE if self._free else PeerStage.APART

    @property
    def available_j(self) -> float:
        """Energy that it can spare and still get home with its reserve."""
        way_s = elementary.distance(self._vehicle.p_ned, self._own.home_ned) / self._own.speed_m_s
        return self._vehicle.remaining_j - self._own.reserve_j - way_s * self._vehicle.power_w

    def step(self, now_s: float, peers: Mapping[int, PeerReport], up: bool) -> None:
        """Move the present service on, or take a caller."""
        self._free = up
        if self.receiver:
            self._serve(now_s, peers.get(self.receiver), up)
        if not self.receiver and up and self.available_j >= WORTH_J:
            self._answer(now_s, peers)

    def _answer(self, now_s: float, peers: Mapping[int, PeerReport]) -> None:
        callers = {
            sysid: report
            for sysid, report in peers.items()
            if report.stage is PeerStage.CALLS
            and report.partner == self._sysid
            and now_s - report.time_s <= CALLED_WITHIN_S
        }
        if not callers:
            return
        chosen = min(callers, key=lambda one: (callers[one].slack_s < HOPELESS_S, callers[one].bid_s, one))
        call = callers[chosen]
        self.receiver, self.since_s, self._received_s = chosen, now_s, now_s
        self._given_at_start_j = self._vehicle.given_j
        self.services.append(ServiceReport(len(self.services) + 1, chosen, call.by, call.since_s))
        self._vehicle.announce(Severity.INFO, f"Serves {chosen}")

    def _serve(self, now_s: float, receiver: PeerReport | None, up: bool) -> None:
        service = self.services[-1]
        given_j = self._vehicle.given_j - self._given_at_start_j
        start_s = now_s if service.start_s < 0.0 and self._vehicle.transfer is not None else service.start_s
        self.services[-1] = service._replace(energy_j=given_j, start_s=start_s)
        if self.available_j <= 0.0:
            self._vehicle.end_transfer("stopped")
        if receiver is not None:
            self._received_s = now_s
        gone = receiver is not None and receiver.time_s > self.since_s and receiver.partner != self._sysid
        late = service.start_s < 0.0 and now_s - self.since_s > MEET_WITHIN_S
        if gone or late or not up or now_s - self._received_s > SILENT_S:
            self._vehicle.end_transfer("stopped")
            self.services[-1] = self.services[-1]._replace(end_s=now_s, ending=1 if given_j > 0 else 2)
            self._vehicle.announce(Severity.INFO, f"Has served {self.receiver}: {given_j} J")
            self.receiver = 0
