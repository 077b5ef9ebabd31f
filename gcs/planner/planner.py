"""One tick of planning: from the fleet's snapshot to a set point for every vehicle that is being steered.

Each vehicle has a virtual leader (docs/model/planner.md#planned-point). Targets' leaders follow a carrot along the
scenario's path, pursuers' their slot of the formation or their own way points, tankers' the place above their receiver
or where they wait. A vehicle flies LOOKAHEAD_S behind its leader (docs/model/control.md#guidance: 0.32 s of guidance,
and half a grant). So leaders keep formation with leaders, and everything else that moves is looked at where it will be
by then. Targets are planned first, then pursuers, then tankers, so that each follows what the one before it does in
this very period.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gcs.mavlink.setpoints import SetPoint, SetPoints
from gcs.planner import fuzzy_escape, goals, leader
from gcs.planner.fence import FenceBorder
from gcs.planner.floors import FLOOR_M, Floors
from gcs.planner.guide import STRAIGHT, RouteFollower
from gcs.planner.leader_limits import CATCH_UP_SPEED
from gcs.planner.link_age import SlowLinks
from gcs.planner.neighbours import IntArray
from gcs.planner.potential_field import FieldConstants
from gcs.planner.request import PlanRequest, TickPlanner
from gcs.planner.route import Router
from gcs.planner.surroundings import LOOKAHEAD_S, NOTHING_MOVES, LeaderSurroundings, LedPart, Team, ahead
from gcs.scenario.accuracy import widest_m
from gcs.scenario.model import Scenario, Target
from gcs.telemetry.columns import FleetColumns
from gcs.telemetry.state import Vec3
from skytender import elementary, geometry
from skytender.geometry import COLUMNS, FloatArray

LEAST_MARGIN_M = 0.1
"""Of every vehicle: so much farther than its clearance the safety filter keeps it from obstacles."""
BRAKE_SHARE = 0.4
"""Of the acceleration of leaders, with which they are to stop at their goals; the rest is for giving way."""
ROLES = ("target", "pursuer", "tanker")
NEAR_GOAL_M = 2.0
"""A route shorter than this is flown with the velocity of its goal."""
OFF_PLAN_M = 1.0
"""A vehicle farther than this from its plan is met where it flies, not where it is planned."""
STILL: Vec3 = (0.0, 0.0, 0.0)


class _Followers(NamedTuple):
    """Pursuers in the air that follow one target."""

    target: int
    sysids: frozenset[int]
    rows: IntArray
    """of those without way points of their own, to which all others keep"""


_NO_SET_POINTS = SetPoints((), np.zeros((0, 6)))


class Planner(TickPlanner):
    """The leaders of all steered vehicles; `plan` moves them by one period, or takes them to set points that are given.

    Arrays have a row for each of the scenario's n vehicles, in order of system id, as `FleetColumns` has.
    """

    def __init__(self, scenario: Scenario) -> None:
        rules, vehicles = scenario.planner, scenario.vehicles
        self._scenario, self._rules = scenario, rules
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
        self._sysids: Sequence[int] = [vehicle.sysid for vehicle in vehicles.all]
        self._row = {sysid: row for row, sysid in enumerate(self._sysids)}
        n = len(self._row)
        self._leaders = leader.LeaderRows(n, rules.repulsion_range_m, fuzzy_escape.new_memory(n))
        self._led = np.zeros(n, np.bool_)
        self._here = np.zeros((n, 3))
        """where vehicles are now; NaN where that is unknown"""
        self._paths = {
            target.sysid: goals.ConstantSpeedPath(target.path_m, closed=target.closed, laps=target.laps)
            for target in vehicles.targets
        }
        self._targets = {target.sysid: target for target in vehicles.targets}
        self._followed = vehicles.followed
        self._way_m = dict.fromkeys(self._paths, 0.0)
        self._slow = SlowLinks(n)
        reached_m = self._field.step_m
        if rules.safety:  # a leader with an inertia passes by within a period's way
            reached_m = max(reached_m, rules.cruise_m_s * scenario.clock.period_s)
        courses = {self._row[p.sysid]: p.waypoints_m for p in vehicles.pursuers if p.waypoints_m}
        # A vehicle that gave way at the last way point comes back to it.
        self._courses = goals.Courses(n, courses, reached_m, keeps_last=rules.safety)
        self._course, self._going = np.zeros(n, np.int64), self._courses.rows
        """how each of those led stands to its way points; and the rows of those that may come to one"""
        self._starts = {self._row[p.sysid]: p.start_m for p in vehicles.pursuers if p.waypoints_m and p.airborne}
        self._waits_ned, self._tanker_m_s = np.zeros((n, 3)), np.zeros(n)
        for tanker in vehicles.tankers:
            (north, east, down), row = tanker.start_m, self._row[tanker.sysid]
            self._waits_ned[row] = tanker.home_m or (north, east, down - tanker.takeoff_m)
            self._tanker_m_s[row] = tanker.speed_m_s
        self._around = LeaderSurroundings(scenario)
        self._floors = Floors(self._row[v.sysid] for v in vehicles.all if not v.airborne)
        brake_m_s2 = BRAKE_SHARE * rules.acceleration_m_s2 if rules.safety else math.inf
        self._limits = leader.SpeedLimits(rules.leash_m, LOOKAHEAD_S, brake_m_s2)
        self._guides: dict[str, RouteFollower] | None = None
        self._clearance_m = 2.0 * (rules.clearance_m + LEAST_MARGIN_M + widest_m(scenario)[1])
        """of routes"""
        self._fence = FenceBorder(scenario, self._clearance_m)
        if (router := self._router()) is not None:
            router.prepare()
        self._slots = np.zeros((n, 3))
        self._slots_of: dict[int, frozenset[int]] = {}
        self._followers: tuple[Team, Mapping[int, int], list[_Followers]] | None = None
        none = np.zeros(0, np.int64)
        self._team = Team((frozenset(), b"", b""), none, (), [], none, (), np.zeros((0, COLUMNS)))
        self._number = -1
        self._steered: frozenset[int] = frozenset()
        """with which the led vehicles were last determined"""

    def plan(self, request: PlanRequest) -> Sequence[SetPoint]:
        """`SetPoints` for the steered vehicles; each holds at the snapshot's time.

        ValueError where the snapshot's vehicles are not the scenario's.
        """
        columns, period_s = request.snapshot.columns, request.period_s
        here = self._here = columns.p_now_ned
        if request.steered != self._steered or columns.changed_since(self._number):
            self._look_who_is_led(request.steered, columns)
        if self._rules.safety:
            self._slow.receive(columns.age_s, period_s)
        team, leaders = self._team, self._leaders
        if not team.sysids:
            return _NO_SET_POINTS
        np.copyto(leaders.begin_ned, leaders.q_ned)
        movers: tuple[FloatArray, FloatArray] | None = None
        for part in team.parts:
            self._aim(part, request)
            if self._guides is not None or len(self._fence.walls):
                self._guide(part)
            moving = NOTHING_MOVES
            exempt, everyone = self._around.exempt(part, team, request.snapshot, request.rendezvous)
            if not everyone:
                movers = movers or self._around.movers(request.snapshot, team, self._met_at(columns))
                moving = leader.Moving(*movers, exempt)
            around = (self.obstacles, moving, self._around.attractors(request.snapshot, part), self._field, period_s)
            leader.lead(leaders, part.rows, here, self._limits, *around, escape=self._rules.escape)
            if request.given:
                self._take(part, request.given, period_s)
        values = leaders.begin_and_v
        return SetPoints(team.sysids, values.copy() if len(team.rows) == len(values) else values[team.rows])

    def _router(self) -> Router | None:
        """Routes around what stands, from now on those of all roles; None where nothing is to be flown around."""
        rules, solid = self._rules, np.concatenate([self.obstacles, self._fence.walls])
        self._guides = None
        if not (rules.safety and rules.guide and len(solid)):
            return None
        router = Router(solid, self._clearance_m, floor_m=FLOOR_M if len(self._floors.rows) else None)
        self._guides = {role: RouteFollower(router) for role in ROLES}
        return router

    def surround(self, scenario: Scenario) -> None:
        """As `TickPlanner.surround`. A target that is given another path begins it at its first corner."""
        before, self._scenario, self._around.scenario = self._scenario, scenario, scenario
        if scenario.obstacles != before.obstacles:
            self.obstacles = geometry.of_scenario(scenario.obstacles)
            if self._router() is None:
                self._leaders.route_m.fill(math.nan)
                self._leaders.obstacle_range_m.fill(self._field.repulsion_range_m)
        for target in scenario.vehicles.targets:
            if target != self._targets[target.sysid]:
                self._targets[target.sysid] = target
                path = goals.ConstantSpeedPath(target.path_m, closed=target.closed, laps=target.laps)
                self._paths[target.sysid], self._way_m[target.sysid] = path, 0.0

    def _look_who_is_led(self, steered: frozenset[int], columns: FleetColumns) -> None:
        """And where their grounds are."""
        if columns.sysids is not self._sysids:
            if tuple(columns.sysids) != tuple(self._sysids):
                raise ValueError(f"the snapshot is of vehicles {list(columns.sysids)}, not {list(self._sysids)}")
            self._sysids = columns.sysids
        key = (steered, np.isnan(self._here[:, 0]).tobytes(), columns.flying.tobytes())
        if key != self._team.key:
            self._team = self._regrouped(key, columns)
        np.copyto(self._leaders.lowest_d, self._floors.at(columns.ground_down_m))
        self._number, self._steered = columns.number, steered

    def _regrouped(self, key: tuple[frozenset[int], bytes, bytes], columns: FleetColumns) -> Team:
        """Those steered whose place is known, and the others. A vehicle that is not steered any more starts from where
        it is, should it come back."""
        steered, leaders = key[0], self._leaders
        led = np.array([sysid in steered for sysid in self._sysids], np.bool_) & ~np.isnan(self._here[:, 0])
        for row in np.flatnonzero(led & ~self._led).tolist():
            leaders.q_ned[row] = self._starts.pop(row, self._here[row])
            leaders.v_ned[row] = 0.0
            leaders.memory[row] = fuzzy_escape.new_memory(1)[0]
        self._led = led
        self._choose_courses()
        rows, flying = np.flatnonzero(led), np.flatnonzero(columns.flying)
        parts = []
        for role in ROLES:
            of_role = np.flatnonzero(led & (self._around.roles == role))
            if len(of_role):
                parts.append(LedPart(role, of_role, self._named(of_role)))
        spheres = self._around.spheres(flying)
        return Team(key, rows, self._named(rows), parts, flying, self._named(flying), spheres)

    def _named(self, rows: IntArray) -> tuple[int, ...]:
        return tuple([self._sysids[row] for row in rows.tolist()])

    def _choose_courses(self) -> None:
        courses = self._courses
        led = [row for row in courses.rows.tolist() if self._led[row]]
        self._going = np.array([row for row in led if courses.goes_on(row)], np.int64)
        self._course.fill(leader.HOLDS)
        self._course[led] = [
            leader.ARRIVED if courses.ended[row] else leader.GOES_ON if courses.goes_on(row) else leader.STAYS
            for row in led
        ]

    def anchor(self, sysids: Sequence[int], p_ned: FloatArray) -> None:
        """Go on from here: where the safety filter takes the leaders of these vehicles to."""
        if sysids is self._team.sysids:
            self._leaders.q_ned[self._team.rows] = p_ned
            return
        for sysid, place in zip(sysids, p_ned, strict=True):
            if self._led[row := self._row[sysid]]:
                self._leaders.q_ned[row] = place

    def _take(self, part: LedPart, given: Mapping[int, tuple[Vec3, Vec3]], period_s: float) -> None:
        """Let leaders of a role be where a program wants them; the leaders of the next roles follow them there."""
        leaders = self._leaders
        rows = [row for row, sysid in zip(part.rows.tolist(), part.sysids, strict=True) if sysid in given]
        if not rows:
            return
        values = np.array([given[self._sysids[row]] for row in rows], np.float64)
        p_ned, v_ned = values[:, 0], values[:, 1]
        leaders.begin_ned[rows], leaders.v_ned[rows], leaders.q_ned[rows] = p_ned, v_ned, p_ned + period_s * v_ned

    # goals

    def _aim(self, part: LedPart, request: PlanRequest) -> None:
        """Goals of the leaders of a role, the goals' velocities, and the leaders' speeds."""
        leaders, rows = self._leaders, part.rows
        if part.role == "pursuer":
            self._follow_courses()
            if self._targets:
                self._keep_formation(request.snapshot.columns, request.pursuing)
        else:
            leaders.goal_v_ned.fill(0.0)
            leaders.speed_m_s.fill(self._rules.cruise_m_s)
        if part.role == "target":
            for sysid, row in zip(part.sysids, rows.tolist(), strict=True):
                self._follow_path(self._targets[sysid], row, moves=request.targets_move, period_s=request.period_s)
        elif part.role == "tanker":
            leaders.goal_ned[rows], leaders.speed_m_s[rows] = self._waits_ned[rows], self._tanker_m_s[rows]
            height_m = self._scenario.refuelling.height_m
            for tanker, receiver in request.rendezvous.items():
                if tanker in self._row and self._led[row := self._row[tanker]]:
                    (north, east, down), v_ned = self._formed_on(self._row[receiver], request.snapshot.columns)
                    leaders.goal_ned[row] = (north, east, down - request.stand_off_m.get(tanker, height_m))
                    leaders.goal_v_ned[row] = v_ned
        for sysid, place in request.stations.items():
            row = self._row[sysid]
            leaders.goal_ned[row], leaders.goal_v_ned[row] = place, 0.0
            leaders.speed_m_s[row] = self._rules.cruise_m_s

    def _follow_path(self, target: Target, row: int, *, moves: bool, period_s: float) -> None:
        leaders, path = self._leaders, self._paths[target.sysid]
        p_ned, direction = path.at(self._way_m[target.sysid])
        leaders.goal_ned[row], leaders.speed_m_s[row] = p_ned, CATCH_UP_SPEED * target.speed_m_s
        arrived = elementary.distance(leaders.q_ned[row].tolist(), p_ned) < self._rules.leash_m
        if moves and arrived:
            self._way_m[target.sysid] += target.speed_m_s * period_s
            leaders.goal_v_ned[row] = [component * target.speed_m_s for component in direction]

    def _follow_courses(self) -> None:
        """The next of a vehicle's own way points, and at the last one it stays; the others hold, and may still give
        way."""
        leaders, courses, cruise_m_s = self._leaders, self._courses, self._rules.cruise_m_s
        arguments = leaders.table, self._course, courses.goal_ned, cruise_m_s, courses.reached_m
        if leader.aim(*arguments) and courses.go_on(self._going, leaders.q_ned):
            self._choose_courses()
            leader.aim(*arguments)

    def _keep_formation(self, columns: FleetColumns, pursuing: Mapping[int, int] | None) -> None:
        """Each pursuer's slot around its target, assigned anew when the set of pursuers in the air changes.

        A target that is dead, silent, or not steered (it may be landing) leads no one: its pursuers hold.
        """
        leaders, rules = self._leaders, self._scenario.formation
        for followers in self._grouped(self._followed if pursuing is None else pursuing):
            row = self._row[followers.target]
            if not (columns.flying[row] and columns.fresh[row] and self._led[row]):
                continue
            centre, v_ned = self._formed_on(row, columns)
            if self._slots_of.get(followers.target) != followers.sysids:
                self._slots_of[followers.target] = followers.sysids
                offsets = goals.ring_offsets(len(followers.sysids), rules.ring_m or 0.0, rules.height_m)
                here = {sysid: vec(self._here[self._row[sysid]]) for sysid in followers.sysids}
                for sysid, slot in goals.assign(here, offsets + np.array(centre)).items():
                    self._slots[self._row[sysid]] = offsets[slot]
            leaders.goal_ned[followers.rows] = self._slots[followers.rows] + centre
            leaders.goal_v_ned[followers.rows] = v_ned

    def _grouped(self, follows: Mapping[int, int]) -> list[_Followers]:
        """Pursuers in the air, by the target that they follow."""
        known = self._followers
        if known is not None and known[0] is self._team and known[1] == follows:
            return known[2]
        flying, own_way, groups = set(self._team.flying.tolist()), set(self._courses.rows.tolist()), []
        for target in self._targets:
            sysids = sorted(one for one, followed in follows.items() if followed == target and self._row[one] in flying)
            if sysids:
                rows = np.array([row for row in map(self._row.__getitem__, sysids) if row not in own_way], np.int64)
                groups.append(_Followers(target, frozenset(sysids), rows))
        self._followers = (self._team, dict(follows), groups)
        return groups

    def _formed_on(self, row: int, columns: FleetColumns) -> tuple[Vec3, Vec3]:
        """Place and velocity with which to keep formation: the leader's; else the vehicle's own, looked ahead."""
        v_ned = vec(columns.v_ned[row])
        flown = ahead(vec(self._here[row]), v_ned)
        begin = vec(self._leaders.begin_ned[row])
        if self._led[row] and elementary.distance(begin, flown) <= OFF_PLAN_M:
            return begin, vec(self._leaders.v_ned[row])
        return flown, v_ned

    def _met_at(self, columns: FleetColumns) -> FloatArray:
        """(k, 3) where leaders meet the vehicles in the air, m: where a vehicle flies, looked ahead.

        Where the link of a vehicle is slow, its leader's place counts instead: vehicles that evade what another did a
        second ago, and are evaded likewise, would sway with it for ever.
        """
        flying = self._team.flying
        at_ned: FloatArray = self._here[flying] + columns.v_ned[flying] * LOOKAHEAD_S
        if self._rules.safety:
            for k in np.flatnonzero((self._slow.slow() & columns.fresh)[flying]).tolist():
                at_ned[k] = self._formed_on(int(flying[k]), columns)[0]
        return at_ned

    def _guide(self, part: LedPart) -> None:
        """No goal beyond the fence; goals as they are where the way is free, else the next place of a route around
        what is in it. A leader that is beyond the fence itself comes back straight."""
        leaders, rows = self._leaders, part.rows
        wanted_ned = leaders.goal_ned[rows]
        if len(self._fence.walls):
            for k in np.flatnonzero(~self._fence.allows(wanted_ned)).tolist():
                wanted_ned[k] = self._fence.brought_inside(vec(wanted_ned[k]))
                leaders.goal_ned[rows[k]], leaders.goal_v_ned[rows[k]] = wanted_ned[k], 0.0
        if self._guides is None:
            return
        here = leaders.q_ned[rows]
        found = self._guides[part.role].aims(part.sysids, here, wanted_ned)
        straight = found.state == STRAIGHT
        if len(self._fence.walls):
            straight |= ~self._fence.allows(here)
        leaders.route_m[rows], leaders.obstacle_range_m[rows] = math.nan, self._field.repulsion_range_m
        if straight.all():
            return
        routed = rows[~straight]
        left_m = found.remaining_m[~straight]
        leaders.goal_ned[routed], leaders.route_m[routed] = found.aim_ned[~straight], left_m
        leaders.goal_v_ned[routed[left_m >= NEAR_GOAL_M]] = 0.0
        # A route keeps its own distance from obstacles, in gaps less than their range.
        leaders.obstacle_range_m[routed] = 0.0


def vec(row: FloatArray) -> Vec3:
    """A row (3,) as plain numbers."""
    n, e, d = row.tolist()
    return n, e, d
