"""The two loops that give a vehicle its time: the supervisor's grants, or the wall clock."""

from __future__ import annotations

import select
import time
from collections.abc import Callable, Sequence
from typing import Protocol

from simvehicle.link import PlainLink, SupervisedLink
from simvehicle.mavlink.codec import Frame
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.lockstep import Bundle, Grants

HELLO_EVERY_S = 0.1
SILENCE_S = 10.0
FREE_TICK_MS = 20


class Unit(Protocol):
    """What a loop drives: a vehicle with its services, or traffic."""

    def hello(self) -> object:
        """The HEARTBEAT of the hello."""

    def start_clock(self, time_ms: int, unix_us: int) -> None:
        """Set the clock without a step."""

    def receive(self, frame: Frame, connection: Connection) -> None:
        """Act on one frame."""

    def advance(self, to_ms: int) -> None:
        """Go to a time and queue what became due."""


def run_supervised(unit: Unit, link: SupervisedLink, plain: Sequence[PlainLink]) -> None:
    """Live on the supervisor's clock until it has been silent for 10 s of wall time.

    Frames from plain connections wait for the next grant, so that they act at a definite time of the session.
    """
    grants = Grants(link.connection)
    hello = grants.hello(unit.hello())
    poll = select.poll()
    poll.register(link.socket, select.POLLIN)
    heard_s = time.monotonic()
    hello_due_s = heard_s
    started = False
    while True:
        now_s = time.monotonic()
        if grants.time_ms is None:
            if now_s >= hello_due_s:
                link.send([hello])
                hello_due_s = now_s + HELLO_EVERY_S
            wait_s = hello_due_s - now_s
        else:
            wait_s = heard_s + SILENCE_S - now_s
            if wait_s <= 0.0:
                return
        poll.poll(max(1e3 * wait_s, 1.0))
        while (datagram := link.receive()) is not None:
            action = grants.feed(datagram)
            heard_s = time.monotonic()
            if isinstance(action, list):
                link.send(action)
            elif action is not None:
                started = _take(unit, action, started, link, plain)
                link.send(grants.answer(action))
                for other in plain:
                    other.flush()


def _take(unit: Unit, bundle: Bundle, started: bool, link: SupervisedLink, plain: Sequence[PlainLink]) -> bool:
    """Apply a bundle: the first sets the clock, every later one is flown to; returns True, the clock being set."""
    if not started:
        unit.start_clock(bundle.time_ms, bundle.unix_us)
    for frame in bundle.frames:
        unit.receive(frame, link.connection)
    for other in plain:
        for frame in other.receive():
            unit.receive(frame, other.connection)
    unit.advance(bundle.time_ms)
    return True


def run_free(unit: Unit, plain: Sequence[PlainLink], *, stop: Callable[[], bool] = lambda: False) -> None:
    """Live on the wall clock, 50 ticks a second; ticks that come late are caught up with, never dropped."""
    start_s = time.monotonic()
    unit.start_clock(0, time.time_ns() // 1000)
    now_ms = 0
    while not stop():
        wait_ms = now_ms + FREE_TICK_MS - 1e3 * (time.monotonic() - start_s)
        if wait_ms > 0.0:
            time.sleep(wait_ms / 1e3)
        now_ms = int(1e3 * (time.monotonic() - start_s))
        for link in plain:
            for frame in link.receive():
                unit.receive(frame, link.connection)
        unit.advance(now_ms)
        for link in plain:
            link.flush()
