"""Measures of a session, gathered tick by tick from snapshots: paths, tracking and pursuit."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from gcs.kernels import kernel
from gcs.scenario.model import Scenario
from gcs.telemetry.approach import segment_gap2
from gcs.telemetry.pursuit import PursuitHeld
from gcs.telemetry.state import FleetSnapshot, Vec3

if TYPE_CHECKING:
    from gcs.mavlink.setpoints import SetPoint

PLAN_MEMORY = 20
"""Set points against which a vehicle's way is held: it flies a few ticks behind its plan."""
UNKNOWN = (math.nan, math.nan, math.nan)


class Metrics:
    """Running figures of one session."""

    def __init__(self, scenario: Scenario) -> None:
        self.target_of = scenario.vehicles.followed
        self._of_targets = scenario.pursuit.by == "competition"
        within_m = scenario.goal.pursue.within_m if scenario.goal.pursue else math.inf
        targets = (target.sysid for target in scenario.vehicles.targets)
        self._pursuit = PursuitHeld(targets if self._of_targets else self.target_of, within_m)
        self._last: dict[int, Vec3] = {}
        self.path_length_m: dict[int, float] = {}
        self._row = {vehicle.sysid: row for row, vehicle in enumerate(scenario.vehicles.all)}
        count = len(self._row)
        self._plans, self._planned = np.zeros((count, PLAN_MEMORY, 3)), np.zeros(count, np.int64)
        self._errors_m = np.full(count, np.nan)

    def update(
        self,
        snapshot: FleetSnapshot,
        set_points: Sequence[SetPoint],
        pursuing: Mapping[int, int] | None = None,
    ) -> None:
        """Count one tick.

        `pursuing` says who pursues which target where one vehicle is chosen for each: it is then the targets that must
        have their pursuer near.
        """
        if pursuing is not None:
            self.target_of = dict(pursuing)
        here = {view.sysid: view.p_now_ned() for view in snapshot.vehicles if view.flying and view.fresh}
        self._measure_paths(here)
        self._measure_tracking(here, set_points)
        self._measure_pursuit(snapshot.time_s, here)

    @property
    def pursuit_held_s(self) -> float:
        """The longest time for which even the worst pursuer stayed with its target (or target had its pursuer)."""
        return self._pursuit.worst_s

    @property
    def max_tracking_error_m(self) -> dict[int, float]:
        """By system id, of those whose way was held against a plan."""
        return {sysid: m for sysid, m in zip(self._row, self._errors_m.tolist(), strict=True) if not math.isnan(m)}

    def _measure_paths(self, here: dict[int, Vec3]) -> None:
        lengths_m, last = self.path_length_m, self._last
        for sysid, p_ned in here.items():
            if sysid in last:
                lengths_m[sysid] = lengths_m.get(sysid, 0.0) + math.dist(p_ned, last[sysid])
        self._last = here

    def _measure_tracking(self, here: Mapping[int, Vec3], set_points: Sequence[SetPoint]) -> None:
        rows = np.array([self._row[point.sysid] for point in set_points], np.int64)
        planned = np.array([point.p_ned for point in set_points], np.float64).reshape(-1, 3)
        at = np.array([here.get(point.sysid, UNKNOWN) for point in set_points], np.float64).reshape(-1, 3)
        _track(rows, planned, at, self._plans, self._planned, self._errors_m)

    def _measure_pursuit(self, now_s: float, here: dict[int, Vec3]) -> None:
        if not self._pursuit.keys:
            return
        near_m: dict[int, float] = {}
        for sysid, target in self.target_of.items():
            if sysid in here and target in here:
                key = target if self._of_targets else sysid
                near_m[key] = min(math.dist(here[sysid], here[target]), near_m.get(key, math.inf))
        distances_m = [near_m.get(key, math.nan) for key in self._pursuit.keys]
        self._pursuit.update(np.array([now_s]), np.array([distances_m]).reshape(1, -1))


@kernel()
def distance_to_path(plan: NDArray[np.float64], oldest: int, n: float, e: float, d: float) -> float:
    """Distance of a point to the polyline of a ring of points (k, 3) that begins at row `oldest`."""
    least2 = math.inf
    count = plan.shape[0]
    for i in range(count - 1):
        a, b = (oldest + i) % count, (oldest + i + 1) % count
        along_n, along_e, along_d = plan[b, 0] - plan[a, 0], plan[b, 1] - plan[a, 1], plan[b, 2] - plan[a, 2]
        gap2, _ = segment_gap2(plan[a, 0] - n, plan[a, 1] - e, plan[a, 2] - d, along_n, along_e, along_d)
        least2 = min(least2, gap2)
    return math.sqrt(least2)


@kernel()
def _track(
    rows: NDArray[np.int64],
    planned: NDArray[np.float64],
    at: NDArray[np.float64],
    plans: NDArray[np.float64],
    counts: NDArray[np.int64],
    errors_m: NDArray[np.float64],
) -> None:
    """Kernel: one tick's set points (k, 3) of the vehicles `rows`, and where these are, NaN where that is not to be
    counted. Of all n vehicles go on from call to call: plans (n, PLAN_MEMORY, 3) and counts (n,), the latest set points
    and how many there were without a break; errors_m (n,), the greatest distance, NaN before the first."""
    memory = plans.shape[1]
    there = np.zeros(counts.size, dtype=np.bool_)
    for k in range(rows.size):
        row = rows[k]
        there[row] = True
        plan, newest = plans[row], counts[row] % memory
        for axis in range(3):
            plan[newest, axis] = planned[k, axis]
        counts[row] += 1
        if counts[row] >= memory and not math.isnan(at[k, 0]):
            error_m = distance_to_path(plan, (newest + 1) % memory, at[k, 0], at[k, 1], at[k, 2])
            if math.isnan(errors_m[row]):
                errors_m[row] = 0.0
            errors_m[row] = max(errors_m[row], error_m)
    for row in range(counts.size):
        if not there[row]:
            counts[row] = 0
