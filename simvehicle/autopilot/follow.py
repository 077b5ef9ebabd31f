"""Following: the place beside a target that reports its position. Pure functions; NED, m, m/s, rad."""

from __future__ import annotations

from math import atan2, cos, hypot, sin
from typing import NamedTuple

Vec3 = tuple[float, float, float]

SLOWEST_COURSE_M_S = 0.3
"""A target slower than this has no course of its own; the last one is kept."""


class Followed(NamedTuple):
    """A target as it was reported last, its velocity smoothed, and the course that it keeps."""

    p_ned: Vec3
    v_ned: Vec3
    course_rad: float
    time_s: float


def smoothed(
    last: Followed | None, p_ned: Vec3, v_ned: Vec3, now_s: float, *, kept: float, towards_rad: float
) -> Followed:
    """Take a report in; `kept`: the share of the old velocity in the new; `towards_rad`: the course to begin with."""
    if last is not None:
        north, east, down = (kept * old + (1.0 - kept) * new for old, new in zip(last.v_ned, v_ned, strict=True))
        v_ned = (north, east, down)
    course_rad = towards_rad if last is None else last.course_rad
    if hypot(v_ned[0], v_ned[1]) > SLOWEST_COURSE_M_S:
        course_rad = atan2(v_ned[1], v_ned[0])
    return Followed(p_ned, v_ned, course_rad, now_s)


def place_beside(target: Followed, *, distance_m: float, angle_rad: float, down_m: float) -> Vec3:
    """Place wanted when the report was made: at a distance, an angle from its course (0 ahead, pi behind), a height."""
    bearing_rad = target.course_rad + angle_rad
    north = target.p_ned[0] + distance_m * cos(bearing_rad)
    east = target.p_ned[1] + distance_m * sin(bearing_rad)
    return north, east, down_m
