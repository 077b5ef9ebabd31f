"""The session's socket: snapshots out, operators' commands in, newline-delimited JSON (contract.md, Processes).

A reader that is slow is dropped, never waited for.
"""

from __future__ import annotations

import contextlib
import json
import os
import socket
from collections.abc import Mapping
from pathlib import Path
from typing import Any

NAME = "session.sock"
READ_BYTES = 65536
BACKLOG_BYTES = 1 << 20


class Publisher:
    """The server end of `OUT/session.sock`."""

    def __init__(self, folder: Path) -> None:
        self._path = folder / NAME
        directory = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
        try:
            self._server = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM | socket.SOCK_NONBLOCK)
            self._server.bind(f"/proc/self/fd/{directory}/{NAME}")
            self._server.listen(16)
        finally:
            os.close(directory)
        self._clients: dict[socket.socket, bytes] = {}

    def poll(self) -> list[dict[str, Any]]:
        """Take new clients and what the present ones ask for; never waits. Lines that are no commands are ignored."""
        with contextlib.suppress(BlockingIOError):
            while True:
                client, _ = self._server.accept()
                client.setblocking(False)
                client.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, BACKLOG_BYTES)
                self._clients[client] = b""
        commands = []
        for client in list(self._clients):
            try:
                chunk = client.recv(READ_BYTES)
            except BlockingIOError:
                continue
            except OSError:
                chunk = b""
            if not chunk or len(self._clients[client]) > READ_BYTES:
                self._drop(client)
                continue
            *lines, self._clients[client] = (self._clients[client] + chunk).split(b"\n")
            for line in lines:
                with contextlib.suppress(ValueError, RecursionError):
                    content = json.loads(line)
                    if isinstance(content, dict) and isinstance(content.get("command"), str):
                        commands.append(content)
        return commands

    def publish(self, content: Mapping[str, Any]) -> None:
        """Send one line to every client; who cannot take it whole is dropped."""
        line = json.dumps(content, allow_nan=False).encode() + b"\n"
        for client in list(self._clients):
            try:
                whole = client.send(line) == len(line)
            except OSError:
                whole = False
            if not whole:
                self._drop(client)

    def close(self) -> None:
        """Let everyone go and take the socket away."""
        for client in list(self._clients):
            self._drop(client)
        self._server.close()
        with contextlib.suppress(OSError):
            self._path.unlink()

    def _drop(self, client: socket.socket) -> None:
        self._clients.pop(client, None)
        client.close()
