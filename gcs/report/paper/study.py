"""Results of which one part of the page is made."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from gcs.report.paper.claims import Measurement
from gcs.report.paper.figures import Drawing


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
    tables: Sequence[Table] = field(default=())
