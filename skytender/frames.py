"""MAVLink 2 frames as they are written: header, payload without its trailing zeros, checksum."""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.skytender.checksum as checksum
from cython.cimports.cpython.bytes import PyBytes_AS_STRING, PyBytes_FromStringAndSize
from cython.cimports.libc.string import memcpy
from cython.cimports.skytender.frames import CHECKSUM_BYTES, FRAME_BYTES, HEADER_BYTES, MAGIC, PAYLOAD_BYTES


def write_frame(out: Any, payload: Any, size: int, msgid: int, seed: int, seq: int, sysid: int, compid: int) -> int:
    """Write the frame of a payload of this size; its bytes."""
    memcpy(out + HEADER_BYTES, payload, size)
    length = size
    while length > 1 and out[HEADER_BYTES + length - 1] == 0:
        length -= 1
    out[0], out[1], out[2], out[3] = MAGIC, length, 0, 0
    out[4], out[5], out[6] = seq & 0xFF, sysid, compid
    out[7], out[8], out[9] = msgid & 0xFF, msgid >> 8 & 0xFF, msgid >> 16 & 0xFF
    end = HEADER_BYTES + length
    crc = checksum.ended(checksum.crc_of(out, 1, end), seed)
    out[end], out[end + 1] = crc & 0xFF, crc >> 8
    return end + CHECKSUM_BYTES


def frame(payload: bytes, msgid: int, seed: int, seq: int, sysid: int, compid: int) -> bytes:
    """The frame of a payload, at most 255 bytes, which ends with all its zeros; `seed`: CRC_EXTRA of its message."""
    begin = cython.cast("const unsigned char *", PyBytes_AS_STRING(payload))
    return framed(begin, min(len(payload), PAYLOAD_BYTES), msgid, seed, seq, sysid, compid)


def framed(payload: Any, size: int, msgid: int, seed: int, seq: int, sysid: int, compid: int) -> bytes:
    """`frame` of so many bytes."""
    out = cython.declare(cython.uchar[FRAME_BYTES])
    written = write_frame(out, payload, size, msgid, seed, seq, sysid, compid)
    return PyBytes_FromStringAndSize(cython.cast("char *", out), written)
