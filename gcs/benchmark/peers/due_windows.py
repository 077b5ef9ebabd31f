"""Index rules of the aerial refuelling scheduling problem: parallel tankers, ready times, and a window from a due date
to a deadline (S. Kaplan, G. Rabadi, Computers & Industrial Engineering 62, 2012, pp. 276-285; S. Kaplan, thesis, Old
Dominion University, 2011).

Both are as far as the abstracts say, since the formulas were not in reach: jobs have ready times r_j, due dates d_j and
deadlines D_j, the cost of tardiness is piecewise by the window between these two, and the rules change ATC (A. P. J.
Vepsalainen, T. E. Morton, Management Science 33, 1987). What ready times do to an index is of ATCSR (M. E. Pfund,
J. W. Fowler, A. Gadkari, Y. Chen, Computers & Industrial Engineering 54, 2008) without set-ups [lineage]:

    w_j / p_j · exp(-max(d_j - p_j - max(r_j, t), 0) / (K1 p)) · exp(-max(r_j - t, 0) / (K3 p))

[choice] r_j is when a receiver begins to wait, D_j when it lands, and D_j - d_j WINDOW of the time for which a full one
flies. A service is in time if energy flows, so that only the way and the setup of p_j stand in the first exponent; p_j
is the way, the setup and the flow. r_j - t is what the tanker would wait beside its way. A tanker whose best receiver
does not wait yet keeps itself free.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gcs.benchmark.arrays import Floats
from gcs.benchmark.peers.dispatching import LATE_S, greedy
from gcs.benchmark.peers.flight import WANTS_FROM, DispatchedFlight
from skytender import elementwise

WINDOW, K3 = 0.05, 0.1
"""[choice] Like K1 and STEEPER among the best of a dozen that were tried on 33 tuning instances."""


class Windows(NamedTuple):
    """Due dates and deadlines of n receivers, for m free tankers; s."""

    due_spare_s: Floats
    """(m, n) until the due date, if the tanker sets off now or as soon as the receiver waits; below 0 after it"""
    deadline_spare_s: Floats
    """(m, n)"""
    mean_s: float
    """of a service"""

    @property
    def lasts_s(self) -> Floats:
        """(m, n) from the due date to the deadline."""
        return self.deadline_spare_s - self.due_spare_s


class ModifiedTardiness:
    """Modified ATC: w_j is 1 / (D_j - d_j) [choice], by which tardiness costs 1 at the deadline."""

    K1 = 0.5

    def assign(self, flight: DispatchedFlight) -> dict[int, int]:
        """Receiver by tanker, of all in the air."""
        arrays, receivers, setup_s = flight.arrays, flight.flying(), flight.arrays.setup_s
        ways_s, lands_s = flight.ways_s(receivers), flight.lands_s[receivers] - flight.now_s
        meets_s = np.maximum(ways_s, flight.holds_in_s(receivers, WANTS_FROM))
        flows_s = flight.takes_s(receivers, flight.now_s + meets_s.min(axis=0) + setup_s)
        service_s = ways_s + setup_s + flows_s
        mean_s = float(service_s.mean())
        spare_s, lasts_s = lands_s - setup_s - meets_s, WINDOW * (arrays.holds_j / arrays.power_w)[receivers]
        index = elementwise.logarithms(self.urgency(Windows(spare_s - lasts_s, spare_s, mean_s)) / service_s)
        index -= (meets_s - ways_s) / (K3 * mean_s) + LATE_S * (spare_s < 0.0)
        return greedy(flight.free, receivers, index)

    def urgency(self, windows: Windows) -> Floats:
        """(m, n) w_j, less for what is not due yet."""
        return discounted(windows.due_spare_s, self.K1 * windows.mean_s) / windows.lasts_s


class PiecewiseTardiness(ModifiedTardiness):
    """Apparent piecewise tardiness cost with release times, APTCR. Its cost rises by 1 a second from the due date on
    and by STEEPER more from the deadline on: a sum of two costs of tardiness, and the index the sum of both ATC
    indices [choice]."""

    K1, STEEPER = 2.0, 10.0

    def urgency(self, windows: Windows) -> Floats:
        """(m, n) what a second later costs, less for what is not due yet."""
        due, deadline = (discounted(spare_s, self.K1 * windows.mean_s) for spare_s in windows[:2])
        return due + self.STEEPER * deadline


def discounted(spare_s: Floats, over_s: float) -> Floats:
    """exp(-max(spare, 0) / over)."""
    return elementwise.exponentials(-np.maximum(spare_s, 0.0) / over_s)
