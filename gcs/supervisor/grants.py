"""Parts of a tick's grants that are the same from tick to tick, until something changes: their recipients, those whose
HEARTBEAT is due, and where vehicles' own frames lie."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from gcs.link.link import Key
from gcs.mavlink.common_frame import turned
from gcs.mavlink.ids import TRAFFIC
from gcs.mavlink.setpoints import PlacedSetPoints, SetPoints
from gcs.telemetry.columns import FleetColumns

HEARTBEAT_EVERY_MS = 1000


class Addressees:
    """Vehicles to which grants go, and our HEARTBEAT."""

    def __init__(self, join_ms: Mapping[int, int]) -> None:
        """join_ms: session time from which each vehicle takes part, by system id."""
        self._join_ms = join_ms
        self._due_ms = dict.fromkeys(join_ms, 0)
        self._next_ms = 0
        self._joined: set[Key] = set()
        self._keys: list[Key] = []

    def granted(self, joined: set[Key], grant_ms: int) -> Sequence[Key]:
        """The joined vehicles that may fly until then, in order."""
        if joined != self._joined or len(self._keys) < len(joined):
            self._joined, self._next_ms = set(joined), 0
            self._keys = [key for key in sorted(joined) if key == TRAFFIC or grant_ms >= self._join_ms[key[0]]]
        return self._keys

    def heartbeat_due(self, keys: Iterable[Key], now_ms: int) -> set[int]:
        """System ids of vehicles whose HEARTBEAT from us is due now; they count as sent."""
        if now_ms < self._next_ms:
            return set()
        due_ms = self._due_ms
        heartbeat_due = {key[0] for key in keys if key != TRAFFIC and now_ms >= due_ms[key[0]]}
        due_ms |= dict.fromkeys(heartbeat_due, now_ms + HEARTBEAT_EVERY_MS)
        self._next_ms = min((due_ms[key[0]] for key in keys if key != TRAFFIC), default=0)
        return heartbeat_due


class OwnFrames:
    """Brings set points into their vehicles' own frames."""

    def __init__(self) -> None:
        self._sysids: tuple[int, ...] = ()
        self._number = -1
        self._origins = np.empty((0, 6))
        """(k, 6) nothing is taken off a velocity, so that one subtraction does for both"""
        self._turns_rad: dict[int, float] = {}
        """by row, where it is none"""

    def placed(self, points: SetPoints, columns: FleetColumns, time_ms: int) -> PlacedSetPoints:
        """These set points as they are sent. Each of their vehicles must have reported where its frame lies."""
        if points.sysids != self._sysids or columns.changed_since(self._number):
            frames = columns.frames[[columns.row[sysid] for sysid in points.sysids]]
            assert not np.isnan(frames).any()
            self._origins = np.hstack((frames[:, :3], np.zeros((len(frames), 3))))
            self._turns_rad = {row: turn for row, turn in enumerate(frames[:, 3].tolist()) if turn}
            self._sysids, self._number = points.sysids, columns.number
        values = points.values - self._origins
        for row, turn_rad in self._turns_rad.items():
            n, e, d, v_n, v_e, v_d = values[row].tolist()
            values[row] = *turned((n, e, d), -turn_rad), *turned((v_n, v_e, v_d), -turn_rad)
        return PlacedSetPoints(time_ms, points.sysids, values)
