"""Requests to planners: what one tick of planning is asked for, and which planner answers it.

A user's own planner, which a scenario names (`planner: {method: MODULE:CLASS}`), is asked for the pursuers alone:

    class Straight:
        def __init__(self, scenario): ...
        def plan(self, vehicle, situation): return p_ned, v_ned
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gcs.mavlink.setpoints import SetPoint
from gcs.scenario.guard import Guard, Nonsense
from gcs.scenario.model import Obstacle, Scenario
from gcs.telemetry.state import FleetSnapshot, Vec3, VehicleView

_NONE: Mapping[int, Any] = MappingProxyType({})
FARTHEST = 1e5
"""m, and m/s: beyond every scenario."""


class PlanRequest(NamedTuple):
    """One tick of planning; positions are in the common NED frame, m.

    steered: system ids of the vehicles that fly set points. rendezvous: the receiver above which each tanker is to
    stand; the two may come near each other, but for tankers in approaches, which stay away from it until they are to
    serve it. targets_move: whether targets fly on along their paths. period_s: until the
    next request. pursuing: the target of each pursuer while all others hold; None: each pursues its own. stations:
    vehicles that are to be at a place instead. given: position and velocity of vehicles that a program steers, in place
    of a planner's. stand_off_m: how far above their receivers tankers in approaches are to stand; without it, as the
    others. claims: (k, 3) places where a vehicle on a mission will be, by its system id; the others stay away.
    takes_off: vehicles that are ordered to take off, or will be as soon as they are armed.
    """

    snapshot: FleetSnapshot
    steered: frozenset[int]
    period_s: float
    targets_move: bool = True
    rendezvous: Mapping[int, int] = _NONE
    approaches: frozenset[int] = frozenset()
    pursuing: Mapping[int, int] | None = None
    stations: Mapping[int, Vec3] = _NONE
    given: Mapping[int, tuple[Vec3, Vec3]] = _NONE
    stand_off_m: Mapping[int, float] = _NONE
    claims: Mapping[int, NDArray[np.float64]] = _NONE
    takes_off: frozenset[int] = frozenset()


class TickPlanner(Protocol):
    """Planner of all steered vehicles."""

    obstacles: NDArray[np.float64]
    """obstacle table (skytender/geometry.py)"""

    def plan(self, request: PlanRequest) -> Sequence[SetPoint]:
        """Set points for the steered vehicles whose place is known, in order of system id, at the snapshot's time; the
        shipped ones give `SetPoints`."""

    def pop_records(self) -> list[dict[str, Any]]:
        """Decisions since the last call that the set points do not show; a planner that does not say has none."""
        return []

    def margin_m(self, sysid: int) -> float | None:
        """Distance that is added for a vehicle's tracking error; None without the safety filter."""
        return None

    def anchor(self, sysids: Sequence[int], p_ned: NDArray[np.float64]) -> None:
        """Go on planning from here: where the safety filter takes these k vehicles' planned points to, (k, 3) m NED."""

    def surround(self, scenario: Scenario) -> None:
        """Go on planning in a changed world: with the obstacles, attractors and targets' paths of this scenario, which
        differs in nothing else from the last one."""


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


class GuardedPlanner:
    """A planner of the user's, whose calls may fail."""

    def __init__(self, planner: PursuerPlanner, guard: Guard) -> None:
        self._planner = planner
        self.guard = guard

    def plan(self, vehicle: VehicleView, situation: Situation) -> tuple[Vec3, Vec3] | None:
        """Position (NED, m) and velocity (NED, m/s) of a pursuer; None where there is no good answer."""
        self.guard.begin_tick(situation.time_s)
        return self.guard.call(vehicle.sysid, lambda: _checked(self._planner.plan(vehicle, situation)))


def _checked(answer: Any) -> tuple[Vec3, Vec3]:
    """The answer as plain numbers. Raises Nonsense."""
    try:
        given = np.asarray(answer)
        if any(map(np.iscomplexobj, given.flat if given.dtype == object else (given,))):
            raise Nonsense("returned complex numbers, which are no place or speed")  # numpy would drop a part of them
        numbers = np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError):
        raise Nonsense(f"returned {type(answer).__name__}, not (p_ned, v_ned) of three numbers each") from None
    if numbers.shape != (2, 3):
        raise Nonsense(f"returned numbers of shape {numbers.shape}, not (p_ned, v_ned) of three numbers each")
    if not (np.abs(numbers) <= FARTHEST).all():
        bad = numbers[~(np.abs(numbers) <= FARTHEST)][0]
        raise Nonsense(f"returned {'NaN' if np.isnan(bad) else f'{bad:g}'}, which is no place or speed")
    (n, e, d), (vn, ve, vd) = numbers.tolist()
    return (n, e, d), (vn, ve, vd)
