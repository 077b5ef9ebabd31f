"""Parts of a tick's grants that are the same from tick to tick, until something changes: who gets one, whose HEARTBEAT
is due, and where vehicles' own frames lie."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from gcs.link.link import Key
from gcs.mavlink.ids import TRAFFIC
from gcs.mavlink.setpoints import PlacedSetPoints, SetPoint, SetPointPlacer, SetPoints
from gcs.telemetry.state import FleetSnapshot, Vec3

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

    def greeted(self, keys: Iterable[Key], now_ms: int) -> set[int]:
        """System ids of vehicles whose HEARTBEAT from us is due now; they count as sent."""
        if now_ms < self._next_ms:
            return set()
        due_ms = self._due_ms
        greeted = {key[0] for key in keys if key != TRAFFIC and now_ms >= due_ms[key[0]]}
        due_ms |= dict.fromkeys(greeted, now_ms + HEARTBEAT_EVERY_MS)
        self._next_ms = min((due_ms[key[0]] for key in keys if key != TRAFFIC), default=0)
        return greeted


class OwnFrames:
    """Set points in their vehicles' own frames, which are asked for again where one may have changed."""

    def __init__(self) -> None:
        self._placer = SetPointPlacer()
        self._sysids: tuple[int, ...] = ()
        self._stamps: NDArray[np.int64] | None = None
        self._offsets_ned: list[Vec3] = []
        self._turns_rad: list[float] = []

    def placed(self, set_points: Sequence[SetPoint], snapshot: FleetSnapshot, time_ms: int) -> PlacedSetPoints:
        """These set points as they are sent. Each of their vehicles must have reported where its frame lies."""
        points, stamps = SetPoints.of(set_points), snapshot.columns.stamps
        if stamps is not self._stamps or (points.sysids is not self._sysids and points.sysids != self._sysids):
            views = [snapshot.vehicle(sysid) for sysid in points.sysids]
            self._offsets_ned = [view.origin_offset_ned for view in views if view.origin_offset_ned is not None]
            self._turns_rad = [view.turn_rad for view in views]
            self._sysids, self._stamps = points.sysids, stamps
            assert len(self._offsets_ned) == len(views)
        return self._placer.place(points, self._offsets_ned, self._turns_rad, time_ms)
