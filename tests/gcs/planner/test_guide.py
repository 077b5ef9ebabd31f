"""Followers reach goals behind walls, keep to one route, and search no more than they must."""

import numpy as np
import pytest
from walls import CEILING, L_WALL, U_WALL, room, walls

from gcs.planner.guide import NO_ROUTE, PARTIAL, ROUTED, STRAIGHT, WAITING, RouteFollower
from gcs.planner.route import Router
from skytender import geometry as ob

SPEED_M = 0.25  # in a tick


def fly(follower, start, goal_at, ticks, sysid=1):
    """Flies a point straight to its aims; the places it was at and the states it was in."""
    p, places, states = np.array(start, dtype=float), [], []
    for tick in range(ticks):
        goal = np.array(goal_at(tick), dtype=float)
        aims = follower.aims([sysid], p[np.newaxis], goal[np.newaxis])
        to_aim = aims.aim_ned[0] - p
        apart = np.linalg.norm(to_aim)
        p = p + to_aim * min(1.0, SPEED_M / max(apart, 1e-9))
        places.append(p)
        states.append(int(aims.state[0]))
        if np.linalg.norm(goal - p) < 1e-6:
            break
    return np.array(places), states


@pytest.mark.parametrize(
    ("table", "goal"),
    [(L_WALL, [8.0, 0.0, -2.0]), (U_WALL, [12.0, 0.0, -2.0]), (CEILING, [12.0, 0.0, -2.0])],
    ids=["L", "U", "closed ceiling"],
)
def test_walls_are_flown_around_with_one_search(table, goal):
    follower = RouteFollower(Router(table, 0.6, floor_m=0.3))
    places, states = fly(follower, [0.0, 0.0, -2.0], lambda _: goal, 250)
    np.testing.assert_allclose(places[-1], goal)
    assert states[0] == ROUTED
    assert states[-1] == STRAIGHT
    assert follower.searches == 1
    assert ob.clearance(table, places).min() >= 0.8 * 0.6 - 0.01
    route_m = Router(table, 0.6, floor_m=0.3).plan([0.0, 0.0, -2.0], goal).length_m
    assert len(places) * SPEED_M < 1.03 * route_m + SPEED_M


def test_a_gap_of_one_and_a_half_separations_is_flown_through():
    table = walls(([5, -30, -40], [5.4, -0.45, 0]), ([5, 0.45, -40], [5.4, 30, 0]))
    places, _ = fly(RouteFollower(Router(table, 0.6, floor_m=0.3)), [0.0, 3.0, -2.0], lambda _: [10.0, 3.0, -2.0], 100)
    np.testing.assert_allclose(places[-1], [10.0, 3.0, -2.0])
    assert ob.clearance(table, places).min() > 0.3


def test_it_does_not_flip_between_two_equal_ways():
    """The goal sways behind a tall pillar, now left and now right of the middle; the way round stays on one side."""
    table = ob.table([ob.cylinder([5.0, 0.0, -10.0], 2.0, 60.0)])
    follower = RouteFollower(Router(table, 0.6))
    places, _ = fly(follower, [0.0, 0.0, -2.0], lambda tick: [10.0, 0.9 * np.sin(tick / 4), -2.0], 60)
    sides = np.sign(places[np.abs(places[:, 0] - 5.0) < 2.0][:, 1])
    assert len(set(sides)) == 1
    east = places[:, 1] * sides[0]
    assert (np.diff(east[: np.argmax(east)]) > -1e-6).all()
    assert follower.searches < 12


def test_a_goal_that_moves_in_sight_of_the_last_way_point_costs_no_search():
    follower = RouteFollower(Router(U_WALL, 0.6, floor_m=0.3))
    fly(follower, [0.0, 0.0, -2.0], lambda tick: [12.0, 0.02 * tick, -2.0], 60)
    assert follower.searches == 1


def test_a_vehicle_that_was_pushed_behind_a_wall_is_led_from_there():
    follower = RouteFollower(Router(L_WALL, 0.6, floor_m=0.3))
    goal = [8.0, 0.0, -2.0]
    fly(follower, [0.0, 0.0, -2.0], lambda _: goal, 5)
    places, _ = fly(follower, [0.0, 9.0, -2.0], lambda _: goal, 100)
    np.testing.assert_allclose(places[-1], goal)
    places, _ = fly(follower, [0.0, 0.0, -0.5], lambda _: goal, 100)
    np.testing.assert_allclose(places[-1], goal)


def test_where_there_is_no_way_it_holds_and_searches_once():
    follower = RouteFollower(Router(room([-3, -3, -5], [3, 3, 0]), 0.6, floor_m=0.3))
    places, states = fly(follower, [0.0, 0.0, -2.0], lambda _: [9.0, 0.0, -2.0], 20)
    assert set(states) == {NO_ROUTE}
    assert follower.searches == 1
    np.testing.assert_array_equal(places[-1], [0.0, 0.0, -2.0])


def test_a_goal_within_a_surface_is_approached_and_held():
    table = ob.table([ob.sphere([8.0, 0.0, -3.0], 2.0)])
    follower = RouteFollower(Router(table, 0.6, floor_m=0.3))
    places, states = fly(follower, [0.0, 0.0, -3.0], lambda _: [7.0, 0.0, -3.0], 60)
    assert set(states) == {PARTIAL}
    assert follower.searches == 1
    assert 0.5 < ob.clearance(table, places[-1])[0] < 0.9


def test_searches_are_spread_over_ticks_longest_waiting_first():
    router = Router(U_WALL, 0.6, floor_m=0.3)
    follower = RouteFollower(router, cells=700, few_cells=700)
    n = 6
    p = np.array([[0.0, -2.5 + i, -2.0] for i in range(n)])
    goals = np.array([[12.0, -2.5 + i, -2.0 - i / 3] for i in range(n)])
    served, settled = [0], [0]
    while served[-1] < n:
        aims = follower.aims(range(n), p, goals)
        np.testing.assert_array_equal(aims.aim_ned[aims.state == WAITING], p[aims.state == WAITING])
        served.append(int((aims.state == ROUTED).sum()))
        settled.append(router.settled)
        assert len(served) < 1000
    assert served == sorted(served)
    assert max(np.diff(settled)) <= 700
    assert served[1] == 0  # the first search was paused, and its end is that of one without a pause
    whole = RouteFollower(Router(U_WALL, 0.6, floor_m=0.3), cells=10**9)
    np.testing.assert_array_equal(aims.aim_ned, whole.aims(range(n), p, goals).aim_ned)


def test_order_and_company_of_vehicles_do_not_matter():
    rng = np.random.default_rng(3)
    p, goals = rng.uniform([-1, -3, -5], [4, 3, -1], (8, 3)), rng.uniform([8, -6, -5], [12, 6, -1], (8, 3))
    together = RouteFollower(Router(U_WALL, 0.6, floor_m=0.3), cells=10**9).aims(range(8), p, goals)
    back = RouteFollower(Router(U_WALL, 0.6, floor_m=0.3), cells=10**9).aims(range(7, -1, -1), p[::-1], goals[::-1])
    np.testing.assert_array_equal(together.aim_ned, back.aim_ned[::-1])
    for i in range(8):
        alone = RouteFollower(Router(U_WALL, 0.6, floor_m=0.3), cells=10**9).aims([i], p[i : i + 1], goals[i : i + 1])
        np.testing.assert_array_equal(alone.aim_ned[0], together.aim_ned[i])
        np.testing.assert_array_equal(alone.remaining_m[0], together.remaining_m[i])


def test_who_is_left_out_is_forgotten():
    follower = RouteFollower(Router(L_WALL, 0.6, floor_m=0.3))
    p, goal = np.array([[0.0, 0.0, -2.0]]), np.array([[8.0, 0.0, -2.0]])
    follower.aims([7], p, goal)
    follower.aims([7], p, goal)
    assert follower.searches == 1
    follower.aims([], np.zeros((0, 3)), np.zeros((0, 3)))
    follower.aims([7], p, goal)
    assert follower.searches == 2


def test_what_cannot_be_is_refused():
    follower = RouteFollower(Router(ob.table([]), 0.6))
    with pytest.raises(ValueError, match="must be"):
        follower.aims([1, 2], np.zeros((1, 3)), np.zeros((1, 3)))
    with pytest.raises(ValueError, match="twice"):
        follower.aims([1, 1], np.zeros((2, 3)), np.zeros((2, 3)))
    with pytest.raises(ValueError, match="finite"):
        follower.aims([1], np.full((1, 3), np.nan), np.zeros((1, 3)))
