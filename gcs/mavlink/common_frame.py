"""Where a vehicle's own local NED frame lies in the common frame of a session, by geodesy on WGS 84.

The common frame is flat: north and east lie in the plane that touches the ellipsoid at its origin, down is the
difference of altitudes, so that a height means the same everywhere. A frame whose origin lies elsewhere is moved by

    offset = (north, east of its origin in that plane, altitude of the common origin - altitude of its own)

and turned about the vertical by the convergence of the meridians, the angle that brings both its axes nearest to where
they point in that plane (least squares, after Kabsch, in two dimensions):

    turn = atan2(e · n' - n · e', n · n' + e · e')      n, e: the common axes, n', e': its own, all in fixed axes

What is left at a distance d is the plane's foreshortening d²/2R² along the bearing, R the earth's radius (0.03 mm for
100 m at 5 km, 12 mm at 100 km), and h/R, h the difference of altitudes (2 mm for 100 m and 100 m). [choice]
"""

from __future__ import annotations

import math
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from skytender import elementary, geodesy

Vec3 = tuple[float, float, float]
T = TypeVar("T", float, NDArray[np.float64])


class FramePlace(NamedTuple):
    """Place of a local frame in the common one: its origin (m, NED), and by how much its axes are turned (rad)."""

    offset_ned: Vec3
    turn_rad: float

    def moved(self, at_ned: Vec3) -> Vec3:
        """A place of that frame in the common one."""
        north, east, down = turned(at_ned, self.turn_rad)
        return (north + self.offset_ned[0], east + self.offset_ned[1], down + self.offset_ned[2])


def frame_place(
    lat_deg: float, lon_deg: float, alt_m: float, common_lat_deg: float, common_lon_deg: float, common_alt_m: float
) -> FramePlace:
    """The place of a frame whose origin lies there, in the common frame with its origin."""
    origin = common_lat_deg, common_lon_deg, common_alt_m
    north, east, _ = geodesy.ned_of(lat_deg, lon_deg, common_alt_m, origin)
    phi, phi_0 = math.radians(lat_deg), math.radians(common_lat_deg)
    ahead = math.radians(lon_deg - common_lon_deg)
    (sin_phi, cos_phi), (sin_phi_0, cos_phi_0) = elementary.sin_cos(phi), elementary.sin_cos(phi_0)
    sin_ahead, cos_ahead = elementary.sin_cos(ahead)
    north_of_north = sin_phi_0 * sin_phi * cos_ahead + cos_phi_0 * cos_phi
    east_of_north, north_of_east = -sin_phi * sin_ahead, sin_phi_0 * sin_ahead
    turn_rad = elementary.atan2(east_of_north - north_of_east, north_of_north + cos_ahead)
    return FramePlace((north, east, common_alt_m - alt_m), turn_rad)


def origin_under(lat_deg: float, lon_deg: float, alt_m: float, at_ned: Vec3) -> tuple[float, float, float]:
    """Origin (deg, deg, m) of the frame in which that place is at `at_ned`, m."""
    north, east, down = at_ned
    lat_0, lon_0, _ = geodesy.place_of((-north, -east, 0.0), (lat_deg, lon_deg, alt_m))
    return lat_0, lon_0, alt_m + down


def turned(vector_ned: tuple[T, T, T], turn_rad: float) -> tuple[T, T, T]:
    """A vector (of numbers, or of arrays) of a frame that is turned by so much, in the other's axes; turned back by the
    negative angle."""
    if not turn_rad:
        return vector_ned
    north, east, down = vector_ned
    sin, cos = elementary.sin_cos(turn_rad)
    return cos * north - sin * east, sin * north + cos * east, down
