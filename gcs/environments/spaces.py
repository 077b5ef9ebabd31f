"""Views and actions of agents by default, and the spaces of both, made from the scenario.

Numbers are in SI, places and velocities in the common NED frame; Gymnasium's wrappers scale them where a policy wants
that.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from gymnasium.spaces import Box
from numpy.typing import NDArray

from gcs.environments.transition import pursued
from gcs.scenario.model import Pursuer, Scenario
from gcs.scenario.plot import bounds
from gcs.session.arrays import Snapshot
from skytender import elementary

NEAREST_OBSTACLES = 3
FASTEST_SHARE = 3.0
"""Speeds are observed up to so many times the greatest that the scenario asks of any vehicle."""


class Observation:
    """View of a vehicle's agent, as one vector of float32, in this order:

    place (3, m), velocity (3, m/s), roll, pitch and yaw (3, rad), battery (1, share of its capacity);
    where it pursues a target: place and velocity of that, from its own (6);
    where it has way points: the last one, from its place (3);
    of each other vehicle by system id: whether it is alive and its place known (1), place and velocity from its own
    (6), else zeros;
    the nearest points of the up to three nearest obstacles' surfaces, from its place (3 each), zeros inside one.

    Where a number is not known it is 0. Each is clipped to the space's bounds: a place to as far as a vehicle can get
    in the session, a velocity to three times the greatest that the scenario asks of any vehicle.
    """

    def __init__(self, scenario: Scenario, sysid: int, space: Box | None = None) -> None:
        """space: of another scenario with the same vehicles, that this one is to keep to. Raises ValueError where it
        has other numbers."""
        fleet = {vehicle.sysid: vehicle for vehicle in scenario.vehicles.all}
        own = fleet[sysid]
        order = sorted(fleet)
        target = pursued(own, scenario)
        self._row, self._target = order.index(sysid), None if target is None else order.index(target)
        """rows of a snapshot"""
        self._waypoint: NDArray[np.float64] | None = None
        if isinstance(own, Pursuer) and own.waypoints_m:
            self._waypoint = np.array(own.waypoints_m[-1], np.float64)
        self._others = [row for row in range(len(order)) if row not in (self._row, self._target)]
        self._obstacles = _Surfaces(scenario)
        own_space = Box(*self._limits(scenario), dtype=np.float32)
        self.space = space or own_space
        if self.space.shape != own_space.shape:
            raise ValueError(
                f"vary has changed what vehicle {sysid} sees from {self.space.shape[0]} numbers to "
                f"{own_space.shape[0]}: keep what it follows, and {NEAREST_OBSTACLES} obstacles or as many"
            )

    def _limits(self, scenario: Scenario) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        far_m, fast_m_s = reach_m(scenario), FASTEST_SHARE * fastest_m_s(scenario)
        moving = [2.0 * far_m] * 3 + [2.0 * fast_m_s] * 3
        high, share = [*[far_m] * 3, *[fast_m_s] * 3, *[np.pi] * 3, 1.0], {9}
        """places of the numbers that lie between 0 and 1"""
        high += moving if self._target is not None else []
        high += [2.0 * far_m] * 3 if self._waypoint is not None else []
        for _ in self._others:
            share.add(len(high))
            high += [1.0, *moving]
        high += [2.0 * far_m] * (3 * self._obstacles.count)
        low = [0.0 if k in share else -number for k, number in enumerate(high)]
        return np.array(low, np.float32), np.array(high, np.float32)

    def __call__(self, snapshot: Snapshot) -> NDArray[np.float32]:
        """The vector at a snapshot."""
        motion = np.concatenate([snapshot.p_ned, snapshot.v_ned], axis=1)
        row = self._row
        own = motion[row]
        parts = [own, snapshot.attitude_rad[row], snapshot.battery[row : row + 1]]
        if self._target is not None:
            parts.append(motion[self._target] - own)
        if self._waypoint is not None:
            parts.append(self._waypoint - own[:3])
        if self._others:
            apart = motion[self._others] - own
            known = snapshot.alive[self._others] & np.isfinite(apart).all(axis=1)
            parts.append(np.column_stack([known, np.where(known[:, None], apart, 0.0)]).ravel())
        parts.append(self._obstacles.nearest(own[:3]))
        seen = np.nan_to_num(np.concatenate(parts), nan=0.0).astype(np.float32)
        return np.clip(seen, self.space.low, self.space.high)


class _Surfaces:
    """The scenario's obstacles as arrays."""

    def __init__(self, scenario: Scenario) -> None:
        shapes = scenario.obstacles
        self.count = min(len(shapes), NEAREST_OBSTACLES)
        self._low = np.array([shape.low_m for shape in shapes], np.float64).reshape(-1, 3)
        self._high = np.array([shape.high_m for shape in shapes], np.float64).reshape(-1, 3)
        self._radius = np.array([shape.radius_m for shape in shapes], np.float64)
        round_ = [(1.0, 1.0, 0.0 if shape.kind == "cylinder" else 1.0) for shape in shapes]
        self._round = np.array(round_, np.float64).reshape(-1, 3)
        """by axis, whether the radius counts along it"""

    def nearest(self, p_ned: NDArray[np.float64]) -> NDArray[np.float64]:
        """From a place to the nearest points of the nearest surfaces, the nearest first."""
        if not self.count or not np.isfinite(p_ned).all():
            return np.zeros(3 * self.count)
        to = np.clip(p_ned, self._low, self._high) - p_ned
        around = to * self._round
        off_m = np.sqrt((around * around).sum(axis=1))
        with np.errstate(invalid="ignore", divide="ignore"):
            share = np.where(off_m > self._radius, self._radius / off_m, 1.0)
        to = to - around * share[:, None]
        order = np.argsort((to * to).sum(axis=1), kind="stable")[: self.count]
        return to[order].ravel()


class VelocityAction:
    """Action of a vehicle's agent: three shares, -1 to 1, of the planner's `cruise_m_s`, along north, east and down.

    The set point that was sent last, or the vehicle's place where none was, moves with that velocity for one step; its
    first tick stays within the planner's `leash_m` of the vehicle. Vectors longer than 1 are shortened.
    """

    def __init__(self, scenario: Scenario, step_s: float) -> None:
        self.space = Box(-1.0, 1.0, (3,), np.float32)
        self._speed_m_s, self._leash_m = scenario.planner.cruise_m_s, scenario.planner.leash_m
        self._period_s = scenario.clock.period_s
        self._after_s = step_s - self._period_s
        """from a step's first tick to its snapshot"""

    def __call__(self, action: Any, snapshot: Snapshot, sysid: int) -> tuple[list[float], list[float]]:
        """(p_ned, v_ned) of the set point for the next snapshot's time."""
        row = snapshot.row(sysid)
        shares = np.asarray(action, np.float64).tolist()
        speed_m_s = self._speed_m_s / max(elementary.norm(shares), 1.0)
        v_ned = [speed_m_s * share for share in shares]
        p_ned, sent = snapshot.p_ned[row].tolist(), snapshot.set_point_p_ned[row]
        begin = sent.tolist() if np.isfinite(sent).all() else p_ned
        ahead = [b + v * self._period_s - p for b, v, p in zip(begin, v_ned, p_ned, strict=True)]
        keep = min(self._leash_m / max(elementary.norm(ahead), 1e-9), 1.0)
        return [p + keep * a + v * self._after_s for p, a, v in zip(p_ned, ahead, v_ned, strict=True)], v_ned


def fastest_m_s(scenario: Scenario) -> float:
    """The greatest speed that the scenario asks of any vehicle, m/s."""
    fleet = scenario.vehicles
    speeds = [scenario.planner.cruise_m_s, *(elementary.norm(vehicle.velocity_m_s) for vehicle in fleet.all)]
    speeds += [target.speed_m_s for target in fleet.targets] + [tanker.speed_m_s for tanker in fleet.tankers]
    return max(speeds)


def reach_m(scenario: Scenario) -> float:
    """How far from the origin, along any axis, a vehicle can get: past all that the scenario names, at its greatest
    speed until the session's end, m."""
    fleet = scenario.vehicles
    (south, west), (north, east) = bounds(scenario)
    heights = [vehicle.start_m[2] for vehicle in fleet.all] + [vehicle.takeoff_m for vehicle in fleet.all]
    heights += [point[2] for target in fleet.targets for point in target.path_m]
    heights += [point[2] for pursuer in fleet.pursuers for point in pursuer.waypoints_m]
    heights += [height for shape in scenario.obstacles for height in (shape.low_m[2], shape.high_m[2])]
    extent_m = max(abs(number) for number in (south, west, north, east, *heights))
    return extent_m + fastest_m_s(scenario) * scenario.goal.duration_s
