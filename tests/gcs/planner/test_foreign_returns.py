"""Plan B of autopilots that are not ours: heights and times of any fleet, and how a mixed one shares the sky."""

from __future__ import annotations

import itertools
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gcs.planner.failsafes import facts, failsafes_of, foreign_returns_of
from gcs.scenario.model import Scenario

SLOWEST_M_S = 1.5
"""ArduCopters climb at 2.5 m/s and PX4s at 3 m/s by default; half of that is slow."""


def fleet(heights_m: list[float], own: int = 0, **changed: Any) -> Scenario:
    """A row of pursuers with a way point each, the last `own` of them launched, the others external."""
    pursuers: list[dict[str, Any]] = []
    for i, height_m in enumerate(heights_m, 1):
        one: dict[str, Any] = {"sysid": i, "waypoints_m": [[8.0, 2.0 * i, -height_m]]}
        if i > len(heights_m) - own:
            one |= {"start_m": [0.0, 2.0 * i, 0.0], "battery": {"capacity_j": 6e4}}
        else:
            one["external"] = {"connect": "udpin:127.0.0.1:14550", "capacity_j": 2e5}
        pursuers.append(one)
    content = {
        "schema": 1, "name": "row", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400.0},
        "clock": {"mode": "real", "speed": 1}, "goal": {"duration_s": 60.0}, "vehicles": {"pursuers": pursuers},
        "planner": {"separation_m": 0.8},
    }  # fmt: skip
    return Scenario.model_validate(content | changed)


@given(heights_m=st.lists(st.floats(1.0, 12.0), min_size=2, max_size=7))
def test_a_lower_one_begins_when_those_above_have_climbed_past_it(heights_m: list[float]) -> None:
    returns = foreign_returns_of(fleet(heights_m))
    assert len(returns) == len(heights_m)
    for one, other in itertools.combinations(returns.values(), 2):
        low, high = sorted((one, other), key=lambda r: r.height_m)
        assert high.height_m - low.height_m >= 0.8 + 0.2
        passed_s = high.begins_after_s + (low.height_m + 0.8) / SLOWEST_M_S
        assert low.begins_after_s >= passed_s + 1.0  # a HEARTBEAT that one of them has lost
    last = max(returns.values(), key=lambda r: r.begins_after_s)
    for one in returns.values():
        assert one.height_m >= max(heights_m) + 1.0
        assert one.lands_after_s >= last.begins_after_s + last.height_m / SLOWEST_M_S
        assert one.in_time


@given(heights_m=st.lists(st.floats(3.0, 12.0), min_size=2, max_size=7, unique=True))
def test_who_is_sent_higher_returns_higher(heights_m: list[float]) -> None:
    returns = foreign_returns_of(fleet(heights_m))
    by_place = sorted(returns, key=lambda sysid: heights_m[sysid - 1])
    assert by_place == sorted(returns, key=lambda sysid: returns[sysid].height_m)


def test_a_vehicle_alone_keeps_its_own_unless_something_stands_there() -> None:
    assert foreign_returns_of(fleet([3.0])) == {}
    assert facts(fleet([3.0])) == [
        "plan B: none for vehicle 1: autopilots that are not ours return by their own parameters"
    ]
    tower = {"cylinder_m": [4.0, 4.0], "radius_m": 0.5, "bottom_m": 0.0, "top_m": -20.0}
    (one,) = foreign_returns_of(fleet([3.0], obstacles=[tower])).values()
    assert one.height_m >= 21.0
    assert one.waits_s == 0.0


def test_without_the_safety_filter_nothing_is_set() -> None:
    assert foreign_returns_of(fleet([3.0, 3.0], planner={"safety": False})) == {}


def test_ours_in_a_mixed_fleet_return_above_the_others_and_come_down_with_them() -> None:
    scenario = fleet([3.0, 4.0, 3.0, 3.0], own=2)
    foreign, own = foreign_returns_of(scenario), failsafes_of(scenario)
    assert (set(foreign), set(own)) == ({1, 2}, {3, 4})
    assert min(one.altitude_m for one in own.values()) >= max(one.height_m for one in foreign.values()) + 1.0
    for one in own.values():
        lost_s = one.loss_s
        assert min(other.begins_after_s for other in foreign.values()) >= lost_s + one.level_after_s
        assert lost_s + one.down_after_s >= max(other.lands_after_s for other in foreign.values())


def test_ours_return_as_they_did_where_all_are_ours() -> None:
    """Heights and times of this fleet before others were planned for."""
    own = failsafes_of(fleet([6.0, 6.0, 6.0], own=3))
    assert {one.altitude_m for one in own.values()} == {7.5}
    assert {round(one.level_after_s, 6) for one in own.values()} == {5.5}


def test_more_than_autopilots_can_wait_for_is_said() -> None:
    scenario = fleet([3.0] * 24)
    late = [sysid for sysid, one in foreign_returns_of(scenario).items() if not one.in_time]
    assert late
    said = next(line for line in facts(scenario) if "more ways meet" in line)
    assert all(str(sysid) in said for sysid in late)


def test_heights_and_times_are_told_and_shared_rally_points_too() -> None:
    scenario = fleet([3.0, 3.0], rally_m=[[0.0, 10.0]])
    returns = foreign_returns_of(scenario)
    lines = facts(scenario)
    assert "none for" not in " ".join(lines)
    for one in returns.values():
        assert f"{one.height_m:.1f}" in lines[0]
        assert f"{one.begins_after_s:.0f}" in lines[0]
    assert "nearest rally point" in lines[1]


@pytest.mark.parametrize("period_s", [0.02, 0.1, 0.2])
def test_they_hold_no_sooner_than_an_older_px4_by_default(period_s: float) -> None:
    returns = foreign_returns_of(fleet([3.0, 3.0], clock={"mode": "real", "speed": 1, "period_s": period_s}))
    assert {one.holds_after_s for one in returns.values()} == {max(0.5, min(5 * period_s, 1.0))}
