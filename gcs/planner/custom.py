"""A user's planner for the pursuers; targets and tankers stay with the shipped one.

    class Straight:
        def __init__(self, scenario): ...
        def plan(self, vehicle, situation): return p_ned, v_ned

A scenario names it: `planner: {method: MODULE:CLASS}`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gcs.mavlink.setpoints import SetPoint, SetPoints
from gcs.planner.planner import Planner
from gcs.planner.request import PlanRequest, TickPlanner
from gcs.planner.safe_planner import SafePlanner
from gcs.scenario import plugins
from gcs.scenario.guard import Guard, Nonsense
from gcs.scenario.model import Obstacle, Scenario
from gcs.telemetry.state import FleetSnapshot, Vec3, VehicleView

FARTHEST = 1e5
"""m, and m/s: beyond every scenario."""


@dataclass(frozen=True, slots=True)
class Situation:
    """Inputs of a planner beside the vehicle itself."""

    time_s: float
    period_s: float
    """until it is asked again"""
    snapshot: FleetSnapshot
    """all vehicles, as their messages report them; also traffic"""
    pursuing: Mapping[int, int]
    """the target's system id by the pursuer's"""
    obstacles: tuple[Obstacle, ...]

    def target(self, vehicle: VehicleView) -> VehicleView | None:
        """Target of a vehicle, once its place is known."""
        sysid = self.pursuing.get(vehicle.sysid)
        view = None if sysid is None else self.snapshot.vehicle(sysid)
        return view if view is not None and view.p_ned is not None else None


class PursuerPlanner(Protocol):
    """One-method protocol; made once, as CLASS(scenario), before anything flies: what takes long belongs there."""

    def plan(self, vehicle: VehicleView, situation: Situation) -> tuple[ArrayLike, ArrayLike]:
        """Position (NED, m) and velocity (NED, m/s) wanted of `vehicle` at situation.time_s."""


class OwnPlanner(TickPlanner):
    """The shipped planner, but for the pursuers, who fly what `planner` says; without a good answer they are held."""

    def __init__(self, scenario: Scenario, planner: PursuerPlanner, guard: Guard) -> None:
        self._scenario = scenario
        self._shipped = Planner(scenario)
        self.obstacles = self._shipped.obstacles
        self._planner = planner
        self._guard = guard
        self._pursuers = frozenset(pursuer.sysid for pursuer in scenario.vehicles.pursuers)
        self._follows = scenario.vehicles.followed
        self._held: dict[int, Vec3] = {}

    def anchor(self, sysids: Sequence[int], p_ned: NDArray[np.float64]) -> None:
        """As `Planner.anchor`; a user's planner keeps its points."""
        self._shipped.anchor(sysids, p_ned)

    def plan(self, request: PlanRequest) -> Sequence[SetPoint]:
        """As `Planner.plan`, which also leads the pursuers that have a station."""
        snapshot, steered = request.snapshot, request.steered
        own_pursuers = self._pursuers - request.stations.keys()
        follows = self._follows if request.pursuing is None else request.pursuing
        situation = Situation(snapshot.time_s, request.period_s, snapshot, follows, self._scenario.obstacles)
        shipped = self._shipped.plan(request._replace(steered=steered - own_pursuers))
        self._guard.begin_tick()
        led = steered & own_pursuers
        own = [view for view in snapshot.of_role("pursuer") if view.sysid in led and view.p_ned is not None]
        self._held = {view.sysid: self._held.get(view.sysid, view.p_now_ned()) for view in own}
        points = [*shipped, *(self._point(view, situation) for view in own)]
        return SetPoints.of(sorted(points, key=lambda point: point.sysid))

    def _point(self, view: VehicleView, situation: Situation) -> SetPoint:
        answer = self._guard.call(view.sysid, lambda: _checked(self._planner.plan(view, situation)))
        if answer is None:
            return SetPoint(view.sysid, self._held[view.sysid], (0.0, 0.0, 0.0))
        p_ned, v_ned = answer
        self._held[view.sysid] = p_ned
        return SetPoint(view.sysid, p_ned, v_ned)


def _checked(answer: Any) -> tuple[Vec3, Vec3]:
    """The answer as plain numbers. Raises Nonsense."""
    try:
        numbers = np.asarray(answer, dtype=np.float64)
    except (TypeError, ValueError):
        raise Nonsense(f"returned {type(answer).__name__}, not (p_ned, v_ned) of three numbers each") from None
    if numbers.shape != (2, 3):
        raise Nonsense(f"returned numbers of shape {numbers.shape}, not (p_ned, v_ned) of three numbers each")
    if not (np.abs(numbers) <= FARTHEST).all():
        bad = numbers[~(np.abs(numbers) <= FARTHEST)][0]
        raise Nonsense(f"returned {'NaN' if np.isnan(bad) else f'{bad:g}'}, which is no place or speed")
    (n, e, d), (vn, ve, vd) = numbers.tolist()
    return (n, e, d), (vn, ve, vd)


def make_planner(scenario: Scenario) -> tuple[TickPlanner, Guard | None]:
    """The planner that a scenario names, and what guards it where it is not the shipped one. Raises ScenarioError."""
    method = scenario.planner.method
    if ":" not in method:
        return behind_filter(scenario, Planner(scenario)), None
    guard = Guard(f"planner {method}")
    own = OwnPlanner(scenario, plugins.make("planner.method", method, "plan", scenario), guard)
    return behind_filter(scenario, own), guard


def behind_filter(scenario: Scenario, planner: TickPlanner) -> TickPlanner:
    """The planner behind the safety filter, unless the scenario leaves that out."""
    return SafePlanner(scenario, planner) if scenario.planner.safety else planner
