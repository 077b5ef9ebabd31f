"""One tick of planning: from the fleet's snapshot to a set point for every vehicle that is being steered.

Each vehicle has a virtual leader (model.md 6). Targets' leaders follow a carrot along the scenario's path, pursuers'
their slot of the formation, tankers' the place above their receiver or where they wait. A vehicle flies LOOKAHEAD_S
behind its leader (model.md 5: 0.32 s of guidance, and half a grant). So leaders keep formation with leaders, and
everything else that moves is looked at where it will be by then.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gcs.fleet import Snapshot, Vec3, VehicleView
from gcs.planner import formation, fuzzy, leader, obstacles
from gcs.planner.potential_field import Field, widened_range
from gcs.scenario import Obstacle, Scenario, Target

LOOKAHEAD_S = 0.37
CATCH_UP_SPEED = 1.3
"""A target's leader may be this much faster than its carrot, so that it comes back after an obstacle."""
STILL: Vec3 = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class SetPoint:
    """Where one vehicle is to be at the tick's time and how fast it is to move on; common NED frame."""

    sysid: int
    p_ned: Vec3
    v_ned: Vec3


@dataclass(frozen=True, slots=True)
class _Wanted:
    """A leader's goal, the goal's velocity and the leader's speed limit."""

    p_ned: Vec3
    v_ned: Vec3
    speed_m_s: float


def obstacle_table(shapes: Iterable[Obstacle]) -> NDArray[np.float64]:
    """The planner's table of a scenario's obstacles."""
    rows = []
    for shape in shapes:
        low, high = np.array(shape.low_m), np.array(shape.high_m)
        centre = (low + high) / 2.0
        if shape.kind == "point":
            rows.append(obstacles.point(centre))
        elif shape.kind == "sphere":
            rows.append(obstacles.sphere(centre, shape.radius_m))
        elif shape.kind == "box":
            rows.append(obstacles.box(low, high))
        else:
            rows.append(obstacles.cylinder(centre, shape.radius_m, float(high[2] - low[2])))
    return obstacles.table(rows)


class Planner:
    """The leaders of all steered vehicles; `plan` moves them by one period."""

    def __init__(self, scenario: Scenario) -> None:
        rules = scenario.planner
        self._scenario = scenario
        self._field = Field(
            k0=rules.k0,
            k1=rules.k1,
            a=rules.a,
            b=rules.b,
            attraction_range_m=rules.attraction_range_m,
            repulsion_range_m=rules.repulsion_range_m,
            step_m=rules.step_m,
        )
        self.obstacles = obstacle_table(scenario.obstacles)
        self._q: dict[int, NDArray[np.float64]] = {}
        self._v: dict[int, Vec3] = {}
        self._memory: dict[int, NDArray[np.float64]] = {}
        self._paths = {
            target.sysid: formation.Path(target.path_m, closed=target.closed, laps=target.laps)
            for target in scenario.vehicles.targets
        }
        self._way_m = dict.fromkeys(self._paths, 0.0)
        self._slots: dict[int, Vec3] = {}
        self._slots_of: dict[int, frozenset[int]] = {}

    def plan(
        self,
        snapshot: Snapshot,
        steered: frozenset[int],
        *,
        rendezvous: Mapping[int, int],
        partners: Iterable[tuple[int, int]],
        targets_move: bool,
        period_s: float,
    ) -> list[SetPoint]:
        """Set points for the vehicles in `steered`, in order of system id; each holds at the snapshot's time.

        `rendezvous` says which receiver a tanker is to stand above; `partners` are pairs that may come close.
        """
        views = [view for view in snapshot.vehicles if view.sysid in steered and view.p_ned is not None]
        self._forget({view.sysid for view in views})
        if not views:
            return []
        for view in views:
            if view.sysid not in self._q:
                self._q[view.sysid] = np.array(view.p_now_ned())
                self._v[view.sysid] = STILL
                self._memory[view.sysid] = fuzzy.new_memory(1)[0]
        wanted = self._wants(snapshot, views, rendezvous, targets_move=targets_move, period_s=period_s)
        others = [view for view in snapshot.vehicles if view.flying]
        q = np.array([self._q[view.sysid] for view in views])
        at, ranges, owner = self._movers(snapshot, views, others)
        q_next, memory, v_ned = leader.advance(
            q,
            np.array([self._memory[view.sysid] for view in views]),
            np.array([want.p_ned for want in wanted]),
            np.array([want.v_ned for want in wanted]),
            repulsors=self.obstacles,
            moving=at,
            ranges_m=ranges,
            owner=owner,
            exempt=self._exempt(views, others, len(at), partners),
            field=self._field,
            speed_m_s=np.array([self._leashed(view, want.speed_m_s) for view, want in zip(views, wanted, strict=True)]),
            period_s=period_s,
            escape=self._scenario.planner.escape,
        )
        set_points = []
        for i, view in enumerate(views):
            set_points.append(SetPoint(view.sysid, _vec(q[i]), _vec(v_ned[i])))
            self._q[view.sysid], self._memory[view.sysid] = q_next[i], memory[i]
            self._v[view.sysid] = set_points[-1].v_ned
        return set_points

    def _forget(self, kept: set[int]) -> None:
        """A vehicle that is not steered any more starts from where it is, should it come back."""
        for sysid in self._q.keys() - kept:
            del self._q[sysid], self._v[sysid], self._memory[sysid]

    def _wants(
        self,
        snapshot: Snapshot,
        views: list[VehicleView],
        rendezvous: Mapping[int, int],
        *,
        targets_move: bool,
        period_s: float,
    ) -> list[_Wanted]:
        vehicles = self._scenario.vehicles
        wants: dict[int, _Wanted] = {}
        for target in vehicles.targets:
            wants[target.sysid] = self._carrot(target, targets_move, period_s)
        wants.update(self._formation(snapshot))
        for tanker in vehicles.tankers:
            waiting = tanker.home_m or (tanker.start_m[0], tanker.start_m[1], tanker.start_m[2] - tanker.takeoff_m)
            (n, e, d), v_ned = waiting, STILL
            if tanker.sysid in rendezvous:
                (n, e, d), v_ned = self._led(snapshot.vehicle(rendezvous[tanker.sysid]))
                d -= self._scenario.refuelling.height_m
            wants[tanker.sysid] = _Wanted((n, e, d), v_ned, tanker.speed_m_s)
        return [wants.get(view.sysid, _Wanted(_vec(self._q[view.sysid]), STILL, 0.0)) for view in views]

    def _carrot(self, target: Target, moves: bool, period_s: float) -> _Wanted:
        path = self._paths[target.sysid]
        p_ned, direction = path.at(self._way_m[target.sysid])
        leader_at = self._q.get(target.sysid)
        arrived = leader_at is not None and math.dist(leader_at, p_ned) < self._scenario.planner.leash_m
        if not (moves and arrived):
            return _Wanted(p_ned, STILL, CATCH_UP_SPEED * target.speed_m_s)
        self._way_m[target.sysid] += target.speed_m_s * period_s
        v_ned = (direction[0] * target.speed_m_s, direction[1] * target.speed_m_s, direction[2] * target.speed_m_s)
        return _Wanted(p_ned, v_ned, CATCH_UP_SPEED * target.speed_m_s)

    def _formation(self, snapshot: Snapshot) -> dict[int, _Wanted]:
        """Each pursuer's slot around its target, assigned anew when the set of pursuers in the air changes."""
        rules = self._scenario.formation
        wants = {}
        for target in self._scenario.vehicles.targets:
            lead = snapshot.vehicle(target.sysid)
            vehicles = self._scenario.vehicles
            mine = [p for p in vehicles.pursuers if vehicles.target_of(p) == target.sysid]
            flying = {p.sysid: snapshot.vehicle(p.sysid) for p in mine}
            here = {sysid: view.p_now_ned() for sysid, view in flying.items() if view.flying}
            if lead.p_ned is None or not here:
                continue
            centre, v_ned = self._led(lead)
            if self._slots_of.get(target.sysid) != frozenset(here):
                self._slots_of[target.sysid] = frozenset(here)
                offsets = formation.ring_offsets(len(here), rules.ring_m or 0.0, rules.height_m)
                for sysid, slot in formation.assign(here, offsets + np.array(centre)).items():
                    self._slots[sysid] = _vec(offsets[slot])
            for sysid in here:
                offset = self._slots[sysid]
                goal = (centre[0] + offset[0], centre[1] + offset[1], centre[2] + offset[2])
                wants[sysid] = _Wanted(goal, v_ned, self._scenario.planner.cruise_m_s)
        return wants

    def _led(self, view: VehicleView) -> tuple[Vec3, Vec3]:
        """Place and velocity with which to keep formation: the leader's; without one, the vehicle's, looked ahead."""
        if view.sysid in self._q:
            return _vec(self._q[view.sysid]), self._v[view.sysid]
        return _ahead(view.p_now_ned(), view.v_ned), view.v_ned

    def _movers(
        self, snapshot: Snapshot, views: list[VehicleView], others: list[VehicleView]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.int64]]:
        """Places, ranges and owners of everything that moves and repels: vehicles in the air, then traffic."""
        rows = {view.sysid: i for i, view in enumerate(views)}
        at = [_ahead(view.p_now_ned(), view.v_ned) for view in others]
        speeds = [math.hypot(*view.v_ned) for view in others]
        ages = [view.age_s for view in others]
        for aircraft in snapshot.traffic:
            at.append(_ahead(aircraft.p_ned, aircraft.v_ned, LOOKAHEAD_S + aircraft.age_s))
            speeds.append(math.hypot(*aircraft.v_ned))
            ages.append(aircraft.age_s + self._scenario.clock.period_s)
        ranges = widened_range(self._field.repulsion_range_m, np.array(speeds), np.array(ages))
        owner = np.array([rows.get(view.sysid, -1) for view in others] + [-1] * len(snapshot.traffic), dtype=np.int64)
        return np.array(at).reshape(-1, 3), np.broadcast_to(ranges, len(at)), owner

    def _exempt(
        self, views: list[VehicleView], others: list[VehicleView], movers: int, partners: Iterable[tuple[int, int]]
    ) -> NDArray[np.bool_]:
        """Whom each leader need not keep away from: partners of a transfer; the pursuers, for the one they pursue."""
        exempt = np.zeros((len(views), movers), dtype=bool)
        close = {pair for a, b in partners for pair in ((a, b), (b, a))}
        for i, view in enumerate(views):
            for j, other in enumerate(others):
                exempt[i, j] = (
                    (view.sysid, other.sysid) in close
                    or (view.role == "target" and other.role != "target")
                    or (view.role == "pursuer" and other.role == "target" and self._scenario.formation.ring_m is None)
                )
        return exempt

    def _leashed(self, view: VehicleView, speed_m_s: float) -> float:
        """The leader waits for a vehicle that has fallen behind by more than its speed explains."""
        assert view.p_ned is not None
        slack_m = self._scenario.planner.leash_m + LOOKAHEAD_S * speed_m_s
        behind_m = math.dist(self._q[view.sysid], view.p_now_ned())
        return speed_m_s * min(max(2.0 * (1.0 - behind_m / slack_m), 0.0), 1.0)


def _ahead(p_ned: Vec3, v_ned: Vec3, time_s: float = LOOKAHEAD_S) -> Vec3:
    return (p_ned[0] + v_ned[0] * time_s, p_ned[1] + v_ned[1] * time_s, p_ned[2] + v_ned[2] * time_s)


def _vec(row: NDArray[np.float64] | Mapping[int, float]) -> Vec3:
    return (float(row[0]), float(row[1]), float(row[2]))
