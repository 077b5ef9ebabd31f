"""A client of a session's socket: messages in, commands out, newline-delimited JSON (contract.md, Processes)."""

from __future__ import annotations

import json
import os
import socket
from pathlib import Path

from gcs.console.source import Message

SOCKET = "session.sock"
READ_BYTES = 1 << 16


class Client:
    """One connection to the session in `folder`; raises OSError where nobody listens there.

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
            except ValueError:
                continue
            if isinstance(content, dict):
                messages.append(content)
        return messages
