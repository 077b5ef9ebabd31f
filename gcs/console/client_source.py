"""A running session as a console's source: its socket, opened as soon as it is there and again when it was lost."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from gcs.console.client import Client
from gcs.console.earlier import Earlier
from gcs.console.source import Message

RETRY_S = 0.25
GONE_S = 3.0
"""A session whose socket nobody has answered for this long, after someone had, is over."""


class SessionSource:
    """The session in `folder`; a slow console that the session has dropped comes back by itself."""

    def __init__(self, folder: Path, clock: Callable[[], float] = time.monotonic) -> None:
        self._folder = folder
        self._clock = clock
        self._client: Client | None = None
        self._earlier = Earlier()
        self._retry_s = self._heard_s = float("-inf")
        self._inspect: Message | None = None
        self._over = False

    @property
    def connected(self) -> bool:
        """Whether the session is there."""
        return self._client is not None and self._client.connected

    def receive(self) -> list[Message]:
        """What has come; an `end` of our own where the session has gone without a word."""
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
            self._heard_s = now_s
        self._over = any(message.get("type") == "end" for message in messages)
        return messages

    def _gone(self, now_s: float) -> list[Message]:
        if self._heard_s == float("-inf") or now_s - self._heard_s < GONE_S:
            return []
        self._over = True
        return [{"type": "end", "outcome": None, "exit": None}]

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
