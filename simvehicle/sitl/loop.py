"""The two loops that give a vehicle its time: the supervisor's grants, or the wall clock."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol

from simvehicle.mavlink.codec import ReceivedFrame, split
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.lockstep import Bundle, Grants, bundles, together
from simvehicle.sitl.link import PlainLink, SupervisedLink
from simvehicle.sitl.steady import Flyable, SteadyFlight
from skytender.exit import ABANDONED

HELLO_EVERY_S = 0.1
SILENCE_S = 10.0
FREE_TICK_MS = 20


class Unit(Protocol):
    """Unit that a loop drives: a vehicle with its services, or traffic."""

    def hello(self) -> object:
        """The HEARTBEAT of the hello."""

    def start_clock(self, time_ms: int, unix_us: int) -> None:
        """Set the clock without a step."""

    def receive(self, frame: ReceivedFrame, connection: Connection) -> None:
        """Act on one frame."""

    def advance(self, to_ms: int) -> None:
        """Go to a time and queue what became due."""


class ConnectedUnit(NamedTuple):
    """A unit with its connections; `supervised`, to its supervisor, is None where it lives on the wall clock."""

    unit: Unit
    supervised: Connection | None
    plain: Sequence[PlainLink]
    flyable: Flyable | None = None
    """its vehicle, if that may be flown in compiled code where nothing else is to be done"""


class _Granted:
    """One unit on its supervisor's clock, from its first hello to the supervisor's silence."""

    def __init__(
        self, unit: Unit, connection: Connection, plain: Sequence[PlainLink], secret: int | None, *, shared: bool
    ) -> None:
        self._unit, self.connection, self._plain = unit, connection, plain
        self.grants = Grants(connection)
        self._hello = self.grants.hello(unit.hello(), secret or 0, shared=shared)
        self._patience_s = SILENCE_S if secret is None else math.inf
        self._last_received_s = 0.0
        self._ticks = 0
        self._started = False

    def look(self, now_s: float, ticks: int, link: SupervisedLink) -> bool:
        """Say hello until the first bundle has come; False once the supervisor has been silent for too long: `ticks`,
        flown steadily so far, are no more than at the last look, and nothing else has come.

        A vehicle that the machine has kept from running has not listened: what waits for it is no silence.
        """
        if ticks != self._ticks:
            self._ticks, self._last_received_s = ticks, now_s
        if self.grants.time_ms is not None:
            return now_s - self._last_received_s < self._patience_s or link.waiting
        link.send([self._hello])
        return True

    def receive(self, frames: Sequence[ReceivedFrame], steady: SteadyFlight, row: int) -> list[bytes]:
        """Act on a bundle that is not flown steadily; the datagrams that answer it."""
        steady.take_back(row)
        self._last_received_s = time.monotonic()
        action = self.grants.feed(frames)
        if action is None or isinstance(action, list):
            return action or []
        self._apply(action)
        answer = self.grants.answer(action)
        for other in self._plain:
            other.flush()
        steady.hand_over(row, action.frames)
        return answer

    def _apply(self, bundle: Bundle) -> None:
        """The first bundle sets the clock, every later one is flown to."""
        unit = self._unit
        if not self._started:
            self._started = True
            unit.start_clock(bundle.time_ms, bundle.unix_us)
        for frame in bundle.frames:
            unit.receive(frame, self.connection)
        for other in self._plain:
            for frame in other.receive():
                unit.receive(frame, other.connection)
        unit.advance(bundle.time_ms)


def run_supervised(seats: Sequence[ConnectedUnit], link: SupervisedLink, secret: int | None = None) -> None:
    """Live on the supervisor's clock until it has been silent for 10 s of wall time, each unit by itself.

    Raises SystemExit then: a supervisor that ends a session ends its vehicles. With a `secret`, by which the supervisor
    knows them, they were started by its fork server, which ends them with the session: they wait for as long as that
    lives, since a supervisor may be suspended.

    Frames from plain connections wait for the next grant, so that they act at a definite time of the session.
    """
    granted = [
        _Granted(unit, connection, plain, secret, shared=len(seats) > 1)
        for unit, connection, plain, _ in seats
        if connection is not None
    ]
    steady = SteadyFlight(
        [
            (None if seat.plain else seat.flyable, one.connection, one.grants)
            for seat, one in zip(seats, granted, strict=True)
        ]
    )
    held = {one.connection.sysid: row for row, one in enumerate(granted)}
    link.wait_in_receive(HELLO_EVERY_S)
    look_s = 0.0
    while held:
        now_s = time.monotonic()
        if now_s >= look_s:
            look_s = now_s + HELLO_EVERY_S
            for sysid, row in list(held.items()):
                if not granted[row].look(now_s, steady.ticks(row), link):
                    steady.take_back(held.pop(sysid))
        left = steady.serve(link) if held else []
        if len(seats) == 1:
            link.send([answer for part in left for answer in granted[0].receive(tuple(split(part)), steady, 0)])
            continue
        own = ((held[sysid], frames) for part in left for sysid, frames in bundles(part) if sysid in held)
        for datagram in together(answer for row, frames in own for answer in granted[row].receive(frames, steady, row)):
            link.send([datagram])
    print(f"The supervisor has been silent for {SILENCE_S:.0f} s: leaving", file=sys.stderr, flush=True)
    raise SystemExit(ABANDONED)


def run_free(seats: Sequence[ConnectedUnit], *, stop: Callable[[], bool] = lambda: False) -> None:
    """Live on the wall clock, 50 ticks a second; ticks that come late are caught up with, never dropped."""
    start_s = time.monotonic()
    for unit, *_ in seats:
        unit.start_clock(0, time.time_ns() // 1000)
    now_ms = 0
    while not stop():
        wait_ms = now_ms + FREE_TICK_MS - 1e3 * (time.monotonic() - start_s)
        if wait_ms > 0.0:
            time.sleep(wait_ms / 1e3)
        now_ms = int(1e3 * (time.monotonic() - start_s))
        for unit, _, plain, _ in seats:
            for link in plain:
                for frame in link.receive():
                    unit.receive(frame, link.connection)
            unit.advance(now_ms)
            for link in plain:
                link.flush()
