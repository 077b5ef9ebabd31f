"""Tracking error and lag of each vehicle, measured against the way of its virtual leader [choice].

A vehicle flies a lag behind its leader. Both are measured in every tick: the error is the distance of the vehicle from
the leader's way of the last HISTORY_S, the lag the age of the nearest place on it, while the leader moves.
"""

from __future__ import annotations

from collections import deque

import numpy as np
from numpy.typing import NDArray

from gcs.telemetry.state import Vec3

HISTORY_S = 2.5
MOVING_M_S = 0.5
"""Only a leader that moves faster shows a lag."""
DECAY_S = 20.0
"""An error that is not measured again counts by 1/e less after so long."""
LAG_SHARE = 0.1
"""Of a newly measured lag in the one that is kept."""


class Tracking:
    """Error and lag of one vehicle."""

    def __init__(self, lag_s: float) -> None:
        self.error_m = 0.0
        """greatest error of late"""
        self.now_m = 0.0
        """error in the last tick"""
        self.lag_s = lag_s
        self._way: deque[tuple[float, Vec3]] = deque()

    def lead(self, time_s: float, p_ned: Vec3) -> None:
        """Append a place of the leader (NED, m) at a session time."""
        self._way.append((time_s, p_ned))
        while self._way[-1][0] - self._way[0][0] > HISTORY_S:
            self._way.popleft()

    def measure(self, time_s: float, p_ned: Vec3, period_s: float) -> None:
        """Hold the vehicle's place (NED, m) at a session time against the leader's way."""
        if len(self._way) < 2:
            return
        times = np.array([t for t, _ in self._way])
        way = np.array([p for _, p in self._way])
        distance_m, at_s = nearest(times, way, np.array(p_ned))
        self.now_m = distance_m
        self.error_m = max(distance_m, self.error_m * float(np.exp(-period_s / DECAY_S)))
        moved_m = float(np.linalg.norm(way[-1] - way[0]))
        if moved_m > MOVING_M_S * (times[-1] - times[0]):
            self.lag_s += LAG_SHARE * (min(max(time_s - at_s, 0.0), HISTORY_S) - self.lag_s)

    def restart(self) -> None:
        """Forget the way: the leader begins anew."""
        self._way.clear()


def nearest(times_s: NDArray[np.float64], way: NDArray[np.float64], p: NDArray[np.float64]) -> tuple[float, float]:
    """Distance (m) of a point p (3,) from a way of points (k, 3), k >= 2, and the time (s) of its nearest place."""
    start, along = way[:-1], np.diff(way, axis=0)
    square = np.maximum((along**2).sum(axis=1), 1e-12)
    share = np.clip(((p - start) * along).sum(axis=1) / square, 0.0, 1.0)
    apart = np.linalg.norm(start + share[:, None] * along - p, axis=1)
    k = int(len(apart) - 1 - np.argmin(apart[::-1]))
    return float(apart[k]), float(times_s[k] + share[k] * (times_s[k + 1] - times_s[k]))
