"""A drawing made of characters: dots finer than a cell (2 x 4 in braille, 1 x 2 in ASCII), and text on top of them.

Dots are square in a terminal whose cells are twice as high as wide. Of two things in one cell the higher rank shows.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from gcs.console.text import Glyphs, StyledLine, StyledLines

_BRAILLE = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
_BRAILLE_START = 0x2800
_HALVES = (" ", "'", ".", ":")

Point = tuple[float, float]


class Canvas:
    """`columns` x `rows` cells. Dots are counted from the upper left corner, x to the right and y down."""

    def __init__(self, columns: int, rows: int, glyphs: Glyphs) -> None:
        self.columns, self.rows = columns, rows
        self._fine = glyphs.unicode
        self.per_column, self.per_row = (2, 4) if self._fine else (1, 2)
        self.width, self.height = columns * self.per_column, rows * self.per_row
        self._dots = [[0] * columns for _ in range(rows)]
        self._text: list[list[str]] = [[""] * columns for _ in range(rows)]
        self._styles = [[""] * columns for _ in range(rows)]
        self._ranks = [[-1] * columns for _ in range(rows)]

    def dot(self, x: float, y: float, style: str, rank: int = 0) -> None:
        """One dot; outside the canvas nothing."""
        column, row = int(x // self.per_column), int(y // self.per_row)
        if not (0 <= column < self.columns and 0 <= row < self.rows):
            return
        bit = _BRAILLE[int(y) % 4][int(x) % 2] if self._fine else 1 + int(y) % 2
        self._dots[row][column] |= bit
        if rank >= self._ranks[row][column]:
            self._ranks[row][column], self._styles[row][column] = rank, style

    def line(self, a: Point, b: Point, style: str, rank: int = 0, *, every: int = 1) -> None:
        """A straight line from a to b, of which `every`th dot is set."""
        inside = self._clipped(a, b)
        if inside is None:
            return
        (x0, y0), (x1, y1) = inside
        steps = max(1, round(max(abs(x1 - x0), abs(y1 - y0))))
        for i in range(0, steps + 1, every):
            self.dot(x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps, style, rank)

    def path(self, points: Sequence[Point], style: str, rank: int = 0, *, every: int = 1) -> None:
        """Lines from point to point."""
        for a, b in pairwise(points):
            self.line(a, b, style, rank, every=every)

    def _clipped(self, a: Point, b: Point) -> tuple[Point, Point] | None:
        """The part of the line that is on the canvas (Liang, Barsky: A New Concept and Method for Line Clipping)."""
        (x0, y0), (x1, y1) = a, b
        dx, dy = x1 - x0, y1 - y0
        enter, leave = 0.0, 1.0
        for step, room in ((-dx, x0), (dx, self.width - 1 - x0), (-dy, y0), (dy, self.height - 1 - y0)):
            if step == 0.0:
                if room < 0.0:
                    return None
            elif step < 0.0:
                enter = max(enter, room / step)
            else:
                leave = min(leave, room / step)
        if enter > leave:
            return None
        return (x0 + enter * dx, y0 + enter * dy), (x0 + leave * dx, y0 + leave * dy)

    def put(self, column: int, row: int, text: str, style: str, rank: int = 0) -> None:
        """Characters of one cell each, from this cell on; what is higher in rank already stays."""
        if not 0 <= row < self.rows:
            return
        for at, letter in enumerate(text, column):
            if 0 <= at < self.columns and rank >= self._ranks[row][at]:
                self._text[row][at], self._styles[row][at], self._ranks[row][at] = letter, style, rank

    def free(self, column: int, row: int, length: int) -> bool:
        """Whether these cells are on the canvas and hold no text yet."""
        if not (0 <= row < self.rows and column >= 0 and column + length <= self.columns):
            return False
        return not any(self._text[row][column : column + length])

    def lines(self) -> StyledLines:
        """The drawing, as many lines as rows."""
        return [self._line(row) for row in range(self.rows)]

    def _line(self, row: int) -> StyledLine:
        line: StyledLine = []
        run, run_style = "", ""
        for dots, text, style in zip(self._dots[row], self._text[row], self._styles[row], strict=True):
            if text:
                letter = text
            elif not dots:
                letter, style = " ", "" if "chosen" in run_style else run_style  # noqa: PLW2901 - a blank takes any ink
            else:
                letter = chr(_BRAILLE_START + dots) if self._fine else _HALVES[dots]
            if style != run_style and run:
                line.append((run, run_style))
                run = ""
            run, run_style = run + letter, style
        return [*line, (run, run_style)]
