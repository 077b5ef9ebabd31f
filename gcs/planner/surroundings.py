"""Vehicles in the air, traffic and attractors around the leaders of a role: what repels and draws them, and what they
need not keep away from (docs/model/planner.md#potential-field)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gcs.planner.leader import Attracting, Moving
from gcs.planner.neighbours import IntArray
from gcs.planner.potential_field import widened_range
from gcs.scenario.model import Scenario
from gcs.telemetry.state import FleetSnapshot, Vec3
from skytender import elementary, geometry
from skytender.geometry import COLUMNS, DOWN, NORTH, FloatArray

LOOKAHEAD_S = 0.37
SAFE_RANGE_SHARE = 0.5
"""[choice] Of the range in which vehicles repel each other, where the safety filter keeps them apart: at all of it
vehicles that hover in a tight row push each other to and fro."""


class LedPart(NamedTuple):
    """The led vehicles of one role."""

    role: str
    rows: IntArray
    sysids: tuple[int, ...]


class Team(NamedTuple):
    """Vehicles that are led, and those in the air: the same for many ticks."""

    key: tuple[frozenset[int], bytes, bytes]
    rows: IntArray
    sysids: tuple[int, ...]
    parts: list[LedPart]
    flying: IntArray
    flying_sysids: tuple[int, ...]
    spheres: FloatArray
    """obstacle table of those in the air, their places left open"""


class _Exempted(NamedTuple):
    """Others that the leaders of one role need not keep away from: the same for many ticks."""

    team: Team
    callsigns: list[str]
    pairs: tuple[tuple[int, int], ...]
    of_each: NDArray[np.bool_]
    everyone: bool


NOTHING_MOVES = Moving(np.zeros((0, COLUMNS)), np.zeros(0), np.zeros((0, 0), np.bool_))
_NOTHING_ATTRACTS = Attracting(np.zeros((0, 4)), np.zeros((0, 0), np.bool_))


class LeaderSurroundings:
    """Everything around leaders that moves or attracts. Rows are of the scenario's vehicles in order of system id."""

    def __init__(self, scenario: Scenario) -> None:
        self.scenario = scenario
        """attractors may change in flight"""
        self._rules = scenario.planner
        role = {vehicle.sysid: vehicle.role for vehicle in scenario.vehicles.all}
        self.roles = np.array([role[vehicle.sysid] for vehicle in scenario.vehicles.all])
        radii_m = {role: self._radius_m(role) for role in set(role.values())}
        self._radii_m = np.array([radii_m[role] for role in self.roles.tolist()], np.float64)
        self._attracting = {mover.callsign for mover in scenario.traffic if mover.attracts}
        self._exempted: dict[str, _Exempted] = {}
        """by role"""

    def spheres(self, flying: IntArray) -> FloatArray:
        """Obstacle table of the vehicles of these rows, their places left open."""
        return geometry.points(np.zeros((len(flying), 3)), self._radii_m[flying])

    def attractors(self, snapshot: FleetSnapshot, part: LedPart) -> Attracting:
        """Points that draw pursuers beside their goals."""
        if part.role != "pursuer" or not (self.scenario.attractors or self._attracting):
            return _NOTHING_ATTRACTS
        default_m = self._rules.attraction_range_m
        rows = [(*a.point_m, a.range_m or default_m) for a in self.scenario.attractors]
        for aircraft in snapshot.traffic:
            if aircraft.callsign in self._attracting:
                rows.append((*ahead(aircraft.p_ned, aircraft.v_ned, LOOKAHEAD_S + aircraft.age_s), default_m))
        table = np.array(rows, np.float64).reshape(-1, 4)
        drawn = np.ones((len(part.rows), len(table)), np.bool_)
        return Attracting(table, drawn)

    def movers(self, snapshot: FleetSnapshot, team: Team, at_ned: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Everything that moves and repels, vehicles in the air, then traffic: obstacle table and ranges (m,), m.

        A vehicle is a sphere of the separation that the scenario demands: a leader pressed against it stays out.
        A target must not push its pursuers from their ring, so its sphere ends where the ring is out of its range.

        at_ned: (k, 3) where leaders meet the vehicles in the air, m.
        """
        columns, table = snapshot.columns, team.spheres
        ages_s = columns.age_s[team.flying]
        speeds = list(map(elementary.norm, columns.v_ned[team.flying].tolist()))
        if snapshot.traffic:
            places = [ahead(a.p_ned, a.v_ned, LOOKAHEAD_S + a.age_s) for a in snapshot.traffic]
            aircraft_m = self._rules.separation_m if self._rules.safety else 0.0
            table = np.concatenate((table, geometry.points(places, np.full(len(places), aircraft_m))))
            at_ned = np.concatenate((at_ned, places))
            period_s = self.scenario.clock.period_s
            speeds += [elementary.norm(a.v_ned) for a in snapshot.traffic]
            ages_s = np.concatenate((ages_s, [a.age_s + period_s for a in snapshot.traffic]))
        table[:, NORTH : DOWN + 1] = at_ned
        ranges_m = widened_range(self._rules.repulsion_range_m, speeds, ages_s)
        return table, SAFE_RANGE_SHARE * ranges_m if self._rules.safety else ranges_m

    def _radius_m(self, role: str) -> float:
        separation_m, ring_m = self._rules.separation_m, self.scenario.formation.ring_m
        if role != "target" or ring_m is None:
            return separation_m
        return min(max(ring_m - self._rules.repulsion_range_m, 0.0), separation_m)

    def exempt(
        self, part: LedPart, team: Team, snapshot: FleetSnapshot, rendezvous: Mapping[int, int]
    ) -> tuple[NDArray[np.bool_], bool]:
        """Others that each leader need not keep away from (itself, partners of a transfer, its target, and what
        attracts it), and whether these are all."""
        callsigns = [aircraft.callsign for aircraft in snapshot.traffic] if snapshot.traffic else []
        pairs = tuple(rendezvous.items()) if rendezvous else ()
        known = self._exempted.get(part.role)
        if known is not None and known.team is team and (known.callsigns, known.pairs) == (callsigns, pairs):
            return known.of_each, known.everyone
        others = team.flying
        exempt = np.zeros((len(part.rows), len(others) + len(callsigns)), np.bool_)
        flying, of_other = exempt[:, : len(others)], self.roles[others]
        flying |= not self._rules.vehicles_repel
        flying |= part.rows[:, np.newaxis] == others
        if part.role == "target":
            flying |= of_other != "target"
        elif part.role == "pursuer":
            exempt[:, len(others) :] = [callsign in self._attracting for callsign in callsigns]
            if self.scenario.formation.ring_m is None:
                flying |= of_other == "target"
        rows = {sysid: i for i, sysid in enumerate(part.sysids)}
        columns = {sysid: j for j, sysid in enumerate(team.flying_sysids)}
        for pair in pairs:
            for one, other in (pair, pair[::-1]):
                if one in rows and other in columns:
                    exempt[rows[one], columns[other]] = True
        known = self._exempted[part.role] = _Exempted(team, callsigns, pairs, exempt, bool(exempt.all()))
        return known.of_each, known.everyone


def ahead(p_ned: Vec3, v_ned: Vec3, time_s: float = LOOKAHEAD_S) -> Vec3:
    """Place of something that flies straight on for a time, m."""
    return (p_ned[0] + v_ned[0] * time_s, p_ned[1] + v_ned[1] * time_s, p_ned[2] + v_ned[2] * time_s)
