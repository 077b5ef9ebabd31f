"""Measures of a session, gathered tick by tick from snapshots: paths, tracking and pursuit."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import cython
import numpy as np
from cython.cimports.gcs.telemetry.approach import segment_gap2
from cython.cimports.gcs.telemetry.metrics import EMPTY, FLYING, FRESH, P_NOW, WAY, flown_at
from cython.cimports.libc import math
from numpy.typing import NDArray

from gcs.mavlink.setpoints import SetPoint, SetPoints
from gcs.scenario.model import Scenario
from gcs.telemetry.approach import Ints
from gcs.telemetry.columns import FIGURES, FLAGS, PLACES, Flags, FleetColumns, Floats
from gcs.telemetry.pursuit import PursuitHeld
from gcs.telemetry.state import FleetSnapshot

_FLOWN = 6
_LENGTH, _ERROR = 4, 5
PLAN_MEMORY = 20
"""Set points against which a vehicle's way is held: it flies a few ticks behind its plan."""


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
        self._plans, self._planned = np.zeros((count, PLAN_MEMORY, 3)), np.zeros(count, np.int64)
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
        self._measure(snapshot.columns, self._rows, points.values, self._pairs)
        if self._pursuit.keys:
            self._time_s[0] = snapshot.time_s + late_s
            self._pursuit.update(self._time_s, self._distances_m)

    def finish(self, snapshot: FleetSnapshot) -> None:
        """Count the way to the last reports: at the session's end nothing is planned, and no pursuit is measured."""
        self._measure(snapshot.columns, np.empty(0, np.int64), np.empty((0, 6)), np.empty((0, 3), np.int64))

    def _measure(self, columns: FleetColumns, rows: Ints, planned: Floats, pairs: Ints) -> None:
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
            self._planned,
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
        """By system id, of those whose way was held against a plan."""
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


def distance_to_path(plan: Any, count: int, oldest: int, n: float, e: float, d: float) -> float:
    """Distance of a point to the polyline of a ring of points (count, 3) that begins at row `oldest`."""
    least2 = math.INFINITY
    for i in range(count - 1):
        a, b = plan + 3 * ((oldest + i) % count), plan + 3 * ((oldest + i + 1) % count)
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
    counts: Ints,
    distances_m: Floats,
) -> None:
    """One tick of n vehicles, of `FleetColumns` flags, places and figures. They count while they are flying and fresh;
    their way from report to report does so too where the next report was long in coming.

    rows (k,), planned (k, 6): which have a set point, and what. pairs (m, 3): rows of pursuer and target, and the
    column of distances_m (1, j) that takes the least distance of those it is of, NaN where none is known. From call to
    call go on: flown (n, _FLOWN), as the struct Flown; plans (n, PLAN_MEMORY, 3) and counts (n,), the latest set points
    and how many there were without a break.
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
    memory = plans.shape[1]
    for i in range(counts.shape[0]):
        counts[i] = -1 - counts[i]  # until it is known whether it has a set point
    for k in range(rows.shape[0]):
        i = rows[k]
        own, before = flown_at(flown, i), -1 - counts[i]
        newest = before % memory
        for axis in range(3):
            plans[i, newest, axis] = planned[k, axis]
        counts[i] = before + 1
        if before + 1 >= memory and not math.isnan(own.last[0]):
            oldest, plan = (newest + 1) % memory, cython.address(plans[i, 0, 0])
            error_m = distance_to_path(plan, memory, oldest, own.last[0], own.last[1], own.last[2])
            own.error_m = error_m if math.isnan(own.error_m) else max(own.error_m, error_m)
    for i in range(counts.shape[0]):
        counts[i] = max(counts[i], 0)
    for j in range(distances_m.shape[1]):
        distances_m[0, j] = math.NAN
    for k in range(pairs.shape[0]):
        a, b, j = flown_at(flown, pairs[k, 0]), flown_at(flown, pairs[k, 1]), pairs[k, 2]
        if not (math.isnan(a.last[0]) or math.isnan(b.last[0])):
            north, east, down = a.last[0] - b.last[0], a.last[1] - b.last[1], a.last[2] - b.last[2]
            distance_m = math.sqrt(north * north + east * east + down * down)
            if not distance_m >= distances_m[0, j]:
                distances_m[0, j] = distance_m
