"""Who wins by time, how soon and for which giver: cases made by hand, and random fleets against the bids themselves."""

import math

import numpy as np
import pytest
from scipy.optimize import linear_sum_assignment

from gcs.refuelling.time_bidding import TimeBidding
from gcs.scenario.model import CompetitionRules, RefuellingRules
from gcs.telemetry.state import FleetSnapshot
from tests.support.competing import TIMES, decide, giver, pursuer

RULES = CompetitionRules(bids="time")


@pytest.mark.parametrize(("n", "k", "within_s", "seeds"), [(12, 4, 6.0, 5), (200, 8, 15.0, 1)])
def test_as_many_win_at_once_as_tankers_are_free(n: int, k: int, within_s: float, seeds: int) -> None:
    """Random fleets, near ties and all: never by time-out, and no winner bids less than who ties with the last one."""
    for seed in range(seeds):
        rng = np.random.default_rng(seed)
        lasts = rng.uniform(22.0, 45.0, n)
        views = [pursuer(i + 1, float(s), (*rng.uniform(-50, 50, 2), -5.0)) for i, s in enumerate(lasts)]
        givers = [giver(200 + j, (*rng.uniform(-50, 50, 2), -6.0)) for j in range(k)]
        bidding = TimeBidding(RULES, RefuellingRules())
        at_s, found = decide(bidding, views, givers)
        assert at_s <= within_s
        assert {by for _, _, by in found} <= {"competition", "urgency"}
        assert len({receiver for _, receiver, _ in found}) == len({name for name, *_ in found}) == k
        won = {receiver for _, receiver, _ in found}
        served = [s for sysid, s in bidding.bids_s.items() if sysid in won]
        passed = [s for sysid, s in bidding.bids_s.items() if sysid not in won]
        assert max(served) <= min(passed) + 2.0 * RULES.tie_s + 0.5


def test_winners_are_matched_so_that_the_way_is_least() -> None:
    rng = np.random.default_rng(3)
    for _ in range(10):
        n, k = 12, int(rng.integers(2, 9))
        views = [pursuer(i + 1, 20.0 + 2.0 * i, (*rng.uniform(-40, 40, 2), -5.0)) for i in range(n)]
        givers = [giver(200 + j, (*rng.uniform(-40, 40, 2), -6.0)) for j in range(k)]
        _, found = decide(TimeBidding(RULES, RefuellingRules()), views, givers)
        at = {v.sysid: v.p_now_ned() for v in views}
        way_m = sum(math.dist(next(g.p_ned for g in givers if g.name == name), at[who]) for name, who, _ in found)
        cost = np.array([[math.dist(g.p_ned, at[who]) for _, who, _ in found] for g in givers])
        least_m = cost[linear_sum_assignment(cost)].sum()
        assert way_m <= 1.0001 * least_m


def test_a_faster_tanker_takes_the_farther_one() -> None:
    near, far = pursuer(1, 30.0, (10.0, 0.0, -6.0)), pursuer(2, 30.0, (60.0, 0.0, -6.0))
    _, found = decide(
        TimeBidding(RULES, RefuellingRules()), [near, far], [giver(201, speed=2.0), giver(202, speed=10.0)]
    )
    assert sorted(found) == [(201, 1, "unopposed"), (202, 2, "unopposed")]


def test_bids_are_times_not_shares() -> None:
    """The larger battery is the emptier one and lasts longer; the small one wins."""
    large = pursuer(1, 60.0, drawn_j=50_000.0)._replace(capacity_j=70_000.0, initial_j=65_500.0)
    small = pursuer(2, 25.0)
    assert large.need > small.need
    at_s, found = decide(TimeBidding(RULES, RefuellingRules()), [large, small], [giver(201)])
    assert found == [(201, 2, "competition")]
    assert at_s <= 6.0


def test_who_waits_alone_or_finds_a_tanker_for_each_does_not_wait() -> None:
    at_s, found = decide(
        TimeBidding(RULES, RefuellingRules()), [pursuer(1, 40.0), pursuer(2, 40.0)], [giver(201), giver(202)]
    )
    assert (at_s, {by for *_, by in found}) == (0.0, {"unopposed"})


def test_ties_go_by_need_then_way_then_id() -> None:
    bidding = TimeBidding(RULES.model_copy(update={"tie_s": 60.0}), RefuellingRules())
    emptier = pursuer(7, 30.0)._replace(capacity_j=40_000.0, initial_j=2000.0 + 200.0 * 30.0)
    assert decide(bidding, [pursuer(3, 30.0), emptier], [giver(201)])[1] == [(201, 7, "competition")]
    aside = pursuer(3, 30.4, (0.0, 2.0, -6.0))
    nearer = pursuer(7, 30.0, (0.0, 0.1, -6.0))
    bidding = TimeBidding(RULES.model_copy(update={"tie_s": 5.0}), RefuellingRules())
    assert decide(bidding, [aside, nearer], [giver(201, speed=0.5)])[1] == [(201, 7, "competition")]
    bidding = TimeBidding(RULES, RefuellingRules())
    assert decide(bidding, [pursuer(7, 30.0), pursuer(4, 30.0)], [giver(201)])[1] == [(201, 4, "competition")]


def test_a_competition_that_ran_while_the_tanker_was_busy_is_decided_when_it_is_free() -> None:
    bidding = TimeBidding(RULES, RefuellingRules())
    views = [pursuer(i, 35.0 + 4.0 * i) for i in range(1, 6)]
    assert decide(bidding, views, [giver(201, free_in_s=8.0)], within_s=8.0)[1] == []
    drawn = [v._replace(drawn_j=v.drawn_j + 200.0 * 8.1) for v in views]
    assert decide(bidding, drawn, [giver(201)], from_s=8.1) == (8.1, [(201, 1, "competition")])


def test_the_next_one_is_clear_at_once_where_it_was_clear_of_two_places() -> None:
    bidding = TimeBidding(RULES, RefuellingRules())
    views = [pursuer(i, 28.0 + 4.0 * i) for i in range(1, 6)]
    two = [giver(201), giver(202, free_in_s=9.0)]
    at_s, found = decide(bidding, views, two)
    assert found[0][1] == 1
    bidding.award(1, at_s)
    drawn = [v._replace(drawn_j=v.drawn_j + 200.0 * (at_s + 0.5)) for v in views[1:]]
    assert decide(bidding, drawn, [giver(202)], from_s=at_s + 0.5) == (at_s + 0.5, [(202, 2, "competition")])


def test_who_cannot_be_reached_in_time_is_served_last() -> None:
    """1 lands in 1 s, and energy needs 3 s and the way: 2 can still be kept."""
    bidding = TimeBidding(RULES, RefuellingRules())
    assert decide(bidding, [pursuer(1, 1.0, (30.0, 0.0, -6.0)), pursuer(2, 9.0)], [giver(201)])[1][0][1] == 2


def test_a_tanker_flies_to_who_would_win_while_it_is_undecided() -> None:
    bidding = TimeBidding(RULES, RefuellingRules())
    views = [pursuer(1, 30.0), pursuer(2, 40.0)]
    snapshot, free = FleetSnapshot(0.0, tuple(views), ()), [giver(201)]
    bidding.advance(snapshot, (), free, TIMES)
    assert list(bidding.awards(snapshot, free)) == []
    assert bidding.approaches(snapshot, free) == {201: 1}


def test_who_is_not_empty_enough_but_would_not_last_takes_part() -> None:
    bidding = TimeBidding(RULES, RefuellingRules())
    hungry = pursuer(1, 0.0)._replace(initial_j=14_000.0, power_w=700.0)  # need 0.3, lands in 18.6 s
    assert decide(bidding, [hungry], [giver(201)])[1] == [(201, 1, "unopposed")]
    assert decide(TimeBidding(RULES, RefuellingRules()), [pursuer(1, 60.0)], [giver(201)], within_s=0.5)[1] == []
