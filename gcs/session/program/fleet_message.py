"""Builds what a program in Python gets of a tick (`messages`)."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from gcs.session.messages import event_row, services_of
from gcs.session.program.messages import AcknowledgedRow, FleetMessage, Number, Numbers
from gcs.supervisor.supervisor import Supervisor
from gcs.telemetry.events import Event
from gcs.telemetry.health import health_issues
from gcs.telemetry.state import VehicleView


def fleet_message(supervisor: Supervisor, events: Iterable[Event]) -> FleetMessage:
    """The tick that the supervisor has just flown; `events` and acknowledgements are those since the last message."""
    snapshot, schedule = supervisor.snapshot, supervisor.schedule
    columns, views = snapshot.columns, snapshot.vehicles
    sysids = list(columns.sysids)
    set_points = np.full((len(sysids), 6), np.nan)
    if supervisor.set_points:
        rows = [columns.row[point.sysid] for point in supervisor.set_points]
        set_points[rows] = [(*point.p_ned, *point.v_ned) for point in supervisor.set_points]
    competing = schedule.competition_state
    return FleetMessage(
        t_s=snapshot.time_s,
        sysid=sysids,
        role=[view.role for view in views],
        mode=[str(view.mode) for view in views],
        alive=columns.alive.tolist(),
        armed=[view.armed for view in views],
        p_ned=columns.p_ned.tolist(),
        v_ned=columns.v_ned.tolist(),
        attitude_rad=[[view.roll_rad, view.pitch_rad, view.heading_rad] for view in views],
        set_point_p_ned=set_points[:, :3].tolist(),
        set_point_v_ned=set_points[:, 3:].tolist(),
        target_m=_distances(supervisor),
        battery=[view.remaining_j / view.capacity_j for view in views],
        remaining_j=columns.remaining_j.tolist(),
        endurance_s=[_finite(view.endurance_s) for view in views],
        v=[competing.v.get(sysid) for sysid in sysids],
        tau=[competing.tau.get(sysid) for sysid in sysids],
        age_s=[_finite(age_s) for age_s in columns.age_s.tolist()],
        heard_s=[_finite(view.silent_s(snapshot.time_s)) for view in views],
        lost_share=[supervisor.quality.lost_share(sysid) for sysid in sysids],
        trouble=[_issues(supervisor, view) for view in views],
        services=services_of(schedule.open_services, snapshot, supervisor.scenario),
        refuelled=len(schedule.refuelled),
        events=[event_row(event) for event in events],
        acknowledged=[AcknowledgedRow(*one) for one in supervisor.script.pop_acknowledged()],
    )


def _distances(supervisor: Supervisor) -> Numbers:
    """From each vehicle to its target."""
    columns, followed = supervisor.snapshot.columns, supervisor.metrics.target_of
    pairs = [(columns.row[one], columns.row[target]) for one, target in followed.items()]
    found = np.full(len(columns.sysids), np.nan)
    if pairs:
        of, to = np.array(pairs, np.int64).T
        n, e, d = (columns.p_ned[of] - columns.p_ned[to]).T
        found[of] = np.sqrt(n * n + e * e + d * d)
    distances: Numbers = found.tolist()
    return distances


def _issues(supervisor: Supervisor, view: VehicleView) -> list[str]:
    sysid, arming = view.sysid, supervisor.arming[view.sysid]
    ordered = arming.ordered is not None or sysid in supervisor.grounded
    lost_share = supervisor.quality.lost_share(sysid)
    now_s = supervisor.snapshot.time_s
    return [one.text for one in health_issues(view, now_s, lost_share=lost_share, down=arming.down, ordered=ordered)]


def _finite(number: float) -> Number:
    return number if math.isfinite(number) else None
