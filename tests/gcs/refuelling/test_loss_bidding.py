"""Bids that see ahead: cases made by hand, and random fleets against the plan that `optimal` flies."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from gcs.refuelling.loss_bidding import LossBidding
from gcs.refuelling.policies import Optimal, RefuellingRequest
from gcs.scenario.model import CompetitionRules, RefuellingRules
from gcs.telemetry.state import FleetSnapshot, VehicleView
from tests.support.competing import TIMES, decide, giver, pursuer

RULES, REFUELLING = CompetitionRules(), RefuellingRules()


def bidding(end_s: float = 300.0) -> LossBidding:
    return LossBidding(RULES, REFUELLING, end_s)


def test_the_near_one_goes_first_where_it_cannot_wait_for_the_one_that_lands_sooner() -> None:
    """2 is 6 s away and lands in 24 s, 1 in 26 s. Served after 1 it gets energy in 20 s; 1 served after 2 in 27 s."""
    views = [pursuer(1, 26.0), pursuer(2, 24.0, (30.0, 0.0, -5.0))]
    seen = bidding()
    at_s, found = decide(seen, views, [giver(201)])
    assert found == [(201, 1, "competition")]
    assert at_s <= 1.0
    assert seen.gain[1] > 1.0
    assert seen.gain[2] == -seen.gain[1]


def test_the_law_names_what_the_best_plan_serves_first() -> None:
    rng = np.random.default_rng(8)
    clear = other = 0
    for _ in range(240):
        n, k = int(rng.integers(4, 10)), int(rng.integers(1, 4))
        views = [pursuer(i + 1, float(rng.uniform(12, 45)), (*rng.uniform(-15, 15, 2), -5.0)) for i in range(n)]
        givers = [giver(200 + j, (*rng.uniform(-15, 15, 2), -6.0)) for j in range(k)]
        competing = bidding()
        at_s, found = decide(competing, views, givers)
        won = {receiver for _, receiver, _ in found}
        if not found or found[0][2] != "competition":
            continue
        gained = min(competing.gain[sysid] for sysid in won)
        passed = max(gain for sysid, gain in competing.gain.items() if sysid not in won)
        assert gained >= passed - 0.1
        if gained > passed + 0.5:
            clear += 1
            other += won != set(chosen(FleetSnapshot(at_s, drawn(views, at_s), ()), givers).values())
    assert clear >= 40
    assert other <= 0.15 * clear  # a plan is up to a second old


def chosen(snapshot: FleetSnapshot, givers: list[Any]) -> dict[int, int]:
    """Receivers by tanker, of the policy `optimal`."""
    tankers = tuple(SimpleNamespace(sysid=one.name) for one in givers)
    request: Any = RefuellingRequest(
        snapshot.time_s, tankers[0], tuple(snapshot.of_role("pursuer")), tankers, {}, REFUELLING, tuple(givers), (),
        TIMES, 300.0 - snapshot.time_s,
    )  # type: ignore[arg-type] # fmt: skip
    scenario: Any = SimpleNamespace(competition=RULES)
    return Optimal(scenario).assign(request)


def test_where_no_order_loses_anything_all_tie_and_need_decides() -> None:
    views = [pursuer(1, 44.0), pursuer(2, 40.0, (3.0, 0.0, -5.0)), pursuer(3, 42.0, (0.0, 3.0, -5.0))]
    seen = bidding(end_s=30.0)
    _, found = decide(seen, views, [giver(201)], within_s=5.0)
    assert found == [(201, 2, "competition")]
    assert np.abs(list(seen.gain.values())).max() < 0.01


def test_after_a_jump_of_the_bids_the_states_must_follow_before_it_is_decided() -> None:
    """A tanker that is far away becomes free where it had not been expected; the states still name another one."""
    near, far = pursuer(1, 21.0), pursuer(2, 20.0, (30.0, 0.0, -5.0))
    views = [near, far, pursuer(3, 30.0, (0.0, 60.0, -5.0))]
    seen = bidding()
    for k in range(30):
        now_s = k / 10
        seen.advance(FleetSnapshot(now_s, drawn(views, now_s), ()), (), [giver(201, free_in_s=4.0 - now_s)], TIMES)
    jumped = giver(202, (31.0, 0.0, -6.0))
    for k in range(30, 60):
        now_s = k / 10
        snapshot = FleetSnapshot(now_s, drawn(views, now_s), ())
        seen.advance(snapshot, (), [jumped], TIMES)
        if awards := list(seen.awards(snapshot, [jumped])):
            assert [award.receiver for award in awards] == [2]
            assert now_s <= 4.5
            return
    pytest.fail("nothing was decided")


def drawn(views: list[VehicleView], now_s: float) -> tuple[VehicleView, ...]:
    return tuple(v._replace(drawn_j=v.drawn_j + v.power_w * now_s) for v in views)


def test_bids_are_planned_anew_as_soon_as_a_draw_is_known() -> None:
    """At a session's start; a plan from before that knows nothing of when a vehicle lands, and would hold for 1 s."""
    views = [pursuer(1, 26.0), pursuer(2, 24.0, (30.0, 0.0, -5.0))]
    seen = bidding()
    unknown = tuple(view._replace(power_w=0.0) for view in views)
    seen.advance(FleetSnapshot(0.0, unknown, ()), (), [giver(201)], TIMES)
    assert seen.gain[1] == pytest.approx(0.0, abs=1e-6)
    seen.advance(FleetSnapshot(0.1, tuple(views), ()), (), [giver(201)], TIMES)
    assert seen.gain[1] > 1.0


def test_without_a_giver_bids_are_all_alike_and_one_alone_is_unopposed() -> None:
    seen = bidding()
    seen.advance(FleetSnapshot(0.0, (pursuer(1, 30.0), pursuer(2, 20.0)), ()), (), [], TIMES)
    assert len(set(seen.bids_s.values())) == 1
    assert decide(bidding(), [pursuer(1, 30.0)], [giver(201)])[1] == [(201, 1, "unopposed")]


def test_bids_of_many_at_several_bases_and_tankers_are_finite() -> None:
    rng = np.random.default_rng(2)
    views = [pursuer(i + 1, float(s), (*rng.uniform(-40, 40, 2), -5.0)) for i, s in enumerate(rng.uniform(10, 45, 60))]
    seen = bidding()
    pads = [giver(201)._replace(name="pad", speed_m_s=1.5), giver(202, (9.0, 0.0, -3.0))]
    seen.advance(FleetSnapshot(0.0, tuple(views), ()), (), pads, TIMES)
    assert len(seen.bids_s) == 60
    assert all(0.0 <= bid_s <= RULES.horizon_s and math.isfinite(bid_s) for bid_s in seen.bids_s.values())
    assert sum(bid_s < RULES.horizon_s for bid_s in seen.bids_s.values()) >= 2
