"""Goal monitor: measures the goal each tick from telemetry, and at the end from the vehicles' truth files.

Vehicles that count (docs/protocol/result.md#goal):
- separation: two vehicles in flight of which we fly at least one. One that another flies (taken over, in an
  operator's hands, on its failsafe) gives no way; near it counts only where ours closes in.
- obstacles, traffic: vehicles in flight that we fly.
- ground: vehicles that we fly and that were up, which follow set points; not while they take off, land or stand at a
  base.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence, Set
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from gcs.mavlink.autopilots import STEERABLE, FlightMode
from gcs.mavlink.ids import TRAFFIC
from gcs.recording import truth
from gcs.recording.silent_ends import TrueEnd, returns_after_s, true_end
from gcs.scenario import goal
from gcs.scenario.goal import Judgement, Loss, Measured
from gcs.scenario.model import Scenario
from gcs.scenario.parts.world import Worlds
from gcs.supervisor.arming import CUT_OFF_S, ArmingSequence, Stage
from gcs.supervisor.fleet_arming import FleetArming
from gcs.telemetry.approach import Floats
from gcs.telemetry.changes import GOING_DOWN
from gcs.telemetry.events import Event
from gcs.telemetry.proximity import PRESENT, Airspace, Breach, Places, Proximity, WayPoints
from gcs.telemetry.state import STALE_S, FleetSnapshot, TrafficView, Vec3, VehicleView
from skytender.safety.patrol import patrol

Notices = tuple[list[dict[str, Any]], list[Event]]
"""Records and events."""
UP_M = 0.3
"""A vehicle that has been so high must not touch the ground until it lands."""
NEVER_FLEW_S = 10.0
"""A vehicle that is not in the air so long after it joined has never taken part."""
BOOTED = "it booted in flight"
_OTHERS = frozenset({Stage.YIELDED, Stage.TAKEN, Stage.DOWN})
_STEERED = frozenset({Stage.OFFBOARD, Stage.FLY})


class GoalWatch:
    """All that is measured for the goal, and what of it has been reported."""

    def __init__(self, scenario: Scenario, shapes: Floats, arming: FleetArming) -> None:
        self._scenario = scenario
        """by which the goal is judged"""
        self._worlds = [(-math.inf, scenario, shapes)]
        """(since when, with which obstacles, their table)"""
        self._fleet_arming, self._arming = arming, arming.sequences
        self._asked = goal.asked(scenario)
        self._vehicles = scenario.vehicles.all
        self._rows = {vehicle.sysid: row for row, vehicle in enumerate(self._vehicles)}
        self.believed = self.judged = Proximity(scenario, shapes)
        self.from_truth = False
        self._waypoints = WayPoints(scenario)
        self._number = -1
        """of the last snapshot"""
        self._restless: set[int] = set()
        """vehicles to look at again though nothing of them changes but figures"""
        count = len(self._vehicles)
        self._flying, self._ours_now, self._up, self._flew = ([False] * count for _ in range(4))
        self._counts = [False] * count
        """whose place counts: they fly, and their places are fresh"""
        self._by_failsafe = [False] * count
        """whether each flies by its failsafe, and passes no way points"""
        self._returns_after_s = returns_after_s(scenario)
        self._came_down_s: dict[int, float] = {}
        """when each that flies no more, as it said itself, flew last"""
        self._true_ends: dict[int, TrueEnd] = {}
        """of vehicles that were silent at the end, or stood and were to rejoin"""
        self._all_count = False
        self._some_up = False
        self._unknown_m = np.full(count, np.nan)
        self._exempted: list[tuple[int, int]] = []
        self._parting_s = goal.parting_s(scenario)
        self._partners: dict[tuple[int, int], float] = {}
        self._airspace: Airspace | None = None
        """None where it has changed"""
        self._uncounted = np.empty(0, np.bool_)
        self._log: list[tuple[float, Airspace]] = []
        """of each tick: time, and vehicles that count"""
        self._external_p_ned: list[Floats] = []
        whole = scenario.truth and scenario.record.truth_hz is None  # a record at every tick
        self._keeps_log = whole and bool(scenario.vehicles.launched)
        self._ours = np.array([vehicle.external is None for vehicle in self._vehicles], dtype=np.bool_)
        self._has_external = not self._ours.all()
        self._lost: dict[int, Loss] = {}
        self._leaves_hold: set[int] = set()
        """those that an operator ordered to hold and that their failsafe takes down"""
        self._came_down_by: dict[int, tuple[bool, bool]] = {}
        """what each one's autopilot said last in its flight: whether a failsafe flies it, and whether it goes down; one
        that stands says neither any more"""
        self._fell: dict[int, Loss] = {}
        """vehicles that touched the ground in flight, which is no loss by itself"""
        self._reported: set[tuple[Any, ...]] = set()
        self.breaches: list[dict[str, Any]] = []
        """those by reports of which it can be seen how they go on"""
        self.late: list[tuple[float, str]] = []
        """when a planner or policy of the user's did not answer in time or its process ended, and how"""

    # in flight

    def surround(self, now_s: float, worlds: Worlds, shapes: Floats) -> None:
        """Measure from now on in the last of the worlds; `shapes`: table of its obstacles."""
        self._scenario = worlds.judged
        self._asked = goal.asked(self._scenario)
        self._worlds.append((now_s, worlds.now, shapes))
        self.believed.surround(worlds.now, shapes)

    def update(self, snapshot: FleetSnapshot, partners: Collection[tuple[int, int]]) -> Notices:
        """Count one tick; records and events of what has just been broken."""
        now_s, columns = snapshot.time_s, snapshot.columns
        new, p_ned, height_m = columns.changed_since(self._number), columns.p_now_ned, self._unknown_m
        self._number = columns.number
        looked_at = self._restless.union(new, self._fleet_arming.moved)
        if looked_at or self._some_up:
            height_m = columns.ground_down_m - p_ned[:, 2]
            for sysid in sorted(looked_at):
                self._look_at(snapshot.vehicle(sysid), height_m, now_s)
        airspace = self._airspace
        if airspace is None or partners or self._partners:
            airspace = self._airspace_of(self._exempt(partners, now_s))
        if not self._all_count:
            p_ned = p_ned.copy()
            p_ned[self._uncounted] = np.nan
        if self._keeps_log:
            self._log.append((now_s, airspace))
            if self._has_external:
                self._external_p_ned.append(p_ned[~self._ours].astype(np.float32))
        traffic = {aircraft.callsign: _now(aircraft) for aircraft in snapshot.traffic}
        places = Places(p_ned, height_m, traffic)
        self._waypoints.update(p_ned, airspace.by_failsafe)
        breaches = self.believed.update(now_s, airspace, places)
        return self._notices_of(now_s, breaches, "reports") if breaches else ([], [])

    def _look_at(self, view: VehicleView, height_m: Floats, now_s: float) -> None:
        """See what of a vehicle counts, and that its height does only where it does."""
        row, arming = self._rows[view.sysid], self._arming[view.sysid]
        was = self._flying[row], self._ours_now[row], self._up[row], self._counts[row], self._by_failsafe[row]
        flies, ours, counts, above_m, rising = view.flying, False, False, math.nan, False
        measured = flies or self._up[row]
        if measured:
            self._flew[row] = True
            by_failsafe = view.mode in GOING_DOWN and arming.stage is not Stage.BASE and not arming.grounded
            ours = arming.stage not in _OTHERS and not by_failsafe
            if view.p_ned is not None and view.fresh:
                counts, above_m = flies, float(height_m[row])
            above_m, rising = self._see_height(row, view, arming, above_m)
        height_m[row] = above_m
        if self._flying[row] and not flies:
            self._came_down_s[view.sysid] = now_s
        if flies:
            self._came_down_by[view.sysid] = view.failsafe, view.mode in GOING_DOWN
        self._flying[row], self._ours_now[row], self._counts[row] = flies, ours, counts
        self._by_failsafe[row] = flies and self._failsafe_flies(row, view, arming, now_s)
        if was != (flies, ours, self._up[row], counts, self._by_failsafe[row]):
            self._airspace = None
        self._see_loss(view, arming, now_s)
        unsettled = rising or (measured and not (flies and view.fresh))
        if unsettled or (view.alive and view.sysid in self._lost):
            self._restless.add(view.sysid)
        else:
            self._restless.discard(view.sysid)

    def _airspace_of(self, exempt: list[tuple[int, int]]) -> Airspace:
        """The last one while nothing has changed, as at nearly every tick."""
        if self._airspace is None or exempt != self._exempted:
            self._exempted = exempt
            flags = (self._flying, self._ours_now, self._up, self._by_failsafe)
            flying, ours, up, by_failsafe = (np.array(each, dtype=np.bool_) for each in flags)
            self._some_up = any(self._up)
            pairs = np.array(exempt, dtype=np.int64).reshape(-1, 2)
            self._airspace = Airspace(flying, ours, up, pairs, by_failsafe)
            self._uncounted, self._all_count = ~np.array(self._counts, dtype=np.bool_), all(self._counts)
        return self._airspace

    def _failsafe_flies(self, row: int, view: VehicleView, arming: ArmingSequence, now_s: float) -> bool:
        """Whether the failsafe of a vehicle in flight flies it: it says so, or has been silent until that begins."""
        if arming.released or arming.ordered not in (None, "hold"):
            return False
        if view.silent_s(now_s) >= self._returns_after_s.get(view.sysid, math.inf):
            return True
        to_land = arming.grounded or arming.stage is Stage.BASE
        by_itself = not self._vehicles[row].is_foreign or view.failsafe
        return by_itself and view.mode in GOING_DOWN and not to_land

    def _see_height(self, row: int, view: VehicleView, arming: ArmingSequence, height_m: float) -> tuple[float, bool]:
        """Whether it is up, and must not touch the ground; one that says it has landed touches it. Its height, m, NaN
        where that is not known; and whether it may be up a moment later."""
        follows = arming.stage in _STEERED and view.mode in STEERABLE and view.alive and view.armed
        follows = follows and view.age_s <= CUT_OFF_S  # else its failsafe may be landing it
        follows = follows and not arming.booted  # it may have said that it has landed before its mode
        if not follows or self._vehicles[row].airborne or arming.grounded:
            self._up[row] = False
        elif self._up[row] and view.landed:
            return (min(0.0, height_m) if not math.isnan(height_m) else 0.0), False
        elif not view.landed:
            self._up[row] = self._up[row] or height_m >= UP_M
            return height_m, not self._up[row]
        return height_m, False

    def _exempt(self, partners: Collection[tuple[int, int]], now_s: float) -> list[tuple[int, int]]:
        """Rows of pairs that may come near each other: partners, also over the interval in which they cease to be."""
        kept = {pair: until_s for pair, until_s in self._partners.items() if until_s >= now_s - 1e-9}
        period_s = self._scenario.clock.period_s
        for a, b in partners:
            kept[min(a, b), max(a, b)] = now_s + period_s + self._parting_s
        self._partners = kept
        return [(self._rows[a], self._rows[b]) for a, b in sorted(kept) if a in self._rows and b in self._rows]

    def _see_loss(self, view: VehicleView, arming: ArmingSequence, now_s: float) -> None:
        loss = self._lost.get(view.sysid)
        if loss is None:
            if why := self._why_lost(view, arming):
                self.lose(view.sysid, now_s, why)
        elif view.alive and arming.stage is Stage.FLY and view.remaining_j > 0.0:
            del self._lost[view.sysid]

    def _why_lost(self, view: VehicleView, arming: ArmingSequence) -> str:
        """Why a vehicle counts as lost from now on; empty where it does not.

        An order to land or return explains a landing, an order to hold does not. No order explains a battery that is
        empty in flight.
        """
        by_itself = not self._vehicles[self._rows[view.sysid]].is_foreign or view.failsafe
        if arming.ordered != "hold" or (view.flying and view.mode not in GOING_DOWN):
            self._leaves_hold.discard(view.sysid)
        elif view.flying and by_itself:
            self._leaves_hold.add(view.sysid)
        if view.alive and _fell(view, arming) and (arming.stage is Stage.DOWN or arming.ordered == "hold"):
            return BOOTED
        failsafe, _ = self._came_down_by.get(view.sysid, (False, False))
        if view.alive and arming.stage is Stage.DOWN and (by_itself or failsafe or arming.left_out):
            return "left out" if arming.left_out else self._how_down(view)
        if view.alive and view.landed and view.sysid in self._leaves_hold:
            return "landed by itself"
        empty = view.battery_reported and view.energy_source != "none" and view.remaining_j <= 0.0
        return "its battery is empty" if empty and (arming.ordered is None or view.flying) else ""

    def _how_down(self, view: VehicleView) -> str:
        """How a vehicle came out of our hands that takes no more part."""
        if view.flying:
            return f"its failsafe flies it ({view.mode_name})"
        _, went_down = self._came_down_by.get(view.sysid, (False, False))
        fell = self._flew[self._rows[view.sysid]] and not went_down and view.mode not in GOING_DOWN
        return "crashed, or disarmed in flight" if fell else "landed by itself"

    def lose(self, sysid: int, t_s: float, why: str) -> None:
        """Count a vehicle as lost, or the traffic, 255; what it was lost by first stays."""
        self._lost.setdefault(sysid, Loss(sysid, t_s, why))
        if sysid in self._rows:
            self._restless.add(sysid)

    def find(self, sysid: int) -> None:
        """A vehicle that was lost is there again."""
        self._lost.pop(sysid, None)
        self._restless.add(sysid)

    @property
    def lost(self) -> Set[int]:
        """System ids of the vehicles that count as lost now."""
        return self._lost.keys()

    def losses(self, snapshot: FleetSnapshot, end_s: float) -> list[Loss]:
        """Vehicles lost by now, in order of time; with those that never flew, and those on their failsafe's way
        down."""
        lost = dict(self._lost)
        for row, view in enumerate(snapshot.vehicles):
            if view.sysid not in lost and (found := self._lost_at_end(row, view, end_s)) is not None:
                lost[view.sysid] = Loss(view.sysid, *found)
        return _in_order(lost.values())

    def _lost_at_end(self, row: int, view: VehicleView, end_s: float) -> tuple[float, str] | None:
        """When and why a vehicle that is not lost yet was lost if the session ends now; None where it was not."""
        vehicle, arming = self._vehicles[row], self._arming[view.sysid]
        held = arming.ordered == "hold"
        if not view.alive or (arming.ordered is not None and not held):
            return None
        if not held:
            if not self._flew[row] and arming.stage is not Stage.BASE and end_s - vehicle.join_s >= NEVER_FLEW_S:
                return end_s, "never in the air"
            if view.doubt:
                return end_s, f"it is not believed: {view.doubt}"
            if arming.rejoining and not view.flying:
                return self._landed_s(view.sysid, end_s), BOOTED if _fell(view, arming) else "landed by itself"
        if (in_silence := self._lost_in_silence(view, arming, end_s)) is not None:
            return in_silence
        by_itself = not vehicle.is_foreign or view.failsafe
        ours = held or arming.stage in (*_STEERED, Stage.MISSION, Stage.YIELDED)
        taken_down = ours and by_itself and view.flying and view.mode in GOING_DOWN
        return (end_s, f"its failsafe flies it ({view.mode_name})") if taken_down else None

    def _landed_s(self, sysid: int, end_s: float) -> float:
        """When a vehicle landed that stands at the end: by its truth, or else when it said so."""
        end = self._true_ends.get(sysid)
        said_s = self._came_down_s.get(sysid, end_s)
        return said_s if end is None or end.landed_s is None else end.landed_s

    def _lost_in_silence(self, view: VehicleView, arming: ArmingSequence, end_s: float) -> tuple[float, str] | None:
        """When and why a launched vehicle was lost that flew when it was last received; None where it was not.

        Its last report does not say how it ended: its truth does, and where there is none, its failsafe's delay. The
        same holds where its places come again, and its HEARTBEAT does not yet.
        """
        silent_s, to_land = view.silent_s(end_s), arming.grounded or arming.stage is Stage.BASE
        received = silent_s <= STALE_S
        flew = view.flying or (not view.mode_known and arming.stage in _STEERED)
        if view.sysid not in self._returns_after_s or not flew or (received and view.mode_known):
            return None
        if arming.released or arming.stage is Stage.YIELDED or (to_land and view.mode is FlightMode.LAND):
            return None
        since_s = end_s - silent_s
        returns_s, why = since_s + self._returns_after_s[view.sysid], f"no telemetry since {since_s:.1f} s"
        by_itself = "landed by itself" if received else f"{why}, landed by itself"
        end = self._true_ends.get(view.sysid)
        if end is not None and end.landed_s is not None:
            ordered = end.landed_s < returns_s and (to_land or arming.stage is Stage.MISSION)
            return None if ordered else (end.landed_s, by_itself)
        if received or end_s < returns_s:
            return None
        return end_s, f"{why}, its failsafe flies it" if end is not None and end.t_s >= returns_s else why

    def harmed(self, snapshot: FleetSnapshot, end_s: float) -> list[Loss]:
        """Vehicles lost by now, and those that touched the ground in flight; each once."""
        return list((self._fell | {loss.sysid: loss for loss in self.losses(snapshot, end_s)}).values())

    def new_losses(self, now_s: float) -> Notices:
        """Records and events of those losses that are more than the goal allows, once each."""
        if len(self._lost) <= self._asked["lost"]:
            return [], []
        records = []
        for loss in _in_order(self._lost.values()):
            if (key := ("lost", loss.sysid, loss.t_s)) not in self._reported:
                self._reported.add(key)
                text = f"{self._label(loss.sysid)} is lost: {loss.why}"
                records.append(self._record(now_s, "lost", "reports", loss.t_s, (loss.sysid,), "", 1.0, text))
        return records, [_event(record) for record in records]

    # at the end

    def judge_truth(self, folder: Path, snapshot: FleetSnapshot) -> Notices:
        """Judge again by the vehicles' own truth, where they left it; what only that shows. snapshot: the last one."""
        now_s = snapshot.time_s
        self._see_true_ends(folder, snapshot)
        if not self._log:
            return [], []
        tables = {
            row: truth.read(folder, vehicle.sysid) for row, vehicle in enumerate(self._vehicles) if self._ours[row]
        }
        if not tables or any(table is None for table in tables.values()):
            return [], []
        ticks = np.array([t_s for t_s, _ in self._log])
        (_, first, shapes), *later = self._worlds
        judged, waypoints = Proximity(first, shapes), WayPoints(first)
        breaches: list[Breach] = []
        shape = (len(ticks), len(self._vehicles), 3)
        p_ned, v_ned = np.full(shape, np.nan), np.zeros(shape)
        for row, table in tables.items():
            assert table is not None
            k = np.searchsorted(table[:, 0], ticks - 1e-4)
            there = k < len(table)
            there[there] = np.abs(table[k[there], 0] - ticks[there]) < 1e-4
            p_ned[there, row], v_ned[there, row] = table[k[there], 1:4], table[k[there], 4:7]
        if self._external_p_ned:
            p_ned[:, ~self._ours], v_ned[:, ~self._ours] = self._external_p_ned, np.nan
        for tick, (t_s, airspace) in enumerate(self._log):
            in_flight = np.where(airspace.flying[:, None], p_ned[tick], np.nan)
            waypoints.update(in_flight, airspace.by_failsafe)
            height_m = 0.0 - p_ned[tick, :, 2]
            places = Places(p_ned[tick], height_m, self._true_traffic(t_s), v_ned[tick])
            breaches += judged.update(t_s, airspace, places)
            while later and later[0][0] <= t_s:
                judged.surround(*later.pop(0)[1:])
        self.judged, self._waypoints, self.from_truth = judged, waypoints, True
        return self._notices_of(now_s, breaches, "truth")

    def _see_true_ends(self, folder: Path, snapshot: FleetSnapshot) -> None:
        """Read how those ended whose last reports do not say it, or not when."""
        for view, vehicle in zip(snapshot.vehicles, self._vehicles, strict=True):
            unknown = view.silent_s(snapshot.time_s) > STALE_S or not view.mode_known
            asked = unknown if view.flying else self._arming[view.sysid].rejoining or not view.mode_known
            end = (
                true_end(folder, view.sysid, airborne=vehicle.airborne) if asked and vehicle.external is None else None
            )
            if end is not None:
                self._true_ends[view.sysid] = end

    def _true_traffic(self, t_s: float) -> dict[str, Vec3]:
        """Places of the scenario's traffic, as long as its process lived."""
        died = self._lost.get(TRAFFIC[0])
        movers = self._scenario.traffic if died is None or t_s < died.t_s else ()
        return {
            mover.callsign: patrol(mover.path_m, mover.speed_m_s, t_s, closed=mover.closed, start_s=mover.start_s)[0]
            for mover in movers
        }

    def measured(self, snapshot: FleetSnapshot, *, time_s: float, pursuit_held_s: float, refuelled: int) -> Measured:
        """All figures, by truth once that has been judged."""
        return replace(
            self._measured(self.losses(snapshot, time_s)),
            time_s=time_s,
            missed=self._waypoints.missed,
            pursuit_held_s=pursuit_held_s,
            refuelled=refuelled,
        )

    def broken(self) -> list[Judgement]:
        """Parts of the goal that can no longer be met, by what is known now."""
        so_far = self._measured(_in_order(self._lost.values()))
        return [judged for judged in goal.judge(self._scenario, so_far) if judged.met is False]

    def _measured(self, lost: list[Loss]) -> Measured:
        near = self.judged
        return Measured(
            separation=near.separation,
            clearance=near.clearance,
            traffic=near.traffic,
            ground=near.ground,
            lost=lost,
            late=self.late,
        )

    # reports

    def _notices_of(self, now_s: float, breaches: Sequence[Breach], by: str) -> Notices:
        records = []
        for breach in breaches:
            near = breach.nearest
            if breach.part == "ground":
                for sysid in near.sysids:
                    self._fell.setdefault(sysid, Loss(sysid, near.t_s, "it touches the ground"))
            key = (breach.part, near.sysids, near.what)
            if key not in self._reported:
                self._reported.add(key)
                text = self._sentence(breach, self._asked[breach.part])
                if by == "truth":
                    text += f" at {near.t_s:.1f} s, by their own truth"
                records.append(self._record(now_s, breach.part, by, near.t_s, near.sysids, near.what, near.m, text))
                if by == "reports" and breach.part in PRESENT:
                    self.breaches.append(records[-1])
        return records, [_event(record) for record in records]

    def _sentence(self, breach: Breach, limit: float) -> str:
        near = breach.nearest
        who = " and ".join(self._label(sysid) for sysid in near.sysids)
        if breach.part == "ground":
            return f"{who} touches the ground"
        if breach.part == "separation":
            return f"{who} are {goal.metres(near.m, limit)} apart; the goal wants {limit:g} m"
        return f"{who} is {goal.metres(near.m, limit)} from {near.what}; the goal wants {limit:g} m"

    def _record(
        self, t_s: float, part: str, by: str, at_s: float, sysids: tuple[int, ...], what: str, value: float, text: str
    ) -> dict[str, Any]:
        about = {"part": part, "by": by, "at_s": at_s, "sysids": list(sysids), "what": what}
        return {"t_s": t_s, "kind": "violation", **about, "value": value, "limit": self._asked[part], "text": text}

    def _label(self, sysid: int) -> str:
        row = self._rows.get(sysid)
        return "traffic" if row is None else self._vehicles[row].label


def _fell(view: VehicleView, arming: ArmingSequence) -> bool:
    """Whether a boot has let it fall, which is no pilot's doing."""
    return arming.booted and not view.flying


def _now(aircraft: TrafficView) -> Vec3:
    (n, e, d), (vn, ve, vd), age_s = aircraft.p_ned, aircraft.v_ned, aircraft.age_s
    return (n + vn * age_s, e + ve * age_s, d + vd * age_s)


def _in_order(losses: Iterable[Loss]) -> list[Loss]:
    return sorted(losses, key=lambda loss: (loss.t_s, loss.sysid))


def _event(record: Mapping[str, Any]) -> Event:
    return Event(record["t_s"], record["sysids"][0], "critical", record["text"], "violation")
