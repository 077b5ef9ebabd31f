"""QGroundControl's .plan: mission, geofence and rally points as JSON.

https://docs.qgroundcontrol.com/master/en/qgc-dev-guide/file_formats/plan.html. A complex item gives the items that the
file carries of it (TransectStyleComplexItem, of surveys and corridor scans); what QGroundControl makes anew whenever it
opens the file, as a landing pattern, is not in it and is named.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from typing import Annotated, Any

import msgspec
from msgspec import Meta, Struct, field

from gcs.missions.errors import MissionFileError
from gcs.missions.items import (
    FENCE_COMMANDS,
    FenceArea,
    GlobalPlace,
    ItemError,
    MissionItem,
    MissionPlan,
    Params,
    check_place,
    numbered,
)

FILE_TYPE, VERSION, MISSION_VERSION = "Plan", 1, 2
_BOM = b"\xef\xbb\xbf"
_PLACE = re.compile(r" - at `\$\.?(?P<path>[^`]*)`$")
_BYTE = re.compile(r" \(byte (?P<byte>\d+)\)$")

Number = float | None
Word = Annotated[int, Meta(ge=0, le=65535)]
Octet = Annotated[int, Meta(ge=0, le=255)]
Point = Annotated[list[Number], Meta(min_length=2, max_length=3)]


class _SimpleItem(Struct, tag_field="type", tag="SimpleItem", rename="camel"):
    command: Word
    params: Annotated[list[Number], Meta(min_length=4, max_length=7)]
    frame: Octet
    auto_continue: bool = True
    coordinate: Point | None = None
    """beside four parameters, as files of before 2017 have it"""


class _Transect(Struct):
    items: list[_SimpleItem] | None = field(name="Items", default=None)


class _ComplexItem(Struct, tag_field="type", tag="ComplexItem", rename="camel"):
    complex_item_type: str = "complex item"
    transect: _Transect | None = field(name="TransectStyleComplexItem", default=None)


class _Mission(Struct, rename="camel"):
    items: list[_SimpleItem | _ComplexItem] = []
    planned_home_position: Point | None = None
    version: int = MISSION_VERSION


class _Ring(Struct):
    center: Point
    radius: float


class _Circle(Struct):
    circle: _Ring
    inclusion: bool = True


class _Polygon(Struct):
    polygon: Annotated[list[Point], Meta(min_length=3)]
    inclusion: bool = True


class _GeoFence(Struct, rename="camel"):
    circles: list[_Circle] = []
    polygons: list[_Polygon] = []
    polygon: list[Point] = []
    """the only one, of version 1"""
    breach_return: Annotated[list[Number], Meta(max_length=3)] | None = None


class _RallyPoints(Struct):
    points: list[Point] = []


class _PlanFile(Struct, rename="camel"):
    file_type: str
    version: int
    mission: _Mission | None = None
    geo_fence: _GeoFence | None = None
    rally_points: _RallyPoints | None = None


_DECODER = msgspec.json.Decoder(_PlanFile)


def read(content: bytes, file: str) -> MissionPlan:
    """The plan in a file. Raises MissionFileError."""
    content = content.removeprefix(_BOM)
    try:
        found = _DECODER.decode(content)
    except msgspec.ValidationError as error:
        raise MissionFileError(f"{file}: {_sentence(str(error))}.") from None
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        raise MissionFileError(f"{file}: {_syntax(str(error), content)}.") from None
    mission, fence = found.mission or _Mission(), found.geo_fence or _GeoFence()
    if found.file_type != FILE_TYPE:
        raise MissionFileError(f"{file}: fileType is {found.file_type[:40]!r}, not {FILE_TYPE!r}.")
    for name, version, known in (("version", found.version, VERSION), ("mission.version", mission.version, 2)):
        if version != known:
            raise MissionFileError(f"{file}: {name} is {version}, and only {known} is read.")
    left_out: list[str] = []
    items = tuple(_items(mission, file, left_out))
    home = None
    if (at := mission.planned_home_position) is not None and any(value != 0.0 for value in at):
        home = GlobalPlace(*_place(at, f"{file}: mission.plannedHomePosition"), "sea")
    rally = enumerate((found.rally_points or _RallyPoints()).points)
    back = fence.breach_return or None
    return MissionPlan(
        mission=items,
        fence=tuple(_areas(fence, file)),
        rally=tuple(GlobalPlace(*_place(at, f"{file}: rallyPoints.points[{k}]"), "home") for k, at in rally),
        home=home,
        fence_return=None if back is None else _place(back, f"{file}: geoFence.breachReturn")[:2],
        left_out=tuple(left_out),
    )


def _items(mission: _Mission, file: str, left_out: list[str]) -> Iterator[MissionItem]:
    for k, one in enumerate(mission.items):
        where = f"mission.items[{k}]"
        if isinstance(one, _SimpleItem):
            yield _item(one, f"{file}: {where}")
        elif one.transect is not None and one.transect.items is not None:
            inner = f"{file}: {where}.TransectStyleComplexItem.Items"
            yield from (_item(part, f"{inner}[{i}]") for i, part in enumerate(one.transect.items))
        else:
            what = f"{where}: a {one.complex_item_type[:40]}, whose items QGroundControl makes when it opens the file"
            left_out.append(what)


def _item(one: _SimpleItem, where: str) -> MissionItem:
    params = [math.nan if value is None else value for value in one.params]
    if len(params) == 4 and one.coordinate is not None:
        params += [math.nan if value is None else value for value in one.coordinate]
    params += [math.nan] * (7 - len(params))
    p1, p2, p3, p4, x, y, z = params
    item = MissionItem(one.command, one.frame, (p1, p2, p3, p4, x, y, z), autocontinue=one.auto_continue)
    if item.command in FENCE_COMMANDS:
        raise MissionFileError(f"{where}: {item.name} stands in the mission; a plan's fence is its geoFence.")
    if isinstance(place := item.place, GlobalPlace):
        _checked(where, place.lat_deg, place.lon_deg)
    return item


def _areas(fence: _GeoFence, file: str) -> Iterator[FenceArea]:
    if fence.polygon:
        corners = [_place(at, f"{file}: geoFence.polygon[{i}]")[:2] for i, at in enumerate(fence.polygon)]
        if len(corners) < 3:
            raise MissionFileError(f"{file}: geoFence.polygon: a polygon has {len(corners)} corners, not 3 or more.")
        yield FenceArea(inclusion=True, corners_deg=tuple(corners))
    for k, one in enumerate(fence.polygons):
        where = f"{file}: geoFence.polygons[{k}].polygon"
        corners = [_place(at, f"{where}[{i}]")[:2] for i, at in enumerate(one.polygon)]
        yield FenceArea(one.inclusion, tuple(corners))
    for k, circle in enumerate(fence.circles):
        where = f"{file}: geoFence.circles[{k}].circle"
        if not 0.0 < circle.circle.radius < math.inf:
            raise MissionFileError(f"{where}.radius: a circle's radius is {circle.circle.radius:g} m.")
        yield FenceArea(circle.inclusion, (_place(circle.circle.center, f"{where}.center")[:2],), circle.circle.radius)


def _place(at: list[Number], where: str) -> tuple[float, float, float]:
    lat_deg, lon_deg, height_m = (math.nan if value is None else value for value in [*at, None][:3])
    _checked(where, lat_deg, lon_deg)
    return lat_deg, lon_deg, height_m


def _checked(where: str, lat_deg: float, lon_deg: float) -> None:
    try:
        check_place(0, lat_deg, lon_deg)
    except ItemError as error:
        raise MissionFileError(f"{where}: {error}.") from None


def _sentence(error: str) -> str:
    """msgspec's words with the place first: `mission.items[0].params[2]: expected a number, got str`."""
    found = _PLACE.search(error)
    path = "" if found is None else f"{found['path']}: "
    text = _PLACE.sub("", error).replace("`", "")
    return path + text[:1].lower() + text[1:]


def _syntax(error: str, content: bytes) -> str:
    found = _BYTE.search(error)
    if found is None:
        return "the JSON ends too early" if "truncated" in error else f"the JSON cannot be read: {error}"
    before = content[: int(found["byte"])]
    line, column = before.count(b"\n") + 1, len(before) - before.rfind(b"\n")
    return f"line {line}, column {column}: {_BYTE.sub('', error)}"


def write(
    plan: MissionPlan, *, autopilot: int = 0, vehicle_type: int = 0, home_deg_m: tuple[float, ...] = (0.0, 0.0, 0.0)
) -> str:
    """The plan as a file's text.

    autopilot, vehicle_type: MAV_AUTOPILOT and MAV_TYPE of which the vehicle is; 0 is generic. home_deg_m: where the
    plan has no home: QGroundControl opens no file without one, and zeros are read as a home that is not known.
    """
    return json.dumps(_written(plan, autopilot, vehicle_type, home_deg_m), indent=4) + "\n"


def _written(plan: MissionPlan, autopilot: int, vehicle_type: int, home_deg_m: tuple[float, ...]) -> dict[str, Any]:
    items = [
        {
            "autoContinue": item.autocontinue,
            "command": item.command,
            "doJumpId": k,
            "frame": item.frame,
            "params": _listed(item.params),
            "type": "SimpleItem",
        }
        for k, item in enumerate(numbered(plan, 1).mission, 1)
    ]
    areas: dict[bool, list[Any]] = {False: [], True: []}
    for area in plan.fence:
        round_one = area.radius_m is not None
        shape: Any = list(map(list, area.corners_deg))
        shape = {"center": shape[0], "radius": area.radius_m} if round_one else shape
        areas[round_one].append(
            {"circle" if round_one else "polygon": shape, "inclusion": area.inclusion, "version": 1}
        )
    fence = {"circles": areas[True], "polygons": areas[False], "version": 2}
    if plan.fence_return is not None:
        fence["breachReturn"] = [*plan.fence_return, 0.0]
    return {
        "fileType": FILE_TYPE,
        "geoFence": fence,
        "groundStation": "Skytender",
        "mission": {
            "cruiseSpeed": 15,
            "firmwareType": autopilot,
            "globalPlanAltitudeMode": 1,
            "hoverSpeed": 5,
            "items": items,
            "plannedHomePosition": _listed(plan.home[:3] if plan.home else home_deg_m),
            "vehicleType": vehicle_type,
            "version": MISSION_VERSION,
        },
        "rallyPoints": {"points": [_listed(point[:3]) for point in plan.rally], "version": 2},
        "version": VERSION,
    }


def _listed(numbers: Params | tuple[float, ...]) -> list[Number]:
    return [None if math.isnan(value) else value for value in numbers]
