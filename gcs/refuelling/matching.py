"""Receivers matched to givers by the least time (H. W. Kuhn, Naval Research Logistics Quarterly 2, 1955)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gcs.assignment import least_cost
from gcs.refuelling.giver import Giver
from gcs.telemetry.state import VehicleView


def match(givers: Sequence[Giver], receivers: Sequence[VehicleView]) -> list[tuple[Giver, VehicleView]]:
    """Pairs, as many as there can be, of which the sum of the ways' times is least; in the givers' order.

    Of equal sums the one that `least_cost` names, which depends on nothing but the numbers.
    """
    if not givers or not receivers:
        return []
    cost_s = np.array([[giver.way_s(view) for view in receivers] for giver in givers])
    rows, columns = least_cost(cost_s)
    return [(givers[i], receivers[j]) for i, j in zip(rows, columns, strict=True)]
