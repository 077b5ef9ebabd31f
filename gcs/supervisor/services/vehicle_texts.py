"""Texts of a session's vehicles, STATUSTEXTs and external vehicles' EVENTs, as events for people."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from typing import Any

from gcs.mavlink.services.vehicle_events import aged
from gcs.supervisor.arming import ArmingSequence
from gcs.supervisor.external_fleet import ExternalFleet
from gcs.telemetry.events import Event, level_of
from gcs.telemetry.fleet import Fleet

MOST_TEXTS = 20
"""Of one vehicle in one tick; a vehicle that reports more is not shown whole."""

Text = tuple[int, int, str]
"""System id, MAV_SEVERITY, text."""


class VehicleTexts:
    """Texts of all of them. A text that its vehicle repeats within a moment is shown once."""

    def __init__(self, fleet: Fleet, externals: ExternalFleet, arming: Mapping[int, ArmingSequence]) -> None:
        self._fleet, self._externals, self._arming = fleet, externals, arming
        self._records: list[dict[str, Any]] = []

    def pop_events(self, now_s: float) -> list[Event]:
        """Texts since the last call that are to be shown."""
        spoken = [(*text, now_s) for text in self._fleet.pop_statustexts(now_s)]
        announced = self._externals.pop_texts()
        if not (spoken or announced):
            return []
        said, words = self._shown(spoken, now_s), self._shown(announced, now_s)
        self._records += [
            {"t_s": now_s, "kind": "event", "sysid": sysid, "severity": severity, "text": text}
            for sysid, severity, text in words
        ]
        return [Event(now_s, sysid, level_of(severity), text, "text") for sysid, severity, text in said + words]

    def pop_records(self) -> list[dict[str, Any]]:
        """EVENTs since the last call, for decisions.jsonl: a recording's frames alone do not put them into words."""
        taken, self._records = self._records, []
        return taken

    def _shown(self, texts: Iterable[tuple[*Text, float]], now_s: float) -> list[Text]:
        """The texts to be shown; each ends with the time at which it came."""
        count: Counter[int] = Counter()
        shown = []
        for sysid, severity, text, came_s in texts:
            count[sysid] += 1
            arming = self._arming.get(sysid)
            if count[sysid] > MOST_TEXTS or self._externals.repeats(sysid, text, came_s):
                continue
            if arming is None or not arming.repeats(text):
                shown.append((sysid, severity, aged(text, came_s, now_s)))
        return shown
