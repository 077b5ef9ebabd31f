"""What each mode wants flown: pure functions of what the mode keeps, the last set point and the vehicle's place.

Places are NED in the local frame, m; times are s since boot.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import NamedTuple

from simvehicle.mavlink.parameters import Parameters
from simvehicle.mavlink.telemetry import Vec3
from simvehicle.modes import STEERED, Mode

REACHED_M = 0.3
AT_REST: Vec3 = (0.0, 0.0, 0.0)
BRAKING_M_S2 = 2.5
REACTION_S = 0.3
_EVERYWHERE = (True, True, True)


@dataclass(frozen=True)
class SetPoint:
    """What offboard control asked for last; `use_position`: the axes on which a position counts beside the velocity."""

    p_ned: Vec3
    v_ned: Vec3
    use_position: tuple[bool, bool, bool]
    yaw_ned_rad: float | None
    time_s: float


@dataclass(frozen=True)
class Anchor:
    """What a mode keeps while it lasts: a place, since when, and the down coordinate that it climbs or returns at."""

    p_ned: Vec3
    time_s: float
    down_m: float


class Wish(NamedTuple):
    """Position, velocity, axes on which the position counts, when the position holds, greatest speed."""

    p_ned: Vec3
    v_ned: Vec3
    use_position: tuple[bool, bool, bool]
    time_s: float
    speed_m_s: float


def resting_place(p_ned: Vec3, v_ned: Vec3, *, ground: bool, landed: bool) -> Vec3:
    """Where a vehicle comes to rest that is told to stop now; never below the ground where there is one."""
    coast_s = 0.0 if landed else REACTION_S + hypot(*v_ned) / (2.0 * BRAKING_M_S2)
    north, east, down = (p + coast_s * v for p, v in zip(p_ned, v_ned, strict=True))
    return north, east, min(down, 0.0) if ground else down


def wish(
    mode: Mode,
    setpoint: SetPoint | None,
    anchor: Anchor,
    *,
    p_ned: Vec3,
    home_ned: Vec3,
    now_s: float,
    parameters: Parameters,
) -> Wish:
    """What the mode wants flown from `now_s` on by a vehicle at `p_ned`."""
    fastest = parameters["MPC_XY_VEL_MAX"]
    north, east, _ = anchor.p_ned
    if mode in STEERED and setpoint is not None:
        return Wish(setpoint.p_ned, setpoint.v_ned, setpoint.use_position, setpoint.time_s, fastest)
    if mode is Mode.TAKEOFF:
        climb = min(parameters["MPC_TKO_SPEED"], fastest)
        return Wish((north, east, anchor.down_m), AT_REST, _EVERYWHERE, now_s, climb)
    if mode is Mode.LAND:
        sink = (0.0, 0.0, parameters["MPC_LAND_SPEED"])
        return Wish(anchor.p_ned, sink, (True, True, False), anchor.time_s, fastest)
    if mode is Mode.RETURN:
        climbed = p_ned[2] <= anchor.down_m + REACHED_M
        goal = (home_ned[0], home_ned[1], anchor.down_m) if climbed else (north, east, anchor.down_m)
        return Wish(goal, AT_REST, _EVERYWHERE, now_s, min(parameters["MPC_XY_CRUISE"], fastest))
    return Wish(anchor.p_ned, AT_REST, _EVERYWHERE, now_s, fastest)
