"""Example 3's competition with noise (paper Fig. 13) and delay (Fig. 14), docs/model/competition.md#noise-and-delay."""

from __future__ import annotations

import functools
import itertools

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from gcs.recording.series import Floats
from gcs.refuelling.simulated_competition import simulate
from gcs.report.paper import figures, races
from gcs.report.paper.examples import EXPONENTS
from gcs.report.paper.study import Drawing, Measurement, Study, Table

VARIANCES = (0.1, 1.0, 10.0)
NOISY_EXPONENTS = (1.5, 2.0, 2.5)
DURATION_S, WINDOW_S, SAMPLE_S = 300.0, 60.0, 0.05
SEED = 1
DELAYS_S = (0.1, 0.2, 0.3)  # of UAVs 1-5, 6-10, 11-15


def fig13(v0: Floats, tau: Floats) -> Study:
    """Noise as samples held for 1 ms, and as a stochastic differential equation."""
    times = np.arange(0.0, DURATION_S + SAMPLE_S / 2, SAMPLE_S)
    window = times >= DURATION_S - WINDOW_S
    winner = int(tau.argmax())
    held: dict[tuple[float, float], Floats | None] = {}
    error: dict[float, list[float]] = {variance: [] for variance in VARIANCES}
    in_size: dict[float, list[float]] = {variance: [] for variance in VARIANCES}
    spread: dict[tuple[float, float], float] = {}
    rows, sde = [], []
    for p in NOISY_EXPONENTS:
        still = simulate(v0, tau, times, p=p, rate=1.0)[window].mean(axis=0)
        run = functools.partial(simulate, v0, tau, times, p=p, rate=1.0, seed=SEED)
        for variance in VARIANCES:
            noisy = functools.partial(run, noise="held", noise_variance=variance)
            states = held[p, variance] = races.disturbed(noisy)
            error[variance].append(_off(states, window, still))
            in_size[variance].append(_off(states, window, still, size=True))
            spread[p, variance] = float("nan") if states is None else float(states[window, winner].std())
            mean = float("nan") if states is None else float(states[window, winner].mean())
            numbers = (mean, float(still[winner]), spread[p, variance], error[variance][-1])
            rows.append([f"{p:g}", f"{variance:g}", *(f"{number:.4f}" for number in numbers)])
        sde.append(_off(races.disturbed(functools.partial(run, noise="sde", noise_variance=0.1)), window, still))
    steps = {p: [spread[p, variance] for variance in VARIANCES] for p in NOISY_EXPONENTS}
    least = min(NOISY_EXPONENTS, key=lambda p: min(b / a for a, b in itertools.pairwise(steps[p])))
    mirrored = (
        f"the winner starts at {v0[winner]:.2g}: noise can carry a small state below zero, and the equation settles "
        "as well at the mirror image; by the size of the mean the greatest difference is {:.3g}"
    )
    measured = {
        f"fig13-held-{variance:g}": Measurement(max(error[variance]), mirrored.format(max(in_size[variance])))
        for variance in VARIANCES
    }
    measured["fig13-sde"] = Measurement(max(sde), f"p = 1.5, 2, 2.5: {', '.join(f'{x:.3g}' for x in sde)}")
    measured["fig13-variance"] = Measurement(steps[least], f"p = {least:g}")
    measured["fig13-p"] = Measurement([spread[p, 1.0] for p in NOISY_EXPONENTS], "p = 1.5, 2, 2.5")
    columns = ["p", "variance", "winner's mean, last 60 s", "without noise", "its standard deviation", "worst error"]
    caption = "Fig. 13: noise held for 1 ms, rows p = 1.5, 2, 2.5, columns variance 0.1, 1, 10; the winner in black."
    drawing = Drawing("fig13", caption, _noise_figure(times, held, winner))
    return Study(measured, [drawing], [Table("Noise as samples held for 1 ms", columns, rows)])


def fig14(v0: Floats, tau: Floats) -> Study:
    """Each state's own delay: v_i' = c (τ_i - Σ v_j^p) v_i(t - d_i)."""
    delay = np.repeat(DELAYS_S, len(tau) // len(DELAYS_S))
    times = np.linspace(0.0, races.EVENTUALLY_S, 2001)
    left, rows = [], []
    figure, axes = figures.sheet(4.2, 2, 2, sharex=True)
    winner = int(tau.argmax())
    for axis, p in zip(axes.flat, EXPONENTS, strict=True):
        states = races.disturbed(functools.partial(simulate, v0, tau, times, p=p, rate=1.0, delay_s=delay))
        figures.label(axis, "time, s", "v", f"p = {p:g}")
        left.append(float("inf") if states is None else races.remoteness(states[-1], tau, p))
        if states is not None:
            _draw(axis, times, states, winner, 150.0)
            rows.append([f"{p:g}", str(int(states[-1].argmax()) + 1), f"{states[-1].max():.4f}", f"{left[-1]:.2e}"])
        else:
            rows.append([f"{p:g}", "–", "grows beyond all bounds", "–"])
    columns = ["p", "winner", "its state after 1000 s", "greatest distance to the limit"]
    drawing = Drawing("fig14", "Fig. 14: delays of 0.1, 0.2 and 0.3 s, c = 1; the winner in black.", figure)
    return Study({"fig14-delay": Measurement(max(left))}, [drawing], [Table("With delay", columns, rows)])


def _off(states: Floats | None, window: NDArray[np.bool_], still: Floats, *, size: bool = False) -> float:
    """Greatest difference of a state's mean, or of that mean's size, to the one without noise."""
    if states is None:
        return float("inf")
    mean = states[window].mean(axis=0)
    return float(np.abs((np.abs(mean) if size else mean) - still).max())


def _noise_figure(times: Floats, held: dict[tuple[float, float], Floats | None], winner: int) -> Figure:
    figure, axes = figures.sheet(5.4, 3, 3, sharex=True)
    for row, p in enumerate(NOISY_EXPONENTS):
        for column, variance in enumerate(VARIANCES):
            axis, states = axes[row, column], held[p, variance]
            if states is not None:
                _draw(axis, times, states, winner, DURATION_S)
            title = f"p = {p:g}, σ² = {variance:g}"
            figures.label(axis, "time, s" if row == 2 else "", "v" if column == 0 else "", title)
    return figure


def _draw(axis: Axes, times: Floats, states: Floats, winner: int, until_s: float) -> None:
    """At most 600 points a curve: more cannot be seen, and would only make the page heavy."""
    shown = np.flatnonzero(times <= until_s)
    shown = shown[:: max(1, len(shown) // 600)]
    for i in range(states.shape[1]):
        if i != winner:
            axis.plot(times[shown], states[shown, i], linewidth=0.6)
    axis.plot(times[shown], states[shown, winner], color="black", linewidth=1.0)
