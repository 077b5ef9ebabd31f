"""Shipped refuelling policies against cases worked out by hand."""

from __future__ import annotations

import dataclasses
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from gcs.refuelling import policies
from gcs.refuelling.giver import Giver, ServiceTimes
from gcs.scenario.guard import Guard
from gcs.scenario.model import RefuellingRules

RULES = RefuellingRules(hold_s=0.0, rate_w=1000.0, until=1.0, lands_at=0.0)
SCENARIO: Any = SimpleNamespace(competition=SimpleNamespace(need_from=0.0))


def view(sysid: int, north_m: float, remaining_j: float, power_w: float = 100.0) -> Any:
    capacity_j = 10_000.0
    return SimpleNamespace(
        sysid=sysid,
        p_now_ned=lambda: (north_m, 0.0, 0.0),
        v_ned=(0.0, 0.0, 0.0),
        remaining_j=remaining_j,
        capacity_j=capacity_j,
        need=1.0 - remaining_j / capacity_j,
        power_w=power_w,
        endurance_s=remaining_j / power_w,
    )


def request(
    candidates: list[Any], tankers: list[Any] | None = None, later: tuple[Any, ...] = ()
) -> policies.RefuellingRequest:
    """Tankers at 1 m/s; a service begins when they are there, and takes nothing but the flow."""
    free = tankers or [view(201, 0.0, 10_000.0)]
    ordered = tuple(sorted(candidates, key=lambda v: v.sysid))
    givers = tuple(Giver(v.sysid, v.p_now_ned(), 0.0, 1.0, 1e6, 1000.0) for v in free)
    speed_m_s, times = {v.sysid: 1.0 for v in free}, ServiceTimes(0.0, 1.0, 0.0)
    return policies.RefuellingRequest(0.0, free[0], ordered, tuple(free), speed_m_s, RULES, givers, later, times)


def test_the_nearest_and_the_emptiest_are_what_they_say() -> None:
    asked = request([view(1, 9.0, 1000.0), view(2, -2.0, 5000.0), view(3, 2.0, 4000.0)])
    assert policies.GreedyNearest(SCENARIO).choose(asked) == 2
    assert policies.MostEmptyFirst(SCENARIO).choose(asked) == 1


def test_equals_are_decided_by_system_id() -> None:
    asked = request([view(7, 2.0, 5000.0), view(4, -2.0, 5000.0)])
    for name in policies.SHIPPED:
        assert policies.SHIPPED[name](SCENARIO).choose(asked) == 4, name


def test_the_earliest_deadline_is_the_one_that_lands_first_not_the_emptiest() -> None:
    asked = request([view(1, 1.0, 3000.0, power_w=50.0), view(2, 1.0, 5000.0, power_w=200.0)])
    assert policies.EarliestDeadline(SCENARIO).choose(asked) == 2
    assert policies.MostEmptyFirst(SCENARIO).choose(asked) == 1


def test_the_hungarian_pairs_by_the_least_way_and_urgent_ones_first() -> None:
    tankers = [view(201, 0.0, 1.0), view(202, 10.0, 1.0)]
    asked = request([view(1, 9.0, 9000.0), view(2, 12.0, 9000.0), view(3, 60.0, 9000.0)], tankers)
    assert policies.Hungarian(SCENARIO).assign(asked) == {201: 1, 202: 2}
    asked = request([view(1, 9.0, 9000.0), view(2, 12.0, 9000.0), view(3, 60.0, 5500.0)], tankers)
    assert policies.Hungarian(SCENARIO).assign(asked) == {201: 1, 202: 3}  # 55 s are not 50 s of way and 20 s


def test_the_auction_weighs_a_second_of_way_against_a_second_left() -> None:
    asked = request([view(1, 30.0, 4000.0), view(2, 5.0, 6000.0)])  # 40 + 30 s against 60 + 5 s
    assert policies.Auction(SCENARIO).choose(asked) == 2
    asked = request([view(1, 20.0, 4000.0), view(2, 5.0, 6000.0)])
    assert policies.Auction(SCENARIO).choose(asked) == 1


def test_the_plan_serves_a_near_vehicle_on_the_way_where_the_emptiest_can_wait() -> None:
    """By hand, tanker at 0 and 1 m/s: 1 is 60 m away with 70 s left, 2 is 1 m away with 75 s left and 2.5 kJ missing.

    1 first: reached at 60 s, filled 3 kJ + 6 kJ drawn meanwhile in 10 s, back to 2 at 129 s: 54 s too late.
    2 first: at 1 s, filled with 2.6 kJ by 3.9 s; 1 at 62.9 s: 7.1 s left. So 2 is first.
    """
    asked = request([view(1, 60.0, 7000.0), view(2, 1.0, 7500.0)])
    assert policies.MostEmptyFirst(SCENARIO).choose(asked) == 1
    assert policies.Optimal(SCENARIO).choose(asked) == 2


def test_two_free_tankers_share_the_work_by_place() -> None:
    tankers = [view(201, 0.0, 10_000.0), view(202, 50.0, 10_000.0)]
    near, far = view(1, 49.0, 3000.0), view(2, 1.0, 3000.0)
    for name in ("optimal", "earliest_deadline", "hungarian", "auction"):
        assert policies.SHIPPED[name](SCENARIO).assign(request([near, far], tankers)) == {201: 2, 202: 1}  # type: ignore[attr-defined]
    assert policies.Optimal(SCENARIO).choose(request([near], tankers)) is None
    assert policies.Optimal(SCENARIO).choose(request([near], tankers[::-1])) == 1


def test_who_soon_wants_energy_is_planned_for() -> None:
    """By hand: 3 is not half empty yet, but lands in 18.3 s, 10 m to the south.

    1, 9 m to the north, first: filled by 15 s, and 19 m on, 3 is met at 34 s. 2, 1 m to the south, first: filled by
    6.4 s, and 9 m on, 3 is met at 15.4 s. The session ends after 30 s.
    """
    half: Any = SimpleNamespace(competition=SimpleNamespace(need_from=0.5))
    three = view(3, -10.0, 5500.0, power_w=300.0)
    asked = request([view(1, 9.0, 4500.0, power_w=50.0), view(2, -1.0, 5000.0, power_w=50.0)], later=(three,))
    assert policies.Optimal(half).choose(dataclasses.replace(asked, left_s=30.0)) == 2


def test_whom_no_plan_keeps_is_flown_to_rather_than_nobody() -> None:
    assert policies.Optimal(SCENARIO).choose(request([view(1, 90.0, 500.0), view(2, 80.0, 600.0)])) in (1, 2)


@pytest.mark.parametrize(
    ("answer", "text"),
    [
        (True, "True"),
        (np.True_, "True"),
        (np.array(True), "True"),
        (np.array([1, 2]), "ndarray"),
        (np.array([1]), "ndarray"),
        ([1], "list"),
        ("1", "'1'"),
        (3, "3"),
        (float("nan"), "NaN"),
    ],
)
def test_only_a_number_is_a_system_id(answer: Any, text: str) -> None:
    asked = request([view(1, 5.0, 5_000.0), view(2, 9.0, 5_000.0)])
    chooses = policies.GuardedPolicy(SimpleNamespace(choose=lambda _: answer), Guard("policy a:B"))
    assigns = policies.GuardedPolicy(SimpleNamespace(assign=lambda _: {201: answer}), Guard("policy a:B"))
    for policy in (chooses, assigns):
        assert policy.pairs(asked) == {}
        (fault,) = policy.pop_faults()
        assert fault.problem == f"returned {text}, which is no candidate's system id"


def test_true_is_no_tankers_system_id() -> None:
    asked = request([view(2, 5.0, 5_000.0)], [view(1, 0.0, 10_000.0)])
    policy = policies.GuardedPolicy(SimpleNamespace(assign=lambda _: {True: 2}), Guard("policy a:B"))
    assert policy.pairs(asked) == {}
    (fault,) = policy.pop_faults()
    assert fault.problem == "returned True, which is no free tanker's system id"


@pytest.mark.parametrize("answer", [2, 2.0, np.int64(2), np.array(2)])
def test_numbers_of_any_kind_are_system_ids(answer: Any) -> None:
    asked = request([view(1, 5.0, 5_000.0), view(2, 9.0, 5_000.0)])
    policy = policies.GuardedPolicy(SimpleNamespace(choose=lambda _: answer), Guard("policy a:B"))
    assert policy.pairs(asked) == {201: 2}
    assert not policy.pop_faults()
