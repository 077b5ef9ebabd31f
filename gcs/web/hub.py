"""Passes a source's lines (`gcs.session.message_types`) on to any number of pages; no socket, clock or thread.

A page that comes late first gets the session with every event so far, then what it has missed, thinned out, then the
newest. A page that reads slowly misses snapshots but no event, no reply and not the end; one that reads nothing is let
go of, and comes back by itself. The source that feeds a hub never waits.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import msgspec

PAST_BYTES = 16 << 20
"""Kept of the past for late pages."""
PIECE_BYTES = 64 << 10
"""The past goes to a page in pieces of this size, each made when the page has room for it."""
PAST_EVERY_S = 0.5
MOST_EVENTS = 4000
MOST_WAITING = 400
"""Lines that may wait for one page, without those that are left out."""
READ_ONLY = "View-only link: commands are disabled; open the link with the token of command."
Message = Mapping[str, Any]


class PageListener:
    """One page: the lines that wait for it. `wake` is called when there is one, or when it is let go of."""

    def __init__(
        self,
        number: int,
        commands: bool,
        wake: Callable[[], object],
        greeting: bytes | None = None,
        past: Iterable[bytes] = (),
    ) -> None:
        """greeting, past: for it to have first; lines of the past are all pages', and copied only when they go."""
        self.number = number
        self.commands = commands
        """whether it may command"""
        self.slow = False
        """whether it has been let go of"""
        self._wake = wake
        self._greeting = greeting
        self._past = deque(past)
        self._waiting: deque[tuple[bytes, bool]] = deque()

    def put(self, line: bytes, *, replaceable: bool = False) -> None:
        """Let it have a line; one that is replaceable makes room for the next such one."""
        if replaceable and self._waiting and self._waiting[-1][1]:
            self._waiting[-1] = (line, True)
        elif len(self._waiting) >= MOST_WAITING:
            self.slow = True
            self._greeting = None
            self._past.clear()
            self._waiting.clear()
        elif not self.slow:
            self._waiting.append((line, replaceable))
        self._wake()

    def take(self) -> bytes | None:
        """The next line for it; None where none waits. The past comes as lists, a piece at a time."""
        if (line := self._greeting) is not None:
            self._greeting = None
            return line
        if self._past:
            piece, size = [], 0
            while self._past and size < PIECE_BYTES:
                piece.append(self._past.popleft())
                size += len(piece[-1])
            return b"[" + b",".join(piece) + b"]"
        return self._waiting.popleft()[0] if self._waiting else None


class Hub:
    """The lines received so far, and the pages that listen."""

    def __init__(self, past_bytes: int = PAST_BYTES) -> None:
        self._encoder = msgspec.json.Encoder()
        self._session: dict[str, Any] | None = None
        self._newest: bytes | None = None
        self._end: bytes | None = None
        self._report: bytes | None = None
        self._events: deque[Any] = deque(maxlen=MOST_EVENTS)
        self._event_count = 0
        self._past: list[tuple[float, bytes]] = []
        self._past_bytes, self._past_room = 0, past_bytes
        self._past_every_s = PAST_EVERY_S
        self._listeners: dict[int, PageListener] = {}
        self._number = 0

    @property
    def ended(self) -> bool:
        """Whether the source has said its last word."""
        return self._end is not None

    @property
    def visited(self) -> bool:
        """Whether a page has ever come."""
        return self._number > 0

    @property
    def reported(self) -> bool:
        """Whether there is a report to read."""
        return self._report is not None

    def report(self, path: str) -> None:
        """Let all pages know where on this server the session's report is."""
        self._report = self._encoder.encode({"type": "report", "path": path})
        for listener in self._listeners.values():
            listener.put(self._report)

    def take(self, messages: Iterable[Message]) -> None:
        """Pass on a message of the source."""
        for message in messages:
            kind = message.get("type")
            if kind == "session":
                self._session = {key: value for key, value in message.items() if key not in ("events", "told")}
                for listener in self._listeners.values():
                    listener.put(self._greeting(listener.commands, events=False))
            elif kind == "snapshot":
                self._take_snapshot(message)
            elif kind == "reply":
                self._reply(message)
            elif kind == "end":
                self._end = self._encoder.encode(message)
                for listener in self._listeners.values():
                    listener.put(self._end)

    def join(self, commands: bool, wake: Callable[[], object]) -> PageListener:
        """A page that has come; its first lines wait for it already."""
        self._number += 1
        greeting = None if self._session is None else self._greeting(commands)
        listener = PageListener(self._number, commands, wake, greeting, (line for _, line in self._past))
        self._listeners[self._number] = listener
        wake()
        if self._newest is not None:
            listener.put(self._newest, replaceable=True)
        for line in (self._end, self._report):
            if line is not None:
                listener.put(line)
        return listener

    def leave(self, listener: PageListener) -> None:
        """A page that has gone."""
        self._listeners.pop(listener.number, None)

    def command(self, listener: PageListener, text: str) -> Message | None:
        """The command of a page, as it is sent to the source; None where it was answered already."""
        try:
            content = msgspec.json.decode(text)
        except (ValueError, RecursionError):
            content = None
        if not isinstance(content, dict) or not isinstance(content.get("command"), str):
            return None
        given = content.get("id")
        if not listener.commands:
            reply = {"type": "reply", "id": given if isinstance(given, str | int) else None}
            listener.put(self._encoder.encode({**reply, "ok": False, "text": READ_ONLY}))
            return None
        return {**content, "id": f"{listener.number}/{given}"}

    def _greeting(self, commands: bool, *, events: bool = True) -> bytes:
        assert self._session is not None
        told: dict[str, Any] = {"events": list(self._events), "told": self._event_count} if events else {}
        control = bool(self._session.get("control")) and commands
        return self._encoder.encode({**self._session, "control": control, **told})

    def _take_snapshot(self, message: Message) -> None:
        events = message.get("events") or ()
        self._events.extend(events)
        self._event_count += len(events)
        line = self._encoder.encode(message)
        self._keep(float(message.get("t_s") or 0.0), message, line, plain=not events)
        self._newest = line if not events else self._encoder.encode({**message, "events": []})
        for listener in self._listeners.values():
            listener.put(line, replaceable=not events)

    def _keep(self, t_s: float, message: Message, line: bytes, *, plain: bool) -> None:
        past = self._past
        while past and past[-1][0] >= t_s:  # a replay went back
            self._past_bytes -= len(past.pop()[1])
        if past and t_s - past[-1][0] < self._past_every_s:
            return
        bare = line  # events are sent with the session
        if not plain or message.get("inspected"):
            bare = self._encoder.encode({**message, "events": [], "inspected": {}})
        past.append((t_s, bare))
        self._past_bytes += len(bare)
        if self._past_bytes > self._past_room:
            self._past = past[::2]
            self._past_bytes = sum(len(kept) for _, kept in self._past)
            self._past_every_s *= 2.0

    def _reply(self, message: Message) -> None:
        number, _, given = str(message.get("id")).partition("/")
        listener = self._listeners.get(int(number)) if number.isdigit() else None
        if listener is not None:
            listener.put(self._encoder.encode({**message, "id": given}))
