"""Baseline flights of scenario families: A* way points and 2-D ORCA on point masses, the yardstick for time to goal.

Each vehicle is a point with a speed and an acceleration limit, decided at 10 Hz. Its wish leads to its aim
(gcs/planner/guide.py) and brakes for the goal and for corners; ORCA [lineage: van den Berg, Guy, Lin, Manocha,
Reciprocal n-body collision avoidance, ISRR 2009; library pyrvo] changes the horizontal part; then no velocity leads
into an obstacle within `_WALL_S`. ORCA knows no acceleration limit, so separations are lost at speed: only its times
are a goal to reach.

Vehicles that start on the ground are put at their take-off height; times leave the take-off out.

    python tests/benchmarks/orca_baseline.py [SEEDS]       writes a row for each scenario and the families' medians
"""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyrvo
from numpy.typing import NDArray

from gcs.campaign.families import family
from gcs.campaign.family_parts import TAKEOFF_M, table_of
from gcs.planner.guide import Follower
from gcs.planner.route import Router
from gcs.scenario import geometry as shapes

FloatArray = NDArray[np.float64]

FLOWN = ("circles", "head_on", "crossings", "walls", "gaps")
PERIOD_S = 0.1
ACCELERATION_M_S2 = 5.0
CLEARANCE_M = 0.6
FLOOR_M = 0.3
MARGIN_M = 0.1
"""[choice] Beyond the separation wanted, between two vehicles."""
ARRIVED_M = 0.3
LONGEST_S = 90.0
_HORIZON_S = 0.7  # [choice] with the turn, of 0.7 to 3 s the fastest on circles 0 to 11, and none stuck there
_NEIGHBOUR_M, _NEIGHBOURS = 15.0, 12
_WALL_S, _WALL_M = 0.5, 0.25
_CORNER_M_S = 0.8
_TURN_RAD = 0.1  # [choice] of the wish to the right, and up to as much more by id, so that nobody stands face to face


@dataclass(frozen=True, slots=True)
class Flight:
    """One scenario's figures; `time_s` is the last vehicle's, inf if one did not arrive."""

    family: str
    seed: int
    vehicles: int
    speed_m_s: float
    separation_m: float
    least_m: float
    clearance_m: float
    time_s: float
    mean_s: float
    stuck: int


def fly(document: dict[str, Any], name: str, seed: int) -> Flight:
    """Fly a scenario whose pursuers have way points."""
    pursuers = document["vehicles"]["pursuers"]
    grounded = not pursuers[0]["airborne"]
    p = np.array([v["start_m"] for v in pursuers], dtype=np.float64)
    p[:, 2] -= TAKEOFF_M if grounded else 0.0
    goals = np.array([v["waypoints_m"][-1] for v in pursuers], dtype=np.float64)
    table, n, cruise = table_of(document), len(pursuers), float(document["planner"]["cruise_m_s"])
    separation_m = float(document["planner"]["separation_m"])
    follower = Follower(Router(table, CLEARANCE_M, floor_m=FLOOR_M if grounded else None))
    orca = pyrvo.RVOSimulator(
        PERIOD_S, _NEIGHBOUR_M, _NEIGHBOURS, _HORIZON_S, _HORIZON_S, (separation_m + MARGIN_M) / 2, cruise
    )
    for place in p:
        orca.add_agent((float(place[0]), float(place[1])))
    v, arrived_s = np.zeros((n, 3)), np.full(n, math.inf)
    least_m = clearance_m = math.inf
    for tick in range(round(LONGEST_S / PERIOD_S)):
        aims = follower.aims(range(n), p, goals)
        wish = _wish(p, goals, aims.aim_ned, aims.remaining_m, cruise)
        for i in range(n):
            orca.set_agent_position(i, (float(p[i, 0]), float(p[i, 1])))
            orca.set_agent_velocity(i, (float(v[i, 0]), float(v[i, 1])))
            orca.set_agent_pref_velocity(i, (float(wish[i, 0]), float(wish[i, 1])))
        orca.do_step()
        for i in range(n):
            wish[i, :2] = orca.get_agent_velocity(i).to_tuple()
            wish[i] = _off_walls(table, p[i], wish[i])
        change = wish - v
        size = np.linalg.norm(change, axis=1, keepdims=True)
        following = v + change * np.minimum(1.0, ACCELERATION_M_S2 * PERIOD_S / np.maximum(size, 1e-9))
        moved = (v + following) / 2 * PERIOD_S
        least_m = min(least_m, _nearest_m(p, moved))
        p, v = p + moved, following
        if len(table):
            clearance_m = min(clearance_m, float(shapes.clearance(table, p).min()))
        there = np.linalg.norm(p - goals, axis=1) <= ARRIVED_M
        arrived_s = np.where(there & np.isinf(arrived_s), (tick + 1) * PERIOD_S, arrived_s)
        if np.isfinite(arrived_s).all():
            break
    flown = float(arrived_s.max())
    stuck = int(np.isinf(arrived_s).sum())
    return Flight(name, seed, n, cruise, separation_m, least_m, clearance_m, flown, float(arrived_s.mean()), stuck)


def _wish(p: FloatArray, goals: FloatArray, aims: FloatArray, remaining_m: FloatArray, cruise: float) -> FloatArray:
    """Towards the aims, braking for goals and for corners, turned a little by id."""
    to_aim = aims - p
    aim_m = np.linalg.norm(to_aim, axis=1)
    brake = 0.6 * ACCELERATION_M_S2
    speed = np.minimum(cruise, np.sqrt(2.0 * brake * np.minimum(remaining_m, 1e6)))
    corner = np.linalg.norm(aims - goals, axis=1) > 1e-6
    speed = np.where(corner, np.minimum(speed, np.sqrt(2.0 * brake * aim_m) + _CORNER_M_S), speed)
    speed = np.minimum(speed, aim_m / PERIOD_S)
    wish: FloatArray = to_aim / np.maximum(aim_m, 1e-9)[:, np.newaxis] * speed[:, np.newaxis]
    # Golden-ratio steps: neighbours in id turn differently.
    angle = _TURN_RAD * (1.0 + np.arange(len(p)) * 0.6180339887 % 1.0)
    cos, sin = np.cos(angle), np.sin(angle)
    north, east = wish[:, 0].copy(), wish[:, 1].copy()
    wish[:, 0], wish[:, 1] = cos * north - sin * east, sin * north + cos * east
    return wish


def _off_walls(table: FloatArray, p: FloatArray, v: FloatArray) -> FloatArray:
    """The velocity without what would bring it nearer than _WALL_M to an obstacle within _WALL_S."""
    if not len(table):
        return v
    distance_m, out_ned = shapes.surface(table, p)
    v = v.copy()
    for _ in range(2):
        for i in np.argsort(distance_m, kind="stable")[:4]:
            missing = -(distance_m[i] - _WALL_M) / _WALL_S - v @ out_ned[i]
            if missing > 0.0:
                v += missing * out_ned[i]
    return v


def _nearest_m(p: FloatArray, moved: FloatArray) -> float:
    """The least distance of any two on straight ways from p to p + moved."""
    if len(p) < 2:
        return math.inf
    i, j = np.triu_indices(len(p), 1)
    apart, change = p[i] - p[j], moved[i] - moved[j]
    square = np.maximum((change**2).sum(axis=1), 1e-12)
    t = np.clip(-(apart * change).sum(axis=1) / square, 0.0, 1.0)
    return float(np.linalg.norm(apart + t[:, np.newaxis] * change, axis=1).min())


def main() -> None:
    """Fly each family's first seeds and print the table."""
    seeds = int(sys.argv[1]) if len(sys.argv) > 1 else 10
    print("family,seed,vehicles,speed_m_s,separation_m,least_m,clearance_m,time_s,mean_s,stuck")
    summary = []
    for name in FLOWN:
        flights = [fly(family(name, seed), name, seed) for seed in range(seeds)]
        for f in flights:
            print(
                f"{f.family},{f.seed},{f.vehicles},{f.speed_m_s:.2f},{f.separation_m:.2f},{f.least_m:.3f},"
                f"{f.clearance_m:.3f},{f.time_s:.1f},{f.mean_s:.2f},{f.stuck}"
            )
        too_near = sum(f.least_m < f.separation_m for f in flights)
        times, means = ([getattr(f, key) for f in flights] for key in ("time_s", "mean_s"))
        summary.append(
            f"| {name} | {len(flights)} | {np.median(times):.1f} | {np.median(means):.1f} | {too_near} | "
            f"{min(f.least_m for f in flights):.2f} | {min(f.clearance_m for f in flights):.2f} | "
            f"{sum(f.clearance_m < 0 for f in flights)} | {sum(f.stuck > 0 for f in flights)} |"
        )
    print("\n| family | n | median time, s | median mean, s | too near | least, m | clearance, m | touched | stuck |")
    print("|---|---|---|---|---|---|---|---|---|")
    print("\n".join(summary))


if __name__ == "__main__":
    main()
