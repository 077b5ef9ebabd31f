"""The report's figures with matplotlib, for notebooks and papers."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any

import numpy as np

from gcs.extras import require
from gcs.report.charts import ChartPanel
from gcs.report.findings import Findings

PATHS = "paths"
WIDTH_IN, HEIGHT_IN = 8.0, 2.6


def plot_panels(panels: Sequence[ChartPanel], sysids: Collection[int]) -> Any:
    """Axes (k,) of matplotlib, one below the other, with the lines of these vehicles and those of the session."""
    require("plot()", {"matplotlib": "matplotlib"}, "plots")
    from matplotlib import pyplot  # noqa: PLC0415 - an extra

    _, grid = pyplot.subplots(
        len(panels), 1, sharex=True, squeeze=False, figsize=(WIDTH_IN, HEIGHT_IN * len(panels)), layout="constrained"
    )
    axes: Any = grid[:, 0]
    for one, panel in zip(axes, panels, strict=True):
        lines = [(f"{sysid}", line) for sysid, line in sorted(panel.of_vehicles.items()) if sysid in sysids]
        for label, line in (*lines, *(panel.of_session or {}).items()):
            one.plot(line.t_s, line.values, label=label)
        for limit, label in panel.limits:
            one.axhline(limit, color="0.5", linestyle="--", label=label)
        one.set_ylabel(panel.title if panel.unit == "1" else f"{panel.title}, {panel.unit}")
        if panel.from_zero:
            one.set_ylim(bottom=0.0)
        if one.get_legend_handles_labels()[1]:
            one.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    axes[-1].set_xlabel("session time, s")
    return axes


def plot_paths(findings: Findings, sysids: Collection[int]) -> Any:
    """Axes (1,) with the vehicles' ways from above, common NED frame."""
    require("plot()", {"matplotlib": "matplotlib"}, "plots")
    from matplotlib import pyplot  # noqa: PLC0415 - an extra

    _, one = pyplot.subplots(figsize=(WIDTH_IN, WIDTH_IN), layout="constrained")
    for sysid, track in findings.tracks.items():
        if sysid in sysids:
            one.plot(track.p_ned[:, 1], track.p_ned[:, 0], label=f"{sysid}")
    one.set_aspect("equal", adjustable="datalim")
    one.set_xlabel("east, m")
    one.set_ylabel("north, m")
    one.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return np.array([one])
