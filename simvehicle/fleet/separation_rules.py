"""Rules by which vehicles keep apart on board, as each of them is given them at its start."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from simvehicle.autopilot.vectors import Vec3, along
from skytender import elementary, geometry
from skytender.safety.braking_clearance import stop_way
from skytender.safety.safety_filter import BRAKE_SHARE
from skytender.safety.silence import Failsafe

STANDS_M_S = 1e-4
"""A leader that is slower stands."""


class SeparationRulesError(ValueError):
    """Rules that cannot be used; the text says why."""


class PeerProfile(NamedTuple):
    """One of the vehicles: greatest speed and acceleration of its leader, m/s and m/s², where its home is, and how it
    returns there."""

    speed_m_s: float
    acceleration_m_s2: float
    home_ned: Vec3
    failsafe: Failsafe


@dataclass(frozen=True)
class SeparationRules:
    """Distances to keep, from which vehicles, and how often set points come; names and units as in the scenario."""

    period_s: float
    separation_m: float
    clearance_m: float
    vehicles: Mapping[int, PeerProfile]
    obstacles: NDArray[np.float64]
    """table of skytender/geometry.py"""

    def rest(self, sysid: int, p_ned: Vec3, v_ned: Vec3) -> Vec3:
        """Place (NED, m) where the leader of a vehicle stands if it brakes now."""
        speed_m_s = elementary.norm(v_ned)
        if speed_m_s < STANDS_M_S:
            return p_ned
        brake_m_s2 = BRAKE_SHARE * self.vehicles[sysid].acceleration_m_s2
        return along(p_ned, v_ned, stop_way(speed_m_s, brake_m_s2, self.period_s) / speed_m_s)


_KEYS = {"period_s", "separation_m", "clearance_m", "vehicles", "obstacles"}


def read_separation(content: Any, sysids: Iterable[int] = ()) -> SeparationRules:
    """Rules from plain data, as a file holds them, for vehicles that must be among theirs. Raises
    SeparationRulesError."""
    if not isinstance(content, Mapping) or set(content) != _KEYS:
        raise SeparationRulesError(f"rules to keep apart by need exactly these keys: {', '.join(sorted(_KEYS))}")
    try:
        rules = SeparationRules(
            float(content["period_s"]),
            float(content["separation_m"]),
            float(content["clearance_m"]),
            {int(one["sysid"]): _profile(one) for one in content["vehicles"]},
            geometry.table(
                [
                    geometry.solid(one["kind"], one["low_ned"], one["high_ned"], float(one["radius_m"]))
                    for one in content["obstacles"]
                ]
            ),
        )
    except (TypeError, KeyError, ValueError) as error:
        raise SeparationRulesError(f"rules to keep apart by hold what cannot be read: {error}") from error
    if missing := sorted(set(sysids) - set(rules.vehicles)):
        raise SeparationRulesError(f"rules to keep apart by do not name vehicle {missing[0]}")
    return rules


def _profile(content: Mapping[str, Any]) -> PeerProfile:
    north, east, down = (float(number) for number in content["home_ned"])
    failsafe = Failsafe(**{name: float(value) for name, value in content["failsafe"].items()})
    return PeerProfile(float(content["speed_m_s"]), float(content["acceleration_m_s2"]), (north, east, down), failsafe)
