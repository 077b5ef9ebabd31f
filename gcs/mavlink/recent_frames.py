"""Frames that came lately: of a vehicle received over two links none is taken twice.

Two links may carry one stream, as behind a router: then a frame comes as the same bytes over both. An autopilot that
has a radio and a network port numbers each on its own: then a number stands for one frame here and another there.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import Literal

from gcs.mavlink.codec import Frame
from gcs.mavlink.frame_runs import HALF

Relation = Literal["new", "copy", "other"]
"""Of a frame to the one that another link brought with its number: there is none, it is the same, it is another one."""


@dataclass(slots=True)
class SeenFrame:
    """A frame that has come."""

    raw: bytes
    link: int
    """which one brought it first"""
    taken: bool = False


class RecentFrames:
    """The last HALF frames of one vehicle: no number comes round again within so many."""

    def __init__(self) -> None:
        self._order: deque[tuple[int, int]] = deque()
        self._seen: dict[tuple[int, int], SeenFrame] = {}

    def add(self, frame: Frame, link: int) -> tuple[SeenFrame, Relation, int]:
        """Keep a frame that has come over a link; the entry that stands for it, its relation to what another link
        brought, and which link that is (its own where there is none)."""
        key = frame.compid, frame.seq
        seen = self._seen.get(key)
        if seen is not None and seen.raw == frame.raw:
            return seen, "new" if seen.link == link else "copy", seen.link
        if seen is None:
            if len(self._order) >= HALF:
                del self._seen[self._order.popleft()]
            self._order.append(key)
        entry = self._seen[key] = SeenFrame(frame.raw, link)
        if seen is None or seen.link == link:
            return entry, "new", link
        return entry, "other", seen.link
