"""One MAVLink conversation without its socket: sequence numbers, streams, and what waits to be sent."""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.simvehicle.mavlink.telemetry as telemetry
import cython.cimports.skytender.frames as compiled_frames
from cython.cimports.cpython.bytes import PyBytes_AS_STRING, PyBytes_FromStringAndSize
from cython.cimports.libc.string import memcpy
from cython.cimports.simvehicle.mavlink.connection import DATAGRAM_BYTES, Waiting
from cython.cimports.simvehicle.mavlink.telemetry import LARGEST_BYTES, STREAMS

from simvehicle.mavlink.codec import packed
from simvehicle.mavlink.streams import StreamSchedule


class Connection:
    """A connection's own sequence counter, stream schedule and send queue."""

    sysid: int
    compid: int
    streams: StreamSchedule
    seq: int
    """number of the next frame"""
    _queue: list[bytes]
    """payloads of messages in order, each behind its `Waiting`"""

    def __init__(self, sysid: int, compid: int = 1) -> None:
        self.sysid = sysid
        self.compid = compid
        self.streams = StreamSchedule()
        self.seq = 0
        self._queue = []

    def put(self, content: Any) -> None:
        """Queue a message behind those that wait."""
        row, payload = content.SCHEMA, packed(content)
        text = cython.cast("const unsigned char *", PyBytes_AS_STRING(payload))
        self._queue_payload(row.msgid, row.seed, text, len(payload))

    def _queue_payload(self, msgid: int, seed: int, payload: Any, size: int) -> None:
        waiting = PyBytes_FromStringAndSize(cython.NULL, cython.sizeof(Waiting) + size)
        head = cython.cast("Waiting *", PyBytes_AS_STRING(waiting))
        head.msgid, head.seed = msgid, seed
        memcpy(head + 1, payload, size)
        self._queue.append(waiting)

    def put_due(self, vehicle: Any) -> None:
        """Queue the telemetry that is due at the vehicle's present time."""
        payload = cython.declare(cython.uchar[LARGEST_BYTES])
        for stream in range(STREAMS):
            if self.streams.take(stream, vehicle.time_ms):
                telemetry.write_payload(vehicle, stream, payload)
                sent = cython.address(telemetry.MESSAGES[stream])
                self._queue_payload(sent.msgid, sent.seed, payload, sent.size)

    def frames(self, most: int = -1) -> list[bytes]:
        """Number, encode and hand out what waits, at most `most` messages where that is given; the others go on
        waiting."""
        queue, numbered = self._queue, []
        count = len(queue) if most < 0 else min(len(queue), most)
        for i in range(count):
            waiting = cython.cast(bytes, queue[i])
            head = cython.cast("const Waiting *", PyBytes_AS_STRING(waiting))
            size = len(waiting) - cython.sizeof(Waiting)
            numbered.append(self.number(head.msgid, head.seed, cython.cast("const unsigned char *", head + 1), size))
        self._queue = queue[count:]
        return numbered

    def number(self, msgid: int, seed: int, payload: Any, size: int) -> bytes:
        """The frame of one message with this connection's next number, past everything that waits."""
        seq, self.seq = self.seq, self.seq + 1 & 0xFF
        return compiled_frames.framed(payload, size, msgid, seed, seq, self.sysid, self.compid)


def pack(frames: list[bytes]) -> list[bytes]:
    """Frames in as few datagrams of at most 1,400 bytes as their order allows."""
    datagrams: list[bytes] = []
    first = size = 0
    for k in range(len(frames)):
        frame = cython.cast(bytes, frames[k])
        if size > 0 and size + len(frame) > DATAGRAM_BYTES:
            datagrams.append(together(frames, first, k))
            first, size = k, 0
        size += len(frame)
    if size > 0:
        datagrams.append(together(frames, first, len(frames)))
    return datagrams


def size_of(parts: list[bytes], first: int, end: int) -> int:
    """Bytes of parts[first:end]."""
    size = 0
    for k in range(first, end):
        size += len(cython.cast(bytes, parts[k]))
    return size


def together(parts: list[bytes], first: int, end: int) -> bytes:
    """parts[first:end], one after the other."""
    whole = PyBytes_FromStringAndSize(cython.NULL, size_of(parts, first, end))
    at = PyBytes_AS_STRING(whole)
    for k in range(first, end):
        part = cython.cast(bytes, parts[k])
        memcpy(at, PyBytes_AS_STRING(part), len(part))
        at += len(part)
    return whole
