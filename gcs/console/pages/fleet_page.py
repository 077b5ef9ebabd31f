"""The fleet's page: its order, the words that its vehicles must have, and how far it is scrolled."""

from __future__ import annotations

from gcs.console.model import SessionModel, Vehicle, issues, ordered
from gcs.console.pages import fleet
from gcs.console.text import Glyphs, StyledLine, StyledLines, fitted

ORDERINGS = ("id", "battery", "competition")


class FleetPage:
    """Which vehicles are shown, and in which order; trouble comes first."""

    def __init__(self) -> None:
        self.order_by = "id"
        self.words = ""
        self._top = 0
        self._on_row: list[int] = []

    def ordered(self, seen: SessionModel) -> list[Vehicle]:
        """The vehicles that the filter lets through."""
        if not seen.vehicles:
            return [{**known, "mode_name": "starting"} for known in seen.known.values()]
        words = self.words.casefold().split()
        found = [v for v in seen.vehicles.values() if all(_has(v, word) for word in words)]
        return ordered(found, self.order_by)

    def table(self, seen: SessionModel, chosen: int | None, *, width: int, height: int, glyphs: Glyphs) -> StyledLines:
        """As many as there is room for, and what the filter leaves out."""
        shown = self.ordered(seen)
        note: StyledLines = []
        if self.words and seen.vehicles:
            said: StyledLine = [(f'"{self.words}": {len(shown)} of {len(seen.vehicles)}', "info")]
            note = [fitted([*said, ("  / changes it", "dim")], width, glyphs)]
        lines, self._on_row, self._top = fleet.table(
            shown, width=width, height=height - len(note), glyphs=glyphs, chosen=chosen, top=self._top
        )
        return [*lines, *note]

    def lines(self, seen: SessionModel) -> int:
        """How many it would need."""
        return len(self.ordered(seen)) + 1 + bool(self.words)

    def at(self, row: int) -> int | None:
        """The vehicle on a row of the table; None on its heading and below."""
        return self._on_row[row - 1] if 0 < row <= len(self._on_row) else None

    def next_order(self) -> None:
        """Another order."""
        self.order_by = ORDERINGS[(ORDERINGS.index(self.order_by) + 1) % len(ORDERINGS)]


def _has(vehicle: Vehicle, word: str) -> bool:
    """Whether a number begins its id, or a word is in its role, label, mode, state or troubles."""
    if word.isdigit():
        return str(vehicle["sysid"]).startswith(word)
    told = (vehicle.get(key) for key in ("role", "label", "mode", "mode_name", "state"))
    return word in " ".join(map(str, (*told, *issues(vehicle)))).casefold()
