"""A client of a session's socket for tests: orders out, and whatever comes kept."""

from __future__ import annotations

import itertools
import json
import os
import select
import socket
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from patience import PATIENCE_S


class Attached:
    """A connection to the session in `folder`, by nothing but the socket's own words."""

    def __init__(self, folder: Path) -> None:
        directory = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
        try:
            self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            self._socket.connect(f"/proc/self/fd/{directory}/session.sock")
        finally:
            os.close(directory)
        self._pending = b""
        self._ids = itertools.count(1)
        self._waiting: list[dict[str, Any]] = []
        self.lines: list[dict[str, Any]] = []
        self.events: list[dict[str, Any]] = []

    def next(self) -> dict[str, Any]:
        """The next line; AssertionError where none comes."""
        deadline_s = time.monotonic() + PATIENCE_S
        while b"\n" not in self._pending:
            ready, _, _ = select.select([self._socket], [], [], max(deadline_s - time.monotonic(), 0.0))
            assert ready, "the session says nothing any more"
            chunk = self._socket.recv(1 << 16)
            assert chunk, "the session has ended"
            self._pending += chunk
        line, self._pending = self._pending.split(b"\n", 1)
        content: dict[str, Any] = json.loads(line)
        self.lines.append(content)
        self.events += content.get("events", ())
        return content

    def send_line(self, line: bytes) -> None:
        """Send a line as it is."""
        self._socket.sendall(line + b"\n")

    def order(self, command: str, **keys: Any) -> dict[str, Any]:
        """Send a command; the reply to it."""
        mark = f"order {next(self._ids)}"
        self._socket.sendall(json.dumps({"command": command, "id": mark, **keys}).encode() + b"\n")
        while True:
            content = self.next()
            if content["type"] == "reply" and content["id"] == mark:
                return content

    def until(self, wanted: Callable[[dict[str, Any]], bool], what: str) -> dict[str, Any]:
        """The first snapshot from now on that is as wanted."""
        while True:
            content = self.next()
            assert content["type"] != "end", f"the session ended before {what}"
            if content["type"] == "snapshot" and wanted(content):
                return content

    def close(self) -> None:
        self._socket.close()


def row(snapshot: dict[str, Any], sysid: int) -> dict[str, Any]:
    """One vehicle of a snapshot."""
    found: dict[str, Any] = next(vehicle for vehicle in snapshot["vehicles"] if vehicle["sysid"] == sysid)
    return found
