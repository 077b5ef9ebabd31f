"""Event list of the console: filter, line formatting and scroll window, newest event last."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gcs.console.model import SessionModel
from gcs.console.text import Glyphs, Span, StyledLine, StyledLines, fitted, left, width_of, wrapped
from gcs.session.plain_text import clean

LEVELS = ("info", "warning", "critical")
KINDS = ("text", "mode", "failsafe", "ack", "decision", "operator", "link", "death", "session", "violation", "fault")
STYLES = {"info": "", "warning": "look", "critical": "act"}
WHO = 12
FOLDED, FOLDED_S = ("text", "mode", "ack"), 3.0
"""Kinds of events that come in numbers, and for how long after the first of a vehicle they are one with it, s."""
LEAST_TEXT = 20
"""Cells below which an event's words are cut instead of going on below themselves."""

Event = Mapping[str, Any]


@dataclass
class Filter:
    """An event is shown when it is at least of `level`, and of `kind`, `sysid` and `words` where these are set."""

    level: str = "info"
    kind: str = ""
    sysid: int | None = None
    words: str = ""

    def lets(self, event: Event, who: str = "") -> bool:
        """Whether `event`, of the vehicle named `who`, is shown."""
        level = str(event.get("level") or "info")
        if level in LEVELS and LEVELS.index(level) < LEVELS.index(self.level):
            return False
        if self.kind and kind_of(event) != self.kind:
            return False
        if self.sysid is not None and event.get("sysid") != self.sysid:
            return False
        return not self.words or self.words.lower() in f"{who} {event.get('text')}".lower()

    @property
    def open(self) -> bool:
        """Whether it lets everything through."""
        return self == Filter()

    def said(self) -> str:
        """The filter's settings, for a person."""
        parts = [f"{self.level} and worse" if self.level == "warning" else self.level if self.level != "info" else ""]
        parts += [self.kind, f"vehicle {self.sysid}" if self.sysid is not None else ""]
        parts += [f'"{self.words}"' if self.words else ""]
        return ", ".join(part for part in parts if part) or "all"

    def next_level(self) -> None:
        """The next stricter level, or all again."""
        self.level = LEVELS[(LEVELS.index(self.level) + 1) % len(LEVELS)]

    def next_kind(self) -> None:
        """The next kind, or all again."""
        every = ("", *KINDS)
        self.kind = every[(every.index(self.kind) + 1) % len(every)]


def kind_of(event: Event) -> str:
    """Category of the event."""
    return str(event.get("kind") or ("text" if event.get("sysid") else "session"))


def matching(watch: SessionModel, chosen: Filter) -> list[Event]:
    """The events that pass, oldest first."""
    if chosen.open:
        return list(watch.events)
    return [event for event in watch.events if chosen.lets(event, watch.name(event.get("sysid")))]


def folded(events: Sequence[Event]) -> list[Event]:
    """The same with what a vehicle says, acknowledges and changes of itself within `FOLDED_S` as one event, the first,
    which tells under "more" for how many others it stands."""
    shown: list[dict[str, Any] | Event] = []
    heads: dict[Any, tuple[int, float]] = {}  # of each vehicle: where its last first one is shown, and its time
    for event in events:
        if str(event.get("level") or "info") != "info" or kind_of(event) not in FOLDED:
            shown.append(event)
            continue
        sysid, t_s = event.get("sysid"), float(event.get("t_s") or 0.0)
        head, begun_s = heads.get(sysid, (-1, -math.inf))
        if 0.0 <= t_s - begun_s <= FOLDED_S:
            shown[head] = {**shown[head], "more": int(shown[head].get("more") or 0) + 1}
        else:
            heads[sysid] = len(shown), t_s
            shown.append(event)
    return shown


def line(watch: SessionModel, event: Event, width: int, glyphs: Glyphs) -> StyledLine:
    """One event on one line, cut where there is no room."""
    head, (text, style) = _parts(watch, event, width, glyphs)
    return fitted([*head, (text, style)], width, glyphs)


def entry(watch: SessionModel, event: Event, width: int, glyphs: Glyphs) -> StyledLines:
    """One event over as many lines as its words need."""
    head, (text, style) = _parts(watch, event, width, glyphs)
    indent = width_of(head)
    first, *rest = wrapped(text, max(width - indent, 1)) if width - indent >= LEAST_TEXT else [text]
    return [fitted([*head, (first, style)], width, glyphs)] + [
        fitted([(" " * indent, ""), (more, style)], width, glyphs) for more in rest
    ]


def _parts(watch: SessionModel, event: Event, width: int, glyphs: Glyphs) -> tuple[StyledLine, Span]:
    """Time, severity, kind and vehicle; then the text."""
    level = str(event.get("level") or "info")
    style = STYLES.get(level, "")
    mark = {"warning": glyphs.look, "critical": glyphs.act}.get(level, " ")
    who, text = watch.name(event.get("sysid")), clean(event.get("text") or "")
    if kind_of(event) == "operator":
        text = text.removeprefix("Operator: ")
    if text.casefold().startswith((f"{who} ", f"{who}: ")):
        text = text[len(who) :].lstrip(": ")
    if more := event.get("more"):
        text = f"{text} (+{more})"
    shown: StyledLine = [(f"{float(event.get('t_s') or 0.0):7.1f} ", "dim"), (f"{mark} ", style)]
    if width >= 60:
        shown.append((left(kind_of(event), 9), "dim"))
    return [*shown, (left(who, WHO) + " ", style or "who")], (text, style)


def window(
    watch: SessionModel, events: Sequence[Event], *, width: int, height: int, back: int, glyphs: Glyphs
) -> tuple[StyledLines, int]:
    """(As many whole `events` as `height` lines hold, how many are newer than these): the newest, or those `back`."""
    end = begin = max(len(events) - back, 0)
    shown: StyledLines = []
    while begin > 0 and len(part := entry(watch, events[begin - 1], width, glyphs)) + len(shown) <= height:
        begin, shown = begin - 1, part + shown
    while begin == 0 and end < len(events):
        part = entry(watch, events[end], width, glyphs)
        if len(shown) + len(part) > height:
            break
        end, shown = end + 1, shown + part
    return shown, len(events) - end
