"""Risk-aware recharging rendezvous, RRRP, as an integer linear program that is solved again and again (A. B. Asghar,
G. Shi, N. Karapetyan, J. Humann, J.-P. Reddinger, J. Dotterweich, P. Tokekar, arXiv 2209.06308, 2022).

As its abstract says [lineage], the rendezvous with chargers whose travel cost is least, under a matching constraint,
since each charger serves a limited number at a time, and a knapsack constraint, by which none runs out of charge with a
wanted probability:

    min Σ c_e x_e,    Σ_e of a receiver x_e = 1,    Σ_e of a rendezvous x_e <= 1,    Σ -log(p_e) x_e <= -log(1 - RISK)

[choice] Chargers of the paper have tasks of their own, and consumption is random. Here a tanker's rendezvous are its
next services, each a mean service and a mean way after the one before, and none without the one before. To the first
the tanker flies from where it is, to a later one a mean way from other receivers; that way is c_e, s. p_e is how likely
energy flows in time where consumption varies by VARIES (standard deviation over mean, normal); that of instances is
known, so that this is a margin, and an edge that would be too late is none. Where no choice serves all and keeps to
RISK, the program of the least risk, solved before, says how many are not served and which risk is taken.
"""

from __future__ import annotations

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.special import log_ndtr

from gcs.benchmark.arrays import Floats
from gcs.benchmark.peers.rolling import Jobs, Rolling
from skytender import elementary

RISK, VARIES = 0.05, 0.05
UNSERVED = 100.0
"""[choice] In place of -log(p) of a receiver without a rendezvous: more than the sum of all others."""


class Rendezvous(Rolling):
    """Edges (n, m · turns + 1): receivers by turns of tankers, turns of one tanker side by side, the last one none."""

    def plan(self, jobs: Jobs, seconds: float) -> dict[int, int] | None:
        """The first job of each tanker that has one; None where no plan was found."""
        cost_s, risk = edges(jobs)
        possible, risk = np.isfinite(risk), np.where(np.isfinite(risk), risk, 0.0)
        n, m, columns = len(jobs.receivers), len(jobs.tankers), cost_s.shape[1]
        place = np.eye(n * columns).reshape(n, columns, -1)
        of_turns = place[:, :-1].sum(axis=0).reshape(m, -1, n * columns)
        later = (of_turns[:, 1:] - of_turns[:, :-1]).reshape(-1, n * columns)
        limits = [
            LinearConstraint(place.sum(axis=1), 1.0, 1.0),
            LinearConstraint(of_turns.reshape(-1, n * columns), ub=1.0),
            LinearConstraint(later, ub=0.0),
        ]
        least = _solved(risk, possible, limits, 0.5 * seconds)
        if least is None:
            return None
        unserved = UNSERVED * float(least.reshape(n, columns)[:, -1].sum())
        most = max(float(risk.ravel() @ least), unserved - elementary.log(1.0 - RISK))
        safe = LinearConstraint(risk.reshape(1, -1), ub=most + 1e-6)
        best = _solved(cost_s, possible, [*limits, safe], 0.5 * seconds)
        chosen = (least if best is None else best).reshape(n, columns)[:, :-1].reshape(n, m, -1)[:, :, 0] > 0.5
        return {int(k): int(j) for j, k in zip(*np.nonzero(chosen), strict=True)}


def edges(jobs: Jobs) -> tuple[Floats, Floats]:
    """Ways, s, and -log of the probabilities of all edges; inf where an edge is none."""
    n, m = len(jobs.receivers), len(jobs.tankers)
    turns = -(-n // m) + 1
    mean_s = jobs.between_s.sum(axis=1) / max(n - 1, 1)
    ways_s = np.stack([jobs.first_s, *[mean_s] * (turns - 1)], axis=1)
    turn_s = mean_s.mean(axis=1) + jobs.takes_s.mean()
    opens_s = jobs.free_s[:, None] + turn_s[:, None] * np.arange(turns)
    meets_s = np.maximum(opens_s[:, :, None] + ways_s, jobs.from_s)
    spare_s = jobs.until_s - meets_s
    risk = -log_ndtr(spare_s / (VARIES * np.maximum(jobs.until_s, 1e-3)))
    risk[(spare_s < 0.0) | (meets_s > opens_s[:, :, None] + ways_s + turn_s[:, None, None])] = np.inf
    none = np.zeros((n, 1))
    return (
        np.concatenate([ways_s.reshape(-1, n).T, none], axis=1),
        np.concatenate([risk.reshape(-1, n).T, none + UNSERVED], axis=1),
    )


def _solved(costs: Floats, possible: np.ndarray, limits: list[LinearConstraint], seconds: float) -> Floats | None:
    """Zeros and ones of the least cost that was found in so many seconds on the clock, the only limit that HiGHS has of
    time: a few programs take minutes."""
    found = milp(
        costs.ravel(), integrality=np.ones(costs.size), bounds=Bounds(0.0, possible.ravel().astype(float)),
        constraints=limits, options={"time_limit": seconds},
    )  # fmt: skip
    return None if found.x is None else np.asarray(found.x)
