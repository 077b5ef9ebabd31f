"""Where vehicles may be by their own geofence, and where they may come down: what is uploaded before a flight."""

import math
from collections.abc import Iterator
from typing import Annotated, Any

from pydantic import Field

from gcs.scenario.document import Conflict
from gcs.scenario.types import Metres, Part, Plane
from skytender import elementary

CIRCLE = 72
MOST_ITEMS = 200
"""Of a fence's corners and circles, or of rally points: more does not fit smaller autopilots."""


class Area(Part):
    """A polygon, or a circle, on the ground, at any height."""

    polygon_m: Annotated[tuple[Plane, ...], Field(min_length=3, max_length=MOST_ITEMS)] | None = None
    """its corners in order, m, the first two coordinates in the file's axes"""
    circle_m: Plane | None = None
    """its centre; with `radius_m`"""
    radius_m: Metres | None = None
    """radius of a circle, m"""

    def fault(self) -> str:
        """Sentence about what is wrong with it; empty where nothing."""
        if (self.polygon_m is None) == (self.circle_m is None):
            return "an area has either polygon_m or circle_m"
        if (self.circle_m is None) != (self.radius_m is None):
            return "circle_m and radius_m go together"
        return ""

    @property
    def border_ned(self) -> list[tuple[float, float]]:
        """Its border as corners (north, east), m; a circle has CIRCLE of them."""
        if self.polygon_m is not None:
            return [(n, e) for n, e in self.polygon_m]
        n, e = self.circle_m or (0.0, 0.0)
        turns = [2.0 * math.pi * k / CIRCLE for k in range(CIRCLE)]
        radius_m = self.radius_m or 0.0
        return [(n + radius_m * elementary.cos(turn), e + radius_m * elementary.sin(turn)) for turn in turns]

    def covers(self, north_m: float, east_m: float) -> bool:
        """Whether a place lies in it: a line from there to the east crosses the border an odd number of times."""
        if self.circle_m is not None and self.radius_m is not None:
            return elementary.distance((north_m, east_m), self.circle_m) <= self.radius_m
        inside, border = False, self.border_ned
        for (n0, e0), (n1, e1) in zip(border, [*border[1:], border[0]], strict=True):
            if (n0 > north_m) != (n1 > north_m) and east_m < e0 + (e1 - e0) * (north_m - n0) / (n1 - n0):
                inside = not inside
        return inside


class FenceRules(Part):
    """The geofence that vehicles keep by themselves; unless `planner: {safety: false}`, no set point lies beyond it."""

    inside: tuple[Area, ...] = ()
    """a vehicle stays in one of these; none: anywhere"""
    outside: tuple[Area, ...] = ()
    """a vehicle stays out of all of these"""

    def allows(self, north_m: float, east_m: float) -> bool:
        """Whether a vehicle may be at a place."""
        kept_in = not self.inside or any(area.covers(north_m, east_m) for area in self.inside)
        return kept_in and not any(area.covers(north_m, east_m) for area in self.outside)


NO_FENCE = FenceRules.model_construct()


def fence_conflicts(fence: FenceRules, rally_m: tuple[Any, ...]) -> Iterator[Conflict]:
    """Areas that are none, and more than autopilots hold."""
    items = 0
    for side in ("inside", "outside"):
        for i, area in enumerate(getattr(fence, side)):
            items += len(area.polygon_m or (0,))
            if area.fault():
                yield Conflict(("fence", side, i), area.fault())
    if items > MOST_ITEMS:
        yield Conflict(("fence",), f"the fence has {items} corners and circles, more than {MOST_ITEMS}")
    if len(rally_m) > MOST_ITEMS:
        yield Conflict(("rally_m",), f"there are more than {MOST_ITEMS} rally points")
