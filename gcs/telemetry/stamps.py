"""Vehicles whose stamps are new: those of which something else than figures may have changed."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gcs.telemetry.columns import UNSTAMPED, FleetColumns


class StampWatch:
    """Remembers the stamps of the last snapshot that it was shown; `new` returns who has another one since."""

    def __init__(self) -> None:
        self._row: Mapping[int, int] = {}
        self._stamps = np.empty(0, np.int64)
        self._raw: bytes | None = None
        """the same as bytes, which compare in a tenth of the time; None while one of them is UNSTAMPED"""

    def new(self, columns: FleetColumns) -> list[int]:
        """System ids, in order; all of a fleet of other vehicles than last time, and always who is not stamped."""
        stamps, raw, known = columns.stamps, columns.stamps.tobytes(), columns.row is self._row
        if known and raw == self._raw:
            return []
        others = not known and columns.row != self._row
        changed = columns.sysids if others else self._changed(columns)
        self._row, self._stamps, self._raw = columns.row, stamps, None if UNSTAMPED in stamps else raw
        return list(changed)

    def _changed(self, columns: FleetColumns) -> list[int]:
        rows = np.flatnonzero((columns.stamps != self._stamps) | (columns.stamps == UNSTAMPED))
        return [columns.sysids[row] for row in rows.tolist()]
