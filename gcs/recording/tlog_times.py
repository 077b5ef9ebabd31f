"""The times of a recording's frames: its stamps as they are, or as they are judged to be (recorded_clock.py)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from typing import NamedTuple

import numpy as np

from gcs.mavlink import dialect
from gcs.recording import recorded_clock
from gcs.recording.recorded_clock import SECOND_US, VehicleClock
from gcs.recording.tlog_walk import AT, COMPID, MSGID, SYSID, T_US, Chunk, IntArray

BOOT_FIELD = "time_boot_ms"
MOST_CLOCKS = 8
"""So many senders' clocks are asked, those that said the most."""


class TlogTimes(NamedTuple):
    """Corrections of stamps by the place of a frame in the file: from `places[k]` on, a time is its stamp plus
    `add_us[k]`. `notes` are sentences without the recording's name."""

    places: IntArray
    add_us: IntArray
    notes: list[str]

    def correct(self, chunk: Chunk) -> None:
        """Write the times that hold into the chunk's heads."""
        if len(self.places) and len(chunk.heads):
            k = np.searchsorted(self.places, chunk.begin + chunk.heads[:, AT], side="right") - 1
            chunk.heads[:, T_US] += self.add_us[np.maximum(k, 0)]


AS_STAMPED = TlogTimes(np.empty(0, np.int64), np.empty(0, np.int64), [])


def judge(walk: Callable[[], Iterator[Chunk]]) -> TlogTimes:
    """Corrections for the recording that `walk` walks, each time from its beginning, with stamps as they are."""
    stamps_us = _joined([chunk.heads[:, T_US] for chunk in walk()])
    if not len(stamps_us) or not recorded_clock.suspicious(stamps_us):
        return AS_STAMPED
    places, clocks = _clocks(walk)
    times_us, notes = recorded_clock.judged(stamps_us, clocks)
    add_us = times_us - stamps_us
    begins = np.flatnonzero(np.diff(add_us, prepend=add_us[0] - 1))
    return TlogTimes(places[begins], add_us[begins], notes)


def _clocks(walk: Callable[[], Iterator[Chunk]]) -> tuple[IntArray, list[VehicleClock]]:
    """The place of each frame, and what each sender said of its time since its start."""
    places, said = [], []
    count = 0
    for chunk in walk():
        heads = chunk.heads
        places.append(chunk.begin + heads[:, AT])
        for msgid in _timed_messages() & set(np.unique(heads[:, MSGID]).tolist()):
            rows = np.flatnonzero(heads[:, MSGID] == msgid)
            boot_us = 1000 * chunk.table(msgid)[BOOT_FIELD].astype(np.int64)
            sender = heads[rows, SYSID] << 8 | heads[rows, COMPID]
            said.append(np.column_stack((sender, count + rows, boot_us))[boot_us > 0])
        count += len(heads)
    table = np.concatenate(said) if said else np.empty((0, 3), np.int64)
    table = table[np.lexsort((table[:, 1], table[:, 0]))]
    parts = np.split(table, np.flatnonzero(np.diff(table[:, 0])) + 1)
    most = sorted((part for part in parts if len(part)), key=len, reverse=True)[:MOST_CLOCKS]
    return _joined(places), [VehicleClock(part[:, 1], _in_order(part[:, 2])) for part in most]


def _in_order(boot_us: IntArray) -> IntArray:
    """Times of a vehicle's clock, those that fall by less than a second, as messages out of order do, held up."""
    restarts = np.flatnonzero(np.diff(boot_us) < -SECOND_US) + 1
    return np.concatenate([np.maximum.accumulate(part) for part in np.split(boot_us, restarts)])


@cache
def _timed_messages() -> frozenset[int]:
    """Ids of the messages that hold the sender's time since its start."""
    return frozenset(msgid for msgid, cls in dialect.CLASSES.items() if BOOT_FIELD in cls.fieldnames)


def _joined(parts: list[IntArray]) -> IntArray:
    return np.concatenate(parts) if parts else np.empty(0, np.int64)
