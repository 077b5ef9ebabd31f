"""A scenario's plan seen from above, as text for a terminal or as an image: what flies where, among what.

North is up and east to the right, in m of the common NED frame. Ground routes only: heights are in the legend.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from gcs.extras import require
from gcs.scenario.colours import LIGHT
from gcs.scenario.model import Obstacle, Scenario, Target, VehicleBase
from gcs.scenario.parts.mission import way_of

Point = tuple[float, ...]
Plane = tuple[float, float]
MARKS = {"pursuer": "P", "target": "T", "tanker": "K"}
ROUTE, OBSTACLE, TRAFFIC, COURSE, ATTRACTOR, BASE = ".", "#", "~", ":", "+", "B"
KEPT_IN, KEPT_OUT, RALLY = "=", "x", "R"
CELL_ASPECT = 2.0
"""A terminal's cell is about twice as high as wide."""
MARGIN_M = 1.0
INK, MOST_NAMED = "#1b1f24", 40


def legs(points: Sequence[Point], closed: bool) -> list[tuple[Point, Point]]:
    """The straight pieces of a route."""
    ends = [*points[1:], *points[:1]] if closed else points[1:]
    return list(zip(points, ends, strict=False))


def length_m(points: Sequence[Point], closed: bool) -> float:
    """Length of a route."""
    return sum(math.dist(a, b) for a, b in legs(points, closed))


def facts(scenario: Scenario) -> list[str]:
    """Summary of the scenario, a line each: vehicles with endurance, routes with their time, ranges."""
    lines = []
    for vehicle in scenario.vehicles.all:
        battery = vehicle.battery
        lasts_s = 0.01 * battery.initial_percent * battery.capacity_j / (battery.hover_w + battery.avionics_w)
        line = f"{MARKS[vehicle.role]} {vehicle.label}: starts at {_place(vehicle.start_m)}, hovers for {lasts_s:.0f} s"
        if vehicle.external is not None:
            line = f"{MARKS[vehicle.role]} {vehicle.label}: expected at {vehicle.external.where}, wherever it stands"
            if (first := drawn_at(vehicle)) is not None:
                line += f"; drawn at {_place(first)}, where it is sent first"
        if isinstance(vehicle, Target):
            way_m = 0.0 if vehicle.external else length_m([vehicle.start_m, vehicle.path_m[0]], False)
            way_m += vehicle.laps * length_m(vehicle.path_m, vehicle.closed)
            line += f"; its path is {way_m:.1f} m long, {way_m / vehicle.speed_m_s:.0f} s"
        lines.append(line)
    for base in scenario.bases:
        line = f"{BASE} base {base.name}: at {_place(base.position_m)}, holds {base.stock_j / 1e3:g} kJ"
        lines.append(f"{line} and gives {base.rate_w:g} W")
    for i, obstacle in enumerate(scenario.obstacles):
        name = obstacle.name or f"{obstacle.kind} {i + 1}"
        lines.append(f"{OBSTACLE} {name}: {_extent(obstacle)}")
    lines += [
        f"{TRAFFIC} traffic {m.callsign}: from {_place(m.path_m[0])}, {m.speed_m_s:g} m/s" for m in scenario.traffic
    ]
    rules = scenario.planner
    ring = f", ring {scenario.formation.ring_m:g} m" if scenario.formation.ring_m else ""
    lines.append(
        f"ranges: repulsion {rules.repulsion_range_m:g} m, separation {rules.separation_m:g} m{ring}, "
        f"capture {scenario.refuelling.capture_m:g} m"
    )
    return lines


def _place(p_ned: Point) -> str:
    return f"N {p_ned[0]:.1f} E {p_ned[1]:.1f}, {0.0 - p_ned[2]:.1f} m high"


def drawn_at(vehicle: VehicleBase) -> Point | None:
    """Place of a vehicle in the plan: an external one stands where it is sent first, for its start is unknown."""
    if vehicle.external is None:
        return vehicle.start_m
    firsts: list[Point] = [*getattr(vehicle, "path_m", ())[:1], *getattr(vehicle, "waypoints_m", ())[:1]]
    home: Point | None = getattr(vehicle, "home_m", None)
    return firsts[0] if firsts else home


def _drawn(scenario: Scenario) -> list[tuple[VehicleBase, Point]]:
    places = [(vehicle, drawn_at(vehicle)) for vehicle in scenario.vehicles.all]
    return [(vehicle, place) for vehicle, place in places if place is not None]


def _extent(shape: Obstacle) -> str:
    (n0, e0, d0), (n1, e1, d1) = shape.low_m, shape.high_m
    text = f"{shape.kind} at {_place(((n0 + n1) / 2, (e0 + e1) / 2, (d0 + d1) / 2))}"
    if shape.radius_m:
        text += f", radius {shape.radius_m:g} m"
    if shape.kind in ("box", "cylinder"):
        text += f", from {0.0 - d1:.1f} to {0.0 - d0:.1f} m high"
    return text


def _routes(scenario: Scenario) -> Iterator[tuple[str, Sequence[Point], bool]]:
    """(mark, points, closed) of everything that is to be flown."""
    for mover in scenario.traffic:
        yield TRAFFIC, mover.path_m, mover.closed
    for target in scenario.vehicles.targets:
        if target.external is None:
            yield ROUTE, (target.start_m, target.path_m[0]), False
        yield ROUTE, target.path_m, target.closed
    for pursuer in scenario.vehicles.pursuers:
        if way := pursuer.waypoints_m or tuple(way_of(pursuer, scenario)):
            yield COURSE, way if pursuer.external else (pursuer.start_m, *way), False


def _fence(scenario: Scenario) -> Iterator[tuple[str, Sequence[Point]]]:
    """(mark, border) of the areas to stay in and to stay out of."""
    for mark, areas in ((KEPT_IN, scenario.fence.inside), (KEPT_OUT, scenario.fence.outside)):
        for area in areas:
            yield mark, area.border_ned


def bounds(scenario: Scenario) -> tuple[Plane, Plane]:
    """((north, east) of the south-west corner, of the north-east corner) of everything, with a margin."""
    points: list[Point] = [place for _, place in _drawn(scenario)] or [(0.0, 0.0, 0.0)]
    points += [base.position_m for base in scenario.bases]
    points += [point for _, route, _ in _routes(scenario) for point in route]
    points += [attractor.point_m for attractor in scenario.attractors]
    points += [point for _, border in _fence(scenario) for point in border] + list(scenario.rally_m)
    for shape in scenario.obstacles:
        r = shape.radius_m
        points += [(shape.low_m[0] - r, shape.low_m[1] - r), (shape.high_m[0] + r, shape.high_m[1] + r)]
    north, east = [p[0] for p in points], [p[1] for p in points]
    return (min(north) - MARGIN_M, min(east) - MARGIN_M), (max(north) + MARGIN_M, max(east) + MARGIN_M)


def text(scenario: Scenario, columns: int = 78, rows: int = 30) -> list[str]:
    """The plan as lines of at most `columns` characters, with a scale below."""
    (south, west), (north, east) = bounds(scenario)
    metres = max((east - west) / (columns - 1), (north - south) / (rows - 1) / CELL_ASPECT)
    width, height = int((east - west) / metres) + 1, int((north - south) / metres / CELL_ASPECT) + 1
    cells = [[" "] * width for _ in range(height)]

    def put(n: float, e: float, mark: str) -> None:
        row, column = round((north - n) / metres / CELL_ASPECT), round((e - west) / metres)
        cells[min(max(row, 0), height - 1)][min(max(column, 0), width - 1)] = mark

    borders = [(mark, border, True) for mark, border in _fence(scenario)]
    for mark, route, closed in (*borders, *_routes(scenario)):
        for a, b in legs(route, closed):
            steps = max(int(math.dist(a, b) / metres), 1)
            for k in range(steps + 1):
                put(a[0] + (b[0] - a[0]) * k / steps, a[1] + (b[1] - a[1]) * k / steps, mark)
    for row in range(height):
        for column in range(width):
            n, e = north - row * metres * CELL_ASPECT, west + column * metres
            if any(_covers(shape, n, e) for shape in scenario.obstacles):
                cells[row][column] = OBSTACLE
    for shape in scenario.obstacles:
        put((shape.low_m[0] + shape.high_m[0]) / 2, (shape.low_m[1] + shape.high_m[1]) / 2, OBSTACLE)
    for attractor in scenario.attractors:
        put(attractor.point_m[0], attractor.point_m[1], ATTRACTOR)
    for base in scenario.bases:
        put(base.position_m[0], base.position_m[1], BASE)
    for north_m, east_m in scenario.rally_m:
        put(north_m, east_m, RALLY)
    for vehicle, place in _drawn(scenario):
        put(place[0], place[1], MARKS[vehicle.role])
    bar_m = 10.0 ** math.floor(math.log10(max(width * metres / 2.0, 1e-9)))
    bar = "-" * max(round(bar_m / metres) - 1, 1)
    return [*("".join(row).rstrip() for row in cells), "", f"|{bar}| {bar_m:g} m, north is up"]


def _covers(shape: Obstacle, n: float, e: float) -> bool:
    """Whether a solid lies above or below this place; its own radius is counted in `low_m`, `high_m` nowhere."""
    beyond_n = max(shape.low_m[0] - n, n - shape.high_m[0], 0.0)
    beyond_e = max(shape.low_m[1] - e, e - shape.high_m[1], 0.0)
    return math.hypot(beyond_n, beyond_e) <= shape.radius_m


def image(scenario: Scenario, path: Path) -> None:
    """Draw the plan to a file whose ending says the format: png, svg, pdf. Raises OSError, ValueError for others,
    MissingExtra without Matplotlib."""
    require("an image of a plan", {"matplotlib": "Matplotlib"}, "plots")
    from matplotlib.figure import Figure  # noqa: PLC0415 - only an image needs it, and it takes half a second

    figure = Figure(figsize=(8.0, 8.0), layout="constrained")
    axes: Any = figure.add_subplot()
    axes.set_title(f"{scenario.name}: {scenario.goal.duration_s:g} s")
    axes.set_xlabel("east (m)")
    axes.set_ylabel("north (m)")
    axes.set_aspect("equal")
    axes.grid(alpha=0.3)
    draw_surroundings(axes, scenario)
    place = {vehicle.sysid: at for at, vehicle in enumerate(scenario.vehicles.all)}
    drawn = _drawn(scenario)
    for role, marker in {"pursuer": "o", "target": "*", "tanker": "s"}.items():
        for external, filled, when in ((False, "full", "start"), (True, "none", "external, sent here first")):
            fleet = [(v, p) for v, p in drawn if v.role == role and (v.external is not None) == external]
            for vehicle, p in fleet:
                color = INK if role == "target" else LIGHT[place[vehicle.sysid] % len(LIGHT)]
                axes.plot(p[1], p[0], marker, color=color, fillstyle=filled, zorder=3)
                if len(drawn) <= MOST_NAMED or role != "pursuer":
                    name = vehicle.name or str(vehicle.sysid)
                    axes.annotate(name, (p[1], p[0]), (4, 4), textcoords="offset points", fontsize=8)
            if fleet:
                axes.plot([], [], marker, color="0.4", fillstyle=filled, linestyle="", label=f"{role} ({when})")
    for base in scenario.bases:
        north_m, east_m, _ = base.position_m
        _circle(axes, base.position_m, base.radius_m, fill=False, color="C5")
        axes.plot(east_m, north_m, "X", color="C5", label=f"base {base.name}")
        axes.annotate(base.name, (east_m, north_m), (4, 4), textcoords="offset points", fontsize=8)
    if scenario.formation.ring_m:
        for target in scenario.vehicles.targets:
            centre = target.path_m[0] if target.external else target.start_m
            _circle(axes, centre, scenario.formation.ring_m, fill=False, color="0.4", linestyle="--")
    for attractor in scenario.attractors:
        axes.plot(attractor.point_m[1], attractor.point_m[0], "P", color="C1")
        reach_m = attractor.range_m or scenario.planner.attraction_range_m
        _circle(axes, attractor.point_m, reach_m, fill=False, color="C1", linestyle=":")
    if scenario.obstacles:
        axes.plot([], [], "s", color="0.35", linestyle="", label="obstacle")
        axes.plot([], [], ":", color="0.7", label="repulsion's range")
    if scenario.formation.ring_m:
        axes.plot([], [], "--", color="0.4", label="ring")
    figure.legend(loc="outside lower center", ncols=4, fontsize=8)
    figure.savefig(path, dpi=150)


def draw_surroundings(axes: Any, scenario: Scenario) -> None:
    """Draw on axes of Matplotlib, east to the right, what stands or is to be flown: obstacles, fence, routes."""
    range_m = scenario.planner.repulsion_range_m
    for shape in scenario.obstacles:
        _draw_obstacle(axes, shape, 0.0, fill=True, color="0.35")
        _draw_obstacle(axes, shape, range_m, fill=False, color="0.7", linestyle=":")
    styles = {
        ROUTE: (INK, "--", "target's path"),
        COURSE: ("0.5", "-", "way points"),
        TRAFFIC: ("#b07300", ":", "traffic"),
    }
    labelled = set()
    for mark, border in _fence(scenario):
        color, label = ("#1a7f37", "fence: stay in") if mark == KEPT_IN else ("#b3261e", "fence: stay out")
        name = "" if label in labelled else label
        labelled.add(label)
        ring = [*border, border[0]]
        axes.plot([p[1] for p in ring], [p[0] for p in ring], "-.", color=color, linewidth=1.2, label=name or None)
    if scenario.rally_m:
        norths_m, easts_m = zip(*scenario.rally_m, strict=True)
        axes.plot(easts_m, norths_m, "v", color="#1a7f37", label="rally point")
    for mark, route, closed in _routes(scenario):
        points = [*route, *(route[:1] if closed else ())]
        color, style, label = styles[mark]
        name = "" if label in labelled else label
        labelled.add(label)
        axes.plot([p[1] for p in points], [p[0] for p in points], style, color=color, linewidth=1.0, label=name or None)


def _circle(axes: Any, p_ned: Sequence[float], radius_m: float, **style: Any) -> None:
    from matplotlib.patches import Circle  # noqa: PLC0415 - as above

    axes.add_patch(Circle((p_ned[1], p_ned[0]), radius_m, **style))


def _draw_obstacle(axes: Any, shape: Obstacle, beyond_m: float, **style: Any) -> None:
    from matplotlib.patches import Rectangle  # noqa: PLC0415 - as above

    if shape.kind == "box":
        (n0, e0, _), (n1, e1, _) = shape.low_m, shape.high_m
        size = (e1 - e0 + 2.0 * beyond_m, n1 - n0 + 2.0 * beyond_m)
        axes.add_patch(Rectangle((e0 - beyond_m, n0 - beyond_m), *size, **style))
    else:
        _circle(axes, shape.low_m, max(shape.radius_m + beyond_m, 0.08), **style)


def legend(marks: Iterable[str]) -> str:
    """Legend of the text plan's characters that occur in `marks`."""
    words = {
        "P": "pursuer",
        "T": "target",
        "K": "tanker",
        BASE: "base",
        ROUTE: "target's path",
        COURSE: "way points",
        OBSTACLE: "obstacle",
        TRAFFIC: "traffic",
        ATTRACTOR: "attractor",
        KEPT_IN: "fence to stay in",
        KEPT_OUT: "fence to stay out of",
        RALLY: "rally point",
    }
    present = set(marks)
    return ", ".join(f"{mark} {word}" for mark, word in words.items() if mark in present)
