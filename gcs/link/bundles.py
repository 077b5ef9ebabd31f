"""Bundles of a tick on their way out: made for many vehicles at once, and gathered for those who share an address."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Collection, Mapping, Sequence
from itertools import groupby
from operator import itemgetter

import numpy as np

from gcs.link.link import Key
from gcs.mavlink import bundle_frames
from gcs.mavlink.bundle_frames import Bundles
from gcs.mavlink.codec import Message
from gcs.mavlink.setpoints import PlacedSetPoints

SHARED_BYTES = 4096
"""Bundles for one address are sent as soon as they are so long together: who gets them flies while others' are made."""

Address = tuple[str, int]
Cuts = list[tuple[int, int, int]]
"""`Bundles.cuts`"""
_END = itemgetter(1)


class Roster:
    """Some vehicles of a link in order, what marks their bundles (nothing where an address is not shared) and where
    they go, as arrays that serve for as many ticks as it is the same ones."""

    def __init__(self, keys: Sequence[Key], markers: Sequence[bytes], addresses: Sequence[Address]) -> None:
        self.keys = list(keys)
        count = len(self.keys)
        self._rows = np.zeros((count, bundle_frames.COLUMNS), np.int64)
        self._markers = np.zeros((count, bundle_frames.MARKER_WIDTH), np.uint8)
        for row, marks, marker, (sysid, _) in zip(self._rows, self._markers, markers, self.keys, strict=True):
            row[bundle_frames.SYSID], row[bundle_frames.MARKER_BYTES] = sysid, len(marker)
            marks[: len(marker)] = np.frombuffer(marker, np.uint8)
        self._steered: Mapping[int, int] = {}
        self._rows[:, bundle_frames.POINT] = bundle_frames.NONE
        self._left_out = self._greets = False
        """whether anyone was left out, or greeted, the last time"""
        self.rows_of = {key: row for row, key in enumerate(self.keys)}
        self.stretches: list[tuple[int, int, Address, bool]] = []
        """(first, one behind the last, address, whether it is shared) of neighbours in the order with one address"""
        for (address, shared), run in groupby(range(count), lambda k: (addresses[k], bool(markers[k]))):
            places = list(run)
            self.stretches.append((places[0], places[-1] + 1, address, shared))

    def number_cells(self) -> list[memoryview]:
        """For each of them, where the sequence number of its next frame stands: as `bundled` reads it and counts on."""
        return [row[bundle_frames.NUMBER : bundle_frames.NUMBER + 1].data for row in self._rows]

    def bundled(
        self, left_out: Sequence[int], greeted: Collection[int], points: PlacedSetPoints, grant: Message
    ) -> Bundles:
        """Bundles of all but those in the places `left_out`; `greeted`, system ids, get our HEARTBEAT. Raises
        ValueError for a set point that no frame can hold."""
        rows = self._rows
        if points.rows is not self._steered or self._left_out:
            rows[:, bundle_frames.POINT] = [points.rows.get(sysid, bundle_frames.NONE) for sysid, _ in self.keys]
            self._steered = points.rows
        if greeted or self._greets:
            rows[:, bundle_frames.GREETED] = [sysid in greeted for sysid, _ in self.keys]
        self._greets, self._left_out = bool(greeted), bool(left_out)
        if left_out:
            rows[left_out, bundle_frames.POINT] = bundle_frames.LEFT_OUT
        return bundle_frames.bundled(rows, self._markers, points, grant)


class DatagramGatherer:
    """Makes datagrams of bundles: bundles for a shared address wait for more, until there is enough, or for `flush`."""

    def __init__(self, send: Callable[[Address, bytes], None]) -> None:
        self._send = send
        self._gathered: dict[Address, bytes] = {}

    def put(self, address: Address, bundle: bytes, *, shared: bool) -> None:
        """Send a vehicle's bundle."""
        if not shared:
            self._send(address, bundle)
            return
        gathered = self._gathered.get(address, b"") + bundle
        if len(gathered) < SHARED_BYTES:
            self._gathered[address] = gathered
        else:
            self._gathered.pop(address, None)
            self._send(address, gathered)

    def put_all(self, roster: Roster, raw: bytes, cuts: Cuts, first: int, last: int) -> None:
        """As `put`, one after the other, for those in these places of the roster, whose bundles `raw` holds side by
        side."""
        for low, high, address, shared in roster.stretches:
            k, behind = max(low, first), min(high, last)
            while k < behind:
                begin = cuts[k][0]
                gathered = self._gathered.get(address, b"") if shared else b""
                enough = begin - len(gathered) + SHARED_BYTES if shared else 0
                end = bisect_left(cuts, enough, k, behind, key=_END)
                if end == behind:
                    self._gathered[address] = gathered + raw[begin : cuts[behind - 1][1]]
                else:
                    self._gathered.pop(address, None)
                    self._send(address, gathered + raw[begin : cuts[end][1]])
                k = end + 1

    def flush(self) -> None:
        """Send what still waits."""
        while self._gathered:
            self._send(*self._gathered.popitem())
