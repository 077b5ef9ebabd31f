"""The session's socket: snapshots out, operators' commands in, newline-delimited JSON
(docs/protocol/socket.md#session-socket).

A client first reads the greeting, a line of type "session": it ends with the last events that were sent before, and how
many those were in all. One that reads slowly is dropped, never waited for.
"""

from __future__ import annotations

import contextlib
import json
import os
import socket
from collections import deque
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import msgspec

from gcs.session.client import READ_BYTES, SOCKET
from gcs.session.messages import CONTEST_EVERY_S, CONTEST_S, reply_message

BACKLOG_BYTES = 1 << 20
REMEMBERED = 1000
"""Earlier events that a new client is sent: those of the start of 254 vehicles, in a greeting that a socket's buffer
holds."""
MOST_CLIENTS = 32
MOST_COMMANDS = 4
"""Lines of one client that are taken in one poll; the rest wait, and it waits with them."""
MOST_IN_ALL = 32
TOO_MANY = f"The session has {MOST_CLIENTS} clients, and takes no more: close one of them."


NO_COMMAND = 'A command is a JSON object with a text under "command", such as {"command": "pause"}.'


class ClientRequest(NamedTuple):
    """Request of one client: an object with a text under "command"."""

    client: int
    """whose it is, while it is connected"""
    content: dict[str, Any]


class Publisher:
    """The server end of `OUT/session.sock`."""

    def __init__(self, folder: Path, greeting: Mapping[str, Any] | None = None) -> None:
        self._greeting = greeting
        self._path = folder / SOCKET
        directory = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
        try:
            self._server = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM | socket.SOCK_NONBLOCK)
            self._server.bind(f"/proc/self/fd/{directory}/{SOCKET}")
            os.chmod(f"/proc/self/fd/{directory}/{SOCKET}", 0o600)  # before any client can connect
            self._server.listen(16)
        finally:
            os.close(directory)
        self._clients: dict[socket.socket, bytes] = {}
        self._numbers: dict[socket.socket, int] = {}
        self._known = 0
        self._events: deque[Any] = deque(maxlen=REMEMBERED)
        self._event_count = 0
        self._contest: deque[tuple[float, Any]] = deque(maxlen=round(CONTEST_S / CONTEST_EVERY_S))

    @property
    def clients(self) -> frozenset[int]:
        """Clients connected, by the number that requests carry."""
        return frozenset(self._numbers.values())

    @property
    def watched(self) -> bool:
        """Whether there is a client."""
        return bool(self._clients)

    def poll(self) -> list[ClientRequest]:
        """Take new clients and what the present ones ask for; never waits. An invalid line is answered by a reply that
        says so.

        Clients and what each may ask for in one poll are bounded: a client that asks for more delays itself alone.
        """
        self._accept()
        commands: list[ClientRequest] = []
        for client in list(self._clients):
            if len(commands) >= MOST_IN_ALL:
                break
            waiting = self._clients.pop(client)
            self._clients[client] = waiting  # whose turn it was is the last one next time
            if waiting.count(b"\n") < MOST_COMMANDS:
                try:
                    chunk = client.recv(READ_BYTES)
                except BlockingIOError:
                    chunk = None
                except OSError:
                    chunk = b""
                ended = chunk == b"" or (chunk is not None and len(waiting) > READ_BYTES)
                if ended and b"\n" not in waiting + (chunk or b""):
                    self._drop(client)
                    continue
                waiting += chunk or b""
            number = self._numbers[client]
            *lines, self._clients[client] = waiting.split(b"\n", MOST_COMMANDS)
            for line in lines:
                content: Any = None
                with contextlib.suppress(ValueError, RecursionError):
                    content = json.loads(line)
                request = ClientRequest(number, content if isinstance(content, dict) else {})
                if isinstance(request.content.get("command"), str):
                    commands.append(request)
                elif line.strip():
                    self.reply(request, False, NO_COMMAND)
        return commands

    def _accept(self) -> None:
        """Accept the clients that have come, each with its greeting, while there is room."""
        for _ in range(MOST_CLIENTS):
            try:
                client, _address = self._server.accept()
            except OSError:  # no client is there, or no descriptor is left: clients wait
                return
            client.setblocking(False)
            if len(self._clients) >= MOST_CLIENTS:
                with contextlib.suppress(OSError):
                    client.send(_line(reply_message(None, False, TOO_MANY)))
                client.close()
                continue
            client.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, BACKLOG_BYTES)
            self._clients[client] = b""
            self._known += 1
            self._numbers[client] = self._known
            if self._greeting is not None:
                earlier = {"events": list(self._events), "told": self._event_count, "contest": list(self._contest)}
                self._send(client, _line({**self._greeting, **earlier}))

    def greet(self, greeting: Mapping[str, Any]) -> None:
        """Send every client, and later ones, a session that has changed."""
        self._greeting = greeting
        line = _line({**greeting, "events": [], "told": self._event_count})
        for client in list(self._clients):
            self._send(client, line)

    def publish(self, content: Mapping[str, Any]) -> None:
        """Send one line to every client; a client that cannot take it whole is dropped. Later clients are sent some of
        it."""
        self.remember(content)
        line = _line(content)
        for client in list(self._clients):
            self._send(client, line)

    def remember(self, content: Mapping[str, Any]) -> None:
        """Keep a snapshot's events and its competition for later clients."""
        events = content.get("events") or ()
        self._events.extend(events)
        self._event_count += len(events)
        v = (content.get("competition") or {}).get("v")
        if v and (not self._contest or content["t_s"] - self._contest[-1][0] >= CONTEST_EVERY_S):
            self._contest.append((content["t_s"], v))

    def reply(self, request: ClientRequest, ok: bool, text: str) -> None:
        """Answer the client that asked, if it is still there: whether its command is taken, and a sentence."""
        line = _line(reply_message(request.content.get("id"), ok, text))
        for client, number in list(self._numbers.items()):
            if number == request.client:
                self._send(client, line)

    def close(self) -> None:
        """Let everyone go and take the socket away."""
        for client in list(self._clients):
            self._drop(client)
        self._server.close()
        with contextlib.suppress(OSError):
            self._path.unlink()

    def _send(self, client: socket.socket, line: bytes) -> None:
        try:
            whole = client.send(line) == len(line)
        except OSError:
            whole = False
        if not whole:
            self._drop(client)

    def _drop(self, client: socket.socket) -> None:
        self._clients.pop(client, None)
        self._numbers.pop(client, None)
        client.close()


def _line(content: Mapping[str, Any]) -> bytes:
    try:
        return msgspec.json.encode(content) + b"\n"
    except UnicodeEncodeError:  # half a pair of surrogates, which JSON can spell and UTF-8 cannot
        return json.dumps(content, allow_nan=False).encode() + b"\n"
