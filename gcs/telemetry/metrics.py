"""Measures of a session, gathered tick by tick from snapshots: paths, tracking and pursuit."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import cython
import numpy as np
from cython.cimports.gcs.telemetry.approach import segment_gap2
from cython.cimports.gcs.telemetry.metrics import AGE, EMPTY, FLYING, FRESH, P_NED, P_NOW, WAY, flown_at
from cython.cimports.libc import math
from numpy.typing import NDArray

from gcs.mavlink.setpoints import SetPoint, SetPoints
from gcs.scenario.model import Scenario
from gcs.telemetry.approach import Ints
from gcs.telemetry.columns import FIGURES, FLAGS, PLACES, Flags, FleetColumns, Floats
from gcs.telemetry.pursuit import PursuitHeld
from gcs.telemetry.state import FleetSnapshot

_FLOWN = 7
_LENGTH, _ERROR = 4, 5
PLAN_MEMORY = 20
"""Set points against which a reported place is held: a vehicle flies a few ticks behind its plan."""
PAUSE_PERIODS = 1.5
"""Set points farther apart than this are no path."""
_MEMORY = PLAN_MEMORY
_KEPT = 128
"""Set points that are kept: reports may be late."""
_ROUNDING_S = 1e-6


class Metrics:
    """Running figures of one session."""

    def __init__(self, scenario: Scenario) -> None:
        self.target_of: Mapping[int, int] = scenario.vehicles.followed
        self._of_targets = scenario.pursuit.by == "competition"
        within_m = scenario.goal.pursue.within_m if scenario.goal.pursue else math.INFINITY
        targets = (target.sysid for target in scenario.vehicles.targets)
        self._pursuit = PursuitHeld(targets if self._of_targets else self.target_of, within_m)
        self._row = {vehicle.sysid: row for row, vehicle in enumerate(scenario.vehicles.all)}
        count = len(self._row)
        self._flown = np.full((count, _FLOWN), np.nan)
        self._plans, self._runs = np.zeros((count, _KEPT, 3)), np.full((count, 2), -2, np.int64)
        self._ticks_s, self._tick = np.zeros(_KEPT), -1
        self._pause_s = PAUSE_PERIODS * scenario.clock.period_s
        self._sysids: tuple[int, ...] = ()
        self._rows = np.empty(0, np.int64)
        """of the vehicles that had the last set points"""
        self._pairs = self._pairs_of(self.target_of)
        self._time_s, self._distances_m = np.empty(1), np.empty((1, len(self._pursuit.keys)))

    def update(
        self,
        snapshot: FleetSnapshot,
        set_points: Sequence[SetPoint],
        pursuing: Mapping[int, int] | None = None,
        late_s: float = 0.0,
    ) -> None:
        """Count one tick; what external vehicles reported is `late_s` newer than the snapshot's time.

        `pursuing` gives the pursuer of each target where one vehicle is chosen for each: it is then the targets that
        must have their pursuer near.
        """
        if pursuing is not None and pursuing != self.target_of:
            self.target_of = dict(pursuing)
            self._pairs = self._pairs_of(self.target_of)
        points = SetPoints.of(set_points)
        if points.sysids != self._sysids:
            self._rows = np.array([self._row[sysid] for sysid in points.sysids], np.int64)
            self._sysids = points.sysids
        self._measure(snapshot, self._rows, points.values, self._pairs)
        if self._pursuit.keys:
            self._time_s[0] = snapshot.time_s + late_s
            self._pursuit.update(self._time_s, self._distances_m)

    def finish(self, snapshot: FleetSnapshot) -> None:
        """Count the last reports: at the session's end nothing is planned, and no pursuit is measured."""
        self._measure(snapshot, np.empty(0, np.int64), np.empty((0, 6)), np.empty((0, 3), np.int64))

    def _measure(self, snapshot: FleetSnapshot, rows: Ints, planned: Floats, pairs: Ints) -> None:
        columns = snapshot.columns
        if snapshot.time_s - self._ticks_s[self._tick % _KEPT] > self._pause_s:
            self._runs[:] = -2
        self._tick += 1
        self._ticks_s[self._tick % _KEPT] = snapshot.time_s
        flags, places, figures = columns.flags, columns.places, columns.figures
        if len(columns.sysids) < len(self._row):
            flags, places, figures = self._in_order(columns)
        _measure(
            flags.view(np.uint8),
            places,
            figures,
            rows,
            planned,
            pairs,
            self._flown,
            self._plans,
            self._runs,
            self._ticks_s,
            self._tick,
            self._distances_m,
        )

    @property
    def path_length_m(self) -> dict[int, float]:
        """Way in the air by system id, for vehicles that were in the air for two ticks in a row. A fall with an empty
        battery does not count."""
        return _known(self._row, self._flown[:, _LENGTH])

    @property
    def pursuit_held_s(self) -> float:
        """The longest time for which even the worst pursuer stayed with its target (or target had its pursuer)."""
        return self._pursuit.worst_s

    @property
    def max_tracking_error_m(self) -> dict[int, float]:
        """By system id, of those whose reported places were held against a plan: the greatest distance of any that was
        the newest at a tick from the path that had been planned by its own time."""
        return _known(self._row, self._flown[:, _ERROR])

    def _in_order(self, columns: FleetColumns) -> tuple[Flags, Floats, Floats]:
        """Flags, places and figures of all the scenario's vehicles, where the fleet has fewer by now."""
        count = len(self._row)
        rows = [self._row[sysid] for sysid in columns.sysids]
        flags, places = np.zeros((FLAGS, count), np.bool_), np.zeros((PLACES, count, 3))
        figures = np.zeros((FIGURES, count))
        flags[:, rows], places[:, rows], figures[:, rows] = columns.flags, columns.places, columns.figures
        return flags, places, figures

    def _pairs_of(self, target_of: Mapping[int, int]) -> Ints:
        """(k, 3) rows of pursuers and targets, and whose distance it is, of those that are measured."""
        place = {key: k for k, key in enumerate(self._pursuit.keys)}
        pairs = [
            (self._row[sysid], self._row[target], place[key])
            for sysid, target in target_of.items()
            if (key := target if self._of_targets else sysid) in place
        ]
        return np.array(pairs, np.int64).reshape((-1, 3))


def _known(rows: Iterable[int], values: Floats) -> dict[int, float]:
    return {sysid: value for sysid, value in zip(rows, values.tolist(), strict=True) if not math.isnan(value)}


def distance_to_path(plan: Any, kept: int, oldest: int, count: int, n: float, e: float, d: float) -> float:
    """Distance of a point to the polyline of `count` points, from row `oldest` on, of a ring of points (kept, 3)."""
    least2 = math.INFINITY
    for i in range(count - 1):
        a, b = plan + 3 * ((oldest + i) % kept), plan + 3 * ((oldest + i + 1) % kept)
        along_n, along_e, along_d = b[0] - a[0], b[1] - a[1], b[2] - a[2]
        gap2, _ = segment_gap2(a[0] - n, a[1] - e, a[2] - d, along_n, along_e, along_d)
        least2 = min(least2, gap2)
    return math.sqrt(least2)


def _measure(
    flags: NDArray[np.uint8],
    places: Floats,
    figures: Floats,
    rows: Ints,
    planned: Floats,
    pairs: Ints,
    flown: Floats,
    plans: Floats,
    runs: Ints,
    ticks_s: Floats,
    tick: int,
    distances_m: Floats,
) -> None:
    """One tick of n vehicles, of `FleetColumns` flags, places and figures. They count while they are flying and fresh;
    their way from report to report does so too where the next report was long in coming.

    rows (k,), planned (k, 6): which have a set point, and what. pairs (m, 3): rows of pursuer and target, and the
    column of distances_m (1, j) that takes the least distance of those it is of, NaN where none is known. From call to
    call go on: flown (n, _FLOWN), as the struct Flown; plans (n, _KEPT, 3), the latest set points, each at its tick;
    runs (n, 2), the first and last tick of the latest that came without a break; ticks_s (_KEPT,), times up to `tick`.
    """
    for i in range(flown.shape[0]):
        own = flown_at(flown, i)
        if flags[FLYING, i] and not (flags[EMPTY, i] or math.isnan(own.way_m)):
            before_m = 0.0 if math.isnan(own.length_m) else own.length_m
            own.length_m = before_m + (figures[WAY, i] - own.way_m)
        own.way_m = figures[WAY, i] if flags[FLYING, i] else math.NAN
        if not (flags[FLYING, i] and flags[FRESH, i]):
            own.last[0] = math.NAN
            continue
        own.last[0], own.last[1], own.last[2] = places[P_NOW, i, 0], places[P_NOW, i, 1], places[P_NOW, i, 2]
    kept = plans.shape[1]
    for k in range(rows.shape[0]):
        i = rows[k]
        for axis in range(3):
            plans[i, tick % kept, axis] = planned[k, axis]
        if runs[i, 1] != tick - 1:
            runs[i, 0] = tick
        runs[i, 1] = tick
    for i in range(flown.shape[0]):
        own, reported_s = flown_at(flown, i), ticks_s[tick % kept] - figures[AGE, i]
        if math.isnan(own.last[0]) or reported_s <= own.reported_s + _ROUNDING_S:
            continue
        own.reported_s = reported_s
        at, first = tick, max(runs[i, 0], tick - kept + 1)
        while at >= first and ticks_s[at % kept] > reported_s + _ROUNDING_S:
            at -= 1
        if first <= at - _MEMORY + 1 and at <= runs[i, 1]:
            plan, oldest = cython.address(plans[i, 0, 0]), (at - _MEMORY + 1) % kept
            n, e, d = places[P_NED, i, 0], places[P_NED, i, 1], places[P_NED, i, 2]
            error_m = distance_to_path(plan, kept, oldest, _MEMORY, n, e, d)
            own.error_m = error_m if math.isnan(own.error_m) else max(own.error_m, error_m)
    for j in range(distances_m.shape[1]):
        distances_m[0, j] = math.NAN
    for k in range(pairs.shape[0]):
        a, b, j = flown_at(flown, pairs[k, 0]), flown_at(flown, pairs[k, 1]), pairs[k, 2]
        if not (math.isnan(a.last[0]) or math.isnan(b.last[0])):
            north, east, down = a.last[0] - b.last[0], a.last[1] - b.last[1], a.last[2] - b.last[2]
            distance_m = math.sqrt(north * north + east * east + down * down)
            if not distance_m >= distances_m[0, j]:
                distances_m[0, j] = distance_m
