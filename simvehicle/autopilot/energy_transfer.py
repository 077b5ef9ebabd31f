"""Giving and receiving energy in flight: docs/protocol/energy.md#energy-transfer.

Joules move whole and fractions carry over. Each side keeps one counter for life, `given_j` or `received_j`, which it
sends as XferOut and XferIn. A receiver credits by the largest XferOut that it has seen, so a lost frame costs nothing.
A giver stops while too much of what it gave is not acknowledged by XferIn, and resumes with the next acknowledgement:
what can be on the way is bounded, however slow or bad the radio. An order that has moved joules and ended is never
begun again, or a late copy of it would credit them twice. What was on the way when a transfer broke off, given and not
credited, comes back once both figures are final: the supervisor settles the order, and the joules count as received.
Time is an argument; nothing here knows a message or a mode.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import IntEnum
from math import dist, floor, inf

SILENCE_S = 1.0
"""A receiver gives up when its giver has shown no sign of life for this long; it must know where the other one is."""
UNACKNOWLEDGED_S = 1.0
"""[choice] A giver is ahead of its receiver's acknowledgements by what flows in so long, and no more. Over four hops of
0.2 s, the most that a scenario may have, they take as long: only worse radio slows a transfer down."""
PROGRESS_WITHIN_S = 3.0
"""[choice] A giver gives up without another acknowledgement for so long; it has stopped giving long before."""
KNOWN_FOR_S = 1.5
"""[choice] A receiver's XferIn heard so long before an order is its value at the order; it comes once a second."""

OrderKey = tuple[int, int, int, int]


class TransferSide(IntEnum):
    """param2 of MAV_CMD_USER_1."""

    STOP = 0
    GIVE = 1
    RECEIVE = 2
    SETTLE = 3


@dataclass(frozen=True)
class TransferOrder:
    """One transfer as the supervisor ordered it; `giver_start_j` is the giver's XferOut at the start.

    `limit_j` of SETTLE is what the receiver has credited in all.
    """

    partner: int
    role: TransferSide
    limit_j: float
    rate_w: float
    transfer_id: int
    giver_start_j: int

    @property
    def key(self) -> OrderKey:
        """Key that distinguishes one transfer from all others."""
        return self.partner, self.role, self.transfer_id, self.giver_start_j


@dataclass(frozen=True)
class Envelope:
    """Distance and speed of a giver that allow a receiver to take from it."""

    capture_m: float
    relative_speed_m_s: float


@dataclass(frozen=True)
class Neighbour:
    """The partner as its FOLLOW_TARGET reported it last, in the own local frame."""

    p_ned: tuple[float, float, float]
    v_ned: tuple[float, float, float]
    own_v_ned: tuple[float, float, float]
    """own velocity at that time: where reports are lost, both turn before the next one comes"""
    seen_s: float


def refusal(
    neighbour: Neighbour | None,
    p_ned: tuple[float, float, float],
    now_s: float,
    envelope: Envelope,
) -> str | None:
    """Why a receiver at `p_ned` will not take from its partner; None when it will."""
    if neighbour is None or now_s - neighbour.seen_s > SILENCE_S:
        return "the giver is silent"
    age_s = now_s - neighbour.seen_s
    there = tuple(p + v * age_s for p, v in zip(neighbour.p_ned, neighbour.v_ned, strict=True))
    distance_m = dist(there, p_ned)
    if distance_m > envelope.capture_m:
        return f"the giver is {distance_m:.1f} m away"
    speed_m_s = dist(neighbour.v_ned, neighbour.own_v_ned)
    if speed_m_s > envelope.relative_speed_m_s:
        return f"the giver moves at {speed_m_s:.1f} m/s"
    return None


class Transfer:
    """One vehicle's side of a transfer in progress."""

    def __init__(self, order: TransferOrder, now_s: float, start_in_j: int | None = None) -> None:
        """`start_in_j`: the receiver's XferIn before the first joule; None where its giver has not heard it yet."""
        self.order = order
        self.moved_j = 0
        """whole joules given or received so far"""
        self._fraction_j = 0.0
        self._reported_j = 0
        self._progress_s = now_s
        self._start_in_j = start_in_j
        self._acknowledged_j = 0

    @property
    def touched(self) -> bool:
        """Whether joules have moved, or were reported to be on their way."""
        return self.moved_j > 0 or self._reported_j > 0

    def stopped_by(self, stop: TransferOrder) -> bool:
        """Whether a STOP means this transfer: 0 stands for any partner or id."""
        return stop.partner in (0, self.order.partner) and stop.transfer_id in (0, self.order.transfer_id)

    @property
    def _ahead_j(self) -> float:
        """Joules that may leave the giver now: it is not to be farther ahead of the acknowledged ones."""
        if self._start_in_j is None:
            return 0.0
        most_j = max(self.order.rate_w * UNACKNOWLEDGED_S, 1.0)
        return max(most_j - (self.moved_j - self._acknowledged_j), 0.0)

    def give(self, dt_s: float, available_j: float) -> int:
        """Whole joules that leave the giver in `dt_s`, of what it has."""
        wanted_j = self._fraction_j + self.order.rate_w * dt_s
        whole_j = floor(min(wanted_j, self.order.limit_j - self.moved_j, self._ahead_j, max(available_j, 0.0)))
        self._fraction_j = min(wanted_j - whole_j, 1.0)
        self.moved_j += whole_j
        return whole_j

    def receive_in(self, xfer_in_j: int, now_s: float) -> None:
        """Take in the receiver's XferIn, at the giver."""
        if self._start_in_j is None:
            self._start_in_j, self._progress_s = xfer_in_j, now_s
        acknowledged_j = min(xfer_in_j - self._start_in_j, self.moved_j)
        if acknowledged_j > self._acknowledged_j:
            self._acknowledged_j, self._progress_s = acknowledged_j, now_s

    def receive_out(self, xfer_out_j: int) -> None:
        """Take in the giver's XferOut, at the receiver."""
        self._reported_j = max(self._reported_j, xfer_out_j - self.order.giver_start_j)

    def credit(self, room_j: float) -> int:
        """Whole joules that the receiver books now: all that were reported and that it has room for."""
        whole_j = min(self._reported_j - self.moved_j, floor(max(room_j, 0.0)))
        self.moved_j += whole_j
        return whole_j

    def finished(self, now_s: float) -> str | None:
        """Why a giver stops by itself; None while it goes on."""
        if self.moved_j >= floor(self.order.limit_j):
            return "limit reached"
        if now_s - self._progress_s > PROGRESS_WITHIN_S:
            return "the receiver takes no more"
        return None


class Exchange:
    """A vehicle's transfers over its life: both counters, the neighbours it knows, and the transfer in progress."""

    given_j: int
    received_j: int
    current: Transfer | None
    ended_s: float
    neighbours: dict[int, Neighbour]
    _last_in: dict[int, tuple[int, float]]
    """the last XferIn of each vehicle that came outside a transfer, and when"""
    _ended_orders: dict[OrderKey, int]
    """joules that each order moved in the end, by its key"""

    def __init__(self) -> None:
        self.given_j = 0
        self.received_j = 0
        self.current = None
        self.ended_s = -inf
        self.neighbours, self._last_in, self._ended_orders = {}, {}, {}

    def refuses(
        self,
        order: TransferOrder,
        p_ned: tuple[float, float, float],
        now_s: float,
        envelope: Envelope,
    ) -> str | None:
        """Why an order to give or to receive cannot begin now; None when it can, or has."""
        if self.current is not None:
            return None if self.current.order == order else "another transfer is under way"
        if order.key in self._ended_orders:
            return "that transfer has ended; a new one needs a new id"
        if order.role is TransferSide.RECEIVE:
            return refusal(self.neighbours.get(order.partner), p_ned, now_s, envelope)
        return None

    def begin(self, order: TransferOrder, now_s: float) -> None:
        """Start an order that is not refused."""
        value_j, reported_s = self._last_in.get(order.partner, (0, -inf))
        self.current = Transfer(order, now_s, value_j if now_s - reported_s <= KNOWN_FOR_S else None)

    def receive_counter(self, partner: int, name: str, value_j: int, now_s: float) -> None:
        """XferOut or XferIn of the partner, as relayed."""
        if self.current is None and name == "XferIn":
            self._last_in[partner] = value_j, now_s
        if self.current is None or self.current.order.partner != partner:
            return
        if name == "XferOut" and self.current.order.role is TransferSide.RECEIVE:
            self.current.receive_out(value_j)
        elif name == "XferIn" and self.current.order.role is TransferSide.GIVE:
            self.current.receive_in(value_j, now_s)

    def move(
        self,
        dt_s: float,
        now_s: float,
        p_ned: tuple[float, float, float],
        *,
        remaining_j: float,
        capacity_j: float,
        envelope: Envelope,
    ) -> tuple[int, str | None]:
        """Whole joules that go into the battery in `dt_s`, negative ones out of it, and why the transfer is over."""
        transfer = self.current
        if transfer is None:
            return 0, None
        if transfer.order.role is TransferSide.GIVE:
            joules = transfer.give(dt_s, remaining_j)
            self.given_j += joules
            return -joules, transfer.finished(now_s)
        reason = refusal(self.neighbours.get(transfer.order.partner), p_ned, now_s, envelope)
        if reason is not None:
            return 0, reason
        joules = transfer.credit(capacity_j - remaining_j)
        self.received_j += joules
        full = capacity_j - (remaining_j + joules) < 1.0
        return joules, "the battery is full" if full else None

    def end(self, now_s: float) -> str:
        """Close the transfer in progress; what it did, in words."""
        assert self.current is not None
        verb = "Gave" if self.current.order.role is TransferSide.GIVE else "Received"
        said = f"{verb} {self.current.moved_j} J"
        if self.current.touched:
            self._ended_orders[self.current.order.key] = self.current.moved_j
        self.current = None
        self.ended_s = now_s
        return said

    def settle(self, order: TransferOrder, room_j: float) -> tuple[int, str | None]:
        """Joules that come back to the giver of an order that has ended, beyond those that its receiver credited, and
        why it cannot be settled; the same again brings nothing more."""
        given = replace(order, role=TransferSide.GIVE)
        if self.current is not None and self.current.order.key == given.key:
            return 0, "that transfer has not ended"
        moved_j = self._ended_orders.get(given.key)
        if moved_j is None:
            return 0, "that transfer was not given here"
        back_j = min(max(moved_j - floor(order.limit_j), 0), floor(max(room_j, 0.0)))
        self._ended_orders[given.key] = moved_j - back_j
        self.received_j += back_j
        return back_j, None
