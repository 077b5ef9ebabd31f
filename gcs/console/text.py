"""Text tools of every panel: styled text of fixed width, numbers that keep their column, bars, characters.

A line is a list of (text, style name) pairs. A style name is words from `gcs/console/styles.py`, so that what a
panel says can be computed, and tested, without a terminal.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from rich.cells import cell_len, set_cell_size

Span = tuple[str, str]
StyledLine = list[Span]
StyledLines = list[StyledLine]

WITHOUT_BRAILLE = {"linux", "vt100", "vt102", "vt220", "ansi", "cons25"}
"""Terminals by name whose fonts have no braille, whatever the locale says."""


@dataclass(frozen=True)
class Glyphs:
    """The characters that a terminal can show."""

    unicode: bool
    full: str
    empty: str
    times: str
    more: str
    rule: str
    act: str
    look: str
    chosen: str
    yes: str
    no: str
    up: str
    live: str
    dot: str
    meet: str
    wall: str
    traffic: str


UNICODE = Glyphs(True, "━", "─", "×", "…", "─", "▲", "!", "▸", "●", "○", "↑", "●", "·", "◎", "×", "◆")
ASCII = Glyphs(False, "#", ".", "x", "..", "-", "A", "!", ">", "y", "n", "^", "*", "-", "@", "#", "X")


def can_unicode(environment: Mapping[str, str], encoding: str) -> bool:
    """Whether the terminal shows more than ASCII, as its environment and the stream's encoding say."""
    if "utf" not in encoding.lower() or environment.get("TERM", "") in WITHOUT_BRAILLE:
        return False
    locale = environment.get("LC_ALL") or environment.get("LC_CTYPE") or environment.get("LANG") or "UTF-8"
    return "utf" in locale.lower()


def given_environment() -> dict[str, str]:
    """This process's environment without the locale that Python gives itself where it finds none but C (PEP 538)."""
    environment = dict(os.environ)
    try:
        given = Path("/proc/self/environ").read_bytes().split(b"\0")
    except OSError:
        return environment
    if not any(entry.startswith(b"LC_CTYPE=") and entry != b"LC_CTYPE=" for entry in given):
        environment.pop("LC_CTYPE", None)
    return environment


def own_glyphs(encoding: str) -> Glyphs:
    """The characters for this process's terminal."""
    return UNICODE if can_unicode(given_environment(), encoding) else ASCII


def number(value: float | None, width: int, decimals: int = 1) -> str:
    """`value` with as many decimals as fit `width`, else in thousands (`12k`) or millions; `-` for unknown."""
    if value is None:
        return "-"
    shown = ""
    for scale, unit, most in ((1.0, "", decimals), (1e3, "k", 1), (1e6, "M", 1), (1e9, "G", 1)):
        for places in range(most, -1, -1):
            shown = f"{value / scale:.{places}f}{unit}"
            if len(shown) <= width:
                return shown.replace("-", "") if float(shown.rstrip("kMG")) == 0.0 and not unit else shown
    return shown


def bar(share: float, width: int, glyphs: Glyphs, style: str) -> StyledLine:
    """A bar of `width` cells filled by `share` in 0..1; what is more than nothing shows."""
    share = min(max(share, 0.0), 1.0)
    full = min(width, math.ceil(share * width - 0.5) or (share > 0.0))
    return [(glyphs.full * full, style), (glyphs.empty * (width - full), "faint")]


def width_of(line: Iterable[Span]) -> int:
    """Cells that a line takes."""
    return sum(cell_len(text) for text, _ in line)


def left(text: str, width: int) -> str:
    """`text` in exactly `width` cells, cut or filled at its end."""
    return set_cell_size(text, width)


def right(text: str, width: int) -> str:
    """`text` in exactly `width` cells, filled at its start."""
    return " " * max(0, width - cell_len(text)) + text if cell_len(text) <= width else set_cell_size(text, width)


def fitted(line: Iterable[Span], width: int, glyphs: Glyphs) -> StyledLine:
    """The line in exactly `width` cells: filled with blanks, or cut with a mark that says so."""
    line = list(line)
    room = width - width_of(line)
    if room >= 0:
        return [*line, (" " * room, "")] if room else line
    shown: StyledLine = []
    room = width - cell_len(glyphs.more)
    for text, style in line:
        size = cell_len(text)
        if size > room:
            shown += [(set_cell_size(text, max(room, 0)), style), (glyphs.more, "dim")]
            break
        shown.append((text, style))
        room -= size
    return fitted(shown, width, glyphs) if width_of(shown) < width else shown


def titled(title: str, width: int, glyphs: Glyphs, note: StyledLine | None = None) -> StyledLine:
    """A panel's heading: its title, a rule, and a note at the right."""
    note = note or []
    room = width - cell_len(title) - 4 - (width_of(note) + 1 if note else 0)
    if room < 0:
        return fitted([(f"{title} ", "title")], width, glyphs)
    line: StyledLine = [(f"{glyphs.rule} ", "faint"), (title, "title"), (" ", ""), (glyphs.rule * room, "faint")]
    return [*line, (" ", ""), *note, (glyphs.rule, "faint")] if note else [*line, (glyphs.rule, "faint")]


def wrapped(text: str, width: int) -> list[str]:
    """Words over as many lines as they need."""
    lines = [""]
    for word in text.split():
        joined = f"{lines[-1]} {word}".strip()
        if cell_len(joined) <= width or not lines[-1]:
            lines[-1] = joined
        else:
            lines.append(word)
    return lines
