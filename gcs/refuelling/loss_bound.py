"""How many vehicles no schedule could have kept (docs/model/competition.md#least-losses) [choice].

A relaxation that every schedule obeys: until t, each tanker delivers at most its rate since energy could first flow,
and no more than it can spare; ways and pauses cost nothing, and what it gives is shared at will. A vehicle that still
flies at t has needed at least what it drew beyond its charge. So no more of them fly at t than of the smallest such
needs fit into what was delivered, and the least of that over t bounds how many are kept until the end.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

STEPS = 400


def least_lost(
    left_j: ArrayLike, power_w: ArrayLike, *, end_s: float, rate_w: float, spare_j: ArrayLike, first_s: float = 0.0
) -> int:
    """At least so many of n vehicles are lost until `end_s`, whatever is done.

    left_j (n,): charge above that at which a vehicle lands, J. power_w (n,): draw, W. spare_j (m,): what each tanker
    can give, J. rate_w: of one transfer, W. first_s: before it no energy can flow, s.
    """
    left, power = np.asarray(left_j, dtype=np.float64), np.asarray(power_w, dtype=np.float64)
    spare = np.asarray(spare_j, dtype=np.float64)
    most_kept = len(left)
    for t in np.linspace(0.0, end_s, STEPS + 1)[1:]:
        needs = np.sort(np.maximum(power * t - left, 0.0))
        delivered_j = float(np.minimum(rate_w * max(t - first_s, 0.0), spare).sum())
        most_kept = min(most_kept, int((np.cumsum(needs) <= delivered_j + 1e-6).sum()))
    return len(left) - most_kept
