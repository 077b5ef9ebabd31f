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
        self._all_stamped = False

    def new(self, columns: FleetColumns) -> list[int]:
        """System ids, in order; all of a fleet of other vehicles than last time, and always who is not stamped."""
        stamps = columns.stamps
        if stamps is self._stamps and self._all_stamped:
            return []
        others = columns.row is not self._row and columns.row != self._row
        changed = columns.sysids if others else self._changed(columns)
        self._row, self._stamps, self._all_stamped = columns.row, stamps, UNSTAMPED not in stamps
        return list(changed)

    def _changed(self, columns: FleetColumns) -> list[int]:
        rows = np.flatnonzero((columns.stamps != self._stamps) | (columns.stamps == UNSTAMPED))
        return [columns.sysids[row] for row in rows.tolist()]
