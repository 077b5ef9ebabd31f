"""Notices that this process did not run for a while: it was stopped, or the machine slept."""

from __future__ import annotations

import time
from collections.abc import Callable

LEAST_S = 3.0
"""A gap is a suspension from so long on. Whoever runs looks many times as often."""
IDLE_SHARE = 0.5
"""A process that computed for more of the gap than this was not suspended."""


def machine_s() -> float:
    """Wall time that goes on while the machine sleeps."""
    return time.clock_gettime(time.CLOCK_BOOTTIME)


class SuspensionWatch:
    """`look` is called often; what lies between two looks for too long is a suspension."""

    def __init__(
        self, wall_s: Callable[[], float] = machine_s, used_s: Callable[[], float] = time.process_time
    ) -> None:
        self._wall_s, self._used_s = wall_s, used_s
        self._looked_s, self._used_then_s = wall_s(), used_s()

    def look(self) -> float:
        """For how long this process did not run since the last look; 0 where that was not long."""
        now_s, used_s = self._wall_s(), self._used_s()
        gap_s, computed_s = now_s - self._looked_s, used_s - self._used_then_s
        self._looked_s, self._used_then_s = now_s, used_s
        return gap_s if gap_s >= LEAST_S and computed_s < IDLE_SHARE * gap_s else 0.0
