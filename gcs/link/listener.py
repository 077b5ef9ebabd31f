"""Socket of `gcs monitor`: UDP or a TCP stream, split into frames, MAVLink 1 too; sends only when asked to."""

from __future__ import annotations

import contextlib
import socket
from collections.abc import Iterator
from pathlib import Path

from gcs.link.keys import SignatureGate
from gcs.link.socket import MOST_AT_ONCE, RECEIVE_BYTES, AddressRefused, Where, open_udp, resolve
from gcs.mavlink import codec, v1
from gcs.mavlink.codec import Frame
from gcs.scenario.endpoint import Endpoint

CONNECT_WITHIN_S = 5.0


class Listener:
    """Frames received at an address, with their senders, of MAVLink 1 too. Raises AddressRefused where it cannot be
    had."""

    def __init__(self, at: Endpoint, key_file: Path | None = None) -> None:
        """Raises AddressRefused, KeyRefused."""
        self.gate = SignatureGate(key_file)
        self._stream = at.way == "tcp"
        self._pending = b""
        self.open = True
        self._socket, where = _connected(at) if self._stream else open_udp(at)
        self._to = None if at.way == "udpin" else where

    @property
    def port(self) -> int:
        """The port that it is at."""
        return int(self._socket.getsockname()[1])

    def fileno(self) -> int:
        """The socket's."""
        return self._socket.fileno()

    def receive(self) -> Iterator[tuple[list[Frame], Where]]:
        """Frames received, with their senders, of a bounded number of datagrams; never waits."""
        for _ in range(MOST_AT_ONCE):
            if not self.open:
                return
            try:
                data, peer = self._socket.recvfrom(RECEIVE_BYTES)
            except OSError as error:
                self.open = isinstance(error, BlockingIOError | ConnectionRefusedError) or not self._stream
                return
            if self._stream:
                if not data:
                    self.open = False
                    return
                yield self.gate.accepted(self._cut(data)), self._to or ()
                continue
            yield self.gate.accepted(codec.split(data).frames or v1.split(data)), tuple(peer)

    def send(self, raw: bytes, peer: Where) -> None:
        """Send a frame to a known sender, or to the address of a udpout or tcp."""
        raw = self.gate.signed(raw)
        with contextlib.suppress(OSError):
            if self._stream:
                self._socket.sendall(raw)
            else:
                self._socket.sendto(raw, self._to or peer)

    @property
    def to(self) -> Where | None:
        """Address that it sends to; None where it listens."""
        return self._to

    def close(self) -> None:
        """Close the socket."""
        self.open = False
        self._socket.close()
        self.gate.close()

    def _cut(self, data: bytes) -> list[Frame]:
        """The frames that a stream's next bytes complete."""
        self._pending += data
        frames = codec.split(self._pending).frames
        if frames:
            last = frames[-1].raw
            self._pending = self._pending[self._pending.rindex(last) + len(last) :]
        self._pending = self._pending[-codec.LARGEST_FRAME :]  # what is earlier belongs to no frame that is to come
        return frames


def _connected(at: Endpoint) -> tuple[socket.socket, Where]:
    """A stream to a listener. Raises AddressRefused."""
    family, where = resolve(at, socket.SOCK_STREAM)
    made = socket.socket(family, socket.SOCK_STREAM)
    try:
        made.settimeout(CONNECT_WITHIN_S)
        made.connect(where)
        made.setblocking(False)
    except OSError as error:
        made.close()
        raise AddressRefused(f"{at.text} cannot be reached: {error.strerror or 'no answer'}") from None
    return made, where
