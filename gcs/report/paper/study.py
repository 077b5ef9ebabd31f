"""Results of which one part of the page is made."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from matplotlib.figure import Figure

Value = float | int | Sequence[float] | Sequence[int] | None


class PaperError(RuntimeError):
    """Reason why the page was not made, as a sentence."""


@dataclass(frozen=True)
class Measurement:
    """Measurement for a claim; `note` is said with the verdict. A value of None: nothing could be measured."""

    value: Value
    note: str = ""


@dataclass(frozen=True)
class Drawing:
    """A figure with its file's name and the sentence under it."""

    name: str
    caption: str
    figure: Figure


@dataclass(frozen=True)
class Table:
    """Numbers for people: a caption, the columns' names, rows of text."""

    caption: str
    columns: Sequence[str]
    rows: Sequence[Sequence[str]]


@dataclass(frozen=True)
class Study:
    """Measurements by the claims' ids, figures and tables of one part."""

    measured: Mapping[str, Measurement]
    drawings: Sequence[Drawing] = ()
    tables: Sequence[Table] = ()
