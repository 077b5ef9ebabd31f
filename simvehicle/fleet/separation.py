"""Separation on board: a vehicle that flies by itself keeps apart from the peers that it receives
(docs/protocol/onboard.md#separation-on-board).

The station's safety filter has seen to it that vehicles stay apart if all brake. So a vehicle whose set point stays
away brakes at once, as that filter has presumed, and has a virtual leader of its own from then on. In every mode that
flies by itself the leader goes where the mode wants, and passes the same filter (skytender/safety) together with the
leaders that peers report: vehicles that receive each other filter the same numbers, and so choose the same ways. Peers
of which only the place is known give no way.

NED, SI units; times are the vehicle's own, which launched vehicles share with their session.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from simvehicle.autopilot.maneuvers import AT_REST, ManeuverTarget
from simvehicle.autopilot.modes import STEERED, Mode
from simvehicle.autopilot.parameters import float32
from simvehicle.autopilot.vectors import Vec3
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.peer_table import PeerTable
from simvehicle.fleet.separation_rules import SeparationRules
from simvehicle.fleet.spare_distance import braked, sure_acceleration
from skytender import elementary
from skytender.safety.braking_clearance import braking, stop_way
from skytender.safety.intruders import Intruder, table_of
from skytender.safety.safety_filter import BRAKE_SHARE, FilterSettings, Leaders, filter_step
from skytender.safety.silence import AHEAD_S, OVER_HOME_M, STEP_M, nearest_rest, stretch, tube, way_home
from skytender.safety.traffic import KnownTraffic, TrafficReach

LAG_S = 0.37
"""A vehicle flies so long behind its leader (docs/model/control.md#guidance)."""
ALONE_S = 2.0
"""Without a HEARTBEAT of the station for so long, every vehicle in the air has a leader, so that all know each
other's."""
PREDICTED_S = 0.35
"""A leader whose report is missing for less than this has gone on as this vehicle's own filter found."""
SILENT_S, FORGOTTEN_S = 1.0, 10.0
"""[choice] A peer of which nothing has come for so long is silent; while the station leads it, it is no longer where it
was after the second time."""
PARTED_S = 0.5
"""[choice] The same while the station is silent too."""
SAID_S = 3.0
"""[choice] A peer that is found silent received this vehicle no longer ago: ALONE_S, and a second of HEARTBEATs."""
LATE_S = 2.0
"""[choice] So much earlier or later a peer may have begun to return: heartbeats get lost."""
STILL_NEAR_M, SPARE_NEAR_M, AHEAD_NEAR_S = 10.0, 1.5, 3.6
"""A peer that comes no nearer than this, or beyond the separation, if both fly straight on for the filter's horizon
and a lag, is not looked at: of a vehicle with a leader, whose filter foresees peers that others turn, and of one
without."""
LEAST_MARGIN_M, MOST_MARGIN_M, SPARE_M, DECAY_S = 0.1, 1.5, 0.05, 5.0
ASIDE_M = 0.15
"""[choice] Distance from its way home that a vehicle keeps within while a peer is silent."""
OFF_LEADER_M = 2.0
FLOOR_M = 0.3
ARRIVES_S = 0.5
GENTLE_SHARE = 0.5
"""Of its acceleration with which a leader comes to rest at a goal."""
STANDS_M_S, STANDS_M = 0.1, 0.15
"""A peer that is slower, and lower, stands on the ground."""
UNCHANGED_M_S2 = 1e-9
_KEPT_CLEAR = frozenset({Mode.HOLD, Mode.GUIDED, Mode.TAKEOFF})
_GOING_DOWN = frozenset({Mode.LAND, Mode.TAKEOFF})
_EVERYWHERE = (True, True, True)


class _Peer(NamedTuple):
    """Last report of another vehicle's place."""

    p_ned: Vec3
    v_ned: Vec3
    silent_s: float

    @property
    def stands(self) -> bool:
        """Whether it is on the ground."""
        return self.p_ned[2] > -STANDS_M and elementary.norm(self.v_ned) < STANDS_M_S


@dataclass
class _Near:
    """Input of the filter: leaders, this vehicle's first, and what gives no way."""

    ids: list[int]
    p_ned: list[Vec3]
    v_ned: list[Vec3]
    wanted_ned: list[Vec3]
    intruders: list[Intruder] = field(default_factory=list)
    unled: list[int] = field(default_factory=list)
    """ids of peers in flight that are received, without a leader of their own"""


class Separation:
    """One vehicle's filter, and what it has received of its peers."""

    def __init__(self, vehicle: Vehicle, sysid: int, rules: SeparationRules) -> None:
        self._vehicle, self._sysid, self._rules = vehicle, sysid, rules
        self._settings = FilterSettings(rules.period_s, rules.separation_m, rules.clearance_m)
        self.peers = PeerTable(rules.vehicles, rules.period_s)
        self.traffic, self._traffic_reach = KnownTraffic(), TrafficReach()
        self._limits = rules.vehicles[sysid]
        self._beside_m = rules.separation_m + 4.0 * ASIDE_M
        """nearer columns are one for two that climb"""
        self._brake_m_s2 = BRAKE_SHARE * self._limits.acceleration_m_s2
        self._next_ms = 0
        self._p_ned: Vec3 = AT_REST
        self._v_ned: Vec3 = AT_REST
        self._wanted_ned: Vec3 | None = None
        self._way: deque[tuple[float, Vec3]] = deque(maxlen=16)
        self._said: deque[tuple[float, Vec3, Vec3]] = deque(maxlen=math.ceil(SAID_S / rules.period_s))
        self._silent: set[int] = set()
        self._waits = False
        self._from_ned: dict[int, Vec3] = {}
        self._higher: dict[int, bool] = {}
        self._error_m = 0.0
        own = rules.vehicles[sysid]
        self.plan, self.home_ned = own.failsafe, own.home_ned
        """timetable by which it returns when the station is lost, and to where"""
        self.target = ManeuverTarget(AT_REST, AT_REST, _EVERYWHERE, 0.0, 0.0)
        """what the vehicle flies while it has a leader"""

    # where it flies

    def step(self) -> bool:
        """Move the leader through the coming period, once a period; whether the vehicle follows it."""
        vehicle = self._vehicle
        if vehicle.time_ms < self._next_ms and vehicle.leads:
            return True
        if not vehicle.armed or vehicle.landed or self._holds():
            self.release()
            return False
        self._next_ms = vehicle.time_ms + round(1e3 * self._rules.period_s)
        steered = vehicle.mode in STEERED
        if vehicle.leads:
            self._measure()
        elif steered:
            self._begin(*vehicle.lead_of_set_points(self._rules.period_s))
        else:
            self._begin(_along(vehicle.p_ned, vehicle.v_ned, LAG_S), vehicle.v_ned)
        if steered:
            u_ned = self._stopping()
        else:
            filtered = self._filtered(vehicle.leads or vehicle.alone(ALONE_S))
            if filtered is None:
                return False
            u_ned = filtered
        self._go(u_ned)
        return True

    def _holds(self) -> bool:
        """Whether it stays where it is, or climbs over it, by order of a station that keeps all others away from there
        and could not foresee where it evades to."""
        vehicle = self._vehicle
        held = vehicle.mode in _KEPT_CLEAR and vehicle.ordered and not vehicle.alone(ALONE_S)
        return held and not (vehicle.leads and elementary.norm(self._v_ned) > STANDS_M_S)

    def release(self) -> None:
        """Leave the vehicle to its set points or its mode."""
        self._vehicle.leads, self._wanted_ned = False, None
        self._way.clear()
        self._error_m = 0.0

    def intend(self) -> None:
        """Say, as a peer receives it, where the leader is and what it wants of the next period."""
        vehicle = self._vehicle
        if vehicle.leads:
            wanted = self._wanted() if vehicle.mode not in STEERED else AT_REST
            asked = _as_sent(_along(AT_REST, _minus(wanted, self._v_ned), 1.0 / self._rules.period_s))
            self._wanted_ned = _along(self._v_ned, asked, self._rules.period_s)
            self._said.append((vehicle.time_s, self._p_ned, self._v_ned))
            vehicle.put_leader((*self._p_ned, *self._v_ned, *asked))

    def _presumed(self, peer: _Peer, sysid: int) -> list[Vec3]:
        """Where a silent peer may be that returns by the timetable, as this vehicle does: where it came to rest, if it
        braked within PARTED_S of its last report, and on the leg that is due, from its beginning to where it can have
        come. Of two that would climb through each other's columns the higher goes first, and the lower waits."""
        here, member = peer.p_ned, self._rules.vehicles[sysid]
        count = math.ceil(PARTED_S * elementary.norm(peer.v_ned) / STEP_M)
        rests = [_along(here, peer.v_ned, PARTED_S * k / max(count, 1)) for k in range(count + 1)]
        now_s, plan = max(self._vehicle.returning_s(), 0.0), member.failsafe
        begun_s = max(now_s - peer.silent_s, 0.0)
        if begun_s > plan.down_after_s and elementary.distance(here[:2], member.home_ned[:2]) > OVER_HOME_M:
            return rests
        due_s = max(at_s for at_s in (0.0, plan.level_after_s, plan.down_after_s) if at_s <= max(now_s - LATE_S, 0.0))
        own = self._from_ned[self._sysid]
        if due_s == 0.0 and elementary.distance(own[:2], here[:2]) < self._beside_m:
            known_ned, _ = self._known(peer.silent_s)
            if self._higher.setdefault(sysid, (known_ned[2], -self._sysid) < (here[2], -sysid)):
                return rests
            self._waits = True
        legs = way_home(here, member.home_ned, plan)
        places = stretch(legs, due_s, now_s + LATE_S + AHEAD_S, begun_s)
        if now_s > plan.again_after_s:
            return places or [member.home_ned]
        return [*rests, *places]

    def resting_place(self) -> Vec3:
        """Place where the leader stands if it brakes now."""
        return self._rest(self._sysid, self._p_ned, self._v_ned)

    def _rest(self, sysid: int, p_ned: Vec3, v_ned: Vec3) -> Vec3:
        speed_m_s = elementary.norm(v_ned)
        if speed_m_s < STANDS_M_S * 1e-3:
            return p_ned
        brake_m_s2 = BRAKE_SHARE * self._rules.vehicles[sysid].acceleration_m_s2
        return _along(p_ned, v_ned, stop_way(speed_m_s, brake_m_s2, self._rules.period_s) / speed_m_s)

    def _by_plan(self) -> bool:
        """Whether no station keeps others away from it."""
        return self._vehicle.alone(ALONE_S) or self._vehicle.returning_s() >= 0.0

    def _known(self, silent_s: float) -> tuple[Vec3, Vec3]:
        """Resting place and velocity of its leader, as a peer has last received them that has been silent for so long:
        such a peer knows of no turn since."""
        then_s = self._vehicle.time_s - silent_s
        for said_s, p_ned, v_ned in self._said:
            if abs(said_s - then_s) < 0.5 * self._rules.period_s:
                return self._rest(self._sysid, p_ned, v_ned), v_ned
        return self.resting_place(), AT_REST

    def _part(self, silent: dict[int, float]) -> None:
        """Stay, while peers are silent (by system id, for how long), where they presume this vehicle, as it presumes
        them, and all those that it receives: on the way home from where it came to rest."""
        self._waits = False
        if not silent:
            self._silent, self._from_ned, self._higher = set(), {}, {}
            return
        if self._sysid not in self._from_ned:
            known = self._known(min(silent.values()))
            self._from_ned[self._sysid] = nearest_rest(self.resting_place(), *known, PARTED_S)
        self._silent |= silent.keys()
        self._vehicle.return_from(self._from_ned[self._sysid])
        self._waits = self._barred()

    def _barred(self) -> bool:
        """Whether a peer that is received is above, in the column through which this vehicle would climb, and returns
        less high: this one could not pass it, and would wait among the ways of those that are silent."""
        if not 0.0 <= self._vehicle.returning_s() < self.plan.level_after_s:
            return False
        own, now_ms = self._from_ned[self._sysid], self._vehicle.time_ms
        top_d = min(own[2], self.home_ned[2] - self.plan.altitude_m)
        for sysid, member in self._rules.vehicles.items():
            said_ms, (n, e, d), _ = self.peers.newest(sysid)
            if sysid == self._sysid or said_ms < 0 or now_ms - said_ms > 1e3 * PARTED_S or d >= self._p_ned[2]:
                continue
            beside = elementary.distance((n, e), own[:2]) < self._beside_m
            if beside and min(d, member.home_ned[2] - member.failsafe.altitude_m) > top_d:
                return True
        return False

    def _tubes(self, near: _Near, margin_m: NDArray[np.float64]) -> tuple[Any, Any]:
        """Walls of all, north, east and down, within which each stays on its way home (skytender/safety/silence.py)."""
        vehicle = self._vehicle
        low, high = np.full((len(near.ids), 3), -math.inf), np.full((len(near.ids), 3), math.inf)
        if vehicle.ground and vehicle.mode not in _GOING_DOWN and vehicle.home_ned[2] - self._p_ned[2] > FLOOR_M:
            high[0, 2] = vehicle.home_ned[2] - FLOOR_M
        for row, sysid in enumerate(near.ids):
            if self._silent and not (row == 0 and vehicle.mode is Mode.LAND):
                member = self._rules.vehicles[sysid]
                now_s = -1.0 if row == 0 and self._waits else vehicle.returning_s()
                if sysid not in self._from_ned:
                    self._from_ned[sysid] = self._rest(sysid, near.p_ned[row], near.v_ned[row])
                from_ned = self._from_ned[sysid]
                box = np.array(tube(near.p_ned[row], from_ned, member.home_ned, now_s, member.failsafe))
                wide_m = ASIDE_M + margin_m[row]
                low[row], high[row] = box[0] - wide_m, np.minimum(high[row], box[1] + wide_m)
        return low, high

    def _begin(self, p_ned: Vec3, v_ned: Vec3) -> None:
        self._p_ned, self._v_ned, self._wanted_ned = _as_sent(p_ned), _as_sent(v_ned), None

    def _measure(self) -> None:
        """The vehicle against its leader: how far it is from where that was a lag ago."""
        now_s, here = self._vehicle.time_s, self._vehicle.p_ned
        then_s = now_s - LAG_S
        self._error_m *= elementary.exp(-self._rules.period_s / DECAY_S)
        if self._way and self._way[0][0] <= then_s:
            for (a_s, a), (b_s, b) in zip(self._way, list(self._way)[1:], strict=False):
                if a_s <= then_s <= b_s:
                    error_m = elementary.distance(here, _along(a, _minus(b, a), (then_s - a_s) / (b_s - a_s)))
                    self._error_m = max(self._error_m, error_m)
                    if error_m > OFF_LEADER_M:
                        self.release()
                        self._begin(_along(here, self._vehicle.v_ned, LAG_S), self._vehicle.v_ned)
                    break

    def _go(self, u_ned: Vec3) -> None:
        vehicle, dt = self._vehicle, self._rules.period_s
        mean_ned = _along(self._v_ned, u_ned, 0.5 * dt)
        fastest = max(elementary.norm(mean_ned), vehicle.parameters["MPC_XY_VEL_MAX"])
        self.target = ManeuverTarget(self._p_ned, mean_ned, _EVERYWHERE, vehicle.time_s, fastest)
        self._way.append((vehicle.time_s, self._p_ned))
        self._p_ned, self._v_ned = _as_sent(_along(self._p_ned, mean_ned, dt)), _as_sent(_along(self._v_ned, u_ned, dt))
        vehicle.leads = True

    def _wanted(self) -> Vec3:
        """Velocity towards what the mode wants, slow enough to come to rest there."""
        target, now_s = self._vehicle.mode_target(), self._vehicle.time_s
        if self._waits:
            target = target._replace(p_ned=self._from_ned[self._sysid])
        ahead_s = now_s - target.time_s
        away = [
            target.p_ned[i] + ahead_s * target.v_ned[i] - self._p_ned[i] if target.use_position[i] else 0.0
            for i in range(3)
        ]
        away_m = elementary.norm(away)
        gentle_m_s = math.sqrt(2.0 * GENTLE_SHARE * self._limits.acceleration_m_s2 * away_m)
        speed_m_s = min(target.speed_m_s, self._limits.speed_m_s, gentle_m_s, away_m / ARRIVES_S)
        share = speed_m_s / away_m if away_m > 0.0 else 0.0
        return _along(target.v_ned, _vec(away), share)

    def _aircraft(self) -> list[Intruder]:
        traffic = self.traffic.at(self._vehicle.time_s)
        return self._traffic_reach.intruders(traffic, LAG_S, self._rules.separation_m)

    def _stopping(self) -> Vec3:
        """Acceleration while set points stay away: it brakes, or leaves aircraft as far as peers that brake give it
        room."""
        dt = self._rules.period_s
        brakes = braking(*self._v_ned, self._brake_m_s2, dt)
        aircraft = self._aircraft()
        if not aircraft:
            return brakes
        own = Leaders(
            ids=[self._sysid],
            p_ned=[self._p_ned],
            v_ned=[self._v_ned],
            v_max_m_s=[self._limits.speed_m_s],
            a_max_m_s2=[self._limits.acceleration_m_s2],
            margin_m=[self._margin_m()],
        )
        wanted_ned = [_along(self._v_ned, brakes, dt)]
        obstacles = self._rules.obstacles
        filtered = filter_step(own, wanted_ned, rules=self._settings, others=table_of(aircraft), obstacles=obstacles)
        if filtered.changed_m_s2[0] <= UNCHANGED_M_S2:
            return brakes
        now_ms, table = self._vehicle.time_ms, self.peers
        beside = table.worth_looking(now_ms, self._p_ned, self._v_ned, STILL_NEAR_M, AHEAD_NEAR_S, FORGOTTEN_S)
        return self._sure(filtered.u_ned[0], [sysid for sysid in beside if sysid != self._sysid], LAG_S)

    def _sure(
        self,
        u_ned: NDArray[np.float64],
        sysids: Sequence[int],
        lead_s: float,
        leaders: _Near | None = None,
        late: Sequence[int] = (),
    ) -> Vec3:
        """The nearest acceleration that is safe whatever `leaders` and these peers do (simvehicle/fleet/
        spare_distance.py), which are looked at where they will be `lead_s` from now; those of `late` also where they
        are that have braked since their last report."""
        near = leaders or _Near([self._sysid], [self._p_ned], [self._v_ned], [])
        ids, places, velocities = list(near.ids), list(near.p_ned), list(near.v_ned)
        for sysid in sysids:
            place_ms, p_ned, v_ned = self.peers.place(sysid)
            ids.append(sysid)
            places.append(_along(p_ned, v_ned, (self._vehicle.time_ms - place_ms) / 1e3 + lead_s))
            velocities.append(v_ned)
        for sysid in late:
            brake_m_s2 = BRAKE_SHARE * self._rules.vehicles[sysid].acceleration_m_s2
            _, p_ned, v_ned = self.peers.newest(sysid)
            motion = braked(p_ned, v_ned, brake_m_s2, self._rules.period_s, self._missed(sysid))
            ids, places, velocities = [*ids, sysid], [*places, motion[0]], [*velocities, motion[1]]
        if len(ids) == 1:
            return _vec(u_ned.tolist())
        brakes = np.array([BRAKE_SHARE * self._rules.vehicles[sysid].acceleration_m_s2 for sysid in ids])
        required_m = np.full(len(ids) - 1, self._rules.separation_m + self._margin_m() + LEAST_MARGIN_M)
        dt = self._rules.period_s
        return sure_acceleration(u_ned, np.array(places), np.array(velocities), brakes, required_m, dt)

    def _missed(self, sysid: int) -> int:
        """Periods that have passed since a peer said what it flies by."""
        said_ms, _, _ = self.peers.newest(sysid)
        return round((self._vehicle.time_ms - said_ms) / (1e3 * self._rules.period_s))

    def _margin_m(self) -> float:
        return min(max(self._error_m + SPARE_M, LEAST_MARGIN_M), MOST_MARGIN_M)

    def _filtered(self, leads: bool) -> Vec3 | None:
        """Acceleration of the coming period; None where a vehicle without a leader needs none."""
        near = self._near(leads)
        if not leads and len(near.ids) == 1 and not near.intruders:
            return None
        n = len(near.ids)
        limits = [self._rules.vehicles[sysid] for sysid in near.ids]
        margin_m = np.full(n, LEAST_MARGIN_M)
        margin_m[0] = self._margin_m()
        low, high = self._tubes(near, margin_m)
        filtered = filter_step(
            Leaders(
                ids=near.ids,
                p_ned=near.p_ned,
                v_ned=near.v_ned,
                v_max_m_s=[one.speed_m_s for one in limits],
                a_max_m_s2=[one.acceleration_m_s2 for one in limits],
                margin_m=margin_m,
                low_ned=low,
                high_ned=high,
            ),
            near.wanted_ned,
            rules=self._settings,
            others=table_of(near.intruders),
            obstacles=self._rules.obstacles,
        )
        if not leads and filtered.changed_m_s2[0] <= UNCHANGED_M_S2:
            return None
        for sysid, p_ned, v_ned in zip(
            near.ids[1:], filtered.p_next_ned[1:].tolist(), filtered.v_next_ned[1:].tolist(), strict=True
        ):
            self.peers.predict(sysid, _vec(p_ned), _vec(v_ned))
        if not self._by_plan():
            return _vec(filtered.u_ned[0].tolist())
        # One that returns while others have the station: each may be steered at any time, from where it is.
        steerable = [] if self._vehicle.alone(ALONE_S) else [*near.ids[1:], *near.unled]
        late = [sysid for sysid in (*near.ids[1:], *near.unled) if self._missed(sysid) > 0]
        return self._sure(filtered.u_ned[0], steerable, 0.0, near, late)

    def _near(self, leads: bool) -> _Near:
        wanted = self._wanted_ned if leads and self._wanted_ned is not None else self._wanted()
        near = _Near([self._sysid], [self._p_ned], [self._v_ned], [wanted])
        now_ms, table = self._vehicle.time_ms, self.peers
        near_m = STILL_NEAR_M if leads else self._rules.separation_m + SPARE_NEAR_M
        by_plan = self._by_plan()
        parted_s, unheard = PARTED_S if by_plan else SILENT_S, list[tuple[int, _Peer]]()
        for sysid in table.worth_looking(now_ms, self._p_ned, self._v_ned, near_m, AHEAD_NEAR_S, parted_s):
            if sysid == self._sysid:
                continue
            leader_ms, leader_p, leader_v, wanted_ned = table.leader(sysid)
            if leader_ms >= 0 and now_ms - leader_ms < 1e3 * PREDICTED_S:
                near.ids.append(sysid)
                near.p_ned.append(leader_p)
                near.v_ned.append(leader_v)
                near.wanted_ned.append(wanted_ned)
                continue
            place_ms, p_ned, v_ned = table.place(sysid)
            newest = (p_ned, v_ned, place_ms) if place_ms >= leader_ms else (leader_p, leader_v, leader_ms)
            peer = _Peer(newest[0], newest[1], (now_ms - newest[2]) / 1e3)
            if peer.stands or peer.silent_s < parted_s or not by_plan:
                near.intruders += self._intruders(sysid, peer, 0.0 if leader_ms > place_ms else LAG_S)
                near.unled += [sysid] if by_plan and not peer.stands else []
            else:
                _, p_ned, v_ned = table.newest(sysid)
                unheard.append((sysid, peer._replace(p_ned=self._rest(sysid, p_ned, v_ned), v_ned=v_ned)))
        near.intruders += self._aircraft()
        self._part({sysid: peer.silent_s for sysid, peer in unheard})
        for sysid, peer in unheard:
            near.intruders += self._out_of_reach(sysid, peer)
        return near

    def _intruders(self, sysid: int, peer: _Peer, lag_s: float) -> list[Intruder]:
        """Where a peer may be of which no leader is known: one on the ground where it is, one that is received where it
        flies."""
        distance_m, silent_s = self._rules.separation_m, peer.silent_s
        if peer.stands:
            return self._at([peer.p_ned], sysid, distance_m)
        if silent_s > FORGOTTEN_S:
            return []
        lead_s = lag_s + min(silent_s, SILENT_S)
        reach_m = distance_m + LEAST_MARGIN_M
        return [Intruder.of(f"vehicle {sysid}", None, peer.p_ned, peer.v_ned, lead_s, reach_m, silent_s)]

    def _out_of_reach(self, sysid: int, peer: _Peer) -> list[Intruder]:
        """Where one may be that is silent on its way home, if the station is silent too."""
        distance_m = elementary.hypot(self._rules.separation_m + ASIDE_M, 0.5 * STEP_M)
        return self._at(self._presumed(peer, sysid), sysid, distance_m)

    def _at(self, places: list[Vec3], sysid: int, distance_m: float) -> list[Intruder]:
        return [
            Intruder.of(f"vehicle {sysid}", None, place, AT_REST, 0.0, distance_m, 0.0)
            for place in places
            if elementary.distance(place, self._p_ned) < STILL_NEAR_M
        ]


def _vec(numbers: Any) -> Vec3:
    return numbers[0], numbers[1], numbers[2]


def _as_sent(v: Vec3) -> Vec3:
    return float32(v[0]), float32(v[1]), float32(v[2])


def _along(a: Vec3, b: Vec3, share: float) -> Vec3:
    return a[0] + share * b[0], a[1] + share * b[1], a[2] + share * b[2]


def _minus(a: Vec3, b: Vec3) -> Vec3:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]
