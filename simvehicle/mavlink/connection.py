"""One MAVLink conversation without its socket: sequence numbers, streams, and what waits to be sent."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from simvehicle.autopilot.maneuvers import AT_REST
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.mavlink.motion_frames import LARGEST_BYTES, write_motion
from simvehicle.mavlink.streams import StreamSchedule
from simvehicle.mavlink.telemetry import Stream

DATAGRAM_BYTES = 1400


class Connection:
    """A connection's own sequence counter, stream schedule and send queue."""

    def __init__(self, sysid: int, compid: int = 1) -> None:
        self.sysid = sysid
        self.compid = compid
        self.streams = StreamSchedule()
        self.seq = 0
        """number of the next frame"""
        self._queue: list[Any] = []
        """messages, or frames that have their number already"""
        self._buffer = np.empty(LARGEST_BYTES, np.uint8)

    @property
    def waiting(self) -> bool:
        """Whether anything waits to be sent."""
        return bool(self._queue)

    def put(self, content: Any) -> None:
        """Queue a message behind those that wait."""
        self._queue.append(content)

    def put_due(self, vehicle: Vehicle) -> None:
        """Queue the telemetry that is due at the vehicle's present time."""
        due = self.streams.due(vehicle.time_ms)
        if not self._queue and vehicle.position_error_ned is AT_REST and (wanted := _motion_alone(due)):
            self._put_motion(vehicle, wanted)
        elif due:
            snapshot = vehicle.snapshot()
            for stream in due:
                self._queue.append(stream.build(snapshot))

    def _put_motion(self, vehicle: Vehicle, wanted: int) -> None:
        """The same in most ticks; numbered at once, since nothing waits before it."""
        first, second, end = write_motion(
            self._buffer,
            vehicle.state,
            vehicle.frame.row,
            vehicle.home_ned[2],
            vehicle.time_ms,
            wanted,
            self.seq,
            self.sysid,
            self.compid,
        )
        written = self._buffer[:end].tobytes()
        frames = [frame for frame in (written[:first], written[first:second], written[second:]) if frame]
        self.seq = (self.seq + len(frames)) & 0xFF
        self._queue += frames

    def frames(self, most: int | None = None) -> list[bytes]:
        """Number, encode and hand out what waits, at most `most` messages; the others go on waiting."""
        queue = self._queue
        handed_out = queue[:most]
        del queue[:most]
        seq, sysid, compid, frames = self.seq, self.sysid, self.compid, []
        for content in handed_out:
            if type(content) is bytes:
                frames.append(content)
                continue
            frames.append(content.SCHEMA.encode(content, seq, sysid, compid))
            seq = (seq + 1) & 0xFF
        self.seq = seq
        return frames

    def number(self, content: Any) -> bytes:
        """The frame of one message with this connection's next number, past everything that waits."""
        seq = self.seq
        self.seq = (seq + 1) & 0xFF
        frame: bytes = content.SCHEMA.encode(content, seq, self.sysid, self.compid)
        return frame


def _motion_alone(due: Iterable[Stream]) -> int:
    """Bits of the streams that are due, where `motion_frames` makes them all; else 0."""
    wanted = 0
    for stream in due:
        if not stream.motion:
            return 0
        wanted |= stream.motion
    return wanted


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
