"""Yardstick for planner and safety filter: A* way points and 2-D ORCA as a planner of a user's own.

    planner: {method: "orca_planner:AStarOrca", safety: false}

It flies the same vehicles over the same links as the shipped planner does. Each pursuer has a leader with the vehicle's
limits of speed and acceleration. Its wish leads along its route (gcs/planner/guide.py) and brakes for goal and corners;
ORCA [lineage: van den Berg, Guy, Lin, Manocha, Reciprocal n-body collision avoidance, ISRR 2009; library pyrvo] changes
the horizontal part; then no velocity leads into an obstacle within `_WALL_S`. ORCA itself knows no acceleration limit,
and takes everyone for somebody who does the same: targets, tankers and traffic, too.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pyrvo
from numpy.typing import ArrayLike, NDArray

from gcs.planner import goals
from gcs.planner.guide import RouteFollower
from gcs.planner.request import Situation
from gcs.planner.route import Router
from gcs.scenario.model import Scenario
from gcs.telemetry.state import VehicleView
from skytender import geometry

FloatArray = NDArray[np.float64]

ACCELERATION_M_S2 = 4.0
"""[choice] What launched vehicles follow: 0.8 of MPC_ACC_HOR, as the shipped planner's leaders."""
CLEARANCE_M = 0.6
FLOOR_M = 0.3
MARGIN_M = 0.1
"""[choice] Beyond the separation wanted, between two vehicles."""
LOOKAHEAD_S = 0.37
HORIZON_S = 0.7  # [choice] with the turn, of 0.7 to 3 s the fastest on circles 0 to 11, and none stuck there
NEIGHBOUR_M, _NEIGHBOURS = 15.0, 12
_WALL_S, _WALL_M, _STEP_M = 0.5, 0.25, 1e-4
_CORNER_M_S = 0.8
_TURN_RAD = 0.1  # [choice] of the wish to the right, and up to as much more by id, so that nobody stands face to face


class AStarOrca:
    """Leaders of all pursuers, moved together once a tick."""

    def __init__(self, scenario: Scenario) -> None:
        self._scenario = scenario
        self._table = geometry.of_scenario(scenario.obstacles)
        grounded = any(not v.airborne for v in scenario.vehicles.pursuers)
        self._guide = RouteFollower(Router(self._table, CLEARANCE_M, floor_m=FLOOR_M if grounded else None))
        self._ends = {p.sysid: p.waypoints_m[-1] for p in scenario.vehicles.pursuers if p.waypoints_m}
        ring_m = scenario.formation.ring_m or 0.0
        ids = [p.sysid for p in scenario.vehicles.pursuers]
        offsets = goals.ring_offsets(len(ids), ring_m, scenario.formation.height_m)
        self._offsets = dict(zip(ids, offsets, strict=True))
        self._p: dict[int, FloatArray] = {}
        self._v: dict[int, FloatArray] = {}
        self._answers: dict[int, tuple[FloatArray, FloatArray]] = {}
        self._time_s = -math.inf
        ends = [p for p in scenario.vehicles.pursuers if p.waypoints_m]
        if ends:  # the first routes of a large fleet take longer than a tick may
            starts, aims = np.array([p.start_m for p in ends]), np.array([self._ends[p.sysid] for p in ends])
            self._guide.aims([p.sysid for p in ends], starts, aims)

    def plan(self, vehicle: VehicleView, situation: Situation) -> tuple[ArrayLike, ArrayLike]:
        """Place and velocity of a vehicle's leader; the first call of a tick moves all of them."""
        if situation.time_s > self._time_s:
            self._time_s = situation.time_s
            self._move(situation)
        if vehicle.sysid not in self._p:
            self._p[vehicle.sysid], self._v[vehicle.sysid] = np.array(vehicle.p_now_ned()), np.zeros(3)
            return self._p[vehicle.sysid], np.zeros(3)
        return self._answers.get(vehicle.sysid, (self._p[vehicle.sysid], np.zeros(3)))

    def _move(self, situation: Situation) -> None:
        led = sorted(self._p)
        if not led:
            return
        p, v = np.array([self._p[i] for i in led]), np.array([self._v[i] for i in led])
        goals, goal_v = self._goals(situation, led)
        speed, period_s = self._scenario.planner.cruise_m_s, situation.period_s
        wish = self._wish(led, p, goals, goal_v, speed, period_s)
        wish = self._reciprocal(situation, led, p, v, wish, speed)
        wish = _off_walls(self._table, p, wish)
        change = wish - v
        size = np.linalg.norm(change, axis=1, keepdims=True)
        v_next = v + change * np.minimum(1.0, ACCELERATION_M_S2 * period_s / np.maximum(size, 1e-9))
        mean = (v + v_next) / 2
        for i, sysid in enumerate(led):
            self._answers[sysid] = p[i], mean[i]
            self._p[sysid], self._v[sysid] = p[i] + mean[i] * period_s, v_next[i]

    def _goals(self, situation: Situation, led: Sequence[int]) -> tuple[FloatArray, FloatArray]:
        """Last way points, or slots of the ring about the target as it flies, and their velocities."""
        goals, velocities = np.array([self._p[i] for i in led]), np.zeros((len(led), 3))
        for i, sysid in enumerate(led):
            target = situation.target(situation.snapshot.vehicle(sysid))
            if sysid in self._ends:
                goals[i] = self._ends[sysid]
            elif target is not None:
                velocities[i] = target.v_ned
                goals[i] = np.array(target.p_now_ned()) + LOOKAHEAD_S * velocities[i] + self._offsets[sysid]
        return goals, velocities

    def _wish(
        self, led: Sequence[int], p: FloatArray, goals: FloatArray, goal_v: FloatArray, cruise: float, period_s: float
    ) -> FloatArray:
        """Towards the aims, braking for goals and for corners, turned a little by id."""
        aims = self._guide.aims(led, p, goals)
        to_aim = aims.aim_ned - p
        aim_m = np.linalg.norm(to_aim, axis=1)
        brake = 0.6 * ACCELERATION_M_S2
        speed = np.minimum(cruise, np.sqrt(2.0 * brake * np.minimum(aims.remaining_m, 1e6)))
        corner = np.linalg.norm(aims.aim_ned - goals, axis=1) > 1e-6
        speed = np.where(corner, np.minimum(speed, np.sqrt(2.0 * brake * aim_m) + _CORNER_M_S), speed)
        speed = np.minimum(speed, aim_m / period_s)
        wish: FloatArray = to_aim / np.maximum(aim_m, 1e-9)[:, np.newaxis] * speed[:, np.newaxis]
        angle = _TURN_RAD * (1.0 + np.array(led) * 0.6180339887 % 1.0)  # golden ratio: neighbours in id differ
        cos, sin = np.cos(angle), np.sin(angle)
        north, east = wish[:, 0].copy(), wish[:, 1].copy()
        wish[:, 0], wish[:, 1] = cos * north - sin * east, sin * north + cos * east
        wish += np.where(corner[:, np.newaxis], 0.0, goal_v)
        size = np.linalg.norm(wish, axis=1, keepdims=True)
        return wish * np.minimum(1.0, cruise / np.maximum(size, 1e-9))

    def _everything(
        self, situation: Situation, led: Sequence[int], p: FloatArray, v: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Places and velocities (m, 3) of all that are in the air, leaders first."""
        others = [
            (o.p_now_ned(), o.v_ned) for o in situation.snapshot.vehicles if o.flying and o.p_ned and o.sysid not in led
        ]
        others += [(a.p_ned, a.v_ned) for a in situation.snapshot.traffic]
        if not others:
            return p, v
        return np.vstack([p, [place for place, _ in others]]), np.vstack([v, [velocity for _, velocity in others]])

    def _reciprocal(
        self, situation: Situation, led: Sequence[int], p: FloatArray, v: FloatArray, wish: FloatArray, speed: float
    ) -> FloatArray:
        """Velocities (n, 3) that evade; this one changes their horizontal part."""
        separation_m = self._scenario.planner.separation_m
        orca = pyrvo.RVOSimulator(
            situation.period_s, NEIGHBOUR_M, _NEIGHBOURS, HORIZON_S, HORIZON_S, (separation_m + MARGIN_M) / 2, speed
        )
        for place, velocity in zip(*self._everything(situation, led, p, v), strict=True):
            agent = orca.add_agent((float(place[0]), float(place[1])))
            orca.set_agent_velocity(agent, (float(velocity[0]), float(velocity[1])))
            orca.set_agent_pref_velocity(agent, (float(velocity[0]), float(velocity[1])))
        for i in range(len(led)):
            orca.set_agent_pref_velocity(i, (float(wish[i, 0]), float(wish[i, 1])))
        orca.do_step()
        level = np.array([orca.get_agent_velocity(i).to_tuple() for i in range(len(led))])
        return np.column_stack([level, wish[:, 2]])


def _off_walls(table: FloatArray, p: FloatArray, v: FloatArray) -> FloatArray:
    """Velocities (n, 3) without what would bring each nearer than _WALL_M to an obstacle within _WALL_S."""
    v = v.copy()
    distances_m = np.array([geometry.clearance(table[k : k + 1], p) for k in range(len(table))]).reshape(-1, len(p)).T
    reach_m = _WALL_M + _WALL_S * np.linalg.norm(v, axis=1, keepdims=True)
    for i in np.flatnonzero((distances_m < reach_m).any(axis=1)).tolist():
        near = [k for k in np.argsort(distances_m[i], kind="stable")[:4] if distances_m[i, k] < reach_m[i, 0]]
        out_ned = [_outward(table[k : k + 1], p[i]) for k in near]
        for _ in range(2):
            for k, away in zip(near, out_ned, strict=True):
                missing = -(distances_m[i, k] - _WALL_M) / _WALL_S - v[i] @ away
                if missing > 0.0:
                    v[i] += missing * away
    return v


def _outward(obstacle: FloatArray, place: FloatArray) -> FloatArray:
    """Direction in which the distance from an obstacle grows, by differences."""
    steps = np.vstack([_STEP_M * np.eye(3), -_STEP_M * np.eye(3)])
    around = geometry.clearance(obstacle, place + steps)
    gradient: FloatArray = around[:3] - around[3:]
    return gradient / max(float(np.linalg.norm(gradient)), 1e-12)
