"""Routes hold their clearance against the exact distance, are near the shortest, and say where there is none."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import ndimage
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra
from walls import CEILING, L_WALL, U_WALL, room, walls

from gcs.planner import route_grid
from gcs.planner.line_of_sight import clear_m, sight
from gcs.planner.route import Router
from gcs.planner.route_grid import CostField, cell_at, cells, centre
from skytender import geometry as ob

CLEARANCE_M = 0.6
SEPARATION_M = 0.6
FLOOR_M = 0.3
ROUNDING_M = 1e-5


def sampled_clearance(table, start, points, step_m=0.02):
    """Least distance along a route by sampling: the truth, up to step_m / 2."""
    path = np.vstack([start, points])
    least = math.inf
    for a, b in itertools.pairwise(path):
        t = np.linspace(0, 1, 2 + int(np.linalg.norm(b - a) / step_m))[:, None]
        least = min(least, ob.clearance(table, a + t * (b - a)).min())
    return least


def length(start, points):
    return np.linalg.norm(np.diff(np.vstack([start, points]), axis=0), axis=1).sum()


def routed(table, start, goal, clearance_m=CLEARANCE_M, floor_m=FLOOR_M, **keys):
    """The route, held against what every route must be; `None` where there is none."""
    router = Router(table, clearance_m, floor_m=floor_m, **keys)
    found = router.plan(start, goal)
    if found is None:
        return None
    if found.reaches_goal:
        np.testing.assert_array_equal(found.points_ned[-1], goal)
    if floor_m is not None:
        assert (found.points_ned[:, 2] <= -floor_m + ROUNDING_M).all()
    np.testing.assert_allclose(found.length_m, length(start, found.points_ned))
    told = min(found.legs_m.min(), clearance_m)
    assert sampled_clearance(table, start, found.points_ned) >= told - ROUNDING_M
    again = Router(table, clearance_m, floor_m=floor_m, **keys).plan(start, goal)
    np.testing.assert_array_equal(again.points_ned, found.points_ned)
    return found


def test_a_free_line_is_one_way_point():
    goal = [10.0, 4.0, -3.0]
    for table in (ob.table([]), walls(([4, -6, -6], [4.3, 0, 0]))):
        np.testing.assert_array_equal(Router(table, CLEARANCE_M).plan([0.0, 4.0, -3.0], goal).points_ned, [goal])


@pytest.mark.parametrize(
    ("table", "start", "goal", "at_most_m"),
    [
        (L_WALL, [0.0, 0.0, -2.0], [8.0, 0.0, -2.0], 14.0),
        (U_WALL, [0.0, 0.0, -2.0], [12.0, 0.0, -2.0], 19.5),
        (CEILING, [0.0, 0.0, -2.0], [12.0, 0.0, -2.0], 37.0),  # 34.5 without clearance
    ],
    ids=["L", "U", "closed ceiling"],
)
def test_walls_are_rounded_with_clearance(table, start, goal, at_most_m):
    found = routed(table, start, goal)
    assert found.legs_m.min() >= CLEARANCE_M - ROUNDING_M
    assert found.length_m <= at_most_m


@pytest.mark.parametrize("share", [1.5, 1.75, 2.0, 2.5, 3.0])
@pytest.mark.parametrize("place_e", [-2.0, -1.93, 0.0, 0.111])
def test_a_gap_between_two_rooms_is_found(share, place_e):
    gap_m = share * SEPARATION_M
    table = walls(([5, -30, -40], [5.4, place_e - gap_m / 2, 0]), ([5, place_e + gap_m / 2, -40], [5.4, 30, 0]))
    found = routed(table, [0.0, 3.0, -2.0], [10.0, 3.0, -2.0])
    assert found.length_m < 14.8
    assert found.legs_m.min() >= min(CLEARANCE_M, gap_m / 2 - 0.05) - ROUNDING_M


def test_a_window_on_all_four_sides_is_found():
    table = walls(([5, -30, -40], [5.4, -0.5, 0]), ([5, 0.5, -40], [5.4, 30, 0]), ([5, -0.5, -40], [5.4, 0.5, -3.5]),
                  ([5, -0.5, -2.5], [5.4, 0.5, 0]))  # fmt: skip
    found = routed(table, [0.0, 4.0, -1.0], [10.0, -4.0, -1.0])
    assert found.length_m < 15.0
    assert found.legs_m.min() > 0.3


def test_there_is_no_way_out_of_a_closed_room_and_none_in():
    table = room([-3, -3, -5], [3, 3, 0])
    inside, outside = [0.0, 0.0, -2.0], [8.0, 1.0, -2.0]
    assert routed(table, inside, outside) is None
    assert routed(table, outside, inside) is None
    assert routed(table, inside, [2.0, 2.0, -4.0]) is not None


def test_a_start_beside_the_wall_of_a_closed_room_does_not_pass_through_it():
    table = room([-3, -3, -5], [3, 3, 0], thick=0.05)
    assert routed(table, [2.9, 0.0, -2.0], [8.0, 1.0, -2.0]) is None


def test_a_goal_in_an_obstacle_gives_the_nearest_place_that_keeps_the_clearance():
    table = ob.table([ob.sphere([10.0, 0.0, -5.0], 2.0)])
    found = routed(table, [0.0, 0.0, -5.0], [9.0, 0.0, -5.0])
    assert not found.reaches_goal
    end = found.points_ned[-1]
    assert CLEARANCE_M - ROUNDING_M <= ob.clearance(table, end)[0] <= CLEARANCE_M + 0.3
    assert np.linalg.norm(end - [9.0, 0.0, -5.0]) < 1.0 + CLEARANCE_M + 0.3


def test_a_goal_below_the_floor_is_raised_to_it():
    router = Router(ob.table([]), CLEARANCE_M, floor_m=FLOOR_M)
    np.testing.assert_array_equal(router.plan([0.0, 0.0, -2.0], [5.0, 0.0, 1.0]).points_ned, [[5.0, 0.0, -FLOOR_M]])


def test_a_start_within_an_obstacle_leaves_it():
    table = walls(([-1, -1, -4], [1, 1, 0]))
    found = routed(table, [0.8, 0.0, -2.0], [-6.0, 0.0, -2.0])
    assert found.reaches_goal
    assert (found.legs_m[1:] > 0).all()


@pytest.mark.parametrize("count", [60, 150])
def test_dense_fields_of_points_and_spheres(count):
    rng = np.random.default_rng(count)
    rows = [ob.point(p) for p in rng.uniform([2, -6, -5], [14, 6, 0], (count, 3))]
    rows += [ob.sphere(p, r) for p, r in zip(rng.uniform([2, -6, -5], [14, 6, 0], (count // 3, 3)),
                                             rng.uniform(0.1, 0.6, count // 3), strict=True)]  # fmt: skip
    found = routed(ob.table(rows), [0.0, 0.0, -2.0], [16.0, 0.0, -2.0])
    assert found.legs_m.min() > 0.25
    assert found.length_m < 1.4 * 16


def test_round_one_tall_box_is_within_3_percent_of_the_closed_form():
    """Two tangents and an arc of radius c about each of the two near corners (0, ±2), (1, ±2)."""
    table = walls(([0, -2, -60], [1, 20, 40]))
    start, goal = np.array([-4.0, 2.0, -2.0]), np.array([5.0, 1.0, -2.0])
    c = CLEARANCE_M

    def tangent(apart_m, north_m, east_m):
        """Length of a tangent to a circle of radius c so far away, and how far it leans to the north."""
        return math.sqrt(apart_m**2 - c**2), math.atan2(east_m, north_m) + math.asin(c / apart_m)

    a, turn_a = tangent(math.hypot(4, 4), 4, 4)  # start to the first corner
    b, turn_b = tangent(math.hypot(4, 3), 4, 3)  # second corner to the goal
    shortest = a + b + 1.0 + c * (turn_a + turn_b)
    found = routed(table, start, goal, floor_m=None)
    assert shortest - 1e-3 <= found.length_m <= 1.03 * shortest


def test_round_one_sphere_is_within_3_percent_of_the_closed_form():
    table = ob.table([ob.sphere([0.0, 0.0, -20.0], 3.0)])
    radius, apart = 3.0 + CLEARANCE_M, 8.0
    shortest = 2 * math.sqrt(apart**2 - radius**2) + radius * (math.pi - 2 * math.acos(radius / apart))
    found = routed(table, [-apart, 0.0, -20.0], [apart, 0.0, -20.0], floor_m=None)
    assert shortest - 1e-3 <= found.length_m <= 1.03 * shortest


def random_table(rng, count):
    rows = []
    for _ in range(count):
        low = rng.uniform([-4, -4, -4], [4, 4, -1])
        kind = rng.integers(4)
        if kind == 0:
            rows.append(ob.box(low, low + rng.uniform(0.3, 3, 3)))
        elif kind == 1:
            rows.append(ob.cylinder(low, rng.uniform(0.2, 1), rng.uniform(0.5, 3)))
        elif kind == 2:
            rows.append(ob.sphere(low, rng.uniform(0.2, 1.2)))
        else:
            rows.append(ob.point(low))
    return ob.table(rows)


def shifted(cells_of, move):
    """The inner cells' neighbours in one direction."""
    return cells_of[tuple(slice(1 + x, size - 1 + x) for x, size in zip(move, cells_of.shape, strict=True))]


@pytest.mark.parametrize("seed", range(6))
def test_search_costs_are_those_of_scipy_on_the_same_graph(seed):
    rng = np.random.default_rng(seed)
    grid = cells(random_table(rng, 6), clearance_m=0.6, least_m=0.3, cell_m=0.6, margin_m=1.0, floor_d=-0.3)
    weight = grid.weight.reshape(grid.count_n, grid.count_e, grid.count_d).astype(np.int64)
    index = np.arange(weight.size).reshape(weight.shape)
    inner = (slice(1, -1),) * 3
    rows, columns, costs = [], [], []
    for move in itertools.product((-1, 0, 1), repeat=3):
        # The cells of the block that the move goes through, its ends among them; all must be free.
        block = [shifted(weight, part) for part in itertools.product(*({0, x} for x in move))]
        free = np.logical_and.reduce(block) if any(move) else np.zeros_like(weight[inner], dtype=bool)
        cost = (0, 35, 50, 61)[sum(map(abs, move))] * (weight[inner] + shifted(weight, move))
        rows.append(index[inner][free])
        columns.append(shifted(index, move)[free])
        costs.append(cost[free])
    rows, columns, costs = map(np.concatenate, (rows, columns, costs))
    graph = coo_matrix((costs, (rows, columns)), shape=(len(grid.weight),) * 2).tocsr()
    largest = np.bincount(grid.part[grid.part > 0]).argmax()
    goal, *starts = rng.choice(np.flatnonzero(grid.part == largest), 9, replace=False)
    expected = dijkstra(graph, indices=goal)
    field = CostField.towards(grid, int(goal))
    paths = []
    for start in starts:
        paths.append(field.path(grid, int(start)))
        assert field.cost[start] - 1 == expected[start]
        fresh = CostField.towards(grid, int(goal)).path(grid, int(start))
        np.testing.assert_array_equal(paths[-1], fresh)  # whoever asked before
        slow = CostField.towards(grid, int(goal))
        while (paused := slow.path(grid, int(start), 37)) is None:
            pass
        np.testing.assert_array_equal(paused, fresh)
    settled = field.cost > 0
    np.testing.assert_array_equal(field.cost[settled] - 1, expected[settled])


@pytest.mark.parametrize("seed", range(6))
def test_a_routes_length_is_within_10_percent_of_the_grids_and_mostly_below(seed):
    rng = np.random.default_rng(100 + seed)
    table = random_table(rng, 12)
    router = Router(table, 0.4, floor_m=0.3)
    ratios = []
    for _ in range(12):
        start, goal = rng.uniform([-6, -6, -5], [-5, 6, -0.4]), rng.uniform([5, -6, -5], [6, 6, -0.4])
        found = router.plan(start, goal)
        if found is not None and len(found.points_ned) > 1 and found.legs_m.min() >= 0.4 - ROUNDING_M:
            grid = router.grid
            ends = [cell_at(grid, goal), cell_at(grid, start)]
            field = CostField.towards(grid, ends[0])
            field.path(grid, ends[1])
            grid_m = (field.cost[ends[1]] - 1) / 70 * grid.cell_m
            grid_m += sum(np.linalg.norm(centre(grid, c) - p) for c, p in zip(ends, (goal, start), strict=True))
            ratios.append(found.length_m / grid_m)
    assert not ratios or max(ratios) < 1.05


@given(seed=st.integers(0, 2**32 - 1), count=st.integers(1, 25))
@settings(max_examples=60, deadline=None, derandomize=True)
def test_routes_among_random_shapes_keep_what_they_tell(seed, count):
    rng = np.random.default_rng(seed)
    table = random_table(rng, count)
    start, goal = rng.uniform([-6, -6, -6], [6, 6, -0.3], (2, 3))
    at_start, at_goal = ob.clearance(table, [start, goal])
    found = routed(table, start, goal)
    if found is None or at_start < 0.3:
        return
    assert found.legs_m.min() >= min(0.15, at_start, at_goal if found.reaches_goal else math.inf) - ROUNDING_M


@given(seed=st.integers(0, 2**32 - 1))
@settings(max_examples=200, deadline=None, derandomize=True)
def test_a_legs_clearance_is_that_of_its_places(seed):
    rng = np.random.default_rng(seed)
    table = random_table(rng, int(rng.integers(1, 15)))
    a, b = rng.uniform([-6, -6, -6], [6, 6, 1], (2, 3))
    reach = float(rng.uniform(0.2, 2.0))
    t = np.linspace(0, 1, 1500)[:, None]
    truth = ob.clearance(table, a + t * (b - a)).min()
    told = clear_m(sight(table, reach), a, b, reach)
    step = np.linalg.norm(b - a) / 1499
    assert min(truth, reach) - step - 1e-6 <= told <= min(truth, reach) + 1e-6


@pytest.mark.parametrize(
    "keys",
    [
        {"clearance_m": 0.0},
        {"clearance_m": 0.5, "least_clearance_m": 0.6},
        {"clearance_m": 1.0, "cell_m": 0.0},
        {"clearance_m": 1.0, "floor_m": math.nan},
    ],
)
def test_what_cannot_be_is_refused(keys):
    with pytest.raises(ValueError, match="_m is"):
        Router(ob.table([]), **keys)


def test_places_must_be_finite():
    with pytest.raises(ValueError, match="goal_ned"):
        Router(ob.table([]), 0.6).plan([0, 0, 0], [math.nan, 0, 0])


def test_fields_that_are_used_again_change_no_route(monkeypatch):
    monkeypatch.setattr("gcs.planner.route.FIELD_BYTES", 1)  # two fields are kept
    rng = np.random.default_rng(5)
    table = random_table(rng, 20)
    few, places = Router(table, 0.6, floor_m=0.3), rng.uniform([-6, -6, -6], [6, 6, -0.3], (16, 2, 3))
    routes = [few.plan(start, goal) for start, goal in places]
    assert sum(found is not None and len(found.points_ned) > 1 for found in routes) > 4
    for (start, goal), found in zip(places, routes, strict=True):
        fresh = Router(table, 0.6, floor_m=0.3).plan(start, goal)
        assert (fresh is None) == (found is None)
        if fresh is not None:
            np.testing.assert_array_equal(found.points_ned, fresh.points_ned)


@pytest.mark.parametrize("free", [0.2, 0.35, 0.5])
def test_parts_of_the_free_space_are_those_of_scipy(free):
    weight = np.zeros((14, 15, 16), dtype=np.uint8)
    weight[1:-1, 1:-1, 1:-1] = np.random.default_rng(5).uniform(size=(12, 13, 14)) < free
    expected, count = ndimage.label(weight)
    assert count > 1
    assert (route_grid.connected_parts(weight) == expected.ravel()).all()
