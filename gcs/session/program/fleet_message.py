"""Builds what a program in Python gets of a tick (`messages`)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

import numpy as np

from gcs.mavlink.setpoints import SetPoints
from gcs.session.messages import event_row, known_to, near_to, services_of
from gcs.session.program.messages import AcknowledgedRow, FleetMessage, Numbers
from gcs.supervisor.supervisor import Supervisor
from gcs.telemetry.events import Event
from gcs.telemetry.health import health_issues
from gcs.telemetry.state import VehicleView


def fleet_message(supervisor: Supervisor, events: Iterable[Event]) -> FleetMessage:
    """The tick that the supervisor has just flown; `events` and acknowledgements are those since the last message."""
    snapshot, schedule = supervisor.snapshot, supervisor.schedule
    columns, views, now_s = snapshot.columns, snapshot.vehicles, snapshot.time_s
    sysids, lost_share = list(columns.sysids), supervisor.quality.lost_share
    sent, set_points = SetPoints.of(supervisor.set_points), np.full((len(sysids), 6), np.nan)
    set_points[[columns.row[sysid] for sysid in sent.sysids]] = sent.values
    competing = schedule.competition_state
    near = near_to(supervisor)
    shares = [lost_share(sysid) for sysid in sysids]
    left_j = [view.remaining_j if view.energy_source != "none" else math.nan for view in views]
    return FleetMessage(
        t_s=now_s,
        sysid=sysids,
        role=[view.role for view in views],
        mode=[str(view.mode) for view in views],
        mode_name=[view.mode_name for view in views],
        alive=columns.alive.tolist(),
        armed=[view.armed for view in views],
        p_ned=columns.p_ned.tolist(),
        v_ned=np.where(np.isfinite(columns.age_s)[:, None], columns.v_ned, np.nan).tolist(),
        attitude_rad=[[view.roll_rad, view.pitch_rad, view.heading_rad] for view in views],
        set_point_p_ned=set_points[:, :3].tolist(),
        set_point_v_ned=set_points[:, 3:].tolist(),
        target_m=_distances(supervisor),
        battery=[left / view.capacity_j for left, view in zip(left_j, views, strict=True)],
        remaining_j=[*left_j],
        endurance_s=[view.endurance_s for view in views],
        v=[competing.v.get(sysid) for sysid in sysids],
        tau=[competing.tau.get(sysid) for sysid in sysids],
        age_s=columns.age_s.tolist(),
        heard_s=[view.silent_s(now_s) for view in views],
        lost_share=shares,
        trouble=[_issues(supervisor, view, near, share) for view, share in zip(views, shares, strict=True)],
        services=services_of(schedule.open_services, snapshot, supervisor.scenario),
        refuelled=len(schedule.refuelled),
        events=[event_row(event) for event in events],
        acknowledged=[AcknowledgedRow(*one) for one in supervisor.script.pop_acknowledged()],
    )


def _distances(supervisor: Supervisor) -> Numbers:
    """From each vehicle to its target."""
    columns, followed = supervisor.snapshot.columns, supervisor.metrics.target_of
    found = np.full(len(columns.sysids), np.nan)
    if followed:
        of, to = np.array([(columns.row[one], columns.row[target]) for one, target in followed.items()], np.int64).T
        n, e, d = (columns.p_ned[of] - columns.p_ned[to]).T
        found[of] = np.sqrt(n * n + e * e + d * d)
    return found.tolist()


def _issues(supervisor: Supervisor, view: VehicleView, near: Mapping[int, str], lost_share: float | None) -> list[str]:
    known, now_s = known_to(supervisor, view, near), supervisor.snapshot.time_s
    return [one.text for one in health_issues(view, now_s, known, lost_share=lost_share)]
