"""Frame loss per vehicle from sequence-number gaps: total so far, and share over the last 10 s."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from gcs.link.link import Key
from gcs.mavlink.datagram import AnswerRuns
from gcs.mavlink.frame_runs import FIRST, LAST
from gcs.mavlink.gaps import GapCounter
from skytender import elementary

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
    return min(math.ceil(elementary.log(LEFT_SHARE) / elementary.log(min(lost_share, 0.5))), MOST_COPIES)


@dataclass
class _Counts:
    """One vehicle's counts, and what they were at earlier times: (s, received, lost)."""

    received: int = 0
    samples: deque[tuple[float, int, int]] = field(default_factory=lambda: deque([(0.0, 0, 0)]))


@dataclass
class _Together:
    """Frames of vehicles that are received together tick by tick, until they are counted for each."""

    keys: Sequence[Key] = ()
    runs: list[AnswerRuns] = field(default_factory=list)
    """of each tick, for all vehicles"""
    due_s: float = math.inf
    """when the first of them has gone without a sample for long enough, or a little before"""

    def pop(self) -> Iterator[tuple[int, int]]:
        """Each system id and its number of frames; nothing if there are none."""
        if self.runs:
            rows = np.array([runs.rows for runs in self.runs])
            frames: list[int] = (rows[:, :, LAST] - rows[:, :, FIRST]).sum(axis=0).tolist()
            self.runs.clear()
            for (sysid, _), received in zip(self.keys, frames, strict=True):
                yield sysid, received


class LinkQuality:
    """Counts frames by system id; `gaps` must be fed every frame, this only their number."""

    def __init__(self, gaps: GapCounter) -> None:
        self._gaps = gaps
        self._counts: dict[int, _Counts] = {}
        self._together = _Together()

    def count_all(self, keys: Sequence[Key], runs: AnswerRuns, now_s: float) -> None:
        """As `count` for each of some vehicles, with its run of frames."""
        together = self._together
        if together.keys is not keys and together.keys != keys:
            self._settle()
            together = self._together = _Together(keys, due_s=min(map(self._due_s, keys), default=math.inf))
        together.runs.append(runs)
        if now_s >= together.due_s:
            for sysid, received in together.pop():
                self._count(sysid, received, now_s)
            together.due_s = min(map(self._due_s, keys))

    def _due_s(self, key: Key) -> float:
        counts = self._counts.get(key[0])
        return -math.inf if counts is None else counts.samples[-1][0] + SAMPLE_EVERY_S - 2.0 * _ROUNDING_S

    def _settle(self) -> None:
        """Count for each vehicle what has been counted for all together."""
        for sysid, received in self._together.pop():
            self._counts[sysid].received += received

    def count(self, sysid: int, frames: int, now_s: float) -> None:
        """Count frames of a vehicle that were delivered at `now_s`."""
        self._settle()
        self._count(sysid, frames, now_s)

    def _count(self, sysid: int, frames: int, now_s: float) -> None:
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
        self._together = _Together()
        self._counts = {sysid: _Counts(samples=deque([(now_s, 0, lost)])) for sysid, lost in self._gaps.lost_of.items()}

    def lost(self, sysid: int) -> int:
        """Frames of this vehicle that never came: gaps in its numbers so far."""
        return self._gaps.lost_of.get(sysid, 0)

    def copies(self, sysid: int) -> int:
        """Number of copies of a frame that must arrive soon, over the link to this vehicle."""
        return copies(self.lost_share(sysid)) if sysid in self._gaps.lost_of else 1

    @property
    def copied(self) -> set[int]:
        """System ids of vehicles that are sent more than one copy."""
        lost_of = self._gaps.lost_of
        return {sysid for sysid in lost_of if self.copies(sysid) > 1} if any(lost_of.values()) else set()

    def lost_share(self, sysid: int) -> float | None:
        """Lost of all frames sent in the last `WINDOW_S` or so, 0..1; None where there were none."""
        self._settle()
        counts = self._counts.get(sysid)
        if counts is None:
            return None
        _, received, lost = counts.samples[0]
        got, missed = counts.received - received, max(self.lost(sysid) - lost, 0)
        return missed / (got + missed) if got + missed else None
