"""Units with their connections, and the loop that drives them on the wall clock; `supervised.py` has the other."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import NamedTuple

from simvehicle.mavlink.connection import Connection
from simvehicle.sitl.link import PlainLink
from simvehicle.sitl.unit import Unit

FREE_TICK_MS = 20


class ConnectedUnit(NamedTuple):
    """A unit with its connections; `supervised`, to its supervisor, is None where it lives on the wall clock."""

    unit: Unit
    supervised: Connection | None
    plain: Sequence[PlainLink]


def run_free(seats: Sequence[ConnectedUnit], *, stop: Callable[[], bool] = lambda: False) -> None:
    """Live on the wall clock, 50 ticks a second; ticks that come late are caught up with, never dropped."""
    start_s = time.monotonic()
    for unit, _, plain in seats:
        unit.start_clock(0, time.time_ns() // 1000)
        for link in plain:
            link.connection.streams.tick_ms = FREE_TICK_MS
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
