"""What gives no way to the vehicles that the safety filter moves: aircraft, vehicles that others fly, silent ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from skytender.safety.safety_filter import Others

DRIFT_M_S2 = 1.0
"""Acceleration of whatever moves otherwise than it reported: its place is unknown by half of this times its age
squared."""
MOST_DRIFT_M = 1.5
MOST_GROWTH_M_S = 1.0
SQUEEZED_M = 0.2
"""[choice] Kept beside, since a vehicle that others stand in the way of leaves what turns a little late."""


@dataclass(frozen=True, slots=True)
class Intruder:
    """One that gives no way; `owner`: a vehicle that is led but silent, and need not keep away from itself."""

    name: str
    owner: int | None
    p_ned: NDArray[np.float64]
    v_ned: NDArray[np.float64]
    radius_m: float
    growth_m_s: float
    agile_m_s: float = 0.0

    @classmethod
    def of(
        cls,
        name: str,
        owner: int | None,
        p_ned: ArrayLike,
        v_ned: ArrayLike,
        lead_s: float,
        radius_m: float,
        age_s: float,
        agile_m_s: float = 0.0,
        *,
        unheard_s: float | None = None,
    ) -> Intruder:
        """Carried forward by `lead_s`, and the less certain the older the report of it is.

        agile_m_s: -w if it may turn at the speed w and others can outrun it, else 0. unheard_s: time since the report
        arrived, `age_s` by default; the radius grows with it, because a slow link delays all reports equally.
        """
        v = np.array(v_ned)
        drift_m = min(0.5 * DRIFT_M_S2 * age_s * age_s, MOST_DRIFT_M)
        growing_s = age_s if unheard_s is None else unheard_s
        growth_m_s = min(DRIFT_M_S2 * growing_s, MOST_GROWTH_M_S) if drift_m < MOST_DRIFT_M else 0.0
        return cls(name, owner, np.array(p_ned) + lead_s * v, v, radius_m + drift_m, growth_m_s, agile_m_s)

    @classmethod
    def turning(cls, name: str, p_ned: ArrayLike, speed_m_s: float, lead_s: float, radius_m: float) -> Intruder:
        """One that may have turned any way since it was at a place `lead_s` ago, and may turn again at any time."""
        place = np.array(p_ned)
        return cls(name, None, place, np.zeros(3), radius_m + SQUEEZED_M + speed_m_s * lead_s, 0.0, speed_m_s)


def table_of(intruders: Sequence[Intruder]) -> Others:
    """As the filter takes them."""
    if not intruders:
        return Others()
    return Others(
        np.array([one.p_ned for one in intruders]),
        np.array([one.v_ned for one in intruders]),
        np.array([one.radius_m for one in intruders]),
        np.array([one.growth_m_s for one in intruders]),
        np.array([one.agile_m_s for one in intruders]),
    )
