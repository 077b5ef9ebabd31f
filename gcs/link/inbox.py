"""A tick's datagrams, side by side as they come from the socket, and the answers that they hold.

Most hold nothing but whole answers of vehicles that are awaited. One compiled call receives such datagrams, sees whose
they are and knows the answers for what they are, by the rules of gcs/mavlink/sequence.py; it ends early with what it
leaves to the interpreter.
"""

from __future__ import annotations

import socket
import struct
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans
from gcs.kernel_files import checksum
from gcs.kernels import UNCOUNTED, external, inner, kernel
from gcs.mavlink import datagram
from gcs.mavlink.datagram import (
    ADDRESS,
    COLUMNS,
    COMPID,
    COMPID_OF,
    CRC_TABLE,
    FIRST,
    GRANTED_MS,
    HALF,
    HELD,
    IN_STEP,
    LAST,
    NEXT,
    NO_RUN,
    NOT_GRANTED,
    NOWHERE,
    NUMBERS,
    RUN,
    SEEDS,
    SEQ,
    SMALLEST_FRAME,
    SYSID,
    TIME_MS,
    AnswerRuns,
    find,
)

Address = tuple[str, int]
Ints = NDArray[np.int64]
Bytes = NDArray[np.uint8]

NOTHING, ENOUGH, UNKNOWN, FULL, LOST = range(5)
"""How `Inbox.receive` ends: no further datagram is there; as many wait to be looked into as were asked for, or as many
have been taken as may be; one came from an address that nobody knows; there is no place for one; one was let go."""
ALONE, SHARED_BY = 0, 1
"""The last bit of an address's number: whether one vehicle speaks from there or several."""

_BOUNDS = 3  # begin, end, number of the address
_CELLS = 10
_FRAMES, _RUNS, _ANSWERS, _STOPPED_AT, _USED, _COUNT, _LOOKED, _TAKEN, _STRAY_AT, _STRAY_BYTES = range(_CELLS)
"""Of what the buffer holds: frames, runs and answers; where looking has stopped; bytes and datagrams, and how many of
these were looked into. Of the last call: datagrams received; the place and length of the one that it ended with."""
_DATAGRAM_FROM = struct.Struct("=HH4s8x")
_ADDRESS_BYTES = _DATAGRAM_FROM.size
_DONTWAIT = int(socket.MSG_DONTWAIT)

_sched_yield = external("sched_yield", "int32")
_recvfrom = external("recvfrom", "intp", "int32", "uintp", "uintp", "int32", "uintp", "uintp")


def packed(address: Address) -> bytes:
    """An IPv4 address as the system has it, `struct sockaddr_in`."""
    host, port = address
    return _DATAGRAM_FROM.pack(socket.AF_INET, socket.htons(port), socket.inet_aton(host))


class Inbox:
    """Datagrams, and the runs of frames that were found in them."""

    def __init__(self, most_bytes: int, most_datagrams: int, room_bytes: int, unknown_bytes: int) -> None:
        """room_bytes: a datagram's, at most; what is longer is cut. unknown_bytes: a longer datagram of somebody who
        is not known is passed over."""
        self._data = np.zeros(most_bytes + 2 * room_bytes, np.uint8)
        most_frames = (most_bytes + room_bytes) // SMALLEST_FRAME
        self._begins = np.empty(most_frames + most_datagrams, np.int64)
        self._rows = np.empty((most_frames, COLUMNS), np.int64)
        self._order = np.empty(NUMBERS, np.int64)
        self._bounds = np.empty((most_datagrams, _BOUNDS), np.int64)
        self._cells = np.zeros(_CELLS, np.int64)
        self._cell = self._cells.data
        self._sizes = np.array([most_bytes, room_bytes, unknown_bytes])
        self._sender = np.zeros(_ADDRESS_BYTES // 8 + 1, np.int64)
        self._origins = np.empty((0, 2), np.int64)

    def know(self, address: Address, number: int) -> None:
        """Take in what comes from this address from now on, under this number."""
        (place,) = struct.unpack("=q8x", packed(address))
        self._origins = np.vstack((self._origins, np.array([[place, number]])))

    def forget(self, number: int) -> None:
        """Take in nothing more of the address with this number."""
        self._origins = self._origins[self._origins[:, 1] != number]

    def receive(
        self, fd: int, most: int, left: int, awaited: Ints, lanes: Ints, *, yields: int = 0, lost: bool = False
    ) -> int:
        """Receive datagrams that have come to this socket until `most` wait to be looked into, and `left` at most; look
        into those that wait, up to the first that holds something else than whole answers.

        `awaited` (vehicles, AWAITED) is filled for those whose answers were found; `lanes` (256,) are its rows by
        system id, else -1. `yields`: so often, where nothing is there, let another process run, and look again. `lost`:
        let one datagram go. With `most` 0 nothing is received. What it ends with; then
        `answered`, `taken`, `stray` and `stopped` have more to say.
        """
        self._before = self._cell[_ANSWERS]
        return _receive(
            fd, most, left, yields, lost, self._sizes, self._data, self._sender, self._origins, self._bounds,
            self._cells, SEEDS, CRC_TABLE, self._begins, self._rows, lanes, awaited, self._order,
        )  # fmt: skip

    @property
    def taken(self) -> int:
        """Datagrams that the last call has received."""
        return self._cell[_TAKEN]

    @property
    def answered(self) -> Ints:
        """Rows of `awaited` whose answers the last call has found."""
        return self._order[self._before : self._cell[_ANSWERS]]

    @property
    def answers(self) -> int:
        """Answers that were found, and have not been taken."""
        return self._cell[_ANSWERS]

    def stray(self) -> tuple[bytes, Address]:
        """The datagram that the last call ended with, and where it came from."""
        begin, size = self._cell[_STRAY_AT], self._cell[_STRAY_BYTES]
        _, port, host = _DATAGRAM_FROM.unpack(self._sender[:2].tobytes())
        address = socket.inet_ntoa(host), socket.ntohs(port)
        return self._data[begin : begin + size].tobytes(), address

    def stopped(self) -> tuple[int, bytes] | None:
        """(number of the address, rest) of the datagram at which looking has stopped; it waits no more. None: at
        none."""
        looked = self._cell[_LOOKED]
        if looked == self._cell[_COUNT]:
            return None
        self._cell[_LOOKED] = looked + 1
        _, end, number = self._bounds[looked].tolist()
        return number, self._data[self._cell[_STOPPED_AT] : end].tobytes()

    def pop_answers(self, awaited: Ints) -> tuple[Ints, AnswerRuns]:
        """The answers that were found: their rows (n,) of `awaited`, in order, and their runs. Nothing is left."""
        cell = self._cell
        rows, spans = np.empty((cell[_ANSWERS], COLUMNS), np.int64), np.empty((cell[_FRAMES], 2), np.int64)
        used = cell[_USED]
        count, frames = _cut(awaited, self._rows, self._begins, self._order, rows, spans, self._cells)
        return self._order[:count], AnswerRuns(FrameSpans(self._data[:used].tobytes(), spans[:frames]), rows[:count])


@inner(**UNCOUNTED)
def _look(
    data: Bytes,
    bounds: Ints,
    seeds: NDArray[np.int16],
    table: NDArray[np.uint16],
    begins: Ints,
    rows: Ints,
    lanes: Ints,
    awaited: Ints,
    order: Ints,
    cells: Ints,
) -> Any:
    """Kernel: look into datagrams, from the first that has not been; which it stops at."""
    for k in range(cells[_LOOKED], cells[_COUNT]):
        at, end, address = bounds[k, 0], bounds[k, 1], bounds[k, 2]
        cells[_STOPPED_AT] = at
        before = cells[_RUNS]
        frames, runs = find(data, at, end, seeds, table, begins, cells[_FRAMES], rows, before)
        if runs < 0:
            return k
        cells[_FRAMES], cells[_RUNS] = frames, runs
        if address == NOWHERE or (address & SHARED_BY == ALONE and runs != before + 1):
            return k
        for r in range(before, runs):
            row = rows[r]
            lane = lanes[row[SYSID]]
            if lane < 0:
                cells[_STOPPED_AT] = begins[row[FIRST]]
                return k
            one, length = awaited[lane], row[LAST] - row[FIRST]
            whole = row[IN_STEP] == 1 and row[SEQ] == one[NEXT] and length < HALF
            whole = whole and row[COMPID] == one[COMPID_OF] and one[ADDRESS] == address
            if not whole or row[TIME_MS] != one[GRANTED_MS] or one[HELD] or cells[_ANSWERS] == order.size:
                cells[_STOPPED_AT] = begins[row[FIRST]]
                return k
            one[NEXT] = (one[NEXT] + length) % NUMBERS
            one[GRANTED_MS], one[RUN] = NOT_GRANTED, r
            order[cells[_ANSWERS]] = lane
            cells[_ANSWERS] += 1
    return cells[_COUNT]


@inner(**UNCOUNTED)
def _forget(cells: Ints) -> None:
    """Kernel: begin again with an empty buffer."""
    cells[_FRAMES] = cells[_RUNS] = cells[_ANSWERS] = 0
    cells[_USED] = cells[_COUNT] = cells[_LOOKED] = 0


def _compiled(build: int) -> Callable[..., int]:
    """The entry point; `build`: checksum of the other file that it is made of."""

    @kernel(error_model="numpy")
    def receive(
        fd: int,
        most: int,
        left: int,
        yields: int,
        lost: bool,
        sizes: Ints,
        data: Bytes,
        sender: Ints,
        origins: Ints,
        bounds: Ints,
        cells: Ints,
        seeds: NDArray[np.int16],
        table: NDArray[np.uint16],
        begins: Ints,
        rows: Ints,
        lanes: Ints,
        awaited: Ints,
        order: Ints,
    ) -> int:
        _ = build
        if cells[_LOOKED] == cells[_COUNT] and cells[_ANSWERS] == 0:
            _forget(cells)
        met, known = ENOUGH, 0
        cells[_TAKEN] = 0
        while cells[_COUNT] - cells[_LOOKED] < most and cells[_TAKEN] < left:
            at = cells[_USED]
            sender[2] = _ADDRESS_BYTES
            where = sender.ctypes.data
            size = _recvfrom(fd, data.ctypes.data + at, sizes[1], _DONTWAIT, where, where + _ADDRESS_BYTES)
            if size < 0 and yields > 0:
                yields -= 1
                _sched_yield()
                continue
            if size < 0:
                met = NOTHING
                break
            cells[_TAKEN] += 1
            number = NOWHERE
            for k in range(len(origins)):  # most answer in turn
                if origins[(known + k) % len(origins), 0] == sender[0]:
                    known = (known + k) % len(origins)
                    number = origins[known, 1]
                    break
            cells[_STRAY_AT], cells[_STRAY_BYTES] = at, size
            if lost:
                met = LOST
                break
            if number == NOWHERE:
                if size <= sizes[2]:
                    met = UNKNOWN
                    break
                continue
            count = cells[_COUNT]
            if at > sizes[0] or count == len(bounds):
                met = FULL
                break
            bounds[count, 0], bounds[count, 1], bounds[count, 2] = at, at + size, number
            cells[_USED], cells[_COUNT] = at + size, count + 1
        cells[_LOOKED] = _look(data, bounds, seeds, table, begins, rows, lanes, awaited, order, cells)
        return met

    return receive


_receive = _compiled(checksum(datagram))
"""As `Inbox.receive`. sizes: as `Inbox` is given them, in that order; sender (3,): room for an address and its length;
origins (n, 2): the first 8 bytes of each address, which hold all of it, and its number; bounds (datagrams, _BOUNDS)."""


@kernel(**UNCOUNTED)
def _cut(awaited: Ints, rows: Ints, begins: Ints, lanes: Ints, found: Ints, spans: Ints, cells: Ints) -> Any:
    """Kernel: as `Inbox.pop_answers`, which fills lanes (n,), found (n, COLUMNS) and spans (frames, 2); how many runs
    and frames there are."""
    count = frames = 0
    for lane in range(awaited.shape[0]):
        if awaited[lane, RUN] == NO_RUN:
            continue
        row = rows[awaited[lane, RUN]]
        awaited[lane, RUN] = NO_RUN
        lanes[count] = lane
        for column in range(COLUMNS):
            found[count, column] = row[column]
        found[count, FIRST] = frames
        for k in range(row[FIRST], row[LAST]):
            spans[frames, 0], spans[frames, 1] = begins[k], begins[k + 1]
            frames += 1
        found[count, LAST] = frames
        count += 1
    _forget(cells)
    return count, frames
