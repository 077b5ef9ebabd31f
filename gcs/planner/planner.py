"""One tick of planning: from the fleet's snapshot to a set point for every vehicle that is being steered.

Each vehicle has a virtual leader (docs/model.md#planned-point). Targets' leaders follow a carrot along the scenario's
path, pursuers' their slot of the formation or their own way points, tankers' the place above their receiver or where
they wait. A vehicle flies LOOKAHEAD_S behind its leader (docs/model.md#guidance: 0.32 s of guidance, and half a grant).
So leaders keep formation with leaders, and everything else that moves is looked at where it will be by then. Targets
are planned first, then pursuers, then tankers, so that each follows what the one before it does in this very period.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gcs.mavlink.setpoints import SetPoint
from gcs.planner import formation, fuzzy_escape, leader
from gcs.planner.fence import FenceBorder
from gcs.planner.guide import STRAIGHT, RouteFollower
from gcs.planner.link_age import SlowLinks
from gcs.planner.potential_field import FieldConstants, widened_range
from gcs.planner.request import PlanRequest, TickPlanner
from gcs.planner.route import Router
from gcs.scenario import geometry
from gcs.scenario.model import Scenario, Tanker, Target
from gcs.telemetry.state import FleetSnapshot, Vec3, VehicleView

LOOKAHEAD_S = 0.37
CATCH_UP_SPEED = 1.3
"""A target's leader may be this much faster than its carrot, so that it comes back after an obstacle."""
FLOOR_M = 0.3
"""No leader of a vehicle that has a ground goes lower than this above it: only landing does."""
LEAST_MARGIN_M = 0.1
"""Of every vehicle: so much farther than its clearance the safety filter keeps it from obstacles."""
BRAKE_SHARE = 0.4
"""Of the acceleration of leaders, with which they are to stop at their goals; the rest is for giving way."""
SAFE_RANGE_SHARE = 0.5
"""[choice] Of the range in which vehicles repel each other, where the safety filter keeps them apart: at all of it
those who hover in a tight row push each other to and fro."""
ROLES = ("target", "pursuer", "tanker")
NEAR_GOAL_M = 2.0
"""A route shorter than this is flown with the velocity of its goal."""
OFF_PLAN_M = 1.0
"""A vehicle farther than this from its plan is met where it flies, not where it is planned."""
GROUND_ROUNDING_M = 0.1
"""Difference of a home from height 0 that the wire's rounding alone can cause."""
STILL: Vec3 = (0.0, 0.0, 0.0)


class _Wanted(NamedTuple):
    """A leader's goal, the goal's velocity and the leader's speed limit; on a route, the way that is left of it."""

    p_ned: Vec3
    v_ned: Vec3
    speed_m_s: float
    route_m: float | None = None


class _Movers(NamedTuple):
    """Everything that moves and repels: vehicles in the air, then traffic; places (m, 3), radii and ranges (m,), m."""

    views: list[VehicleView]
    p_ned: NDArray[np.float64]
    radii_m: NDArray[np.float64]
    ranges_m: NDArray[np.float64]


class Planner(TickPlanner):
    """The leaders of all steered vehicles; `plan` moves them by one period."""

    def __init__(self, scenario: Scenario) -> None:
        rules = scenario.planner
        self._scenario, self._rules = scenario, rules
        self._followed = scenario.vehicles.followed
        self._field = FieldConstants(
            k0=rules.k0,
            k1=rules.k1,
            a=rules.a,
            b=rules.b,
            attraction_range_m=rules.attraction_range_m,
            repulsion_range_m=rules.repulsion_range_m,
            step_m=rules.step_m,
            full_steps=rules.full_steps,
        )
        self.obstacles = geometry.of_scenario(scenario.obstacles)
        self._q: dict[int, Vec3] = {}
        self._v: dict[int, Vec3] = {}
        self._memory: dict[int, NDArray[np.float64]] = {}
        self._paths = {
            target.sysid: formation.ConstantSpeedPath(target.path_m, closed=target.closed, laps=target.laps)
            for target in scenario.vehicles.targets
        }
        self._begin: dict[int, Vec3] = {}
        self._here: dict[int, Vec3] = {}
        """where vehicles are now, of all that have told their place"""
        self._slow = SlowLinks()
        self._pursuing: Mapping[int, int] | None = None
        self._stations: Mapping[int, Vec3] = {}
        self._way_m = dict.fromkeys(self._paths, 0.0)
        self._courses = {p.sysid: list(p.waypoints_m) for p in scenario.vehicles.pursuers if p.waypoints_m}
        self._reached_m = self._field.step_m
        if rules.safety:  # a leader with an inertia passes by within a period's way
            self._reached_m = max(self._reached_m, rules.cruise_m_s * scenario.clock.period_s)
        self._starts = {p.sysid: p.start_m for p in scenario.vehicles.pursuers if p.waypoints_m and p.airborne}
        self._attracting = {mover.callsign for mover in scenario.traffic if mover.attracts}
        self._radii_m = {role: self._radius_m(role) for role in ROLES}
        self._grounded = {v.sysid for v in scenario.vehicles.all if not v.airborne}
        self._guides: dict[str, RouteFollower] | None = None
        clearance_m = 2.0 * (rules.clearance_m + LEAST_MARGIN_M)
        self._fence = FenceBorder(scenario, clearance_m)
        solid = np.concatenate([self.obstacles, self._fence.walls])
        if rules.safety and rules.guide and len(solid):
            router = Router(solid, clearance_m, floor_m=FLOOR_M if self._grounded else None)
            router.prepare()
            self._guides = {role: RouteFollower(router) for role in ROLES}
        self._exempted: dict[str, tuple[tuple[Any, ...], NDArray[np.bool_]]] = {}
        """by role: of whom, and the answer, which seldom changes"""
        self._slots: dict[int, Vec3] = {}
        self._slots_of: dict[int, frozenset[int]] = {}

    def plan(self, request: PlanRequest) -> list[SetPoint]:
        """Set points for the steered vehicles, in order of system id; each holds at the snapshot's time."""
        snapshot, steered, period_s = request.snapshot, request.steered, request.period_s
        views = [view for view in snapshot.vehicles if view.sysid in steered and view.p_ned is not None]
        self._forget({view.sysid for view in views})
        if self._rules.safety:
            for view in snapshot.vehicles:
                self._slow.receive(view.sysid, view.age_s, period_s)
        if not views:
            return []
        for view in views:
            if view.sysid not in self._q:
                start = self._starts.pop(view.sysid, None)
                self._q[view.sysid] = view.p_now_ned() if start is None else start
                self._v[view.sysid] = STILL
                self._memory[view.sysid] = fuzzy_escape.new_memory(1)[0]
        self._begin = {view.sysid: self._q[view.sysid] for view in views}
        self._pursuing, self._stations = request.pursuing, request.stations
        self._here = {view.sysid: view.p_now_ned() for view in snapshot.vehicles if view.p_ned is not None}
        movers = self._movers(snapshot)
        for role in ROLES:
            led = [view for view in views if view.role == role]
            if led:
                wanted = self._guided(led, self._wants(role, request, led))
                self._move(snapshot, movers, led, wanted, request.rendezvous, period_s)
        return [SetPoint(view.sysid, self._begin[view.sysid], self._v[view.sysid]) for view in views]

    def _guided(self, views: list[VehicleView], wanted: list[_Wanted]) -> list[_Wanted]:
        """Goals, none beyond the fence: as they are where the way is free, else the next place of a route around what
        is in it. A leader that is beyond the fence itself comes back straight."""
        if len(self._fence.walls):
            wanted = [self._fenced(want) for want in wanted]
        if self._guides is None:
            return wanted
        guide = self._guides[views[0].role]
        here = [self._q[view.sysid] for view in views]
        found = guide.aims([view.sysid for view in views], here, [want.p_ned for want in wanted])
        straight = (found.state == STRAIGHT) | ~self._fence.allows(np.array(here))
        guided = []
        for want, aim, left_m, free in zip(wanted, found.aim_ned, found.remaining_m, straight, strict=True):
            v_ned = want.v_ned if left_m < NEAR_GOAL_M else STILL
            guided.append(want if free else _Wanted(vec(aim), v_ned, want.speed_m_s, float(left_m)))
        return guided

    def _fenced(self, want: _Wanted) -> _Wanted:
        p_ned = self._fence.brought_inside(want.p_ned)
        return want if p_ned is want.p_ned else _Wanted(p_ned, STILL, want.speed_m_s)

    def anchor(self, sysid: int, p_ned: Vec3) -> None:
        """Go on from here: where the safety filter takes the leader of a vehicle to."""
        if sysid in self._q:
            self._q[sysid] = p_ned

    def _move(
        self,
        snapshot: FleetSnapshot,
        movers: _Movers,
        views: list[VehicleView],
        wanted: list[_Wanted],
        rendezvous: Mapping[int, int],
        period_s: float,
    ) -> None:
        """Move the leaders of these vehicles by one period."""
        rows = {view.sysid: i for i, view in enumerate(views)}
        owner = [rows.get(view.sysid, -1) for view in movers.views] + [-1] * len(snapshot.traffic)
        attractors, attraction_ranges, drawn = self._attractors(snapshot, views)
        q_next, memory, v_ned = leader.advance(
            np.array([self._q[view.sysid] for view in views]),
            np.array([self._memory[view.sysid] for view in views]),
            np.array([want.p_ned for want in wanted]),
            np.array([want.v_ned for want in wanted]),
            repulsors=self.obstacles,
            moving=movers.p_ned,
            radii_m=movers.radii_m,
            ranges_m=movers.ranges_m,
            owner=owner,
            exempt=self._exempt(snapshot, views, movers.views, rendezvous),
            field=self._field,
            speed_m_s=np.array([self._speed(view, want) for view, want in zip(views, wanted, strict=True)]),
            period_s=period_s,
            escape=self._rules.escape,
            attractors=attractors,
            attraction_ranges_m=attraction_ranges,
            drawn=drawn,
            # A route keeps its own distance from obstacles, in gaps less than their range.
            obstacle_ranges_m=[self._field.repulsion_range_m if want.route_m is None else 0.0 for want in wanted],
        )
        for view, q, way, remembered in zip(views, q_next.tolist(), v_ned.tolist(), memory, strict=True):
            v = way
            if view.sysid in self._grounded and q[2] > (lowest_d := floor_d(view)):
                q[2] = lowest_d
                v = [(end - begin) / period_s for end, begin in zip(q, self._begin[view.sysid], strict=True)]
            self._q[view.sysid], self._v[view.sysid] = (q[0], q[1], q[2]), (v[0], v[1], v[2])
            self._memory[view.sysid] = remembered

    def _forget(self, kept: set[int]) -> None:
        """A vehicle that is not steered any more starts from where it is, should it come back."""
        for sysid in self._q.keys() - kept:
            del self._q[sysid], self._v[sysid], self._memory[sysid]

    def _wants(self, role: str, request: PlanRequest, views: list[VehicleView]) -> list[_Wanted]:
        snapshot = request.snapshot
        wants: dict[int, _Wanted] = {}
        if role == "target":
            for target in self._scenario.vehicles.targets:
                wants[target.sysid] = self._carrot(target, request.targets_move, request.period_s)
        elif role == "pursuer":
            wants = self._formation(snapshot) | {sysid: self._course(sysid) for sysid in self._courses.keys() & self._q}
        else:
            for tanker in self._scenario.vehicles.tankers:
                wants[tanker.sysid] = self._station(tanker, snapshot, request.rendezvous.get(tanker.sysid))
        cruise_m_s = self._rules.cruise_m_s  # who holds may still give way
        wants |= {sysid: _Wanted(place, STILL, cruise_m_s) for sysid, place in self._stations.items()}
        return [wants.get(view.sysid) or _Wanted(self._q[view.sysid], STILL, cruise_m_s) for view in views]

    def _station(self, tanker: Tanker, snapshot: FleetSnapshot, receiver: int | None) -> _Wanted:
        """Above its receiver, or where it waits."""
        if receiver is None:
            n, e, d = tanker.start_m
            return _Wanted(tanker.home_m or (n, e, d - tanker.takeoff_m), STILL, tanker.speed_m_s)
        (n, e, d), v_ned = self._led(snapshot.vehicle(receiver))
        return _Wanted((n, e, d - self._scenario.refuelling.height_m), v_ned, tanker.speed_m_s)

    def _carrot(self, target: Target, moves: bool, period_s: float) -> _Wanted:
        path = self._paths[target.sysid]
        p_ned, direction = path.at(self._way_m[target.sysid])
        leader_at = self._q.get(target.sysid)
        arrived = leader_at is not None and math.dist(leader_at, p_ned) < self._rules.leash_m
        if not (moves and arrived):
            return _Wanted(p_ned, STILL, CATCH_UP_SPEED * target.speed_m_s)
        self._way_m[target.sysid] += target.speed_m_s * period_s
        v_ned = (direction[0] * target.speed_m_s, direction[1] * target.speed_m_s, direction[2] * target.speed_m_s)
        return _Wanted(p_ned, v_ned, CATCH_UP_SPEED * target.speed_m_s)

    def _course(self, sysid: int) -> _Wanted:
        """The next of a vehicle's own way points; at the last one it stays."""
        course, here = self._courses[sysid], self._q[sysid]
        last = 1 if self._rules.safety else 0  # who gives way at the last one comes back to it
        if len(course) > last and math.dist(here, course[0]) <= self._reached_m:
            course.pop(0)
        if not course:
            return _Wanted(here, STILL, 0.0)
        return _Wanted(course[0], STILL, self._rules.cruise_m_s)

    def _formation(self, snapshot: FleetSnapshot) -> dict[int, _Wanted]:
        """Each pursuer's slot around its target, assigned anew when the set of pursuers in the air changes.

        A target that is dead, silent, or not steered (it may be landing) leads no one: its pursuers hold.
        """
        rules, vehicles = self._scenario.formation, self._scenario.vehicles
        follows = self._followed if self._pursuing is None else self._pursuing
        wants = {}
        for target in vehicles.targets:
            lead = snapshot.vehicle(target.sysid)
            flying = {sysid: snapshot.vehicle(sysid) for sysid in follows if follows[sysid] == target.sysid}
            here = {sysid: self._here[sysid] for sysid, view in flying.items() if view.flying}
            if not here or not (lead.flying and lead.fresh and target.sysid in self._begin):
                continue
            centre, v_ned = self._led(lead)
            if self._slots_of.get(target.sysid) != frozenset(here):
                self._slots_of[target.sysid] = frozenset(here)
                offsets = formation.ring_offsets(len(here), rules.ring_m or 0.0, rules.height_m)
                for sysid, slot in formation.assign(here, offsets + np.array(centre)).items():
                    self._slots[sysid] = vec(offsets[slot])
            for sysid in here:
                offset = self._slots[sysid]
                goal = (centre[0] + offset[0], centre[1] + offset[1], centre[2] + offset[2])
                wants[sysid] = _Wanted(goal, v_ned, self._rules.cruise_m_s)
        return wants

    def _led(self, view: VehicleView) -> tuple[Vec3, Vec3]:
        """Place and velocity with which to keep formation: the leader's; else the vehicle's own, looked ahead."""
        flown = _ahead(self._here[view.sysid], view.v_ned)
        if view.sysid in self._begin and math.dist(self._begin[view.sysid], flown) <= OFF_PLAN_M:
            return self._begin[view.sysid], self._v[view.sysid]
        return flown, view.v_ned

    def _met(self, view: VehicleView) -> Vec3:
        """Place at which leaders meet a vehicle: where it flies, looked ahead; where its leader is if its link is slow.
        Who evades what another did a second ago, and is evaded likewise, sways with it for ever."""
        if self._rules.safety and view.fresh and self._slow.slow(view.sysid):
            return self._led(view)[0]
        return _ahead(self._here[view.sysid], view.v_ned)

    def _attractors(
        self, snapshot: FleetSnapshot, views: list[VehicleView]
    ) -> tuple[ArrayLike, ArrayLike, NDArray[np.bool_] | None]:
        """Places and ranges of what draws pursuers beside their goals, and whom each one draws."""
        if not (self._scenario.attractors or self._attracting):
            return (), (), None
        default_m = self._rules.attraction_range_m
        rows = [(*a.point_m, a.range_m or default_m) for a in self._scenario.attractors]
        for aircraft in snapshot.traffic:
            if aircraft.callsign in self._attracting:
                rows.append((*_ahead(aircraft.p_ned, aircraft.v_ned, LOOKAHEAD_S + aircraft.age_s), default_m))
        table = np.array(rows).reshape(-1, 4)
        pursuers = np.array([view.role == "pursuer" for view in views])
        return table[:, :3], table[:, 3], np.repeat(pursuers[:, np.newaxis], len(table), axis=1)

    def _movers(self, snapshot: FleetSnapshot) -> _Movers:
        """A vehicle is a sphere of the separation that the scenario demands: a leader pressed against it stays out.
        A target must not push its pursuers from their ring, so its sphere ends where the ring is out of its range.
        """
        views = [view for view in snapshot.vehicles if view.flying]
        at = [self._met(view) for view in views]
        speeds = [math.hypot(*view.v_ned) for view in views]
        ages = [view.age_s for view in views]
        aircraft_m = self._rules.separation_m if self._rules.safety else 0.0
        radii = [self._radii_m[view.role] for view in views] + [aircraft_m] * len(snapshot.traffic)
        for aircraft in snapshot.traffic:
            at.append(_ahead(aircraft.p_ned, aircraft.v_ned, LOOKAHEAD_S + aircraft.age_s))
            speeds.append(math.hypot(*aircraft.v_ned))
            ages.append(aircraft.age_s + self._scenario.clock.period_s)
        ranges = widened_range(self._field.repulsion_range_m, np.array(speeds), np.array(ages))
        if self._rules.safety:
            ranges = SAFE_RANGE_SHARE * ranges
        return _Movers(views, np.array(at).reshape(-1, 3), np.array(radii), ranges)

    def _radius_m(self, role: str) -> float:
        separation_m, ring_m = self._rules.separation_m, self._scenario.formation.ring_m
        if role != "target" or ring_m is None:
            return separation_m
        return min(max(ring_m - self._field.repulsion_range_m, 0.0), separation_m)

    def _exempt(
        self,
        snapshot: FleetSnapshot,
        views: list[VehicleView],
        others: list[VehicleView],
        rendezvous: Mapping[int, int],
    ) -> NDArray[np.bool_]:
        """Vehicles that each leader need not keep away from: partners of a transfer; whom it pursues; what attracts
        it."""
        pairs = tuple(rendezvous.items())
        rows_of = ([view.sysid for view in views], [other.sysid for other in others])
        asked = (*rows_of, [aircraft.callsign for aircraft in snapshot.traffic], pairs)
        known = self._exempted.get(views[0].role)
        if known is not None and known[0] == asked:
            return known[1]
        exempt = np.zeros((len(views), len(others) + len(snapshot.traffic)), dtype=bool)
        of_view, of_other = np.array([view.role for view in views]), np.array([other.role for other in others])
        flying = exempt[:, : len(others)]
        flying |= not self._rules.vehicles_repel
        flying |= np.outer(of_view == "target", of_other != "target")
        attracting = [aircraft.callsign in self._attracting for aircraft in snapshot.traffic]
        exempt[:, len(others) :] = np.outer(of_view == "pursuer", np.array(attracting, dtype=bool))
        if self._scenario.formation.ring_m is None:
            flying |= np.outer(of_view == "pursuer", of_other == "target")
        rows = {view.sysid: i for i, view in enumerate(views)}
        columns = {other.sysid: j for j, other in enumerate(others)}
        for a, b in pairs:
            for one, other in ((a, b), (b, a)):
                if one in rows and other in columns:
                    exempt[rows[one], columns[other]] = True
        self._exempted[views[0].role] = (asked, exempt)
        return exempt

    def _speed(self, view: VehicleView, want: _Wanted) -> float:
        """Leashed; and under the safety filter, whose leaders brake at a limit, no faster than they can still stop."""
        speed_m_s = self._leashed(view, want.speed_m_s)
        if not self._rules.safety:
            return speed_m_s
        way_m = math.dist(self._q[view.sysid], want.p_ned) if want.route_m is None else want.route_m
        if math.isinf(way_m):
            return 0.0 if want.route_m is not None else speed_m_s
        brake_m_s2 = BRAKE_SHARE * self._rules.acceleration_m_s2
        return min(speed_m_s, math.hypot(*want.v_ned) + math.sqrt(2.0 * brake_m_s2 * way_m))

    def _leashed(self, view: VehicleView, speed_m_s: float) -> float:
        """The leader waits for a vehicle that has fallen behind by more than its speed explains."""
        slack_m = self._rules.leash_m + LOOKAHEAD_S * speed_m_s
        behind_m = math.dist(self._q[view.sysid], self._here[view.sysid])
        return speed_m_s * min(max(2.0 * (1.0 - behind_m / slack_m), 0.0), 1.0)


def floor_d(view: VehicleView) -> float:
    """Greatest down of a leader: above the scenario's height 0 and above the vehicle's own ground, by its home."""
    ground_d = view.ground_down_m or 0.0
    return -FLOOR_M + (ground_d if ground_d < -GROUND_ROUNDING_M else 0.0)


def _ahead(p_ned: Vec3, v_ned: Vec3, time_s: float = LOOKAHEAD_S) -> Vec3:
    return (p_ned[0] + v_ned[0] * time_s, p_ned[1] + v_ned[1] * time_s, p_ned[2] + v_ned[2] * time_s)


def vec(row: NDArray[np.float64] | Mapping[int, float]) -> Vec3:
    """A row (3,) as plain numbers."""
    return (float(row[0]), float(row[1]), float(row[2]))
