"""A client of a session's socket: messages in, commands out, newline-delimited JSON
(docs/protocol/socket.md#session-socket)."""

from __future__ import annotations

import json
import os
import socket
import time
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, Protocol

Message = Mapping[str, Any]


RETRY_S = 0.25
GONE_S = 3.0
"""A session whose socket has not answered for this long, after it had, is over."""

NO_LAST_WORD: Message = {
    "type": "end",
    "outcome": None,
    "text": "its process ended without a last word; the terminal that started it may say why",
    "exit": None,
}
"""The end of a session that has said none."""
SOCKET = "session.sock"
READ_BYTES = 1 << 16


class Client:
    """One connection to the session in `folder`; raises OSError where no session listens there.

    `connected` turns False when the session has ended or has dropped this client for being slow.
    """

    def __init__(self, folder: Path) -> None:
        self._lines = Lines()
        self.connected = True
        directory = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
        try:
            self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM | socket.SOCK_NONBLOCK)
            try:
                self._socket.connect(f"/proc/self/fd/{directory}/{SOCKET}")
            except OSError:
                self._socket.close()
                raise
        finally:
            os.close(directory)

    def fileno(self) -> int:
        """For select: readable when a message or the end has come."""
        return self._socket.fileno()

    def receive(self) -> list[Message]:
        """The messages that have come; never waits."""
        messages: list[Message] = []
        while self.connected:
            try:
                chunk = self._socket.recv(READ_BYTES)
            except BlockingIOError:
                break
            except OSError:
                chunk = b""
            if not chunk:
                self.connected = False
                break
            messages += self._lines.feed(chunk)
        return messages

    def send(self, command: Message) -> None:
        """Hand a command over; a session that does not take it at once is let go of."""
        try:
            self._socket.sendall(json.dumps(command).encode() + b"\n")
        except OSError:
            self.connected = False

    def say(self, word: str) -> None:
        """A command of one word: `pause`, `resume` or `stop`."""
        self.send({"command": word})

    def close(self) -> None:
        """Let go of the session, which goes on."""
        self.connected = False
        self._socket.close()


class Lines:
    """Bytes → JSON objects, one per line. What is no object, and an unfinished last line, is left out."""

    def __init__(self) -> None:
        self._pending = b""

    def feed(self, chunk: bytes) -> list[Message]:
        """The objects that `chunk` completes."""
        *lines, self._pending = (self._pending + chunk).split(b"\n")
        messages: list[Message] = []
        for line in lines:
            try:
                content = json.loads(line)
            except (ValueError, RecursionError):
                continue
            if isinstance(content, dict):
                messages.append(content)
        return messages


class SessionSource:
    """The session in `folder`; a slow console that the session has dropped comes back by itself."""

    def __init__(self, folder: Path, clock: Callable[[], float] = time.monotonic) -> None:
        self._folder = folder
        self._clock = clock
        self._client: Client | None = None
        self._earlier = EarlierEvents()
        self._retry_s = self._last_received_s = float("-inf")
        self._inspect: Message | None = None
        self._over = False

    @property
    def connected(self) -> bool:
        """Whether the session is there."""
        return self._client is not None and self._client.connected

    def receive(self) -> list[Message]:
        """Messages received; an `end` of our own where the session has gone without a word."""
        now_s = self._clock()
        if self._over:
            return []
        if not self.connected and now_s >= self._retry_s:
            self._retry_s = now_s + RETRY_S
            self._connect()
        if self._client is None:
            return self._gone(now_s)
        messages = self._earlier.joined(self._client.receive())
        if messages or self._client.connected:
            self._last_received_s = now_s
        self._over = any(message.get("type") == "end" for message in messages)
        return messages

    def _gone(self, now_s: float) -> list[Message]:
        if self._last_received_s == float("-inf") or now_s - self._last_received_s < GONE_S:
            return []
        self._over = True
        return [NO_LAST_WORD]

    def _connect(self) -> None:
        if self._client is not None:
            self._client.close()
            self._client = None
        try:
            self._client = Client(self._folder)
        except OSError:
            return
        if self._inspect is not None:
            self._client.send(self._inspect)

    def send(self, command: Message) -> None:
        """Hand over a command; without a session it is lost. What is inspected is asked for again after a loss."""
        if command.get("command") == "inspect":
            self._inspect = command
        if self._client is not None:
            self._client.send(command)

    def close(self) -> None:
        """Let go of the session, which goes on."""
        self._over = True
        if self._client is not None:
            self._client.close()


class EarlierEvents:
    """Lasts as long as its viewer, over any number of connections."""

    def __init__(self) -> None:
        self._event_count = 0
        self._missed: list[Any] = []

    def joined(self, messages: Iterable[Message]) -> list[Message]:
        """The messages, with what was missed put before the events of the next snapshot."""
        made: list[Message] = []
        for message in messages:
            kind, events = message.get("type"), list(message.get("events") or ())
            if kind == "session":
                sent = int(message.get("told") or 0)
                known = (
                    self._event_count if self._event_count <= sent else 0
                )  # else it is another session, in the same place
                missed = min(sent - known, len(events))
                self._missed = events[len(events) - missed :]
                if events and sent - known > missed:
                    self._missed.insert(0, _left_out(sent - known - missed, float(self._missed[0]["t_s"])))
                self._event_count = sent
            elif kind == "snapshot":
                self._event_count += len(events)
                if self._missed:
                    message = {**message, "events": [*self._missed, *events]}  # noqa: PLW2901
                    self._missed = []
            made.append(message)
        return made


def _left_out(count: int, t_s: float) -> dict[str, Any]:
    """The event that stands for those before a time that a session no longer keeps for new clients."""
    text = f"{count} earlier events are not shown here: the report shows them"
    return {"t_s": t_s, "sysid": None, "level": "info", "text": text, "kind": "session"}


class MessageSource(Protocol):
    """Source of the console's messages; all of it is called from the console's one thread."""

    @property
    def connected(self) -> bool:
        """Whether the other end is there; what was received before may still be shown."""

    def receive(self) -> list[Message]:
        """The messages that have come since the last call; never waits, never raises."""

    def send(self, command: Message) -> None:
        """Hand over a command; its reply, if there is one, comes as a message. Never waits, never raises."""

    def close(self) -> None:
        """Let go of the other end, which goes on."""
