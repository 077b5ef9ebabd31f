"""The lines that every page has: session and progress, pages and goal, health; and the keys at the bottom."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from gcs.console.model import SessionModel, issues, severity
from gcs.console.text import Glyphs, StyledLine, StyledLines, bar, fitted, width_of, wrapped
from gcs.session.plain_text import broken_text, clean, goal_parts

PAGES = ("fleet", "map", "competition", "events", "vehicle")
PHASES = {"starting": "info", "flying": "well", "monitoring": "well", "paused": "look", "ended": "title"}
LONGEST_BAR = 40
SILENT_S = 3.0


def session_line(
    watch: SessionModel, title: str, connected: bool, silent_s: float, width: int, glyphs: Glyphs
) -> StyledLine:
    """Name, time, progress, speed, phase, connection; and that a session which runs says nothing."""
    replay, snapshot = watch.replay, watch.snapshot
    name = clean(watch.session.get("name") or title or "session")
    duration_s = snapshot.get("duration_s") or watch.session.get("duration_s")
    begin_s = float((replay or {}).get("from_s") or 0.0)
    end_s = (replay or {}).get("to_s") or duration_s
    time = f"{watch.t_s:7.1f}" + (f" of {float(end_s):.0f} s" if end_s else " s")
    speed = (replay or snapshot).get("speed")
    pace = "-" if speed is None else f"{float(speed):.2f}"
    phase = watch.phase
    if replay and phase != "ended":
        phase = "paused" if replay.get("paused") else "replay"
    if connected:
        link: tuple[str, str] = (f"{glyphs.live} connected", "well")
    elif watch.snapshot:
        link = (f"{glyphs.act} not connected", "act")
    else:
        link = (f"{glyphs.no} connecting", "info")
    tail: StyledLine = [(f"  {glyphs.times}{pace}  ", ""), (phase, PHASES.get(phase, "info")), ("  ", ""), link]
    head: StyledLine = [(f" {name} ", "name"), (f" {time} ", "")]
    room = width - width_of(head) - width_of(tail) - 1
    if end_s and room >= 4:
        share = (watch.t_s - begin_s) / max(float(end_s) - begin_s, 1e-9)
        head += bar(share, min(room, LONGEST_BAR), glyphs, "progress")
        head.append((" " * (room - min(room, LONGEST_BAR)), ""))
    line = fitted([*head, *tail], width, glyphs)
    if not (connected and snapshot and silent_s >= SILENT_S and not replay):
        return line
    note = f" no news for {silent_s:.0f} s "
    return [*fitted(line, width - len(note), glyphs), (note, "look")]


def goal_line(watch: SessionModel, page: str, width: int, glyphs: Glyphs) -> StyledLine:
    """The pages, the present one marked, and how far the goal is."""
    goal: StyledLine = []
    if broken := broken_text(watch.snapshot.get("goal") or {}):
        goal.append((broken, "act"))
    for what, have, need, text in _goal(watch):
        style = "well" if have >= need else "info"
        goal += [("  " if goal else "", ""), (f"{what} ", "dim"), (text, style)]
        if width >= 120:
            goal += [(" ", ""), *bar(have / need if need else 1.0, 10, glyphs, style)]
    for short in (False, True):
        line = _tabs(page, short=short)
        gap = width - width_of(line) - width_of(goal) - 1
        if gap >= 1:
            break
    return fitted([*line, (" " * max(gap, 1), ""), *goal, (" ", "")], width, glyphs)


def _tabs(page: str, *, short: bool) -> StyledLine:
    """The pages with their keys; `short` names the present one alone."""
    line: StyledLine = []
    for order, name in enumerate(PAGES, 1):
        text = f"{order} {name}" if name == page or not short else str(order)
        line.append((f"[{text}]", "tab chosen") if name == page else (f" {text} ", "tab"))
    return line


def _goal(watch: SessionModel) -> Iterable[tuple[str, float, float, str]]:
    goal = {**(watch.session.get("goal") or {}), **(watch.snapshot.get("goal") or {})}
    refuelled = int(watch.snapshot.get("refuelled") or 0)
    for what, have, need, _ in goal_parts(goal, refuelled):
        word, unit = ("pursue", " s") if what == "pursuit" else ("refuel", "")
        yield word, have, need, f"{have:.0f}{unit} met" if have >= need else f"{have:.0f}/{need:.0f}{unit}"
    if refuelled and not goal.get("refuelled_at_least"):
        yield "refuel", 1, 1, str(refuelled)


def health_line(watch: SessionModel, width: int, glyphs: Glyphs) -> StyledLine:
    """The worst vehicles and what is wrong with them; on every page, always in the same place."""
    if not watch.vehicles and watch.monitors:
        return fitted([(" no vehicle yet", "info")], width, glyphs)
    if not watch.vehicles:
        waiting = watch.session.get("vehicles")
        count = f"{len(waiting)} vehicles" if waiting else "the vehicles"
        return fitted([(f" starting {count} {glyphs.more}", "info")], width, glyphs)
    bad = sorted((v for v in watch.vehicles.values() if severity(v)), key=lambda v: (-severity(v), v["sysid"]))
    acts = sum(1 for v in bad if severity(v) == 2)
    if not bad:
        flying = sum(1 for v in watch.vehicles.values() if v.get("armed"))
        text = f" all well {glyphs.dot} {len(watch.vehicles)} vehicles, {flying} armed"
        return fitted([(text, "well-line")], width, glyphs)
    line: StyledLine = []
    if acts:
        line.append((f" {glyphs.act} ACT {acts} ", "act badge"))
    if len(bad) > acts:
        line.append((f" {glyphs.look} LOOK {len(bad) - acts} ", "look badge"))
    for vehicle in bad:
        style = "act" if severity(vehicle) == 2 else "look"
        words = ", ".join(issues(vehicle)[:2]) or "trouble"
        line += [("  ", ""), (f"{watch.name(vehicle['sysid'])}: ", style), (words, style)]
        if width_of(line) > width:
            break
    return fitted(line, width, glyphs)


def keys_line(keys: Sequence[tuple[str, str]], width: int) -> StyledLine:
    """The (key, what it does) that fit whole, the first ones first."""
    line: StyledLine = []
    for key, meaning in keys:
        piece: StyledLine = [(f" {key}", "key"), (f" {meaning} ", "keys")]
        if width_of(line) + width_of(piece) > width:
            break
        line += piece
    return [*line, (" " * (width - width_of(line)), "keys")]


def too_small(width: int, height: int, least: tuple[int, int], *, flies: bool) -> StyledLines:
    """The longest text that fits a terminal of less than `least` (width, height); `flies`: a session goes on."""
    goes_on = "; the session goes on" if flies else ""
    needs = f"needs {least[0]} x {least[1]}"
    texts = (
        f"This terminal is {width} x {height}: the console {needs}. "
        f"Make it larger, or close the console with q{goes_on}.",
        f"{width} x {height} is too small: {needs}; q closes{goes_on}.",
        f"{needs}; q closes",
    )
    written = [wrapped(text, width) for text in texts]
    lines = next((lines for lines in written if len(lines) <= height), written[-1])
    return [[(line, "look")] for line in lines]
