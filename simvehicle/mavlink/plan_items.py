"""Meaning of the items of a mission, a geofence and a list of rally points: MAVLink's items in, legs, areas, places
out.

An item that cannot be flown as it stands is refused by raising PlanError with the result that MISSION_ACK then reports;
nothing is left out in silence.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.geofence import Circle, Fence, Point, Polygon
from simvehicle.autopilot.mission import Kind, Leg, Place
from simvehicle.mavlink.commands import RELATIVE_FRAMES
from skytender import elementary
from skytender import mavlink as mav

Vec3 = tuple[float, float, float]
MOST_ITEMS = 1000
"""A plan of more items is refused: NO_SPACE."""


class PlanError(ValueError):
    """An item that cannot be taken; `result` is a MAV_MISSION_RESULT."""

    def __init__(self, text: str, result: int) -> None:
        super().__init__(text)
        self.result = result


class Item(NamedTuple):
    """One item as the wire carries it: x and y in degE7, or 1e-4 m in local frames; z in m."""

    command: int
    frame: int
    params: tuple[float, float, float, float]
    x: int
    y: int
    z: float
    autocontinue: int = 1


def row_of(item: Item) -> tuple[float, ...]:
    """An item as ten plain numbers, for storage."""
    return (item.command, item.frame, *item.params, item.x, item.y, item.z, item.autocontinue)


def item_of(row: Sequence[float]) -> Item:
    """The item that `row_of` made these numbers of."""
    command, frame, first, second, third, fourth, x, y, z, autocontinue = row
    params = (first, second, third, fourth)
    return Item(int(command), int(frame), params, int(x), int(y), z, int(autocontinue))


def item_from(content: Any) -> Item:
    """The item in a MISSION_ITEM_INT, or in a MISSION_ITEM, whose places are floats."""
    x, y = content.x, content.y
    if isinstance(x, float) or isinstance(y, float):
        scale = 1e4 if content.frame in _LOCAL else 1e7
        if not (abs(x) * scale < _UNSET and abs(y) * scale < _UNSET):
            raise PlanError("an item's place is no number", mav.MAV_MISSION_INVALID_PARAM5_X)
        x, y = round(x * scale), round(y * scale)
    params = (content.param1, content.param2, content.param3, content.param4)
    return Item(content.command, content.frame, params, x, y, content.z, content.autocontinue)


def legs_from(items: Sequence[Item], frame: LocalFrame, *, home_down_m: float, item_0_is_home: bool) -> tuple[Leg, ...]:
    """The legs of a mission, one per item, for a vehicle whose home is there; raises PlanError."""
    return tuple(
        Leg(Kind.HOME) if number == 0 and item_0_is_home else _leg(number, item, frame, home_down_m)
        for number, item in enumerate(items)
    )


def fence_from(items: Sequence[Item], frame: LocalFrame) -> Fence:
    """The areas of a geofence; the corners of a polygon follow each other and each carry their number (param1)."""
    inside: list[Circle | Polygon] = []
    outside: list[Circle | Polygon] = []
    at = 0
    while at < len(items):
        item, more, size = items[at], 1, _size(at, items[at])
        if item.command in _CIRCLES:
            area: Circle | Polygon = Circle(_point(at, item, frame), size)
        else:
            more = int(size)
            corners = items[at : at + more]
            if len(corners) < more or any(c.command != item.command or c.params[0] != item.params[0] for c in corners):
                raise PlanError(f"item {at}: a polygon of {more} corners needs them all", mav.MAV_MISSION_INVALID)
            area = Polygon(tuple(_point(at + i, corner, frame) for i, corner in enumerate(corners)))
        (inside if item.command in _INCLUSIONS else outside).append(area)
        at += more
    return Fence(tuple(inside), tuple(outside))


def rally_from(items: Sequence[Item], frame: LocalFrame) -> tuple[Vec3, ...]:
    """Rally points in the local frame; their height is not used, because a return has its own."""
    return tuple(_rally_point(number, item, frame) for number, item in enumerate(items))


def check_item(
    kind: int, number: int, item: Item, frame: LocalFrame, *, home_down_m: float, item_0_is_home: bool
) -> None:
    """Raise PlanError for an item that no plan of this kind (MAV_MISSION_TYPE) can have, whatever comes after it."""
    if kind == mav.MAV_MISSION_TYPE_FENCE:
        _size(number, item)
        _point(number, item, frame)
    elif kind == mav.MAV_MISSION_TYPE_RALLY:
        _rally_point(number, item, frame)
    elif number or not item_0_is_home:
        _leg(number, item, frame, home_down_m)


def _size(number: int, item: Item) -> float:
    """Radius of a fence's circle (m), or how many corners a polygon has."""
    if item.command in _CIRCLES:
        return _number(item.params[0], number, mav.MAV_MISSION_INVALID_PARAM1, least=0.1)
    if item.command in _POLYGONS:
        return _number(item.params[0], number, mav.MAV_MISSION_INVALID_PARAM1, least=3.0)
    if item.command == mav.MAV_CMD_NAV_FENCE_RETURN_POINT:
        raise PlanError(f"item {number}: no return point; GF_ACTION says what happens", mav.MAV_MISSION_UNSUPPORTED)
    raise PlanError(f"item {number}: command {item.command} is no fence", mav.MAV_MISSION_UNSUPPORTED)


def _rally_point(number: int, item: Item, frame: LocalFrame) -> Vec3:
    if item.command != mav.MAV_CMD_NAV_RALLY_POINT:
        raise PlanError(f"item {number}: command {item.command} is no rally point", mav.MAV_MISSION_UNSUPPORTED)
    return (*_point(number, item, frame), 0.0)


def too_low(above_home_m: float) -> bool:
    """Whether no vehicle flies at a height; a millimetre is what a float above the sea is rounded by."""
    return round(above_home_m, 3) < LEAST_HEIGHT_M


def _leg(number: int, item: Item, frame: LocalFrame, home_down_m: float) -> Leg:
    kind = _KINDS.get(item.command)
    if kind is None:
        raise PlanError(f"item {number}: command {item.command} cannot be flown", mav.MAV_MISSION_UNSUPPORTED)
    hold_s = radius_m = speed_m_s = None
    if kind is Kind.SPEED:
        if _number(item.params[0], number, mav.MAV_MISSION_INVALID_PARAM1, least=0.0) not in _SPEEDS:
            raise PlanError(f"item {number}: speed of type {item.params[0]:g}", mav.MAV_MISSION_INVALID_PARAM1)
        speed_m_s = -1.0 if math.isnan(item.params[1]) else item.params[1]
        if speed_m_s == _NO_CHANGE:
            return Leg(Kind.WAIT)
        if not (0.0 < speed_m_s < 1e6 or speed_m_s == _OWN_SPEED):
            raise PlanError(f"item {number}: a speed of {speed_m_s:g} m/s", mav.MAV_MISSION_INVALID_PARAM2)
        return Leg(kind, speed_m_s=speed_m_s if speed_m_s > 0.0 else None)
    if kind is Kind.WAIT:
        return Leg(kind, hold_s=_number(item.params[0], number, mav.MAV_MISSION_INVALID_PARAM1, least=0.0))
    if kind is Kind.RETURN:
        return Leg(kind)
    place = _place(number, item, frame, may_lack_place=kind in (Kind.TAKEOFF, Kind.LAND))
    if place.height_m is not None and kind is not Kind.LAND:
        above_home_m = place.height_m + (0.0 if place.above_home else home_down_m)
        if too_low(above_home_m):
            raise PlanError(f"item {number}: {above_home_m:g} m above home", mav.MAV_MISSION_INVALID_PARAM7)
    if item.command in (mav.MAV_CMD_NAV_WAYPOINT, mav.MAV_CMD_NAV_LOITER_TIME):
        hold_s = _number(item.params[0], number, mav.MAV_MISSION_INVALID_PARAM1, least=0.0)
    if item.command == mav.MAV_CMD_NAV_WAYPOINT:
        radius_m = _number(item.params[1], number, mav.MAV_MISSION_INVALID_PARAM2, least=0.0) or None
    return Leg(kind, place, hold_s or 0.0, radius_m)


def _place(number: int, item: Item, frame: LocalFrame, *, may_lack_place: bool) -> Place:
    _known_frame(number, item)
    height_m = None if math.isnan(item.z) else _number(item.z, number, mav.MAV_MISSION_INVALID_PARAM7, least=-1e4)
    if item.frame in _LOCAL:
        return Place(1e-4 * item.x, 1e-4 * item.y, None if height_m is None else -height_m)
    above_home = item.frame in RELATIVE_FRAMES
    if height_m is not None and not above_home:
        height_m -= frame.alt_m
    unset = (item.x, item.y) == (0, 0) or _UNSET in (item.x, item.y)
    if unset and may_lack_place:
        return Place(None, None, height_m, above_home)
    return Place(*_point(number, item, frame), height_m, above_home)


def _point(number: int, item: Item, frame: LocalFrame) -> Point:
    _known_frame(number, item)
    if item.frame in _LOCAL:
        return 1e-4 * item.x, 1e-4 * item.y
    lat_deg, lon_deg = 1e-7 * item.x, 1e-7 * item.y
    if not abs(lat_deg) <= 90.0:
        raise PlanError(f"item {number}: latitude {lat_deg:g}", mav.MAV_MISSION_INVALID_PARAM5_X)
    if not abs(lon_deg) <= 180.0:
        raise PlanError(f"item {number}: longitude {lon_deg:g}", mav.MAV_MISSION_INVALID_PARAM6_Y)
    north, east, _ = frame.to_local(lat_deg, lon_deg, 0.0)
    if elementary.hypot(north, east) > FARTHEST_M:
        raise PlanError(f"item {number}: farther away than {FARTHEST_M / 1e3:g} km", mav.MAV_MISSION_INVALID_PARAM5_X)
    return north, east


def _known_frame(number: int, item: Item) -> None:
    if item.frame not in _GLOBAL | RELATIVE_FRAMES | _LOCAL:
        raise PlanError(f"item {number}: frame {item.frame}", mav.MAV_MISSION_UNSUPPORTED_FRAME)


def _number(value: float, number: int, result: int, *, least: float) -> float:
    """A parameter; NaN is what the sender left unset: 0."""
    value = 0.0 if math.isnan(value) else value
    if not least <= value < 1e6:
        raise PlanError(f"item {number}: {value:g} is outside {least:g} .. 1e6", result)
    return value


LEAST_HEIGHT_M = 0.3
"""[choice] No vehicle flies lower above home."""
_SPEEDS = (0.0, 1.0)
"""SPEED_TYPE: airspeed and ground speed, which are one."""
_NO_CHANGE, _OWN_SPEED = -1.0, -2.0
FARTHEST_M = 1e5
_UNSET = 2**31 - 1
_LOCAL = frozenset({mav.MAV_FRAME_LOCAL_NED})
_GLOBAL = frozenset({mav.MAV_FRAME_GLOBAL, mav.MAV_FRAME_GLOBAL_INT})
_KINDS = {
    mav.MAV_CMD_NAV_TAKEOFF: Kind.TAKEOFF,
    mav.MAV_CMD_NAV_WAYPOINT: Kind.WAYPOINT,
    mav.MAV_CMD_NAV_LOITER_TIME: Kind.WAYPOINT,
    mav.MAV_CMD_NAV_LOITER_UNLIM: Kind.STAY,
    mav.MAV_CMD_NAV_DELAY: Kind.WAIT,
    mav.MAV_CMD_DO_CHANGE_SPEED: Kind.SPEED,
    mav.MAV_CMD_NAV_RETURN_TO_LAUNCH: Kind.RETURN,
    mav.MAV_CMD_NAV_LAND: Kind.LAND,
}
_CIRCLES = frozenset({mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION, mav.MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION})
_POLYGONS = frozenset({mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION, mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION})
_INCLUSIONS = frozenset({mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION, mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION})
