"""Flown paths, beside what was planned for them, and Example 1 with eqs. 4 and 17 to the letter."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from gcs.recording.series import Floats
from gcs.report.paper import session, tracking
from gcs.report.paper.session import RecordedFlight
from gcs.report.paper.study import Drawing, Measurement, Study
from gcs.scenario.model import Scenario

NEAR_M_S, HELD_S = 0.1, 1.0
"""A speed is reached when the error stays below this for so long."""
NEAR_S = 1.5
LAST_S = 1.0
"""Before its arrival a planned point slows down for so long."""


def arrival(flights: Sequence[RecordedFlight], end: Floats) -> Measurement:
    """Greatest distance of a vehicle to the end when the session ends."""
    away = [float(np.linalg.norm(f.p[-1] - end)) for f in flights]
    return Measurement(max(away), f"vehicles end {min(away):.1f} to {max(away):.1f} m beside it")


def clearance(flights: Sequence[RecordedFlight], obstacles: Floats) -> Measurement:
    """Least distance of a flown path to an obstacle point."""
    clear = [tracking.path_clearance(f.p, obstacles) for f in flights]
    return Measurement(min(clear), f"vehicle {flights[int(np.argmin(clear))].sysid}")


def along(flights: Sequence[RecordedFlight]) -> Measurement:
    """Rms of |v - v_d| along the path, worst vehicle."""
    errors = tracking.path_errors(flights)
    return Measurement(max(errors), f"vehicle {flights[int(np.argmax(errors))].sysid}")


def transient(flights: Sequence[RecordedFlight]) -> Measurement:
    """Latest time of any vehicle at which |v - v_d| came below NEAR_M_S for HELD_S; infinite where it never did."""
    times = [_settles_s(f) for f in flights]
    return Measurement(max(times), f"first {min(times):.1f} s")


def pitch(flights: Sequence[RecordedFlight]) -> Measurement:
    """Greatest |θ_d| of any vehicle from ALONG_FROM_S until LAST_S before its planned point came to rest."""
    greatest = []
    for f in flights:
        on_way = (f.time_s >= tracking.ALONG_FROM_S) & (f.time_s <= f.arrived_s - LAST_S)
        asked = np.abs(tracking.attitude_reference(f)[:, 1])
        greatest.append((float(asked[on_way].max()), float(f.time_s[on_way][asked[on_way].argmax()]), f.sysid))
    most, at_s, sysid = max(greatest)
    f = next(f for f in flights if f.sysid == sysid)
    jump = np.linalg.norm(np.diff(f.plan_v, axis=0), axis=1)[np.searchsorted(f.plan_time_s, at_s) - 2 :][:3].max()
    return Measurement(most, f"vehicle {sysid} at {at_s:.1f} s, where the set points' velocity jumps by {jump:.2f} m/s")


def length(flights: Sequence[RecordedFlight], way: Floats, end: Floats) -> Measurement:
    """Longest plan over the straight lines from its start by the way point to the end."""
    ratios = []
    for f in flights:
        planned_m = float(np.linalg.norm(np.diff(f.plan_p, axis=0), axis=1).sum())
        legs = (way - f.plan_p[0], end - way)
        ratios.append(planned_m / float(sum(np.linalg.norm(leg) for leg in legs)))
    return Measurement(max(ratios), ", ".join(f"{ratio:.3f}" for ratio in ratios))


def literal(scenario: Scenario, folder: Path) -> Study:
    """Example 1 with whole steps, signed thrust and no floor."""
    flights = session.flights_of(scenario, folder)
    obstacles, way, _ = session.world(scenario)
    speed = tracking.speed_errors(flights)
    slowest = min(float(np.linalg.norm(f.plan_v[f.plan_time_s < f.arrived_s - 1e-6], axis=1).min()) for f in flights)
    measured = {
        "lit-speed": Measurement(max(speed), f"worst of {len(flights)} vehicles"),
        "lit-way": Measurement(slowest),
        "lit-pitch": pitch(flights),
        "lit-pitch-way": Measurement(max(_pitch_at(f, way) for f in flights)),
        "lit-clearance": Measurement(min(tracking.clearances(flights, obstacles))),
    }
    drawing = Drawing(
        "fig7bc-literal",
        "Figs. 7(b) and 7(c) with eqs. 4 and 17 to the letter: the planned point passes the way point at 1 m/s, and "
        "stops once, at the end.",
        tracking.tracking_figure(flights, literal=True),
    )
    return Study(measured, [drawing], [tracking.table(flights, obstacles)])


def _pitch_at(flight: RecordedFlight, way: Floats) -> float:
    """Greatest |θ_d| within NEAR_S of the planned point's passing of a way point."""
    passed_s = flight.plan_time_s[np.linalg.norm(flight.plan_p - way, axis=1).argmin()]
    near = np.abs(flight.time_s - passed_s) <= NEAR_S
    return float(np.abs(tracking.attitude_reference(flight)[near, 1]).max())


def _settles_s(flight: RecordedFlight) -> float:
    off = np.flatnonzero(tracking.speed_error(flight) > NEAR_M_S)
    bounds = np.concatenate(([-1], off, [len(flight.time_s)]))
    for before, after in itertools.pairwise(bounds.tolist()):
        if after - before > 1 and flight.time_s[after - 1] - flight.time_s[before + 1] >= HELD_S:
            return float(flight.time_s[before + 1])
    return float("inf")
