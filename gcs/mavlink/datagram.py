"""A datagram whose every byte belongs to a frame of the dialect, as nearly all of a session's: its frames by sender,
found in one call of compiled code.

Whether a frame is one is decided as by `codec.split`, which is asked about every other datagram. What reads such frames
by compiled code too needs no `Frame` of each: a `FrameRun` makes them when somebody asks.

Here also stands what compiled code keeps of a vehicle whose answer is awaited, which gcs/link/inbox.py takes in.
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
from gcs.mavlink import codec, dialect
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
    rows = [np.array(dialect.CRC_TERMS, dtype=np.uint16)]
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

SMALLEST_FRAME = codec.HEADER_BYTES + codec.CRC_BYTES

NUMBERS = 256
HALF = 128
"""Numbers wrap; of two the later is the one fewer than so many steps ahead, so a tick holds fewer frames."""

AWAITED = 6
NEXT, GRANTED_MS, COMPID_OF, HELD, ADDRESS, RUN = range(AWAITED)
"""Of a vehicle whose answer may come: the number of its next frame; the time that its answer will say, or NOT_GRANTED;
its component; whether a part of the answer is there (1, else 0); where it speaks from, else NOWHERE; and which of the
buffer's runs its answer is, else NO_RUN."""
NOT_GRANTED, NOWHERE, NO_RUN = -2, -1, -1


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
    frames, runs = _find_alone(datagram, SEEDS, CRC_TABLE, _BEGINS, _ROWS)
    if runs < 0:
        return None
    begins = _BEGINS[:frames].tolist()
    return [FrameRun(datagram, begins[row[FIRST] : row[LAST] + 1], row) for row in _ROWS[:runs].tolist()]


class AnswerRuns(Sequence[FrameRun]):
    """Runs of frames that lie in one piece of data, each a vehicle's: a sequence of `FrameRun`, made when it is asked
    for."""

    def __init__(self, frames: FrameSpans, rows: NDArray[np.int64]) -> None:
        """frames: of all, run by run; `FIRST` and `LAST` of the rows (n, COLUMNS) are places among them."""
        self.frames = frames
        self.rows = rows

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
def find(
    data: Any,
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
def _find_alone(
    data: bytes,
    seeds: NDArray[np.int16],
    table: NDArray[np.uint16],
    begins: NDArray[np.int64],
    rows: NDArray[np.int64],
) -> Any:
    """Kernel: as `find`, of one datagram."""
    return find(data, 0, len(data), seeds, table, begins, 0, rows, 0)


_BEGINS = np.empty(MOST_BYTES // SMALLEST_FRAME + 1, np.int64)
_ROWS = np.empty((MOST_BYTES // SMALLEST_FRAME, COLUMNS), np.int64)
"""For one datagram at a time: one thread reads a session's links."""
