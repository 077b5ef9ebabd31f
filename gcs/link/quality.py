"""Frame loss per vehicle from sequence-number gaps: total so far, and share over the last 10 s.

What the simulated radio never loses must not be counted: the share would be too low.
"""

from __future__ import annotations

import math
from collections import deque

import numpy as np

from gcs.mavlink import frame_runs
from gcs.mavlink.datagram import AnswerRuns
from gcs.mavlink.frame_runs import NUMBERS, SYSID
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


class LinkQuality:
    """Counts frames by system id; `gaps` must be fed every frame, this only their number."""

    def __init__(self, gaps: GapCounter) -> None:
        self._gaps = gaps
        self._received = np.zeros(NUMBERS, np.int64)
        """frames so far, by system id; so is when there was the last sample, s"""
        self._sampled_s = np.full(NUMBERS, -np.inf)
        self._due_s = -np.inf
        """when those that come together need their next sample"""
        self._samples: dict[int, deque[tuple[float, int, int]]] = {}
        """(s, received, lost) at times of the last `WINDOW_S`, oldest first"""

    def count_runs(self, runs: AnswerRuns, now_s: float) -> None:
        """Count the frames of vehicles that were delivered at `now_s`."""
        frame_runs.add_frames(runs.rows, self._received)
        if now_s >= self._due_s and len(runs):
            sysids = runs.rows[:, SYSID]
            for sysid in sysids[now_s - self._sampled_s[sysids] >= SAMPLE_EVERY_S - _ROUNDING_S].tolist():
                self._sample(sysid, now_s)
            self._due_s = float(self._sampled_s[sysids].min()) + SAMPLE_EVERY_S - _ROUNDING_S

    def count(self, sysid: int, frames: int, now_s: float) -> None:
        """Count frames of a vehicle that were delivered at `now_s`."""
        self._received[sysid] += frames
        if now_s - self._sampled_s[sysid] >= SAMPLE_EVERY_S - _ROUNDING_S:
            self._sample(sysid, now_s)

    def _sample(self, sysid: int, now_s: float) -> None:
        samples = self._samples.get(sysid)
        if samples is None:
            samples = self._samples[sysid] = deque([(0.0, 0, 0)])
        if now_s - samples[-1][0] >= SAMPLE_EVERY_S - _ROUNDING_S:
            samples.append((now_s, int(self._received[sysid]), self.lost(sysid)))
            while now_s - samples[1][0] >= WINDOW_S - _ROUNDING_S:
                samples.popleft()
        self._sampled_s[sysid] = samples[-1][0]

    def begin(self, now_s: float) -> None:
        """Count lost frames from `now_s` on."""
        self._samples = {sysid: deque([(now_s, 0, lost)]) for sysid, lost in self._gaps.lost_of.items()}
        self._received[:], self._sampled_s[:], self._due_s = 0, -np.inf, -np.inf
        self._sampled_s[list(self._samples)] = now_s

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
        if sysid not in self._samples:
            return None
        _, received, lost = self._samples[sysid][0]
        got, missed = int(self._received[sysid]) - received, max(self.lost(sysid) - lost, 0)
        return missed / (got + missed) if got + missed else None
