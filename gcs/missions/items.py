"""Model of a mission, a geofence and rally points, as files and vehicles have them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Literal, NamedTuple

from skytender import mavlink as mav

Above = Literal["sea", "home", "terrain"]
LatLon = tuple[float, float]
"""Latitude and longitude, degrees of WGS 84."""
Params = tuple[float, float, float, float, float, float, float]

GLOBAL: dict[int, Above] = {
    mav.MAV_FRAME_GLOBAL: "sea",
    mav.MAV_FRAME_GLOBAL_INT: "sea",
    mav.MAV_FRAME_GLOBAL_RELATIVE_ALT: "home",
    mav.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT: "home",
    mav.MAV_FRAME_GLOBAL_TERRAIN_ALT: "terrain",
    mav.MAV_FRAME_GLOBAL_TERRAIN_ALT_INT: "terrain",
}
"""Frames with latitude and longitude, and what their heights are above."""
LOCAL = frozenset(
    {
        mav.MAV_FRAME_LOCAL_NED,
        mav.MAV_FRAME_LOCAL_ENU,
        mav.MAV_FRAME_LOCAL_OFFSET_NED,
        mav.MAV_FRAME_BODY_NED,
        mav.MAV_FRAME_BODY_OFFSET_NED,
        mav.MAV_FRAME_BODY_FRD,
        mav.MAV_FRAME_LOCAL_FRD,
        mav.MAV_FRAME_LOCAL_FLU,
    }
)
"""Frames in metres; all but the first two begin at the vehicle, wherever that is."""
FENCE_COMMANDS = range(mav.MAV_CMD_NAV_FENCE_RETURN_POINT, mav.MAV_CMD_NAV_RALLY_POINT)
_POLYGONS = {
    mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION: True,
    mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION: False,
}
_CIRCLES = {mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION: True, mav.MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION: False}


class ItemError(ValueError):
    """An item that does not fit; `index` is its place in the list, the text a sentence without an end."""

    def __init__(self, index: int, message: str) -> None:
        super().__init__(message)
        self.index = index


class GlobalPlace(NamedTuple):
    """A place on earth; the height is NaN where none is given."""

    lat_deg: float
    lon_deg: float
    height_m: float
    above: Above


class LocalPlace(NamedTuple):
    """A place in the vehicle's own local frame, m."""

    p_ned: tuple[float, float, float]


class MissionItem(NamedTuple):
    """One item: MAV_CMD, MAV_FRAME and the seven parameters, in the units that the command gives them.

    Parameters 5 and 6 are degrees in global frames and metres in local ones, 7 is metres. NaN: not given.
    """

    command: int
    frame: int
    params: Params
    autocontinue: bool = True
    current: bool = False

    @property
    def name(self) -> str:
        """`NAV_WAYPOINT`; `command 31010` for one that the dialect lacks."""
        return mav.command_name(self.command)

    @property
    def frame_name(self) -> str:
        """`GLOBAL_RELATIVE_ALT`; `frame 30` for one that the dialect lacks."""
        return mav.ENUMS["MAV_FRAME"].get(self.frame, f"frame {self.frame}").removeprefix("MAV_FRAME_")

    @property
    def about(self) -> str:
        """Parameters that are given and not 0, by the dialect's names: `Hold 5, Accept Radius 2`."""
        known = mav.COMMANDS.get(self.command)
        named = known.labels if known else {}
        shown = range(4 if self.place is not None else 7)
        given = [(named.get(k + 1, f"p{k + 1}"), self.params[k]) for k in shown]
        return ", ".join(f"{name} {value:.9g}" for name, value in given if value and not math.isnan(value))

    @property
    def flown(self) -> bool:
        """Whether the vehicle flies there: a region of interest has a place, and is looked at."""
        return self.name.startswith("NAV_") or self.command == mav.MAV_CMD_CONDITION_CHANGE_ALT

    @property
    def place(self) -> GlobalPlace | LocalPlace | None:
        """Its place; None for a command without one, for 0, 0 and NaN (wherever the vehicle is then), and in frames
        that begin at the vehicle."""
        x, y, z = self.params[4:]
        known = mav.COMMANDS.get(self.command)
        if (known and not known.has_place) or math.isnan(x) or math.isnan(y):
            return None
        if self.frame in GLOBAL:
            return None if x == y == 0.0 else GlobalPlace(x, y, z, GLOBAL[self.frame])
        if self.frame == mav.MAV_FRAME_LOCAL_NED:
            return LocalPlace((x, y, z))
        if self.frame == mav.MAV_FRAME_LOCAL_ENU:
            return LocalPlace((y, x, -z))
        return None


class FenceArea(NamedTuple):
    """A polygon, or with a radius the circle around its only corner."""

    inclusion: bool
    corners_deg: tuple[LatLon, ...]
    radius_m: float | None = None


class MissionPlan(NamedTuple):
    """Mission, fence and rally points of a file, or of a vehicle. `left_out`: parts not understood, a phrase each."""

    mission: tuple[MissionItem, ...] = ()
    """without the home that ArduPilot counts as item 0"""
    fence: tuple[FenceArea, ...] = ()
    rally: tuple[GlobalPlace, ...] = ()
    home: GlobalPlace | None = None
    fence_return: LatLon | None = None
    """place where a vehicle goes that has left the fence"""
    first: int = 1
    """number of the first item, by which DO_JUMP counts"""
    left_out: tuple[str, ...] = ()

    @property
    def empty(self) -> bool:
        """Whether there is nothing in it."""
        return not (self.mission or self.fence or self.rally or self.left_out)


def sorted_out(items: Sequence[MissionItem], *, has_home: bool) -> MissionPlan:
    """Items of any kind as a plan; `has_home`: a way point at the beginning is home. Raises ItemError."""
    mission: list[MissionItem] = []
    fence: list[tuple[int, MissionItem]] = []
    rally: list[GlobalPlace] = []
    home = None
    for index, item in enumerate(items):
        place = item.place
        if isinstance(place, GlobalPlace):
            check_place(index, place.lat_deg, place.lon_deg)
        if index == 0 and has_home and item.command == mav.MAV_CMD_NAV_WAYPOINT and item.frame in GLOBAL:
            home = place if isinstance(place, GlobalPlace) else None
            continue
        if item.command in FENCE_COMMANDS:
            fence.append((index, item))
        elif item.command == mav.MAV_CMD_NAV_RALLY_POINT:
            if not isinstance(place, GlobalPlace):
                raise ItemError(index, f"a rally point has no place in {item.frame_name}")
            rally.append(place)
        else:
            mission.append(item)
    first = len(items) - len(mission) if not fence and not rally else 0
    left_out = tuple(
        f"{item.name} is no fence item that is known here" for _, item in fence if item.command not in _KNOWN
    )
    areas = tuple(_areas([(index, item) for index, item in fence if item.command in _POLYGONS | _CIRCLES]))
    returns = [item for _, item in fence if item.command == mav.MAV_CMD_NAV_FENCE_RETURN_POINT]
    fence_return = (returns[-1].params[4], returns[-1].params[5]) if returns else None
    return MissionPlan(tuple(mission), areas, tuple(rally), home, fence_return, first, left_out)


_KNOWN = {*_POLYGONS, *_CIRCLES, mav.MAV_CMD_NAV_FENCE_RETURN_POINT}


def check_place(index: int, lat_deg: float, lon_deg: float) -> None:
    """Raises ItemError where these are no latitude and longitude."""
    if not (abs(lat_deg) <= 90.0 and abs(lon_deg) <= 180.0):
        raise ItemError(index, f"{lat_deg:.9g}, {lon_deg:.9g} are no latitude and longitude in degrees")


def _areas(items: Sequence[tuple[int, MissionItem]]) -> Iterator[FenceArea]:
    """Circles, and polygons by the number of corners that each of their corners tells."""
    corners: list[LatLon] = []
    for k, (index, item) in enumerate(items):
        size, at = item.params[0], (item.params[4], item.params[5])
        if not isinstance(item.place, GlobalPlace):
            raise ItemError(index, f"{item.name} has no latitude and longitude")
        if item.command in _CIRCLES:
            if not 0.0 < size < math.inf:
                raise ItemError(index, f"a circle's radius is {size:g} m")
            yield FenceArea(_CIRCLES[item.command], (at,), size)
            continue
        if not (size >= 3.0 and size.is_integer()):
            raise ItemError(index, f"a polygon has {size:g} corners, not 3 or more")
        corners.append(at)
        if len(corners) == size:
            yield FenceArea(_POLYGONS[item.command], tuple(corners))
            corners = []
            continue
        following = items[k + 1][1] if k + 1 < len(items) else None
        if following is None or (following.command, following.params[0]) != (item.command, size):
            raise ItemError(index, f"a polygon of {size:g} corners ends after {len(corners)}")


def fence_items(plan: MissionPlan) -> list[MissionItem]:
    """The fence as mission items."""

    def item(command: int, size: float, at: LatLon) -> MissionItem:
        return MissionItem(command, mav.MAV_FRAME_GLOBAL, (size, 0.0, 0.0, 0.0, *at, 0.0), autocontinue=False)

    items = [item(mav.MAV_CMD_NAV_FENCE_RETURN_POINT, 0.0, plan.fence_return)] if plan.fence_return else []
    for area in plan.fence:
        kinds = _POLYGONS if area.radius_m is None else _CIRCLES
        command = next(one for one, inclusion in kinds.items() if inclusion == area.inclusion)
        size = float(len(area.corners_deg)) if area.radius_m is None else area.radius_m
        items += [item(command, size, at) for at in area.corners_deg]
    return items


def rally_items(plan: MissionPlan) -> list[MissionItem]:
    """The rally points as mission items."""
    frames = {above: frame for frame, above in reversed(GLOBAL.items())}
    return [
        MissionItem(
            mav.MAV_CMD_NAV_RALLY_POINT,
            frames[point.above],
            (0.0, 0.0, 0.0, 0.0, *point[:3]),
            autocontinue=False,
        )
        for point in plan.rally
    ]


def numbered(plan: MissionPlan, first: int) -> MissionPlan:
    """The plan with this number for its first item, by which its jumps count."""
    shift = first - plan.first
    mission = tuple(
        item._replace(params=(item.params[0] + shift, *item.params[1:]))
        if item.command == mav.MAV_CMD_DO_JUMP
        else item
        for item in plan.mission
    )
    return plan._replace(mission=mission, first=first)


def mission_items(plan: MissionPlan) -> list[MissionItem]:
    """The mission as items with home as the first one, as ArduPilot counts them; zeros where home is not known."""
    at = plan.home or GlobalPlace(0.0, 0.0, 0.0, "sea")
    home = MissionItem(mav.MAV_CMD_NAV_WAYPOINT, mav.MAV_FRAME_GLOBAL, (0.0, 0.0, 0.0, 0.0, *at[:3]))
    return [home, *numbered(plan, 1).mission]


def joined(plans: Iterable[MissionPlan]) -> MissionPlan:
    """Plans of one vehicle, each of which has another part, as one."""
    whole = MissionPlan()
    for plan in plans:
        whole = MissionPlan(
            whole.mission + plan.mission,
            whole.fence + plan.fence,
            whole.rally + plan.rally,
            whole.home or plan.home,
            whole.fence_return or plan.fence_return,
            plan.first if plan.mission else whole.first,
            whole.left_out + plan.left_out,
        )
    return whole
