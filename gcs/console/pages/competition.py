"""The competition for the next refuelling: its course, the bids, the winner and its margin, and why the tanker
flies."""

from __future__ import annotations

from typing import Any

from gcs.console.drawing.chart import chart
from gcs.console.model import SessionModel, margin
from gcs.console.text import Glyphs, StyledLine, StyledLines, bar, fitted, left, number, titled, wrapped
from gcs.session.plain_text import clean

MOST_CURVES = 6
SPAN_S = 60.0
BRIEF = 60
"""Cells below which a service that has ended is shown by numbers alone."""


def verdict(watch: SessionModel) -> StyledLine:
    """The leader and its share, in one line."""
    competition = watch.competition
    if not competition.get("v"):
        return [("no vehicle competes at present", "dim")]
    leader, ahead = competition.get("leader"), margin(competition)
    if leader is None or ahead is None:
        return [("undecided", "info"), (f", {len(competition['v'])} compete", "")]
    share, needed = 100.0 * float(competition["share"]), 100.0 * float(competition.get("threshold") or 0.9)
    line: StyledLine = [(watch.name(leader), "lead"), (f" leads with {share:.0f} %", "")]
    line.append((f", margin {100.0 * ahead:+.0f}", "well" if ahead >= 0.0 else "info"))
    line.append((f" (needs {needed:.0f} %)", "dim"))
    if (runner_up := competition.get("runner_up")) is not None:
        line.append((f", then {watch.name(runner_up)}", ""))
    return line


def names(watch: SessionModel) -> list[str]:
    """The vehicles whose curves are drawn: the greatest v now first, then those that were greatest while the curves
    show."""
    now = {str(name): float(value) for name, value in (watch.competition.get("v") or {}).items()}
    best: dict[str, float] = {}
    for t_s, values in watch.competition_states:
        if t_s >= watch.t_s - SPAN_S:
            for name, value in values.items():
                best[name] = max(best.get(name, 0.0), value)
    every = sorted({*now, *best}, key=lambda name: (-now.get(name, -1.0), -best.get(name, 0.0), name))
    return every[:MOST_CURVES]


def why(watch: SessionModel, width: int, most: int) -> StyledLines:
    """Why each tanker flies where it flies."""
    lines: StyledLines = []
    for service in watch.snapshot.get("services") or ():
        sentence = clean(service.get("why") or "") or (
            f"{watch.giver(service)} serves {watch.name(service.get('receiver'))}, "
            f"decided by {clean(service.get('by') or '?')}."
        )
        state = f"{clean(service.get('phase') or '')}, {float(service.get('energy_j') or 0.0):.0f} J given"
        for order, text in enumerate(wrapped(f"{sentence} ({state})", width - 2)):
            lines.append([("  " if order else "> ", "meet"), (text, "")])
    return lines[:most] or [[("  no tanker is under way", "dim")]]


def compact(watch: SessionModel, *, width: int, height: int, glyphs: Glyphs) -> StyledLines:
    """Verdict, reason and curves in little room."""
    reasons = why(watch, width, 3)
    lines: StyledLines = [fitted(verdict(watch), width, glyphs), *reasons]
    return [*lines, *_curves(watch, width, height - len(lines), glyphs)]


def _curves(watch: SessionModel, width: int, height: int, glyphs: Glyphs) -> StyledLines:
    return chart(
        watch.competition_states,
        names(watch),
        list(watch.handovers),
        style_of=lambda name: _style_of(watch, name),
        width=width,
        height=height,
        glyphs=glyphs,
        span_s=SPAN_S,
        now_s=watch.t_s,
    )


def _style_of(watch: SessionModel, name: str) -> str:
    return watch.style(int(name)) if name.isdigit() else ""


def page(watch: SessionModel, *, width: int, height: int, glyphs: Glyphs) -> StyledLines:
    """All of it: reasons, curves, bids, and the services that have ended."""
    lines: StyledLines = [fitted([(" ", ""), *verdict(watch)], width, glyphs), *why(watch, width, 4)]
    half = min(46, width // 2)
    bids, past = _bids(watch, glyphs), _past(watch, brief=width - half < BRIEF)
    below = min(max(len(bids), len(past), 3) + 1, max(4, height // 3))
    lines.append(titled("v over time, 60 s", width, glyphs))
    curves = _curves(watch, width, height - len(lines) - below, glyphs)
    room = height - len(lines) - below
    lines += [*curves, *([] for _ in range(room - len(curves)))]
    first = titled("bids", half - 1, glyphs)
    second = titled("services so far", width - half, glyphs)
    lines.append([*first, (" ", ""), *second])
    for order in range(below - 1):
        one = bids[order] if order < len(bids) else []
        other = past[order] if order < len(past) else []
        lines.append([*fitted(one, half, glyphs), *fitted(other, width - half, glyphs)])
    return lines


def _bids(watch: SessionModel, glyphs: Glyphs) -> StyledLines:
    """v and need of everyone in it, the greatest v first."""
    competition = watch.competition
    values = {str(k): float(x) for k, x in (competition.get("v") or {}).items()}
    needs: dict[str, Any] = {str(k): x for k, x in (competition.get("tau") or {}).items()}
    top = max([1.0, *values.values()])
    lines: StyledLines = [[(f"  {'vehicle':<12} {'v':>5} {'':<12} {'bid':>5}", "heading")]] if values else []
    drawn = names(watch)
    for name in sorted(values, key=lambda name: (-values[name], name)):
        tau = needs.get(name)
        style = _style_of(watch, name) if name in drawn else ""
        bid = "-" if tau is None else f"{float(tau):.2f}"
        text = f"  {left(watch.name(name), 12)} {values[name]:5.2f} "
        lines.append([(text, style), *bar(values[name] / top, 12, glyphs, style or "charge"), (f" {bid:>5}", "")])
    return lines


def _past(watch: SessionModel, *, brief: bool) -> StyledLines:
    """Services that have ended, the last one first: when it ended, how much energy, receiver, giver, and why; `brief`:
    in 40 cells."""
    lines: StyledLines = []
    for service in reversed(watch.snapshot.get("history") or ()):
        when = service.get("end_s")
        stamp = "-" if when is None else f"{float(when):.1f}"
        text = f"{stamp:>6} s {number(float(service.get('energy_j') or 0.0), 6, 0):>6} J "
        by, reason = clean(service.get("by") or ""), clean(service.get("reason") or "")
        if brief:
            giver = service.get("tanker") if service.get("base") is None else clean(service["base"])
            text += f"{service.get('receiver')} by {giver} {by}"
        else:
            text += f" {watch.name(service.get('receiver'))} by {watch.giver(service)}"
            text += "".join(f", {part}" for part in (by, reason) if part)
        lines.append([(text, "")])
    return lines or [[("    none", "dim")]]
