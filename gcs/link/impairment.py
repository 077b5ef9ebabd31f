"""A bad radio, in session time: what it loses, holds back, repeats and shuffles
(docs/protocol/radio.md#radio-impairment).

It stands above the link, between it and the supervisor, and knows nothing of frames but their order. Each vehicle and
direction has a random stream of its own, seeded by name; every frame draws the same number of times whatever becomes of
it. So a vehicle's fate does not depend on the others, and raising the loss loses more frames rather than other ones.
"""

from __future__ import annotations

import hashlib
import heapq
import random
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Literal, NamedTuple, TypeVar

Item = TypeVar("Item")
Direction = Literal["in", "out"]
"""To the ground station, and from it."""

# Session times are sums of tick lengths; a delivery must not slip a tick for their last bits.
_ROUNDING_S = 1e-6


class Burst(NamedTuple):
    """The radio of a vehicle is worse for frames sent in from_s ≤ t < to_s; with a loss of 1 none gets through."""

    sysid: int | None
    """None: of every vehicle"""
    from_s: float
    to_s: float
    loss: float = 0.0
    """share of frames lost, if that is more than otherwise"""
    delay_s: float = 0.0
    """how much later than otherwise frames come"""
    only: Direction | None = None
    """the direction that it is about; None: both"""


@dataclass
class _Stream:
    """One vehicle and direction: its randomness and the frames in the air."""

    random: random.Random
    sent: int = 0
    pending: list[tuple[float, int, object]] = field(default_factory=list)
    """heap of (delivery time, order, frame)"""
    overtaken: list[tuple[float, object]] = field(default_factory=list)
    """(delivery time, frame) of frames that follow the next one sent"""

    def launch(self, due_s: float, frame: object) -> None:
        heapq.heappush(self.pending, (due_s, self.sent, frame))
        self.sent += 1


class Impairment:
    """The radio of all vehicles.

    `loss`, `duplicate` and `reorder` are shares of frames in [0, 1]; `delay_s` holds every frame back, `jitter_s` adds
    a uniform random part of up to that much, by which frames may overtake each other. A duplicate is delayed on its
    own. A reordered frame is delivered after the one that is sent next.
    """

    def __init__(
        self,
        *,
        loss: float = 0.0,
        delay_s: float = 0.0,
        jitter_s: float = 0.0,
        duplicate: float = 0.0,
        reorder: float = 0.0,
        bursts: Iterable[Burst] = (),
        seed: int = 0,
    ) -> None:
        self._loss, self._duplicate, self._reorder = loss, duplicate, reorder
        self._delay_s, self._jitter_s = delay_s, jitter_s
        self._bursts: tuple[Burst, ...] = ()
        self._seed = seed
        self._streams: dict[tuple[int, Direction | int], _Stream] = {}
        self.clear = not any((loss, delay_s, jitter_s, duplicate, reorder))
        """whether every frame passes as it is"""
        self.prompt = not any((delay_s, jitter_s, reorder))
        """whether none is held back"""
        self.add(bursts)

    def add(self, bursts: Iterable[Burst]) -> None:
        """Let the radio have these too, from the next frames on."""
        self._bursts += tuple(bursts)
        self.clear = self.clear and not self._bursts
        self.prompt = self.prompt and not any(burst.delay_s for burst in self._bursts)

    def apply(
        self, sysid: int, direction: Direction | int, t_s: float, frames: Sequence[Item], *, dark: bool = False
    ) -> Sequence[Item]:
        """Send a vehicle's frames at session time `t_s`; what is delivered now, held frames that are due included.

        direction: to or from the ground station, or the system id of the vehicle that they come from. dark: none gets
        through now.

        Call it once per tick even without frames, with times that do not fall. Frames due at the same time come in the
        order in which they were sent.
        """
        if self.clear:
            return () if dark else frames
        stream = self._streams.get((sysid, direction))
        if stream is None:
            stream = self._streams[sysid, direction] = _Stream(_random(self._seed, sysid, direction))
        loss, delay_s = (1.0 if dark else self._loss), self._delay_s
        for burst in self._bursts:
            if burst.sysid in (None, sysid) and burst.from_s <= t_s < burst.to_s and burst.only in (None, direction):
                loss, delay_s = max(loss, burst.loss), delay_s + burst.delay_s
        for frame in frames:
            self._send(stream, t_s, frame, loss, delay_s)
        delivered: list[Item] = []
        while stream.pending and stream.pending[0][0] <= t_s + _ROUNDING_S:
            delivered.append(heapq.heappop(stream.pending)[2])  # type: ignore[arg-type]  # it came in as an Item
        return delivered

    def _send(self, stream: _Stream, t_s: float, frame: object, loss: float, delay_s: float) -> None:
        draw = stream.random.random
        lost, late, again, again_late, overtaken = draw(), draw(), draw(), draw(), draw()
        if lost < loss:
            return
        due_s = t_s + delay_s + late * self._jitter_s
        if overtaken < self._reorder:
            stream.overtaken.append((due_s, frame))
        else:
            stream.launch(due_s, frame)
            for overtaken_due_s, held in stream.overtaken:
                stream.launch(max(due_s, overtaken_due_s), held)
            stream.overtaken.clear()
        if again < self._duplicate:
            stream.launch(t_s + delay_s + again_late * self._jitter_s, frame)


def _random(seed: int, sysid: int, direction: Direction | int) -> random.Random:
    """The stream of this name: the same in every process, unlike one seeded by `hash`."""
    digest = hashlib.sha256(f"{seed}/{sysid}/{direction}".encode()).digest()
    return random.Random(int.from_bytes(digest[:16], "big"))
