"""The walk over a recording's bytes: where its frames stand, and what each chunk of them holds.

A frame counts when its checksum is right; one that the dialect lacks, where it also stands exactly between two others,
with their stamps or without. MAVLink 1 is handed out as MAVLink 2. A frame that directly follows another has no stamp,
NO_STAMP.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property, lru_cache
from typing import Any

import cython
import numpy as np
from cython.cimports.cpython.bytes import PyBytes_AS_STRING
from cython.cimports.gcs.mavlink.frame_runs import seed_of, seed_of_id
from cython.cimports.gcs.recording.frame_heads import head_at
from cython.cimports.libc.string import memcpy
from cython.cimports.skytender.checksum import crc_of, ended
from cython.cimports.skytender.frames import CHECKSUM_BYTES, HEADER_BYTES, MAGIC, SIGNATURE_BYTES, SIGNED
from numpy.typing import NDArray

from gcs.mavlink import codec, dialect, records
from gcs.mavlink.codec import Frame
from gcs.recording.times.recorded_clock import NO_STAMP
from skytender.checksum import mcrf4xx

IntArray = NDArray[np.int64]
ByteArray = NDArray[np.uint8]

TIME_BYTES = 8
COLUMNS = 6
T_US, AT, SYSID, COMPID, SEQ, MSGID = range(COLUMNS)
"""Columns of `Chunk.heads`, in the order of the struct Head in frame_heads.pxd; AT is the place of the frame's marker
in `Chunk.octets`."""

_NO_STAMP = NO_STAMP
_SOME_SEED = np.isin(np.arange(1 << 16), [mcrf4xx(bytes([seed]), 0) for seed in range(256)]).view(np.uint8)
"""Which differences one unknown seed byte can make."""


class Chunk:
    """A stretch of a recording."""

    def __init__(self, octets: ByteArray, heads: IntArray, read_share: float, begin: int) -> None:
        self.octets = octets
        self.begin = begin
        """where in the file `octets` begin"""
        self.heads = heads
        """(n, 6) in the file's order: T_US, AT, SYSID, COMPID, SEQ, MSGID"""
        self.read_share = read_share
        """how much of the file has been read, 0 to 1"""

    @cached_property
    def _msgids(self) -> NDArray[np.int32]:
        """(n,) by themselves, since `table` looks for each message among all."""
        return self.heads[:, MSGID].astype(np.int32)

    def frames(self) -> Iterator[tuple[int, Frame]]:
        """(time in µs since the Unix epoch, frame) in the file's order."""
        times, places, *numbers = self.heads.T.tolist()
        return zip(times, map(Frame._make, zip(*numbers, raws_at(self.octets.tobytes(), places))))  # noqa: B905

    def places(self, message: int | str) -> IntArray:
        """(n,) where in the file the rows of `table` begin."""
        places: IntArray = self.begin + self.heads[self._msgids == codec.layout(message).msgid, AT]
        return places

    def table(self, message: int | str) -> NDArray[Any]:
        """Every frame of one message as a structured array (n,): t_us, sysid, compid, seq, then the message's fields
        in wire order and MAVLink's own units; a field named like one of the four comes with a `_` after it.

        Raises ValueError for a message that the dialect lacks.
        """
        msgid = codec.layout(message).msgid
        dtype, payload_bytes = _dtypes(msgid)
        heads = self.heads[np.flatnonzero(self._msgids == msgid)]
        rows = np.zeros(len(heads), dtype=dtype)
        for name, column in (("t_us", T_US), ("sysid", SYSID), ("compid", COMPID), ("seq", SEQ)):
            rows[name] = heads[:, column]
        head_bytes = dtype.itemsize - payload_bytes
        _gather(self.octets, heads, rows.view(np.uint8).reshape(len(rows), dtype.itemsize), head_bytes)
        return rows


def raw_at(data: bytes, at: int) -> bytes:
    """The frame at a place, of MAVLink 1 in the form of MAVLink 2."""
    octets = cython.cast("const unsigned char *", PyBytes_AS_STRING(data))
    if octets[at] == MAGIC:
        signature = SIGNATURE_BYTES if octets[at + 2] & SIGNED else 0
        return data[at : at + HEADER_BYTES + octets[at + 1] + CHECKSUM_BYTES + signature]
    older = dialect.older_frame(data, at)
    assert older is not None  # as the walk has found
    return older.raw


def raws_at(data: bytes, places: list[int]) -> list[bytes]:
    """The frames at these places, as by `raw_at`."""
    return [raw_at(data, at) for at in places]


@lru_cache(maxsize=512)
def _dtypes(msgid: int) -> tuple[np.dtype[Any], int]:
    """The dtype of a message's table, and how many of its bytes are payload: they come last."""
    own = [("t_us", "<i8"), ("sysid", "u1"), ("compid", "u1"), ("seq", "u1")]
    payload = records.dtype(codec.layout(msgid), frozenset(name for name, _ in own))
    return np.dtype([*own, *((name, payload[name]) for name in payload.names or ())]), payload.itemsize


def _gather(data: ByteArray, heads: IntArray, rows: ByteArray, head_bytes: int) -> None:
    """Copy payloads into rows (n, size) behind their first bytes, cut off or left zero as they fit."""
    for i in range(len(heads)):
        at = head_at(heads, i).at
        begin = at + 10 if data[at] == 0xFD else at + 6
        size = min(data[at + 1], rows.shape[1] - head_bytes)
        memcpy(cython.address(rows[i, head_bytes]), cython.address(data[begin]), size)


def walk(
    octets: ByteArray, heads: IntArray, last_end: int, look_at: int, final: bool
) -> tuple[int, int, int, int, int]:
    """Fill heads (m, 6), with room for a frame at every 8 bytes; how many there are, end of the last frame, where to
    look next, gaps, bytes in them.

    In step, the next frame stands 8 bytes after the last one's end. Out of step it is looked for byte by byte.
    """
    data, rows = octets, heads
    with cython.nogil:
        n, last_end, look_at, gaps, skipped = _walk(data, rows, last_end, look_at, final, _SOME_SEED)
    return n, last_end, look_at, gaps, skipped


def _frame_bytes(data: Any, size: int, at: int, some_seed: NDArray[np.uint8]) -> int:
    """Length of the intact frame at a place; negative where only its seed is unknown; 0: none."""
    if at < 0 or at + 8 > size or (data[at] != 0xFD and data[at] != 0xFE):
        return 0
    length = data[at + 1]
    if data[at] == 0xFD:
        end = at + 10 + length
        if end + 2 > size or data[at + 2] > 1:
            return 0
        seed = seed_of(data + at)
        total = end + 2 - at + (13 if data[at + 2] == 1 else 0)
    else:
        end = at + 6 + length
        if end + 2 > size:
            return 0
        seed = seed_of_id(data[at + 5])
        total = end + 2 - at
    if at + total > size:
        return 0
    crc = crc_of(data, at + 1, end)
    sent_crc = data[end] | data[end + 1] << 8
    if seed >= 0:
        return total if ended(crc, seed) == sent_crc else 0
    return -total if some_seed[sent_crc ^ crc >> 8] else 0


def _walk(
    octets: ByteArray,
    heads: IntArray,
    last_end: int,
    look_at: int,
    final: bool,
    some_seed: NDArray[np.uint8],
) -> tuple[int, int, int, int, int]:
    data = cython.address(octets[0])
    size = octets.shape[0]
    n = gaps = skipped = 0
    while look_at < size:
        if not final and look_at + 288 > size:
            break
        total = _frame_bytes(data, size, look_at, some_seed)
        if total < 0:
            end, stamp_bytes = look_at - total, look_at - last_end
            next_at = end + stamp_bytes
            follows = end == size or (next_at < size and (data[next_at] == 0xFD or data[next_at] == 0xFE))
            total = -total if stamp_bytes in (0, 8) and follows else 0
        if total == 0:
            look_at = last_end if look_at == last_end + 8 else look_at + 1
            if look_at == last_end + 8:  # that place has been looked at, and means `in step`
                look_at += 1
            continue
        begin, stamp = look_at, _NO_STAMP
        if look_at - last_end >= 8:
            begin, stamp = look_at - 8, 0
            for k in range(8):
                stamp = stamp << 8 | data[begin + k]
        if begin > last_end:
            gaps += 1
            skipped += begin - last_end
        head = head_at(heads, n)
        head.t_us, head.at = stamp, look_at
        if data[look_at] == 0xFD:
            head.sysid, head.compid, head.seq = data[look_at + 5], data[look_at + 6], data[look_at + 4]
            head.msgid = data[look_at + 7] | data[look_at + 8] << 8 | data[look_at + 9] << 16
        else:
            head.sysid, head.compid, head.seq = data[look_at + 3], data[look_at + 4], data[look_at + 2]
            head.msgid = data[look_at + 5]
        n += 1
        last_end = look_at + total
        look_at = last_end + 8
    return n, last_end, look_at, gaps, skipped
