"""Frames lost on a link: the gaps in the sequence numbers of each (system, component).

One rule, `after`, counts frame by frame while a session flies (`GapCounter`) and over a recording (`RecordedGaps`).
A frame that comes late fills its gap and is no loss; one that comes twice changes nothing.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import cython
import numpy as np
from cython.cimports.gcs.mavlink.frame_runs import HALF, NUMBERS, run_at
from numpy.typing import NDArray

from gcs.mavlink.codec import Frame
from gcs.mavlink.datagram import AnswerRuns, FrameRun

IntArray = NDArray[np.int64]
SENDERS = 1 << 16
"""Components of all systems, by number: a system's is the high byte."""
MOST_SENDERS = 2048
"""Components of all systems whose numbers are watched; more than eight of each of 254 vehicles are none."""


def after(missing: Any, newest: int, number: int) -> tuple[int, int]:
    """(newest number, change of the frames lost) after a frame of this number; `newest` -1 before the first.

    missing: 256 flags of one sender, by number, changed in place. A number half a turn old can no longer be
    distinguished from a new one, and is missing no more.
    """
    ahead = (number - newest) & 0xFF
    if newest < 0:
        return number, 0
    if ahead == 1:  # as nearly every frame
        missing[number ^ HALF] = 0
        return number, 0
    if 0 < ahead < HALF:
        for step in range(ahead):
            missing[(number - HALF - step) & 0xFF] = 0
        for step in range(1, ahead):
            missing[(newest + step) & 0xFF] = 1
        return number, ahead - 1
    if missing[number]:
        missing[number] = 0
        return newest, -1
    return newest, 0


_NONE = bytes(NUMBERS)


class GapCounter:
    """Frames lost so far, counted as they come."""

    def __init__(self) -> None:
        self.lost_of: dict[int, int] = {}
        """by system id; one that has lost nothing may not be in it"""
        self._newest, self._missing = np.full(SENDERS, -1, dtype=np.int16), np.zeros((SENDERS, NUMBERS), dtype=np.uint8)
        self._newest_of = self._newest.data
        self._missing_of: dict[int, memoryview] = {}

    @property
    def lost(self) -> int:
        """Of all systems."""
        return sum(self.lost_of.values())

    def feed_all(self, frames: Iterable[Frame]) -> None:
        """Count frames that were received, in their order."""
        newest, missing = self._newest_of, self._missing_of
        if isinstance(frames, FrameRun) and frames.in_step:
            sysid, compid = frames.sender
            sender, count, first = sysid << 8 | compid, len(frames), frames.first
            begin, before = first ^ HALF, newest[sender]
            if before >= 0 and (first - before) % NUMBERS == 1 and begin + count <= NUMBERS:  # as below, at once
                missing[sender][begin : begin + count] = _NONE[:count]
                newest[sender] = (first + count - 1) % NUMBERS
                return
        for sysid, compid, seq, _, _ in frames:
            sender = sysid << 8 | compid
            before = newest[sender]
            if before >= 0 and (seq - before) % NUMBERS == 1:  # as nearly every frame; see `after`
                missing[sender][seq ^ HALF] = 0
                newest[sender] = seq
            else:
                self.feed(sysid, compid, seq)

    def feed_runs(self, runs: AnswerRuns) -> None:
        """As `feed_all` with each of them, whose frames are in step."""
        at = 0
        while (at := _go_on(runs.rows, at, self._newest, self._missing)) < len(runs):
            self.feed_all(runs[at])
            at += 1

    def feed(self, sysid: int, compid: int, seq: int) -> None:
        """Count a frame that was received."""
        sender = sysid << 8 | compid
        flags = self._missing_of.get(sender)
        if flags is None:
            if len(self._missing_of) < MOST_SENDERS:
                self._watch(sender, seq)
            return
        missing = cython.declare(cython.uchar[::1], flags)
        self._newest_of[sender], lost = after(cython.address(missing[0]), self._newest_of[sender], seq)
        if lost:
            self.lost_of[sysid] = self.lost_of.get(sysid, 0) + lost

    def _watch(self, sender: int, newest: int) -> None:
        self._newest_of[sender] = newest
        self._missing_of[sender] = self._missing[sender].data

    def forget(self, sysid: int) -> None:
        """A vehicle's frames are numbered anew from the next one on; what it has lost so far stays."""
        for sender in [sender for sender in self._missing_of if sender >> 8 == sysid]:
            del self._missing_of[sender]
            self._newest[sender], self._missing[sender] = -1, 0


class RecordedGaps:
    """The same over a recording, many frames at once."""

    def __init__(self) -> None:
        self._newest = np.full(SENDERS, -1, dtype=np.int64)
        self._missing = np.zeros((SENDERS, NUMBERS), dtype=np.uint8)
        self._lost = np.zeros(NUMBERS, dtype=np.int64)

    def count(self, sysids: IntArray, compids: IntArray, numbers: IntArray) -> tuple[IntArray, NDArray[np.bool_]]:
        """Go on with these frames (n,): the change of the frames lost with each, and which did not come before."""
        lost, new = np.empty(len(numbers), dtype=np.int64), np.empty(len(numbers), dtype=np.bool_)
        senders, numbers = np.ascontiguousarray(sysids << 8 | compids), np.ascontiguousarray(numbers)
        _count(senders, numbers, self._newest, self._missing, lost, new.view(np.uint8))
        np.add.at(self._lost, sysids, lost)
        return lost, new

    def packed(self) -> tuple[IntArray, IntArray, IntArray, NDArray[np.uint8]]:
        """State of the counter, in little room: for `resumed`."""
        senders = np.flatnonzero(self._newest >= 0)
        return self._lost.copy(), senders, self._newest[senders], np.packbits(self._missing[senders], axis=1)


def resumed(lost: IntArray, senders: IntArray, newest: IntArray, missing: NDArray[np.uint8]) -> GapCounter:
    """A counter that goes on from where a recording had been counted, as `RecordedGaps.packed` gave it."""
    counter = GapCounter()
    counter.lost_of = {int(sysid): int(lost[sysid]) for sysid in np.flatnonzero(lost)}
    for sender, number, flags in zip(senders.tolist(), newest.tolist(), np.unpackbits(missing, axis=1), strict=True):
        counter._watch(sender, number)
        counter._missing[sender] = flags
    return counter


def _count(
    senders: IntArray,
    numbers: IntArray,
    newest: IntArray,
    missing: NDArray[np.uint8],
    lost: IntArray,
    new: NDArray[np.uint8],
) -> None:
    """Fill lost (n,) and new (n,); newest (senders,) and missing (senders, 256) go on from call to call."""
    for i in range(numbers.shape[0]):
        sender = senders[i]
        before = newest[sender]
        newest[sender], lost[i] = after(cython.address(missing[sender, 0]), before, numbers[i])
        new[i] = newest[sender] != before or lost[i] < 0


def _go_on(rows: IntArray, first: int, newest: NDArray[np.int16], missing: NDArray[np.uint8]) -> Any:
    """Count the runs (n, COLUMNS of gcs/mavlink/frame_runs.py) from the first on, up to one that does not go on with
    the next number of its sender's; where that is."""
    for k in range(first, rows.shape[0]):
        run = run_at(rows, k)
        sender = run.sysid << 8 | run.compid
        before = newest[sender]
        if before < 0 or (run.seq - before) & 0xFF != 1:
            return k
        for step in range(run.last - run.first):
            number = (run.seq + step) & 0xFF
            missing[sender, number ^ HALF] = 0
            newest[sender] = number
    return rows.shape[0]
