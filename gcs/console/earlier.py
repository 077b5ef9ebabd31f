"""What a session told before this client came to it: in the session's first line, and shown once, as if heard now.

The session counts its events. So a client that was dropped and comes back is told what it missed, and nothing twice.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from gcs.console.source import Message


class Earlier:
    """Lasts as long as somebody looks on, over any number of connections."""

    def __init__(self) -> None:
        self._heard = 0
        self._missed: list[Any] = []

    def joined(self, messages: Iterable[Message]) -> list[Message]:
        """The messages, with what was missed put before the events of the next snapshot."""
        made: list[Message] = []
        for message in messages:
            kind, events = message.get("type"), list(message.get("events") or ())
            if kind == "session":
                told = int(message.get("told") or 0)
                heard = self._heard if self._heard <= told else 0  # else it is another session, in the same place
                missed = min(told - heard, len(events))
                self._missed = events[len(events) - missed :]
                self._heard = told
            elif kind == "snapshot":
                self._heard += len(events)
                if self._missed:
                    message = {**message, "events": [*self._missed, *events]}  # noqa: PLW2901
                    self._missed = []
            made.append(message)
        return made
