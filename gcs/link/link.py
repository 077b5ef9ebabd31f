"""The link between a supervisor and its vehicles, launched and external ones."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from typing import NamedTuple, Protocol

from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.ids import OUR_HEARTBEAT
from gcs.mavlink.setpoints import PlacedSetPoints

Key = tuple[int, int]
"""System and component."""


Answers = tuple[Sequence[Key], Sequence[Sequence[Frame]]]
"""Some vehicles, and the frames of each, which may be `AnswerRuns`, but of one group in a tick at most."""


class LinkState(NamedTuple):
    """One of the links of a vehicle that has several."""

    connect: str
    used: bool
    """whether what is sent goes over it"""
    fresh: bool
    """whether it is there at present"""
    received: int
    """frames"""
    lost_share: float | None
    """of the frames of the last 10 s, 0..1; None where there were none"""


class TickGrants(NamedTuple):
    """All that goes to the vehicles at a tick's end."""

    t_ms: int
    """until when they may fly, in session time"""
    unix_us: int
    """the same since 1970, UTC"""
    keys: Sequence[Key]
    """the vehicles that it goes to, in order"""
    heartbeat_due: Collection[int]
    """system ids of the vehicles that get our HEARTBEAT"""
    points: PlacedSetPoints
    more: Mapping[Key, tuple[Sequence[Message], Sequence[bytes], bytes]]
    """of vehicles that get more, or less, than HEARTBEAT and set point: all messages, frames as they are, and what
    other vehicles have broadcast"""

    def content(self, key: Key) -> tuple[Sequence[Message], Sequence[bytes], bytes]:
        """Messages for one of `keys`, frames as they are, and what other vehicles have broadcast."""
        if key in self.more:
            return self.more[key]
        messages = [OUR_HEARTBEAT] if key[0] in self.heartbeat_due else []
        if key[0] in self.points.sysids:
            messages.append(self.points.message(key[0]))
        return messages, (), b""


class TickLink(Protocol):
    """Link as a supervisor uses it, tick by tick."""

    @property
    def joined(self) -> set[Key]:
        """Vehicles that are there and still held."""

    def leave(self, key: Key) -> None:
        """Hold a vehicle no longer: an unfinished answer is dropped, the others go on."""

    def grant(
        self, key: Key, t_ms: int, unix_us: int, messages: Sequence[Message], relayed: Sequence[bytes], air: bytes = b""
    ) -> list[bytes]:
        """Send one vehicle what is for it up to a time, at `flush` at the latest; the frames. `air`: what others have
        broadcast, which goes out now or never."""

    def grant_all(self, grants: TickGrants) -> Sequence[bytes]:
        """Send each vehicle its messages, at `flush` at the latest; the frames, in order."""
        return [
            raw for key in grants.keys for raw in self.grant(key, grants.t_ms, grants.unix_us, *grants.content(key))
        ]

    def flush(self) -> None:
        """Send what has been granted and not been sent yet."""

    def answers(self, idle: Callable[[], None]) -> Iterator[Answers]:
        """Frames of the tick of each vehicle that lives on the session's clock, when all are whole or before."""

    def unawaited(self) -> Mapping[Key, list[Frame]]:
        """Frames that have come since the last call from vehicles for which no tick waits."""
        return {}

    def unawaited_s(self) -> float:
        """Session time by the wall clock when `unawaited` was called last; a session's ticks may be behind it."""
        return -math.inf

    def clock_offsets_s(self) -> dict[int, float]:
        """Offset from the own time of a vehicle that has its own clock to the session's, s, by system id."""
        return {}

    def pop_rebooted(self) -> set[int]:
        """System ids of vehicles whose clock has restarted since the last call."""
        return set()

    def pop_relinked(self) -> set[int]:
        """System ids of vehicles of which, since the last call, a link has come, or another is used whose frames have
        numbers of their own."""
        return set()

    def links(self) -> dict[int, list[LinkState]]:
        """Links of the vehicles that have several, in the scenario's order, by system id."""
        return {}


class Link(TickLink, Protocol):
    """Link as a session uses it besides."""

    @property
    def malformed(self) -> int:
        """Runs of bytes that were no frames."""

    @property
    def signature_refusals(self) -> dict[int, int]:
        """Frames refused for their signature, by system id."""

    @property
    def buffer_bytes(self) -> int:
        """The least receive buffer that the kernel granted."""

    @property
    def awaited(self) -> list[Key]:
        """Launched vehicles that have not answered the last grant yet."""

    @property
    def refused(self) -> dict[Key, tuple[str, int]]:
        """Senders with an id that another address has already, and their addresses; the first of each."""

    def listen(self, wait_s: float) -> set[Key]:
        """Receive the first frames of vehicles for at most `wait_s`; those that are missing."""

    def begin(self) -> None:
        """The session's clock runs from now."""

    def repeat(self) -> None:
        """Send launched vehicles their last bundle again."""

    def overflowed(self) -> int:
        """Datagrams that the kernel dropped because they were not read in time."""

    def close(self) -> None:
        """Close the sockets."""
