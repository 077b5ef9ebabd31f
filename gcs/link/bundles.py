"""Bundles of a tick on their way out: made for many vehicles at once, and gathered for vehicles that share an
address."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Sequence
from itertools import groupby
from operator import itemgetter
from typing import NamedTuple

import cython
import numpy as np
from cython.cimports.gcs.link.bundles import NO_SOCKET, SHARED_BYTES, receiver_at
from cython.cimports.gcs.mavlink.bundle_frames import LEFT_OUT, NONE, write_bundles
from cython.cimports.skytender.system_calls import sendto, sockaddr

from gcs.link.inbox import Address, packed
from gcs.link.link import Key, TickGrants
from gcs.mavlink import bundle_frames, codec
from gcs.mavlink.bundle_frames import Bytes, Floats, Ints
from gcs.mavlink.ids import STATION

# Bundles for one address are sent as soon as they are SHARED_BYTES long together: its vehicles fly while bundles of
# others are made. NO_SOCKET: where nothing is to be sent.

_END = itemgetter(1)
_TO = 3
_SHARED = 2
"""Columns of where a bundle goes, in the order of the struct Receiver in bundles.pxd; the place of the last."""


class Bundles(NamedTuple):
    """Bundles of n vehicles."""

    raw: bytes
    """one behind the other"""
    cuts: Ints
    """(n, 3) where each begins and ends, and how many frames there are with it"""
    spans: Ints
    """(m, 2) where each frame begins and ends; markers are none"""


class Recipients:
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
        self._steered: tuple[int, ...] = ()
        self._rows[:, bundle_frames.POINT] = NONE
        self._left_out = self._beats = False
        """whether a vehicle was left out, or sent a HEARTBEAT, the last time"""
        self.rows_of = {key: row for row, key in enumerate(self.keys)}
        self.stretches: list[tuple[int, int, Address, bool]] = []
        """(first, one behind the last, address, whether it is shared) of neighbours in the order with one address"""
        for (address, shared), run in groupby(range(count), lambda k: (addresses[k], bool(markers[k]))):
            places = list(run)
            self.stretches.append((places[0], places[0] + len(places), address, shared))
        self.in_turn = len({stretch[2] for stretch in self.stretches}) == len(self.stretches)
        """whether those with one address are neighbours: `bundled` can send to all of them"""
        self._out = np.empty(count * bundle_frames.BUNDLE_BYTES, np.uint8)
        self._templates = bundle_frames.made_templates()
        self._to = np.zeros((count, _TO), np.int64)
        for to, address, marker in zip(self._to, addresses, markers, strict=True):
            to[:_SHARED], to[_SHARED] = np.frombuffer(packed(address), np.int64), bool(marker)

    def number_cells(self) -> list[memoryview]:
        """For each of them, where the sequence number of its next frame stands: as `bundled` reads it and counts on."""
        return [row[bundle_frames.NUMBER : bundle_frames.NUMBER + 1].data for row in self._rows]

    def bundled(self, left_out: Sequence[int], grants: TickGrants, fd: int = NO_SOCKET) -> Bundles:
        """Bundles of all but those in the places `left_out`, sent through this socket. Raises ValueError for a set
        point that no frame can hold: nothing is sent then."""
        points, heartbeat_due = grants.points, grants.heartbeat_due
        rows = self._rows
        if points.sysids != self._steered or self._left_out:
            point_of = {sysid: row for row, sysid in enumerate(points.sysids)}
            rows[:, bundle_frames.POINT] = [point_of.get(sysid, NONE) for sysid, _ in self.keys]
            self._steered = points.sysids
        if heartbeat_due or self._beats:
            rows[:, bundle_frames.HEARTBEAT_DUE] = [sysid in heartbeat_due for sysid, _ in self.keys]
        self._beats, self._left_out = bool(heartbeat_due), bool(left_out)
        if left_out:
            rows[left_out, bundle_frames.POINT] = LEFT_OUT
        count = len(rows)
        cuts, spans = np.empty((count, 3), np.int64), np.empty((count * bundle_frames.MOST_FRAMES, 2), np.int64)
        end, frames, refused = _bundle(
            self._out, rows, self._markers, points.values, *self._templates, cuts, spans,
            points.time_ms, grants.unix_us, grants.t_ms, fd, self._to,
        )  # fmt: skip
        if refused != NONE:
            codec.frame(points.message(points.sysids[refused]), 0, *STATION)
        return Bundles(self._out[:end].tobytes(), cuts, spans[:frames])


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

    def put_all(
        self, recipients: Recipients, raw: bytes, cuts: Sequence[tuple[int, int, int]], first: int, last: int
    ) -> None:
        """As `put`, one after the other, for those in these places of the recipients, whose bundles `raw` holds side by
        side, as `Bundles.cuts` says."""
        for low, high, address, shared in recipients.stretches:
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


def _send_all(fd: int, out: Bytes, cuts: Ints, to: Ints) -> None:
    """Send bundles, those for a shared address together."""
    count, k = cuts.shape[0], 0
    while k < count:
        first, receiver = k, receiver_at(to, k)
        k += 1
        while k < count and receiver.shared and receiver_at(to, k).address[0] == receiver.address[0]:
            if cuts[k - 1, 1] - cuts[first, 0] >= SHARED_BYTES:
                break
            k += 1
        begin, size = cuts[first, 0], cuts[k - 1, 1] - cuts[first, 0]
        if size:
            address = cython.cast(cython.pointer(sockaddr), receiver.address)
            sendto(fd, cython.address(out[begin]), size, 0, address, cython.sizeof(receiver.address))


def _bundle(
    out: Bytes,
    rows: Ints,
    markers: Bytes,
    values: Floats,
    templates: Bytes,
    sizes: Ints,
    cuts: Ints,
    spans: Ints,
    point_ms: int,
    unix_us: int,
    grant_ms: int,
    fd: int,
    to: Ints,
) -> tuple[int, int, int]:
    """Write bundles as `write_bundles` does, and send them through the socket `fd` unless that is NO_SOCKET, to (n,
    _TO). (Where they end, frames, row of a set point that no frame can hold, or NONE.)"""
    end, refused = write_bundles(out, rows, markers, values, templates, sizes, cuts, spans, point_ms, unix_us, grant_ms)
    count = cuts.shape[0]
    if refused != NONE or not count:
        return end, 0, refused
    if fd != NO_SOCKET:
        _send_all(fd, out, cuts, to)
    return end, cuts[count - 1, 2], refused
