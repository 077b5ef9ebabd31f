"""A session's state as a table that fits a terminal: `render` is a pure function of a snapshot and the room there is.

Columns are dropped when it is narrow, healthy vehicles and events when it is low. Vehicles in trouble come first.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from rich.console import Console, Group
from rich.live import Live
from rich.table import Table
from rich.text import Text

from gcs.console.plain import Snapshot, clean, counts, goal_parts, minutes, name_of, told, worth_a_line

LOW_BATTERY = 0.2
HALF_BATTERY = 0.5
DRAW_EVERY_S = 0.125
EVENTS = 5
SERVICES = 4
WIDE = 110
LONGEST_BAR = 60
LEAST_NOTE = 14
MODE_STYLES = {
    "offboard": "green",
    "refuel": "bright_cyan",
    "takeoff": "cyan",
    "hold": "yellow",
    "return": "bright_red",
    "land": "bright_red",
    "other": "magenta",
}
LEVEL_STYLES = {"warning": "yellow", "critical": "bold red"}
PHASE_STYLES = {"starting": "cyan", "flying": "green", "paused": "yellow", "ended": "bold"}


@dataclass(frozen=True)
class Glyphs:
    """The characters that a terminal can show."""

    full: str
    empty: str
    times: str
    arrow: str
    more: str


UNICODE = Glyphs("━", "─", "×", "←", "…")
ASCII = Glyphs("#", ".", "x", "<-", "...")


@dataclass(frozen=True)
class Row:
    """One vehicle, and what its cells need to know beside it."""

    vehicle: Mapping[str, Any]
    trouble: str
    leads: bool
    glyphs: Glyphs
    bar: int


@dataclass(frozen=True)
class Column:
    """A column of the fleet table; the highest `rank` is dropped first when it is narrow."""

    title: str
    width: int
    rank: int
    cell: Callable[[Row], Text]
    justify: Literal["left", "right"] = "left"


def bar(share: float, width: int, glyphs: Glyphs, style: str) -> Text:
    """A bar of `width` cells filled by `share` in 0..1; what is more than nothing shows."""
    share = min(max(share, 0.0), 1.0)
    full = min(width, math.ceil(share * width - 0.5) or (share > 0.0))
    return Text.assemble((glyphs.full * full, style), (glyphs.empty * (width - full), "dim"))


def number(value: float | None, width: int, decimals: int = 1) -> str:
    """`value` with as many decimals as fit `width`; `-` for unknown."""
    if value is None:
        return "-"
    shown = ""
    for places in range(decimals, -1, -1):
        shown = f"{value:.{places}f}"
        if len(shown) <= width:
            break
    return shown.replace("-", "") if float(shown) == 0.0 else shown


def trouble(vehicle: Mapping[str, Any], phase: str) -> str:
    """What is wrong with a vehicle, in a word or two; empty if nothing is."""
    if not vehicle["alive"]:
        return "died"
    if phase in ("flying", "paused"):
        if vehicle["mode"] == "land":
            return "landing"
        if vehicle["mode"] == "return":
            return "going home"
        if vehicle["stage"] == "down":
            return "is down"
    if vehicle["battery"] is not None and vehicle["battery"] < LOW_BATTERY:
        return "battery low"
    return ""


_ORDER = {"died": 0, "is down": 1, "landing": 2, "going home": 3, "battery low": 4, "": 5}


def _battery_style(share: float) -> str:
    return "bold red" if share < LOW_BATTERY else "yellow" if share < HALF_BATTERY else "green"


def _mode(row: Row) -> Text:
    vehicle = row.vehicle
    if not vehicle["alive"]:
        return Text("DEAD", "bold red reverse")
    if not vehicle["armed"]:
        return Text("disarmed", "dim")
    return Text(clean(vehicle["mode"]), MODE_STYLES.get(vehicle["mode"], "magenta"))


def _coordinate(axis: int, sign: float, width: int, decimals: int) -> Callable[[Row], Text]:
    def cell(row: Row) -> Text:
        p_ned = row.vehicle["p_ned"]
        return Text(number(None if p_ned is None else sign * p_ned[axis], width, decimals))

    return cell


def _figure(key: str, width: int, decimals: int) -> Callable[[Row], Text]:
    return lambda row: Text(number(row.vehicle[key], width, decimals))


def _battery(row: Row) -> Text:
    share = row.vehicle["battery"]
    if share is None:
        return Text("-")
    style = _battery_style(share)
    left = minutes(row.vehicle["endurance_s"])
    return Text.assemble(bar(share, row.bar, row.glyphs, style), (f"{100.0 * share:4.0f}%", style), f"{left:>6}")


def _competition(row: Row) -> Text:
    share = row.vehicle["v"]
    if share is None:
        return Text("")
    style = "bold bright_magenta" if row.leads else "magenta"
    figure = Text.assemble(bar(share, row.bar - 1, row.glyphs, style), (f" {share:.2f}", style))
    return figure.append(" 1st", style) if row.leads else figure


def _note(row: Row) -> Text:
    note = clean(row.vehicle["note"])
    if row.trouble:
        return Text.assemble((row.trouble, "bold red"), f", {note}" if note else "")
    return Text(note, "cyan")


def _role(row: Row) -> Text:
    style = {"tanker": "bright_cyan", "target": "bright_yellow"}.get(row.vehicle["role"], "")
    return Text(clean(row.vehicle["role"]), style)


def columns(width: int) -> tuple[list[Column], int, int]:
    """(the columns that fit `width`, the gap between them, the width of their bars)."""
    wide = width >= WIDE
    cells, short, decimals, gap, size = (8, 8, 2, 2, 8) if wide else (5, 4, 1, 1, 5)
    every = [
        Column("", 1, 0, lambda row: Text("!" if row.trouble else "", "bold red")),
        Column("id", 3, 0, lambda row: Text(str(row.vehicle["sysid"]), "bold"), "right"),
        Column("role", 7, 6, _role),
        Column("mode", 8, 1, _mode),
        Column("N m", cells, 7, _coordinate(0, 1.0, cells, decimals), "right"),
        Column("E m", cells, 7, _coordinate(1, 1.0, cells, decimals), "right"),
        Column("up m", short, 5, _figure("height_m", short, decimals), "right"),
        Column("m/s", 4, 8, _figure("speed_m_s", 4, 1), "right"),
        Column("target m" if wide else "tgt", short, 3, _figure("target_m", short, decimals), "right"),
        Column("battery   min left" if wide else "battery min left", size + 11, 0, _battery),
        Column("competition", size - 1 + 9, 4, _competition),
    ]

    def taken() -> int:
        return sum(column.width + gap for column in every) - gap

    while taken() > width and any(column.rank for column in every):
        worst = max(column.rank for column in every)
        every = [column for column in every if column.rank != worst]
    if (rest := width - taken() - gap) >= LEAST_NOTE:
        every.append(Column("note", rest, 9, _note))
    return every, gap, size


def _order(vehicles: Iterable[Mapping[str, Any]], phase: str, room: int) -> list[Mapping[str, Any]]:
    """Troubled vehicles first, worst first; the others by system id, or emptiest first if not all can be shown."""
    listed = list(vehicles)
    by_battery = len(listed) > room

    def key(vehicle: Mapping[str, Any]) -> tuple[float, float, int]:
        what = trouble(vehicle, phase)
        charge = 1.0 if vehicle["battery"] is None else vehicle["battery"]
        return _ORDER[what], charge if what or by_battery else 0.0, vehicle["sysid"]

    return sorted(listed, key=key)


def _header(snapshot: Snapshot, name: str, width: int, glyphs: Glyphs) -> Text:
    t_s, duration_s = snapshot["t_s"], snapshot["duration_s"]
    times = f"{t_s:.1f} / {duration_s:.0f} s"
    pace = f"{glyphs.times}{snapshot['speed']:.2f}"
    phase = snapshot["phase"]
    hint = "Ctrl-C stops and saves"
    name = clean(name)
    fixed = len(name) + len(times) + len(pace) + len(phase) + 8
    with_hint = width - fixed - len(hint) - 2 >= 12
    length = min(width - fixed - (len(hint) + 2 if with_hint else 0), LONGEST_BAR)
    line = Text.assemble((name, "bold"), "  ")
    if length >= 4:
        line.append_text(bar(t_s / duration_s if duration_s else 0.0, length, glyphs, "bright_blue")).append("  ")
    line.append(times).append("  ").append(pace).append("  ").append(phase, PHASE_STYLES.get(phase, ""))
    return line.append("  ").append(hint, "dim") if with_hint else line


def _goal(snapshot: Snapshot, glyphs: Glyphs) -> Text:
    line = Text("goal", "bold")
    parts = goal_parts(snapshot)
    for what, have, need, unit in parts:
        style = "green" if have >= need else "yellow"
        line.append(f"  {what} ").append(f"{have:.0f}/{need:.0f}{unit} ", style)
        line.append_text(bar(have / need if need else 1.0, 10, glyphs, style))
    if not any(part[0] == "refuelled" for part in parts):
        line.append(f"  refuelled {snapshot['refuelled']}")
    return line


def _services(snapshot: Snapshot, glyphs: Glyphs) -> list[Text]:
    services = snapshot["services"]
    lines = []
    for service in services[: SERVICES if len(services) <= SERVICES else SERVICES - 1]:
        receiver, tanker = name_of(snapshot, service["receiver"]), name_of(snapshot, service["tanker"])
        line = Text.assemble(("refuelling", "bold"), "  ", (f"{receiver} {glyphs.arrow} {tanker}", "bright_cyan"))
        lines.append(
            line.append(f"  {clean(service['phase'])}, {service['energy_j']:.0f} J, by {clean(service['by'])}")
        )
    if len(lines) < len(services):
        lines.append(Text(f"refuelling  {glyphs.more} and {len(services) - len(lines)} more", "dim"))
    return lines


def _event(snapshot: Snapshot, event: Mapping[str, Any]) -> Text:
    style = LEVEL_STYLES.get(event["level"], "")
    return Text.assemble((f"{event['t_s']:7.1f} s  ", "dim"), (told(snapshot, event), style))


def _fleet(snapshot: Snapshot, rows: Sequence[Mapping[str, Any]], width: int, glyphs: Glyphs) -> Table:
    shown, gap, size = columns(width)
    table = Table(box=None, padding=(0, gap, 0, 0), pad_edge=False, header_style="bold underline", show_edge=False)
    for column in shown:
        table.add_column(column.title, width=column.width, justify=column.justify, no_wrap=True, overflow="crop")
    values = sorted((v["v"] for v in snapshot["vehicles"] if v["v"] is not None), reverse=True)
    for vehicle in rows:
        leads = bool(values) and vehicle["v"] == values[0] > 0.0 and (len(values) == 1 or values[0] > values[1])
        row = Row(vehicle, trouble(vehicle, snapshot["phase"]), leads, glyphs, size)
        table.add_row(*(column.cell(row) for column in shown), style="" if vehicle["alive"] else "dim")
    return table


def render(snapshot: Snapshot, *, name: str, width: int, height: int, unicode: bool = True) -> Group:
    """The session as at most `height` lines of at most `width` cells; `name` is the scenario's."""
    glyphs = UNICODE if unicode else ASCII
    services = _services(snapshot, glyphs)
    events = [_event(snapshot, event) for event in snapshot["events"][-EVENTS:]]
    vehicles = snapshot["vehicles"]
    fixed = 4 + len(services)
    room = max(1, height - fixed - (EVENTS + 1 if height - fixed - EVENTS - 1 >= min(len(vehicles), 6) else 0))
    rows = _order(vehicles, snapshot["phase"], room)
    hidden = rows[room - 1 :] if len(rows) > room else []
    rows = rows[: len(rows) - len(hidden)]
    lines: list[Text | Table] = [_header(snapshot, name, width, glyphs), _goal(snapshot, glyphs), Text("")]
    lines.append(_fleet(snapshot, rows, width, glyphs))
    if hidden:
        lines.append(Text(f"{glyphs.more} {len(hidden)} more: {counts(hidden)}", "dim"))
    left = height - fixed - len(rows) - bool(hidden) - 1
    below = [*services, *(events[-left:] if left > 0 else ())]
    if below and left >= 0:
        lines.append(Text(""))
    lines += below
    for line in lines:
        if isinstance(line, Text):
            line.no_wrap, line.overflow = True, "ellipsis" if unicode else "crop"
    return Group(*lines)


class TableView:
    """The table, live in a terminal; drawn at most eight times a second."""

    def __init__(self, name: str, console: Console) -> None:
        self._name = name
        self._console = console
        self._unicode = console.encoding.lower().startswith("utf")
        self._size = console.size
        self._events: deque[Mapping[str, Any]] = deque(maxlen=EVENTS)
        self._newest: Snapshot | None = None
        self._drawn: Snapshot | None = None
        self._drawn_s = -DRAW_EVERY_S
        self._live = Live(console=console, auto_refresh=False, redirect_stdout=False, redirect_stderr=False)
        self._live.start()

    def show(self, snapshot: Snapshot) -> None:
        """Take in the newest state."""
        self._events.extend(event for event in snapshot["events"] if worth_a_line(event))
        self._newest = {**snapshot, "events": list(self._events)}

    def tick(self, now_s: float) -> None:
        """Draw what is new, if it is time at wall time `now_s`."""
        resized = self._console.size != self._size
        if now_s - self._drawn_s >= DRAW_EVERY_S and (resized or self._newest is not self._drawn):
            if resized:  # the terminal has wrapped the old lines: where they end is no longer known
                self._console.clear()
                self._size = self._console.size
            self._draw()
            self._drawn_s = now_s

    def close(self) -> None:
        """Leave the last state on the screen."""
        try:
            if self._newest is not self._drawn:
                self._draw()
        finally:
            self._live.stop()

    def _draw(self) -> None:
        if self._newest is None:
            return
        width, height = self._console.size
        picture = render(self._newest, name=self._name, width=width, height=height - 1, unicode=self._unicode)
        self._live.update(picture, refresh=True)
        self._drawn = self._newest
