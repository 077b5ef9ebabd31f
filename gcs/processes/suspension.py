"""Notices that this process did not run for a while: it was stopped, or the machine slept.

One that only waits for a processor, as on a busy machine, is not suspended: the kernel counts that time apart.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

LEAST_S = 3.0
"""A gap is a suspension from so long on. A running process looks many times as often."""
IDLE_SHARE = 0.5
"""A process that computed, or waited for a processor, for more of the gap than this was not suspended."""
SCHEDSTAT = Path("/proc/self/schedstat")
"""Of the main thread: nanoseconds on a processor, nanoseconds on a queue for one, number of time slices (Linux,
Documentation/scheduler/sched-stats)."""


def machine_s() -> float:
    """Wall time that goes on while the machine sleeps."""
    return time.clock_gettime(time.CLOCK_BOOTTIME)


def queued_s(schedstat: Path = SCHEDSTAT) -> float:
    """Time for which a process waited for a processor; 0 where the kernel does not tell it."""
    try:
        return 1e-9 * float(schedstat.read_text(encoding="ascii").split()[1])
    except (OSError, ValueError, IndexError):
        return 0.0


def busy_s() -> float:
    """Time for which this process computed, or waited for a processor."""
    return time.process_time() + queued_s()


class SuspensionWatch:
    """`look` is called often; what lies between two looks for too long is a suspension."""

    def __init__(self, wall_s: Callable[[], float] = machine_s, used_s: Callable[[], float] = busy_s) -> None:
        self._wall_s, self._used_s = wall_s, used_s
        self._looked_s, self._used_then_s = wall_s(), used_s()

    def look(self) -> float:
        """For how long this process did not run since the last look; 0 where that was not long."""
        now_s = self._wall_s()
        gap_s, self._looked_s = now_s - self._looked_s, now_s
        used_s = self._used_s()
        computed_s, self._used_then_s = used_s - self._used_then_s, used_s
        return gap_s if gap_s >= LEAST_S and computed_s < IDLE_SHARE * gap_s else 0.0
