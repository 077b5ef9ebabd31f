"""A tick's datagrams, side by side as they come from the socket, and the answers that they hold.

Most hold nothing but whole answers of vehicles that are awaited. One compiled call receives such datagrams, sees whose
they are and knows the answers for what they are, by the rules of gcs/mavlink/sequence.py; it ends early with what it
leaves to the interpreter.
"""

from __future__ import annotations

import socket
import struct
from typing import Any

import cython
import numpy as np
from cython.cimports.gcs.link.inbox import (
    _ADDRESS_BYTES,
    ALONE,
    ENOUGH,
    FULL,
    LOST,
    NOTHING,
    SHARED_BY,
    UNKNOWN,
    Datagram,
)
from cython.cimports.gcs.mavlink.frame_runs import (
    HALF,
    NO_RUN,
    NOT_GRANTED,
    NOWHERE,
    NUMBERS,
    SMALLEST_FRAME,
    Found,
    awaited_at,
    find,
    run_at,
)
from cython.cimports.skytender.system_calls import MSG_DONTWAIT, recvfrom, sched_yield, sockaddr
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans
from gcs.mavlink.datagram import AnswerRuns
from gcs.mavlink.frame_runs import COLUMNS

__all__ = [
    "ALONE", "ENOUGH", "FULL", "LOST", "NOTHING", "SHARED_BY", "UNKNOWN", "Address", "Bytes", "Inbox", "Ints", "packed",
]  # fmt: skip

Address = tuple[str, int]
Ints = NDArray[np.int64]
Bytes = NDArray[np.uint8]

_DATAGRAM_FROM = struct.Struct("=HH4s8x")
_BOUNDS = 3  # columns, as Datagram in inbox.pxd


def packed(address: Address) -> bytes:
    """An IPv4 address as the system has it, `struct sockaddr_in`."""
    host, port = address
    return _DATAGRAM_FROM.pack(socket.AF_INET, socket.htons(port), socket.inet_aton(host))


class Inbox:
    """Datagrams, and the runs of frames that were found in them.

    A call of `receive` ends with NOTHING: no further datagram is there; ENOUGH: as many wait to be looked into as were
    asked for, or as many have been taken as may be; UNKNOWN: one came from an address that is not known; FULL: there is
    no place for one; LOST: one was let go. The last bit of an address's number is ALONE where one vehicle speaks from
    there, SHARED_BY where several do.
    """

    def __init__(self, most_bytes: int, most_datagrams: int, room_bytes: int, unknown_bytes: int) -> None:
        """room_bytes: a datagram's, at most; what is longer is cut. unknown_bytes: a longer datagram of an unknown
        sender is passed over."""
        self._most_bytes, self._room_bytes, self._unknown_bytes = most_bytes, room_bytes, unknown_bytes
        self._data = np.zeros(most_bytes + 2 * room_bytes, np.uint8)
        most_frames = (most_bytes + room_bytes) // SMALLEST_FRAME
        self._begins = np.empty(most_frames + most_datagrams, np.int64)
        self._rows = np.empty((most_frames, COLUMNS), np.int64)
        self._bounds = np.empty((most_datagrams, _BOUNDS), np.int64)
        self._origins = np.empty((0, 2), np.int64)
        """the first 8 bytes of each address, which hold all of it, and its number"""
        self._sender = np.zeros(_ADDRESS_BYTES // 8, np.int64)
        self._order = np.empty(NUMBERS, np.int64)
        self._order_row = self._order
        self._forget()

    def know(self, address: Address, number: int) -> None:
        """Take in what comes from this address from now on, under this number."""
        (place,) = struct.unpack("=q8x", packed(address))
        self._origins = np.vstack((self._origins, np.array([[place, number]])))

    def forget(self, number: int) -> None:
        """Take in nothing more of the address with this number."""
        origins = np.asarray(self._origins)
        self._origins = origins[origins[:, 1] != number]

    def receive(
        self, fd: int, most: int, left: int, awaited: Ints, row_by_sysid: Ints, *, yields: int = 0, lost: bool = False
    ) -> int:
        """Receive datagrams that have come to this socket until `most` wait to be looked into, and `left` at most; look
        into those that wait, up to the first that holds something else than whole answers.

        `awaited` (vehicles, AWAITED) is filled for the vehicles whose answers were found; `row_by_sysid` (256,) are its
        rows by system id, else -1. `yields`: so often, where nothing is there, let another process run, and look again.
        `lost`: let one datagram go. With `most` 0 nothing is received. Returns what it ends with; then `answered`,
        `taken`, `stray` and `stopped` have more to say.

        `taken` is the number of datagrams that the last call has received, `answers` that of the answers that were
        found and have not been taken.
        """
        self._before = self.answers
        met: int = self._receive(fd, most, left, yields, lost)
        self._look(row_by_sysid, awaited)
        return met

    @property
    def answered(self) -> Ints:
        """Rows of `awaited` whose answers the last call has found."""
        return self._order[self._before : self.answers]

    def stray(self) -> tuple[bytes, Address]:
        """The datagram that the last call ended with, and where it came from."""
        _, port, host = _DATAGRAM_FROM.unpack(np.asarray(self._sender).tobytes())
        address = socket.inet_ntoa(host), socket.ntohs(port)
        return self._bytes(self._stray_at, self._stray_at + self._stray_bytes), address

    def stopped(self) -> tuple[int, bytes] | None:
        """(number of the address, rest) of the datagram at which looking has stopped; it waits no more. None: at
        none."""
        if self._looked == self._count:
            return None
        datagram = self._datagram(self._looked)
        self._looked += 1
        return datagram.address, self._bytes(self._stopped_at, datagram.end)

    def pop_answers(self, awaited: Ints) -> tuple[Ints, AnswerRuns]:
        """The answers that were found: their rows (n,) of `awaited`, in order, and their runs. Nothing is left."""
        data = self._bytes(0, self._used)
        rows, spans = np.empty((self.answers, COLUMNS), np.int64), np.empty((self._found.frames, 2), np.int64)
        cut = self._cut(awaited, rows, spans)
        self._forget()
        return self._order[: cut.runs], AnswerRuns(FrameSpans(data, spans[: cut.frames]), rows[: cut.runs])

    def _bytes(self, begin: int, end: int) -> bytes:
        return cython.address(self._data[0])[begin:end]

    def _datagram(self, k: int) -> Any:
        return cython.cast(cython.pointer(Datagram), cython.address(self._bounds[k, 0]))

    def _forget(self) -> None:
        """Begin again with an empty buffer."""
        self._found = Found(0, 0)
        self._used = self._count = self._looked = self.answers = 0

    def _number(self, known: Any) -> Any:
        """Number of the address that the last datagram came from, else NOWHERE. known: the place of that of the one
        before, changed; most answer in turn."""
        count = self._origins.shape[0]
        for k in range(count):
            place = (known[0] + k) % count
            if self._origins[place, 0] == self._sender[0]:
                known[0] = place
                return self._origins[place, 1]
        return NOWHERE

    def _receive(self, fd: int, most: int, left: int, yields: int, lost: bool) -> Any:
        """As `receive`, without looking into what came."""
        if self._looked == self._count and self.answers == 0:
            self._forget()
        known = 0
        self.taken = 0
        while self._count - self._looked < most and self.taken < left:
            at = self._used
            origin_bytes = _ADDRESS_BYTES
            origin = cython.cast(cython.pointer(sockaddr), cython.address(self._sender[0]))
            into = cython.address(self._data[at])
            size = recvfrom(fd, into, self._room_bytes, MSG_DONTWAIT, origin, cython.address(origin_bytes))
            if size < 0 and yields > 0:
                yields -= 1
                sched_yield()
                continue
            if size < 0:
                return NOTHING
            self.taken += 1
            number = self._number(cython.address(known))
            self._stray_at, self._stray_bytes = at, size
            if lost:
                return LOST
            if number == NOWHERE:
                if size <= self._unknown_bytes:
                    return UNKNOWN
                continue
            if at > self._most_bytes or self._count == self._bounds.shape[0]:
                return FULL
            self._datagram(self._count)[0] = Datagram(at, at + size, number)
            self._used += size
            self._count += 1
        return ENOUGH

    def _look(self, row_by_sysid: Ints, awaited: Ints) -> None:
        """Look into datagrams, from the first that has not been, up to the one that it stops at."""
        while self._looked < self._count:
            datagram = self._datagram(self._looked)
            self._stopped_at = datagram.begin
            before = self._found.runs
            begins, rows = cython.address(self._begins[0]), run_at(self._rows, 0)
            found = find(cython.address(self._data[0]), datagram.begin, datagram.end, begins, rows, self._found)
            if found.runs < 0:
                return
            self._found = found
            address = datagram.address
            if address == NOWHERE or (address & 1 == ALONE and found.runs != before + 1):
                return
            for k in range(before, found.runs):
                run = run_at(self._rows, k)
                vehicle = row_by_sysid[run.sysid]
                if vehicle < 0 or not self._is_answer(run, awaited_at(awaited, vehicle), address):
                    self._stopped_at = self._begins[run.first]
                    return
                one = awaited_at(awaited, vehicle)
                one.next = (one.next + run.last - run.first) & 0xFF
                one.granted_ms, one.run = NOT_GRANTED, k
                self._order_row[self.answers] = vehicle
                self.answers += 1
            self._looked += 1

    def _is_answer(self, run: Any, one: Any, address: int) -> bool:
        """Whether a run is the whole answer of a vehicle that is awaited."""
        if not run.in_step or run.seq != one.next or run.last - run.first >= HALF or run.compid != one.compid:
            return False
        if one.address != address or run.time_ms != one.granted_ms or one.held:
            return False
        return bool(self.answers < NUMBERS)

    def _cut(self, awaited: Ints, rows: Ints, spans: Ints) -> Any:
        """Fill the first answers of `_order`, rows (n, COLUMNS) and spans (frames, 2) as `pop_answers` gives them; how
        many runs and frames there are."""
        count = frames = 0
        for vehicle in range(awaited.shape[0]):
            one = awaited_at(awaited, vehicle)
            if one.run == NO_RUN:
                continue
            run, cut = run_at(self._rows, one.run), run_at(rows, count)
            one.run = NO_RUN
            self._order_row[count] = vehicle
            cut[0] = run[0]
            cut.first = frames
            for k in range(run.first, run.last):
                spans[frames, 0], spans[frames, 1] = self._begins[k], self._begins[k + 1]
                frames += 1
            cut.last = frames
            count += 1
        return Found(frames, count)
