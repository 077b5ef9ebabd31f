"""Events of one vehicle as texts, by the definitions in its own metadata: no socket and no clock here, time is an
argument (s).

Events that come before the definitions wait for them, each with the time at which it came. A check that stands against
arming is no text of its own: it is added to the text that says that arming was refused.
[lineage] mavlink/libevents, README.md: log levels, event groups
"""

from __future__ import annotations

from typing import Any

from gcs.mavlink.codec import Message
from gcs.mavlink.metadata.client import EVENTS, MetadataClient, MetadataRefused
from gcs.mavlink.metadata.event_stream import EventStream
from gcs.mavlink.metadata.event_words import EventDefinitions, EventWords

MOST_WAITING = 64
MOST_PARTS, MOST_CHECKS = 8, 32
"""Of a report on what stands against arming; more are not kept."""
LEAST_SEVERE = 7
"""Debug; beyond it stand events of protocols, and disabled ones."""
CHECKS = ("arming_check", "health")
APPENDED = "append_health_and_arming_messages"
NAMES = frozenset(
    {"EVENT", "CURRENT_EVENT_SEQUENCE", "RESPONSE_EVENT_ERROR", "COMPONENT_METADATA", "FILE_TRANSFER_PROTOCOL"}
)
"""Messages that are read."""


class ReportedEvents:
    """The dialogue with one vehicle's autopilot, which has been asked for COMPONENT_METADATA."""

    def __init__(self, sysid: int, compid: int) -> None:
        self.definitions: EventDefinitions | None = None
        self._metadata = MetadataClient(sysid, compid, (EVENTS,), asks=False)
        self._stream = EventStream(sysid, compid)
        self._unread: list[tuple[float, Any]] = []
        """events that wait for the definitions, and when they came"""
        self._checks: dict[Any, list[str]] = {}
        """texts of what stands against arming, by the part of the report"""
        self._part: Any = None

    @property
    def lost(self) -> int:
        """Events that did not come, so far."""
        return self._stream.lost

    def receive(self, name: str, content: Any, now_s: float) -> list[tuple[int, str, float]]:
        """Take a message, its name and fields; (MAV_SEVERITY, text, when it came) of each event to be shown."""
        self._metadata.receive(name, content, now_s)
        came = [(now_s, event) for event in self._stream.receive(name, content)]
        self._unread = [*self._unread, *came][-MOST_WAITING:]
        if self.definitions is None:
            self._define()
        if self.definitions is None:
            return []
        unread, self._unread = self._unread, []
        found = []
        for came_s, event in unread:
            words = self.definitions.words(event.id, bytes(event.arguments))
            text = self._text(words) if words is not None else f"Event {event.id}, which its metadata does not define"
            severity = event.log_levels & 0xF
            if text and severity <= LEAST_SEVERE:
                found.append((severity, text, came_s))
        return found

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        return [*self._metadata.poll(now_s), *self._stream.poll(now_s)]

    def _define(self) -> None:
        """Take the definitions, once they have come."""
        if EVENTS in self._metadata.files:
            try:
                self.definitions = EventDefinitions(self._metadata.files.pop(EVENTS))
            except MetadataRefused:
                self._unread = []

    def _text(self, words: EventWords) -> str:
        """Text to show; empty where it is none."""
        if words.group in CHECKS:
            if words.type == "summary":
                self._part = words.values[0] if words.values else None
                if words.group == "arming_check" and (self._part in self._checks or len(self._checks) < MOST_PARTS):
                    self._checks[self._part] = []
            elif len(part := self._checks.get(self._part, [])) < MOST_CHECKS:
                part.append(words.text)
            return ""
        if words.group != "default":
            return ""
        checks = "; ".join(dict.fromkeys(text for part in self._checks.values() for text in part))
        if words.type != APPENDED or not checks:
            return words.text
        return f"{words.text}{' ' if words.text.endswith(':') else '; '}{checks}"
