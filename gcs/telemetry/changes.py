"""Detector of vehicle events from snapshots: modes, failsafes, loss and return of telemetry, of places, of belief.

That a vehicle is silent and that its position is old are two facts: positions may stop, or come seldom, of a vehicle
that is heard all the time. Of one that is silent only the silence is reported.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from gcs.mavlink.autopilots import STEERABLE, End, FlightMode
from gcs.telemetry.events import Event
from gcs.telemetry.health import flies_as_ordered
from gcs.telemetry.state import STALE_S, FleetSnapshot, VehicleView

RECEIVED_WITHIN_S = 1.0
"""[choice] A vehicle of which anything has come within so long is received, though its place is old."""
REGULAR_S = 5.0
"""Positions come again when none has been old for so long: of a slow stream each one would begin anew."""
NO_TELEMETRY = "No telemetry for"
"""How the event of a silence begins."""
GOING_DOWN = frozenset({FlightMode.RETURN, FlightMode.LAND})


class _FlownMode(NamedTuple):
    """A mode as it was flown: HEARTBEAT's number changes also between two of a vehicle's modes that are one to us."""

    mode: FlightMode
    custom_mode: int
    name: str


class ChangeDetector:
    """Remembers what each vehicle did; `look` returns what is new."""

    def __init__(self) -> None:
        self._modes: dict[int, _FlownMode] = {}
        self._silent: set[int] = set()
        self._late_s: dict[int, float] = {}
        """when a position was last seen old, of those whose positions do not come regularly"""
        self._uncertain: dict[int, str] = {}
        self._doubted: set[int] = set()
        self._number = -1
        """of the last snapshot that was looked at"""
        self._aged: set[int] = set()
        """vehicles that may change by time alone: they live, and their last report is old or not believed"""

    def look(self, snapshot: FleetSnapshot, ordered: Mapping[int, End] | None) -> list[Event]:
        """Events since the last snapshot.

        `ordered` says what an operator wants vehicles to fly instead of the plan: that is no failsafe. None: no one
        here commands them, so that no change of mode can be distinguished from an order.
        """
        events: list[Event] = []
        looked_at = self._aged.union(snapshot.columns.changed_since(self._number))
        self._number = snapshot.columns.number
        for view in map(snapshot.vehicle, sorted(looked_at)):
            wanted = str(view.mode) if ordered is None else ordered.get(view.sysid)
            self._watch_mode(view, snapshot.time_s, flies_as_ordered(view.mode, wanted), events)
            self._watch_silence(view, snapshot.time_s, events)
            self._watch_place(view, snapshot.time_s, events)
            self._watch_belief(view, snapshot.time_s, events)
            if view.alive and (not view.fresh or view.sysid in self._late_s):
                self._aged.add(view.sysid)
            else:
                self._aged.discard(view.sysid)
        return events

    def _watch_mode(self, view: VehicleView, now_s: float, by_order: bool, events: list[Event]) -> None:
        if view.last_received_s < 0.0:
            return
        before = self._modes.get(view.sysid)
        if before is not None and (before.mode, before.custom_mode) == (view.mode, view.custom_mode):
            return
        self._modes[view.sysid] = _FlownMode(view.mode, view.custom_mode, view.mode_name)
        if before is None:
            return
        text = f"{before.name} -> {view.mode_name}"
        if view.armed and not by_order and view.mode in GOING_DOWN and before.mode not in GOING_DOWN:
            events.append(Event(now_s, view.sysid, "critical", text, "failsafe"))
        elif view.armed and not by_order and view.mode is FlightMode.HOLD and before.mode in STEERABLE:
            events.append(Event(now_s, view.sysid, "warning", text, "failsafe"))
        else:
            events.append(Event(now_s, view.sysid, "info", text, "mode"))

    def _watch_belief(self, view: VehicleView, now_s: float, events: list[Event]) -> None:
        if view.doubt and view.sysid not in self._doubted:
            self._doubted.add(view.sysid)
            events.append(Event(now_s, view.sysid, "critical", f"Is not believed: {view.doubt}", "link"))
        elif not view.doubt and view.sysid in self._doubted:
            self._doubted.discard(view.sysid)
            events.append(Event(now_s, view.sysid, "info", "Is believed again", "link"))

    def _watch_silence(self, view: VehicleView, now_s: float, events: list[Event]) -> None:
        silent_s = view.silent_s(now_s)
        silent = view.alive and STALE_S < silent_s < math.inf
        if silent and view.sysid not in self._silent:
            self._silent.add(view.sysid)
            events.append(Event(now_s, view.sysid, "warning", f"{NO_TELEMETRY} {silent_s:.1f} s", "link"))
        elif not silent and view.sysid in self._silent:
            self._silent.discard(view.sysid)
            if view.alive:
                events.append(Event(now_s, view.sysid, "info", "Heard again", "link"))

    def _watch_place(self, view: VehicleView, now_s: float, events: list[Event]) -> None:
        sysid, old = view.sysid, STALE_S < view.age_s < math.inf
        if not view.alive:
            self._late_s.pop(sysid, None)
        elif old and (
            sysid in self._late_s or (sysid not in self._silent and view.silent_s(now_s) < RECEIVED_WITHIN_S)
        ):
            if sysid not in self._late_s:
                text = f"No position for {view.age_s:.1f} s, though it is heard"
                events.append(Event(now_s, sysid, "warning", text, "link"))
            self._late_s[sysid] = now_s
        elif not old and now_s - self._late_s.get(sysid, now_s) >= REGULAR_S:
            del self._late_s[sysid]
            events.append(Event(now_s, sysid, "info", "Its positions come again", "link"))
        before = self._uncertain.get(sysid, "")
        if view.uncertain != before:
            self._uncertain[sysid] = view.uncertain
            if view.uncertain:
                text = f"Its position is uncertain: {view.uncertain}"
                events.append(Event(now_s, sysid, "warning", text, "link"))
            else:
                events.append(Event(now_s, sysid, "info", "Its position is certain now", "link"))
