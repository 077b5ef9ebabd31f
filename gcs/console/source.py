"""Where a console's messages come from and its commands go to: a session's socket, a recording, another's fleet.

A message is a mapping with `type`: `session` first, then `snapshot`, `reply`, and one `end`. Positions are NED in m,
in the frame common to all vehicles; times are session time in s.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

Message = Mapping[str, Any]


class Source(Protocol):
    """What the console asks of whoever feeds it; all of it is called from the console's one thread."""

    @property
    def connected(self) -> bool:
        """Whether there is someone at the other end; what was received before may still be shown."""

    def receive(self) -> list[Message]:
        """The messages that have come since the last call; never waits, never raises."""

    def send(self, command: Message) -> None:
        """Hand over a command; its reply, if there is one, comes as a message. Never waits, never raises."""

    def close(self) -> None:
        """Let go of the other end, which goes on."""
