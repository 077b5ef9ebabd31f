"""Dispatching rules: each looks at the tankers that are free and the receivers that wait now."""

from __future__ import annotations

import numpy as np

from gcs.benchmark.peers.flight import DispatchedFlight
from skytender import elementwise

LATE_S = 1e4


class FirstToLand:
    """The receivers that land first, each by the nearest free tanker (C. L. Liu, J. W. Layland, J. ACM 20, 1973)."""

    def assign(self, flight: DispatchedFlight) -> dict[int, int]:
        """Receiver by tanker."""
        found: dict[int, int] = {}
        ways_s = flight.ways_s()
        for j in np.argsort(flight.slack_s(), kind="stable"):
            left = [k for k, t in enumerate(flight.free) if t not in found]
            if not left:
                break
            found[flight.free[min(left, key=lambda k: float(ways_s[k, j]))]] = flight.waiting[j]
        return found


class NearestPair:
    """The pair with the shortest way, then the next of those left."""

    def assign(self, flight: DispatchedFlight) -> dict[int, int]:
        """Receiver by tanker."""
        ways_s = flight.ways_s()
        return greedy(flight.free, flight.waiting, -ways_s)


class LeastWays:
    """Pairs with the least sum of ways (H. W. Kuhn, Naval Research Logistics Quarterly 2, 1955), by SciPy; a pair that
    would be too late comes last."""

    def assign(self, flight: DispatchedFlight) -> dict[int, int]:
        """Receiver by tanker."""
        from scipy.optimize import linear_sum_assignment  # noqa: PLC0415 - an extra

        ways_s = flight.ways_s()
        late = ways_s + flight.arrays.setup_s > flight.slack_s()
        rows, columns = linear_sum_assignment(ways_s + LATE_S * late)
        return {flight.free[k]: flight.waiting[j] for k, j in zip(rows, columns, strict=True)}


class ApparentTardiness:
    """Apparent tardiness cost with set-up times, ATCS (Y. H. Lee, K. Bhaskaran, M. Pinedo, IIE Transactions 29, 1997):
    the pair with the greatest index

        1/p_j · exp(-max(d_j - p_j - t, 0) / (K1 p)) · exp(-s_kj / (K2 s))

    where the set-up s_kj is the way and p_j the service. All receivers weigh the same, and d_j - p_j is when energy
    must flow at the latest, less the way and the setup.
    """

    K1, K2 = 2.0, 1.0
    """[choice]"""

    def assign(self, flight: DispatchedFlight) -> dict[int, int]:
        """Receiver by tanker."""
        ways_s, setup_s = flight.ways_s(), flight.arrays.setup_s
        service_s = setup_s + flight.takes_s(flight.waiting, flight.now_s + ways_s.min(axis=0) + setup_s)
        spare_s = np.maximum(flight.slack_s() - setup_s - ways_s, 0.0)
        index = (
            -elementwise.logarithms(service_s)
            - spare_s / (self.K1 * service_s.mean())
            - ways_s / (self.K2 * ways_s.mean())
        )
        return greedy(flight.free, flight.waiting, index - LATE_S * (ways_s + setup_s > flight.slack_s()))


def greedy(tankers: list[int], receivers: list[int], worth: np.ndarray) -> dict[int, int]:
    """The pair that is worth most, then the next of those left; rows are tankers, columns receivers."""
    found: dict[int, int] = {}
    for flat in np.argsort(-worth, axis=None, kind="stable"):
        k, j = divmod(int(flat), len(receivers))
        if tankers[k] not in found and receivers[j] not in found.values():
            found[tankers[k]] = receivers[j]
    return found
