"""Launched and external vehicles behind one `Link`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from gcs.link.external import ExternalLink
from gcs.link.link import Answers, Key, TickGrants
from gcs.link.lockstep import LockstepLink
from gcs.mavlink.codec import Frame, Message


class FleetLink:
    """The supervised links, and the vehicles that live on the real clock: a tick waits for the first only.

    See `Link` for the methods.
    """

    def __init__(self, fleet: LockstepLink, external: ExternalLink) -> None:
        self._fleet = fleet
        self._external = external
        self._given_up: set[Key] = set()
        self.begin = external.begin
        self.repeat = fleet.repeat
        self.flush = fleet.flush
        self.pop_relinked = external.pop_relinked
        self.links = external.links

    @property
    def signature_refusals(self) -> dict[int, int]:
        return self._external.signature_refusals

    @property
    def buffer_bytes(self) -> int:
        return min(self._fleet.buffer_bytes, self._external.buffer_bytes)

    @property
    def joined(self) -> set[Key]:
        return (self._fleet.joined | self._external.joined) - self._given_up

    @property
    def awaited(self) -> list[Key]:
        return self._fleet.awaited

    @property
    def refused(self) -> dict[Key, tuple[str, int]]:
        return self._fleet.refused | self._external.refused

    @property
    def malformed(self) -> int:
        return self._fleet.malformed + self._external.malformed

    def overflowed(self) -> int:
        return self._fleet.overflowed() + self._external.overflowed()

    def unawaited_s(self) -> float:
        return self._external.collected_s

    def clock_offsets_s(self) -> dict[int, float]:
        return self._fleet.clock_offsets_s() | self._external.offsets_s()

    def pop_rebooted(self) -> set[int]:
        return self._fleet.pop_rebooted() | self._external.pop_rebooted()

    def listen(self, wait_s: float) -> set[Key]:
        missing = self._fleet.listen(0.0)
        self._external.listen(wait_s)
        return missing | self._external.missing

    def leave(self, key: Key) -> None:
        self._fleet.leave(key)
        if key in self._external.joined:
            self._given_up.add(key)

    def grant_all(self, grants: TickGrants) -> Sequence[bytes]:
        if grants.keys and not self._external.joined.intersection(grants.keys):
            return self._fleet.grant_all(grants)
        return [
            raw for key in grants.keys for raw in self.grant(key, grants.t_ms, grants.unix_us, *grants.content(key))
        ]

    def grant(
        self, key: Key, t_ms: int, unix_us: int, messages: Sequence[Message], relayed: Sequence[bytes], air: bytes = b""
    ) -> list[bytes]:
        if key in self._external.joined:
            return self._external.grant(key, messages, relayed)
        return self._fleet.grant(key, t_ms, unix_us, messages, relayed, air)

    def answers(self, idle: Callable[[], None]) -> Iterator[Answers]:
        def wait() -> None:
            self._external.stand_in()
            idle()

        return self._fleet.answers(wait)

    def unawaited(self) -> dict[Key, list[Frame]]:
        return {key: frames for key, frames in self._external.collect().items() if key not in self._given_up}

    def close(self) -> None:
        self._fleet.close()
        self._external.close()
