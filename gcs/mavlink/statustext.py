"""STATUSTEXT's chunks, put together again.

A text longer than a message comes in chunks of one id, counted up; a chunk that is not full is the last. Whoever sends
short texts alone leaves the id 0, and so does a PX4 for its first text after boot, in however many chunks. A PX4 sends
nothing after a last chunk that happens to be full. So a full chunk waits for the next one, and not for long.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

CHUNK_CHARACTERS = 50
MOST_CHARACTERS = 500
"""A text is told as soon as it is so long; what goes on with it is passed over."""
PATIENCE_S = 0.5
"""The chunks of a text are sent without a pause between them."""


class _Open(NamedTuple):
    """A text whose last chunk was full."""

    severity: int
    text: str
    text_id: int
    since_s: float


class Texts:
    """One vehicle's texts; trailing white space, with which a PX4 ends them, is cut."""

    def __init__(self) -> None:
        self._open: _Open | None = None
        self._cut_id: int | None = None

    def add(self, content: Any, time_s: float) -> list[tuple[int, str]]:
        """Take in STATUSTEXT's fields, received at a session time; (severity, text) of each text that is complete
        now."""
        if content.chunk_seq == 0 or content.id != self._cut_id:
            self._cut_id = None
        else:
            return []
        goes_on = self._open is not None and content.chunk_seq > 0 and content.id == self._open.text_id
        whole = [] if goes_on else self.give_up()
        before = self._open.text if self._open is not None else ""
        self._open = _Open(content.severity, before + content.text, content.id, time_s)
        if len(self._open.text) >= MOST_CHARACTERS:
            self._cut_id = content.id
            return whole + self.give_up()
        return whole + (self.give_up() if len(content.text) < CHUNK_CHARACTERS else [])

    @property
    def open(self) -> bool:
        """Whether a text waits for its next chunk."""
        return self._open is not None

    def overdue(self, now_s: float) -> list[tuple[int, str]]:
        """The text that has waited too long for its next chunk, as far as it came."""
        waited = self._open is not None and now_s - self._open.since_s >= PATIENCE_S
        return self.give_up() if waited else []

    def give_up(self) -> list[tuple[int, str]]:
        """The text that waits, as far as it came."""
        texts = [] if self._open is None else [(self._open.severity, self._open.text.rstrip())]
        self._open = None
        return texts


def recorded(messages: Iterable[tuple[float, Any]]) -> Iterator[tuple[float, int, str]]:
    """(session time in s, severity, text) of one vehicle's texts, from its STATUSTEXTs and the times of their
    reception."""
    texts, received_s = Texts(), 0.0
    for time_s, content in messages:
        yield from ((received_s + PATIENCE_S, *text) for text in texts.overdue(time_s))
        received_s = time_s
        yield from ((time_s, *text) for text in texts.add(content, time_s))
    yield from ((received_s + PATIENCE_S, *text) for text in texts.give_up())
