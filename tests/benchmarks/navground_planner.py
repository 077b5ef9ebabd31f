"""Yardstick for dense fleets: A* way points and a behaviour of navground as a planner of a user's own.

    planner: {method: "navground_planner:AStarNavground", safety: false}

As `orca_planner` in all else. navground (PyPI) is two-dimensional: each vehicle's behaviour is given the vehicles that
are no farther above or below than the separation, and changes the horizontal part of the wish. The behaviour is HL, the
human-like one of Guzzi, Giusti, Gambardella, Theraulaz and Di Caro (Human-friendly robot navigation in dynamic
environments, ICRA 2013), navground's own; its ORCA is the library that `orca_planner` uses.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from navground.core import Behavior, Neighbor, Target, kinematics
from orca_planner import HORIZON_S, MARGIN_M, NEIGHBOUR_M, AStarOrca, FloatArray

from gcs.planner.request import Situation
from gcs.scenario.model import Scenario

_BEHAVIOUR = "HL"


class AStarNavground(AStarOrca):
    """Leaders of all pursuers, moved together once a tick, each by a behaviour of its own."""

    def __init__(self, scenario: Scenario) -> None:
        super().__init__(scenario)
        self._behaviours: dict[int, Behavior] = {}
        self._radius_m = (scenario.planner.separation_m + MARGIN_M) / 2

    def _behaviour(self, sysid: int, speed: float) -> Behavior:
        if sysid not in self._behaviours:
            behaviour = Behavior.make_type(_BEHAVIOUR)
            behaviour.kinematics = kinematics.OmnidirectionalKinematics(speed)
            behaviour.radius, behaviour.horizon = self._radius_m, max(speed * HORIZON_S, 2.0)
            behaviour.max_speed = speed
            self._behaviours[sysid] = behaviour
        return self._behaviours[sysid]

    def _reciprocal(
        self, situation: Situation, led: Sequence[int], p: FloatArray, v: FloatArray, wish: FloatArray, speed: float
    ) -> FloatArray:
        places, velocities = self._everything(situation, led, p, v)
        chosen = wish.copy()
        for i, sysid in enumerate(led):
            behaviour = self._behaviour(sysid, speed)
            away = places - p[i]
            beside = (np.abs(away[:, 2]) < 2.0 * self._radius_m) & (np.linalg.norm(away[:, :2], axis=1) < NEIGHBOUR_M)
            beside[i] = False
            behaviour.position, behaviour.velocity = p[i, :2], v[i, :2]
            level_m_s = float(np.linalg.norm(wish[i, :2]))
            behaviour.optimal_speed = level_m_s
            behaviour.target = Target.Velocity(wish[i, :2])
            behaviour.environment_state.neighbors = [
                Neighbor(places[k, :2], self._radius_m, velocities[k, :2], int(k)) for k in np.flatnonzero(beside)
            ]
            if level_m_s > 1e-3:
                chosen[i, :2] = behaviour.compute_cmd(situation.period_s).velocity
        return chosen
