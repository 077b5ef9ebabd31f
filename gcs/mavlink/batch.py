"""Many frames at once, as of a whole tick or of a log: checked and sorted by compiled code, read by the codec's table.

Only what is plain goes that way: MAVLink 2, no signature, an id of the dialect, no gap. Where anything else is among
the bytes, all of them take the way over `codec.split` and `codec.fields`, whose answers are the same.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from fastcrc.crc16 import mcrf4xx
from numba import njit
from numpy.typing import NDArray
from pymavlink.dialects.v20 import common

from gcs.mavlink import codec

IntArray = NDArray[np.int64]
ByteArray = NDArray[np.uint8]

HEADER, SMALLEST, MARKER = codec.HEADER_BYTES, codec.HEADER_BYTES + codec.CRC_BYTES, codec.MARKER
SYSID, COMPID, SEQ, MSGID, AT = range(5)
_NO_SEED = 256
# By message id, what its checksum ends with. Ids of three bytes that the dialect has all fit into two.
_SEEDS = np.full(1 << 16, _NO_SEED, dtype=np.int64)
for _msgid, _cls in common.mavlink_map.items():
    _SEEDS[_msgid] = _cls.crc_extra
# CRC-16/MCRF4XX of one byte, from a register of 0: what a byte does to the rest.
_CRC = np.array([mcrf4xx(bytes([byte]), 0) for byte in range(256)], dtype=np.int64)


class Batch(NamedTuple):
    """What bytes held, in their order: senders and ids (n, 4) as SYSID, COMPID, SEQ, MSGID, and n messages as `fields`
    gives them, None for an id that the dialect lacks. `malformed` as in `codec.Split`."""

    headers: IntArray
    messages: list[Any]
    malformed: int


def decode(data: bytes) -> Batch:
    """Every message in the bytes; never raises."""
    octets = np.frombuffer(data, dtype=np.uint8)
    heads = _walk(octets, _SEEDS, _CRC)
    if heads is None:
        return _careful(data)
    ids, first = np.unique(heads[:, MSGID], return_index=True)
    ids = ids[np.argsort(first)]
    sizes = np.array([codec.record_bytes(msgid) for msgid in ids.tolist()], dtype=np.int64)
    packed, rows, begin, row_begin = _sort(octets, heads, ids, sizes)
    view = memoryview(packed.data)
    messages: list[Any] = [None] * len(heads)
    for k, msgid in enumerate(ids.tolist()):
        places = rows[row_begin[k] : row_begin[k + 1]].tolist()
        for place, message in zip(places, codec.records(msgid, view[begin[k] : begin[k + 1]]), strict=True):
            messages[place] = message
    return Batch(heads[:, :AT], messages, 0)


def _careful(data: bytes) -> Batch:
    frames, malformed, _ = codec.split(data)
    headers = np.array([(f.sysid, f.compid, f.seq, f.msgid) for f in frames], dtype=np.int64).reshape(-1, AT)
    messages = [codec.fields(f) if f.msgid in common.mavlink_map else None for f in frames]
    return Batch(headers, messages, malformed)


@njit(cache=True)
def _walk(data: ByteArray, seeds: IntArray, table: IntArray) -> IntArray | None:
    """Kernel: (n, 5) sender, number, id and place of each frame; None where not all bytes are plain, intact frames."""
    size = data.size
    heads = np.empty((size // SMALLEST, 5), dtype=np.int64)
    n = 0
    at = 0
    while at < size:
        if at + SMALLEST > size or data[at] != MARKER or data[at + 2] != 0 or data[at + 9] != 0:
            return None
        end = at + SMALLEST + data[at + 1]
        msgid = np.int64(data[at + 7]) | np.int64(data[at + 8]) << 8
        seed = seeds[msgid]
        if end > size or seed == _NO_SEED:
            return None
        crc = np.int64(0xFFFF)
        for k in range(at + 1, end - 2):
            crc = crc >> 8 ^ table[(crc ^ data[k]) & 0xFF]
        crc = crc >> 8 ^ table[(crc ^ seed) & 0xFF]
        if crc != np.int64(data[end - 2]) | np.int64(data[end - 1]) << 8:
            return None
        heads[n, SYSID], heads[n, COMPID], heads[n, SEQ] = data[at + 5], data[at + 6], data[at + 4]
        heads[n, MSGID], heads[n, AT] = msgid, at
        n += 1
        at = end
    return heads[:n]


@njit(cache=True)
def _sort(
    data: ByteArray, heads: IntArray, ids: IntArray, sizes: IntArray
) -> tuple[ByteArray, IntArray, IntArray, IntArray]:
    """Kernel: frames with their payloads filled up with zeros, message by message; their rows in `heads`; and where
    each message's bytes, and rows, begin (one more for the end)."""
    groups = ids.size
    group_of = np.empty(heads.shape[0], dtype=np.int64)
    begin = np.zeros(groups + 1, dtype=np.int64)
    row_begin = np.zeros(groups + 1, dtype=np.int64)
    for i in range(heads.shape[0]):
        g = 0
        while ids[g] != heads[i, MSGID]:
            g += 1
        group_of[i] = g
        row_begin[g + 1] += 1
    for g in range(groups):
        begin[g + 1] = begin[g] + row_begin[g + 1] * sizes[g]
        row_begin[g + 1] += row_begin[g]
    packed = np.zeros(begin[groups], dtype=np.uint8)
    rows = np.empty(heads.shape[0], dtype=np.int64)
    taken = np.zeros(groups, dtype=np.int64)
    for i in range(heads.shape[0]):
        g, at = group_of[i], heads[i, AT]
        to = begin[g] + taken[g] * sizes[g]
        for k in range(min(sizes[g], HEADER + data[at + 1])):
            packed[to + k] = data[at + k]
        rows[row_begin[g] + taken[g]] = i
        taken[g] += 1
    return packed, rows, begin, row_begin
