"""What a snapshot's line says of each vehicle, aircraft and event: from views alone, for every producer of snapshots.

All in the common NED frame and SI; None (null) where nothing is known.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from gcs.telemetry.events import Event
from gcs.telemetry.health import State, Trouble, severity
from gcs.telemetry.state import TrafficView, Vec3, VehicleView


def vehicle_row(
    view: VehicleView,
    now_s: float,
    *,
    stage: str = "",
    target_m: float | None = None,
    v: float | None = None,
    tau: float | None = None,
    note: str = "",
    lost: int = 0,
    lost_share: float | None = None,
    aim_ned: Vec3 | None = None,
    state: State = State.IDLE,
    found: Sequence[Trouble] = (),
) -> dict[str, Any]:
    """One vehicle at `now_s`; `found` is its trouble, worst first (gcs/telemetry/health.py)."""
    heard = view.heard_s >= 0.0
    return {
        "sysid": view.sysid,
        "role": view.role,
        "label": view.label,
        "alive": view.alive,
        "stage": stage,
        "mode": str(view.mode),
        "armed": view.armed,
        "landed": view.landed,
        "autopilot": view.profile.name if heard else None,
        "p_ned": view.p_ned,
        "v_ned": view.v_ned,
        "speed_m_s": math.hypot(*view.v_ned),
        "height_m": -view.p_ned[2] if view.p_ned is not None else None,
        "heading_rad": view.heading_rad,
        "aim_ned": aim_ned,
        "age_s": view.age_s if math.isfinite(view.age_s) else None,
        "heard_s": max(now_s - view.heard_s, 0.0) if heard else None,
        "lost": lost,
        "lost_share": lost_share,
        "target_m": target_m,
        "battery": view.remaining_j / view.capacity_j,
        "remaining_j": view.remaining_j,
        "power_w": view.power_w,
        "endurance_s": view.endurance_s if math.isfinite(view.endurance_s) else None,
        "energy_source": view.energy_source,
        "v": v,
        "tau": tau,
        "state": str(state),
        "trouble": [trouble.text for trouble in found],
        "severity": severity(found),
        "note": note,
    }


def traffic_row(aircraft: TrafficView) -> dict[str, Any]:
    """One aircraft by its ADSB_VEHICLE."""
    return {
        "callsign": aircraft.callsign,
        "p_ned": aircraft.p_ned,
        "v_ned": aircraft.v_ned,
        "age_s": aircraft.age_s,
    }


def event_row(event: Event) -> dict[str, Any]:
    """One event."""
    return {"t_s": event.t_s, "sysid": event.sysid, "level": event.level, "text": event.text, "kind": event.kind}


def distance_m(a: Vec3 | None, b: Vec3 | None) -> float | None:
    """Between two places; None where one is not known."""
    return None if a is None or b is None else math.dist(a, b)
