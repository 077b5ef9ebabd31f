"""Places of a plan in the common frame of a session (gcs/mavlink/common_frame.py)."""

from __future__ import annotations

import math

from gcs.missions.items import FenceArea, GlobalPlace, LatLon, LocalPlace
from skytender import elementary, geodesy

Origin = tuple[float, float, float]
"""Of the common frame: latitude and longitude in degrees, altitude above the sea in m."""
Vec3 = tuple[float, float, float]
CIRCLE = 72
"""Corners of a circle's outline."""


def plane_ne(at_deg: LatLon, origin: Origin) -> tuple[float, float]:
    """North and east of a place, m."""
    return geodesy.ned_of(*at_deg, origin[2], origin)[:2]


def place_ned(place: GlobalPlace | LocalPlace, origin: Origin, home_alt_m: float) -> Vec3:
    """A place in the common frame, m. home_alt_m: altitude of home above the sea.

    Terrain counts as level with home. A height that is not given is home's; a local frame counts as the common one.
    """
    if isinstance(place, LocalPlace):
        return place.p_ned
    zero_m = 0.0 if place.above == "sea" else home_alt_m
    alt_m = home_alt_m if math.isnan(place.height_m) else zero_m + place.height_m
    return (*plane_ne((place.lat_deg, place.lon_deg), origin), origin[2] - alt_m)


def outline_ne(area: FenceArea, origin: Origin) -> list[tuple[float, float]]:
    """Corners of an area, m, the last one the first again; a circle has CIRCLE of them."""
    corners = [plane_ne(at, origin) for at in area.corners_deg]
    if area.radius_m is not None:
        (north_m, east_m), r = corners[0], area.radius_m
        turns = [2.0 * math.pi * k / CIRCLE for k in range(CIRCLE)]
        corners = [(north_m + r * elementary.cos(turn), east_m + r * elementary.sin(turn)) for turn in turns]
    return [*corners, corners[0]]
