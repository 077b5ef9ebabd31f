"""Truth: kinematics by hand, docs/model/planner.md#potential-field's path, and the plain field as the measure of the
feed-forward."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from gcs.planner import fuzzy_escape
from gcs.planner.leader import advance
from gcs.planner.potential_field import FieldConstants
from skytender import geometry

FIELD = FieldConstants()
NO_OBSTACLE = geometry.table([])
NWU_TO_NED = np.array([1.0, -1.0, -1.0])
EXAMPLE_1 = NWU_TO_NED * [
    (1, 2, 1.5), (2, 2, 1), (2, 2, 2), (4, 2.2, 2.1), (4.1, 3, 2.1), (3, 5, 2.1), (4, 5, 2.1), (5, 5, 2.3),
    (5.8, 5, 2.4), (8, 5, 2.6), (8.3, 6, 2.7), (8, 8, 2.6), (8.5, 8, 2.7),
]  # fmt: skip
WALL = [(5, -0.5, 0), (5, 0, 0), (5, 0.5, 0)]
Path = Callable[[float], np.ndarray]


def tick(q: object, memory: np.ndarray, goals: object, velocity: object, **changed: object) -> tuple[np.ndarray, ...]:
    n = len(q)  # type: ignore[arg-type]
    moving = changed.pop("moving", np.zeros((0, 3)))
    m = len(moving)  # type: ignore[arg-type]
    arguments: dict[str, object] = {
        "repulsors": NO_OBSTACLE, "moving": moving, "ranges_m": np.ones(m), "owner": np.full(m, -1),
        "exempt": np.zeros((n, m), bool), "field": FIELD, "speed_m_s": np.full(n, 2.0), "period_s": 0.1, "escape": True,
    }  # fmt: skip
    return advance(q, memory, goals, velocity, **(arguments | changed))  # type: ignore[arg-type]


def one(q: object, goal: object, **changed: object) -> tuple[np.ndarray, ...]:
    return tick([q], fuzzy_escape.new_memory(1), [goal], [(0, 0, 0)], **changed)


def follow(
    path: Path, duration_s: float, *, points: object = (), fed: bool = True, speed: float = 2.0, **changed: object
) -> tuple[np.ndarray, np.ndarray, float]:
    """One leader from the path's start: points (k, 3), distances from the goal (k,) after each period, clearance."""
    table = geometry.points(np.array(points, dtype=float).reshape(-1, 3))
    q, memory = np.array([path(0.0)]), fuzzy_escape.new_memory(1)
    trail, lag = [q[0]], []
    for k in range(round(duration_s / 0.1)):
        t = 0.1 * k
        velocity = (path(t + 1e-6) - path(t)) / 1e-6 * fed
        q, memory, _ = tick(q, memory, [path(t)], [velocity], repulsors=table, speed_m_s=[speed], **changed)
        trail.append(q[0])
        lag.append(float(np.linalg.norm(q[0] - path(t + 0.1))))
    return np.array(trail), np.array(lag), float(geometry.clearance(table, np.array(trail)).min())


def straight(start: object, end: object, speed: float) -> tuple[Path, float]:
    a, b = np.array(start, dtype=float), np.array(end, dtype=float)
    length = float(np.linalg.norm(b - a))
    return (lambda t: a + (b - a) / length * min(speed * t, length)), length / speed + 5


def circle(speed: float) -> Path:
    return lambda t: 3 * np.array([math.cos(speed / 3 * t), math.sin(speed / 3 * t), 0])


@pytest.mark.parametrize("speed", [0.3, 1.0, 2.5, 7.0])
def test_towards_a_far_goal_it_flies_at_its_speed(speed: float) -> None:
    q, _, v = one((0, 0, 0), (30, 40, 0), speed_m_s=[speed])
    assert v[0] == pytest.approx([0.6 * speed, 0.8 * speed, 0])
    assert q[0] == pytest.approx(v[0] * 0.1)


def test_within_a_metre_of_the_goal_it_slows_down_in_proportion() -> None:
    # One step of 0.1 m, |F| = k0 · 0.4 m.
    assert one((0, 0, 0), (0.4, 0, 0), speed_m_s=[1.0])[2][0] == pytest.approx([0.4, 0, 0])


def test_at_rest_it_stays() -> None:
    assert (one((1, 2, 3), (5, 5, 5), speed_m_s=[0.0])[0] == [(1, 2, 3)]).all()
    assert (one((1, 2, 3), (1, 2, 3))[0] == [(1, 2, 3)]).all()


def test_example_1_is_flown_at_the_published_length_and_clearance() -> None:
    table = geometry.points(EXAMPLE_1)
    trail, memory = [np.zeros((1, 3))], fuzzy_escape.new_memory(1)
    for goal in NWU_TO_NED * [(5, 5, 1.5), (10, 10, 3)]:
        while np.linalg.norm(trail[-1][0] - goal) > 0.1:
            q, memory, _ = tick(trail[-1], memory, [goal], [(0, 0, 0)], repulsors=table, speed_m_s=[1.0])
            trail.append(q)
            assert len(trail) < 300
    path = np.concatenate(trail)
    # docs/model/planner.md#potential-field: 14.5 m and 0.451 m, measured with full steps; slowing down before a point
    # rounds the path off less.
    assert np.linalg.norm(np.diff(path, axis=0), axis=1).sum() == pytest.approx(14.5, abs=0.1)
    assert geometry.clearance(table, path).min() > 0.451


@pytest.mark.parametrize("speed", [0.5, 1.0, 3.0])
def test_the_escape_takes_it_past_an_obstacle_exactly_on_its_line(speed: float) -> None:
    """The minimum is a saddle: only exactly on the axis does the plain field stop; 1e-9 m beside it would free it."""
    ticks = round(30 / speed / 0.1)
    for escape in (True, False):
        q, memory = np.zeros((1, 3)), fuzzy_escape.new_memory(1)
        for _ in range(ticks):
            q, memory, v = tick(
                q, memory, [(10, 0, 0)], [(0, 0, 0)],
                repulsors=geometry.points([(5, 0, 0)]), speed_m_s=[speed], escape=escape,
            )  # fmt: skip
        if escape:
            assert np.linalg.norm(q[0] - (10, 0, 0)) < 0.1
        else:
            assert 4 < q[0][0] < 5
            assert np.linalg.norm(v) < 1e-6


@pytest.mark.parametrize("speed", [0.4, 0.8, 1.9])
def test_a_moving_goal_is_followed_without_lag_when_the_field_is_free(speed: float) -> None:
    path, _ = straight((0, 0, 0), (30, 40, 0), speed)
    assert follow(path, 10)[1].max() < 1e-6
    assert follow(path, 10, fed=False)[1][-1] > speed / 2 * 0.05


def test_a_goal_on_a_circle_is_followed_within_centimetres() -> None:
    assert follow(circle(0.8), 25)[1].max() < 0.01
    assert follow(circle(0.8), 25, fed=False)[1][-1] > 0.3


def test_it_never_exceeds_its_speed() -> None:
    trail, _, _ = follow(circle(3.0), 10, points=[(0, 3, 0)])
    assert np.linalg.norm(np.diff(trail, axis=0), axis=1).max() <= 0.2 + 1e-12


STANDARD = {
    "one obstacle on the line": [(5, 0, 0)],
    "one beside the line": [(5, 0.3, 0)],
    "Example 1": EXAMPLE_1,
}


@pytest.mark.parametrize("speed", [0.8, 1.5])
@pytest.mark.parametrize("scene", STANDARD)
def test_feed_forward_brings_it_no_closer_to_an_obstacle(scene: str, speed: float) -> None:
    path, duration = straight((0, 0, 0), (10, -10, -3) if scene == "Example 1" else (10, 0, 0), speed)
    fed = follow(path, duration, points=STANDARD[scene])
    plain = follow(path, duration, points=STANDARD[scene], fed=False)
    assert fed[2] >= plain[2]
    assert fed[1][-1] < 0.01


@pytest.mark.parametrize("speed", [0.8, 1.5])
@pytest.mark.parametrize(
    "points",
    [
        WALL,
        [(5, -0.8, 0), (5, 0, 0), (5, 0.8, 0)],
        [*WALL, (4.5, -0.5, 0), (4.5, 0.5, 0)],
        [*WALL, (4.5, -0.5, 0), (4.5, 0.5, 0), (4, -0.5, 0), (4, 0.5, 0)],
    ],
    ids=["wall 0.5 m", "wall 0.8 m", "shallow U", "deep U"],
)
def test_feed_forward_around_walls_costs_at_most_two_centimetres(points: object, speed: float) -> None:
    # The two fly by at different times on different paths, so that no order between them holds exactly.
    path, duration = straight((0, 0, 0), (10, 0, 0), speed)
    fed = follow(path, duration, points=points)
    assert fed[2] > follow(path, duration, points=points, fed=False)[2] - 0.02
    assert fed[1][-1] < 0.01


def test_vehicles_repel_each_other_but_not_themselves() -> None:
    at = np.array([(0, 0, 0), (0.5, 0, 0)], dtype=float)
    q, _, _ = tick(at, fuzzy_escape.new_memory(2), at, np.zeros((2, 3)), moving=at, owner=[0, 1])
    assert q[0][0] < 0
    assert q[1][0] > 0.5
    assert q[0] == pytest.approx(np.array([0.5, 0, 0]) - q[1])


def test_an_exempt_pair_does_not_repel_and_the_exemption_is_one_way() -> None:
    at = np.array([(0, 0, 0), (0.5, 0, 0)], dtype=float)
    exempt = np.array([[False, True], [False, False]])
    q, _, _ = tick(at, fuzzy_escape.new_memory(2), at, np.zeros((2, 3)), moving=at, owner=[0, 1], exempt=exempt)
    assert (q[0] == 0).all()
    assert q[1][0] > 0.5
    assert not exempt[0, 0]


def test_a_moving_repulsor_acts_within_its_own_range() -> None:
    near, far = (one((0, 0, 0), (0, 0, 0), moving=[(1.4, 0, 0)], ranges_m=[r])[0][0] for r in (1.5, 1.3))
    assert near[0] < 0
    assert (far == 0).all()


def test_the_order_of_leaders_does_not_matter_and_results_repeat_exactly() -> None:
    rng = np.random.default_rng(2)
    at, goals, velocity = rng.uniform(-2, 2, (3, 30, 3))
    order = rng.permutation(30)
    table = geometry.points(rng.uniform(-2, 2, (20, 3)))

    def run(which: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        q, memory = at[which], fuzzy_escape.new_memory(30)
        for _ in range(20):
            q, memory, _ = tick(q, memory, goals[which], velocity[which], repulsors=table)
        return q, memory

    plain, shuffled = run(np.arange(30)), run(order)
    assert np.array_equal(plain[0][order], shuffled[0])
    assert np.array_equal(plain[1][order], shuffled[1])


def test_the_arguments_are_left_alone() -> None:
    q, memory = np.zeros((1, 3)), fuzzy_escape.new_memory(1)
    tick(q, memory, [(5, 0, 0)], [(0, 0, 0)])
    assert (q == 0).all()
    assert (memory == 0).all()


def test_no_leader_is_no_work() -> None:
    q, memory, v = tick(np.zeros((0, 3)), fuzzy_escape.new_memory(0), np.zeros((0, 3)), np.zeros((0, 3)))
    assert q.shape == v.shape == (0, 3)
    assert memory.shape == (0, fuzzy_escape.MEMORY_SIZE)


@pytest.mark.parametrize(
    ("changed", "says"),
    [
        ({"speed_m_s": [-1.0]}, "speed_m_s"),
        ({"period_s": 0.0}, "period_s"),
        ({"exempt": np.zeros((2, 2), bool)}, "exempt"),
        ({"moving": [(1, 0, 0)], "owner": [1]}, "owner"),
        ({"moving": [(1, math.nan, 0)]}, "moving"),
        ({"moving": [(1, 0, 0)], "ranges_m": []}, "ranges_m"),
        ({"repulsors": np.zeros((1, 3))}, "repulsors"),
    ],
)
def test_a_wrong_argument_is_refused_by_name(changed: dict[str, object], says: str) -> None:
    with pytest.raises(ValueError, match=says):
        one((0, 0, 0), (1, 0, 0), **changed)


def test_a_goal_that_is_not_a_number_is_refused() -> None:
    with pytest.raises(ValueError, match="goals"):
        one((0, 0, 0), (math.nan, 0, 0))


def test_an_attractor_draws_within_its_range_and_only_whom_it_is_to_draw() -> None:
    """Beside the goal straight ahead, both 3 m away: forces k0 each, so that two of three go half-way to the side."""
    goals, still = [(3, 0, 0)] * 3, [(0, 0, 0)] * 3
    how = {"speed_m_s": [1.0] * 3, "attractors": [(0, 3, 0)], "drawn": [[True], [True], [False]]}
    near = tick([(0, 0, 0)] * 3, fuzzy_escape.new_memory(3), goals, still, attraction_ranges_m=[3.5], **how)[2]
    assert near == pytest.approx(np.array([(0.5**0.5, 0.5**0.5, 0), (0.5**0.5, 0.5**0.5, 0), (1, 0, 0)]))
    far = tick([(0, 0, 0)] * 3, fuzzy_escape.new_memory(3), goals, still, attraction_ranges_m=[2.5], **how)[2]
    assert far == pytest.approx(np.array([(1, 0, 0)] * 3))


def test_attractors_for_nobody_are_refused() -> None:
    with pytest.raises(ValueError, match="drawn"):
        one((0, 0, 0), (1, 0, 0), attractors=[(0, 3, 0)], attraction_ranges_m=[1.0], drawn=[[True], [True]])


def test_full_steps_neither_shrink_before_a_way_point_nor_pass_the_goal() -> None:
    """Example 1 by eq. 4: 146 steps of 0.1 m, counted by hand of docs/model/planner.md#potential-field's measure; the
    default comes to the way point at a tenth of that."""
    table = geometry.points(EXAMPLE_1)
    course = [NWU_TO_NED * (5.0, 5.0, 1.5), NWU_TO_NED * (10.0, 10.0, 3.0)]
    for field, steps, least_m in ((replace(FIELD, full_steps=True), 146, 0.1), (FIELD, None, 0.012)):
        q, lengths, left = np.zeros(3), [], list(course)
        while left and len(lengths) < 300:
            (q_next, *_), *_ = one(q, left[0], field=field, speed_m_s=[1.0], repulsors=table, escape=False)
            lengths.append(float(np.linalg.norm(q_next - q)))
            q = q_next
            if np.linalg.norm(q - left[0]) <= 0.1:
                left.pop(0)
        assert not left
        assert steps in (None, len(lengths))
        assert min(lengths[:-1]) == pytest.approx(least_m, rel=0.3 if steps is None else 1e-9)
    resting, *_ = one(course[1], course[1], field=replace(FIELD, full_steps=True), speed_m_s=[1.0])
    assert resting[0] == pytest.approx(course[1])
    beside, *_ = one(course[1] + (0.03, 0.0, 0.0), course[1], field=replace(FIELD, full_steps=True), speed_m_s=[1.0])
    assert beside[0] == pytest.approx(course[1])


@pytest.mark.parametrize("seed", range(3))
def test_what_cannot_come_into_range_adds_nothing_to_the_last_bit(seed: int) -> None:
    """Also one whose range ends where a leader's way may end, a rounding before it or beyond."""
    rng = np.random.default_rng(seed)
    n, speed, period_s = 40, 3.0, 0.1
    q, goals = rng.uniform(-10, 10, (n, 3)), rng.uniform(-10, 10, (n, 3))
    memory, velocity = fuzzy_escape.new_memory(n), rng.uniform(-1, 1, (n, 3))

    def moved(at: np.ndarray, radii: np.ndarray, ranges: np.ndarray) -> tuple[np.ndarray, ...]:
        return tick(
            q, memory, goals, velocity, moving=at, radii_m=radii, ranges_m=ranges,
            speed_m_s=np.full(n, speed), period_s=period_s,
        )  # fmt: skip

    at, radii, ranges = rng.uniform(-12, 12, (60, 3)), rng.uniform(0, 0.5, 60), rng.uniform(0.2, 1.5, 60)
    edge = rng.normal(size=(n, 3))
    edge = q + edge / np.linalg.norm(edge, axis=1)[:, None] * (
        1.0 + speed * period_s + rng.uniform(-1e-9, 1e-9, (n, 1))
    )
    at, radii, ranges = np.vstack([at, edge]), np.append(radii, np.zeros(n)), np.append(ranges, np.ones(n))
    apart_m = np.linalg.norm(q[:, None] - at, axis=2) - (radii + ranges + speed * period_s)
    near = (apart_m <= 1e-7).any(axis=0)
    assert 0 < np.count_nonzero(~near) < len(at)
    every, some, none = (moved(at[k], radii[k], ranges[k]) for k in (near | True, near, near & False))
    assert [x.tobytes() for x in every] == [x.tobytes() for x in some]
    assert every[0].tobytes() != none[0].tobytes()
    alone = [
        advance(
            q[i : i + 1], memory[i : i + 1], goals[i : i + 1], velocity[i : i + 1], repulsors=NO_OBSTACLE, moving=at,
            radii_m=radii, ranges_m=ranges, owner=np.full(len(at), -1), field=FIELD, speed_m_s=speed,
            period_s=period_s, escape=True, exempt=(apart_m[i : i + 1] > 1e-7),
        )[0][0]
        for i in range(n)
    ]  # fmt: skip
    assert np.array(alone).tobytes() == every[0].tobytes()


@pytest.mark.parametrize(("ahead_m", "felt"), [(1.19, True), (1.21, False)])
def test_what_comes_into_range_on_the_way_is_felt_from_there_on(ahead_m: float, felt: bool) -> None:
    """Three steps of 0.1 m: the last begins 0.2 m on, and the range is 1 m."""
    there, free = (
        one((0, 0, 0), (9, 0, 0), moving=moving, speed_m_s=[3.0], escape=False)[0]
        for moving in (np.array([(ahead_m, 0.0, 0.0)]), np.zeros((0, 3)))
    )
    assert (there.tobytes() != free.tobytes()) is felt
