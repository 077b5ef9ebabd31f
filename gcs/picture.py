"""A session as its clients see it: one JSON object per snapshot on the session's socket."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from gcs.refuelling import Service
from gcs.supervisor import Event, Supervisor


def picture(
    supervisor: Supervisor, *, phase: str, speed: float, refuelled: int, events: Iterable[Event]
) -> dict[str, Any]:
    """The present state; `speed` is session time over wall time so far, `events` are those that nobody was told yet."""
    scenario, snapshot = supervisor.scenario, supervisor.snapshot
    standing, goal = supervisor.schedule.standing, scenario.goal
    services = supervisor.schedule.open_services
    at = {view.sysid: view.p_ned for view in snapshot.vehicles}
    target_of = supervisor.metrics.target_of
    notes = _notes(services)
    return {
        "type": "snapshot",
        "t_s": supervisor.time_s,
        "duration_s": goal.duration_s,
        "speed": speed,
        "phase": phase,
        "vehicles": [
            {
                "sysid": view.sysid,
                "role": view.role,
                "label": view.label,
                "alive": view.alive,
                "stage": str(supervisor.pilots[view.sysid].stage),
                "mode": str(view.mode),
                "armed": view.armed,
                "p_ned": view.p_ned,
                "v_ned": view.v_ned,
                "speed_m_s": math.hypot(*view.v_ned),
                "height_m": -view.p_ned[2] if view.p_ned is not None else None,
                "target_m": _distance_m(view.p_ned, at.get(target_of.get(view.sysid, -1))),
                "battery": view.remaining_j / view.capacity_j,
                "remaining_j": view.remaining_j,
                "endurance_s": view.endurance_s if math.isfinite(view.endurance_s) else None,
                "v": standing.v.get(view.sysid),
                "tau": standing.tau.get(view.sysid),
                "note": notes.get(view.sysid, ""),
            }
            for view in snapshot.vehicles
        ],
        "traffic": [{"callsign": aircraft.callsign, "p_ned": aircraft.p_ned} for aircraft in snapshot.traffic],
        "services": [
            {"receiver": s.receiver, "tanker": s.tanker, "phase": str(s.phase), "energy_j": s.energy_j, "by": s.by}
            for s in services
        ],
        "refuelled": refuelled,
        "goal": {
            "pursue_within_m": goal.pursue.within_m if goal.pursue else None,
            "pursue_for_s": goal.pursue.for_s if goal.pursue else None,
            "pursue_held_s": supervisor.metrics.pursuit_held_s,
            "refuelled_at_least": goal.refuelled_at_least,
        },
        "events": [{"t_s": e.t_s, "sysid": e.sysid, "level": e.level, "text": e.text} for e in events],
    }


def _notes(services: Iterable[Service]) -> dict[int, str]:
    notes = {}
    for service in services:
        notes[service.receiver] = f"served by {service.tanker}: {service.phase}"
        notes[service.tanker] = f"serves {service.receiver}: {service.phase}"
    return notes


def _distance_m(a: tuple[float, float, float] | None, b: tuple[float, float, float] | None) -> float | None:
    return None if a is None or b is None else math.dist(a, b)
