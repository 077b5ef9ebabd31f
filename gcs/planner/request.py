"""Request to a planner: what one tick of planning is asked for, and by whom it is answered."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink.setpoints import SetPoint
from gcs.telemetry.state import FleetSnapshot, Vec3

_NONE: Mapping[int, Any] = MappingProxyType({})


class PlanRequest(NamedTuple):
    """One tick of planning; positions are in the common NED frame, m.

    steered: system ids of the vehicles that fly set points. rendezvous: the receiver above which each tanker is to
    stand; the two may come near each other. targets_move: whether targets fly on along their paths. period_s: until the
    next request. pursuing: the target of each pursuer while all others hold; None: each pursues its own. stations:
    vehicles that are to be at a place instead.
    """

    snapshot: FleetSnapshot
    steered: frozenset[int]
    period_s: float
    targets_move: bool = True
    rendezvous: Mapping[int, int] = _NONE
    pursuing: Mapping[int, int] | None = None
    stations: Mapping[int, Vec3] = _NONE


class TickPlanner(Protocol):
    """Planner of all steered vehicles."""

    obstacles: NDArray[np.float64]
    """obstacle table (gcs/scenario/geometry.py)"""

    def plan(self, request: PlanRequest) -> Sequence[SetPoint]:
        """Set points for the steered vehicles whose place is known, in order of system id, at the snapshot's time; the
        shipped ones give `SetPoints`."""

    def pop_records(self) -> list[dict[str, Any]]:
        """Decisions since the last call that the set points do not show; a planner that does not say has none."""
        return []

    def margin_m(self, sysid: int) -> float | None:
        """Distance that is added for a vehicle's tracking error; None without the safety filter."""
        return None

    def anchor(self, sysids: Sequence[int], p_ned: NDArray[np.float64]) -> None:
        """Go on planning from here: where the safety filter takes these k vehicles' planned points to, (k, 3) m NED."""
