"""The fleet from above as an array of pixels, by matplotlib."""

from __future__ import annotations

from collections import deque
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.extras import require
from gcs.scenario.colours import LIGHT
from gcs.scenario.model import Scenario
from gcs.scenario.plot import INK, MARGIN_M, bounds, draw_surroundings
from gcs.session.arrays import Snapshot

PIXELS, DOTS_PER_INCH = 480, 80
TRAIL = 100
"""Snapshots whose places are drawn behind each vehicle."""
MARKERS = {"pursuer": "o", "target": "*", "tanker": "s"}


class FleetDrawing:
    """Vehicles, their ways of late and their set points on the scenario's plan; north is up."""

    def __init__(self, scenario: Scenario) -> None:
        """Raises MissingExtra without Matplotlib."""
        require("render_mode='rgb_array'", {"matplotlib": "Matplotlib"}, "plots")
        self._trail: deque[NDArray[np.float64]] = deque(maxlen=TRAIL)
        self.begin(scenario)

    def begin(self, scenario: Scenario) -> None:
        """Draw the plan of an episode."""
        from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415 - an extra
        from matplotlib.figure import Figure  # noqa: PLC0415 - the same

        self._trail.clear()
        size = PIXELS / DOTS_PER_INCH
        self._canvas: Any = FigureCanvasAgg(Figure(figsize=(size, size), dpi=DOTS_PER_INCH))
        axes: Any = self._canvas.figure.add_subplot()
        axes.set_xlabel("east, m")
        axes.set_ylabel("north, m")
        axes.set_aspect("equal")
        draw_surroundings(axes, scenario)
        corners = np.array(bounds(scenario))
        self._axes, self._low, self._high = axes, corners[0], corners[1]
        self._colours = [LIGHT[k % len(LIGHT)] for k in range(len(scenario.vehicles.all))]
        self._lines: list[tuple[Any, Any, Any]] = []

    def add(self, snapshot: Snapshot) -> None:
        """The next snapshot: the ways go on to its places."""
        self._trail.append(snapshot.p_ned)

    def array(self, shown: Snapshot) -> NDArray[np.uint8]:
        """The newest snapshot as pixels, (PIXELS, PIXELS, 3)."""
        trail = np.array(self._trail)
        if not self._lines:
            for role, colour in zip(shown.role.tolist(), self._colours, strict=True):
                own = INK if role == "target" else colour
                (way,) = self._axes.plot([], [], "-", color=own, linewidth=1.0, alpha=0.6)
                (sent,) = self._axes.plot([], [], "+", color=own)
                (place,) = self._axes.plot([], [], MARKERS[role], color=own)
                self._lines.append((way, sent, place))
        for row, (way, sent, place) in enumerate(self._lines):
            way.set_data(trail[:, row, 1], trail[:, row, 0])
            sent.set_data(shown.set_point_p_ned[row, 1:2], shown.set_point_p_ned[row, :1])
            place.set_data(shown.p_ned[row, 1:2], shown.p_ned[row, :1])
        places = shown.p_ned[np.isfinite(shown.p_ned).all(axis=1), :2]
        south, west = np.min([self._low, *(places - MARGIN_M)], axis=0)
        north, east = np.max([self._high, *(places + MARGIN_M)], axis=0)
        self._axes.set_xlim(west, east)
        self._axes.set_ylim(south, north)
        self._axes.set_title(f"{shown.time_s:.1f} s")
        self._canvas.draw()
        return np.asarray(self._canvas.buffer_rgba())[..., :3].copy()
