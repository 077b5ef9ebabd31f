"""The fleet from above, north up: vehicles with heading and trail, what they aim at, obstacles, rendezvous."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gcs.console.drawing.canvas import Canvas, Point
from gcs.console.model import SessionModel, Vehicle, severity
from gcs.console.text import Glyphs, StyledLines
from gcs.session.plain_text import clean

ZOOM = 1.25
PAN = 0.2
LEAST_M_PER_DOT, MOST_M_PER_DOT = 0.005, 500.0
STILL_M_S = 0.1
_ARROWS = "↑↗→↘↓↙←↖"
_ASCII_ARROWS = "^^>vvv<^"
_TROUBLED = {1: "look", 2: "act"}
GRID, PATH, TRAIL, AIM, WALL, LABEL, MARK, CRAFT, CHOSEN = range(9)


@dataclass
class MapView:
    """Which part of the plane is shown; `fit` shows everything, `follow` keeps one vehicle in the middle."""

    centre_ne: tuple[float, float] = (0.0, 0.0)
    m_per_dot: float = 0.0
    fit: bool = True
    follow: int | None = None

    def zoom(self, steps: int) -> None:
        """Nearer for positive steps."""
        self.fit = False
        self.m_per_dot = min(max(self.m_per_dot * ZOOM**-steps, LEAST_M_PER_DOT), MOST_M_PER_DOT)

    def pan(self, north: int, east: int, canvas_dots: tuple[int, int]) -> None:
        """Move the window by a fifth of its size per step."""
        self.fit, self.follow = False, None
        width, height = canvas_dots
        n, e = self.centre_ne
        self.centre_ne = (n + north * PAN * height * self.m_per_dot, e + east * PAN * width * self.m_per_dot)

    def settle(self, watch: SessionModel, canvas: Canvas) -> None:
        """Take the window that `fit` or `follow` asks for. It moves in steps, so that the map does not jitter."""
        if self.fit or self.m_per_dot <= 0.0:
            self._fit(list(_extent(watch)), canvas)
        if self.follow is not None and (vehicle := watch.vehicles.get(self.follow)) and vehicle.get("p_ned"):
            n, e, _ = vehicle["p_ned"]
            step_m = 4.0 * self.m_per_dot
            self.centre_ne = (round(n / step_m) * step_m, round(e / step_m) * step_m)

    def _fit(self, points: Sequence[tuple[float, float]], canvas: Canvas) -> None:
        if not points:
            self.m_per_dot = self.m_per_dot or 0.1
            return
        norths, easts = [n for n, _ in points], [e for _, e in points]
        high, wide = max(norths) - min(norths), max(easts) - min(easts)
        needed = max(high / max(canvas.height - 12, 4), wide / max(canvas.width - 12, 4), 0.01)
        self.m_per_dot = ZOOM ** math.ceil(math.log(needed, ZOOM))
        step_m = 4.0 * self.m_per_dot
        north, east = (max(norths) + min(norths)) / 2.0, (max(easts) + min(easts)) / 2.0
        self.centre_ne = (round(north / step_m) * step_m, round(east / step_m) * step_m)


PLANS_WITHIN_M = 1e5
"""Of the origin: a plan farther off is not what the map is fitted to."""


def _extent(watch: SessionModel) -> Iterable[tuple[float, float]]:
    for vehicle in watch.vehicles.values():
        if vehicle.get("p_ned") is not None:
            yield vehicle["p_ned"][0], vehicle["p_ned"][1]
    for known in watch.known.values():
        yield from ((p[0], p[1]) for p in known.get("path_ned") or ())
    for obstacle in watch.session.get("obstacles") or ():
        yield from ((p[0], p[1]) for p in obstacle.get("outline_ne") or ())
    for base in watch.session.get("bases") or ():
        if base.get("p_ned"):
            yield base["p_ned"][0], base["p_ned"][1]
    for plan in watch.session.get("plans") or ():
        places = [*_way(plan), *plan["rally_ned"], *(p for area in plan["fence"] for p in area["outline_ne"])]
        yield from ((p[0], p[1]) for p in places if math.hypot(p[0], p[1]) < PLANS_WITHIN_M)


def _way(plan: Mapping[str, Any]) -> list[Any]:
    """Places (NED) where a plan's mission leads."""
    return [item["p_ned"] for item in plan["items"] if item["flown"] and item["p_ned"]]


def draw(
    watch: SessionModel, view: MapView, *, width: int, height: int, glyphs: Glyphs, chosen: int | None
) -> StyledLines:
    """The plan in `width` x `height` cells; `view` is settled on the way."""
    canvas = Canvas(width, height, glyphs)
    view.settle(watch, canvas)

    def at(n: float, e: float) -> Point:
        north, east = view.centre_ne
        return (
            canvas.width / 2.0 + (e - east) / view.m_per_dot,
            canvas.height / 2.0 - (n - north) / view.m_per_dot,
        )

    def cell(n: float, e: float) -> tuple[int, int]:
        x, y = at(n, e)
        return int(x // canvas.per_column), int(y // canvas.per_row)

    scale_m = _round_length(view.m_per_dot * canvas.per_column * max(width // 6, 8))
    _grid(canvas, view, at, scale_m)
    for known in watch.known.values():
        style = "path " + watch.style(int(known["sysid"]))
        canvas.path([at(p[0], p[1]) for p in known.get("path_ned") or ()], style, PATH, every=3)
    for obstacle in watch.session.get("obstacles") or ():
        _obstacle(canvas, obstacle, at, cell, glyphs)
    for base in watch.session.get("bases") or ():
        if base.get("p_ned"):
            column, row = cell(base["p_ned"][0], base["p_ned"][1])
            canvas.put(column, row, ("⌂" if glyphs.unicode else "B") + str(base.get("name") or ""), "base", MARK)
    for plan in watch.session.get("plans") or ():
        _plan(canvas, plan, watch, at, cell)
    for sysid, trail in watch.trails.items():
        canvas.path([at(n, e) for n, e in trail], f"trail {watch.style(sysid)}", TRAIL)
    for vehicle in watch.vehicles.values():
        aim, here = vehicle.get("aim_ned"), vehicle.get("p_ned")
        if aim is not None and here is not None and vehicle.get("alive", True):
            canvas.line(at(here[0], here[1]), at(aim[0], aim[1]), "aim", AIM, every=2)
    for service in watch.snapshot.get("services") or ():
        _rendezvous(canvas, service, watch, at, cell, glyphs)
    for craft in watch.snapshot.get("traffic") or ():
        if craft.get("p_ned"):
            column, row = cell(craft["p_ned"][0], craft["p_ned"][1])
            canvas.put(column, row, glyphs.traffic, "traffic", CRAFT)
    ranked = sorted(watch.vehicles.values(), key=lambda v: (v["sysid"] != chosen, -severity(v), v["sysid"]))
    seen = [vehicle for vehicle in ranked if vehicle.get("p_ned") is not None]
    for vehicle in reversed(seen):
        canvas.put(*cell(*vehicle["p_ned"][:2]), symbol(vehicle, glyphs), _style(watch, vehicle, chosen), CRAFT)
    for vehicle in seen:
        text = f"{vehicle['sysid']}{'!' if severity(vehicle) else ''}"
        anyway = vehicle["sysid"] == chosen
        _label(canvas, *cell(*vehicle["p_ned"][:2]), text, _style(watch, vehicle, chosen), anyway=anyway)
    for craft in watch.snapshot.get("traffic") or ():
        if craft.get("p_ned"):
            _label(canvas, *cell(*craft["p_ned"][:2]), clean(craft.get("callsign") or ""), "traffic")
    cells = max(1, round(scale_m / view.m_per_dot / canvas.per_column))
    ends, rule = ("├┤", "─") if glyphs.unicode else ("||", "-")
    canvas.put(1, height - 1, f"{ends[0]}{rule * (cells - 1)}{ends[1]} {scale_m:g} m", "scale", CHOSEN)
    canvas.put(width - 3, 0, "N" + glyphs.up, "scale", CHOSEN)
    return canvas.lines()


def _round_length(length_m: float) -> float:
    """The largest of 1, 2 and 5 times a power of ten that is no longer."""
    power = 10.0 ** math.floor(math.log10(length_m))
    return next(factor * power for factor in (5.0, 2.0, 1.0) if factor * power <= length_m * 1.0000001)


def _grid(canvas: Canvas, view: MapView, at: Any, step_m: float) -> None:
    north, east = view.centre_ne
    high, wide = canvas.height / 2.0 * view.m_per_dot, canvas.width / 2.0 * view.m_per_dot
    for i in range(math.ceil((north - high) / step_m), math.floor((north + high) / step_m) + 1):
        for j in range(math.ceil((east - wide) / step_m), math.floor((east + wide) / step_m) + 1):
            x, y = at(i * step_m, j * step_m)
            canvas.dot(x, y, "grid", GRID)


def _obstacle(canvas: Canvas, obstacle: Mapping[str, Any], at: Any, cell: Any, glyphs: Glyphs) -> None:
    outline = [at(p[0], p[1]) for p in obstacle.get("outline_ne") or ()]
    if outline:
        canvas.path([*outline, outline[0]], "obstacle", WALL)
    elif obstacle.get("centre_ned") and obstacle.get("kind") != "plane":
        column, row = cell(obstacle["centre_ned"][0], obstacle["centre_ned"][1])
        canvas.put(column, row, glyphs.wall, "obstacle", WALL)


def _plan(canvas: Canvas, plan: Mapping[str, Any], watch: SessionModel, at: Any, cell: Any) -> None:
    for area in plan["fence"]:
        canvas.path([at(*p) for p in area["outline_ne"]], "base" if area["inside"] else "obstacle", PATH, every=2)
    style = "aim" if plan["sysid"] is None else "path " + watch.style(int(plan["sysid"]))
    canvas.path([at(p[0], p[1]) for p in _way(plan)], style, PATH, every=3)
    for p in plan["rally_ned"]:
        column, row = cell(p[0], p[1])
        canvas.put(column, row, "R", "base", MARK)


def _rendezvous(
    canvas: Canvas, service: Mapping[str, Any], watch: SessionModel, at: Any, cell: Any, glyphs: Glyphs
) -> None:
    place = service.get("rendezvous_ned")
    tanker = watch.vehicles.get(service.get("tanker", -1))
    if place is None:
        return
    if tanker is not None and tanker.get("p_ned") is not None:
        canvas.line(at(*tanker["p_ned"][:2]), at(place[0], place[1]), "meet", AIM, every=2)
    column, row = cell(place[0], place[1])
    canvas.put(column, row, glyphs.meet, "meet", MARK)


def _style(watch: SessionModel, vehicle: Vehicle, chosen: int | None) -> str:
    style = _TROUBLED.get(severity(vehicle)) or f"craft {watch.style(vehicle['sysid'])}"
    return f"{style} chosen" if vehicle["sysid"] == chosen else style


def symbol(vehicle: Vehicle, glyphs: Glyphs) -> str:
    """An arrow into the direction of its nose; a dot where that is unknown, a cross for the dead."""
    if not vehicle.get("alive", True):
        return "✖" if glyphs.unicode else "x"
    heading, v_ned = vehicle.get("heading_rad"), vehicle.get("v_ned")
    if heading is None and v_ned is not None and math.hypot(v_ned[0], v_ned[1]) > STILL_M_S:
        heading = math.atan2(v_ned[1], v_ned[0])
    if heading is None:
        return glyphs.live
    return (_ARROWS if glyphs.unicode else _ASCII_ARROWS)[round(heading / (math.pi / 4.0)) % 8]


def _label(canvas: Canvas, column: int, row: int, text: str, style: str, *, anyway: bool = False) -> None:
    """Beside its symbol where it can be read, with nothing written next to it; nowhere if there is no such place."""
    length = len(text)
    for x, y, margin in (
        (column + 1, row, 0),
        (column - length, row, -1),
        (column, row - 1, -1),
        (column, row + 1, -1),
    ):
        if (
            text
            and canvas.free(x + margin, y, length + 1)
            and (margin == 0 or y == row or canvas.free(x, y, length + 1))
        ):
            canvas.put(x, y, text, style, LABEL)
            return
    if anyway:
        canvas.put(column + 1, row, text, style, CHOSEN)
