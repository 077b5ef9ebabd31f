"""Joules that were on the way when a transfer ended: they come back to the tanker (docs/protocol.md#settlement).

A transfer over a slow or bad radio ends with more given than credited. Once both sides have ended it and have told
their counters since, what is missing is known for good, and the tanker is ordered to take it back. Until then neither
side begins another transfer, so that a counter means one transfer only.
"""

from __future__ import annotations

from dataclasses import dataclass

from gcs.mavlink.autopilots import FlightMode
from gcs.refuelling.service import ServiceRequests
from gcs.refuelling.transfer_command import TransferRole, transfer_request
from gcs.telemetry.state import FleetSnapshot, VehicleView

WAIT_S = 10.0
"""No next transfer waits for longer."""
ASK_AGAIN_S = 5.0
MOST_ASKED = 20
"""A tanker that accepts no order of so many keeps its books as they are."""


@dataclass
class EndedTransfer:
    """A transfer that has ended, and what is known for good of both of its ends; J."""

    service: int
    tanker: int
    receiver: int
    out_at_start_j: int
    in_at_start_j: int
    since_s: float
    given_j: int | None = None
    credited_j: int | None = None
    asked: int = 0
    asked_s: float = 0.0

    @property
    def token(self) -> str:
        """The mark by which the result of its order is known."""
        return f"refuel {self.service} settle {self.out_at_start_j}"

    @property
    def missing_j(self) -> int | None:
        """Given and never credited; None while that is not known for good."""
        return None if self.given_j is None or self.credited_j is None else self.given_j - self.credited_j


class Settlement:
    """Transfers of a session that have ended and are not settled yet."""

    def __init__(self, requests: ServiceRequests) -> None:
        self._requests = requests
        self._open: list[EndedTransfer] = []

    def add(self, ended: EndedTransfer) -> None:
        """A transfer has just ended: both sides were told to stop, and have said that they did or been waited for."""
        self._open.append(ended)

    def awaits(self, sysid: int, now_s: float) -> bool:
        """Whether a vehicle's counter still belongs to an earlier transfer, for a while."""
        return any(_unknown(one, sysid) and now_s - one.since_s < WAIT_S for one in self._open)

    def begin(self, sysid: int) -> None:
        """A vehicle begins another transfer: what is not known of its earlier ones by now never will be."""
        self._open = [one for one in self._open if not _unknown(one, sysid)]

    def settle(self, snapshot: FleetSnapshot) -> None:
        """Take in what is known by now, and let tankers take back what has not arrived."""
        self._open = [one for one in self._open if not self._settled(one, snapshot)]

    def _settled(self, one: EndedTransfer, snapshot: FleetSnapshot) -> bool:
        tanker, receiver = snapshot.vehicle(one.tanker), snapshot.vehicle(one.receiver)
        if not tanker.alive or (not receiver.alive and one.credited_j is None):
            return True
        if one.given_j is None and _has_ended(tanker) and tanker.given_reported_s > one.since_s:
            one.given_j = tanker.given_j - one.out_at_start_j
        if one.credited_j is None and _has_ended(receiver) and receiver.received_reported_s > one.since_s:
            one.credited_j = receiver.received_j - one.in_at_start_j
        missing_j = one.missing_j
        if missing_j is None:
            return False
        if missing_j <= 0 or one.asked > MOST_ASKED:
            return True
        accepted = self._requests.accepted(one.token)
        if accepted:
            self._requests.records.append(
                {"kind": "settled", "receiver": one.receiver, "tanker": one.tanker, "energy_j": missing_j}
            )
            return True
        if tanker.fresh and (not one.asked or snapshot.time_s - one.asked_s > ASK_AGAIN_S):
            one.asked, one.asked_s = one.asked + 1, snapshot.time_s
            self._requests.request(
                transfer_request(
                    one.tanker,
                    one.token,
                    TransferRole.SETTLE,
                    partner=one.receiver,
                    limit_j=one.credited_j or 0,
                    rate_w=0.0,
                    number=one.service,
                    given_at_start_j=one.out_at_start_j,
                )
            )
        return False


def _unknown(one: EndedTransfer, sysid: int) -> bool:
    return (one.tanker == sysid and one.given_j is None) or (one.receiver == sysid and one.credited_j is None)


def _has_ended(view: VehicleView) -> bool:
    """Whether a vehicle is heard, and in no transfer."""
    return view.fresh and view.mode is not FlightMode.REFUEL
