"""Between a vehicle's local north-east-down frame and latitude, longitude and height.

The local frame is the plane tangent to the WGS 84 ellipsoid at its origin, with the ellipsoid's radii of curvature
there: against the exact conversion it is off by 1 mm at 100 m from the origin and by 0.1 m at 1 km.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import degrees, radians

import numpy as np
from numpy.typing import NDArray

from skytender import elementary
from skytender.geodesy import half_turn_deg, radii_m

MOST_LATITUDE_DEG = 89.0


@dataclass(frozen=True)
class LocalFrame:
    """A local frame with its origin at latitude, longitude (degrees) and height above mean sea level (m)."""

    lat_deg: float
    lon_deg: float
    alt_m: float
    deg_per_north_m: float = field(init=False)
    deg_per_east_m: float = field(init=False)
    row: NDArray[np.float64] = field(init=False, repr=False, compare=False)
    """all of it in this order, for compiled code"""

    def __post_init__(self) -> None:
        """Raises ValueError for a place that is none, or so near a pole that east has no meaning."""
        if not (abs(self.lat_deg) <= MOST_LATITUDE_DEG and abs(self.lon_deg) <= 180.0 and abs(self.alt_m) <= 1e5):
            place = f"{self.lat_deg:g}, {self.lon_deg:g}, {self.alt_m:g}"
            raise ValueError(
                f"{place} is no origin: latitude within 89 deg, longitude within 180 deg, then height in m"
            )
        meridian_m, across_m = radii_m(self.lat_deg)
        north_radius_m = meridian_m + self.alt_m
        east_radius_m = (across_m + self.alt_m) * elementary.cos(radians(self.lat_deg))
        object.__setattr__(self, "deg_per_north_m", degrees(1.0 / north_radius_m))
        object.__setattr__(self, "deg_per_east_m", degrees(1.0 / east_radius_m))
        numbers = (self.lat_deg, self.lon_deg, self.alt_m, self.deg_per_north_m, self.deg_per_east_m)
        object.__setattr__(self, "row", np.array(numbers, dtype=np.float64))

    def to_global(self, north_m: float, east_m: float, down_m: float) -> tuple[float, float, float]:
        """Latitude and longitude in degrees and height above mean sea level in m of a local point."""
        return (
            self.lat_deg + north_m * self.deg_per_north_m,
            half_turn_deg(self.lon_deg + east_m * self.deg_per_east_m),
            self.alt_m - down_m,
        )

    def to_local(self, lat_deg: float, lon_deg: float, alt_m: float) -> tuple[float, float, float]:
        """North, east and down in m of a global point."""
        return (
            (lat_deg - self.lat_deg) / self.deg_per_north_m,
            half_turn_deg(lon_deg - self.lon_deg) / self.deg_per_east_m,
            self.alt_m - alt_m,
        )
