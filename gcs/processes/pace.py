"""The session's pace: lockstep runs as fast as the vehicles answer, real time at speed X waits for the wall clock."""

from __future__ import annotations

import math
from collections.abc import Callable

MOST_PERIODS = 10
"""Periods of one grant: vehicles on the session's clock take one that is much longer for a silence."""


class Pace:
    """When the next grant is due on the wall, and how far the session has fallen behind.

    A tick that comes late by more than a period moves all later ones: the session slows down for everyone, and never
    hurries to catch up. By less it moves none: sleeps that end a millisecond late would slow the session.
    Not so where some vehicles live on the real clock (`keeps_up`): then a late tick grants the periods that have gone
    by at once, up to MOST_PERIODS, the next ones follow without waiting, and the session's time stays the wall's.
    """

    def __init__(self, speed: float | None, wall_s: Callable[[], float], *, keeps_up: bool = False) -> None:
        """`speed` None is lockstep; `wall_s` reads a monotonic clock."""
        self._keeps_up = keeps_up
        self._speed = speed
        self._wall_s = wall_s
        self._start_wall_s = wall_s()
        self._due_wall_s = self._start_wall_s
        self._paused_s = 0.0
        self._paused_since_s: float | None = None
        self.lag_s = 0.0

    def start(self) -> None:
        """Let the first tick be due now."""
        self._start_wall_s = self._due_wall_s = self._wall_s()

    def next(self, period_s: float) -> int:
        """Schedule the tick after this one, which takes place now; how many periods this one is to grant."""
        if self._speed is None:
            return 1
        late_s = self._wall_s() - self._due_wall_s
        if self._keeps_up:
            missed = min(max(math.floor(late_s * self._speed / period_s), 0), MOST_PERIODS - 1)
            self.lag_s += missed * period_s / self._speed
            self._due_wall_s += (1 + missed) * period_s / self._speed
            return 1 + missed
        if late_s > period_s / self._speed:
            self.lag_s += late_s
            self._due_wall_s += late_s
        self._due_wall_s += period_s / self._speed
        return 1

    def wait_s(self) -> float:
        """Wall time until the next tick is due; 0 in lockstep."""
        return 0.0 if self._speed is None else max(self._due_wall_s - self._wall_s(), 0.0)

    def pause(self) -> None:
        """Stop the pace; a second call changes nothing."""
        if self._paused_since_s is None:
            self._paused_since_s = self._wall_s()

    def resume(self) -> None:
        """Go on where the pace was stopped."""
        if self._paused_since_s is not None:
            away_s = self._wall_s() - self._paused_since_s
            self._paused_s += away_s
            self._due_wall_s += away_s
            self._paused_since_s = None

    @property
    def paused(self) -> bool:
        """Whether the session stands still."""
        return self._paused_since_s is not None

    @property
    def running_s(self) -> float:
        """Session time by the wall clock; in lockstep, where there is none, that wall time itself."""
        return self.running_wall_s * (1.0 if self._speed is None else self._speed)

    @property
    def running_wall_s(self) -> float:
        """Wall time since the start, pauses left out."""
        until_s = self._wall_s() if self._paused_since_s is None else self._paused_since_s
        return until_s - self._start_wall_s - self._paused_s
