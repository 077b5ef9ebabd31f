"""One step of one agent, which rewards and ends are functions of, and the ones that are taken by default."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from gcs.scenario.model import Pursuer, Scenario, VehicleBase
from gcs.session.arrays import Snapshot
from gcs.session.python import Session
from skytender import elementary


@dataclass(frozen=True, slots=True)
class Transition:
    """An agent's action in a step, and what came of it."""

    scenario: Scenario
    sysid: int
    """the agent's vehicle"""
    row: int
    """its row in both snapshots"""
    action: Any
    """as the policy gave it"""
    before: Snapshot
    """the fleet when the agent acted"""
    after: Snapshot
    """the fleet one step later"""
    session: Session
    """the session, for its `truth` at the second snapshot's time"""


def pursued(vehicle: VehicleBase, scenario: Scenario) -> int | None:
    """System id of what a vehicle is to follow: its target, or the first one; None for one that has way points, and
    where there is no target."""
    targets = scenario.vehicles.targets
    if not isinstance(vehicle, Pursuer) or vehicle.waypoints_m or not targets:
        return None
    return vehicle.target or targets[0].sysid


def miss_m(step: Transition) -> float:
    """Distance of the vehicle from where it should be after a step, m; infinite where that is not known.

    From its distance on the ring to its target, or from the target where the scenario has no ring; from the last of its
    way points. 0 for a vehicle that has neither.
    """
    scenario, after = step.scenario, step.after
    vehicle = next(one for one in scenario.vehicles.all if one.sysid == step.sysid)
    ring_m, there = 0.0, None
    if (target := pursued(vehicle, scenario)) is not None:
        there, formation = after.p_ned[after.row(target)].tolist(), scenario.formation
        ring_m = 0.0 if formation.ring_m is None else elementary.hypot(formation.ring_m, formation.height_m)
    elif isinstance(vehicle, Pursuer) and vehicle.waypoints_m:
        there = vehicle.waypoints_m[-1]
    if there is None:
        return 0.0
    off_m = elementary.norm([a - b for a, b in zip(after.p_ned[step.row].tolist(), there, strict=True)])
    return abs(off_m - ring_m) if math.isfinite(off_m) else math.inf


def is_lost(step: Transition) -> bool:
    """Whether the vehicle flies no more: it is dead, or its motors are off."""
    return not (step.after.alive[step.row] and step.after.armed[step.row])


def nearness(step: Transition) -> float:
    """1 / (1 + d), d being the distance from where the vehicle should be in m (`miss_m`); 0 once it is lost.

    It is never negative, so that no policy gains by a crash.
    """
    return 0.0 if is_lost(step) else 1.0 / (1.0 + miss_m(step))
