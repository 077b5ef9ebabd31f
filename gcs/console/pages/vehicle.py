"""One vehicle: its state, its link, its last events, and every message that it sends with all its fields."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from gcs.console.events_log import Filter, matching
from gcs.console.events_log import line as event_line
from gcs.console.model import SessionModel, Vehicle, battery_share, issues, severity
from gcs.console.pages.fleet import battery_style, mode
from gcs.console.text import Glyphs, StyledLine, StyledLines, bar, fitted, left, number, titled, wrapped
from gcs.session.plain_text import clean, minutes

EVENTS = 3
NAME = 12


def page(
    watch: SessionModel, sysid: int | None, *, width: int, height: int, back: int, glyphs: Glyphs
) -> tuple[StyledLines, int]:
    """(lines, how far its messages can be scrolled); `back` is how far they are."""
    vehicle = watch.vehicles.get(-1 if sysid is None else sysid)
    if vehicle is None or sysid is None:
        return [[("  no vehicle is chosen: choose one on the fleet page", "dim")]], 0
    lines = _state(watch, vehicle, width, glyphs)
    events = matching(watch, Filter(sysid=sysid))[-EVENTS:]
    lines.append(titled("its last events", width, glyphs))
    lines += [event_line(watch, event, width, glyphs) for event in events] or [[("  none", "dim")]]
    inspected = _inspected(watch, sysid, width, glyphs)
    room = max(height - len(lines) - 1, 1)
    most = max(0, len(inspected) - room)
    back = min(back, most)
    note: StyledLine = (
        [(f"{back + 1}-{min(back + room, len(inspected))} of {len(inspected)} lines", "dim")] if most else []
    )
    lines.append(titled("what it sends, in MAVLink's units", width, glyphs, note))
    return [*lines, *inspected[back : back + room]], most


def _state(watch: SessionModel, vehicle: Vehicle, width: int, glyphs: Glyphs) -> StyledLines:
    known = watch.known.get(vehicle["sysid"], {})
    text, style = mode(vehicle)
    level = severity(vehicle)
    words = ", ".join(issues(vehicle)) or "well"
    title: StyledLine = [
        (f" {watch.name(vehicle['sysid'])} ", "name"),
        (f"  id {vehicle['sysid']}  {clean(vehicle.get('role') or '')}  {clean(vehicle.get('autopilot') or '')}  ", ""),
        (f"{glyphs.act if level == 2 else glyphs.look} {words}" if level else words, ("well", "look", "act")[level]),
    ]
    share, capacity = battery_share(vehicle), known.get("capacity_j")
    battery: StyledLine = [("-", "dim")]
    if share is not None:
        style_now = battery_style(share)
        battery = [*bar(share, 8, glyphs, style_now), (f" {100.0 * share:.0f} %", style_now)]
        battery.append((f", {minutes(vehicle.get('endurance_s'))} min", ""))
    landed = ", landed" if vehicle.get("landed") else ""
    facts: list[tuple[str, StyledLine]] = [
        ("mode", [(text, style), (", armed" if vehicle.get("armed") else ", disarmed", "")]),
        ("battery", battery),
        ("stage", [(clean(vehicle.get("stage") or "-") + landed, "")]),
        ("energy J", [(f"{number(vehicle.get('remaining_j'), 8, 0)} of {number(capacity, 8, 0)}", "")]),
        ("NED m", [(_vector(vehicle.get("p_ned")), "")]),
        ("power W", [(f"{number(vehicle.get('power_w'), 8)}, {clean(vehicle.get('energy_source') or '-')}", "")]),
        ("v NED m/s", [(_vector(vehicle.get("v_ned")), "")]),
        ("competition", [(_competition(vehicle), "")]),
        ("set point m", [(_vector(vehicle.get("aim_ned")), "")]),
        ("target m", [(number(vehicle.get("target_m"), 8, 2) + _margin(vehicle), "")]),
        ("heading", [(_degrees(vehicle.get("heading_rad")), "")]),
        ("link", [(_link(vehicle), "")]),
    ]
    half = width // 2
    lines: StyledLines = [fitted(title, width, glyphs)]
    for one, other in zip(facts[::2], facts[1::2], strict=True):
        lines.append([*fitted(_fact(*one), half, glyphs), *fitted(_fact(*other), width - half, glyphs)])
    if batteries := vehicle.get("batteries"):
        text = "   ".join(map(_battery, batteries))
        lines += [[(" " + left("batteries", NAME), "dim"), (part, "")] for part in wrapped(text, width - NAME - 2)]
    for name, key in (("Remote ID", "remote_id"), ("note", "note")):
        if text := clean(vehicle.get(key) or ""):
            lines.append(fitted([(" " + left(name, NAME), "dim"), (text, "")], width, glyphs))
    return lines


def _margin(vehicle: Vehicle) -> str:
    margin_m = vehicle.get("margin_m")
    return "" if margin_m is None else f", margin {number(margin_m, 4, 2).strip()}"


def _fact(name: str, value: StyledLine) -> StyledLine:
    return [(" " + left(name, NAME), "dim"), *value]


def _vector(value: Any) -> str:
    return "-" if value is None else " ".join(f"{number(x, 8, 2):>8}" for x in value)


def _degrees(heading_rad: float | None) -> str:
    return "-" if heading_rad is None else f"{math.degrees(heading_rad) % 360.0:.0f} deg from north"


def _competition(vehicle: Vehicle) -> str:
    parts = [clean(vehicle.get("state") or "-")]
    parts += [f"{name} {float(vehicle[name]):.3f}" for name in ("v", "tau") if vehicle.get(name) is not None]
    return ", ".join(parts)


def _battery(one: Mapping[str, Any]) -> str:
    share = one.get("share")
    parts = [f"{one.get('id')}: {'-' if share is None else f'{100.0 * float(share):.0f} %'}"]
    if one.get("voltage_v") is not None:
        parts.append(f"{float(one['voltage_v']):.1f} V")
    if one.get("function"):
        parts.append(clean(one["function"]))
    return " ".join(parts)


def _link(vehicle: Vehicle) -> str:
    share = vehicle.get("lost_share")
    lost = "-" if share is None else f"{100.0 * float(share):.1f} % lost"
    used = f", {clean(vehicle['link'])}" if vehicle.get("link") else ""
    return f"{lost} ({vehicle.get('lost', '-')}), {number(vehicle.get('heard_s'), 5)} s ago{used}"


def _inspected(watch: SessionModel, sysid: int, width: int, glyphs: Glyphs) -> StyledLines:
    """Each message: name, rate, age, count, and its fields."""
    inspected = watch.snapshot.get("inspected") or {}
    messages: Mapping[str, Any] = inspected.get(str(sysid)) or {}
    if not messages:
        return [[("  nothing yet", "dim")]]
    lines: StyledLines = []
    for name in sorted(messages):
        message = messages[name]
        age = message.get("age_s")
        numbers = (
            f"{number(message.get('rate_hz'), 5):>6} Hz {number(age, 6):>6} s ago {message.get('count', 0):>7} so far"
        )
        lines.append(fitted([(" " + left(clean(name), 30), "who"), (numbers, "dim")], width, glyphs))
        fields = "   ".join(f"{clean(key)}={_value(value)}" for key, value in (message.get("fields") or {}).items())
        lines += [[("   " + text, "")] for text in wrapped(fields, width - 4) if text]
    return lines


def _value(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        return "[" + ",".join(_value(x) for x in value) + "]"
    return clean(value)
