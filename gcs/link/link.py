"""The link between a supervisor and its vehicles, whoever started them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Protocol

from gcs.mavlink.codec import Frame, Message

Key = tuple[int, int]
"""System and component."""


class TickLink(Protocol):
    """What a supervisor asks of a link, tick by tick."""

    @property
    def joined(self) -> set[Key]:
        """Vehicles that are there and still held."""

    def leave(self, key: Key) -> None:
        """Hold a vehicle no longer: an unfinished answer is dropped, the others go on."""

    def grant(
        self, key: Key, t_ms: int, unix_us: int, messages: Sequence[Message], relayed: Sequence[bytes]
    ) -> list[bytes]:
        """Send one vehicle what is for it up to a time; the frames."""

    def answers(self, idle: Callable[[], None]) -> Iterator[tuple[Key, list[Frame]]]:
        """Every vehicle's frames of the tick, of those that live on the session's clock as soon as they are whole."""

    def unawaited(self) -> Mapping[Key, list[Frame]]:
        """Frames that have come since the last call from vehicles for which no tick waits."""

    def clock_offsets_s(self) -> dict[int, float]:
        """What added to the own time of a vehicle that has a clock of its own gives the session's, by system id."""

    def pop_rebooted(self) -> set[int]:
        """Whose clock has begun anew since the last call."""


class Link(TickLink, Protocol):
    """What a session asks of a link besides."""

    @property
    def malformed(self) -> int:
        """Runs of bytes that were no frames."""

    @property
    def buffer_bytes(self) -> int:
        """The least receive buffer that the kernel granted."""

    @property
    def awaited(self) -> list[Key]:
        """Launched vehicles that have not answered the last grant yet."""

    @property
    def refused(self) -> dict[Key, tuple[str, int]]:
        """Who spoke with an id that another address has already, and from where; the first of each."""

    def listen(self, wait_s: float) -> set[Key]:
        """Take the first words of vehicles for at most `wait_s`; who is missing."""

    def begin(self) -> None:
        """The session's clock runs from now."""

    def repeat(self) -> None:
        """Send launched vehicles their last bundle again."""

    def overflowed(self) -> int:
        """Datagrams that the kernel dropped because nobody read them in time."""

    def close(self) -> None:
        """Close the sockets."""
