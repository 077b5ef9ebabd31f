"""Plan B: heights by whose ways may meet, above all places, and times in which all have flown their legs."""

from __future__ import annotations

import itertools
from typing import Any

import pytest

from gcs.planner.failsafes import facts, failsafes_of, shared_heights
from gcs.scenario.model import Scenario


def fleet(count: int, apart_m: float = 2.0, **changed: Any) -> Scenario:
    """A row of pursuers, each with a way point 8 m north of its start, 6 m up."""
    pursuers = [
        {
            "sysid": i + 1,
            "start_m": [0.0, apart_m * i, 0.0],
            "waypoints_m": [[8.0, apart_m * i, -6.0]],
            "battery": {"capacity_j": 60000.0},
        }
        for i in range(count)
    ]
    content = {
        "schema": 1,
        "name": "row",
        "axes": "ned",
        "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400.0},
        "goal": {"duration_s": 60.0},
        "vehicles": {"pursuers": pursuers},
        "planner": {"separation_m": 0.8},
    }
    return Scenario.model_validate(content | changed)


def test_ways_side_by_side_need_no_heights_of_their_own() -> None:
    found = failsafes_of(fleet(5, apart_m=4.0))
    assert {failsafe.altitude_m for failsafe in found.values()} == {6.0 + 1.5}


def test_ways_that_may_meet_lie_above_each_other_and_above_every_way_point() -> None:
    scenario = fleet(6)
    pursuers = [one.model_copy(update={"waypoints_m": ((8.0, 5.0, -6.0),)}) for one in scenario.vehicles.pursuers]
    crossing = scenario.model_copy(update={"vehicles": scenario.vehicles.model_copy(update={"pursuers": pursuers})})
    heights_m = sorted(failsafe.altitude_m for failsafe in failsafes_of(crossing).values())
    assert heights_m[0] >= 6.0 + 1.0
    assert all(b - a >= 0.8 + 0.2 for a, b in itertools.pairwise(heights_m))
    assert shared_heights(crossing) == []


def test_each_leg_of_the_timetable_has_time_for_the_slowest() -> None:
    found = failsafes_of(fleet(4, apart_m=4.0))
    one = found[1]
    assert one.level_after_s > one.altitude_m / 5.0
    assert one.down_after_s - one.level_after_s > 8.0 / 5.0
    assert one.again_after_s - one.down_after_s > (one.altitude_m - 5.0) / 5.0 + 5.0 / 0.7
    assert len({(failsafe.level_after_s, failsafe.down_after_s) for failsafe in found.values()}) == 1


def test_a_height_that_is_given_stays_and_who_shares_it_is_named() -> None:
    scenario = fleet(3, apart_m=2.0)
    params = {"RTL_RETURN_ALT": 20.0}
    together = [
        one.model_copy(update={"params": params, "waypoints_m": ((8.0, 2.0, -6.0),)})
        for one in scenario.vehicles.pursuers
    ]
    given = scenario.model_copy(update={"vehicles": scenario.vehicles.model_copy(update={"pursuers": together})})
    assert {failsafe.altitude_m for failsafe in failsafes_of(given).values()} == {20.0}
    assert shared_heights(given) == [(1, 2, 3)]
    assert "vehicles 1, 2, 3 return at one height" in facts(given)[1]


def test_homes_at_different_heights_count_from_one_zero() -> None:
    scenario = fleet(2, apart_m=4.0)
    first, second = scenario.vehicles.pursuers
    raised = second.model_copy(update={"start_m": (0.0, 4.0, -3.0), "airborne": True})
    mixed = scenario.model_copy(update={"vehicles": scenario.vehicles.model_copy(update={"pursuers": [first, raised]})})
    found = failsafes_of(mixed)
    assert found[1].altitude_m == pytest.approx(found[2].altitude_m + 3.0)


def test_a_vehicle_alone_returns_at_once() -> None:
    (one,) = failsafes_of(fleet(1)).values()
    assert (one.altitude_m, one.level_after_s, one.down_after_s) == (5.0, 0.0, 0.0)
    assert facts(fleet(1)) == []


def test_times_are_said_as_of_the_last_heartbeat_and_equal_heights_once() -> None:
    given = fleet(5, apart_m=4.0, radio={"loss": 0.1})
    one = failsafes_of(given)[1]
    (line,) = facts(given)
    assert one.loss_s == 5.0
    assert f"return at 7.5 m above home, fly home from {5.0 + one.level_after_s:.1f} s" in line
    assert f"descend there from {5.0 + one.down_after_s:.1f} s after its last HEARTBEAT" in line
