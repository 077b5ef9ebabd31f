"""Who is next: the state against an adaptive solver, decisions against the rules in
docs/protocol/energy.md#refuelling-schedule."""

import itertools
from typing import Any

import numpy as np
import pytest
import views as base
from scipy.integrate import solve_ivp

from gcs.mavlink.autopilots import FlightMode
from gcs.refuelling.bidding import NeedBidding
from gcs.scenario.model import CompetitionRules
from gcs.telemetry.state import FleetSnapshot, VehicleView

RULES = CompetitionRules(p=2.0, rate=5.0, need_from=0.5, dwell_s=2.0, decide_within_s=30.0)


def view(sysid: int, need: float, role: str = "pursuer", **changed: Any) -> VehicleView:
    return base.view(sysid, role, **({"p_ned": (0.0, 0.0, -5.0), "drawn_j": 1e4 * need} | changed))


TANKER = view(200, 0.0, "tanker")


def run(bidding: NeedBidding, views: list[VehicleView], until_s: float, from_s: float = 0.0, served: Any = ()) -> Any:
    """Ticks of 0.1 s until someone wins: (time, (winner, by)), or (until_s, None)."""
    for k in itertools.count():
        now_s = from_s + k / 10
        if now_s > until_s + 1e-9:
            return until_s, None
        snapshot = FleetSnapshot(now_s, tuple(views), ())
        bidding.advance(snapshot, served)
        won = bidding.winner_at([TANKER.p_now_ned()], snapshot, 5.0, 20.0)
        if won is not None:
            return now_s, won
    raise AssertionError


def test_the_state_is_the_solution_of_the_law() -> None:
    """Only until a loser reaches the floor, to which it is then lifted."""
    bidding = NeedBidding(RULES)
    needs = {1: 0.6, 2: 0.9, 3: 0.75}
    run(bidding, [view(sysid, need) for sysid, need in needs.items()], 0.4)
    tau = np.array([0.01, 1.0, 0.505])  # min-max by hand
    solved = solve_ivp(
        lambda _, v: 5.0 * (tau - (v**2).sum()) * v, (0, 0.4), [0.01] * 3, method="DOP853", rtol=1e-10, atol=1e-13
    ).y[:, -1]
    assert list(bidding.competition_state.tau.values()) == pytest.approx(tau)
    assert list(bidding.competition_state.v.values()) == pytest.approx(solved, rel=1e-6)
    assert bidding.competition_state.need == pytest.approx(needs)


def test_the_neediest_wins_after_leading_for_the_dwell_time() -> None:
    bidding = NeedBidding(RULES)
    views = [view(1, 0.6), view(2, 0.9), view(3, 0.75)]
    leads_s = None
    for k in range(200):
        snapshot = FleetSnapshot(k / 10, tuple(views), ())
        bidding.advance(snapshot, ())
        if leads_s is None and bidding.competition_state.share >= RULES.share:
            leads_s = k / 10
        won = bidding.winner_at([TANKER.p_now_ned()], snapshot, 5.0, 20.0)
        if won is not None:
            break
    assert won == (2, "competition")
    assert leads_s is not None
    assert k / 10 - leads_s == pytest.approx(RULES.dwell_s)


def test_a_lead_that_is_interrupted_begins_anew() -> None:
    bidding = NeedBidding(RULES.model_copy(update={"dwell_s": 6.0}))
    assert run(bidding, [view(1, 0.6), view(2, 0.9)], 5.0)[1] is None
    assert bidding.competition_state.leader == 2
    time_s, won = run(bidding, [view(1, 0.95), view(2, 0.9)], 30.0, from_s=5.1)
    assert won == (1, "competition")
    assert time_s >= 5.1 + 6.0


def test_equal_needs_are_won_by_the_lowest_id() -> None:
    time_s, won = run(NeedBidding(RULES), [view(sysid, 0.7) for sysid in (4, 7, 9)], 30.0)
    assert (won, time_s < 10) == ((4, "competition"), True)


def test_one_alone_wins_with_the_highest_bid() -> None:
    bidding = NeedBidding(RULES)
    assert run(bidding, [view(5, 0.55)], 30.0)[1] == (5, "competition")
    assert bidding.competition_state.tau == {5: 1.0}


def test_a_near_tie_is_cut_short_for_the_largest_v() -> None:
    """With many between them, a gap of one in a thousand of the bids takes minutes at rate 5."""
    views = [view(1, 0.5001), view(2, 0.9), view(3, 0.8999)]
    time_s, won = run(NeedBidding(RULES), views, 100.0)
    assert won == (2, "timeout")
    assert time_s == pytest.approx(RULES.decide_within_s, abs=0.11)


def test_whoever_would_not_last_is_served_first_the_shortest_first() -> None:
    views = [view(1, 0.9), view(2, 0.6, power_w=400.0), view(3, 0.6, power_w=300.0)]
    # 4000 J last 10 s and 13 s; 20 s are needed.
    assert run(NeedBidding(RULES), views, 10.0) == (0.0, (2, "urgency"))


@pytest.mark.parametrize(("away_m", "urgent"), [(50.0, True), (40.0, False)])
def test_urgency_counts_the_tankers_way(away_m: float, urgent: bool) -> None:
    """4000 J at 140 W last 28.6 s; the way at 5 m/s takes 10 s or 8 s, and 20 s are kept."""
    views = [view(2, 0.6, power_w=140.0, p_ned=(away_m, 0.0, -5.0))]
    assert (run(NeedBidding(RULES), views, 0.0)[1] is not None) is urgent


@pytest.mark.parametrize(
    "changed", [{"mode": FlightMode.LAND}, {"mode": FlightMode.HOLD}, {"armed": False}, {"landed": True},
                {"alive": False}, {"p_ned": None}, {"role": "target"}, {"drawn_j": 4900.0}]
)  # fmt: skip
def test_only_who_can_receive_and_needs_it_competes(changed: dict[str, Any]) -> None:
    bidding = NeedBidding(RULES)
    bidding.advance(FleetSnapshot(0.0, (view(1, 0.6), view(2, 0.9)._replace(**changed)), ()), ())
    assert set(bidding.competition_state.v) == {1}


def test_who_is_served_does_not_compete() -> None:
    bidding = NeedBidding(RULES)
    assert run(bidding, [view(1, 0.6), view(2, 0.9)], 30.0, served={2})[1] == (1, "competition")
    bidding.advance(FleetSnapshot(99.0, (view(1, 0.6),), ()), {1})
    assert bidding.competition_state.v == {}
    assert bidding.winner_at([TANKER.p_now_ned()], FleetSnapshot(99.0, (view(1, 0.6),), ()), 5.0, 20.0) is None


def test_after_an_award_the_loser_comes_back_and_takes_its_own_dwell_time() -> None:
    bidding = NeedBidding(RULES)
    views = [view(1, 0.6), view(2, 0.9)]
    first_s, won = run(bidding, views, 30.0)
    assert won == (2, "competition")
    assert bidding.competition_state.v[1] == RULES.floor
    bidding.award(2, first_s)
    snapshot = FleetSnapshot(first_s, tuple(views), ())
    assert set(bidding.competition_state.v) == {1}
    assert bidding.winner_at([TANKER.p_now_ned()], snapshot, 5.0, 20.0) is None
    second_s, won = run(bidding, views, 60.0, from_s=first_s + 0.1, served={2})
    assert won == (1, "competition")
    assert second_s - first_s >= RULES.dwell_s


def test_a_former_loser_wins_when_its_need_becomes_the_greatest() -> None:
    bidding = NeedBidding(RULES)
    for k in range(100):
        bidding.advance(FleetSnapshot(k / 10, (view(1, 0.6), view(2, 0.9)), ()), ())
    assert bidding.competition_state.leader == 2
    for k in range(100, 200):
        bidding.advance(FleetSnapshot(k / 10, (view(1, 0.9), view(2, 0.6)), ()), ())
    assert bidding.competition_state.leader == 1


def test_urgency_also_serves_one_that_is_not_needy_enough_to_compete() -> None:
    """A need of 0.3 leaves 7000 J, which last 17.5 s at 400 W; 20 s are kept."""
    views = [view(1, 0.6), view(2, 0.3, power_w=400.0)]
    assert run(NeedBidding(RULES), views, 10.0) == (0.0, (2, "urgency"))
