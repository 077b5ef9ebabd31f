"""Bytes of a file that have come, in any order: as large in memory as what came is broken up, whatever was claimed."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator

MOST_RANGES = 4096
"""A piece that would begin another range is not taken: it is still missing, and asked for again."""


class ReceivedRanges:
    """Disjoint ranges of bytes, in their order."""

    def __init__(self) -> None:
        self._starts: list[int] = []
        self._ends: list[int] = []
        self.size_bytes = 0
        """of all of them"""

    def __iter__(self) -> Iterator[tuple[int, int]]:
        """The first byte of each range, and the first one behind it."""
        return zip(self._starts, self._ends, strict=True)

    def add(self, start: int, end: int) -> int:
        """Add bytes from `start` on; where what is new of them ends, which is `start` where nothing is."""
        at = bisect_right(self._starts, start)
        if at and self._ends[at - 1] > start:
            return start
        if at < len(self._starts):
            end = min(end, self._starts[at])
        after = at > 0 and self._ends[at - 1] == start
        before = at < len(self._starts) and self._starts[at] == end
        if end <= start or (not after and not before and len(self._starts) >= MOST_RANGES):
            return start
        if after and before:
            self._ends[at - 1] = self._ends.pop(at)
            del self._starts[at]
        elif after:
            self._ends[at - 1] = end
        elif before:
            self._starts[at] = start
        else:
            self._starts.insert(at, start)
            self._ends.insert(at, end)
        self.size_bytes += end - start
        return end

    @property
    def first_missing(self) -> int:
        """The first byte that has not come."""
        return self._ends[0] if self._starts and self._starts[0] == 0 else 0

    def missing(self, end: int, near_bytes: int = 0) -> tuple[int, int]:
        """The first range that has not come, before `end`; it takes in what came where that is no longer than
        `near_bytes`."""
        first = self.first_missing
        for start, stop in self:
            if start > first and stop - start > near_bytes:
                return first, min(start, end)
        return first, end
