"""Where a silent vehicle may be: by hand from its failsafe, 5 m/s home and 0.7 m/s down after 5 s of silence."""

from __future__ import annotations

import itertools
import math

import pytest
from sessions import merged, small

from gcs.planner.failsafes import failsafe_of
from gcs.scenario.model import Scenario
from skytender.safety.silence import Failsafe, Vec3, between, braked, flown_on, nearest_rest, presumed_places

HOME = (0.0, 0.0, -5.0)
LAST = (20.0, 0.0, -5.0)  # 5 m up to -10, 20 m home, then down: 1 s, 4 s
USUAL = Failsafe()


def test_it_holds_until_the_ground_station_may_be_lost() -> None:
    """After 3.5 s, for which others make room 1.5 s before."""
    assert presumed_places(LAST, HOME, 1.9, USUAL) == []
    assert presumed_places(LAST, HOME, 3.4, USUAL)[-1] == pytest.approx((18.0, 0.0, -10.0))  # in 1.4 s


def test_it_is_looked_for_all_along_the_way_that_it_may_have_flown() -> None:
    places = presumed_places(LAST, HOME, 6.0, USUAL)  # began 0 to 2.5 s ago, looked for 1.5 s ahead: up to 4 s of way
    assert places[0] == LAST
    assert min(n for n, _, _ in places) == pytest.approx(20.0 - 5.0 * (4.0 - 1.0))
    gaps = [math.dist(a, b) for a, b in itertools.pairwise(places)]
    assert max(gaps) <= 0.7 + 1e-9


def test_it_comes_down_at_home() -> None:
    places = presumed_places(LAST, HOME, 20.0, USUAL)  # sinks since 6.5 to 11.5 s: 4.55 m to 9.1 m below -10
    assert {(n, e) for n, e, _ in places} == {(0.0, 0.0)}
    assert places[0][2] == pytest.approx(-10.0 + 0.7 * (16.5 - 1.5 - 2.5 - 5.0))
    assert places[-1][2] == pytest.approx(-10.0 + 0.7 * (16.5 + 1.5 - 5.0))


def test_parameters_of_its_own_count() -> None:
    assert presumed_places(LAST, HOME, 20.0, Failsafe(loss_s=60.0)) == []


@pytest.mark.parametrize(
    ("start_m", "params", "altitude_m"),
    [
        ([0.0, 0.0, 0.0], {}, 9.0),  # the column is 7 m high, and 1.5 m over it, in whole metres
        ([0.0, 0.0, -6.0], {}, 5.0),  # home lies 6 m up: 5 m over it is high enough
        ([0.0, 0.0, 0.0], {"RTL_RETURN_ALT": 3.0}, 3.0),
    ],
)
def test_a_launched_vehicle_returns_above_all_obstacles(
    start_m: list[float], params: dict[str, float], altitude_m: float
) -> None:
    column = {"cylinder_m": [9.0, 0.0], "radius_m": 0.5, "bottom_m": 0.0, "top_m": -7.0}
    scenario = Scenario.model_validate(merged(small(), {"obstacles": [column]}))
    vehicle = scenario.vehicles.pursuers[0].model_copy(update={"start_m": tuple(start_m), "params": params})
    assert failsafe_of(vehicle, scenario).altitude_m == altitude_m
    assert (
        failsafe_of(vehicle.model_copy(update={"params": {}}), scenario.model_copy(update={"obstacles": ()})).altitude_m
        == 5.0
    )


@pytest.mark.parametrize(("period_s", "hold_s"), [(0.036, 0.1), (0.1, 0.2), (0.2, 0.4)])
def test_a_launched_vehicle_holds_after_two_periods_but_no_sooner_than_it_can_be_told_to(
    period_s: float, hold_s: float
) -> None:
    scenario = Scenario.model_validate(merged(small(), {"clock": {"period_s": period_s}}))
    assert failsafe_of(scenario.vehicles.pursuers[0], scenario).hold_s == pytest.approx(hold_s)


@pytest.mark.parametrize("silent_s", [0.0, 0.4, 0.8, 1.0, 30.0])
def test_a_vehicle_without_set_points_flies_on_until_it_holds(silent_s: float) -> None:
    """It is 0.37 s behind its last set point, flies on for 0.5 s, and brakes from 3.2 m/s in 1.28 m: for 0.4 s more."""
    place, v_ned = flown_on((1.0, 2.0, -5.0), (3.2, 0.0, 0.0), silent_s, 0.37, Failsafe(hold_s=0.5))
    assert place == pytest.approx((1.0 + 3.2 * min(silent_s + 0.37, 1.27), 2.0, -5.0))
    assert v_ned == ((3.2, 0.0, 0.0) if silent_s < 0.9 else (0.0, 0.0, 0.0))


@pytest.mark.parametrize(
    ("silent_s", "gone_m", "left_m_s"), [(0.0, 0.0, 3.2), (0.4, 0.96, 1.6), (0.8, 1.28, 0.0), (30.0, 1.28, 0.0)]
)
def test_a_vehicle_is_nowhere_behind_where_it_is_if_it_brakes_at_once(
    silent_s: float, gone_m: float, left_m_s: float
) -> None:
    """From 3.2 m/s at 4 m/s²: it stands after 0.8 s and 1.28 m."""
    place, v_ned = braked((1.0, 2.0, -5.0), (0.0, 3.2, 0.0), silent_s)
    assert place == pytest.approx((1.0, 2.0 + gone_m, -5.0))
    assert v_ned == pytest.approx((0.0, left_m_s, 0.0))


def test_a_vehicle_that_hovers_stays() -> None:
    assert braked(LAST, (0.0, 0.0, 0.0), 3.0) == (LAST, (0.0, 0.0, 0.0))


def test_between_two_places_there_is_no_gap_and_the_last_is_left_out() -> None:
    first, last = ((0.0, 0.0, -5.0), (1.0, 0.0, 0.0)), ((3.0, 0.0, -5.0), (4.0, 0.0, 0.0))
    places = [*between(first, last), last]
    assert places[0] == first
    assert max(math.dist(a[0], b[0]) for a, b in itertools.pairwise(places)) <= 0.7
    assert all(v[0] == pytest.approx(1.0 + p[0]) for p, v in places), "velocity changes in proportion"
    assert between(first, first) == []


@pytest.mark.parametrize(
    ("p_ned", "nearest_ned"),
    [
        ((0.0, 1.0, -12.0), (0.0, 0.0, -12.0)),  # 1 m of the 2 m that it flies on in half a second
        ((0.0, 0.0, -9.0), (0.0, 0.0, -11.0)),  # it cannot have stopped earlier
        ((0.0, 0.0, -20.0), (0.0, 0.0, -13.0)),
    ],
)
def test_one_that_may_brake_later_rests_along_its_way(p_ned: Vec3, nearest_ned: Vec3) -> None:
    assert nearest_rest(p_ned, (0.0, 0.0, -11.0), (0.0, 0.0, -4.0), 0.5) == pytest.approx(nearest_ned)
    assert nearest_rest(p_ned, (0.0, 0.0, -11.0), (0.0, 0.0, 0.0), 0.5) == (0.0, 0.0, -11.0)
