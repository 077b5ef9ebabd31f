"""The paper's loop closed, from its recorded sessions: measured control energy competes for a moving target and for a
tanker (docs/model/competition.md#target-assignment; paper Section III-A and Fig. 11)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from gcs.report.paper import examples, figures, session
from gcs.report.paper.session import RecordedFlight
from gcs.report.paper.study import Drawing, Measurement, Study, Table
from gcs.scenario.model import Scenario

STEP_S = 0.5


def pursuit(scenario: Scenario, folder: Path) -> Study:
    """The least control energy pursues a moving target among moving obstacles."""
    flights = session.flights_of(scenario, folder)
    record, changes = session.summary(folder), _of_kind(folder, "pursuit")
    parts = {part["part"]: part for part in record["goal"]}
    right = [_least(flights, change["t_s"]) == change["pursuer"] for change in changes]
    rows = [
        [f"{c['t_s']:.1f}", str(c["pursuer"]), *(f"{c['efforts'][str(f.sysid)]:.1f}" for f in flights)] for c in changes
    ]
    nearest = min(parts["clearance"]["value"], parts["traffic"]["value"])
    measured = {
        "loop-target": Measurement(parts["pursue"]["value"], f"{len(changes)} pursuers in turn"),
        "loop-obstacles": Measurement(
            nearest, f"obstacles {parts['clearance']['reached']}, traffic {parts['traffic']['reached']}"
        ),
        "loop-least": Measurement(sum(right) / len(right) if right else None, f"{len(changes)} changes"),
    }
    columns = ["from, s", "pursuer", *(f"effort of {f.sysid}, m/s" for f in flights)]
    drawing = Drawing(
        "pursuit",
        "Control effort beyond the least of all; the bar below shows the pursuer.",
        _figure(flights, changes, scenario.goal.duration_s),
    )
    return Study(measured, [drawing], [Table("Pursuers, and the efforts when each was decided", columns, rows)])


def example4_energy(scenario: Scenario, folder: Path) -> Study:
    """A tanker serves the vehicle that has used most."""
    flights = session.flights_of(scenario, folder)
    record = session.summary(folder)
    left, right = list(flights), []
    for decision in _of_kind(folder, "decided")[: len(flights)]:
        right.append(_most(left, decision["t_s"]) == decision["receiver"])
        left = [f for f in left if f.sysid != decision["receiver"]]
    measured = {
        "ex4e-most": Measurement(sum(right) / len(right) if right else None, f"{len(right)} decisions"),
        "ex4e-order": Measurement(examples.first_served(record)),
    }
    return Study(measured, (), [examples.services_table(record)])


def _of_kind(folder: Path, kind: str) -> list[Mapping[str, Any]]:
    return [decision for decision in session.decisions(folder) if decision["kind"] == kind]


def _least(flights: Sequence[RecordedFlight], t_s: float) -> int:
    return min(flights, key=lambda f: float(f.effort_at(t_s))).sysid


def _most(flights: Sequence[RecordedFlight], t_s: float) -> int | None:
    return max(flights, key=lambda f: float(f.effort_at(t_s))).sysid if flights else None


def _figure(flights: Sequence[RecordedFlight], changes: Sequence[Mapping[str, Any]], end_s: float) -> Figure:
    figure, axes = figures.sheet(3.6, 2, 1, sharex=True)
    times = np.arange(0.0, end_s + 1e-9, STEP_S)
    effort = np.column_stack([f.effort_at(times) for f in flights])
    until = [*(change["t_s"] for change in changes[1:]), end_s]
    for k, f in enumerate(flights):
        colour = figures.COLOURS[k % len(figures.COLOURS)]
        axes[0, 0].plot(times, effort[:, k] - effort.min(axis=1), color=colour, label=f"vehicle {f.sysid}")
        for change, to_s in zip(changes, until, strict=True):
            if change["pursuer"] == f.sysid:
                axes[1, 0].barh(f.sysid, to_s - change["t_s"], left=change["t_s"], color=colour)
    figures.label(axes[0, 0], "", "effort beyond the least, m/s")
    figures.label(axes[1, 0], "time, s", "pursues")
    axes[0, 0].legend(ncols=5)
    return figure
