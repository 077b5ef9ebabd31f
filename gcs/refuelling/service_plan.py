"""Services planned ahead for a session's vehicles and givers (skytender/service_plan.py)."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from gcs.refuelling.giver import Giver, ServiceTimes
from gcs.scenario.model import RefuellingRules
from gcs.telemetry.state import VehicleView
from skytender.rolling_horizon import Durations, Givers, Planned
from skytender.service_plan import PlannedFleet, planned


def plan_services(
    views: Sequence[VehicleView],
    waiting: Collection[int],
    givers: Sequence[Giver],
    times: ServiceTimes,
    rules: RefuellingRules,
    *,
    need_from: float,
    left_s: float,
) -> Planned:
    """The best plan for at least one vehicle and one giver; `waiting`: system ids of vehicles that want energy now."""
    fleet = PlannedFleet(
        np.array([view.p_now_ned() for view in views]),
        np.array([view.remaining_j for view in views]),
        np.array([view.capacity_j for view in views]),
        np.array([view.power_w for view in views]),
        np.array([view.sysid in waiting for view in views]),
    )
    sources = Givers(
        np.array([giver.p_ned for giver in givers]),
        np.array([giver.free_in_s for giver in givers]),
        np.array([giver.speed_m_s for giver in givers]),
        np.array([giver.available_j for giver in givers]),
        np.array([giver.rate_w for giver in givers]),
        np.array([giver.is_tanker for giver in givers]),
    )
    takes = Durations(times.start_s, times.per_way, times.end_s)
    return planned(
        fleet, sources, takes, need_from=need_from, until=rules.until, lands_at=rules.lands_at, left_s=left_s
    )
