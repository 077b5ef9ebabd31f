"""Where vehicles were by the truth that they wrote, at common times, and how near two of them came."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from sessions import Outcome, Truth


def at_grants(outcome: Outcome, sysids: Sequence[int]) -> np.ndarray:
    """(vehicles, times, 3), NED in m, at the ends of grants that all of them flew."""
    truths = [outcome.truth(sysid) for sysid in sysids]
    times = set.intersection(*(set(np.round(truth.time_s, 3)) for truth in truths))
    return np.array([truth.p_ned[np.isin(np.round(truth.time_s, 3), list(times))] for truth in truths])


def between(read: Sequence[tuple[np.ndarray, np.ndarray]]) -> tuple[np.ndarray, np.ndarray]:
    """Common times, each 0.02 s, and places then (vehicles, times, 3), of each vehicle's times and places (n, 3)."""
    times = np.arange(max(t[0] for t, _ in read), min(t[-1] for t, _ in read), 0.02)
    ways = [[np.interp(times, t, p[:, axis]) for axis in range(3)] for t, p in read]
    return times, np.array(ways).transpose(0, 2, 1)


def of_truths(truths: Sequence[Truth]) -> tuple[np.ndarray, np.ndarray]:
    """Likewise of truths of vehicles that share a clock."""
    return between([(truth.time_s, truth.p_ned) for truth in truths])


def nearest_m(ways: np.ndarray) -> float:
    """Least distance of any two of (vehicles, times, 3)."""
    pairs = itertools.combinations(range(len(ways)), 2)
    return min(float(np.linalg.norm(ways[a] - ways[b], axis=1).min()) for a, b in pairs)
