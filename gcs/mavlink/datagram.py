"""A datagram whose every byte belongs to a frame of the dialect, as nearly all of a session's: its frames by sender,
found in one call of compiled code.

Whether a frame is one is decided as by `codec.split`, which is asked about every other datagram. What reads such frames
by compiled code too needs no `Frame` of each: a `FrameRun` makes them when somebody asks.

Datagrams of a tick lie side by side in a `DatagramBuffer`. Most hold nothing but whole answers of vehicles that are
awaited, and those are known there for what they are, by the rules of gcs/mavlink/sequence.py.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans
from gcs.kernels import UNCOUNTED, inner, kernel
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame

MOST_BYTES = 16_384
"""A longer datagram is not looked at."""
NO_TIME = -1
_NO_SEED = -1

_new = tuple.__new__

SEEDS = np.full(1 << 16, _NO_SEED, dtype=np.int16)
"""(65536,) by message id, none of which has more than 16 bits in the dialect: the byte that its checksum ends with, or
-1."""
for _msgid, _seed in codec.seeds():
    SEEDS[_msgid] = _seed
AT_ONCE = 8


def _crc_table() -> NDArray[np.uint16]:
    """(AT_ONCE, 256) CRC-16/MCRF4XX, from a register of 0, of one byte with so many zeros behind it as the row says: so
    many bytes are summed in one step (Kounavis and Berry 2005)."""
    rows = [np.array(codec.CRC_TERMS, dtype=np.uint16)]
    for _ in range(AT_ONCE - 1):
        rows.append(rows[-1] >> 8 ^ rows[0][rows[-1] & 0xFF])
    return np.array(rows, dtype=np.uint16)


CRC_TABLE = _crc_table()

COLUMNS = 7
FIRST, LAST, SYSID, COMPID, SEQ, IN_STEP, TIME_MS = range(COLUMNS)
"""Of a run: the places of its first frame and behind its last one in the list of frames, the first frame's sender and
number, whether the others are of the same component and numbered on from it (1, else 0), and the `time_boot_ms` of the
last one if that is SYSTEM_TIME, else NO_TIME."""
_SYSTEM_TIME = codec.msgid("SYSTEM_TIME")
_TIME_BOOT_MS = 8  # where it stands in the payload

_SMALLEST_FRAME = codec.HEADER_BYTES + codec.CRC_BYTES

NUMBERS = 256
HALF = 128
"""Numbers wrap; of two the later is the one fewer than so many steps ahead, so a tick holds fewer frames."""

AWAITED = 6
NEXT, GRANTED_MS, COMPID_OF, HELD, ADDRESS, RUN = range(AWAITED)
"""Of a vehicle whose answer may come: the number of its next frame; the time that its answer will say, or NOT_GRANTED;
its component; whether a part of the answer is there (1, else 0); where it speaks from, else NOWHERE; and which of the
buffer's runs its answer is, else NO_RUN."""
NOT_GRANTED, NOWHERE, NO_RUN = -2, -1, -1
ALONE, SHARED_BY = 0, 1
"""The last bit of an address's number: whether one vehicle speaks from there or several."""
_BOUNDS = 3
_FILLED = 4
_FRAMES, _RUNS, _ANSWERS, _STOPPED_AT = range(_FILLED)


class FrameRun(Sequence[Frame]):
    """Frames of one system that follow each other in a datagram: a sequence of `Frame`, made when it is first read."""

    __slots__ = ("_begins", "_frames", "data", "first", "in_step", "sender", "time_ms")

    def __init__(self, data: bytes, begins: list[int], row: Sequence[int]) -> None:
        """begins: of each frame in `data`, and the end of the last; row: COLUMNS values."""
        self.data = data
        self._begins = begins
        self._frames: list[Frame] | None = None
        _, _, sysid, compid, self.first, in_step, time_ms = row
        self.sender = sysid, compid
        """system and component of the first frame"""
        self.in_step = in_step == 1
        """whether all are of this component, numbered one after the other from `first` on"""
        self.time_ms = time_ms if time_ms != NO_TIME else None
        """the sender's own time, where the last frame is a SYSTEM_TIME"""

    @property
    def span(self) -> tuple[int, int]:
        """Where in `data` the first frame begins and the last one ends."""
        return self._begins[0], self._begins[-1]

    def raws(self) -> list[bytes]:
        """The frames as they stood on the wire."""
        data = self.data
        return [data[begin:end] for begin, end in pairwise(self._begins)]

    def __len__(self) -> int:
        return len(self._begins) - 1

    def __iter__(self) -> Iterator[Frame]:
        return iter(self._made())

    @overload
    def __getitem__(self, at: int) -> Frame: ...
    @overload
    def __getitem__(self, at: slice) -> list[Frame]: ...
    def __getitem__(self, at: int | slice) -> Frame | list[Frame]:
        return self._made()[at]

    def __eq__(self, other: object) -> bool:
        return self._made() == (other._made() if isinstance(other, FrameRun) else other)

    __hash__ = None  # type: ignore[assignment]

    def _made(self) -> list[Frame]:
        if self._frames is None:
            self._frames = [frame_of(raw) for raw in self.raws()]
        return self._frames


def frame_of(raw: bytes) -> Frame:
    """The frame that these bytes are."""
    return _new(Frame, (raw[5], raw[6], raw[4], raw[7] | raw[8] << 8 | raw[9] << 16, raw))


def frame_at(data: bytes, begin: int) -> Frame:
    """The frame that begins there."""
    signature = codec.SIGNATURE_BYTES if data[begin + 2] & codec.SIGNED else 0
    return frame_of(data[begin : begin + codec.HEADER_BYTES + data[begin + 1] + codec.CRC_BYTES + signature])


def raws_of(frames: Iterable[Frame]) -> list[bytes]:
    """Frames as they stood on the wire."""
    return frames.raws() if isinstance(frames, FrameRun) else [frame.raw for frame in frames]


def runs_of(datagram: bytes) -> list[FrameRun] | None:
    """Frames of a datagram by system, in their order; None where not every byte belongs to a frame of the dialect."""
    if len(datagram) > MOST_BYTES:
        return None
    _alone.clear()
    _alone.room[: len(datagram)] = datagram
    _alone.put(len(datagram), NOWHERE)
    _alone.take_in(_NO_ROWS, _NO_LANES)
    return _alone.runs(datagram)


class AnswerRuns(Sequence[FrameRun]):
    """Runs of frames that lie in one piece of data, each a vehicle's: a sequence of `FrameRun`, made when it is asked
    for."""

    def __init__(self, frames: FrameSpans, rows: NDArray[np.int64]) -> None:
        """frames: of all, run by run; `FIRST` and `LAST` of the rows (n, COLUMNS) are places among them."""
        self.frames = frames
        self.rows = rows

    @property
    def counts(self) -> NDArray[np.int64]:
        """(n,) frames of each."""
        return self.rows[:, LAST] - self.rows[:, FIRST]

    def by_system(self) -> Mapping[int, FrameRun]:
        """Each by its system id, of which there is one run."""
        return _BySystem(self)

    def __len__(self) -> int:
        return len(self.rows)

    @overload
    def __getitem__(self, at: int) -> FrameRun: ...
    @overload
    def __getitem__(self, at: slice) -> list[FrameRun]: ...
    def __getitem__(self, at: int | slice) -> FrameRun | list[FrameRun]:
        if isinstance(at, slice):
            return [self[k] for k in range(*at.indices(len(self)))]
        row = self.rows[at].tolist()
        spans = self.frames.spans[row[FIRST] : row[LAST]]
        return FrameRun(self.frames.data, [*spans[:, 0].tolist(), int(spans[-1, 1])], row)


class _BySystem(Mapping[int, FrameRun]):
    def __init__(self, runs: AnswerRuns) -> None:
        self._runs = runs
        self._made: dict[int, FrameRun] = {}

    @cached_property
    def _at(self) -> dict[int, int]:
        return {sysid: at for at, sysid in enumerate(self._runs.rows[:, SYSID].tolist())}

    def __getitem__(self, sysid: int) -> FrameRun:
        if sysid not in self._made:
            self._made[sysid] = self._runs[self._at[sysid]]
        return self._made[sysid]

    def __iter__(self) -> Iterator[int]:
        return iter(self._at)

    def __len__(self) -> int:
        return len(self._at)


class DatagramBuffer:
    """Datagrams side by side, and the runs of frames that were found in them."""

    def __init__(self, most_bytes: int, most_datagrams: int, room_bytes: int) -> None:
        """room_bytes: a datagram's, at most."""
        self._data = np.zeros(most_bytes + 2 * room_bytes, dtype=np.uint8)
        self._view = self._data.data
        self._room_bytes, self._most_bytes = room_bytes, most_bytes
        most_frames = (most_bytes + room_bytes) // _SMALLEST_FRAME
        self._begins = np.empty(most_frames + most_datagrams, dtype=np.int64)
        self._rows = np.empty((most_frames, COLUMNS), dtype=np.int64)
        self._order = np.empty(NUMBERS, dtype=np.int64)
        self._most = most_datagrams
        bounds = np.empty(_BOUNDS * most_datagrams, dtype=np.int64)
        filled = np.zeros(_FILLED, dtype=np.int64)
        self._bounds, self._bound = bounds, bounds.data
        self._filled, self._fill = filled, filled.data
        self._used = self._count = self._first = 0
        self.room = self._view[:room_bytes]
        """where the next datagram goes"""

    @property
    def waiting(self) -> int:
        """Datagrams that have not been looked into."""
        return self._count - self._first

    @property
    def answers(self) -> int:
        """Runs that were taken in as answers."""
        return self._fill[_ANSWERS]

    @property
    def full(self) -> bool:
        """Whether there is place for no further datagram; there still is room for one to be read elsewhere."""
        return self._used > self._most_bytes or self._count == self._most

    def put(self, size: int, address: int) -> None:
        """A datagram of so many bytes has been written into `room`; `address` is where it came from, or NOWHERE."""
        begin = self._used
        end = begin + size
        at = _BOUNDS * self._count
        self._bound[at], self._bound[at + 1], self._bound[at + 2] = begin, end, address
        self._count += 1
        self._used = end
        self.room = self._view[end : end + self._room_bytes]

    def take_in(self, awaited: NDArray[np.int64], lanes: NDArray[np.int64]) -> NDArray[np.int64]:
        """Look into the datagrams that wait, up to the first that holds something else than whole answers; the rows of
        `awaited` (vehicles, AWAITED) whose answers were found. `lanes` (256,) are those rows by system id, else -1.

        `stopped` then gives what is left of that one.
        """
        before = self._fill[_ANSWERS]
        self._first = _take_in(
            self._data, self._bounds, self._first, self._count, SEEDS, CRC_TABLE,
            self._begins, self._rows, lanes, awaited, self._order, self._filled,
        )  # fmt: skip
        return self._order[before : self._fill[_ANSWERS]]

    def stopped(self) -> tuple[int, bytes] | None:
        """(address, rest) of the datagram at which `take_in` has stopped; it waits no more. None: at none."""
        if self._first == self._count:
            return None
        at = _BOUNDS * self._first
        self._first += 1
        return self._bound[at + 2], bytes(self._view[self._fill[_STOPPED_AT] : self._bound[at + 1]])

    def runs(self, datagram: bytes) -> list[FrameRun] | None:
        """The runs of the only datagram, which holds these bytes; None where it was not whole."""
        frames, runs = self._fill[_FRAMES], self._fill[_RUNS]
        if not runs:
            return None
        begins = self._begins[:frames].tolist()
        rows = self._rows[:runs].tolist()
        return [FrameRun(datagram, begins[row[FIRST] : row[LAST] + 1], row) for row in rows]

    def pop_answers(self, awaited: NDArray[np.int64]) -> tuple[NDArray[np.int64], AnswerRuns]:
        """The answers that were found: their rows (n,) of `awaited`, in order, and their runs. Nothing is left."""
        rows = np.empty((self.answers, COLUMNS), np.int64)
        spans = np.empty((self._fill[_FRAMES], 2), np.int64)
        count, frames = _cut(awaited, self._rows, self._begins, self._order, rows, spans)
        data = bytes(self._view[: self._used])
        self.clear()
        return self._order[:count], AnswerRuns(FrameSpans(data, spans[:frames]), rows[:count])

    def clear(self) -> None:
        """Begin again with nothing."""
        self._used = self._count = self._first = 0
        self._fill[_FRAMES] = self._fill[_RUNS] = self._fill[_ANSWERS] = 0
        self.room = self._view[: self._room_bytes]


@inner(**UNCOUNTED)
def crc_of(data: Any, begin: Any, end: Any, table: NDArray[np.uint16]) -> Any:
    """Kernel: CRC-16/MCRF4XX of some bytes, of `bytes` or of an array; `table` is CRC_TABLE."""
    crc = np.uint16(0xFFFF)
    k = begin
    while k + AT_ONCE <= end:
        crc = (
            table[7, data[k] ^ np.uint8(crc & 0xFF)]
            ^ table[6, data[k + 1] ^ np.uint8(crc >> 8)]
            ^ table[5, data[k + 2]]
            ^ table[4, data[k + 3]]
            ^ table[3, data[k + 4]]
            ^ table[2, data[k + 5]]
            ^ table[1, data[k + 6]]
            ^ table[0, data[k + 7]]
        )
        k += AT_ONCE
    while k < end:
        crc = np.uint16(crc >> 8) ^ table[0, data[k] ^ np.uint8(crc & 0xFF)]
        k += 1
    return np.int64(crc)


@inner(**UNCOUNTED)
def _find(
    data: NDArray[np.uint8],
    at: Any,
    size: Any,
    seeds: NDArray[np.int16],
    table: NDArray[np.uint16],
    begins: NDArray[np.int64],
    frames: Any,
    rows: NDArray[np.int64],
    runs: Any,
) -> Any:
    """Kernel: goes on filling begins and rows (runs, COLUMNS) behind so many frames and runs with what lies in
    data[at:size]; how many frames and runs there are then, both -1 where a byte is of no frame of the dialect. Behind a
    datagram's last frame stands its end."""
    before = runs
    if at == size:
        return -1, -1
    while at < size:
        if at + 12 > size or data[at] != 0xFD:
            return -1, -1
        signed = data[at + 2] == 1
        if (data[at + 2] and not signed) or data[at + 9]:
            return -1, -1
        body_end = at + 10 + np.int64(data[at + 1])
        end = body_end + (15 if signed else 2)
        msgid = np.int64(data[at + 7]) | np.int64(data[at + 8]) << 8
        seed = np.int64(seeds[msgid])
        if end > size or seed < 0:
            return -1, -1
        crc = crc_of(data, at + 1, body_end, table)
        crc = crc >> 8 ^ np.int64(table[0, (crc ^ seed) & 0xFF])
        if crc != (np.int64(data[body_end]) | np.int64(data[body_end + 1]) << 8):
            return -1, -1
        seq, sysid, compid = np.int64(data[at + 4]), np.int64(data[at + 5]), np.int64(data[at + 6])
        if runs == before or rows[runs - 1, SYSID] != sysid:
            row = rows[runs]
            row[FIRST], row[SYSID], row[COMPID], row[SEQ], row[IN_STEP] = frames, sysid, compid, seq, 1
            runs += 1
        row = rows[runs - 1]
        if compid != row[COMPID] or seq != (row[SEQ] + frames - row[FIRST]) & 0xFF:
            row[IN_STEP] = 0
        row[TIME_MS] = NO_TIME
        if msgid == _SYSTEM_TIME:
            row[TIME_MS] = 0
            for k in range(4):
                place = at + 10 + _TIME_BOOT_MS + k
                if place < body_end:
                    row[TIME_MS] |= np.int64(data[place]) << 8 * k
        begins[frames] = at
        frames += 1
        row[LAST] = frames
        at = end
    begins[frames] = size
    return frames + 1, runs


@kernel(**UNCOUNTED)
def _take_in(
    data: NDArray[np.uint8],
    bounds: NDArray[np.int64],
    first: int,
    count: int,
    seeds: NDArray[np.int16],
    table: NDArray[np.uint16],
    begins: NDArray[np.int64],
    rows: NDArray[np.int64],
    lanes: NDArray[np.int64],
    awaited: NDArray[np.int64],
    order: NDArray[np.int64],
    filled: NDArray[np.int64],
) -> int:
    """Kernel: as `DatagramBuffer.take_in`, from the first datagram on; which it stops at."""
    for k in range(first, count):
        at, end, address = bounds[_BOUNDS * k], bounds[_BOUNDS * k + 1], bounds[_BOUNDS * k + 2]
        filled[_STOPPED_AT] = at
        before = filled[_RUNS]
        frames, runs = _find(data, at, end, seeds, table, begins, filled[_FRAMES], rows, before)
        if runs < 0:
            return k
        filled[_FRAMES], filled[_RUNS] = frames, runs
        if address == NOWHERE or (address & SHARED_BY == ALONE and runs != before + 1):
            return k
        for r in range(before, runs):
            row = rows[r]
            lane = lanes[row[SYSID]]
            if lane < 0:
                filled[_STOPPED_AT] = begins[row[FIRST]]
                return k
            one, length = awaited[lane], row[LAST] - row[FIRST]
            whole = row[IN_STEP] == 1 and row[SEQ] == one[NEXT] and length < HALF
            whole = whole and row[COMPID] == one[COMPID_OF] and one[ADDRESS] == address
            if not whole or row[TIME_MS] != one[GRANTED_MS] or one[HELD] or filled[_ANSWERS] == order.size:
                filled[_STOPPED_AT] = begins[row[FIRST]]
                return k
            one[NEXT] = (one[NEXT] + length) % NUMBERS
            one[GRANTED_MS], one[RUN] = NOT_GRANTED, r
            order[filled[_ANSWERS]] = lane
            filled[_ANSWERS] += 1
    return count


@kernel(**UNCOUNTED)
def _cut(
    awaited: NDArray[np.int64],
    rows: NDArray[np.int64],
    begins: NDArray[np.int64],
    lanes: NDArray[np.int64],
    found: NDArray[np.int64],
    spans: NDArray[np.int64],
) -> Any:
    """Kernel: as `DatagramBuffer.pop_answers`, which fills lanes (n,), found (n, COLUMNS) and spans (frames, 2); how
    many runs and frames there are."""
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
    return count, frames


_alone = DatagramBuffer(0, 1, MOST_BYTES)
"""For one datagram at a time: one thread reads a session's links."""
_NO_ROWS, _NO_LANES = np.empty((0, AWAITED), dtype=np.int64), np.full(NUMBERS, -1, dtype=np.int64)
