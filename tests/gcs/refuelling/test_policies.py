"""Shipped refuelling policies against cases worked out by hand, and against each other where theory orders them."""

from __future__ import annotations

import itertools
from types import SimpleNamespace
from typing import Any

import pytest

from gcs.refuelling.policies import SHIPPED, GreedyNearest, MostEmptyFirst, Optimal, RefuellingRequest
from gcs.scenario.model import RefuellingRules

RULES = RefuellingRules(hold_s=0.0, rate_w=1000.0, until=1.0)


def view(sysid: int, north_m: float, remaining_j: float, power_w: float = 100.0) -> Any:
    capacity_j = 10_000.0
    return SimpleNamespace(
        sysid=sysid,
        p_now_ned=lambda: (north_m, 0.0, 0.0),
        remaining_j=remaining_j,
        capacity_j=capacity_j,
        need=1.0 - remaining_j / capacity_j,
        power_w=power_w,
        endurance_s=remaining_j / power_w,
    )


def request(candidates: list[Any], tankers: list[Any] | None = None) -> RefuellingRequest:
    free = tankers or [view(201, 0.0, 10_000.0)]
    ordered = tuple(sorted(candidates, key=lambda v: v.sysid))
    return RefuellingRequest(0.0, free[0], ordered, tuple(free), {v.sysid: 1.0 for v in free}, RULES)


def test_the_nearest_and_the_emptiest_are_what_they_say() -> None:
    asked = request([view(1, 9.0, 1000.0), view(2, -2.0, 5000.0), view(3, 2.0, 4000.0)])
    assert GreedyNearest(None).choose(asked) == 2  # type: ignore[arg-type]
    assert MostEmptyFirst(None).choose(asked) == 1  # type: ignore[arg-type]


def test_equals_are_decided_by_system_id() -> None:
    asked = request([view(7, 2.0, 5000.0), view(4, -2.0, 5000.0)])
    for name in SHIPPED:
        assert SHIPPED[name](None).choose(asked) == 4  # type: ignore[arg-type]


def test_the_optimum_serves_a_near_vehicle_on_the_way_where_the_emptiest_can_wait() -> None:
    """By hand, tanker at 0 and 1 m/s: 1 is 60 m away with 70 s left, 2 is 1 m away with 75 s left and 2.5 kJ missing.

    1 first: reached at 60 s (10 s left), filled 3 kJ + 6 kJ drawn meanwhile = 9 s, back to 2 at 128 s: 53 s too late.
    2 first: at 1 s (74 s left), filled with 2.6 kJ by 3.6 s; 1 at 62.6 s: 7.4 s left. So 2 is first.
    """
    asked = request([view(1, 60.0, 7000.0), view(2, 1.0, 7500.0)])
    assert MostEmptyFirst(None).choose(asked) == 1  # type: ignore[arg-type]
    assert Optimal(None).choose(asked) == 2  # type: ignore[arg-type]


def test_two_free_tankers_share_the_work_by_place() -> None:
    tankers = [view(201, 0.0, 10_000.0), view(202, 50.0, 10_000.0)]
    near, far = view(1, 49.0, 3000.0), view(2, 1.0, 3000.0)
    assert Optimal(None).choose(request([near, far], tankers)) == 2  # type: ignore[arg-type]
    assert Optimal(None).choose(request([near, far], tankers[::-1])) == 1  # type: ignore[arg-type]
    assert Optimal(None).choose(request([near], tankers)) is None  # type: ignore[arg-type]


def simulate(choose: Any, vehicles: list[Any]) -> float:
    """Least endurance left at the begin of a service when `choose` decides each time; an independent simulation."""
    time_s, here, worst = 0.0, 0.0, float("inf")
    waiting = {v.sysid: [v.p_now_ned()[0], v.remaining_j] for v in vehicles}
    while waiting:
        now = [view(sysid, n, joules - 100.0 * time_s) for sysid, (n, joules) in waiting.items()]
        sysid = choose(request(now, [view(201, here, 10_000.0)]))
        n, joules = waiting.pop(sysid)
        time_s += abs(n - here)
        here = n
        left_j = joules - 100.0 * time_s
        worst = min(worst, left_j / 100.0)
        time_s += (10_000.0 - left_j) / 1000.0
    return worst


@pytest.mark.parametrize("seed", range(8))
def test_no_order_beats_the_optimum(seed: int) -> None:
    vehicles = [view(i + 1, ((17 * i + 7 * seed) % 41) - 20.0, 8000.0 - 700.0 * ((i * 3 + seed) % 5)) for i in range(4)]
    best = simulate(Optimal(None).choose, vehicles)  # type: ignore[arg-type]
    for order in itertools.permutations(v.sysid for v in vehicles):
        turn = iter(order)
        assert simulate(lambda _, turn=turn: next(turn), vehicles) <= best + 1e-9
