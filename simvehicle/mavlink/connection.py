"""One MAVLink conversation without its socket: sequence numbers, streams, and what waits to be sent."""

from __future__ import annotations

from typing import Any

from simvehicle.mavlink.codec import encode
from simvehicle.mavlink.streams import StreamSchedule
from simvehicle.mavlink.telemetry import VehicleState

DATAGRAM_BYTES = 1400


class Connection:
    """A connection's own sequence counter, stream schedule and send queue."""

    def __init__(self, sysid: int, compid: int = 1) -> None:
        self.sysid = sysid
        self.compid = compid
        self.streams = StreamSchedule()
        self._seq = 0
        self._queue: list[Any] = []

    def put(self, content: Any) -> None:
        """Queue a message behind those that wait."""
        self._queue.append(content)

    def put_due(self, snapshot: VehicleState) -> None:
        """Queue the telemetry that is due at the snapshot's time."""
        for stream in self.streams.due(snapshot.time_ms):
            self._queue.append(stream.build(snapshot))

    def frames(self, most: int | None = None) -> list[bytes]:
        """Number, encode and hand out what waits, at most `most` messages; the others go on waiting."""
        handed_out = self._queue[:most]
        del self._queue[:most]
        return [self.number(content) for content in handed_out]

    def number(self, content: Any) -> bytes:
        """The frame of one message with this connection's next number, past everything that waits."""
        seq = self._seq
        self._seq = (seq + 1) & 0xFF
        return encode(content, seq=seq, sysid=self.sysid, compid=self.compid)


def pack(frames: list[bytes]) -> list[bytes]:
    """Frames in as few datagrams of at most 1,400 bytes as their order allows."""
    datagrams: list[bytes] = []
    waiting: list[bytes] = []
    size = 0
    for frame in frames:
        if waiting and size + len(frame) > DATAGRAM_BYTES:
            datagrams.append(b"".join(waiting))
            waiting, size = [], 0
        waiting.append(frame)
        size += len(frame)
    if waiting:
        datagrams.append(b"".join(waiting))
    return datagrams
