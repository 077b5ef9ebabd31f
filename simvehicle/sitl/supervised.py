"""The loop that gives vehicles the time that their supervisor grants."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any

import cython
import cython.cimports.simvehicle.mavlink.codec as codec
import cython.cimports.simvehicle.mavlink.connection as connections
import cython.cimports.simvehicle.mavlink.lockstep as lockstep
from cython.cimports.cpython.bytearray import PyByteArray_AS_STRING
from cython.cimports.cpython.bytes import PyBytes_AS_STRING
from cython.cimports.posix.time import CLOCK_MONOTONIC, clock_gettime, timespec
from cython.cimports.simvehicle.mavlink.lockstep import SHARED_BYTES
from cython.cimports.skytender.system_calls import MSG_DONTWAIT, recv, sched_yield, send

from simvehicle.mavlink.codec import ReceivedFrame
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.lockstep import Bundle, Grants
from simvehicle.sitl.link import SUPERVISED_BYTES, PlainLink, SupervisedLink
from simvehicle.sitl.loop import ConnectedUnit
from simvehicle.sitl.unit import Unit
from skytender.exit import ABANDONED

HELLO_EVERY_S = 0.1
SILENCE_S = 10.0
LOOK_NS = 500_000
"""For so long the next grant is looked for, where the last came as soon, and the processor left to others meanwhile: to
be woken from sleep costs a vehicle and its supervisor a third of a short tick."""
CROWDED_NS = 1_300_000
"""Others that keep the processor for so long need it themselves: sleep is better then, since to be woken gives it back
at once."""
LEAST_SLEEPS, MOST_SLEEPS = 50, 4096
"""So many waits are slept through then: twice as many each time, one less for each wait that was looked through."""


class Granted:
    """One unit on its supervisor's clock, from its first hello to the supervisor's silence."""

    connection: Connection
    _unit: Unit
    _plain: list[PlainLink]
    _grants: Grants
    _hello: bytes
    _patience_s: float
    _last_received_s: float
    _started: bool
    _time_ms: int

    def __init__(
        self, unit: Unit, connection: Connection, plain: Sequence[PlainLink], secret: int | None, shared: bool
    ) -> None:
        self._unit, self.connection, self._plain = unit, connection, list(plain)
        self._grants = Grants(connection)
        self._hello = self._grants.hello(unit.hello(), secret or 0, shared=shared)
        self._patience_s = SILENCE_S if secret is None else math.inf
        self._last_received_s = 0.0
        self._started = False
        self._time_ms = 0

    def look(self, now_s: float, link: SupervisedLink) -> bool:
        """Say hello until the first bundle has come; False once the supervisor has been silent for too long.

        A vehicle that the machine has kept from running has not listened: what waits for it is no silence.
        """
        if self._started:
            return now_s - self._last_received_s < self._patience_s or link.waiting
        link.send([self._hello])
        return True

    def receive(self, frames: list[ReceivedFrame], now_s: float, answers: list[bytes]) -> None:
        """Act on a bundle; the datagrams that answer it go behind `answers`."""
        self._last_received_s = now_s
        action = self._grants.feed(frames)
        if action is None:
            return
        if isinstance(action, list):
            answers += action
            return
        self._apply(action)
        answers += self._grants.answer(action)
        for other in self._plain:
            other.flush()

    def _apply(self, bundle: Bundle) -> None:
        """The first bundle sets the clock, every later one is flown to."""
        unit = self._unit
        if not self._started:
            self._started = True
            unit.start_clock(bundle.time_ms, bundle.unix_us)
        elif bundle.time_ms - self._time_ms != self.connection.streams.tick_ms:
            for connection in (self.connection, *(link.connection for link in self._plain)):
                connection.streams.tick_ms = bundle.time_ms - self._time_ms
        self._time_ms = bundle.time_ms
        for frame in bundle.frames:
            unit.receive(frame, self.connection)
        for other in self._plain:
            for frame in other.receive():
                unit.receive(frame, other.connection)
        unit.advance(bundle.time_ms)


class GrantReader:
    """Receives from the supervisor's socket, which waits in `recv` for a time of its own."""

    sleeps_left: int
    """how many of the next waits are slept through, because other programs keep the processor"""
    last_ns: int
    """how long the last wait was"""
    _fd: int
    _room: bytearray
    _most: int
    _sleeps: int

    def __init__(self, link: SupervisedLink) -> None:
        self._fd, self._room, self._most = link.fileno(), bytearray(SUPERVISED_BYTES), SUPERVISED_BYTES
        self.sleeps_left, self.last_ns, self._sleeps = 0, LOOK_NS, LEAST_SLEEPS

    def receive(self) -> bytes:
        """The next datagram; none where none came in the socket's time, or the system was interrupted."""
        into = PyByteArray_AS_STRING(self._room)
        with cython.nogil:
            have = self._wait(into)
        return into[:have] if have > 0 else b""

    def _wait(self, into: Any) -> int:
        begun_ns = now_ns = _now_ns()
        have = -1
        if self.sleeps_left > 0:
            self.sleeps_left -= 1
        elif self.last_ns < LOOK_NS:
            self._sleeps = max(self._sleeps - 1, LEAST_SLEEPS)
            while have < 0 and now_ns - begun_ns < LOOK_NS:
                have = recv(self._fd, into, self._most, MSG_DONTWAIT)
                if have < 0:
                    sched_yield()
                    left_ns, now_ns = now_ns, _now_ns()
                    if now_ns - left_ns >= CROWDED_NS:
                        self.sleeps_left, self._sleeps = self._sleeps, min(2 * self._sleeps, MOST_SLEEPS)
        if have < 0:
            have = recv(self._fd, into, self._most, 0)
            now_ns = _now_ns()
        self.last_ns = now_ns - begun_ns
        return have


def run_supervised(
    seats: Sequence[ConnectedUnit],
    link: SupervisedLink,
    secret: int | None = None,
    clock: Callable[[], float] = time.monotonic,
) -> None:
    """Live on the supervisor's clock until it has been silent for 10 s of wall time, each unit by itself.

    Raises SystemExit then: a supervisor that ends a session ends its vehicles. With a `secret`, by which the supervisor
    knows them, they were started by its fork server, which ends them with the session: they wait for as long as that
    lives, since a supervisor may be suspended.

    Frames from plain connections wait for the next grant, so that they act at a definite time of the session.
    """
    shared = len(seats) > 1
    granted = {
        connection.sysid: Granted(unit, connection, plain, secret, shared)
        for unit, connection, plain in seats
        if connection is not None
    }
    link.wait_in_receive(HELLO_EVERY_S)
    reader, fd, look_s = GrantReader(link), link.fileno(), 0.0
    now_s = clock()
    while granted:
        if now_s >= look_s:
            look_s = now_s + HELLO_EVERY_S
            granted = {sysid: one for sysid, one in granted.items() if one.look(now_s, link)}
        datagram = reader.receive()
        answers: list[bytes] = []
        now_s = clock()
        if not datagram:
            continue
        if not shared:
            for one in granted.values():
                one.receive(codec.split(datagram), now_s, answers)
            _send(fd, answers)
            continue
        for sysid, frames in lockstep.bundles(datagram):
            if sysid not in granted:
                continue
            one = granted[sysid]
            one.receive(frames, now_s, answers)
            if connections.size_of(answers, 0, len(answers)) >= SHARED_BYTES:
                _send(fd, [connections.together(answers, 0, len(answers))])
                answers = []
        if answers:
            _send(fd, [connections.together(answers, 0, len(answers))])
    print(f"The supervisor has been silent for {SILENCE_S:.0f} s: leaving", file=sys.stderr, flush=True)
    raise SystemExit(ABANDONED)


def _send(fd: int, datagrams: list[bytes]) -> None:
    """Send; a supervisor that is not there is no error."""
    for datagram in datagrams:
        send(fd, PyBytes_AS_STRING(datagram), len(datagram), MSG_DONTWAIT)


def _now_ns() -> int:
    now = timespec(0, 0)
    clock_gettime(CLOCK_MONOTONIC, cython.address(now))
    return now.tv_sec * 1_000_000_000 + now.tv_nsec
