"""Events of one component in their order, each once, and lost ones asked for again: no socket and no clock
here, time is an argument (s).

1. The first number that comes begins the count; what was before it is past.
2. An event that is not the next waits, and the next is asked for; so it is where CURRENT_EVENT_SEQUENCE is ahead.
3. What the component no longer has, or does not send though it was asked TRIES times, is lost, and counted.
4. A component that has booted counts anew: CURRENT_EVENT_SEQUENCE says so, or the events' own time, which falls.
[lineage] Events Interface, https://mavlink.io/en/services/events.html; libevents' libs/cpp/protocol/receive.h
"""

from __future__ import annotations

from typing import Any

from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from skytender import mavlink as mav

REPEAT_S, TRIES = 0.5, 10
MOST_WAITING = 64
BOOTED_MS = 3000
"""So much earlier than the last event the clock of a component is that has booted."""
_COUNT = 1 << 16


class EventStream:
    """The events of one component."""

    def __init__(self, sysid: int, compid: int) -> None:
        self._to = {"target_system": sysid, "target_component": compid}
        self._last: int | None = None
        """number of the last event that was handed out"""
        self._ahead = 0
        """of events that there are beyond it, as far as is known"""
        self._waiting: dict[int, Any] = {}
        self._time_ms = 0
        self._tries, self._due_s = 0, 0.0
        self.lost = 0

    def receive(self, name: str, content: Any) -> list[Any]:
        """Take a message of this component's: its name and fields; the fields of each EVENT that is next now."""
        if name == "CURRENT_EVENT_SEQUENCE":
            booted = content.flags & mav.MAV_EVENT_CURRENT_SEQUENCE_FLAGS_RESET
            if self._last is None or booted or self._beyond(content.sequence) < 0:
                self._begin(content.sequence)
            else:
                self._ahead = max(self._ahead, self._beyond(content.sequence))
        elif name == "RESPONSE_EVENT_ERROR" and self._last is not None:
            if self._beyond(content.sequence) == 1:
                self._skip(max(self._beyond(content.sequence_oldest_available) - 1, 1))
        elif name == "EVENT":
            if self._last is None or content.event_time_boot_ms < self._time_ms - BOOTED_MS:
                self._begin(content.sequence - 1)
            beyond = self._beyond(content.sequence)
            if beyond > 0 and len(self._waiting) < MOST_WAITING:
                self._waiting[content.sequence] = content
                self._ahead = max(self._ahead, beyond)
        return self._next()

    def poll(self, now_s: float) -> list[Message]:
        """The message to send now."""
        if not self._ahead or self._last is None or now_s < self._due_s:
            return []
        if self._tries >= TRIES:
            self._skip(1)
        missing = (self._last + 1) % _COUNT
        if not self._ahead or missing in self._waiting:  # it is handed out with the next message
            return []
        self._tries, self._due_s = self._tries + 1, now_s + REPEAT_S
        return [codec.message("REQUEST_EVENT", **self._to, first_sequence=missing, last_sequence=missing)]

    def _beyond(self, sequence: int) -> int:
        """How many numbers it lies beyond the last one; negative before it."""
        assert self._last is not None
        return (sequence - self._last + _COUNT // 2) % _COUNT - _COUNT // 2

    def _begin(self, last: int) -> None:
        self._last, self._ahead, self._time_ms, self._tries = last % _COUNT, 0, 0, 0
        self._waiting.clear()

    def _skip(self, count: int) -> None:
        """Give up the next events."""
        assert self._last is not None
        self.lost += count
        self._last = (self._last + count) % _COUNT
        self._ahead, self._tries, self._due_s = max(self._ahead - count, 0), 0, 0.0
        self._waiting = {sequence: one for sequence, one in self._waiting.items() if self._beyond(sequence) > 0}

    def _next(self) -> list[Any]:
        """The events that are next, one after the other."""
        found = []
        while self._last is not None and (content := self._waiting.pop((self._last + 1) % _COUNT, None)) is not None:
            self._last, self._ahead = content.sequence, max(self._ahead - 1, 0)
            self._tries, self._due_s, self._time_ms = 0, 0.0, content.event_time_boot_ms
            found.append(content)
        return found
