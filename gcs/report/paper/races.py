"""The competition of control efforts: the winner, the time, and whether the losers vanish
(docs/model/competition.md#competition; paper eqs. 1, 2, 22).

v_i' = c (τ_i - Σ v_j^p) v_i,   τ and v(0) min-max to [0.01, 1]
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Literal

import numpy as np
from scipy.integrate import solve_ivp

from gcs.recording.series import Floats
from gcs.refuelling.simulated_competition import simulate
from gcs.report.paper.session import RecordedFlight
from skytender.winner_take_all import advance, normalise

Criterion = Literal["ratio", "share"]

LOW, HIGH = 0.01, 1.0
EVENTUALLY_S = 1000.0
FASTEST_S, LATEST_S = 1e-6, 1e7


def efforts(flights: Sequence[RecordedFlight]) -> Floats:
    """Control effort (n,) that each vehicle reported up to its own arrival at the end."""
    return np.array([float(f.effort_at(f.arrived_s)) for f in flights])


def initial_states(flights: Sequence[RecordedFlight]) -> Floats:
    """v(0) (n,): initial speeds, normalised (paper eq. 22)."""
    return normalise([float(np.linalg.norm(f.v[0])) for f in flights], low=LOW, high=HIGH)


def least_wins(effort: Floats) -> Floats:
    """τ (n,) of a competition that the least control effort wins."""
    return normalise(effort, low=LOW, high=HIGH, largest_wins=False)


def remoteness(v: Floats, tau: Floats, p: float) -> float:
    """Greatest distance of the states (n,) from what they must come to: τ^(1/p) for the greatest τ, 0 for others."""
    limit = np.zeros_like(tau)
    limit[tau.argmax()] = tau.max() ** (1.0 / p)
    return float(np.abs(v - limit).max())


def eventually(v0: Floats, tau: Floats, *, p: float, rate: float = 1.0) -> Floats:
    """States (n,) after EVENTUALLY_S."""
    return advance(v0, tau, EVENTUALLY_S, p=p, rate=rate)


def time_to_win(v0: Floats, tau: Floats, *, p: float, rate: float, criterion: Criterion) -> float:
    """First time in s at which the race is over, by bisection: both measures only ever rise.

    `ratio`: every other v below 1 % of the winner's. `share`: the winner's v^p at least 0.9 of all. Infinite where two
    share the greatest τ and the race is never over.
    """
    winner = int(tau.argmax())

    def over(time_s: float) -> bool:
        v = advance(v0, tau, time_s, p=p, rate=rate)
        if criterion == "ratio":
            return bool(np.delete(v, winner).max(initial=0.0) < 0.01 * v[winner])
        return bool(v[winner] ** p >= 0.9 * (v**p).sum())

    if over(FASTEST_S):
        return 0.0
    if not over(LATEST_S):
        return float("inf")
    early, late = FASTEST_S, LATEST_S
    while late - early > 1e-6 * late:
        middle = np.sqrt(early * late)
        early, late = (early, middle) if over(middle) else (middle, late)
    return float(late)


def solver_error(v0: Floats, tau: Floats, *, p: float, duration_s: float, rtol: float = 1e-10) -> float:
    """Greatest difference between the closed form and scipy's adaptive solver over `duration_s`, c = 1.

    They are compared at the solver's own steps, where its error is controlled. Its trial points may lie below zero,
    hence |v|.
    """

    def slope(_: float, v: Floats) -> Floats:
        return np.asarray((tau - (np.abs(v) ** p).sum()) * v)

    solved = solve_ivp(slope, (0.0, duration_s), v0, "DOP853", rtol=rtol, atol=1e-14)
    return float(np.abs(solved.y.T - simulate(v0, tau, solved.t, p=p, rate=1.0)).max())


def dynamic(
    flights: Sequence[RecordedFlight], times_s: Floats, v0: Floats, *, since_s: float = 0.0
) -> tuple[Floats, Floats]:
    """States (k, n) and efforts (k, n) at `times_s` (k,) of a race that the greatest effort since `since_s` wins.

    τ of each interval is that of the reports at its end; p = 2, c = 1.
    """
    effort = np.column_stack([f.effort_at(times_s) - f.effort_at(since_s) for f in flights])
    tau = np.array([normalise(row, low=LOW, high=HIGH) for row in effort])
    return simulate(v0, np.concatenate((tau[1:], tau[-1:])), times_s, p=2.0, rate=1.0), effort


def served_in_fifths(flights: Sequence[RecordedFlight], end_s: float) -> list[int]:
    """System ids in the order in which the race of the efforts of each fifth of the time serves them."""
    left, order = list(flights), []
    v = initial_states(flights)
    for k in range(len(flights)):
        times = np.linspace(k, k + 1.0, 15) * end_s / len(flights)
        states, _ = dynamic(left, times, v, since_s=float(times[0]))
        winner = int(states[-1].argmax())
        order.append(left.pop(winner).sysid)
        v = np.delete(states[-1], winner)
    return order


def disturbed(run: Callable[[], Floats]) -> Floats | None:
    """States of a simulation, or None where they grow beyond all bounds."""
    try:
        return run()
    except ArithmeticError:
        return None
