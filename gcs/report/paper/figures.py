"""Looks of every figure of the page, and its files: SVG and PNG, without a display."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib
from cycler import cycler
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from gcs.report.paper.study import Drawing

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#777777")
"""Distinguished by colour-blind eyes too."""
STYLE: Any = {
    "font.size": 8.0,
    "axes.titlesize": 8.5,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e2e2e2",
    "grid.linewidth": 0.5,
    "lines.linewidth": 1.0,
    "legend.frameon": False,
    "legend.fontsize": 7.5,
    "savefig.dpi": 160,
    "svg.hashsalt": "skytender",  # the same figure is the same file
    "axes.prop_cycle": cycler(color=COLOURS),
}
WIDTH_IN = 7.6


@contextmanager
def style() -> Iterator[None]:
    """Figures made and saved within look like the others."""
    with matplotlib.rc_context(STYLE):
        yield


def sheet(height_in: float, rows: int = 1, columns: int = 1, **options: Any) -> tuple[Figure, Any]:
    """A figure and its axes (rows, columns)."""
    figure = Figure(figsize=(WIDTH_IN, height_in), layout="constrained")
    axes = figure.subplots(rows, columns, squeeze=False, **options)
    return figure, axes


def label(axes: Axes, x: str, y: str, title: str = "") -> None:
    """Name the axes; the unit stands in the name."""
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    if title:
        axes.set_title(title, loc="left")


def save(drawing: Drawing, folder: Path) -> None:
    """Write NAME.svg and NAME.png into `folder`. Raises OSError."""
    FigureCanvasAgg(drawing.figure)
    drawing.figure.savefig(folder / f"{drawing.name}.svg", metadata={"Date": None})
    drawing.figure.savefig(folder / f"{drawing.name}.png")
