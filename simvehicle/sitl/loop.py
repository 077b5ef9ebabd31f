"""The two loops that give a vehicle its time: the supervisor's grants, or the wall clock."""

from __future__ import annotations

import math
import select
import sys
import time
from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol

from simvehicle.exit import ABANDONED
from simvehicle.mavlink.codec import ReceivedFrame
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.lockstep import Bundle, Grants
from simvehicle.sitl.link import PlainLink, SupervisedLink

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
    """A unit with its connections; `link` is None where it lives on the wall clock."""

    unit: Unit
    link: SupervisedLink | None
    plain: Sequence[PlainLink]


class _Granted:
    """One unit on its supervised link, from its first hello to the supervisor's silence."""

    def __init__(self, unit: Unit, link: SupervisedLink, plain: Sequence[PlainLink], secret: int | None) -> None:
        self._unit, self._link, self._plain = unit, link, plain
        self._grants = Grants(link.connection)
        self._hello = self._grants.hello(unit.hello(), secret or 0)
        self._patience_s = SILENCE_S if secret is None else math.inf
        self._last_received_s = 0.0
        self._started = False

    def look(self, now_s: float) -> bool:
        """Say hello until the first bundle has come; False once the supervisor has been silent for too long.

        A vehicle that the machine has kept from running has not listened: what waits for it is no silence.
        """
        if self._grants.time_ms is not None:
            return now_s - self._last_received_s < self._patience_s or self._link.waiting
        self._link.send([self._hello])
        return True

    def receive(self) -> None:
        """Act on the datagram that waits."""
        datagram = self._link.receive()
        if datagram is None:
            return
        self._last_received_s = time.monotonic()
        action = self._grants.feed(datagram)
        if isinstance(action, list):
            self._link.send(action)
        elif action is not None:
            self._apply(action)
            self._link.send(self._grants.answer(action))
            for other in self._plain:
                other.flush()

    def _apply(self, bundle: Bundle) -> None:
        """The first bundle sets the clock, every later one is flown to."""
        unit = self._unit
        if not self._started:
            self._started = True
            unit.start_clock(bundle.time_ms, bundle.unix_us)
        for frame in bundle.frames:
            unit.receive(frame, self._link.connection)
        for other in self._plain:
            for frame in other.receive():
                unit.receive(frame, other.connection)
        unit.advance(bundle.time_ms)


def run_supervised(seats: Sequence[ConnectedUnit], secret: int | None = None) -> None:
    """Live on the supervisor's clock until it has been silent for 10 s of wall time, each unit by itself.

    Raises SystemExit then: a supervisor that ends a session ends its vehicles. With a `secret`, by which the supervisor
    knows them, they were started by its hatch, which ends them with the session: they wait for as long as that lives,
    since a supervisor may be suspended.

    Frames from plain connections wait for the next grant, so that they act at a definite time of the session.
    """
    poll = select.poll()
    granted: dict[int, _Granted] = {}
    for unit, link, plain in seats:
        assert link is not None
        granted[link.socket.fileno()] = _Granted(unit, link, plain, secret)
        poll.register(link.socket, select.POLLIN)
        if len(seats) == 1:
            link.wait_in_receive(HELLO_EVERY_S)
    alone = next(iter(granted.values())) if len(granted) == 1 else None
    look_s = 0.0
    while granted:
        now_s = time.monotonic()
        if now_s >= look_s:
            look_s = now_s + HELLO_EVERY_S
            for fd in [fd for fd, one in granted.items() if not one.look(now_s)]:
                poll.unregister(fd)
                del granted[fd]
        if not granted:
            print(f"The supervisor has been silent for {SILENCE_S:.0f} s: leaving", file=sys.stderr, flush=True)
            raise SystemExit(ABANDONED)
        if alone is not None:
            alone.receive()
            continue
        for fd, _ in poll.poll(1e3 * HELLO_EVERY_S):
            granted[fd].receive()


def run_free(seats: Sequence[ConnectedUnit], *, stop: Callable[[], bool] = lambda: False) -> None:
    """Live on the wall clock, 50 ticks a second; ticks that come late are caught up with, never dropped."""
    start_s = time.monotonic()
    for unit, _, _ in seats:
        unit.start_clock(0, time.time_ns() // 1000)
    now_ms = 0
    while not stop():
        wait_ms = now_ms + FREE_TICK_MS - 1e3 * (time.monotonic() - start_s)
        if wait_ms > 0.0:
            time.sleep(wait_ms / 1e3)
        now_ms = int(1e3 * (time.monotonic() - start_s))
        for unit, _, plain in seats:
            for link in plain:
                for frame in link.receive():
                    unit.receive(frame, link.connection)
            unit.advance(now_ms)
            for link in plain:
                link.flush()
