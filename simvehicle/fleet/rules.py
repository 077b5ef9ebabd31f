"""Rules of a fleet whose vehicles compete on board, as each of them is given them at its start."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, NamedTuple

from simvehicle.autopilot.vectors import Vec3
from skytender import elementary


class FleetRulesError(ValueError):
    """Rules that cannot be used; the text says why."""


class Solid(NamedTuple):
    """An obstacle: a box between two corners, or one of no size, `radius_m` around it; NED. An upright cylinder's
    corners are the ends of its axis."""

    kind: str
    low_ned: Vec3
    high_ned: Vec3
    radius_m: float

    def clearance_m(self, p_ned: Vec3) -> float:
        """Distance from a place to the surface; of a point, to it; negative inside."""
        beyond = [max(low - x, x - high) for low, x, high in zip(self.low_ned, p_ned, self.high_ned, strict=True)]
        if self.kind == "cylinder":
            beyond = [elementary.hypot(beyond[0], beyond[1]) - self.radius_m, beyond[2]]
        outside = elementary.norm([max(distance, 0.0) for distance in beyond])
        return (outside or max(beyond)) - (self.radius_m if self.kind == "sphere" else 0.0)


class TankerShare(NamedTuple):
    """A tanker's own rules: what it keeps, how fast it flies, and where its home is."""

    reserve_j: float
    speed_m_s: float
    home_ned: Vec3


@dataclass(frozen=True)
class FleetRules:
    """Competition, service and distances; names and units are as in the scenario's keys."""

    bids: str
    """`losses` or `time`"""
    p: float
    rate: float
    floor: float
    high: float
    need_from: float
    share: float
    dwell_s: float
    decide_within_s: float
    horizon_s: float
    tie_s: float
    height_m: float
    capture_m: float
    relative_speed_m_s: float
    hold_s: float
    rate_w: float
    until: float
    reserve_s: float
    lands_at: float
    tops_up: bool
    limit_j: float | None
    transfers_until_s: float
    """of the session: transfers are stopped then, so that they are settled before it ends"""
    separation_m: float
    clearance_m: float
    transit_height_m: float
    """above the frame's zero: over all obstacles"""
    report_every_s: float
    """how often a vehicle reports itself to the others"""
    pursuers: tuple[int, ...]
    tankers: Mapping[int, TankerShare]
    obstacles: tuple[Solid, ...] = ()


def read_rules(content: Any) -> FleetRules:
    """Rules from plain data, as a file holds them. Raises FleetRulesError."""
    names = {field.name for field in fields(FleetRules)}
    if not isinstance(content, Mapping) or set(content) != names:
        different = ", ".join(sorted(names ^ set(content))) if isinstance(content, Mapping) else "all"
        raise FleetRulesError(f"the rules of a fleet need exactly their keys; missing or unknown: {different}")
    try:
        tankers = {
            int(one["sysid"]): TankerShare(float(one["reserve_j"]), float(one["speed_m_s"]), _vec(one["home_ned"]))
            for one in content["tankers"]
        }
        obstacles = tuple(
            Solid(str(one["kind"]), _vec(one["low_ned"]), _vec(one["high_ned"]), float(one["radius_m"]))
            for one in content["obstacles"]
        )
        special: dict[str, Any] = {
            "bids": str(content["bids"]),
            "tops_up": bool(content["tops_up"]),
            "limit_j": None if content["limit_j"] is None else float(content["limit_j"]),
            "pursuers": tuple(int(sysid) for sysid in content["pursuers"]),
            "tankers": tankers,
            "obstacles": obstacles,
        }
        special |= {name: float(content[name]) for name in names - special.keys()}
        return FleetRules(**special)
    except (TypeError, KeyError, ValueError) as error:
        raise FleetRulesError(f"the rules of a fleet hold what cannot be read: {error}") from error


def _vec(numbers: Any) -> Vec3:
    north, east, down = (float(number) for number in numbers)
    return north, east, down
