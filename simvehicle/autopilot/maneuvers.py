"""Set points of each mode: pure functions of what the mode keeps, the last set point and the vehicle's place.

Places are NED in the local frame, m; times are s since boot.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from math import hypot, inf, radians
from typing import NamedTuple

from simvehicle.autopilot.follow import Followed, place_beside
from simvehicle.autopilot.mission import Mission
from simvehicle.autopilot.modes import Mode
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vectors import Vec3

REACHED_M = 0.3
AT_REST: Vec3 = (0.0, 0.0, 0.0)
BRAKING_M_S2 = 2.5
REACTION_S = 0.3
FOLLOW_SILENCE_S = 3.0
"""A vehicle that follows holds when its target has been silent for this long."""
FOLLOW_ITS_HEIGHT = 2
"""FLW_TGT_ALT_M for a height above the target; other values: above home."""
_EVERYWHERE = (True, True, True)


class OffboardSetPoint(NamedTuple):
    """Offboard control's last set point; `use_position`: the axes on which a position counts beside the velocity.

    Of yaw and yaw rate at most one counts; where both are None the yaw stays.
    """

    p_ned: Vec3
    v_ned: Vec3
    use_position: tuple[bool, bool, bool]
    yaw_ned_rad: float | None
    time_s: float
    yaw_rate_rad_s: float | None = None


@dataclass(frozen=True)
class Anchor:
    """State that a mode keeps while it lasts: a place, since when, and the down coordinate that it climbs or returns
    at.

    `speed_m_s` is the greatest speed on the way to the place, where one was asked for.
    """

    p_ned: Vec3
    time_s: float
    down_m: float
    speed_m_s: float | None = None


class ManeuverTarget(NamedTuple):
    """Position, velocity, axes on which the position counts, when the position holds, greatest speed."""

    p_ned: Vec3
    v_ned: Vec3
    use_position: tuple[bool, bool, bool]
    time_s: float
    speed_m_s: float


class ReturnLeg(Enum):
    """Leg of a return."""

    UP = "up"
    WAIT = "wait"
    """where it began, below all ways"""
    LEVEL = "level"
    DOWN = "down"


def resting_place(p_ned: Vec3, v_ned: Vec3, *, ground: bool, landed: bool) -> Vec3:
    """Place where a vehicle comes to rest that is to stop now; never below the ground where there is one."""
    coast_s = 0.0 if landed else REACTION_S + hypot(*v_ned) / (2.0 * BRAKING_M_S2)
    north, east, down = (p + coast_s * v for p, v in zip(p_ned, v_ned, strict=True))
    return north, east, min(down, 0.0) if ground else down


def target_of(
    mode: Mode,
    anchor: Anchor,
    *,
    p_ned: Vec3,
    home_ned: Vec3,
    return_ned: Vec3,
    now_s: float,
    parameters: Parameters,
    mission: Mission | None = None,
    followed: Followed | None = None,
    blind: bool = False,
    leg: ReturnLeg | None = None,
    descend_m: float = inf,
) -> ManeuverTarget:
    """Target of a mode that flies by itself from `now_s` on, for a vehicle at `p_ned`; `blind`: it does not know where
    that is. A mode that flies set points rests without one. `leg`: of a return; None: up, or level from where it is as
    high as it returns; the last one goes down to `descend_m` above home."""
    fastest = parameters["MPC_XY_VEL_MAX"]
    north, east, _ = anchor.p_ned
    if mode is Mode.TAKEOFF:
        climb = min(parameters["MPC_TKO_SPEED"], fastest)
        return ManeuverTarget((north, east, anchor.down_m), AT_REST, _EVERYWHERE, now_s, climb)
    if mode is Mode.LAND:
        return landing(anchor, parameters, blind=blind)
    if mode is Mode.MISSION and mission is not None:
        return on_mission(mission, anchor, now_s=now_s, parameters=parameters)
    if mode is Mode.FOLLOW:
        return following(followed, anchor, home_ned=home_ned, now_s=now_s, parameters=parameters)
    if mode is Mode.RETURN:
        climbed = leg is ReturnLeg.LEVEL or (leg is None and p_ned[2] <= anchor.down_m + REACHED_M)
        goal = (return_ned[0], return_ned[1], anchor.down_m) if climbed else (north, east, anchor.down_m)
        if leg is ReturnLeg.WAIT:
            goal = anchor.p_ned
        elif leg is ReturnLeg.DOWN:
            goal = (return_ned[0], return_ned[1], max(anchor.down_m, return_ned[2] - descend_m))
        return ManeuverTarget(goal, AT_REST, _EVERYWHERE, now_s, min(parameters["MPC_XY_CRUISE"], fastest))
    return ManeuverTarget(anchor.p_ned, AT_REST, _EVERYWHERE, now_s, min(anchor.speed_m_s or fastest, fastest))


def landing(anchor: Anchor, parameters: Parameters, *, blind: bool = False) -> ManeuverTarget:
    """Sink over a place, or, `blind`, without knowing where that is: straight down as far as the velocity shows."""
    sink = (0.0, 0.0, parameters["MPC_LAND_SPEED"])
    held = (not blind, not blind, False)
    return ManeuverTarget(anchor.p_ned, sink, held, anchor.time_s, parameters["MPC_XY_VEL_MAX"])


def on_mission(mission: Mission, anchor: Anchor, *, now_s: float, parameters: Parameters) -> ManeuverTarget:
    """Set point of a mission; without a goal, to stay at the anchor."""
    fastest = parameters["MPC_XY_VEL_MAX"]
    goal = mission.goal_ned
    if goal is None:
        return ManeuverTarget(anchor.p_ned, AT_REST, _EVERYWHERE, now_s, fastest)
    if mission.landing:
        return landing(Anchor(goal, anchor.time_s, goal[2]), parameters)
    wanted = parameters["MPC_TKO_SPEED"] if mission.climbing else mission.speed_m_s or parameters["MPC_XY_CRUISE"]
    return ManeuverTarget(goal, AT_REST, _EVERYWHERE, now_s, min(wanted, fastest))


def following(
    target: Followed | None, anchor: Anchor, *, home_ned: Vec3, now_s: float, parameters: Parameters
) -> ManeuverTarget:
    """Set point beside a target; without one, or when it has fallen silent, to stay at the anchor."""
    fastest = parameters["MPC_XY_VEL_MAX"]
    if target is None or now_s - target.time_s > FOLLOW_SILENCE_S:
        return ManeuverTarget(anchor.p_ned, AT_REST, _EVERYWHERE, now_s, fastest)
    lowest_ned = target.p_ned if parameters["FLW_TGT_ALT_M"] == FOLLOW_ITS_HEIGHT else home_ned
    place = place_beside(
        target,
        distance_m=parameters["FLW_TGT_DST"],
        angle_rad=radians(parameters["FLW_TGT_FA"]),
        down_m=lowest_ned[2] - parameters["FLW_TGT_HT"],
    )
    v_ned = (target.v_ned[0], target.v_ned[1], 0.0)
    return ManeuverTarget(place, v_ned, _EVERYWHERE, target.time_s, min(parameters["FLW_TGT_MAX_VEL"], fastest))
