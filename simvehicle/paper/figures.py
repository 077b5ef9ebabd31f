"""The curves of studies.py as figures, SVG and PNG, drawn without a display."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import NDArray

Curves = Mapping[str, NDArray[np.float64]]
Numbers = Mapping[str, Any]

BLUE, ORANGE, GREEN, GREY = "#0072b2", "#d55e00", "#009e73", "#777777"  # distinguished by colour-blind eyes too
STYLE: dict[Any, Any] = {
    "font.size": 8.0,
    "axes.titlesize": 8.5,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e2e2e2",
    "grid.linewidth": 0.5,
    "lines.linewidth": 1.0,
    "legend.frameon": False,
    "legend.fontsize": 8.0,
    "savefig.dpi": 160,
    "svg.hashsalt": "skytender",  # the same figure is the same file
}
SHOWN_S = 10.0


def write(name: str, curves: Curves, numbers: Numbers, out: Path) -> list[str]:
    """Draw the figure of that name into the folder `out`; the names of its files, SVG first.

    Raises:
        OSError: a file cannot be written.
    """
    with matplotlib.rc_context(STYLE):
        figure = DRAWN[name](curves, numbers)
        FigureCanvasAgg(figure)
        figure.savefig(out / f"{name}.svg", metadata={"Date": None})
        figure.savefig(out / f"{name}.png")
    return [f"{name}.svg", f"{name}.png"]


def _fig5(curves: Curves, numbers: Numbers) -> Figure:
    figure = Figure(figsize=(7.2, 4.8), layout="constrained")
    axes = figure.subplots(3, 2, sharex=True, width_ratios=(3, 2))
    t, x, truth = curves["t"], curves["x"], curves["truth"]
    shown = t <= SHOWN_S
    labels = (r"$X_1$, rad", r"$X_2$, rad/s", r"$X_3$, rad/s²")
    truths = (r"$5\,\sin t$", r"$5\,\cos t$", r"$-5\,\sin t$")
    for k, (left, right) in enumerate(axes):
        left.plot(t[shown], x[shown, k], color=BLUE, label="differentiator")
        left.plot(t[shown], truth[shown, k], color="black", linewidth=0.9, dashes=(4, 3), label=truths[k])
        left.set_ylabel(labels[k])
        left.set_ylim(-8.0, 11.0)
        left.legend(loc="upper right", ncols=2, borderaxespad=0.1)
        right.plot(t[shown], (x - truth)[shown, k], color=ORANGE)
        right.axvline(numbers["settled_after_s"], color=GREY, linewidth=0.7, dashes=(2, 2))
        late = np.abs((x - truth)[t > numbers["settled_after_s"], k]).max()
        right.set_ylim(-2.2 * late, 2.2 * late)
        unit = ("rad", "rad_s", "rad_s2")[k]
        most, rms = numbers[f"x{k + 1}_error_max_{unit}"], numbers[f"x{k + 1}_error_rms_{unit}"]
        right.set_title(f"after {numbers['settled_after_s']:g} s: max {most:.3f}, rms {rms:.3f}", loc="right")
    axes[0, 0].set_title(
        f"implicit at {1e3 * numbers['step_s']:g} ms, ε = {numbers['epsilon_s']:g} s, X(0) = 0", loc="left"
    )
    axes[0, 1].set_title("error", loc="left")
    for column in axes[2]:
        column.set_xlabel("t, s")
        column.set_xlim(0.0, SHOWN_S)
    return figure


def _fig12(curves: Curves, numbers: Numbers) -> Figure:
    figure = Figure(figsize=(7.2, 5.4), layout="constrained")
    axes = figure.subplots(3, 2, sharex=True, sharey=True)
    rows = (
        ("sliding_mode", "sliding mode", ORANGE),
        ("high_gain", "linear high gain", GREEN),
        ("finite_time", "finite time, implicit", BLUE),
    )
    columns = (("clean", "sin t"), ("noisy", f"sin t with noise, {numbers['noise_std_rad']:g} rad rms"))
    for i, (name, words, colour) in enumerate(rows):
        for j, (case, signal) in enumerate(columns):
            plot = axes[i, j]
            t = curves[f"{case}_t"]
            shown = t <= SHOWN_S
            plot.plot(t[shown], curves[f"{case}_{name}"][shown], color=colour, linewidth=0.7)
            plot.plot(t[shown], curves[f"{case}_truth"][shown], color="black", linewidth=0.9, dashes=(4, 3))
            measured = numbers[case][name]
            most, rms = measured["derivative_error_max_rad_s"], measured["derivative_error_rms_rad_s"]
            said = f"error max {most:.3f}, rms {rms:.3f}; total variation {measured['total_variation_rad_s']:.0f}"
            plot.text(0.99, 0.97, said, transform=plot.transAxes, ha="right", va="top", fontsize=7.2)
            plot.set_title(f"{words}: {signal}", loc="left")
        axes[i, 0].set_ylabel("derivative, rad/s")
    axes[0, 0].set_ylim(-2.0, 2.6)
    axes[0, 0].set_xlim(0.0, SHOWN_S)
    for column in axes[2]:
        column.set_xlabel("t, s")
    truth = numbers["clean"]["truth"]["total_variation_rad_s"]
    figure.supxlabel(
        f"dashed: cos t, whose total variation over {numbers['duration_s']:g} s is {truth:.0f} rad/s; steps of "
        f"{1e3 * numbers['clean']['step_s']:g} ms; errors from {numbers['settled_after_s']:g} s on",
        fontsize=7.5,
    )
    return figure


def _implicit(curves: Curves, numbers: Numbers) -> Figure:
    figure = Figure(figsize=(7.2, 4.9), layout="constrained")
    grid = figure.add_gridspec(2, 2)
    torque, speed, trace = (figure.add_subplot(place) for place in (grid[0, 0], grid[0, 1], grid[1, :]))
    colours = {"explicit": ORANGE, "implicit": BLUE}
    for method, colour in colours.items():
        for noise, line in ((0.0, "-"), (0.02, "--")):
            cases = [c for c in numbers["cases"] if c["method"] == method and c["velocity_noise_m_s"] == noise]
            steps = [1e3 * case["step_s"] for case in cases]
            label = f"{method}, {'no noise' if noise == 0.0 else f'{noise:g} m/s noise'}"
            for plot, key in ((torque, "torque_rms_rad_s2"), (speed, "speed_error_rms_m_s")):
                values = [np.nan if case[key] is None else case[key] for case in cases]
                plot.plot(steps, values, line, color=colour, marker="o", markersize=3.5, label=label)
    for plot, words in ((torque, "torque, rad/s² rms"), (speed, "speed error, m/s rms")):
        _steps_axis(plot, words)
    handles, labels = torque.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=4, columnspacing=1.4)
    for method, colour in colours.items():
        rows = curves[f"{method}_0"]
        shown = rows[:, 0] <= numbers["counted_from_s"] + 1.0
        trace.plot(rows[shown, 0], rows[shown, 1], color=colour, linewidth=0.8)
    trace.set_xlabel("t, s")
    trace.set_ylabel("roll torque, rad/s²")
    trace.set_title("steady flight at 4 ms without noise", loc="left")
    return figure


def _steps_axis(plot: Axes, words: str) -> None:
    plot.set_xscale("log", base=2)
    plot.set_yscale("log")
    plot.set_xticks([1, 2, 4, 8], labels=["1", "2", "4", "8"])
    plot.set_xlabel("step, ms")
    plot.set_ylabel(words)


def _noise(curves: Curves, numbers: Numbers) -> Figure:
    figure = Figure(figsize=(7.2, 4.9), layout="constrained")
    grid = figure.add_gridspec(2, 2)
    torque, speed, trace = (figure.add_subplot(place) for place in (grid[0, 0], grid[0, 1], grid[1, :]))
    rivals = (
        ("high_gain", "linear high gain", GREEN),
        ("finite_time", "finite time", BLUE),
        ("sliding_mode", "sliding mode", ORANGE),
    )
    for name, words, colour in rivals:
        cases = [case for case in numbers["cases"] if case["differentiator"] == name]
        errors = [case["errors_over_sensors"] for case in cases]
        for plot, key in ((torque, "torque_rms_rad_s2"), (speed, "speed_error_rms_m_s")):
            plot.plot(errors, [case[key] for case in cases], color=colour, marker="o", markersize=3.5, label=words)
        rows = curves[name]
        shown = rows[:, 0] <= numbers["counted_from_s"] + 2.0
        trace.plot(rows[shown, 0], rows[shown, 1], color=colour, linewidth=0.7)
    for plot, words in ((torque, "torque, rad/s² rms"), (speed, "speed error, m/s rms")):
        plot.set_yscale("log")
        plot.set_xlabel("errors of the estimate over those of sensors: {}")
        plot.set_ylabel(words)
    handles, labels = torque.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=3)
    trace.set_xlabel("t, s")
    trace.set_ylabel("roll torque, rad/s²")
    trace.set_title("with the errors of sensors: {}", loc="left")
    return figure


DRAWN: dict[str, Callable[[Curves, Numbers], Figure]] = {
    "fig5": _fig5,
    "fig12": _fig12,
    "implicit": _implicit,
    "noise": _noise,
}
