"""How fast virtual leaders of a scenario's vehicles may fly and turn: less than the vehicles can, as far as that is
known [choice]."""

from __future__ import annotations

import math

from gcs.scenario.model import Scenario, VehicleBase
from skytender import elementary

CATCH_UP_SPEED = 1.3
"""A target's leader may be this much faster than its carrot, so that it comes back after an obstacle."""

SLOWEST_M_S = 1.0
"""Even a vehicle that is to stand may give way this fast."""
ABLE_SHARE, USUAL_M_S2, USUAL_TILT_DEG, GRAVITY_M_S2 = 0.8, 5.0, 35.0, 9.8
"""Of what a launched vehicle can by MPC_ACC_HOR and MPC_TILTMAX_AIR: at all of it corners err by half a metre."""
EXTERNAL_M_S2 = 2.0
"""Autopilots that others have tuned follow leaders of no more acceleration."""


def speeds_m_s(scenario: Scenario) -> dict[int, float]:
    """Greatest speed of each vehicle's leader, by system id."""
    vehicles = scenario.vehicles
    speeds = {v.sysid: scenario.planner.cruise_m_s for v in vehicles.pursuers}
    speeds |= {t.sysid: CATCH_UP_SPEED * t.speed_m_s for t in vehicles.targets}
    speeds |= {t.sysid: t.speed_m_s for t in vehicles.tankers}
    return {sysid: max(speed_m_s, SLOWEST_M_S) for sysid, speed_m_s in speeds.items()}


def acceleration_m_s2(scenario: Scenario, vehicle: VehicleBase) -> float:
    """Greatest acceleration of a vehicle's leader."""
    most_m_s2 = scenario.planner.acceleration_m_s2
    if vehicle.is_foreign:
        return min(most_m_s2, EXTERNAL_M_S2)
    able_m_s2 = vehicle.params.get("MPC_ACC_HOR", USUAL_M_S2)
    tilt_m_s2 = GRAVITY_M_S2 * elementary.tan(math.radians(vehicle.params.get("MPC_TILTMAX_AIR", USUAL_TILT_DEG)))
    return min(most_m_s2, ABLE_SHARE * able_m_s2, ABLE_SHARE * tilt_m_s2)
