"""A planner of one's own: each pursuer keeps its place on a ring around its target and looks at nothing else."""

import math

import numpy as np

from gcs import Scenario, Situation, VehicleView


class Ring:
    def __init__(self, scenario: Scenario) -> None:
        self.radius_m = scenario.formation.ring_m or 2.0
        self.speed_m_s = scenario.planner.cruise_m_s
        self.planned: dict[int, np.ndarray] = {}

    def plan(self, vehicle: VehicleView, situation: Situation) -> tuple[np.ndarray, np.ndarray]:
        here = self.planned.setdefault(vehicle.sysid, np.array(vehicle.p_now_ned()))
        target = situation.target(vehicle)
        if target is None:
            return here, np.zeros(3)
        angle = 2.0 * math.pi * sorted(situation.pursuing).index(vehicle.sysid) / len(situation.pursuing)
        place = target.p_now_ned() + self.radius_m * np.array([math.cos(angle), math.sin(angle), 0.0])
        v_ned = target.v_ned + (place - here)
        v_ned *= min(1.0, self.speed_m_s / max(float(np.linalg.norm(v_ned)), 1e-9))
        self.planned[vehicle.sysid] = here + v_ned * situation.period_s
        return here, v_ned
