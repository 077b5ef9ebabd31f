"""A rectangle of lines in a terminal. Only the lines that have changed are drawn again."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rich.segment import Segment
from textual import events
from textual.geometry import Region
from textual.strip import Strip
from textual.widget import Widget

from gcs.console.shell import Shell
from gcs.console.styles import style
from gcs.console.text import StyledLines, width_of

Paint = Callable[[int, int], StyledLines]
Pointed = Callable[[int, int, int], object]


class Panel(Widget):
    """Shows what `paint(width, height)` returns, on the style `ground`.

    `pointed(column, row, turn)` is called for clicks (0) and the wheel (±1).
    """

    app: Shell

    def __init__(
        self, paint: Paint, *, id: str, classes: str = "", ground: str = "", pointed: Pointed | None = None
    ) -> None:
        super().__init__(id=id, classes=classes)
        self._paint = paint
        self._ground = ground
        self._pointed = pointed
        self._lines: StyledLines = []
        self._strips: list[Strip] = []

    def again(self) -> None:
        """Paint all of it, as after a change of the look."""
        self._lines, self._strips = [], []
        self.redraw()

    def redraw(self) -> None:
        """Take in what is new."""
        width, height = self.size
        if not width or not height or not self.display:
            return
        lines = self._paint(width, height)[:height]
        lines += [[] for _ in range(height - len(lines))]
        if len(lines) != len(self._lines):
            self._lines, self._strips = lines, [self._strip(line) for line in lines]
            self.refresh()
            return
        changed = [row for row, line in enumerate(lines) if line != self._lines[row]]
        for row in changed:
            self._lines[row], self._strips[row] = lines[row], self._strip(lines[row])
        if changed:
            self.refresh(*(Region(0, row, width, 1) for row in changed))

    def _strip(self, line: list[tuple[str, str]]) -> Strip:
        look = self.app.look
        width = self.size.width
        segments = [Segment(text, style(f"{self._ground} {names}", look)) for text, names in line if text]
        return Strip(segments, width_of(line)).adjust_cell_length(width, style(self._ground, look))

    def render_line(self, y: int) -> Strip:
        """One line as it was last painted."""
        if y < len(self._strips):
            return self._strips[y]
        return Strip.blank(self.size.width, style(self._ground, self.app.look))

    def on_resize(self) -> None:
        """Paint for the new size."""
        self.again()

    def on_click(self, event: events.Click) -> None:
        """Notify the listener."""
        self._point(event, 0)

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        """Notify the listener."""
        self._point(event, -1)

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        """Notify the listener."""
        self._point(event, 1)

    def _point(self, event: Any, turn: int) -> None:
        if self._pointed is not None:
            event.stop()
            self._pointed(event.x, event.y, turn)
