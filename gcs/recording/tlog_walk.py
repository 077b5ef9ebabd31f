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
from cython.cimports.gcs.recording.frame_heads import head_at
from cython.cimports.libc.string import memcpy
from cython.cimports.skytender.frames import (
    CHECKSUM_BYTES,
    HEADER_1_BYTES,
    HEADER_BYTES,
    MAGIC,
    MAGIC_1,
    SIGNATURE_BYTES,
    SIGNED,
)
from cython.cimports.skytender.intact_frames import NO_SEED, intact_at
from numpy.typing import NDArray

from gcs.mavlink import codec, dialect, records
from gcs.mavlink.codec import Frame
from gcs.recording.times.recorded_clock import NO_STAMP

IntArray = NDArray[np.int64]
ByteArray = NDArray[np.uint8]

TIME_BYTES = 8
COLUMNS = 6
T_US, AT, SYSID, COMPID, SEQ, MSGID = range(COLUMNS)
"""Columns of `Chunk.heads`, in the order of the struct Head in frame_heads.pxd; AT is the place of the frame's marker
in `Chunk.octets`."""

_NO_STAMP = NO_STAMP


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
        return self.begin + self.heads[self._msgids == codec.layout(message).msgid, AT]

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
    return dialect.newer_form(data, at)


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
        begin = at + HEADER_BYTES if data[at] == MAGIC else at + HEADER_1_BYTES
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
        n, last_end, look_at, gaps, skipped = _walk(data, rows, last_end, look_at, final)
    return n, last_end, look_at, gaps, skipped


def _walk(
    octets: ByteArray,
    heads: IntArray,
    last_end: int,
    look_at: int,
    final: bool,
) -> tuple[int, int, int, int, int]:
    data = cython.address(octets[0])
    size = octets.shape[0]
    n = gaps = skipped = 0
    while look_at < size:
        if not final and look_at + 288 > size:
            break
        intact = intact_at(data, look_at, size)
        if intact.end and intact.seed == NO_SEED:
            stamp_bytes = look_at - last_end
            next_at = intact.end + stamp_bytes
            follows = intact.end == size or (next_at < size and (data[next_at] == MAGIC or data[next_at] == MAGIC_1))
            intact.end = intact.end if stamp_bytes in (0, 8) and follows else 0
        if not intact.end:
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
        head.msgid = intact.msgid
        numbers = look_at + 4 if intact.version == 2 else look_at + 2
        head.seq, head.sysid, head.compid = data[numbers], data[numbers + 1], data[numbers + 2]
        n += 1
        last_end = intact.end
        look_at = last_end + 8
    return n, last_end, look_at, gaps, skipped
