"""A session as the program sees it that steps it: lines to and from its supervisor (gcs/session/program/messages.py),
and questions to the program's own planner and policy, which are answered meanwhile."""

from __future__ import annotations

import contextlib
import select
import socket
from collections.abc import Mapping
from typing import Any

import msgspec

from gcs.processes.forks import close_in_forks
from gcs.session.client import READ_BYTES
from gcs.session.message_types import Reply
from gcs.session.program.messages import FINISH, FleetMessage
from gcs.session.program.objects import Objects

_LINES: msgspec.json.Decoder[FleetMessage | Reply] = msgspec.json.Decoder(FleetMessage | Reply)
WAITS_S = 0.2


class SessionChannel:
    """The program's end; `objects`: planner and policy that are asked on a socket pair of their own."""

    def __init__(self, end: socket.socket, objects: Objects | None) -> None:
        self._end, self._objects = end, objects
        close_in_forks(end)
        self._pending = b""
        self.closed = False

    def say(self, content: Mapping[str, Any]) -> None:
        """Send a request; a session that has gone is said nothing."""
        if not self.closed:
            with contextlib.suppress(OSError):
                self._end.sendall(msgspec.json.encode(content) + b"\n")

    def receive(self) -> FleetMessage | Reply | None:
        """The next line; None once the session has ended."""
        while b"\n" not in self._pending:
            if self.closed:
                return None
            if self._objects is not None and not self.await_word(self._end.fileno()):
                continue
            try:
                chunk = self._end.recv(READ_BYTES)
            except OSError:
                chunk = b""
            if not chunk:
                return None
            self._pending += chunk
        line, _, self._pending = self._pending.partition(b"\n")
        return _LINES.decode(line)

    def await_word(self, descriptor: int) -> bool:
        """Wait a while until a descriptor is readable, answering what the session asks; whether it is readable."""
        if self._objects is None:
            return bool(select.select([descriptor], [], [], WAITS_S)[0])
        asks = self._objects.fileno()
        ready = select.select([descriptor, asks], [], [], WAITS_S)[0]
        if asks in ready and not self._objects.reply():
            self._objects = None
        return descriptor in ready

    def finish(self) -> None:
        """Let the session fly on to its end by itself; questions are still answered in `await_word`."""
        self.say({"command": FINISH})
        self.close()

    def close(self) -> None:
        """Say and receive nothing more."""
        self.closed = True
        self._end.close()
