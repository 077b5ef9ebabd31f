"""Tables of HTML, as notebooks show them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape


def html_table(rows: Iterable[Sequence[object]], head: Sequence[str] = ()) -> str:
    """A table of these rows, each value as text; with a head the cells are values, else the first of a row names it."""
    lines = ["<table>"]
    if head:
        lines.append("<thead><tr>" + "".join(f"<th>{escape(one)}</th>" for one in head) + "</tr></thead>")
    for row in rows:
        cells = [escape(str(one)) for one in row]
        first = f"<td>{cells[0]}</td>" if head else f"<th>{cells[0]}</th>"
        lines.append(f"<tr>{first}" + "".join(f"<td>{cell}</td>" for cell in cells[1:]) + "</tr>")
    return "".join([*lines, "</table>"])
