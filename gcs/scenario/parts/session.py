"""The session as a whole: place, clock, goal and record."""

from datetime import UTC, datetime
from typing import Annotated, Literal

from pydantic import AwareDatetime, Field, ValidationInfo

from gcs.scenario.types import Count, Degrees, Exact, Flag, Limit, Metres, Part, Seconds

STEP_S = 0.004  # the vehicles' own step: a grant is a whole number of them


def known_axes(value: str, info: ValidationInfo) -> str:
    if value == "paper" and info.context != {"axes": "paper"}:
        raise ValueError("must be 'ned' here: only a file is converted from paper axes")
    return "ned"


EARLIEST, LATEST = datetime(1970, 1, 1, tzinfo=UTC), datetime(2200, 1, 1, tzinfo=UTC)


class Origin(Part):
    """Place of the local frame's zero; the height is above mean sea level."""

    lat_deg: Annotated[float, Exact(ge=-89, le=89)]
    """latitude, degrees north, WGS 84"""
    lon_deg: Degrees
    """longitude, degrees east, WGS 84"""
    alt_m: Annotated[float, Exact(ge=-1000, le=20_000)]
    """height above mean sea level, m"""


class Clock(Part):
    """lockstep: as fast as the machine can; real: paced at `speed`. `epoch` is the date of session time zero."""

    mode: Literal["lockstep", "real"] = "real"
    """`lockstep`: as fast as the machine can; `real`: paced at `speed`"""
    speed: Annotated[float, Exact(gt=0, le=1000)] = 1.0
    """session seconds per wall second, with mode `real`; external vehicles must keep it by themselves, else they are
    not armed"""
    period_s: Annotated[float, Exact(ge=STEP_S, le=1)] = 0.1
    """period of planning, set points and grants, s; a multiple of 0.004, at most 0.2 with refuelling"""
    epoch: Annotated[AwareDatetime, Field(ge=EARLIEST, lt=LATEST)] = datetime(2026, 1, 1, tzinfo=UTC)
    """date and time of session time zero, with time zone; the times in session.tlog count from it"""


class Pursue(Part):
    """Distance of each pursuer, or in a competition of one, to its target, and for how long without a
    break."""

    within_m: Metres
    """greatest distance from pursuer to target, m"""
    for_s: Seconds
    """how long without a break, s of session time"""


class Goal(Part):
    """Goal of the session (docs/protocol/result.md#goal): every part must be met. No vehicle collides, falls out or
    misses a way point unless the scenario says that this does not matter."""

    pursue: Pursue | None = None
    """pursuit that is demanded; none by default"""
    refuelled_at_least: Count = 0
    """number of services that must have ended, and delivered energy; 0 demands none"""
    duration_s: Annotated[float, Exact(gt=0, le=604_800)]
    """length of the session, s of session time"""
    separation_m: Limit = None
    """least distance of two vehicles in flight, m, except during a transfer; by default planner.separation_m where
    planner.vehicles_repel; `false` or 0 demands none"""
    traffic_m: Limit = None
    """least distance of a vehicle in flight to traffic, m, except traffic that attracts; by default
    planner.separation_m; `false` or 0 demands none"""
    clearance_m: Limit = 0.1
    """least distance of a vehicle in flight to an obstacle's surface (a point's is its centre), m; nearer counts as
    touched; 0: only inside counts; `false` demands none"""
    ground: Flag = True
    """whether touching the ground, other than to take off and land, fails the goal; not of vehicles that start
    `airborne`, which have no ground"""
    lost_at_most: Count = 0
    """how many vehicles may be lost: dead, run dry, landed by a failsafe without an order to come down, or never in the
    air"""
    waypoints: Literal["all", "none"] = "all"
    """`all`: every pursuer with waypoints_m passes all of them in order, and one with a mission reaches its last item;
    `none`: none need"""
    waypoint_within_m: Metres = 1.0
    """how near a pursuer must pass a way point, m; at least planner.step_m"""


class Record(Part):
    """Files that a session leaves on disk, and how large they become (docs/protocol/folder.md#rotation)."""

    rotate_mb: Annotated[int, Exact(ge=1, le=1_000_000)] | None = None
    """once session.tlog and decisions.jsonl are larger together, they go on in new files; MB; never without it"""
    keep: Annotated[int, Exact(ge=1, le=9999)] | None = None
    """so many of the files that were full are kept, the oldest go; all without it"""
    decisions: Literal["all", "changes"] = "all"
    """`changes`: a set point that the one before it foretells to 5 cm and 5 cm/s is not written, for 1 s at most"""
    truth_hz: Annotated[float, Exact(gt=0, le=250)] | None = None
    """vehicles record their truth so often, without the thrust of each step; every grant without it"""
