"""Joules of transfers that have ended and never arrived: their receiver lets the tanker take them back.

The tanker's own books say what it gave by an order; the receiver tells it what it has credited of that
(docs/protocol/energy.md#settlement). Where nothing was lost nothing is sent.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from simvehicle.autopilot.energy_transfer import TransferOrder, TransferSide
from simvehicle.fleet.peers import PeerReport, PeerStage

REPEAT_S = 0.5
MOST_ASKED = 20
ANSWERS = 2
"""[choice] Acceptances after which nothing more is asked: one may belong to an earlier order."""


@dataclass
class UnsettledTransfer:
    """A transfer that its receiver has ended, by the order to its tanker."""

    tanker: int
    order: TransferOrder
    credited_j: int
    since_s: float
    asked: int = 0
    asked_s: float = 0.0
    answers: int = 0


class ReceiverSettlement:
    """A receiver's transfers that are not settled yet."""

    def __init__(self) -> None:
        self._open: list[UnsettledTransfer] = []

    def add(self, tanker: int, order: TransferOrder, credited_j: int, now_s: float) -> None:
        """A transfer has ended here; `order` is what its tanker gave by."""
        settle = replace(order, role=TransferSide.SETTLE, limit_j=float(credited_j), rate_w=0.0)
        self._open.append(UnsettledTransfer(tanker, settle, credited_j, now_s))

    def receive_answer(self, sysid: int, accepted: bool) -> None:
        """A tanker's acknowledgement of an order; they come in the orders' sequence."""
        for one in self._open:
            if accepted and one.tanker == sysid and one.asked:
                one.answers += 1
                return

    def due(self, now_s: float, peers: Mapping[int, PeerReport]) -> list[tuple[int, TransferOrder]]:
        """(tanker, order) of what is to be asked now."""
        asks = []
        for one in list(self._open):
            tanker = peers.get(one.tanker)
            if one.answers >= ANSWERS or one.asked >= MOST_ASKED:
                self._open.remove(one)
            elif tanker is None or tanker.time_s <= one.since_s or tanker.stage is PeerStage.TRANSFERS:
                continue  # what it has given is not known for good
            elif not one.asked and tanker.given_j - one.order.giver_start_j <= one.credited_j:
                self._open.remove(one)
            elif not one.asked or now_s - one.asked_s >= REPEAT_S:
                one.asked, one.asked_s = one.asked + 1, now_s
                asks.append((one.tanker, one.order))
        return asks
