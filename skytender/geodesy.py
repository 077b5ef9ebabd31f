"""Places on the globe in a local frame and back, on the ellipsoid of WGS 84.

A local frame is flat: north and east lie in the plane that touches the ellipsoid below its origin, and down is the
plane's normal. An origin is (latitude in degrees, longitude in degrees, height above the ellipsoid in m); what is used
as height is the altitude above the sea, for all places alike.

Both ways lead through coordinates fixed in the earth, in which latitude φ, longitude λ and height h are

    x = (N + h) cos φ cos λ    y = (N + h) cos φ sin λ    z = (N (1 - e²) + h) sin φ    N = a / sqrt(1 - e² sin² φ)

The way back is Bowring's (Survey Review 23, 1976), iterated twice: within 10⁻¹² degrees up to 5 km above ground. All
is IEEE 754's basic operations and `skytender.elementary`, so the results are the same on every processor.
"""

from __future__ import annotations

import math

from skytender import elementary

Vec3 = tuple[float, float, float]

A_M = 6_378_137.0
"""[WGS 84] Half the ellipsoid's great axis."""
FLATTENING = 1.0 / 298.257223563
"""[WGS 84]"""
_B_M = A_M * (1.0 - FLATTENING)
_E2 = FLATTENING * (2.0 - FLATTENING)
_SECOND_E2 = _E2 / (1.0 - _E2)
_ITERATIONS = 2


def ned_of(lat_deg: float, lon_deg: float, alt_m: float, origin: Vec3) -> Vec3:
    """North, east and down (m) of a place in the frame of an origin."""
    (sin_lat, cos_lat), (sin_lon, cos_lon) = _directions(origin)
    x, y, z = _fixed(lat_deg, lon_deg, alt_m)
    x_0, y_0, z_0 = _fixed(*origin)
    x, y, z = x - x_0, y - y_0, z - z_0
    outwards = cos_lon * x + sin_lon * y
    north = cos_lat * z - sin_lat * outwards
    return north, cos_lon * y - sin_lon * x, -(cos_lat * outwards + sin_lat * z)


def place_of(p_ned: Vec3, origin: Vec3) -> Vec3:
    """Latitude (deg), longitude (deg) and height (m) of a place in the frame of an origin."""
    north, east, down = p_ned
    (sin_lat, cos_lat), (sin_lon, cos_lon) = _directions(origin)
    x, y, z = _fixed(*origin)
    outwards = -sin_lat * north - cos_lat * down
    x += cos_lon * outwards - sin_lon * east
    y += sin_lon * outwards + cos_lon * east
    z += cos_lat * north - sin_lat * down
    from_axis = math.sqrt(x * x + y * y)
    lat = elementary.atan2(z, (1.0 - _E2) * from_axis)
    for _ in range(_ITERATIONS):
        sin, cos = elementary.sin_cos(elementary.atan2(_B_M * elementary.sin(lat), A_M * elementary.cos(lat)))
        lat = elementary.atan2(z + _SECOND_E2 * _B_M * sin * sin * sin, from_axis - _E2 * A_M * cos * cos * cos)
    sin, cos = elementary.sin_cos(lat)
    height_m = from_axis * cos + z * sin - A_M * math.sqrt(1.0 - _E2 * sin * sin)
    return math.degrees(lat), math.degrees(elementary.atan2(y, x)), height_m


def half_turn_deg(longitude_deg: float) -> float:
    """The same longitude, or difference of longitudes, within half a turn: from -180 to 180 degrees."""
    return math.remainder(longitude_deg, 360.0)


def radii_m(lat_deg: float) -> tuple[float, float]:
    """The ellipsoid's radii of curvature (m) at a latitude (deg): along the meridian, and across it.

    M = a (1 - e²)/(1 - e² sin² φ)^(3/2)    N = a/(1 - e² sin² φ)^(1/2)
    """
    sine, _ = elementary.sin_cos(math.radians(lat_deg))
    square = 1.0 - _E2 * sine * sine
    across_m = A_M / math.sqrt(square)
    return across_m * (1.0 - _E2) / square, across_m


def _directions(origin: Vec3) -> tuple[tuple[float, float], tuple[float, float]]:
    """Sine and cosine of an origin's latitude and of its longitude."""
    return elementary.sin_cos(math.radians(origin[0])), elementary.sin_cos(math.radians(origin[1]))


def _fixed(lat_deg: float, lon_deg: float, alt_m: float) -> Vec3:
    """A place in coordinates fixed in the earth, m."""
    sin_lat, cos_lat = elementary.sin_cos(math.radians(lat_deg))
    sin_lon, cos_lon = elementary.sin_cos(math.radians(lon_deg))
    across = A_M / math.sqrt(1.0 - _E2 * sin_lat * sin_lat)
    out = (across + alt_m) * cos_lat
    return out * cos_lon, out * sin_lon, (across * (1.0 - _E2) + alt_m) * sin_lat
