"""Vehicles on missions: begun when all are in the air, watched item by item, held and let go on, until the last item.

    waits for its turn → flies ⇄ holds → (steps aside) → flies … → flown: led by set points like all others

Who has to wait is a law (gcs/planner/mission_holds.py); the arming sequences command it. A mission is flown when its
last item is reached. Before it begins its first item is made the present one, for the autopilot may remember another
from a flight before. While an operator, a pilot or a failsafe flies it, nothing is asked of it; afterwards it goes on
with the item that it was at.
"""

from __future__ import annotations

import math
from collections.abc import Container, Iterable, Mapping
from typing import Any

import numpy as np

from gcs.mavlink import codec
from gcs.mavlink.autopilots import STEERABLE, FlightMode
from gcs.mavlink.codec import Frame, Message, message
from gcs.mavlink.ids import AUTOPILOT
from gcs.planner.mission_holds import CLEAR_S, FOREIGN, NOWHERE, OURS, MissionVerdict, OnMission, Other, braking, judge
from gcs.refuelling.participation import Participation
from gcs.scenario.model import Pursuer, Scenario
from gcs.scenario.parts.mission import FlownItem, items_of
from gcs.supervisor.arming import ArmingSequence, Mission, Stage
from gcs.telemetry.state import FleetSnapshot, Vec3, VehicleView
from skytender import elementary
from skytender import mavlink as mav
from skytender.geometry import FloatArray

FIRST_TRIES, FIRST_EVERY_S = 3, 1.0
"""How often the first item is asked for where no MISSION_CURRENT says that it is the present one."""
COMPLETE = 5
"""MISSION_STATE_COMPLETE"""
SETTLES_S, STILL_M_S = 3.0, 0.2
"""[choice] One that holds and has been so slow for so long keeps its place: an autopilot that is to come back
to another does so at once."""
_FLYING = frozenset({Stage.OFFBOARD, Stage.FLY, Stage.MISSION})
_CURRENT, _REACHED = codec.msgid("MISSION_CURRENT"), codec.msgid("MISSION_ITEM_REACHED")
_ROUNDING_S = 1e-6


class MissionFlight:
    """One vehicle's mission."""

    def __init__(self, vehicle: Pursuer, scenario: Scenario) -> None:
        self.sysid = vehicle.sysid
        self.items: tuple[FlownItem, ...] = items_of(vehicle)
        self.last = max(k for k, item in enumerate(self.items) if item.command != mav.MAV_CMD_DO_CHANGE_SPEED)
        """index of the last item that is reached"""
        self.stopping = FOREIGN if vehicle.is_foreign else OURS
        o = scenario.origin
        self.origin = o.lat_deg, o.lon_deg, o.alt_m
        self.said: list[Any] = []
        """fields of what it has said of its mission since the last tick"""
        self.index, self.index_known = 0, False
        """of the item that it flies, and whether it has said which that is"""
        self.reached: set[int] = set()
        self.begun = self.done = self.complete = False
        self.tries, self.tried_s = 0, -math.inf
        self.waits_for = ""
        self.clear_since_s = self.held_since_s = self.done_s = math.nan
        self.holds, self.held_s = 0, 0.0
        self.cruise_m_s = 0.0
        """its greatest speed so far"""
        self.held_ned = NOWHERE
        """(k, 3) m NED where it may come back to while it holds"""
        self.moved_s = math.nan
        """when it has moved last"""

    def settle(self, view: VehicleView, now_s: float) -> None:
        """While it holds, see where it has come to stand: it comes back to no other place then."""
        if not len(self.held_ned) or elementary.norm(view.v_ned) >= STILL_M_S:
            self.moved_s = now_s
        elif now_s - self.moved_s >= SETTLES_S - _ROUNDING_S:
            self.held_ned = np.array([view.p_now_ned()])

    def listen(self, first: int) -> None:
        """Take in what it has said; `first` is its number of the first item."""
        for content in self.said:
            index = content.seq - first
            if hasattr(content, "mission_state"):
                self.index, self.index_known = max(index, 0), True
                self.complete = self.begun and content.mission_state == COMPLETE and index >= self.last
            elif self.begun and 0 <= index < len(self.items):
                self.reached.add(index)
                self.index = max(self.index, index + 1)
        self.said.clear()

    def ahead(self, view: VehicleView) -> tuple[Vec3, ...]:
        """Places of the items that are left, from where it is."""
        here, home_down_m = view.p_now_ned(), view.ground_down_m or 0.0
        places = []
        for item in self.items[self.index :]:
            if (place := item.place_ned(self.origin, home_down_m)) is not None:
                here = (here[0], here[1], min(here[2], place[2])) if math.isnan(place[0]) else place
                places.append(here)
        return tuple(places)


class MissionWatch:
    """All missions of a session."""

    def __init__(self, scenario: Scenario, arming: Mapping[int, ArmingSequence], participation: Participation) -> None:
        """A vehicle takes no part in refuelling until its mission is flown."""
        self.flights = {p.sysid: MissionFlight(p, scenario) for p in scenario.vehicles.on_missions}
        self._arming, self._participation = arming, participation
        self._separation_m = scenario.planner.separation_m
        self._records: list[dict[str, Any]] = []
        self.claims: dict[int, FloatArray] = {}
        """(k, 3) m NED where the others must not be, by system id"""
        self.turned: list[int] = []
        """system ids of vehicles that are to do something else than at the last tick"""
        for sysid in self.flights:
            participation.change("mission", sysid)

    @property
    def missed(self) -> dict[int, int]:
        """Number of items that each has not reached yet, by system id."""
        return {k: 0 if one.done else max(len(one.items) - one.index, 1) for k, one in self.flights.items()}

    def item(self, sysid: int) -> int | None:
        """Number of the item that a vehicle flies, from 1; None where it has no mission."""
        flight = self.flights.get(sysid)
        return None if flight is None else min(flight.index, len(flight.items) - 1) + 1

    def note(self, sysid: int) -> str:
        """How far a vehicle's mission is, for people; empty where it has none."""
        flight = self.flights.get(sysid)
        if flight is None:
            return ""
        count = len(flight.items)
        if flight.done:
            return f"mission flown, {count} items"
        waits = f", waits for {flight.waits_for}" if flight.waits_for else ""
        return f"mission item {self.item(sysid)} of {count}{waits}"

    def pop_records(self) -> list[dict[str, Any]]:
        """Records since the last call, as decisions."""
        taken, self._records = self._records, []
        return taken

    def receive(self, delivered: Mapping[int, Iterable[Frame]]) -> None:
        """Keep what vehicles say of their missions."""
        for sysid, flight in self.flights.items():
            flight.said += [
                codec.fields(frame)
                for frame in delivered.get(sysid, ())
                if frame.msgid in (_CURRENT, _REACHED) and (frame.sysid, frame.compid) == (sysid, AUTOPILOT)
            ]

    def decide(self, snapshot: FleetSnapshot, *, may_begin: bool) -> dict[int, list[Message]]:
        """Let missions begin, wait and go on; messages by system id. `may_begin`: all are in the air."""
        self.turned = []
        flying: list[OnMission] = []
        for sysid, flight in self.flights.items():
            view, arming = snapshot.vehicle(sysid), self._arming[sysid]
            flight.listen(int(view.profile.plans.begin_with_home))
            if flight.begun and not flight.done and (flight.complete or flight.last in flight.reached):
                self._end(flight, snapshot.time_s)
            if not flight.done and view.flying and arming.stage in _FLYING:
                flight.settle(view, snapshot.time_s)
                flying.append(_on_mission(flight, view, arming))
            else:
                flight.waits_for = ""
        verdicts = judge(flying, _others(snapshot, {one.sysid for one in flying}), self._separation_m)
        self.claims = {sysid: verdict.claim_ned for sysid, verdict in verdicts.items() if len(verdict.claim_ned)}
        messages = {}
        for one, (sysid, verdict) in zip(flying, verdicts.items(), strict=True):
            self._turn(self.flights[sysid], one, verdict, snapshot.time_s, may_begin=may_begin)
            if may_begin and not verdict.waits_for and not self.flights[sysid].begun:
                messages[sysid] = self._begin(self.flights[sysid], snapshot.vehicle(sysid), snapshot.time_s)
        return messages

    def _turn(
        self, flight: MissionFlight, one: OnMission, verdict: MissionVerdict, now_s: float, *, may_begin: bool
    ) -> None:
        """Let one that has begun hold, step aside or go on."""
        mission = self._arming[flight.sysid].mission
        if verdict.waits_for and flight.begun and mission == "fly":
            flight.holds, flight.held_since_s = flight.holds + 1, now_s
            self._order(flight, "hold", "held", now_s, verdict.waits_for)
            flight.held_ned = braking(one)
        elif verdict.waits_for and mission == "hold" and verdict.aside:
            self._order(flight, "", "steps aside", now_s, verdict.waits_for)
        if verdict.waits_for or mission == "fly":
            flight.clear_since_s = math.nan
            flight.waits_for = verdict.waits_for if may_begin else ""
            return
        if math.isnan(flight.clear_since_s):
            flight.clear_since_s = now_s
        if flight.begun and now_s - flight.clear_since_s >= CLEAR_S - _ROUNDING_S:
            flight.held_s += now_s - flight.held_since_s
            flight.held_since_s = math.nan
            flight.waits_for = ""
            self._order(flight, "fly", "goes on", now_s)

    def _begin(self, flight: MissionFlight, view: VehicleView, now_s: float) -> list[Message]:
        """Begin with the first item, once that is the present one."""
        if self._arming[flight.sysid].stage is not Stage.FLY:
            return []
        there = flight.index_known and flight.index == 0
        if there or (flight.tries >= FIRST_TRIES and now_s - flight.tried_s >= FIRST_EVERY_S - _ROUNDING_S):
            flight.begun, flight.index = True, 0
            self._order(flight, "fly", "begins", now_s)
        elif now_s - flight.tried_s >= FIRST_EVERY_S - _ROUNDING_S:
            flight.tries, flight.tried_s = flight.tries + 1, now_s
            first = int(view.profile.plans.begin_with_home)
            to = {"target_system": flight.sysid, "target_component": AUTOPILOT}
            return [message("MISSION_SET_CURRENT", **to, seq=first)]
        return []

    def _end(self, flight: MissionFlight, now_s: float) -> None:
        flight.done, flight.done_s, flight.waits_for = True, now_s, ""
        self._order(flight, "", "flown", now_s)
        self._participation.change("mission flown", flight.sysid)

    def _order(self, flight: MissionFlight, mission: Mission, state: str, now_s: float, waits_for: str = "") -> None:
        self._arming[flight.sysid].go_on_mission(mission)
        flight.held_ned = NOWHERE
        self.turned.append(flight.sysid)
        item = min(flight.index, len(flight.items) - 1) + 1
        why = {"by": waits_for} if waits_for else {}
        about = {"sysid": flight.sysid, "state": state, "item": item, "of": len(flight.items), **why}
        self._records.append({"t_s": now_s, "kind": "mission", **about})


def _on_mission(flight: MissionFlight, view: VehicleView, arming: ArmingSequence) -> OnMission:
    ordered = arming.stage is Stage.MISSION and arming.mission == "fly"
    goes = flight.begun and (ordered or view.mode is FlightMode.MISSION)
    led = view.mode in STEERABLE and not goes
    if goes:
        flight.cruise_m_s = max(flight.cruise_m_s, elementary.norm(view.v_ned))
    place, ahead = view.p_now_ned(), flight.ahead(view)
    reckoned = flight.stopping, flight.cruise_m_s, flight.held_ned
    return OnMission(view.sysid, view.label, place, view.v_ned, ahead, goes, led, *reckoned)


def _others(snapshot: FleetSnapshot, on_missions: Container[int]) -> list[Other]:
    """Vehicles in the air that are on no mission, and aircraft."""
    flying = (view for view in snapshot.vehicles if view.flying and view.sysid not in on_missions)
    found = [Other(view.label, view.p_now_ned(), view.v_ned) for view in flying]
    for aircraft in snapshot.traffic:
        (n, e, d), (v_n, v_e, v_d), age_s = aircraft.p_ned, aircraft.v_ned, aircraft.age_s
        place = (n + age_s * v_n, e + age_s * v_e, d + age_s * v_d)
        found.append(Other(f"traffic {aircraft.callsign}", place, aircraft.v_ned))
    return found
