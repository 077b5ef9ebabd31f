"""TCP as a link: connected to a listener (`tcp`), or listening for connections (`tcpin`)."""

from __future__ import annotations

import errno
import os
import select
import socket
import time
from collections.abc import Iterator

from gcs.link.connection import RETRY_S, ByteStream, StreamConnection
from gcs.link.socket import Where, refused_to_listen, resolve
from gcs.scenario.endpoint import Endpoint

CONNECT_WITHIN_S = 5.0
MOST_CONNECTIONS = 16
"""A tcpin has so many at once; for a newcomer one makes room that has never sent a frame, or none for YIELDS_S."""
YIELDS_S = 5.0
"""A station or a vehicle sends a HEARTBEAT every second."""
_PATIENT = frozenset({errno.EINPROGRESS, errno.EWOULDBLOCK})


class TcpClient(StreamConnection):
    """One stream to a listener, made again when it has ended. See `Channel` for the methods."""

    def __init__(self, at: Endpoint) -> None:
        """Raises AddressRefused where the host is not known."""
        self._family, self._where = resolve(at, socket.SOCK_STREAM)
        super().__init__(at)
        self.to = self._where
        self._connecting: socket.socket | None = None
        self._since_s = self._retry_s = 0.0
        self.problem = "the connection is being made"
        self.tend(time.monotonic())

    @property
    def port(self) -> int:
        return int(self._socket.getsockname()[1]) if self._streams else 0

    def tend(self, now_s: float) -> None:
        super().tend(now_s)
        if self._connecting is not None:
            self._see_whether_connected(self._connecting, now_s)
        elif not self._streams and now_s >= self._retry_s:
            self._begin(now_s)

    def close(self) -> None:
        if self._connecting is not None:
            self._connecting.close()
            self._connecting = None
        super().close()

    def _begin(self, now_s: float) -> None:
        self._since_s, self._retry_s = now_s, now_s + RETRY_S
        made = socket.socket(self._family, socket.SOCK_STREAM)
        made.setblocking(False)
        failed = made.connect_ex(self._where)
        if failed and failed not in _PATIENT:
            made.close()
            self._fail(failed)
            return
        self._connecting = made
        self._ready.register(made.fileno(), select.EPOLLOUT)
        self._see_whether_connected(made, now_s)

    def _see_whether_connected(self, made: socket.socket, now_s: float) -> None:
        poll = select.poll()
        poll.register(made, select.POLLOUT)
        if not poll.poll(0):
            if now_s - self._since_s < CONNECT_WITHIN_S:
                return
            failed = errno.ETIMEDOUT
        else:
            failed = made.getsockopt(socket.SOL_SOCKET, socket.SO_ERROR)
        self._connecting = None
        self._ready.unregister(made.fileno())
        if failed:
            made.close()
            self._retry_s = now_s + RETRY_S
            self._fail(failed)
            return
        made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._socket = made
        self.problem = ""
        self._add(self._where, ByteStream(made.fileno(), made.close))

    def _fail(self, failed: int) -> None:
        self.problem = f"it cannot be reached ({os.strerror(failed)}): does the simulator or the router listen there?"

    def _ended(self, why: str) -> None:
        reason = f" ({why})" if why else ""
        self.problem = f"the other end has closed the connection{reason}: it is made again when a program listens there"
        self._retry_s = time.monotonic() + RETRY_S


class TcpListener(StreamConnection):
    """Streams of all clients that connect. See `Channel` for the methods."""

    def __init__(self, at: Endpoint) -> None:
        """Raises AddressRefused."""
        family, where = resolve(at, socket.SOCK_STREAM)
        self._socket = socket.socket(family, socket.SOCK_STREAM)
        try:
            self._socket.setblocking(False)
            self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            self._socket.bind(where)
            self._socket.listen(MOST_CONNECTIONS)
        except OSError as error:
            self._socket.close()
            raise refused_to_listen(at, error) from None
        super().__init__(at)
        self._ready.register(self._socket.fileno(), select.EPOLLIN)

    @property
    def port(self) -> int:
        return int(self._socket.getsockname()[1])

    def receive(self) -> Iterator[tuple[bytes, Where]]:
        self._accept()
        yield from super().receive()

    def close(self) -> None:
        super().close()
        self._socket.close()

    def _accept(self) -> None:
        for _ in range(MOST_CONNECTIONS):
            try:
                made, sender = self._socket.accept()
            except OSError:
                return
            if len(self._streams) >= MOST_CONNECTIONS:
                idle = min(self._streams, key=lambda other: self._streams[other].heard_s or 0.0)
                heard_s = self._streams[idle].heard_s
                if heard_s is not None and time.monotonic() - heard_s < YIELDS_S:
                    made.close()
                    continue
                self._drop(idle)
            made.setblocking(False)
            made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self._add(sender, ByteStream(made.fileno(), made.close))
