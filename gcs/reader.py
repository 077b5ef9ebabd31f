"""The supervisor's end of a channel to one reader that gets every snapshot it asks for: the Python session.

Stream socket. The reader writes `n` for the next snapshot and `s` for the session's end; one JSON line answers each
`n`. Whoever reads so is waited for in lockstep, unlike the clients of the session's socket.
"""

from __future__ import annotations

import contextlib
import json
import select
import socket
from collections.abc import Iterable, Mapping
from dataclasses import asdict
from typing import Any

from gcs.telemetry.events import Event

NEXT, STOP = b"n", b"s"
BUFFER_BYTES = 1 << 20


class Reader:
    """The channel on an inherited file descriptor."""

    def __init__(self, descriptor: int, every_ms: int) -> None:
        self._socket = socket.socket(fileno=descriptor)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, BUFFER_BYTES)
        self._events: list[Event] = []
        self._every_ms = every_ms
        self.open = True
        self.asked = False
        self.stops = False

    def due(self, time_s: float) -> bool:
        """Whether a snapshot of this session time is one that the reader wants to be asked about."""
        return self.open and round(1e3 * time_s) % self._every_ms == 0

    def wants(self, timeout_s: float) -> bool:
        """Whether the next snapshot is asked for, or the end; waits for a word up to `timeout_s`."""
        if self.open and not self.asked and select.select([self._socket], [], [], timeout_s)[0]:
            try:
                said = self._socket.recv(64)
            except OSError:
                said = b""
            self.open = bool(said)
            self.asked = NEXT in said
            self.stops = STOP in said
        return self.asked or self.stops

    def remember(self, events: Iterable[Event]) -> None:
        """Keep these for the next snapshot."""
        self._events += events

    def give(self, picture: Mapping[str, Any]) -> None:
        """Answer with this picture and the events since the last one."""
        events, self._events = self._events, []
        self.asked = False
        line = json.dumps({**picture, "events": [asdict(event) for event in events]}, allow_nan=False)
        with contextlib.suppress(OSError):
            self._socket.sendall(line.encode() + b"\n")
