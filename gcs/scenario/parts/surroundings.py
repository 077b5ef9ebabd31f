"""Obstacles, traffic and attractors."""

from collections.abc import Callable
from typing import Annotated, Literal

from pydantic import Field

from gcs.scenario.types import Exact, Flag, Height, Label, Metres, Part, Plane, Route, Seconds, Speed, Vec3
from skytender import elementary

Kind = Literal["point", "sphere", "box", "cylinder"]
_KEYS: dict[Kind, set[str]] = {
    "point": set(),
    "box": set(),
    "sphere": {"radius_m"},
    "cylinder": {"radius_m", "bottom_m", "top_m"},
}


class Obstacle(Part):
    """A point, a sphere round its centre, a box between two opposite corners, or an upright cylinder round (x, y).

    All are read alike, by `kind`, `low_m`, `high_m` and `radius_m` (0 for points and boxes).
    """

    name: Label | None = None
    """shown in messages and plots; by default `sphere 2` and the like"""
    point_m: Vec3 | None = None
    """a point obstacle: its position, m, in the file's axes"""
    sphere_m: Vec3 | None = None
    """a sphere: its centre, m, in the file's axes; with `radius_m`"""
    box_m: tuple[Vec3, Vec3] | None = None
    """a box: two opposite corners, m, in the file's axes"""
    cylinder_m: Plane | None = None
    """an upright cylinder: its axis as the first two coordinates, m; with `radius_m`, `bottom_m` and `top_m`"""
    radius_m: Annotated[float, Exact(ge=0, le=1e5)] = 0.0
    """radius of a sphere or cylinder, m"""
    bottom_m: Height | None = None
    """lower end of a cylinder, m, third coordinate in the file's axes"""
    top_m: Height | None = None
    """upper end of a cylinder, m, third coordinate in the file's axes"""

    @property
    def kind(self) -> Kind:
        return next(kind for kind in _KEYS if getattr(self, f"{kind}_m") is not None)

    @property
    def low_m(self) -> Vec3:
        """NED; the least coordinates of the box, of the cylinder's axis, or the point or centre itself."""
        return self._corner(min)

    @property
    def high_m(self) -> Vec3:
        """NED; the greatest coordinates of the same."""
        return self._corner(max)

    def _corner(self, of: Callable[[float, float], float]) -> Vec3:
        a = b = self.point_m or self.sphere_m or (0.0, 0.0, 0.0)
        if self.box_m:
            a, b = self.box_m
        elif self.cylinder_m:
            a, b = (*self.cylinder_m, self.top_m or 0.0), (*self.cylinder_m, self.bottom_m or 0.0)
        return of(a[0], b[0]), of(a[1], b[1]), of(a[2], b[2])

    def clearance_m(self, p_ned: Vec3) -> float:
        """The distance in m from p_ned to the surface (a point's is its centre); negative inside."""
        beyond = [max(low - x, x - high) for low, x, high in zip(self.low_m, p_ned, self.high_m, strict=True)]
        if self.kind == "cylinder":
            beyond = [elementary.hypot(beyond[0], beyond[1]) - self.radius_m, beyond[2]]
        outside = elementary.norm([max(distance, 0.0) for distance in beyond])
        return (outside or max(beyond)) - (self.radius_m if self.kind == "sphere" else 0.0)

    def fault(self) -> str:
        """Fault that keeps the keys from being one solid, as a sentence; empty without one."""
        kinds = [kind for kind in _KEYS if getattr(self, f"{kind}_m") is not None]
        if len(kinds) != 1:
            return f"an obstacle needs exactly one of {', '.join(f'{kind}_m' for kind in _KEYS)}"
        for key in ("radius_m", "bottom_m", "top_m"):
            given = getattr(self, key) is not None and (key != "radius_m" or self.radius_m > 0)
            if given != (key in _KEYS[kinds[0]]):
                return f"a {kinds[0]} {'has no' if given else 'needs'} {key}"
        if self.box_m and any(low == high for low, high in zip(*self.box_m, strict=True)):
            return "a box needs corners that differ in each direction"
        if self.bottom_m is not None and self.top_m is not None and self.top_m >= self.bottom_m:
            return "a cylinder's top_m must lie above its bottom_m"
        return ""


class Mover(Part):
    """Traffic: flies its path from session time `start_s`, reported by ADSB_VEHICLE; it is not steered."""

    callsign: Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,8}$")]
    """ADSB_VEHICLE's callsign, 1 to 8 letters, digits, - or _; unique"""
    path_m: Route
    """corners of its path, m, in the file's axes; an open path is flown to its end and back"""
    speed_m_s: Speed
    """speed along the path, m/s"""
    closed: Flag = False
    """the path leads from its last point back to its first"""
    start_s: Seconds = 0.0
    """session time at which it starts to move, s; until then it waits at its first point"""
    attracts: Flag = False
    """pursuers within planner.attraction_range_m are drawn to it, instead of repelled"""


class Attractor(Part):
    """A point that draws pursuers within its range, beside what they follow (docs/model/planner.md#potential-field;
    paper eq. 5) [choice], range [seed]."""

    name: Label | None = None
    """shown in plots"""
    point_m: Vec3
    """its position, m, in the file's axes"""
    range_m: Metres | None = None
    """without it planner.attraction_range_m"""
