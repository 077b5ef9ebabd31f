"""Peers that are silent while the station is silent too: their presumed places, and the way to which this vehicle
keeps so that peers presume it rightly (docs/protocol/onboard.md#separation-on-board).

NED, SI units; times are the vehicle's own.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Mapping

from simvehicle.autopilot.maneuvers import AT_REST
from simvehicle.autopilot.modes import Mode
from simvehicle.autopilot.vectors import Vec3, along
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.peer_table import PeerTable
from simvehicle.fleet.separation_rules import SeparationRules
from skytender import elementary
from skytender.safety.silence import AHEAD_S, OVER_HOME_M, STEP_M, nearest_rest, stretch, tube, way_home

PARTED_S = 0.5
"""[choice] A peer of which nothing has come for so long is silent, while the station is silent too."""
SAID_S = 3.0
"""[choice] A peer that is found silent received this vehicle no longer ago."""
LATE_S = 2.0
"""[choice] So much earlier or later a peer may have begun to return: heartbeats get lost."""
ASIDE_S = 2.0
"""[choice] For so long since its return began a vehicle leaves a column that another one bars."""
CLIMBS_M_S = 0.5
"""[choice] A peer that wants to rise so fast while this vehicle returns does so too."""
ASIDE_M = 0.15
"""[choice] Distance from its way home that a vehicle keeps within while a peer is silent."""


class SilentPeers:
    """One vehicle's silent peers."""

    def __init__(self, vehicle: Vehicle, sysid: int, rules: SeparationRules, peers: PeerTable) -> None:
        self.waits_at_ned: Vec3 | None = None
        """where this vehicle waits until it receives others again or they have landed, or to leave a column"""
        self._vehicle, self._sysid, self._rules, self._peers = vehicle, sysid, rules, peers
        own = rules.vehicles[sysid]
        self._home_ned, self._plan = own.home_ned, own.failsafe
        self._beside_m = rules.separation_m + 4.0 * ASIDE_M
        """nearer columns are one for two that climb"""
        self._said: deque[tuple[float, Vec3, Vec3]] = deque(maxlen=math.ceil(SAID_S / rules.period_s))
        self._rest_ned: Vec3 = AT_REST
        self._silent: set[int] = set()
        self._from_ned: dict[int, Vec3] = {}
        """where those came to rest that this vehicle knows, itself among them"""
        self._higher: dict[int, bool] = {}

    @property
    def any(self) -> bool:
        """Whether a peer is silent."""
        return bool(self._silent)

    @property
    def from_ned(self) -> Vec3:
        """Place where this vehicle came to rest; call it only while a peer is silent."""
        return self._from_ned[self._sysid]

    def say(self, p_ned: Vec3, v_ned: Vec3) -> None:
        """This vehicle reports its leader now."""
        self._said.append((self._vehicle.time_s, p_ned, v_ned))

    def part(self, silent: Mapping[int, float], p_ned: Vec3, v_ned: Vec3) -> None:
        """Note which peers are silent, and for how long, by system id. While any is silent, this vehicle, whose leader
        is at p and v, returns from its resting place, where silent peers presume it."""
        self.waits_at_ned = None
        self._rest_ned = self._rules.rest(self._sysid, p_ned, v_ned)
        if not silent:
            self._silent, self._from_ned, self._higher = set(), {}, {}
            self._step_aside(p_ned)
            return
        if self._sysid not in self._from_ned:
            known = self._known(min(silent.values()))
            self._from_ned[self._sysid] = nearest_rest(self._rest_ned, *known, PARTED_S)
        self._silent |= silent.keys()
        self._vehicle.return_from(self.from_ned)
        if self._lower_above(self.from_ned, p_ned[2]):  # below it, this one would wait where silent peers fly
            self.waits_at_ned = self.from_ned

    def presumed(self, sysid: int, rest_ned: Vec3, v_ned: Vec3, silent_s: float) -> list[Vec3]:
        """Where a silent peer may be that returns by the timetable, as this vehicle does: where it came to rest, if it
        braked within PARTED_S of its last report, and on the leg that is due, from its beginning to where it can have
        come. Of two that would climb through each other's columns the higher goes first, and the lower waits.

        rest_ned, v_ned: where it stood if it braked at its last report, and how fast it was then.
        """
        member = self._rules.vehicles[sysid]
        count = math.ceil(PARTED_S * elementary.norm(v_ned) / STEP_M)
        rests = [along(rest_ned, v_ned, PARTED_S * k / max(count, 1)) for k in range(count + 1)]
        now_s, plan = max(self._vehicle.returning_s(), 0.0), member.failsafe
        begun_s = max(now_s - silent_s, 0.0)
        if begun_s > plan.down_after_s and elementary.distance(rest_ned[:2], member.home_ned[:2]) > OVER_HOME_M:
            return rests
        due_s = max(at_s for at_s in (0.0, plan.level_after_s, plan.down_after_s) if at_s <= max(now_s - LATE_S, 0.0))
        if due_s == 0.0 and elementary.distance(self.from_ned[:2], rest_ned[:2]) < self._beside_m:
            known_ned, _ = self._known(silent_s)
            if self._higher.setdefault(sysid, (known_ned[2], -self._sysid) < (rest_ned[2], -sysid)):
                return rests
            self.waits_at_ned = self.from_ned
        legs = way_home(rest_ned, member.home_ned, plan)
        places = stretch(legs, due_s, now_s + LATE_S + AHEAD_S, begun_s)
        if now_s > plan.again_after_s:
            return places or [member.home_ned]
        return [*rests, *places]

    def tube(self, sysid: int, p_ned: Vec3, v_ned: Vec3) -> tuple[Vec3, Vec3]:
        """Least and greatest places of the leg that is due on the way home of a vehicle that is received, or of this
        one, whose leader is at p and v (skytender/safety/silence.py)."""
        member = self._rules.vehicles[sysid]
        now_s = -1.0 if sysid == self._sysid and self.waits_at_ned else self._vehicle.returning_s()
        if sysid not in self._from_ned:
            self._from_ned[sysid] = self._rules.rest(sysid, p_ned, v_ned)
        return tube(p_ned, self._from_ned[sysid], member.home_ned, now_s, member.failsafe)

    def _known(self, silent_s: float) -> tuple[Vec3, Vec3]:
        """Resting place and velocity of this vehicle's leader, as a peer has last received them that has been silent
        for so long: such a peer knows of no turn since."""
        then_s = self._vehicle.time_s - silent_s
        for said_s, p_ned, v_ned in self._said:
            if abs(said_s - then_s) < 0.5 * self._rules.period_s:
                return self._rules.rest(self._sysid, p_ned, v_ned), v_ned
        return self._rest_ned, AT_REST

    def _step_aside(self, p_ned: Vec3) -> None:
        """Leave a column before climbing in it, if it has a vehicle above that returns less high: pushed from below,
        that one would leave its own height, and be parted from others there.

        Only in the return's first moments, for the timetable has no more time; only from vehicles that climb home too,
        since a station that leads others expects this one in its column; and not between two, where no way leads out.
        """
        if self._vehicle.returning_s() > ASIDE_S:
            return
        north = east = farthest_m = 0.0
        for sysid, (n, e, _) in self._lower_above(p_ned, p_ned[2]).items():
            said_ms, _, _, wanted_ned = self._peers.leader(sysid)
            if said_ms < self._vehicle.time_ms - 1e3 * PARTED_S or wanted_ned[2] > -CLIMBS_M_S:
                continue
            away_m = elementary.distance((n, e), p_ned[:2])
            along_n, along_e = ((p_ned[0] - n) / away_m, (p_ned[1] - e) / away_m) if away_m > 0.0 else (1.0, 0.0)
            missing_m = self._beside_m + ASIDE_M - away_m
            north, east, farthest_m = (
                north + missing_m * along_n,
                east + missing_m * along_e,
                max(farthest_m, missing_m),
            )
        push_m = elementary.hypot(north, east)
        if farthest_m > 0.0 and push_m >= 0.5 * farthest_m:
            share = farthest_m / push_m
            self.waits_at_ned = (p_ned[0] + share * north, p_ned[1] + share * east, p_ned[2])
            self._vehicle.return_from(self.waits_at_ned)

    def _lower_above(self, column_ned: Vec3, height_d: float) -> dict[int, Vec3]:
        """Places of received peers that bar a climb in a column from a height, by system id: above this vehicle, with a
        lower height of their return."""
        if self._vehicle.mode is not Mode.RETURN or not 0.0 <= self._vehicle.returning_s() < self._plan.level_after_s:
            return {}
        now_ms, top_d = self._vehicle.time_ms, min(column_ned[2], self._home_ned[2] - self._plan.altitude_m)
        found = {}
        for sysid, member in self._rules.vehicles.items():
            said_ms, (n, e, d), _ = self._peers.newest(sysid)
            if sysid == self._sysid or said_ms < 0 or now_ms - said_ms > 1e3 * PARTED_S or d >= height_d:
                continue
            beside = elementary.distance((n, e), column_ned[:2]) < self._beside_m
            if beside and min(d, member.home_ned[2] - member.failsafe.altitude_m) > top_d:
                found[sysid] = (n, e, d)
        return found
