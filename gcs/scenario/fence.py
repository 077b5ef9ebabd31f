"""Where vehicles may be by their own geofence, and where they may come down: what is uploaded before a flight."""

from collections.abc import Iterator
from typing import Annotated, Any

from pydantic import Field

from gcs.scenario.document import Conflict
from gcs.scenario.types import Metres, Part, Plane

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


class FenceRules(Part):
    """The geofence that vehicles keep by themselves; the planner does not know it."""

    inside: tuple[Area, ...] = ()
    """a vehicle stays in one of these; none: anywhere"""
    outside: tuple[Area, ...] = ()
    """a vehicle stays out of all of these"""


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
