"""Measures of a session, gathered tick by tick from snapshots: paths, tracking and pursuit."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
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


class Metrics:
    """Running figures of one session."""

    def __init__(self, scenario: Scenario) -> None:
        self.target_of = scenario.vehicles.followed
        self._of_targets = scenario.pursuit.by == "competition"
        within_m = scenario.goal.pursue.within_m if scenario.goal.pursue else math.inf
        targets = (target.sysid for target in scenario.vehicles.targets)
        self._pursuit = PursuitHeld(targets if self._of_targets else self.target_of, within_m)
        self._last: dict[int, Vec3] = {}
        self._plans: dict[int, NDArray[np.float64]] = {}
        self._planned: dict[int, int] = {}
        self.path_length_m: dict[int, float] = {}
        self.max_tracking_error_m: dict[int, float] = {}

    def update(
        self,
        snapshot: FleetSnapshot,
        set_points: Iterable[SetPoint],
        pursuing: Mapping[int, int] | None = None,
    ) -> None:
        """Count one tick.

        `pursuing` says who pursues which target where one vehicle is chosen for each: it is then the targets that must
        have their pursuer near.
        """
        if pursuing is not None:
            self.target_of = dict(pursuing)
        here = {view.sysid: view.p_now_ned() for view in snapshot.vehicles if view.flying and view.fresh}
        self._measure_paths(here, {point.sysid: point.p_ned for point in set_points})
        self._measure_pursuit(snapshot.time_s, here)

    @property
    def pursuit_held_s(self) -> float:
        """The longest time for which even the worst pursuer stayed with its target (or target had its pursuer)."""
        return self._pursuit.worst_s

    def _measure_paths(self, here: dict[int, Vec3], planned: dict[int, Vec3]) -> None:
        for sysid, p_ned in here.items():
            if sysid in self._last:
                self.path_length_m[sysid] = self.path_length_m.get(sysid, 0.0) + math.dist(p_ned, self._last[sysid])
        self._last = here
        for sysid in self._plans.keys() - planned.keys():
            del self._plans[sysid], self._planned[sysid]
        for sysid, point in planned.items():
            plan = self._plans.setdefault(sysid, np.empty((PLAN_MEMORY, 3)))
            count = self._planned.get(sysid, 0)
            plan[count % PLAN_MEMORY] = point
            self._planned[sysid] = count + 1
            if sysid in here and count + 1 >= PLAN_MEMORY:
                error_m = float(distance_to_path(plan, (count + 1) % PLAN_MEMORY, *here[sysid]))
                self.max_tracking_error_m[sysid] = max(self.max_tracking_error_m.get(sysid, 0.0), error_m)

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
