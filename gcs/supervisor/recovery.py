"""Brings vehicles back that their failsafe has taken while the supervisor was away.

Only vehicles that it flew, that report that a failsafe flies them or hold (external ones that rejoin by the scenario:
whatever they do), and that have energy left: one that a person may have taken over meanwhile stays with that person.
"""

from __future__ import annotations

from collections.abc import Mapping

from gcs.supervisor.arming import ArmingSequence, Stage
from gcs.telemetry.events import Event
from gcs.telemetry.state import FleetSnapshot, VehicleView

WATCHED_S = 20.0
"""Session time within which a failsafe is blamed on the supervisor's absence."""
_FLOWN = frozenset({Stage.FLY, Stage.OFFBOARD})
_GONE = frozenset({Stage.YIELDED, Stage.DOWN})


class Recovery:
    """Of the vehicles of one session that fly on without it; `returned` says that the supervisor was away."""

    def __init__(self, arming: Mapping[int, ArmingSequence]) -> None:
        self._arming = arming
        self._led: tuple[set[int], set[int]] = (set(), set())
        """that it flew when it looked for the last two times"""
        self._flown: set[int] = set()
        self._until_s = 0.0

    def returned(self, now_s: float) -> None:
        """The supervisor goes on at a session time; the vehicles that it flew until now may have flown a failsafe
        meanwhile, which the tick in which it woke may have read."""
        self._flown = self._led[0] | self._led_now()
        self._until_s = now_s + WATCHED_S

    def look(self, snapshot: FleetSnapshot) -> list[Event]:
        """Bring vehicles back where possible; returns the events of it."""
        self._led = self._led[1], self._led_now()
        if not self._flown:
            return []
        events = []
        for sysid in sorted(self._flown):
            view, arming = snapshot.vehicle(sysid), self._arming[sysid]
            if arming.stage not in _GONE or arming.left_out or arming.ordered is not None or not view.fresh:
                continue
            self._flown.discard(sysid)
            events.append(self._bring_back(view, arming, snapshot.time_s))
        if snapshot.time_s > self._until_s:
            self._flown.clear()
        return events

    def _led_now(self) -> set[int]:
        return {sysid for sysid, arming in self._arming.items() if arming.stage in _FLOWN}

    def _bring_back(self, view: VehicleView, arming: ArmingSequence, now_s: float) -> Event:
        if arming.stage is Stage.YIELDED and not arming.back_from(view):
            text = f"A pilot or another station may control it ({view.mode_name}): rejoin brings it back"
        elif view.energy_source != "none" and view.remaining_j <= 0.0:
            text = "Stays where its failsafe brought it: it has no energy left"
        else:
            arming.rejoin()
            return Event(now_s, view.sysid, "info", "Brought back: its failsafe flew it while the station was silent")
        return Event(now_s, view.sysid, "warning", text)
