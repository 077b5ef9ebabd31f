"""The events as a page that is filtered and scrolled, and the newest of them under the fleet."""

from __future__ import annotations

from dataclasses import replace

from gcs.console import events_log
from gcs.console.model import SessionModel
from gcs.console.text import Glyphs, StyledLine, StyledLines, titled

NONE: StyledLine = [("  none", "dim")]


class EventsPage:
    """Which events are shown, and how far back."""

    def __init__(self) -> None:
        self.filter = events_log.Filter()
        self.folds = True
        self._back = self._matched = 0
        self._found: tuple[object, list[events_log.Event]] = (None, [])

    def _matching(self, watch: SessionModel) -> list[events_log.Event]:
        """The events that pass, folded unless filtered. Kept while nothing has come."""
        key = (watch.event_count, len(watch.events), self.folds, replace(self.filter))
        if self._found[0] != key:
            found = events_log.matching(watch, self.filter)
            self._found = key, events_log.folded(found) if self.folds and self.filter.open else found
        return self._found[1]

    def page(self, watch: SessionModel, *, width: int, height: int, glyphs: Glyphs) -> StyledLines:
        """The events that there is room for, from where it was scrolled to."""
        found = self._matching(watch)
        if self._back:  # a reader of the past keeps the place
            self._back += max(0, len(found) - self._matched)
        self._matched = len(found)
        shown, self._back = events_log.window(
            watch, found, width=width, height=height - 1, back=self._back, glyphs=glyphs
        )
        shows = len(found) + sum(int(event.get("more") or 0) for event in found)
        note: StyledLine = [(f"{self.filter.said()}: {shows} of {len(watch.events)}", "info")]
        if self._back:
            note.append((f", {self._back} newer below", "look"))
        return [titled("events", width, glyphs, note), *(shown or [NONE])]

    def recent(self, watch: SessionModel, *, width: int, height: int, glyphs: Glyphs) -> StyledLines:
        """The newest ones."""
        found = self._matching(watch)
        note: StyledLine = [] if self.filter.open else [(self.filter.said(), "info")]
        shown, _ = events_log.window(watch, found, width=width, height=height - 1, back=0, glyphs=glyphs)
        return [titled("events", width, glyphs, note), *(shown or [NONE])]

    def scroll(self, down: int) -> None:
        """Scroll some events on, or back for a negative number."""
        self._back = max(0, self._back - down)

    def change(self, what: str, chosen: int | None) -> None:
        """The next `level` or `kind`, only the `vehicle` that is chosen or all again, or no filter."""
        if what == "level":
            self.filter.next_level()
        elif what == "kind":
            self.filter.next_kind()
        elif what == "vehicle":
            self.filter.sysid = None if self.filter.sysid is not None else chosen
        else:
            self.filter = events_log.Filter()
        self._back = 0

    def look_for(self, words: str) -> None:
        """Only events with these words."""
        self.filter.words = words
        self._back = 0
