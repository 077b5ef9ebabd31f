"""Curves over time, as characters."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from gcs.console.drawing.canvas import Canvas, Point
from gcs.console.text import Glyphs, StyledLines, left, number, right

AXIS = 5
LABEL = 9
GAP_S = 2.0
"""Samples farther apart are not joined: there was no competition between them."""


def chart(
    samples: Sequence[tuple[float, Mapping[str, float]]],
    names: Sequence[str],
    marks: Sequence[tuple[float, str]],
    *,
    style_of: Callable[[str], str],
    width: int,
    height: int,
    glyphs: Glyphs,
    span_s: float,
    now_s: float,
) -> StyledLines:
    """The curves `names` of `samples`, each (time in s, {name: value from 0}), over the last `span_s` up to `now_s`.

    Every curve of the newest sample has its name at the right, as far as there is room, and its value unless it is
    over; `marks` are (time in s, text) to be drawn as upright lines. Time runs to the right, from 0 until `span_s` is
    full, then with the present at the edge.
    """
    columns, rows = width - AXIS - LABEL, height - 1
    if columns < 8 or rows < 3:
        return []
    end_s = max(now_s, span_s)
    begin_s = end_s - span_s
    top = max(1.0, *(value for _, values in samples for name in names if (value := values.get(name)) is not None), 0.0)
    canvas = Canvas(columns, rows, glyphs)

    def x(t_s: float) -> float:
        return (t_s - begin_s) / span_s * (canvas.width - 1)

    def y(value: float) -> float:
        return (1.0 - value / top) * (canvas.height - 1)

    for share in (0.0, 0.5, 1.0):
        canvas.line((0, y(share * top)), (canvas.width - 1, y(share * top)), "faint", every=4 if glyphs.unicode else 3)
    for t_s, text in marks:
        if begin_s <= t_s <= end_s:
            canvas.line((x(t_s), 0), (x(t_s), canvas.height - 1), "mark", 1, every=2)
            canvas.put(int(x(t_s) // canvas.per_column) + 1, 0, text, "mark", 1)
    labels: dict[int, tuple[str, str]] = {}
    for order, name in enumerate(names):
        style = style_of(name)
        run: list[Point] = []
        last_s = begin_s
        for t_s, values in samples:
            if t_s >= begin_s and name in values:
                if t_s - last_s > GAP_S:
                    run = []
                here = (x(t_s), y(values[name]))
                canvas.path([*run[-1:], here, here], style, max(2, 9 - order))
                run, last_s = [here], t_s
        value = samples[-1][1].get(name) if samples and samples[-1][0] >= begin_s else None
        if value is not None:
            shown = f" {name:>3} {value:.2f}" if now_s - samples[-1][0] <= GAP_S else f" {name:>3}"
            row = min(rows - 1, max(0, int(y(value) // canvas.per_row)))
            for shift in sorted(range(-rows, rows), key=abs):
                if 0 <= row + shift < rows and row + shift not in labels:
                    labels[row + shift] = (shown, style)
                    break
    lines: StyledLines = []
    axis = {0: top, (rows - 1) // 2: None, rows - 1: 0.0}
    for row, line in enumerate(canvas.lines()):
        value = axis.get(row)
        text, style = labels.get(row, ("", ""))
        scale = right(number(value, AXIS - 1, 1), AXIS - 1) if value is not None else " " * (AXIS - 1)
        lines.append([(f"{scale} ", "dim"), *line, (left(text, LABEL), style)])
    first, last = f"{begin_s:.0f} s", f"{end_s:.0f} s"
    lines.append([(" " * AXIS + left(first, columns - len(last)) + last + " " * LABEL, "dim")])
    return lines
