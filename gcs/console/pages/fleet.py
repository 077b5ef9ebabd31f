"""The fleet as a table: as many columns as fit, vehicles with health issues first and always in sight."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from gcs.console.model import Vehicle, battery_share, issues, severity
from gcs.console.text import Glyphs, Span, StyledLine, StyledLines, bar, fitted, left, number, right, width_of
from gcs.session.plain_text import clean, minutes

LEAST_WORDS = 12
LOW, HALF = 0.2, 0.5
SEVERITY_STYLES = ("", "look", "act")

Cell = Callable[[Vehicle, Glyphs, int], StyledLine]


@dataclass(frozen=True)
class TableColumn:
    """Title with unit, width, what is dropped first (the highest rank), and what a vehicle has there."""

    title: str
    width: int
    rank: int
    cell: Cell
    justify: Callable[[str, int], str] = right
    wide: int = 0
    wide_title: str = ""
    """its width and title where there is room to spare"""


def _figure(key: str, decimals: int, axis: int | None = None) -> Cell:
    def cell(vehicle: Vehicle, glyphs: Glyphs, width: int) -> StyledLine:
        value = vehicle.get(key)
        if axis is not None and value is not None:
            value = value[axis]
        return [(right(number(value, width, decimals), width), "")]

    return cell


def identity(vehicle: Vehicle, glyphs: Glyphs, width: int) -> StyledLine:
    """The vehicle's id with the mark of its health in front."""
    level = severity(vehicle)
    mark = (" ", glyphs.look, glyphs.act)[level]
    return [(mark + right(str(vehicle["sysid"]), width - 1), SEVERITY_STYLES[level])]


def _role(vehicle: Vehicle, glyphs: Glyphs, width: int) -> StyledLine:
    role = clean(vehicle.get("role") or "vehicle")
    return [(left(role, width), f"craft {role}")]


def mode(vehicle: Vehicle) -> Span:
    """Its flight mode, or that it is dead."""
    if not vehicle.get("alive", True):
        return "DEAD", "act"
    style = {"return": "look", "land": "look", "hold": "held", "refuel": "meet"}.get(vehicle.get("mode") or "", "")
    return clean(vehicle.get("mode_name") or "-"), style


def _mode(vehicle: Vehicle, glyphs: Glyphs, width: int) -> StyledLine:
    text, style = mode(vehicle)
    return [(left(text, width), style)]


def _armed(vehicle: Vehicle, glyphs: Glyphs, width: int) -> StyledLine:
    armed = vehicle.get("armed")
    text = "-" if armed is None else glyphs.yes if armed else glyphs.no
    return [(text.center(width), "" if armed else "dim")]


def battery_style(share: float) -> str:
    """Style of a charge: calm down to a fifth; whether to act is said by the health issues."""
    return "look" if share < LOW else "half" if share < HALF else "charge"


def _battery(vehicle: Vehicle, glyphs: Glyphs, width: int) -> StyledLine:
    share = battery_share(vehicle)
    if share is None:
        return [(left("-", width), "dim")]
    style = battery_style(share)
    return [*bar(share, width - 4, glyphs, style), (f"{100.0 * share:3.0f}%", style)]


def _minutes(vehicle: Vehicle, glyphs: Glyphs, width: int) -> StyledLine:
    return [(right(minutes(vehicle.get("endurance_s")), width), "")]


def _loss(vehicle: Vehicle, glyphs: Glyphs, width: int) -> StyledLine:
    share = vehicle.get("lost_share")
    if share is None:
        return [(right("-", width), "dim")]
    return [(right(number(100.0 * share, width, 0), width), "look" if share >= 0.05 else "")]


def _competition(vehicle: Vehicle, glyphs: Glyphs, width: int) -> StyledLine:
    state, v = str(vehicle.get("state") or ""), vehicle.get("v")
    word = "compet" if state == "competing" else clean(state)
    if state in ("idle", "") and v is None:
        return [(left("-" if state else "", width), "dim")]
    if state in ("competing", "") and v is not None:
        return [(left(f"v {v:.2f}", width), "")]
    style = {"leads": "lead", "served": "meet", "serves": "meet", "lost": "dim"}.get(state, "")
    if v is not None and width >= 11:
        word = f"{word} {v:.2f}"
    return [(left(word, width), style)]


COLUMNS = (
    TableColumn(" id", 4, 0, identity, left, 4),
    TableColumn("rol", 3, 0, _role, left, 7, "role"),
    TableColumn("mode", 8, 0, _mode, left, 8),
    TableColumn("a", 1, 6, _armed, left, 3, "arm"),
    TableColumn("N m", 4, 5, _figure("p_ned", 1, 0), right, 6),
    TableColumn("E m", 4, 5, _figure("p_ned", 1, 1), right, 6),
    TableColumn("h m", 4, 3, _figure("height_m", 1), right, 5),
    TableColumn("m/s", 4, 4, _figure("speed_m_s", 1), right, 4),
    TableColumn("tgt", 4, 4, _figure("target_m", 1), right, 6, "tgt m"),
    TableColumn("battery", 8, 0, _battery, left, 12),
    TableColumn("J", 5, 3, _figure("remaining_j", 0), right, 6),
    TableColumn("min", 5, 2, _minutes, right, 5),
    TableColumn("age", 3, 3, _figure("age_s", 1), right, 5, "age s"),
    TableColumn("ls%", 3, 4, _loss, right, 4, "los%"),
    TableColumn("state", 6, 2, _competition, left, 11, "competition"),
)


@dataclass(frozen=True)
class TableLayout:
    """Which columns stand in a table of some width, how wide, and what room is left for health issues."""

    columns: tuple[tuple[TableColumn, int], ...]
    gap: int
    words: int


def layout(width: int) -> TableLayout:
    """The columns that fit; the least important ones are left out, the roomy widths taken where possible."""
    shown = list(COLUMNS)

    def taken(columns: Sequence[TableColumn], *, wide: bool, gap: int) -> int:
        return sum(c.wide if wide else c.width for c in columns) + gap * (len(columns) - 1)

    while taken(shown, wide=False, gap=1) > width and any(c.rank for c in shown):
        worst = max(c.rank for c in shown)
        shown = [c for c in shown if c.rank != worst]
    wide = taken(shown, wide=True, gap=1) <= width
    gap = 2 if wide and taken(shown, wide=True, gap=2) + 2 + LEAST_WORDS <= width else 1
    words = width - taken(shown, wide=wide, gap=gap) - gap
    widths = tuple((c, c.wide if wide else c.width) for c in shown)
    return TableLayout(widths, gap, words if words >= LEAST_WORDS else 0)


def heading(plan: TableLayout) -> StyledLine:
    """The titles over their columns."""
    line: StyledLine = []
    for column, width in plan.columns:
        title = column.wide_title if width == column.wide and column.wide_title else column.title
        line += [(column.justify(title, width), "heading"), (" " * plan.gap, "heading")]
    return [*line, (left("trouble", plan.words), "heading")] if plan.words else line[:-1]


def row(vehicle: Vehicle, plan: TableLayout, glyphs: Glyphs, *, chosen: bool) -> StyledLine:
    """One vehicle."""
    line: StyledLine = []
    for column, width in plan.columns:
        line += [*column.cell(vehicle, glyphs, width), (" " * plan.gap, "")]
    if plan.words:
        note = ", ".join(issues(vehicle)) or clean(vehicle.get("note") or "")
        style = SEVERITY_STYLES[severity(vehicle)] or "dim"
        line += fitted([(note, style)], plan.words, glyphs)
    else:
        line = line[:-1]
    if not vehicle.get("alive", True):
        line = [(text, style or "dim") for text, style in line]
    return [(text, f"{style} chosen") for text, style in line] if chosen else line


def window(vehicles: Sequence[Vehicle], room: int, chosen: int | None, top: int) -> tuple[list[Vehicle], int, int]:
    """(the vehicles shown, how many of them are pinned at the top, the new `top`) of an ordered fleet.

    Those with health issues stay in sight, in up to a half of the room, however far the rest is scrolled; `top` is the
    first of the others that is shown, and moves as little as keeps the chosen one in sight.
    """
    if len(vehicles) <= room or room <= 0:
        return list(vehicles[: max(room, 0)]), 0, 0
    pinned = min(sum(1 for v in vehicles if severity(v)), room // 2)
    rest, room = vehicles[pinned:], room - pinned
    at = next((i for i, v in enumerate(rest) if v["sysid"] == chosen), None)
    top = min(max(top, 0), len(rest) - room)
    if at is not None:
        top = min(max(top, at - room + 1), at)
    return [*vehicles[:pinned], *rest[top : top + room]], pinned, top


def table(
    vehicles: Sequence[Vehicle], *, width: int, height: int, glyphs: Glyphs, chosen: int | None, top: int
) -> tuple[StyledLines, list[int], int]:
    """(lines, the system id on each line from the second on, the new `top`); the last line counts those not shown."""
    plan = layout(width)
    room = height - 1
    hidden_line = len(vehicles) > room
    shown, _, top = window(vehicles, room - hidden_line, chosen, top)
    lines: StyledLines = [_filled(heading(plan), width, "heading")]
    for vehicle in shown:
        mine = vehicle["sysid"] == chosen
        lines.append(_filled(row(vehicle, plan, glyphs, chosen=mine), width, "chosen" if mine else ""))
    if hidden_line:
        hidden = _hidden(len(vehicles) - len(shown), vehicles, {v["sysid"] for v in shown}, glyphs)
        lines.append(fitted([*hidden, ("   ", ""), (totals(vehicles), "dim")], width, glyphs))
    return lines, [vehicle["sysid"] for vehicle in shown], top


def totals(vehicles: Sequence[Vehicle]) -> str:
    """How many are in each mode, the most first, and how many are low."""
    modes = Counter(mode(vehicle)[0] for vehicle in vehicles)
    low = sum(1 for v in vehicles if (share := battery_share(v)) is not None and share < LOW)
    said = ", ".join(f"{count} {name}" for name, count in sorted(modes.items(), key=lambda one: (-one[1], one[0])))
    return f"{said}; {low} below {100 * LOW:.0f} %" if low else said


def _filled(line: StyledLine, width: int, style: str) -> StyledLine:
    return [*line, (" " * max(0, width - width_of(line)), style)]


def _hidden(count: int, vehicles: Sequence[Vehicle], shown: set[Any], glyphs: Glyphs) -> StyledLine:
    levels = [severity(v) for v in vehicles if v["sysid"] not in shown]
    acts, looks = levels.count(2), levels.count(1)
    line: StyledLine = [(f"{glyphs.more} {count} more", "dim")]
    if acts or looks:
        line.append((f", {acts} to act on, {looks} to look at: scroll", "act" if acts else "look"))
    return line
