"""The times of a recording's frames: its stamps as they are, or as they are judged to be (recorded_clock.py)."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink import codec, records
from gcs.recording.times import recorded_clock
from gcs.recording.times.recorded_clock import LATEST_US
from gcs.recording.times.vehicle_clock import SECOND_US, VehicleClock, disagree
from gcs.recording.tlog_walk import AT, COMPID, MSGID, SYSID, T_US, Chunk, IntArray
from skytender import mavlink as mav
from skytender.mavlink import MESSAGES

BOOT_FIELD, USEC_FIELD = "time_boot_ms", "time_usec"
_KINDS = {BOOT_FIELD: np.dtype("<u4"), USEC_FIELD: np.dtype("<u8")}
_OLDER_HEADER_BYTES = 6
"""Before a payload of MAVLink 1."""
MOST_CLOCKS = 8
"""Greatest number of senders whose clocks are read: the ones with the most times."""
ASKED = 1 << 14
"""So many frames of a chunk are asked at first: some a second of each of 254 vehicles."""


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


def judge(walk: Callable[[], Iterable[Chunk]], *, session: bool = False) -> TlogTimes:
    """Corrections for the recording that `walk` walks, each time from its beginning, with stamps as they are.

    session: as of `recorded_clock.judged`.
    """
    said, stamps_us = _Said(thinned=True), []
    for chunk in walk():
        stamps_us.append(chunk.heads[:, T_US])
        if not session:
            said.take(chunk)
    stamped_us = _joined(stamps_us)
    clocks = said.clocks()
    if not len(stamped_us) or not (recorded_clock.suspicious(stamped_us) or disagree(stamped_us, clocks)):
        return AS_STAMPED
    said = _Said()
    places_of = []
    for chunk in walk():
        said.take(chunk)
        places_of.append(chunk.begin + chunk.heads[:, AT])
    places = _joined(places_of)
    times_us, notes = recorded_clock.judged(stamped_us, said.clocks(), session=session)
    add_us = times_us - stamped_us
    begins = np.flatnonzero(np.diff(add_us, prepend=add_us[0] - 1))
    return TlogTimes(places[begins], add_us[begins], notes)


class _Said:
    """All that vehicles said of their time, chunk by chunk; thinned: once a second of theirs."""

    def __init__(self, *, thinned: bool = False) -> None:
        self._thinned = thinned
        self._count = 0
        self._parts: dict[int, list[tuple[IntArray, IntArray]]] = defaultdict(list)
        """by clock: which frames of the recording, and the times, µs"""
        self._stations: set[int] = set()

    def take(self, chunk: Chunk) -> None:
        """Add what a chunk's frames say."""
        heads, (offsets, is_usec) = chunk.heads, _clock_fields()
        msgids = np.where(heads[:, MSGID] < len(offsets), heads[:, MSGID], 0)
        rows = np.flatnonzero(offsets[msgids] >= 0)
        if self._thinned:
            rows = rows[:: len(rows) // ASKED + 1]
        msgids = msgids[rows]
        usec = is_usec[msgids]
        clock_us = _numbers(chunk, heads[rows, AT], offsets[msgids], usec)
        clock_us[~usec] *= 1000
        clock = (heads[rows, SYSID] << 8 | heads[rows, COMPID]) << 16 | np.where(usec, msgids, 0)
        possible = np.flatnonzero((clock_us > 0) & (clock_us < LATEST_US))
        by_clock = possible[np.argsort(clock[possible], kind="stable")]
        if self._thinned:
            by_clock = by_clock[_changes(clock[by_clock]) | _changes(clock_us[by_clock] // SECOND_US)]
        for mine in np.split(by_clock, np.flatnonzero(_changes(clock[by_clock]))[1:]):
            if len(mine):
                self._parts[int(clock[mine[0]])].append((self._count + rows[mine], clock_us[mine]))
        beats = chunk.table("HEARTBEAT")
        beats = beats[beats["type"] == mav.MAV_TYPE_GCS]
        self._stations.update((beats["sysid"].astype(np.int64) << 8 | beats["compid"]).tolist())
        self._count += len(heads)

    def clocks(self) -> list[VehicleClock]:
        """The clocks that said the most, that one first; other fields count of those that send no time_boot_ms."""
        said = {key: sum(len(rows) for rows, _ in parts) for key, parts in self._parts.items()}
        boots = {key >> 16 for key, count in said.items() if key & 0xFFFF == 0 and count}
        keys = [key for key in said if said[key] and key >> 16 not in self._stations]
        keys = [key for key in keys if key & 0xFFFF == 0 or key >> 16 not in boots]
        most = sorted(keys, key=lambda key: (-said[key], key))[:MOST_CLOCKS]
        return [VehicleClock(rows, _in_order(boot_us)) for rows, boot_us in (self._whole(key) for key in most)]

    def _whole(self, key: int) -> tuple[IntArray, IntArray]:
        rows, clock_us = zip(*self._parts[key], strict=True)
        return np.concatenate(rows), np.concatenate(clock_us)


def _changes(values: IntArray) -> NDArray[np.bool_]:
    """(n,) whether each is the first of all or another than the one before."""
    changes = np.ones(len(values), dtype=np.bool_)
    changes[1:] = values[1:] != values[:-1]
    return changes


def _numbers(chunk: Chunk, at: IntArray, offsets: IntArray, wide: NDArray[np.bool_]) -> IntArray:
    """(n,) numbers without a sign of 4 bytes, or of 8 where `wide`, in frames at these places."""
    octets = chunk.octets
    begins = at + offsets + np.where(octets[at] == codec.MARKER, codec.HEADER_BYTES, _OLDER_HEADER_BYTES)
    left = octets[at + 1] - offsets
    number = np.zeros(len(at), np.int64)
    for k in range(8):
        there = (k < left) & (wide | (k < 4))
        number[there] |= octets[begins[there] + k].astype(np.int64) << 8 * k
    return number


def _in_order(boot_us: IntArray) -> IntArray:
    """Times of a vehicle's clock, those that fall by less than a second, as messages out of order do, held up."""
    restarts = np.flatnonzero(np.diff(boot_us) < -SECOND_US) + 1
    return np.concatenate([np.maximum.accumulate(part) for part in np.split(boot_us, restarts)])


@cache
def _clock_fields() -> tuple[IntArray, NDArray[np.bool_]]:
    """By message id: where in its payload the sender's time stands, -1 where it has none, and whether it is in µs."""
    offsets, is_usec = np.full(1 << 16, -1, dtype=np.int64), np.zeros(1 << 16, dtype=np.bool_)
    for msgid in MESSAGES:
        names = codec.layout(msgid).record._fields
        field = next((name for name in (BOOT_FIELD, USEC_FIELD) if name in names), None)
        if field is not None and msgid < len(offsets):
            columns: Mapping[str, Any] = records.dtype(codec.layout(msgid)).fields or {}
            kind, offset = columns[field][:2]
            if kind == _KINDS[field]:
                offsets[msgid], is_usec[msgid] = offset, field == USEC_FIELD
    return offsets, is_usec


def _joined(parts: list[IntArray]) -> IntArray:
    return np.concatenate(parts) if parts else np.empty(0, np.int64)
