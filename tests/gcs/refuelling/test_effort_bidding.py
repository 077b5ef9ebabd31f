"""The competition by control energy: who has used most since energy last arrived, as soon as the law itself says."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from views import snapshot, view

from gcs.refuelling.bidding import EffortBidding
from gcs.refuelling.policy_bidding import make_competition
from gcs.scenario.model import CompetitionRules, RefuellingRules
from gcs.telemetry.state import VehicleView

RULES = CompetitionRules(
    bids="effort", p=2.0, rate=1.0, share=0.9999, need_from=0.0, dwell_s=0.0, decide_within_s=1000.0
)
TANKER = view(200, "tanker")


def used(sysid: int, effort: float, received_j: int = 0) -> VehicleView:
    return view(sysid, control_effort=effort, received_j=received_j, initial_j=10_000.0 - received_j)


def decided(bidding: EffortBidding, views: list[VehicleView], from_s: float = 0.0, until_s: float = 99.0) -> object:
    """(time, who) of the next decision in ticks of 0.1 s."""
    for now_s in np.arange(from_s, until_s, 0.1):
        now = snapshot(*views, TANKER, time_s=float(now_s))
        bidding.advance(now, ())
        if (won := bidding.winner_at([TANKER.p_now_ned()], now, 5.0, 0.0)) is not None:
            assert won[1] == "competition"
            return round(float(now_s), 1), won[0]
    return None


def test_the_most_effort_wins_when_the_others_are_below_a_hundredth_of_it() -> None:
    tau = np.array([0.01, 1.0, 0.703])  # min-max by hand of 500, 600, 570

    def over(_: float, v: np.ndarray) -> float:
        above = np.maximum(np.asarray(v), 0.01) ** 2 - 1e-4  # the floor, to which losers are lifted
        return float(above.max() / max(above.sum(), 1e-12) - 0.9999) if above.max() > 0.25 else -1.0

    over.terminal = True  # type: ignore[attr-defined]
    law = solve_ivp(lambda _, v: (tau - (v**2).sum()) * v, (0, 99), [0.01] * 3, "DOP853", rtol=1e-10, events=over)
    found = decided(EffortBidding(RULES), [used(1, 500.0), used(2, 600.0), used(3, 570.0)])
    assert found == (pytest.approx(law.t_events[0][0], abs=0.11), 2)


def test_who_has_been_refuelled_counts_from_zero_again() -> None:
    bidding = EffortBidding(RULES)
    first = decided(bidding, [used(1, 500.0), used(2, 600.0), used(3, 520.0)])
    assert first is not None
    views = [used(1, 500.0), used(2, 610.0, received_j=9000), used(3, 520.0)]
    bidding.advance(snapshot(*views, TANKER, time_s=60.0), ())
    assert bidding.competition_state.tau == pytest.approx({1: 0.01 + 0.99 * 500 / 520, 2: 0.01, 3: 1.0})
    views[1] = used(2, 1131.0, received_j=9000)  # 521 since
    bidding.advance(snapshot(*views, TANKER, time_s=60.1), ())
    assert max(bidding.competition_state.tau, key=lambda sysid: bidding.competition_state.tau[sysid]) == 2


def test_need_from_holds_and_the_scenario_names_it() -> None:
    rules = RULES.model_copy(update={"need_from": 0.5})
    bidding = make_competition(rules, RefuellingRules())
    assert isinstance(bidding, EffortBidding)
    full, empty = used(1, 900.0)._replace(drawn_j=1000.0), used(2, 100.0)._replace(drawn_j=6000.0)
    bidding.advance(snapshot(full, empty, TANKER, time_s=0.0), ())
    assert list(bidding.competition_state.tau) == [2]
    assert math.isclose(bidding.competition_state.need[2], 0.6)
