"""Safety layer: any planner's set points, changed as little as keeps everyone apart
(docs/model/safety.md#safety-layer).

Each steered vehicle has a leader that obeys limits of speed and acceleration. The planner proposes where it goes, the
safety filter (safety_filter.py) has the last word, and the vehicle is sent the leader's place and mean velocity. Then
the planner goes on from where the leader is. Leaders of all roles are filtered together, so they give way to each
other; traffic, vehicles that are not steered and silent ones do not, and are looked at where they will be when the
vehicles have followed their leaders.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from statistics import median
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink.autopilots import STEERABLE, FlightMode
from gcs.mavlink.setpoints import SetPoint, SetPoints
from gcs.planner.failsafes import failsafes_of, foreign_returns_of
from gcs.planner.fence import FenceBorder
from gcs.planner.floors import FLOOR_M, Floors
from gcs.planner.foreign_returns import LEAST_HOLD_S
from gcs.planner.leader_limits import acceleration_m_s2, speeds_m_s
from gcs.planner.link_age import LinkAge
from gcs.planner.planner import LEAST_MARGIN_M, STILL
from gcs.planner.request import PlanRequest, TickPlanner
from gcs.planner.surroundings import LOOKAHEAD_S
from gcs.planner.tracking import Tracking
from gcs.scenario.accuracy import factor, spreads_m
from gcs.scenario.model import Scenario
from gcs.telemetry.accuracy import Spreads
from gcs.telemetry.columns import FleetColumns
from gcs.telemetry.state import Vec3, VehicleView
from skytender import elementary
from skytender.geometry import FloatArray
from skytender.safety.intruders import Intruder, table_of
from skytender.safety.safety_filter import KINDS, Filtered, FilterSettings, Leaders, filter_step
from skytender.safety.silence import BRAKES_M_S2, STEP_M, between, braked, presumed_places, stopping
from skytender.safety.traffic import TrafficReach

MOST_MARGIN_M = 1.5
SPARE_M = 0.05
"""Added to the measured error."""
OFF_LEADER_M = 2.0
"""A vehicle farther from its leader's way gets a new leader where it is."""
LATE_PERIODS = 3
"""[choice] A tick that stands for so many periods is late: what vehicles that live on the wall clock flew meanwhile is
where they say they are, and not where their leaders would be."""
STRAYS_M = 0.3
"""[choice] How far a vehicle on a mission may be from where its items lead it."""
CLAIM_EVERY = 2
"""Of the places of its claim one in so many is kept away from: they are STEP_M apart then, or less."""
SETTLE_S = 0.5
"""A leader that is not where a planner of a user's own wants it comes there in about so long."""
PARTNERS_SHARE = 0.5
"""Of the height in which a tanker stands: so near may partners of a transfer come."""
ACTS_M_S2, REPEAT_AFTER_S = 1.0, 2.0
"""A change of a wanted velocity by so much is an intervention to be recorded, once in so long for each vehicle and
cause."""
ANSWERED_S = 0.25
"""[choice] Offboard is asked for when set points have flowed for 0.2 s, and where nothing is lost the next report says
that they are followed: one that has been sent set points for longer without that may follow them or not."""
EVADES_M_S = 0.1
"""[choice] One of ours that flies by itself may evade others on board, and come back at any time: where it is faster,
others also keep apart from where it would come to rest."""


class SafePlanner(TickPlanner):
    """A planner whose set points pass the safety filter.

    Arrays have a row for each of the scenario's n vehicles, in order of system id, as `FleetColumns` has.
    """

    def __init__(self, scenario: Scenario, planner: TickPlanner) -> None:
        rules, vehicles = scenario.planner, scenario.vehicles
        self._scenario = scenario
        self._planner = planner
        self.obstacles = planner.obstacles
        every = vehicles.all
        self._row = {vehicle.sysid: row for row, vehicle in enumerate(every)}
        n = len(every)
        self._led = np.zeros(n, np.bool_)
        self._p_ned, self._v_ned = np.zeros((n, 3)), np.zeros((n, 3))
        """leaders' places, m, and velocities, m/s"""
        self._sysids: tuple[int, ...] = ()
        self._ids = self._rows = np.zeros(0, np.int64)
        """of those that have a leader"""
        self.tracking = Tracking(n, LOOKAHEAD_S)
        speeds = speeds_m_s(scenario)
        self._speed_m_s = np.array([speeds[v.sysid] for v in every])
        self._takeoff_m = [v.takeoff_m for v in every]
        self._a_max = np.array([acceleration_m_s2(scenario, v) for v in every])
        self._external = np.array([v.external is not None for v in every], np.bool_)
        self._spreads = Spreads([*spreads_m(scenario).values()], factor(scenario), self._a_max, self._external)
        self._spread_m = np.zeros(n)
        self._floors = Floors(self._row[v.sysid] for v in every if not v.airborne)
        launched = (v for v in every if not v.is_foreign)
        self._airborne = {v.sysid: v.start_m for v in launched if v.airborne and not v.join_s}
        self.lag_s = LOOKAHEAD_S
        """how far vehicles fly behind their leaders, usually"""
        holds_s = {sysid: one.holds_after_s for sysid, one in foreign_returns_of(scenario).items()}
        self._flies_on_s = np.array(
            [holds_s.get(v.sysid, LEAST_HOLD_S) + scenario.clock.period_s if v.external else 0.0 for v in every]
        )
        """how long each flies on by a set point that no further one follows"""
        self._late = False
        self._unsaid_s = np.zeros(n)
        """for how long each has been sent set points without having said that it follows them"""
        failsafes = failsafes_of(scenario)
        self._failsafes = {v.sysid: (v.start_m, failsafes[v.sysid]) for v in every if not v.is_foreign}
        self._link_age = LinkAge(n)
        self._fence = FenceBorder(scenario, rules.clearance_m)
        self._solid = np.concatenate([planner.obstacles, self._fence.walls])
        self._settings: FilterSettings | None = None
        self._traffic_reach = TrafficReach()
        """how fast each aircraft in sight may turn, by callsign"""
        self._attracting = {mover.callsign for mover in scenario.traffic if mover.attracts}
        self._reported_s: dict[tuple[int, str], float] = {}
        self._records: list[dict[str, Any]] = []

    def margin_m(self, sysid: int) -> float:
        """Margin added to the separation for a vehicle's tracking error."""
        error_m = float(self.tracking.error_m[self._row[sysid]])
        return min(max(error_m + SPARE_M, LEAST_MARGIN_M), MOST_MARGIN_M)

    def pop_records(self) -> list[dict[str, Any]]:
        """Interventions of the filter since the last call, as decisions."""
        taken, self._records = self._records, []
        return taken

    def anchor(self, sysids: Sequence[int], p_ned: FloatArray) -> None:
        """Same as the planner's."""
        self._planner.anchor(sysids, p_ned)

    def surround(self, scenario: Scenario) -> None:
        """As `TickPlanner.surround`. Vehicles' failsafes stay as they were launched."""
        self._planner.surround(scenario)
        self._scenario, self.obstacles = scenario, self._planner.obstacles
        self._solid = np.concatenate([self.obstacles, self._fence.walls])

    def plan(self, request: PlanRequest) -> Sequence[SetPoint]:
        """The planner's set points, filtered, as `SetPoints`."""
        snapshot, period_s = request.snapshot, request.period_s
        columns = snapshot.columns
        self._late = period_s > (LATE_PERIODS - 0.5) * self._scenario.clock.period_s
        self._link_age.receive(columns.age_s, period_s)
        self._spread_m = self._spreads.of(snapshot, late=self._late)
        self._follow(request, columns)
        if request.approaches and self._scenario.planner.vehicles_repel:
            request = request._replace(stand_off_m=self._stand_off_m(request))
        points = SetPoints.of(self._planner.plan(request))
        self._keep(points, columns)
        if not points.sysids:
            return points
        others = self._others(request, columns)
        rows = self._rows
        overrun_s = np.maximum(self._flies_on_s[rows] - self.tracking.lag_s[rows], 0.0)
        ahead_ned = overrun_s[:, np.newaxis] * self._v_ned[rows]
        filtered = self._filter(points, request, columns, others, ahead_ned, overrun_s)
        values = np.empty((len(rows), 6))
        values[:, :3], values[:, 3:] = self._p_ned[rows], self._v_ned[rows] + 0.5 * period_s * filtered.u_ned
        if self._late:  # flown on for as long as the next tick takes, too
            flown_on = self._external[rows]
            values[flown_on, 3:] = filtered.v_next_ned[flown_on]
        set_points = SetPoints(points.sysids, values)
        p_next_ned = filtered.p_next_ned - ahead_ned
        self._p_ned[rows], self._v_ned[rows] = p_next_ned, filtered.v_next_ned
        self.tracking.lead(rows, snapshot.time_s + period_s, p_next_ned)
        self._planner.anchor(points.sysids, p_next_ned)
        self._record(points.sysids, filtered, snapshot.time_s, others)
        return set_points

    def _follow(self, request: PlanRequest, columns: FleetColumns) -> None:
        """Measure each vehicle against its leader; one that is far off, or follows none, gets one where it is."""
        rows, tracking = self._rows, self.tracking
        if not len(rows):
            self.lag_s = LOOKAHEAD_S
            return
        known = ~(self._link_age.silent | np.isnan(columns.p_now_ned[:, 0]))
        unsaid = self._led & ~columns.steerable & ~self._external
        self._unsaid_s = np.where(unsaid, self._unsaid_s + request.period_s, 0.0)
        following = rows[(known & columns.steerable)[rows]]
        tracking.measure(following, columns.p_now_ned[following], request.snapshot.time_s, request.period_s, self.lag_s)
        lost = known & (~columns.steerable | (tracking.now_m > OFF_LEADER_M) | (self._external & self._late))
        for row in np.flatnonzero(lost & self._doubtful).tolist():
            ahead_ned = columns.p_now_ned[row] + self.lag_s * columns.v_ned[row]
            lost[row] = elementary.distance(ahead_ned.tolist(), self._p_ned[row].tolist()) > OFF_LEADER_M
        for row in rows[lost[rows]].tolist():
            v_ned = self._within_speed(row, columns.v_ned[row])
            if self._external[row]:  # it brakes, or has to: it is led on from where it comes to rest
                self._p_ned[row] = columns.p_now_ned[row] + v_ned * elementary.norm(v_ned.tolist()) / (
                    2.0 * BRAKES_M_S2
                )
                self._v_ned[row] = 0.0
            else:
                self._p_ned[row], self._v_ned[row] = columns.p_now_ned[row] + self.lag_s * v_ned, v_ned
            tracking.restart(row)
            self._planner.anchor((columns.sysids[row],), self._p_ned[row : row + 1])
        self.lag_s = max(median(tracking.lag_s[rows].tolist()), LOOKAHEAD_S)

    @property
    def _doubtful(self) -> NDArray[np.bool_]:
        """(n,) of which it is not known whether they follow the set points that they are sent.

        Their leaders brake, and are not put back to where the vehicles are in every period, which would undo that: one
        that follows comes to rest as one does that holds.
        """
        return self._unsaid_s > ANSWERED_S

    def _keep(self, points: SetPoints, columns: FleetColumns) -> None:
        """A leader for each set point."""
        if points.sysids == self._sysids:
            return
        self._sysids = points.sysids
        self._ids = np.array(points.sysids, np.int64)
        self._rows = np.array([self._row[sysid] for sysid in points.sysids], np.int64)
        kept = np.zeros(len(self._led), np.bool_)
        kept[self._rows] = True
        for row in np.flatnonzero(self._led & ~kept).tolist():
            self.tracking.restart(row)
        for row, p_ned in zip(self._rows.tolist(), points.p_ned, strict=True):
            if not self._led[row]:
                self._p_ned[row] = p_ned
                self._v_ned[row] = self._within_speed(row, columns.v_ned[row])
        self._led = kept

    def _within_speed(self, row: int, v_ned: FloatArray) -> FloatArray:
        return v_ned * min(1.0, float(self._speed_m_s[row]) / max(elementary.norm(v_ned.tolist()), 1e-9))

    def _filter(
        self,
        points: SetPoints,
        request: PlanRequest,
        columns: FleetColumns,
        others: list[Intruder],
        ahead_ned: FloatArray,
        overrun_s: FloatArray,
    ) -> Filtered:
        """Accelerations of the leaders.

        The station may be stopped at any tick. Vehicles in lockstep wait for it; external ones fly on by this set
        point, `ahead_ned` beyond their leaders by the time that they brake, and are filtered there.
        """
        rules, rows = self._scenario.planner, self._rows
        p = self._p_ned[rows]
        wanted_ned = points.v_ned + (points.p_ned - p) / SETTLE_S
        wanted_ned[(self._link_age.silent | self._doubtful)[rows] | self._late] = 0.0
        floor = np.full((len(rows), 3), np.inf)
        floor[:, 2] = self._floors.at(columns.ground_down_m)[rows]
        margin_m = np.minimum(np.maximum(self.tracking.error_m[rows] + SPARE_M, LEAST_MARGIN_M), MOST_MARGIN_M)
        margin_m += overrun_s * request.period_s * self._a_max[rows]  # what this period adds to `ahead_ned`
        return filter_step(
            Leaders(
                ids=self._ids,
                p_ned=p + ahead_ned,
                v_ned=self._v_ned[rows],
                v_max_m_s=self._speed_m_s[rows],
                a_max_m_s2=self._a_max[rows],
                margin_m=margin_m,
                spread_m=self._spread_m[rows],
                high_ned=floor,
            ),
            wanted_ned,
            rules=self._settings_for(request.period_s),
            others=table_of(others),
            obstacles=self._solid,
            beyond=~self._fence.allows(p),
            pair_required_m=self._partners(request),
            other_required_m=[(other.owner, row, 0.0) for row, other in enumerate(others) if other.owner is not None],
            apart=rules.vehicles_repel,
        )

    def _settings_for(self, period_s: float) -> FilterSettings:
        if self._settings is None or self._settings.period_s != period_s:
            rules = self._scenario.planner
            self._settings = FilterSettings(period_s, rules.separation_m, rules.clearance_m)
        return self._settings

    def _partners(self, request: PlanRequest) -> list[tuple[int, int, float]]:
        """Least distance of partners of a transfer, by pair."""
        near_m = PARTNERS_SHARE * self._scenario.refuelling.height_m
        pairs = [pair for pair in request.rendezvous.items() if pair[0] not in request.approaches]
        return [(a, b, min(near_m, self._apart_m(a, b))) for a, b in pairs]

    def _stand_off_m(self, request: PlanRequest) -> dict[int, float]:
        """How far above its receiver a tanker stands that is not to serve it yet, by tanker."""
        height_m, rendezvous = self._scenario.refuelling.height_m, request.rendezvous
        return {tanker: max(height_m, self._apart_m(tanker, rendezvous[tanker])) for tanker in request.approaches}

    def _apart_m(self, one: int, other: int) -> float:
        """Distance that the filter keeps between two vehicles."""
        return self._scenario.planner.separation_m + self.margin_m(one) + self.margin_m(other)

    def _others(self, request: PlanRequest, columns: FleetColumns) -> list[Intruder]:
        """Vehicles that give no way, where they will be when vehicles fly where their leaders are now."""
        rules, others = self._scenario.planner, []
        for row in self._unled(columns) if rules.vehicles_repel else ():
            view = request.snapshot.vehicle(columns.sysids[row])
            place = self._place(view)
            if place is None:
                continue
            silent, radius_m = bool(self._link_age.silent[row]), self._radius_m(row, view.sysid)
            name, owner = f"vehicle {view.sysid}", view.sysid if self._led[row] else None
            age_s = min(view.age_s, request.snapshot.time_s)
            home, failsafe = self._failsafes.get(view.sysid, (STILL, None))
            states, lead_s = [(place, view.v_ned)], self.lag_s
            if silent and failsafe and view.p_ned is not None and view.mode in STEERABLE:
                states, lead_s = stopping(view.p_ned, view.v_ned, age_s, self.lag_s, failsafe), 0.0
            for p, v in states[:-1]:
                others.append(Intruder.of(name, owner, p, v, 0.0, radius_m + 0.5 * STEP_M, 0.0))
            place, v_ned = states[-1]
            others.append(Intruder.of(name, owner, place, v_ned, lead_s, radius_m, age_s))
            if failsafe and not silent and view.mode not in STEERABLE and elementary.norm(v_ned) > EVADES_M_S:
                rest_ned, _ = braked(place, v_ned, math.inf)
                others.append(Intruder.of(name, owner, rest_ned, STILL, 0.0, radius_m, age_s))
            if silent and failsafe:
                wide_m = radius_m + elementary.hypot(0.5 * STEP_M, STEP_M if len(states) > 1 else 0.0)
                for presumed in (one for p, _ in states[::-2] for one in presumed_places(p, home, age_s, failsafe)):
                    others.append(Intruder.of(name, owner, presumed, STILL, 0.0, wide_m, 0.0))
        others += self._climbs(request, columns) if rules.vehicles_repel else ()
        for sysid, places in request.claims.items():
            strays_m = rules.separation_m + STRAYS_M + float(self._spread_m[self._row[sysid]]) + 0.5 * STEP_M
            owner = sysid if self._led[self._row[sysid]] else None
            for claimed in places[::CLAIM_EVERY]:
                others.append(Intruder.of(f"vehicle {sysid}", owner, claimed, STILL, 0.0, strays_m, 0.0))
        traffic = request.snapshot.traffic
        return others + self._traffic_reach.intruders(traffic, self.lag_s, rules.separation_m, self._attracting)

    def _radius_m(self, row: int, sysid: int) -> float:
        return self._scenario.planner.separation_m + self.margin_m(sysid) + float(self._spread_m[row])

    def _climbs(self, request: PlanRequest, columns: FleetColumns) -> list[Intruder]:
        """Ways up of vehicles that take off, or are about to: their velocities do not show them in time."""
        found = []
        for row in np.flatnonzero(columns.alive & ~self._led).tolist():
            view = request.snapshot.vehicle(columns.sysids[row])
            if view.p_ned is None or not (view.sysid in request.takes_off or view.mode is FlightMode.TAKEOFF):
                continue
            here_ned = view.p_now_ned()
            top_ned = (here_ned[0], here_ned[1], float(columns.ground_down_m[row]) - self._takeoff_m[row])
            wide_m = elementary.hypot(self._radius_m(row, view.sysid), 0.5 * STEP_M)
            if top_ned[2] < here_ned[2]:
                for place, _ in [*between((here_ned, STILL), (top_ned, STILL)), (top_ned, STILL)]:
                    found.append(Intruder.of(f"vehicle {view.sysid}", None, place, STILL, 0.0, wide_m, 0.0))
        return found

    def _unled(self, columns: FleetColumns) -> list[int]:
        """Rows of the live vehicles that may fly without following a leader.

        A vehicle is left out if it certainly follows its leader, or certainly stands on the ground.
        """
        unled = ~(self._led & columns.steerable & ~self._link_age.silent) & columns.alive
        if not unled.any():
            return []
        down = ~columns.flying & (columns.ground_down_m - columns.p_ned[:, 2] <= FLOOR_M)
        return np.flatnonzero(unled & ~down).tolist()

    def _place(self, view: VehicleView) -> Vec3 | None:
        """Place of a vehicle that is not on the ground, whether or not its arming has been reported; None on the
        ground.

        Launched vehicles have the scenario's origin and start, so that their place is known before they report it.
        """
        if not view.alive:
            return None
        if view.p_ned is not None:
            in_the_air = view.flying or view.height_m is None or view.height_m > FLOOR_M
            return view.p_now_ned() if in_the_air else None
        start = self._airborne.get(view.sysid)
        return None if start is None else view.p_local_ned or start

    def _record(self, sysids: Sequence[int], filtered: Filtered, now_s: float, others: list[Intruder]) -> None:
        for row in np.flatnonzero(filtered.changed_m_s2 > ACTS_M_S2).tolist():
            sysid = sysids[row]
            by = self._named(int(filtered.binding_kind[row]), int(filtered.binding[row]), sysids, others)
            if now_s < self._reported_s.get((sysid, by), -math.inf) + REPEAT_AFTER_S:
                continue
            self._reported_s[sysid, by] = now_s
            change = round(float(filtered.changed_m_s2[row]), 3)
            braked = bool(filtered.checked[row] == 3)
            self._records.append(
                {"t_s": now_s, "kind": "safety", "sysid": sysid, "by": by, "change_m_s2": change, "braked": braked}
            )

    def _named(self, kind: int, index: int, sysids: Sequence[int], others: list[Intruder]) -> str:
        """Constraint that bound the filter, for a person."""
        if KINDS[kind] == "vehicle":
            return f"vehicle {sysids[index]}"
        if KINDS[kind] in ("other", "reach"):
            return others[index].name
        if KINDS[kind] == "obstacle":
            if index >= len(self._scenario.obstacles):
                return "fence"
            obstacle = self._scenario.obstacles[index]
            return f"obstacle {obstacle.name or f'{obstacle.kind} {index + 1}'}"
        return "ground" if KINDS[kind] == "wall" else "limits"
