"""The two loops that give a vehicle its time: the supervisor's grants, or the wall clock."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol

from simvehicle.exit import ABANDONED
from simvehicle.mavlink.codec import ReceivedFrame, split
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.lockstep import Bundle, Grants, bundles, together
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
    """A unit with its connections; `supervised`, to its supervisor, is None where it lives on the wall clock."""

    unit: Unit
    supervised: Connection | None
    plain: Sequence[PlainLink]


class _Granted:
    """One unit on its supervisor's clock, from its first hello to the supervisor's silence."""

    def __init__(
        self, unit: Unit, connection: Connection, plain: Sequence[PlainLink], secret: int | None, *, shared: bool
    ) -> None:
        self._unit, self._connection, self._plain = unit, connection, plain
        self._grants = Grants(connection)
        self._hello = self._grants.hello(unit.hello(), secret or 0, shared=shared)
        self._patience_s = SILENCE_S if secret is None else math.inf
        self._last_received_s = 0.0
        self._started = False

    def look(self, now_s: float, link: SupervisedLink) -> bool:
        """Say hello until the first bundle has come; False once the supervisor has been silent for too long.

        A vehicle that the machine has kept from running has not listened: what waits for it is no silence.
        """
        if self._grants.time_ms is not None:
            return now_s - self._last_received_s < self._patience_s or link.waiting
        link.send([self._hello])
        return True

    def receive(self, frames: Sequence[ReceivedFrame]) -> list[bytes]:
        """Act on a bundle; the datagrams that answer it."""
        self._last_received_s = time.monotonic()
        action = self._grants.feed(frames)
        if action is None or isinstance(action, list):
            return action or []
        self._apply(action)
        answer = self._grants.answer(action)
        for other in self._plain:
            other.flush()
        return answer

    def _apply(self, bundle: Bundle) -> None:
        """The first bundle sets the clock, every later one is flown to."""
        unit = self._unit
        if not self._started:
            self._started = True
            unit.start_clock(bundle.time_ms, bundle.unix_us)
        for frame in bundle.frames:
            unit.receive(frame, self._connection)
        for other in self._plain:
            for frame in other.receive():
                unit.receive(frame, other.connection)
        unit.advance(bundle.time_ms)


def run_supervised(seats: Sequence[ConnectedUnit], link: SupervisedLink, secret: int | None = None) -> None:
    """Live on the supervisor's clock until it has been silent for 10 s of wall time, each unit by itself.

    Raises SystemExit then: a supervisor that ends a session ends its vehicles. With a `secret`, by which the supervisor
    knows them, they were started by its hatch, which ends them with the session: they wait for as long as that lives,
    since a supervisor may be suspended.

    Frames from plain connections wait for the next grant, so that they act at a definite time of the session.
    """
    granted: dict[int, _Granted] = {}
    for unit, connection, plain in seats:
        assert connection is not None
        granted[connection.sysid] = _Granted(unit, connection, plain, secret, shared=len(seats) > 1)
    alone = next(iter(granted.values())) if len(granted) == 1 else None
    link.wait_in_receive(HELLO_EVERY_S)
    look_s = 0.0
    while granted:
        now_s = time.monotonic()
        if now_s >= look_s:
            look_s = now_s + HELLO_EVERY_S
            for sysid in [sysid for sysid, one in granted.items() if not one.look(now_s, link)]:
                del granted[sysid]
        if not granted:
            print(f"The supervisor has been silent for {SILENCE_S:.0f} s: leaving", file=sys.stderr, flush=True)
            raise SystemExit(ABANDONED)
        datagram = link.receive()
        if datagram is None:
            continue
        if alone is not None:
            link.send(alone.receive(tuple(split(datagram))))
        else:
            own = ((granted[sysid], frames) for sysid, frames in bundles(datagram) if sysid in granted)
            for answers in together(answer for one, frames in own for answer in one.receive(frames)):
                link.send([answers])


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
