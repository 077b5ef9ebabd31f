"""Units with their connections, and the loop that drives them on the wall clock; `supervised.py` has the other."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import NamedTuple

from simvehicle.mavlink.connection import Connection
from simvehicle.sitl.link import PlainLink
from simvehicle.sitl.unit import Unit

FREE_TICK_MS = 20
MOST_BEHIND_MS = 100
"""[choice] What is later, as after a process was stopped or on a machine that is too slow, becomes one long tick."""


class ConnectedUnit(NamedTuple):
    """A unit with its connections; `supervised`, to its supervisor, is None where it lives on the wall clock."""

    unit: Unit
    supervised: Connection | None
    plain: Sequence[PlainLink]


def run_free(
    seats: Sequence[ConnectedUnit],
    *,
    stop: Callable[[], bool] = lambda: False,
    clock: Callable[[], float] = time.monotonic,
    sleep: Callable[[float], object] = time.sleep,
) -> None:
    """Live on the wall clock, 50 ticks a second; ticks that come late are caught up with, up to MOST_BEHIND_MS."""
    start_s = clock()
    for unit, _, plain in seats:
        unit.start_clock(0, time.time_ns() // 1000)
        for link in plain:
            link.connection.streams.tick_ms = FREE_TICK_MS
    due_ms = 0
    while not stop():
        due_ms += FREE_TICK_MS
        behind_ms = 1e3 * (clock() - start_s) - due_ms
        if behind_ms < 0.0:
            sleep(-behind_ms / 1e3)
        elif behind_ms > MOST_BEHIND_MS:
            due_ms += int(behind_ms) // FREE_TICK_MS * FREE_TICK_MS
        for unit, _, plain in seats:
            for link in plain:
                for frame in link.receive():
                    unit.receive(frame, link.connection)
            unit.advance(due_ms)
            for link in plain:
                link.flush()
