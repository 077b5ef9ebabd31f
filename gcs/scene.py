"""The first line that a client of a session's socket reads: what flies where, among what, and to what end.

From the scenario alone, so that a replay of a session's folder tells the same.
"""

from __future__ import annotations

import math
from typing import Any, Literal

from gcs.scenario.model import Goal, Obstacle, Scenario, VehicleBase

ROUND_CORNERS = 32
"""of the outline of what is round"""


def session_line(
    scenario: Scenario,
    folder: str | None,
    *,
    source: Literal["session", "monitor", "replay"] = "session",
    clock: Literal["lockstep", "real", "replay"] | None = None,
    control: bool = True,
) -> dict[str, Any]:
    """The message of type "session"; `clock` is the scenario's own unless given, `control`: commands are taken."""
    mode = clock or scenario.clock.mode
    return {
        "type": "session",
        "name": scenario.name,
        "folder": folder,
        "source": source,
        "duration_s": scenario.goal.duration_s,
        "clock": mode,
        "speed": scenario.clock.speed if mode == "real" else None,
        "control": control,
        "separation_m": scenario.planner.separation_m,
        "vehicles": [vehicle_of(vehicle) for vehicle in scenario.vehicles.all],
        "obstacles": [obstacle_of(shape, f"{shape.kind} {i + 1}") for i, shape in enumerate(scenario.obstacles)],
        "bases": [{"name": base.name, "p_ned": base.position_m} for base in scenario.bases],
        "goal": goal_of(scenario.goal),
    }


def goal_of(goal: Goal) -> dict[str, Any]:
    """What makes the session a success."""
    return {
        "pursue_within_m": goal.pursue.within_m if goal.pursue else None,
        "pursue_for_s": goal.pursue.for_s if goal.pursue else None,
        "refuelled_at_least": goal.refuelled_at_least,
    }


def vehicle_of(vehicle: VehicleBase) -> dict[str, Any]:
    """Who flies, and the way that it is to fly where there is one; a closed path ends where it begins."""
    path = list(getattr(vehicle, "path_m", None) or getattr(vehicle, "waypoints_m", None) or ())
    if getattr(vehicle, "closed", False):
        path.append(path[0])
    return {
        "sysid": vehicle.sysid,
        "role": vehicle.role,
        "label": vehicle.label,
        "capacity_j": vehicle.battery.capacity_j,
        "path_ned": path,
    }


def obstacle_of(shape: Obstacle, default_label: str) -> dict[str, Any]:
    """An obstacle to draw: outline from above (its last point is its first), centre, and where it begins and ends."""
    (n0, e0, d0), (n1, e1, d1) = shape.low_m, shape.high_m
    up_m = shape.radius_m if shape.kind == "sphere" else 0.0
    return {
        "name": shape.name,
        "label": shape.name or default_label,
        "kind": shape.kind,
        "outline_ne": _outline(shape),
        "centre_ned": ((n0 + n1) / 2.0, (e0 + e1) / 2.0, (d0 + d1) / 2.0),
        "radius_m": shape.radius_m if shape.kind in ("sphere", "cylinder") else None,
        "bottom_d": d1 + up_m,
        "top_d": d0 - up_m,
    }


def _outline(shape: Obstacle) -> list[tuple[float, float]]:
    (n0, e0, _), (n1, e1, _) = shape.low_m, shape.high_m
    if shape.kind == "point":
        return []
    if shape.kind == "box":
        return [(n0, e0), (n0, e1), (n1, e1), (n1, e0), (n0, e0)]
    angles = [2.0 * math.pi * i / ROUND_CORNERS for i in range(ROUND_CORNERS)]
    r = shape.radius_m
    corners = [(n0 + r * math.cos(angle), e0 + r * math.sin(angle)) for angle in angles]
    return [*corners, corners[0]]
