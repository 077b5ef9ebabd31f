"""A session as its clients see it: one JSON object per snapshot on the session's socket."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from gcs.refuelling import explain
from gcs.refuelling.service import Phase
from gcs.rows import distance_m, event_row, traffic_row, vehicle_row
from gcs.scene import goal_of
from gcs.supervisor.supervisor import Supervisor
from gcs.telemetry.events import Event
from gcs.telemetry.health import state, troubles
from gcs.telemetry.state import Vec3


def picture(
    supervisor: Supervisor, *, phase: str, speed: float, refuelled: int, events: Iterable[Event]
) -> dict[str, Any]:
    """The present state; `speed` is session time over wall time so far, `events` are those that nobody was told yet."""
    scenario, snapshot, schedule = supervisor.scenario, supervisor.snapshot, supervisor.schedule
    services = schedule.open_services
    tanker_m_s: dict[int | None, float] = {tanker.sysid: tanker.speed_m_s for tanker in scenario.vehicles.tankers}
    base_ned: dict[str | None, Vec3] = {base.name: base.position_m for base in scenario.bases}
    return {
        "type": "snapshot",
        "t_s": supervisor.time_s,
        "duration_s": scenario.goal.duration_s,
        "speed": speed,
        "phase": phase,
        "vehicles": _vehicles(supervisor),
        "traffic": [traffic_row(aircraft) for aircraft in snapshot.traffic],
        "competition": explain.competition_of(schedule.standing, scenario.competition),
        "services": [
            explain.service_of(
                s,
                snapshot,
                scenario.refuelling,
                scenario.competition,
                tanker_m_s.get(s.tanker, 0.0),
                base_ned.get(s.base),
            )
            for s in services
        ],
        "history": explain.history_of(schedule.services),
        "bases": [
            {"name": stock.base.name, "remaining_j": stock.remaining_j, "stock_j": stock.base.stock_j}
            for stock in schedule.stocks
        ],
        "refuelled": refuelled,
        "goal": {**goal_of(scenario.goal), "pursue_held_s": supervisor.metrics.pursuit_held_s},
        "inspected": supervisor.inspection.told(snapshot.time_s),
        "events": [event_row(event) for event in events],
    }


def _vehicles(supervisor: Supervisor) -> list[dict[str, Any]]:
    snapshot, standing, quality = supervisor.snapshot, supervisor.schedule.standing, supervisor.quality
    now_s = snapshot.time_s
    services = supervisor.schedule.open_services
    notes = explain.notes_of(services, supervisor.schedule.asked, supervisor.schedule.out)
    waiting = {service.receiver for service in services if service.phase is Phase.JOIN}
    served = {service.receiver for service in services}
    serving = {service.tanker for service in services if service.tanker is not None}
    at = {view.sysid: view.p_ned for view in snapshot.vehicles}
    aims = {point.sysid: point.p_ned for point in supervisor.set_points}
    target_of = supervisor.metrics.target_of
    rows = []
    for view in snapshot.vehicles:
        sysid, pilot = view.sysid, supervisor.pilots[view.sysid]
        lost_share = quality.lost_share(sysid)
        rows.append(
            vehicle_row(
                view,
                now_s,
                stage=str(pilot.stage),
                target_m=distance_m(view.p_ned, at.get(target_of.get(sysid, -1))),
                v=standing.v.get(sysid),
                tau=standing.tau.get(sysid),
                note=notes.get(sysid, ""),
                lost=quality.lost(sysid),
                lost_share=lost_share,
                aim_ned=aims.get(sysid),
                state=state(
                    view,
                    competing=standing.v or standing.tau,
                    leader=standing.leader,
                    waiting=waiting,
                    served=served - waiting,
                    serving=serving,
                ),
                found=troubles(
                    view,
                    now_s,
                    lost_share=lost_share,
                    down=pilot.down,
                    ordered=pilot.ordered is not None or sysid in supervisor.grounded,
                ),
            )
        )
    return rows
