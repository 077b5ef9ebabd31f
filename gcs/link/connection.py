"""Addresses, opened: bytes with their senders in, frames out. Nothing here waits, and what is lost is had again.

A connection that cannot be had at present says so (`problem`) and tries again every RETRY_S. What is received in one
call is bounded, and what a receiver does not take is dropped frame by frame, as on a radio.
"""

from __future__ import annotations

import contextlib
import os
import select
import socket
import time
from collections.abc import Callable, Iterator
from typing import Protocol

from gcs.link.socket import MOST_AT_ONCE, RECEIVE_BYTES, AddressRefused, Where, kernel_drops, open_udp
from gcs.mavlink import codec
from gcs.mavlink.codec import Split
from gcs.mavlink.frame_stream import FrameStream
from gcs.scenario.endpoint import Endpoint

RETRY_S = 1.0
STREAM_CHUNKS = 16
"""Of RECEIVE_BYTES each: so much of one stream is taken in before anything else has its turn."""
STREAM_OUT_BYTES = 4096
"""So much waits to be sent to a stream's other end; frames beyond that are dropped."""


class Channel(Protocol):
    """One address. Times are of the monotonic clock, s."""

    at: Endpoint
    to: Where | None
    """the address that it sends to; None where it listens, and answers any sender"""
    stream: bool
    """whether it carries a stream of bytes, whose pieces must not be cut or passed over"""
    problem: str
    """why nothing can come at present, and what to do; empty while all is well"""

    @property
    def port(self) -> int:
        """The local port; 0 of a serial device."""
        return 0

    @property
    def senders(self) -> frozenset[Where]:
        """Addresses of the clients that have connected to it."""
        return frozenset()

    def fileno(self) -> int:
        """For select: readable when something has come."""

    def tend(self, now_s: float) -> None:
        """Connect again where that is due, and send what waits."""
        return

    def receive(self) -> Iterator[tuple[bytes, Where]]:
        """Bytes that have come, with their senders: a bounded number."""

    def split(self, data: bytes, sender: Where) -> Split:
        """Frames that these bytes of a sender hold, or complete."""

    def send(self, raw: bytes, to: Where) -> None:
        """Send a frame; it is lost where the other end is missing or there is no room."""

    _reported: str = ""

    def pop_problem(self) -> str | None:
        """Its problem, where that has come since the last call; empty where it has gone; None while it is as it was."""
        before, self._reported = self._reported, self.problem
        return self.problem if bool(before) != bool(self.problem) else None

    def pop_gone(self) -> set[Where]:
        """Senders whose stream has ended since the last call."""
        return set()

    def overflowed(self) -> int:
        """Datagrams that the kernel dropped because they were not read in time."""
        return 0

    def buffer_bytes(self) -> int | None:
        """The receive buffer that the kernel granted; None where none can overflow."""
        return None

    def close(self) -> None:
        """Close it for good."""


class UdpConnection(Channel):
    """Datagrams; see `Channel` for the methods."""

    stream = False
    problem = ""

    def __init__(self, at: Endpoint, *, alone: bool = False) -> None:
        """alone: take nothing but from the address of a udpout. Raises AddressRefused."""
        self.at = at
        self._socket, where = open_udp(at)
        self.to = None if at.way == "udpin" else where
        if alone and self.to is not None:
            try:
                self._socket.connect(where)
            except OSError as error:
                self._socket.close()
                raise AddressRefused(f"{at.text} cannot be spoken to: {error.strerror}") from None

    @property
    def port(self) -> int:
        return int(self._socket.getsockname()[1])

    def fileno(self) -> int:
        return self._socket.fileno()

    def receive(self) -> Iterator[tuple[bytes, Where]]:
        for _ in range(MOST_AT_ONCE):
            try:
                datagram, sender = self._socket.recvfrom(RECEIVE_BYTES)
            except BlockingIOError:
                return
            except OSError:  # a udpout whose other end is not there: raised once for each datagram sent
                if self._socket.fileno() < 0:
                    return
                continue
            yield datagram, sender

    def split(self, data: bytes, sender: Where) -> Split:
        return codec.split(data)

    def send(self, raw: bytes, to: Where) -> None:
        with contextlib.suppress(OSError):  # no receiver yet, or no room: as on a radio link, it is lost
            self._socket.sendto(raw, to)

    def overflowed(self) -> int:
        return kernel_drops(self._socket)

    def buffer_bytes(self) -> int | None:
        return self._socket.getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF) // 2

    def close(self) -> None:
        self._socket.close()


class ByteStream:
    """One stream that is open: a descriptor that never waits, and what is under way on it."""

    def __init__(
        self, descriptor: int, close: Callable[[], object], is_there: Callable[[], bool] = lambda: False
    ) -> None:
        """close: called once, at the end. is_there: asked where a read gives nothing, which of a device is no end."""
        self.descriptor = descriptor
        self.frames = FrameStream()
        self.heard_s: float | None = None
        """when it last completed a frame; None before the first"""
        self._close = close
        self._is_there = is_there
        self._unsent = b""

    def receive(self) -> Iterator[bytes]:
        """Pieces that have come, STREAM_CHUNKS at most. Raises OSError at the end; no reason: closed in order."""
        for _ in range(STREAM_CHUNKS):
            try:
                data = os.read(self.descriptor, RECEIVE_BYTES)
            except BlockingIOError:
                return
            if not data:
                if self._is_there():
                    return
                raise OSError
            yield data

    def send(self, raw: bytes) -> None:
        """Send a frame as a whole; it is dropped where too much waits already."""
        if len(self._unsent) + len(raw) <= STREAM_OUT_BYTES:
            self._unsent += raw
        self.flush()

    def flush(self) -> None:
        """Send what waits; a later read notices where the other end is gone."""
        with contextlib.suppress(OSError):
            while self._unsent:
                self._unsent = self._unsent[os.write(self.descriptor, self._unsent) :]

    def close(self) -> None:
        """Close it."""
        with contextlib.suppress(OSError):
            self._close()


class StreamConnection(Channel):
    """Part that TCP and serial streams share: streams by sender, one descriptor for all, and the senders that have
    gone.

    See `Channel` for the methods.
    """

    stream = True

    def __init__(self, at: Endpoint) -> None:
        self.at = at
        self.to: Where | None = None
        self.problem = ""
        self._streams: dict[Where, ByteStream] = {}
        self._gone: set[Where] = set()
        self._ready = select.epoll()

    @property
    def senders(self) -> frozenset[Where]:
        return frozenset(self._streams)

    def fileno(self) -> int:
        return self._ready.fileno()

    def tend(self, now_s: float) -> None:
        for stream in self._streams.values():
            stream.flush()

    def receive(self) -> Iterator[tuple[bytes, Where]]:
        for sender, stream in list(self._streams.items()):
            try:
                for data in stream.receive():
                    yield data, sender
            except OSError as end:
                self._drop(sender)
                self._ended(end.strerror or "")

    def split(self, data: bytes, sender: Where) -> Split:
        stream = self._streams.get(sender)
        if stream is None:
            return codec.split(data)
        found = stream.frames.feed(data)
        if found.frames:
            stream.heard_s = time.monotonic()
        return found

    def send(self, raw: bytes, to: Where) -> None:
        stream = self._streams.get(to)
        if stream is not None:
            stream.send(raw)

    def pop_gone(self) -> set[Where]:
        taken, self._gone = self._gone, set()
        return taken

    def close(self) -> None:
        for sender in list(self._streams):
            self._drop(sender)
        self._ready.close()

    def _add(self, sender: Where, stream: ByteStream) -> None:
        self._streams[sender] = stream
        self._ready.register(stream.descriptor, select.EPOLLIN)

    def _drop(self, sender: Where) -> None:
        stream = self._streams.pop(sender)
        with contextlib.suppress(OSError):
            self._ready.unregister(stream.descriptor)
        stream.close()
        self._gone.add(sender)

    def _ended(self, why: str) -> None:
        """A stream has ended, for this reason of the system's."""
