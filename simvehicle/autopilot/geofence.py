"""The geofence: where a vehicle may be, as polygons and circles on the ground, north and east in m."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot

Point = tuple[float, float]


@dataclass(frozen=True)
class Circle:
    """A circle around a point."""

    centre: Point
    radius_m: float

    def holds(self, north: float, east: float) -> bool:
        """Whether a point lies in it, its edge included."""
        return hypot(north - self.centre[0], east - self.centre[1]) <= self.radius_m


@dataclass(frozen=True)
class Polygon:
    """A closed polygon of three corners or more; it may be concave."""

    corners: tuple[Point, ...]

    def holds(self, north: float, east: float) -> bool:
        """Whether a point lies inside: a ray towards east crosses the outline an odd number of times."""
        inside = False
        for (n0, e0), (n1, e1) in zip(self.corners, (*self.corners[1:], self.corners[0]), strict=True):
            if (n0 > north) != (n1 > north) and east < e0 + (north - n0) / (n1 - n0) * (e1 - e0):
                inside = not inside
        return inside


@dataclass(frozen=True)
class Fence:
    """A vehicle stays in one of the areas of `inside`, where there are any, and out of all of `outside`."""

    inside: tuple[Circle | Polygon, ...] = ()
    outside: tuple[Circle | Polygon, ...] = ()

    def breached(self, north: float, east: float) -> bool:
        """Whether a vehicle at this place is where it may not be."""
        if not self.inside and not self.outside:
            return False
        kept = not self.inside or any(area.holds(north, east) for area in self.inside)
        return not kept or any(area.holds(north, east) for area in self.outside)
