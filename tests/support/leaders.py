"""Scenes for the safety filter: leaders that fly to their goals through it, and how near they come to each other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from skytender.safety.safety_filter import FilterSettings, Leaders, filter_step

Floats = NDArray[np.float64]
PERIOD_S = 0.1
ARRIVED_M = 0.15
ACCELERATION_M_S2 = 4.0
MARGIN_M = 0.1


@dataclass
class Scene:
    """Starts and goals (n, 3), NED, m, and the leaders' speed."""

    name: str
    start: Floats
    goal: Floats
    speed_m_s: float


@dataclass
class Outcome:
    """What came of a scene."""

    least_m: float
    time_s: float
    stuck: int


def circle(n: int, speed_m_s: float) -> Scene:
    """n leaders that change places across a circle."""
    radius_m = max(5.0, 1.3 * n * 0.8 / (2 * np.pi))
    angle = np.arange(n) * 2 * np.pi / n
    start = np.stack([radius_m * np.cos(angle), radius_m * np.sin(angle), np.full(n, -5.0)], 1)
    return Scene(f"circle {n}", start, start * (-1, -1, 1), speed_m_s)


def rows(n: int, speed_m_s: float) -> Scene:
    """Two rows of n, 1 m apart, head on."""
    left = np.stack([np.full(n, -6.0), np.arange(n) * 1.0, np.full(n, -5.0)], 1)
    right = left * (-1, 1, 1)
    return Scene(f"rows {n}+{n}", np.vstack([left, right]), np.vstack([right, left]), speed_m_s)


def fly(scene: Scene, rules: FilterSettings, limit_s: float = 60.0) -> Outcome:
    """All leaders to their goals; distances every 20 ms of the exact ways."""
    n = len(scene.start)
    p, v = scene.start.copy(), np.zeros_like(scene.start)
    outcome = Outcome(np.inf, limit_s, n)
    for k in range(int(limit_s / PERIOD_S)):
        out = filter_step(
            Leaders(
                np.arange(n) + 1, p, v, scene.speed_m_s, ACCELERATION_M_S2, MARGIN_M, high_ned=(np.inf, np.inf, -0.3)
            ),
            _wish(scene, p),
            rules=rules,
        )
        for s in (0.02, 0.04, 0.06, 0.08, 0.1):
            at = p + s * v + 0.5 * s * s * out.u_ned
            apart = np.linalg.norm(at[:, None] - at[None], axis=2) + 1e9 * np.eye(n)
            outcome.least_m = min(outcome.least_m, float(apart.min()))
        p, v = out.p_next_ned, out.v_next_ned
        outcome.stuck = int((np.linalg.norm(scene.goal - p, axis=1) > ARRIVED_M).sum())
        if not outcome.stuck:
            outcome.time_s = (k + 1) * PERIOD_S
            break
    return outcome


def _wish(scene: Scene, p: Floats) -> Floats:
    """Towards the goal, with a brake that a leader can fly."""
    a = 0.5 * ACCELERATION_M_S2
    way = scene.goal - p
    d = np.linalg.norm(way, axis=1, keepdims=True)
    size = np.minimum(scene.speed_m_s, np.where(d < a / 4, 2 * d, np.sqrt(2 * a * np.maximum(d - a / 8, 0.0))))
    return way / np.maximum(d, 1e-9) * size
