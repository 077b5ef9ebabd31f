"""Frame loss per vehicle from sequence-number gaps: total so far, and share over the last 10 s."""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass, field

from gcs.mavlink.gaps import GapCounter

WINDOW_S = 10.0
SAMPLE_EVERY_S = 1.0
_ROUNDING_S = 1e-6
LOSSY_SHARE = 0.05
"""A link that loses so many frames is sent copies of those that must arrive soon."""
LEFT_SHARE = 0.03
"""[choice] So many of them may be lost with all their copies."""
MOST_COPIES = 3


def copies(lost_share: float | None) -> int:
    """Number of copies of a frame that must arrive soon, over a link that loses this share of its frames; None: 1."""
    if lost_share is None or lost_share < LOSSY_SHARE:
        return 1
    return min(math.ceil(math.log(LEFT_SHARE) / math.log(min(lost_share, 0.5))), MOST_COPIES)


@dataclass
class _Counts:
    """One vehicle's counts, and what they were at earlier times: (s, received, lost)."""

    received: int = 0
    samples: deque[tuple[float, int, int]] = field(default_factory=lambda: deque([(0.0, 0, 0)]))


class LinkQuality:
    """Counts frames by system id; `gaps` must be fed every frame, this only their number."""

    def __init__(self, gaps: GapCounter) -> None:
        self._gaps = gaps
        self._counts: dict[int, _Counts] = {}

    def count(self, sysid: int, frames: int, now_s: float) -> None:
        """Count frames of a vehicle that were delivered at `now_s`."""
        counts = self._counts.get(sysid)
        if counts is None:
            counts = self._counts[sysid] = _Counts()
        counts.received += frames
        samples = counts.samples
        if now_s - samples[-1][0] >= SAMPLE_EVERY_S - _ROUNDING_S:
            samples.append((now_s, counts.received, self.lost(sysid)))
            while now_s - samples[1][0] >= WINDOW_S - _ROUNDING_S:
                samples.popleft()

    def begin(self, now_s: float) -> None:
        """Count lost frames from `now_s` on."""
        self._counts = {sysid: _Counts(samples=deque([(now_s, 0, lost)])) for sysid, lost in self._gaps.lost_of.items()}

    def lost(self, sysid: int) -> int:
        """Frames of this vehicle that never came: gaps in its numbers so far."""
        return self._gaps.lost_of.get(sysid, 0)

    def copies(self, sysid: int) -> int:
        """Number of copies of a frame that must arrive soon, over the link to this vehicle."""
        return copies(self.lost_share(sysid)) if sysid in self._gaps.lost_of else 1

    @property
    def copied(self) -> set[int]:
        """System ids of those to whom more than one copy goes."""
        lost_of = self._gaps.lost_of
        return {sysid for sysid in lost_of if self.copies(sysid) > 1} if any(lost_of.values()) else set()

    def lost_share(self, sysid: int) -> float | None:
        """Lost of all frames sent in the last `WINDOW_S` or so, 0..1; None where there were none."""
        counts = self._counts.get(sysid)
        if counts is None:
            return None
        _, received, lost = counts.samples[0]
        got, missed = counts.received - received, max(self.lost(sysid) - lost, 0)
        return missed / (got + missed) if got + missed else None
