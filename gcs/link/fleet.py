"""Launched and external vehicles behind one interface, which is `FleetLink`'s."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from gcs.link.external import ExternalLink
from gcs.link.lockstep import FleetLink, Key
from gcs.mavlink.codec import Frame, Message


class MixedLink:
    """The supervised links, and the vehicles that live on the real clock: a tick waits for the first only."""

    def __init__(self, fleet: FleetLink, external: ExternalLink) -> None:
        self._fleet = fleet
        self.external = external
        self.host, self.port = fleet.host, fleet.port
        self._given_up: set[Key] = set()

    @property
    def buffer_bytes(self) -> int:
        """The least receive buffer that the kernel granted."""
        return min(self._fleet.buffer_bytes, self.external.buffer_bytes)

    @property
    def joined(self) -> set[Key]:
        """Vehicles that are there and still held."""
        return (self._fleet.joined | self.external.joined) - self._given_up

    @property
    def awaited(self) -> list[Key]:
        """Launched vehicles that have not answered the last grant yet."""
        return self._fleet.awaited

    @property
    def refused(self) -> dict[Key, tuple[str, int]]:
        """Who spoke with an id that another address has already, and from where; the first of each."""
        return self._fleet.refused | self.external.refused

    @property
    def malformed(self) -> int:
        """Runs of bytes that were no frames."""
        return self._fleet.malformed + self.external.malformed

    def overflowed(self) -> int:
        """Datagrams that the kernel dropped because nobody read them in time."""
        return self._fleet.overflowed() + self.external.overflowed()

    def expect(self, keys: Iterable[Key]) -> None:
        """Let these launched vehicles join when they say hello."""
        self._fleet.expect(keys)

    def listen(self, wait_s: float) -> set[Key]:
        """Take launched vehicles' hellos and external ones' first words for at most `wait_s`; who is missing."""
        missing = self._fleet.listen(0.0)
        self.external.listen(wait_s)
        return missing | self.external.missing

    def leave(self, key: Key) -> None:
        """Hold a vehicle no longer."""
        self._fleet.leave(key)
        if key in self.external.joined:
            self._given_up.add(key)

    def grant(
        self, key: Key, t_ms: int, unix_us: int, messages: Sequence[Message], relayed: Sequence[bytes]
    ) -> list[bytes]:
        """Send one vehicle what is for it, a launched one with its grant; the frames."""
        if key in self.external.joined:
            return self.external.grant(key, messages, relayed)
        return self._fleet.grant(key, t_ms, unix_us, messages, relayed)

    def collect(self, idle: Callable[[], None]) -> dict[Key, list[Frame]]:
        """What `answers` gives, in order of system id."""
        return dict(sorted(self.answers(idle)))

    def answers(self, idle: Callable[[], None]) -> Iterator[tuple[Key, list[Frame]]]:
        """Launched vehicles' answers to the last grant, then what external ones have sent."""

        def wait() -> None:
            self.external.stand_in()
            idle()

        for key, frames in self._fleet.answers(wait):
            if key not in self._given_up:
                yield key, frames
        for key, frames in self.external.collect().items():
            if key not in self._given_up:
                yield key, frames

    def repeat(self) -> None:
        """Send launched vehicles their last bundle again."""
        self._fleet.repeat()

    def close(self) -> None:
        """Close the sockets."""
        self._fleet.close()
        self.external.close()
