"""One MAVLink conversation without its socket: sequence numbers, streams, and what waits to be sent."""

from __future__ import annotations

from typing import Any, Protocol

from simvehicle.autopilot.snapshot import Moving, VehicleState
from simvehicle.mavlink.streams import StreamSchedule

DATAGRAM_BYTES = 1400


class Reporting(Moving, Protocol):
    """Vehicle whose telemetry is sent."""

    def snapshot(self) -> VehicleState:
        """Everything that telemetry reports, at the present time."""


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

    def put_due(self, vehicle: Reporting) -> None:
        """Queue the telemetry that is due at the vehicle's present time."""
        snapshot = None
        for stream in self.streams.due(vehicle.time_ms):
            if stream.build_moving is not None:
                self._queue.append(stream.build_moving(vehicle))
                continue
            if snapshot is None:
                snapshot = vehicle.snapshot()
            self._queue.append(stream.build(snapshot))

    def frames(self, most: int | None = None) -> list[bytes]:
        """Number, encode and hand out what waits, at most `most` messages; the others go on waiting."""
        queue = self._queue
        handed_out = queue[:most]
        del queue[:most]
        seq, sysid, compid, frames = self._seq, self.sysid, self.compid, []
        for content in handed_out:
            frames.append(content.SCHEMA.encode(content, seq, sysid, compid))
            seq = (seq + 1) & 0xFF
        self._seq = seq
        return frames

    def number(self, content: Any) -> bytes:
        """The frame of one message with this connection's next number, past everything that waits."""
        seq = self._seq
        self._seq = (seq + 1) & 0xFF
        frame: bytes = content.SCHEMA.encode(content, seq, self.sysid, self.compid)
        return frame


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
