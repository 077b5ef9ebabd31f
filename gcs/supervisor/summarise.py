"""Summary of a session that has ended, from the state of its supervisor and its link."""

from __future__ import annotations

import functools
import math
import platform
from collections import defaultdict
from dataclasses import asdict
from importlib.metadata import version
from typing import TYPE_CHECKING, cast

from gcs.recording import summary
from gcs.scenario.goal import Nearest
from skytender.mavlink import PYMAVLINK

if TYPE_CHECKING:  # readers of a summary need not load the supervisor
    from gcs.link.link import Link
    from gcs.supervisor.supervisor import Supervisor
    from gcs.telemetry.state import VehicleView


def summarise(
    supervisor: Supervisor,
    link: Link,
    *,
    outcome: str,
    outcome_text: str = "",
    completed: bool,
    wall_time_s: float,
    lag_s: float,
) -> summary.Summary:
    """Summary of a session that has ended; the link must still be open."""
    scenario, metrics, schedule = supervisor.scenario, supervisor.metrics, supervisor.schedule
    snapshot = supervisor.fleet.snapshot(supervisor.time_s)
    goal = [summary.GoalPartSummary(**asdict(one) | {"met": one.met is not False}) for one in supervisor.judged()]
    near, believed = supervisor.goal_watch.judged, supervisor.goal_watch.believed
    approaches: dict[summary.Nearness, Nearest] = {
        "separation": near.separation,
        "clearance": near.clearance,
        "traffic": near.traffic,
    }
    links = link.links()
    schedule.settle(snapshot)
    credited_j: dict[int | str | None, int] = defaultdict(int)
    for service in schedule.services:
        credited_j[service.tanker if service.base is None else service.base] += service.energy_j
    return summary.Summary(
        schema=1,
        scenario=scenario.name,
        seed=scenario.seed,
        clock=scenario.clock.mode,
        speed=scenario.clock.speed if scenario.clock.mode == "real" else None,
        sim_time_s=supervisor.time_s,
        wall_time_s=wall_time_s,
        speed_achieved=supervisor.time_s / wall_time_s if wall_time_s > 0.0 else 0.0,
        lag_s=lag_s,
        completed=completed,
        outcome=outcome,
        outcome_text=outcome_text,
        goal=goal,
        unmet=[part for part in goal if not part.met],
        judged_by="truth" if supervisor.goal_watch.from_truth else "reports",
        digest=supervisor.digest.hexdigest() if scenario.vehicles.repeat else None,
        versions=versions(),
        min_separation_m=_finite(near.separation.m),
        min_clearance_m=_finite(near.clearance.m),
        min_traffic_m=_finite(near.traffic.m),
        closest={name: _closest(nearest) for name, nearest in approaches.items() if math.isfinite(nearest.m)},
        believed_min_separation_m=_finite(believed.separation.m),
        believed_min_clearance_m=_finite(believed.clearance.m),
        believed_min_traffic_m=_finite(believed.traffic.m),
        vehicles=[
            summary.VehicleSummary(
                sysid=view.sysid,
                role=cast(summary.Role, view.role),
                final_mode=str(view.mode) if view.alive else "dead",
                final_mode_name=view.mode_name if view.alive else "dead",
                max_tracking_error_m=metrics.max_tracking_error_m.get(view.sysid),
                path_length_m=metrics.path_length_m.get(view.sysid, 0.0),
                control_effort=view.control_effort,
                energy=_ledger(view, credited_j[view.sysid]),
                missing_streams=supervisor.externals.missing_streams(view.sysid),
                check_list=[summary.CheckedItem(**item._asdict()) for item in supervisor.preflight.items(view.sysid)],
                mission=_mission(supervisor, view.sysid),
                refused_messages=link.signature_refusals.get(view.sysid, 0),
                links=[summary.VehicleLinkSummary(**one._asdict()) for one in links.get(view.sysid, ())],
            )
            for view in snapshot.vehicles
        ],
        refuelling=[summary.RefuellingSummary(**service.record()) for service in schedule.services],
        tanker_idle_s=schedule.tanker_idle_s,
        refuel_order=[service.receiver for service in schedule.refuelled],
        bases=[
            summary.BaseSummary(
                name=stock.base.name,
                initial_j=stock.base.stock_j,
                given_j=stock.given_j - stock.taken_back_j,
                lost_j=stock.given_j - stock.taken_back_j - credited_j[stock.base.name],
                remaining_j=stock.remaining_j,
            )
            for stock in schedule.stocks
        ],
        faults=[summary.FaultSummary(**fault) for fault in supervisor.fault_outcomes()],
        link=summary.LinkSummary(
            received=supervisor.received,
            sent=supervisor.sent,
            lost=supervisor.gaps.lost,
            malformed=link.malformed,
            overflowed=link.overflowed(),
            command_retries=supervisor.command_queue.resent,
        ),
    )


def _ledger(view: VehicleView, credited_j: int) -> summary.EnergySummary:
    returned_j = view.received_j if view.role == "tanker" else 0  # a tanker receives only what comes back to it
    return summary.EnergySummary(
        initial_j=view.initial_j,
        drawn_j=view.drawn_j,
        received_j=view.received_j,
        given_j=view.given_j,
        lost_j=view.given_j - credited_j - returned_j,
        remaining_j=view.remaining_j,
        source=view.energy_source,
    )


def _mission(supervisor: Supervisor, sysid: int) -> summary.MissionSummary | None:
    flight = supervisor.missions.flights.get(sysid)
    if flight is None:
        return None
    count = len(flight.items)
    return summary.MissionSummary(
        items=count,
        reached=count if flight.done else min(flight.index, count),
        flown_at_s=_finite(flight.done_s),
        holds=flight.holds,
        held_s=flight.held_s
        if math.isnan(flight.held_since_s)
        else flight.held_s + supervisor.time_s - flight.held_since_s,
    )


def _closest(nearest: Nearest) -> summary.ClosestSummary:
    return summary.ClosestSummary(distance_m=nearest.m, sysids=list(nearest.sysids), what=nearest.what, t_s=nearest.t_s)


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def load() -> None:
    """Build what the first summary of a process is built of."""
    for model in summary.SummaryPart.__subclasses__():
        model.model_rebuild()
    versions()


@functools.cache
def versions() -> dict[str, str]:
    """Versions on which a session's digest depends, by package; pymavlink's is of its definitions."""
    ours = {"python": platform.python_version(), "skytender": version("skytender")}
    return {**ours, "pymavlink": PYMAVLINK, "numpy": version("numpy")}
