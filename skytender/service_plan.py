"""Services of a fleet planned ahead, and what each vehicle's being served first gains
(docs/model/competition.md#planned-services) [choice]."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from skytender import elementary
from skytender.rolling_horizon import Durations, Givers, Planned, Receivers, plan

FloatArray = NDArray[np.float64]

MOST_PLANNED = 24
"""Most vehicles that are planned for: the first to land."""
PLANNED_S = 90.0
"""How far ahead."""
MARGIN_S = 3.0
"""Beyond the session's end: estimates of which vehicles last until then are as wrong as that."""
LONGEST_S = 1e6
"""Stands for a time without an end."""
AGAIN_S = 1.0
"""[choice] Bids are planned anew after so long, and whenever other vehicles compete or other givers are free."""
GAIN = 0.25
"""[choice] Gain of a vehicle whose bid is 0.73 of the way from the least to the greatest."""
_MOST_GAINS = 100.0


class PlannedFleet(NamedTuple):
    """Vehicles that can be served, in any order."""

    p_ned: FloatArray
    """(n, 3), common NED frame, m"""
    remaining_j: FloatArray
    """(n,) in their batteries"""
    capacity_j: FloatArray
    """(n,)"""
    power_w: FloatArray
    """(n,) draw"""
    waits: NDArray[np.bool_]
    """(n,) whether each wants energy already"""

    def lasts_s(self, lands_at: float) -> FloatArray:
        """(n,) time until each lands by itself at a share of its battery, at most LONGEST_S."""
        above_j = np.maximum(self.remaining_j - lands_at * self.capacity_j, 0.0)
        power_w = np.where(self.power_w > 0.0, self.power_w, 1.0)
        return np.where(self.power_w > 0.0, np.minimum(above_j / power_w, LONGEST_S), LONGEST_S)


def planned(
    fleet: PlannedFleet,
    givers: Givers,
    takes: Durations,
    *,
    need_from: float,
    until: float,
    lands_at: float,
    left_s: float,
) -> Planned:
    """The best plan for at least one vehicle and one giver until the session ends, `left_s` from now. A vehicle wants
    energy once `need_from` of its battery is gone, and is served `until` a share of it; both 0 to 1."""
    lands_s = fleet.lasts_s(lands_at)
    rows = np.sort(np.argsort(lands_s, kind="stable")[:MOST_PLANNED])
    capacity_j = fleet.capacity_j[rows]
    wants_j = (1.0 - need_from - lands_at) * capacity_j
    above_j = fleet.remaining_j[rows] - lands_at * capacity_j
    receivers = Receivers(
        fleet.p_ned[rows],
        lands_s[rows],
        np.maximum(fleet.power_w[rows], 1e-3),
        (until - lands_at) * capacity_j,
        np.where(fleet.waits[rows], np.maximum(wants_j, above_j), wants_j),
    )
    best = plan(receivers, givers, takes, horizon_s=min(left_s + MARGIN_S, PLANNED_S))
    served_cost, passed_over_cost = np.full(len(lands_s), np.inf), np.full(len(lands_s), best.cost)
    served_cost[rows], passed_over_cost[rows] = best.served_cost, best.passed_over_cost
    first = np.where(best.first >= 0, rows[best.first], -1)
    return Planned(first, best.starts_s, best.cost, served_cost, passed_over_cost)


def gain_of(served_cost: float, passed_over_cost: float) -> float:
    """How much less the best plan costs that serves a vehicle first than the best that does not; -inf for one that no
    plan serves first."""
    return -math.inf if served_cost == math.inf else passed_over_cost - served_cost


def below_greatest(gain: float) -> float:
    """Distance of a bid from the greatest possible bid, as a share of the scale: 0 for the greatest, 1 for the least.

    gain: cost that serving the vehicle first would avoid (docs/model/competition.md#likely-losses).
    """
    return 1.0 / (1.0 + elementary.exp(min(max(gain / GAIN, -_MOST_GAINS), _MOST_GAINS)))
