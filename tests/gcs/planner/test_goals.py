"""Truth: a brute-force optimum for the slots, and a square by hand for the path."""

import itertools
import math

import numpy as np
import pytest

from gcs.planner.goals import ConstantSpeedPath, Courses, assign, ring_offsets

SQUARE = [(0.0, 0.0, -2.0), (4.0, 0.0, -2.0), (4.0, 4.0, -2.0), (0.0, 4.0, -2.0)]


@pytest.mark.parametrize("count", [1, 2, 5, 9])
def test_the_ring_is_even_level_and_starts_in_the_north(count: int) -> None:
    offsets = ring_offsets(count, 3.0, 1.5)
    assert offsets[0] == pytest.approx([3.0, 0.0, -1.5])
    assert np.hypot(offsets[:, 0], offsets[:, 1]) == pytest.approx(np.full(count, 3.0))
    chord_m = 2 * 3.0 * math.sin(math.pi / count)
    assert np.linalg.norm(offsets - np.roll(offsets, 1, axis=0), axis=1) == pytest.approx(np.full(count, chord_m))


def test_nobody_has_no_slots() -> None:
    assert ring_offsets(0, 3.0, 0.0).shape == (0, 3)


@pytest.mark.parametrize("seed", range(5))
def test_slots_are_the_brute_force_optimum(seed: int) -> None:
    rng = np.random.default_rng(seed)
    here = {sysid: tuple(rng.uniform(-5, 5, 3)) for sysid in (9, 2, 7, 4, 30)}
    slots = ring_offsets(5, 2.0, 0.0)

    def cost(order: tuple[int, ...]) -> float:
        return sum(math.dist(here[sysid], slots[slot]) ** 2 for sysid, slot in zip(sorted(here), order, strict=True))

    best = min(itertools.permutations(range(5)), key=cost)
    assert assign(here, slots) == dict(zip(sorted(here), best, strict=True))


@pytest.mark.parametrize("seed", range(5))
def test_ways_into_the_slots_do_not_cross(seed: int) -> None:
    """Least squared distances: for any two, (a - b)·(slot a - slot b) >= 0, so they never change sides."""
    rng = np.random.default_rng(seed)
    here = {sysid: tuple(rng.uniform(-5, 5, 3)) for sysid in range(1, 9)}
    slots = ring_offsets(8, 2.0, 0.0)
    slot_of = assign(here, slots)
    for a, b in itertools.combinations(here, 2):
        assert np.dot(np.subtract(here[a], here[b]), slots[slot_of[a]] - slots[slot_of[b]]) >= -1e-9


def test_a_closed_path_goes_round_the_square() -> None:
    path = ConstantSpeedPath(SQUARE, closed=True, laps=3)
    assert path.length_m == 48.0
    for lap in range(3):
        assert path.at(16 * lap + 1.0) == ((1.0, 0.0, -2.0), (1.0, 0.0, 0.0))
        assert path.at(16 * lap + 6.0) == ((4.0, 2.0, -2.0), (0.0, 1.0, 0.0))
        assert path.at(16 * lap + 9.0) == ((3.0, 4.0, -2.0), (-1.0, 0.0, 0.0))
        assert path.at(16 * lap + 15.0) == ((0.0, 1.0, -2.0), (0.0, -1.0, 0.0))
        assert path.at(16 * lap + 4.0) == ((4.0, 0.0, -2.0), (0.0, 1.0, 0.0))


def test_a_closed_path_ends_where_it_began_and_stands() -> None:
    path = ConstantSpeedPath(SQUARE, closed=True, laps=2)
    assert path.at(32.0) == path.at(1e9) == (SQUARE[0], (0.0, 0.0, 0.0))


def test_an_open_path_ends_at_its_last_point_whatever_the_laps() -> None:
    path = ConstantSpeedPath(SQUARE, closed=False, laps=1)
    assert path.length_m == 12.0
    assert path.at(11.0)[0] == (1.0, 4.0, -2.0)
    assert path.at(12.0) == path.at(50.0) == (SQUARE[-1], (0.0, 0.0, 0.0))
    assert path.at(-1.0)[0] == SQUARE[0]


def test_a_path_of_one_point_stands_there() -> None:
    assert ConstantSpeedPath([(1.0, 2.0, 3.0)], closed=False, laps=1).at(0.0) == ((1.0, 2.0, 3.0), (0.0, 0.0, 0.0))


def just(above: bool, reached_m: float, direction: np.ndarray) -> np.ndarray:
    """A place as near as can be to a sphere about 0 of this radius, on the one side of it or the other."""
    place = direction / np.linalg.norm(direction) * reached_m
    while (math.sqrt(sum(x * x for x in place.tolist())) > reached_m) != above:
        place[0] = np.nextafter(place[0], math.inf if (place[0] > 0) == above else -math.inf)
    return place


@pytest.mark.parametrize("above", [True, False])
def test_a_way_point_is_left_behind_by_who_is_as_near_as_the_root_of_the_sum_of_squares_says(above: bool) -> None:
    rng = np.random.default_rng(4)
    for _ in range(200):
        q = np.full((3, 3), 50.0)
        q[1] = just(above, 0.3, rng.normal(size=3) + 0.01)
        courses = Courses(3, {1: [(0.0, 0.0, 0.0), (5.0, 5.0, 5.0)]}, 0.3, keeps_last=True)
        assert courses.go_on(courses.rows, q) is not above
        assert courses.goal_ned[1].tolist() == ([0.0, 0.0, 0.0] if above else [5.0, 5.0, 5.0])


@pytest.mark.parametrize("keeps_last", [True, False])
def test_way_points_are_left_behind_one_in_a_tick_and_the_last_is_kept_or_not(keeps_last: bool) -> None:
    q = np.zeros((2, 3))
    courses = Courses(2, {0: [(0.0, 0.0, 0.1), (0.0, 0.0, 0.2)], 1: [(9.0, 0.0, 0.0)]}, 0.3, keeps_last=keeps_last)
    assert courses.go_on(courses.rows, q)
    assert courses.goal_ned[0].tolist() == [0.0, 0.0, 0.2]
    assert courses.goes_on(0) is not keeps_last
    assert courses.go_on(courses.rows, q) is not keeps_last
    assert courses.ended.tolist() == [not keeps_last, False]
    assert not courses.go_on(courses.rows, q)
    assert courses.goal_ned[1].tolist() == [9.0, 0.0, 0.0]
