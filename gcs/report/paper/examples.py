"""The paper's Examples 1 to 4 from their recorded sessions (docs/model/examples.md#paper-examples; paper Figs. 7 to
11)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from gcs.recording.series import Floats
from gcs.refuelling.simulated_competition import simulate
from gcs.report.paper import figures, flown, races, session, tracking
from gcs.report.paper.session import RecordedFlight
from gcs.report.paper.study import Drawing, Measurement, Study, Table
from gcs.scenario.model import Scenario

EXPONENTS = (1.5, 2.0, 2.5, 5.0)
SHOWN_S = 150.0
RATIO_1, RATIO_P, SHARE = "losers below 1 %, c = 1", "losers below 1 %, c = 1/p", "0.9 of the sum, c = 1"
DYNAMIC_FROM_S = 20.0
DYNAMIC_STEP_S = 1.0


def example1(scenario: Scenario, folder: Path) -> Study:
    """Five vehicles from one start: paths, speeds, attitudes, and their competition (Figs. 7 and 8)."""
    flights = session.flights_of(scenario, folder)
    v0, effort = races.initial_states(flights), races.efforts(flights)
    tau = races.least_wins(effort)
    paths, drawings, tables = _paths("ex1", "fig7a", "7(a)", scenario, flights)
    measured = paths | tracking.measure("ex1", flights) | _race("ex1", flights, v0, tau, paper=None)
    obstacles, _, end = session.world(scenario)
    measured |= {
        "ex1-arrival-flown": flown.arrival(flights, end),
        "ex1-clearance-flown": flown.clearance(flights, obstacles),
        "ex1-along": flown.along(flights),
        "ex1-transient": flown.transient(flights),
        "ex1-pitch": flown.pitch(flights),
    }
    drawings += [
        Drawing(
            "fig7bc",
            "Figs. 7(b) and 7(c): speeds and attitudes of the five vehicles.",
            tracking.tracking_figure(flights),
        ),
        Drawing("fig8", "Fig. 8: static competition, p = 2, c = 1, least control effort wins.", _static(v0, tau)),
    ]
    return Study(measured, drawings, [*tables, _bids(flights, effort, v0, tau)])


def example2(scenario: Scenario, folder: Path) -> Study:
    """Three vehicles from three starts (Fig. 9); all states start at 0.8, the paper's."""
    flights = session.flights_of(scenario, folder)
    effort = races.efforts(flights)
    v0, tau = np.full(len(flights), 0.8), races.least_wins(effort)
    order = [flights[i].sysid for i in np.argsort(effort, kind="stable")]
    ratios = [float(x) for x in effort / effort[0]]
    paths, drawings, tables = _paths("ex2", "fig9b", "9(b)", scenario, flights)
    measured = paths | tracking.measure("ex2", flights) | _race("ex2", flights, v0, tau, paper=1)
    measured["ex2-energy-order"] = Measurement(order, f"control efforts {_listed(effort)}")
    measured["ex2-energy-ratio"] = Measurement(ratios)
    obstacles, way, end = session.world(scenario)
    measured |= {
        "ex2-arrival-flown": flown.arrival(flights, end),
        "ex2-clearance-flown": flown.clearance(flights, obstacles),
        "ex2-length": flown.length(flights, way, end),
    }
    drawings += [
        Drawing("fig9a", "Fig. 9(a): speeds and attitudes of the three vehicles.", tracking.tracking_figure(flights)),
        Drawing("fig9c", "Fig. 9(c): competition from 0.8, p = 2, c = 1.", _static(v0, tau)),
    ]
    return Study(measured, drawings, [*tables, _bids(flights, effort, v0, tau)])


def example3(scenario: Scenario, folder: Path) -> Study:
    """Fifteen vehicles: which wins, and how fast for each p under three criteria (Fig. 10)."""
    flights = session.flights_of(scenario, folder)
    v0, effort = races.initial_states(flights), races.efforts(flights)
    tau = races.least_wins(effort)
    speed = tracking.measure("ex3", flights)["ex3-speed"]
    winner = flights[int(tau.argmax())].sysid
    second, gap = _runner_up(flights, tau)
    left = [races.remoteness(races.eventually(v0, tau, p=p), tau, p) for p in EXPONENTS]
    solver = max(races.solver_error(v0, tau, p=p, duration_s=SHOWN_S) for p in EXPONENTS)
    finer = max(races.solver_error(v0, tau, p=p, duration_s=SHOWN_S, rtol=3e-14) for p in EXPONENTS)
    times = convergence_times(v0, tau)
    close = f"the next, vehicle {second}, bids {gap:.4f} less than the winner, {winner}"
    why_1 = "with c = 1 the ratio of two states does not depend on p (docs/model/competition.md#convergence-time)"
    measured = {
        "ex3-speed": speed,
        "ex3-winner": Measurement(winner, f"control efforts {_listed(effort)}"),
        "ex3-competition": Measurement(max(left), close),
        "fig10-solver": Measurement(solver, f"at rtol 3e-14 it is {finer:.1e}: the error is the solver's own"),
        "fig10-order-ratio": Measurement(times[RATIO_1], why_1),
        "fig10-times-ratio": Measurement(times[RATIO_1], close),
        "fig10-order-rate": Measurement(times[RATIO_P]),
        "fig10-ratios-rate": Measurement([t / times[RATIO_P][0] for t in times[RATIO_P]]),
        "fig10-times-rate": Measurement(times[RATIO_P], close),
        "fig10-order-share": Measurement(times[SHARE]),
        "fig10-times-share": Measurement(times[SHARE], close),
    }
    rows = [[name, *(f"{t:.1f}" for t in values)] for name, values in times.items()]
    rows.append(["the paper", "50", "70", "90", "> 140"])
    spent = Table("Time until the race is over, s", ["criterion", *(f"p = {p:g}" for p in EXPONENTS)], rows)
    obstacles, way, end = session.world(scenario)
    drawings = [
        Drawing("fig10", "Fig. 10: fifteen states for four p, c = 1; the winner in black.", _four(v0, tau, 1.0)),
        Drawing("fig10-rate", "Fig. 10 with c = 1/p.", _four(v0, tau, None)),
        Drawing(
            "fig10-paths",
            "Example 3: planned and flown paths of the fifteen vehicles.",
            tracking.path_figure(flights, obstacles, way, end),
        ),
    ]
    return Study(measured, drawings, [spent, _bids(flights, effort, v0, tau)])


def convergence_times(v0: Floats, tau: Floats) -> dict[str, list[float]]:
    """Times in s for each of EXPONENTS, under the three criteria of docs/model/competition.md#convergence-time."""
    return {
        RATIO_1: [races.time_to_win(v0, tau, p=p, rate=1.0, criterion="ratio") for p in EXPONENTS],
        RATIO_P: [races.time_to_win(v0, tau, p=p, rate=1.0 / p, criterion="ratio") for p in EXPONENTS],
        SHARE: [races.time_to_win(v0, tau, p=p, rate=1.0, criterion="share") for p in EXPONENTS],
    }


def example4(scenario: Scenario, folder: Path) -> Study:
    """Dynamic competition, and the order in which a tanker refuels (Fig. 11)."""
    flights = session.flights_of(scenario, folder)
    end_s = scenario.goal.duration_s
    times = np.arange(0.0, end_s + 1e-9, DYNAMIC_STEP_S)
    v0 = races.initial_states(flights)
    states, effort = races.dynamic(flights, times, v0)
    late = times >= DYNAMIC_FROM_S
    followed = float(np.mean(states[late].argmax(axis=1) == effort[late].argmax(axis=1)))
    record = session.summary(folder)
    served = first_served(record)
    most = flights[int(effort[-1].argmax())].sysid
    measured = {
        "ex4-dynamic": Measurement(followed, f"vehicle {most} has the greatest control effort at the end"),
        "ex4-order": Measurement(served, _how_decided(record)),
        "ex4-order-effort": Measurement(races.served_in_fifths(flights, end_s)),
    }
    drawings = [
        Drawing(
            "fig11",
            "Fig. 11: states of the dynamic competition (above), control effort beyond the least (middle), and what "
            "each battery lacks (below).",
            _dynamic_figure(flights, times, states, effort, folder),
        )
    ]
    return Study(measured, drawings, [services_table(record)])


def services_table(record: Mapping[str, Any]) -> Table:
    """Refuellings of a session, by its summary."""
    services = [
        [
            *(str(s["receiver"]), s["by"]),
            *(_seconds(s[key]) for key in ("decided_at_s", "start_s", "end_s")),
            f"{s['energy_j']:.0f}",
        ]
        for s in record["refuelling"]
    ]
    columns = ["receiver", "decided by", "decided, s", "transfer from, s", "to, s", "energy, J"]
    return Table("Refuelling as it was flown", columns, services)


def _how_decided(record: Mapping[str, Any]) -> str:
    """By what the first services were decided; needs come in steps of BATTERY_STATUS's 100 J."""
    by = ", ".join(f"{s['receiver']} by {s['by']}" for s in record["refuelling"][:5])
    return f"{by}; the five fly with the paper's gains, needs are known to 100 J (BATTERY_STATUS)"


def first_served(record: Mapping[str, Any]) -> list[int]:
    """System ids in the order of their first refuelling, by a session's summary."""
    order: list[int] = []
    for sysid in record["refuel_order"]:
        if sysid not in order:
            order.append(sysid)
    return order


def _paths(
    prefix: str, name: str, figure: str, scenario: Scenario, flights: Sequence[RecordedFlight]
) -> tuple[dict[str, Measurement], list[Drawing], list[Table]]:
    obstacles, way, end = session.world(scenario)
    arrival = tracking.arrival_errors(flights, way, end)
    clear = tracking.clearances(flights, obstacles)
    measured = {
        f"{prefix}-path": Measurement(max(arrival), f"worst of {len(flights)} vehicles"),
        f"{prefix}-clearance": Measurement(min(clear), f"worst of {len(flights)} vehicles"),
    }
    caption = (
        f"Fig. {figure}: planned path, and what was flown. The paper's law holds the speed, not the place: what an "
        "initial attitude and speed carry a vehicle aside is never taken back."
    )
    drawing = Drawing(name, caption, tracking.path_figure(flights, obstacles, way, end))
    return measured, [drawing], [tracking.table(flights, obstacles)]


def _race(
    prefix: str, flights: Sequence[RecordedFlight], v0: Floats, tau: Floats, *, paper: int | None
) -> dict[str, Measurement]:
    second, gap = _runner_up(flights, tau)
    winner = flights[int(tau.argmax())].sysid
    note = f"the next, vehicle {second}, bids {gap:.4f} less"
    left = races.remoteness(races.eventually(v0, tau, p=2.0), tau, 2.0)
    return {
        f"{prefix}-winner": Measurement(winner, f"vehicle {winner} wins; {note}" if paper is None else note),
        f"{prefix}-competition": Measurement(left, note),
    }


def _runner_up(flights: Sequence[RecordedFlight], tau: Floats) -> tuple[int, float]:
    order = np.argsort(-tau, kind="stable")
    return flights[order[1]].sysid, float(tau[order[0]] - tau[order[1]])


def _bids(flights: Sequence[RecordedFlight], effort: Floats, v0: Floats, tau: Floats) -> Table:
    rows = [
        [str(f.sysid), f"{effort[i]:.3f}", f"{effort[i] / effort.min():.4f}", f"{tau[i]:.4f}", f"{v0[i]:.4f}"]
        for i, f in enumerate(flights)
    ]
    columns = ["vehicle", "control effort at the end of its path", "over the least", "τ", "v(0)"]
    return Table("What competes: control efforts as reported over MAVLink, normalised to [0.01, 1]", columns, rows)


def _static(v0: Floats, tau: Floats) -> Figure:
    figure, axes = figures.sheet(2.6)
    _draw_states(axes[0, 0], v0, tau, 2.0, 1.0)
    figures.label(axes[0, 0], "time, s", "v")
    axes[0, 0].legend(ncols=5)
    return figure


def _four(v0: Floats, tau: Floats, rate: float | None) -> Figure:
    figure, axes = figures.sheet(4.2, 2, 2, sharex=True)
    for axis, p in zip(axes.flat, EXPONENTS, strict=True):
        _draw_states(axis, v0, tau, p, rate or 1.0 / p)
        figures.label(axis, "time, s", "v", f"p = {p:g}")
    return figure


def _draw_states(axis: Axes, v0: Floats, tau: Floats, p: float, rate: float) -> None:
    times = np.linspace(0.0, SHOWN_S, 301)
    states = simulate(v0, tau, times, p=p, rate=rate)
    for i in range(len(tau)):
        if i != int(tau.argmax()):
            axis.plot(times, states[:, i], label=str(i + 1), linewidth=0.8)
    winner = int(tau.argmax())
    axis.plot(times, states[:, winner], color="black", linewidth=1.4, label=f"{winner + 1}, the winner")


def _dynamic_figure(
    flights: Sequence[RecordedFlight], times: Floats, states: Floats, effort: Floats, folder: Path
) -> Figure:
    figure, axes = figures.sheet(5.0, 3, 1, sharex=True)
    needs: dict[int, list[tuple[float, float]]] = {}
    for decision in session.decisions(folder):
        if decision["kind"] == "competition":
            for sysid, tau in decision["tau"].items():
                needs.setdefault(int(sysid), []).append((decision["t_s"], tau))
    for i, f in enumerate(flights):
        axes[0, 0].plot(times, states[:, i], label=f"vehicle {f.sysid}")
        axes[1, 0].plot(times, effort[:, i] - effort.min(axis=1))
        bids = np.array(needs.get(f.sysid, [(0.0, np.nan)]))
        gap = np.diff(bids[:, 0], append=bids[-1, 0]) > 0.15  # out of the race while it is served
        axes[2, 0].plot(bids[:, 0], np.where(gap, np.nan, bids[:, 1]))
    figures.label(axes[0, 0], "", "v")
    figures.label(axes[1, 0], "", "effort beyond the least")
    figures.label(axes[2, 0], "time, s", "need, normalised")
    axes[0, 0].legend(ncols=5)
    return figure


def _listed(values: Floats) -> str:
    return ", ".join(f"{value:.1f}" for value in values)


def _seconds(value: float | None) -> str:
    return "–" if value is None else f"{value:.1f}"
