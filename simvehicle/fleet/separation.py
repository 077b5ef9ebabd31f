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
from simvehicle.autopilot.vectors import Vec3, along, vec
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.peer_table import PeerTable
from simvehicle.fleet.separation_rules import SeparationRules
from simvehicle.fleet.silent_peers import ASIDE_M, PARTED_S, SilentPeers
from simvehicle.fleet.spare_distance import braked, sure_acceleration
from skytender import elementary
from skytender.safety.braking_clearance import braking
from skytender.safety.intruders import Intruder, table_of
from skytender.safety.safety_filter import BRAKE_SHARE, FilterSettings, Leaders, filter_step
from skytender.safety.silence import STEP_M
from skytender.safety.traffic import KnownTraffic, TrafficReach
from skytender.vehicle.parameters import float32

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
STILL_NEAR_M, SPARE_NEAR_M, AHEAD_NEAR_S = 10.0, 1.5, 3.6
"""A peer that comes no nearer than this, or beyond the separation, if both fly straight on for the filter's horizon
and a lag, is not looked at: of a vehicle with a leader, whose filter foresees peers that others turn, and of one
without."""
LEAST_MARGIN_M, MOST_MARGIN_M, SPARE_M, DECAY_S = 0.1, 1.5, 0.05, 5.0
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
        self._brake_m_s2 = BRAKE_SHARE * self._limits.acceleration_m_s2
        self._next_ms = 0
        self._p_ned: Vec3 = AT_REST
        self._v_ned: Vec3 = AT_REST
        self._wanted_ned: Vec3 | None = None
        self._way: deque[tuple[float, Vec3]] = deque(maxlen=16)
        self._silent = SilentPeers(vehicle, sysid, rules, self.peers)
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
            self._begin(along(vehicle.p_ned, vehicle.v_ned, LAG_S), vehicle.v_ned)
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
            asked = _as_sent(along(AT_REST, along(wanted, self._v_ned, -1.0), 1.0 / self._rules.period_s))
            self._wanted_ned = along(self._v_ned, asked, self._rules.period_s)
            self._silent.say(self._p_ned, self._v_ned)
            vehicle.put_leader((*self._p_ned, *self._v_ned, *asked))

    def resting_place(self) -> Vec3:
        """Place where the leader stands if it brakes now."""
        return self._rules.rest(self._sysid, self._p_ned, self._v_ned)

    def _by_plan(self) -> bool:
        """Whether no station keeps others away from it."""
        return self._vehicle.alone(ALONE_S) or self._vehicle.returning_s() >= 0.0

    def _tubes(self, near: _Near, margin_m: NDArray[np.float64]) -> tuple[Any, Any]:
        """Walls of all, north, east and down: the ground, and while peers are silent the way home of each."""
        vehicle = self._vehicle
        low, high = np.full((len(near.ids), 3), -math.inf), np.full((len(near.ids), 3), math.inf)
        if vehicle.ground and vehicle.mode not in _GOING_DOWN and vehicle.home_ned[2] - self._p_ned[2] > FLOOR_M:
            high[0, 2] = vehicle.home_ned[2] - FLOOR_M
        for row, sysid in enumerate(near.ids):
            if self._silent.any and not (row == 0 and vehicle.mode is Mode.LAND):
                box = np.array(self._silent.tube(sysid, near.p_ned[row], near.v_ned[row]))
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
                    error_m = elementary.distance(here, along(a, along(b, a, -1.0), (then_s - a_s) / (b_s - a_s)))
                    self._error_m = max(self._error_m, error_m)
                    if error_m > OFF_LEADER_M:
                        self.release()
                        self._begin(along(here, self._vehicle.v_ned, LAG_S), self._vehicle.v_ned)
                    break

    def _go(self, u_ned: Vec3) -> None:
        vehicle, dt = self._vehicle, self._rules.period_s
        mean_ned = along(self._v_ned, u_ned, 0.5 * dt)
        fastest = max(elementary.norm(mean_ned), vehicle.parameters["MPC_XY_VEL_MAX"])
        self.target = ManeuverTarget(self._p_ned, mean_ned, _EVERYWHERE, vehicle.time_s, fastest)
        self._way.append((vehicle.time_s, self._p_ned))
        self._p_ned, self._v_ned = _as_sent(along(self._p_ned, mean_ned, dt)), _as_sent(along(self._v_ned, u_ned, dt))
        vehicle.leads = True

    def _wanted(self) -> Vec3:
        """Velocity towards what the mode wants, slow enough to come to rest there."""
        target, now_s = self._vehicle.mode_target(), self._vehicle.time_s
        if self._silent.waits_at_ned is not None:
            target = target._replace(p_ned=self._silent.waits_at_ned)
        ahead_s = now_s - target.time_s
        away = [
            target.p_ned[i] + ahead_s * target.v_ned[i] - self._p_ned[i] if target.use_position[i] else 0.0
            for i in range(3)
        ]
        away_m = elementary.norm(away)
        gentle_m_s = math.sqrt(2.0 * GENTLE_SHARE * self._limits.acceleration_m_s2 * away_m)
        speed_m_s = min(target.speed_m_s, self._limits.speed_m_s, gentle_m_s, away_m / ARRIVES_S)
        share = speed_m_s / away_m if away_m > 0.0 else 0.0
        return along(target.v_ned, vec(away), share)

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
        wanted_ned = [along(self._v_ned, brakes, dt)]
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
            places.append(along(p_ned, v_ned, (self._vehicle.time_ms - place_ms) / 1e3 + lead_s))
            velocities.append(v_ned)
        for sysid in late:
            brake_m_s2 = BRAKE_SHARE * self._rules.vehicles[sysid].acceleration_m_s2
            _, p_ned, v_ned = self.peers.newest(sysid)
            motion = braked(p_ned, v_ned, brake_m_s2, self._rules.period_s, self._missed(sysid))
            ids, places, velocities = [*ids, sysid], [*places, motion[0]], [*velocities, motion[1]]
        if len(ids) == 1:
            return vec(u_ned.tolist())
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
            self.peers.predict(sysid, vec(p_ned), vec(v_ned))
        if not self._by_plan():
            return vec(filtered.u_ned[0].tolist())
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
                unheard.append((sysid, peer._replace(p_ned=self._rules.rest(sysid, p_ned, v_ned), v_ned=v_ned)))
        near.intruders += self._aircraft()
        self._silent.part({sysid: peer.silent_s for sysid, peer in unheard}, self._p_ned, self._v_ned)
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
        unheard_s = (self._vehicle.time_ms - self.peers.arrived(sysid)) / 1e3
        if unheard_s >= PARTED_S:  # it came to rest, as this vehicle did, or is led past it: fleeing, both might meet
            _, p_ned, v_ned = self.peers.newest(sysid)
            return self._at([self._rules.rest(sysid, p_ned, v_ned)], sysid, distance_m)
        lead_s, reach_m = lag_s + min(silent_s, SILENT_S), distance_m + LEAST_MARGIN_M
        name, p_ned, v_ned = f"vehicle {sysid}", peer.p_ned, peer.v_ned
        return [Intruder.of(name, None, p_ned, v_ned, lead_s, reach_m, silent_s, unheard_s=unheard_s)]

    def _out_of_reach(self, sysid: int, peer: _Peer) -> list[Intruder]:
        """Where one may be that is silent on its way home, if the station is silent too."""
        distance_m = elementary.hypot(self._rules.separation_m + ASIDE_M, 0.5 * STEP_M)
        return self._at(self._silent.presumed(sysid, peer.p_ned, peer.v_ned, peer.silent_s), sysid, distance_m)

    def _at(self, places: list[Vec3], sysid: int, distance_m: float) -> list[Intruder]:
        return [
            Intruder.of(f"vehicle {sysid}", None, place, AT_REST, 0.0, distance_m, 0.0)
            for place in places
            if elementary.distance(place, self._p_ned) < STILL_NEAR_M
        ]


def _as_sent(v: Vec3) -> Vec3:
    return float32(v[0]), float32(v[1]), float32(v[2])
