"""Truth: numeric gradients of the potential, closed values, and the paths measured in
docs/model/planner.md#potential-field."""

import math

import numpy as np
import pytest
from field import attraction_potential, force, repulsion_potential, surface
from hypothesis import given, settings
from hypothesis import strategies as st

from gcs.planner.potential_field import SURFACE_FLOOR_M, FieldConstants, widened_range
from skytender import geometry

FIELD = FieldConstants()
# Example 1 of the paper (north, west, up), turned to NED.
NWU_TO_NED = np.array([1.0, -1.0, -1.0])
EXAMPLE_1 = NWU_TO_NED * [
    (1, 2, 1.5), (2, 2, 1), (2, 2, 2), (4, 2.2, 2.1), (4.1, 3, 2.1), (3, 5, 2.1), (4, 5, 2.1), (5, 5, 2.3),
    (5.8, 5, 2.4), (8, 5, 2.6), (8.3, 6, 2.7), (8, 8, 2.6), (8.5, 8, 2.7),
]  # fmt: skip
LEGS = NWU_TO_NED * [(5, 5, 1.5), (10, 10, 3)]


def repulsion_at(q: object, table: np.ndarray, field: FieldConstants = FIELD) -> np.ndarray:
    ranges = np.full(len(table), field.repulsion_range_m)
    return force(q, tracked=[], waypoints=[], repulsors=table, ranges_m=ranges, field=field)[1]


def attraction_at(q: object, goal: object, field: FieldConstants = FIELD) -> np.ndarray:
    return force(q, tracked=[goal], waypoints=[], repulsors=geometry.table([]), ranges_m=[], field=field)[0]


@pytest.mark.parametrize("rho", [0.005, 0.05, 0.2, 0.4, 0.49, 0.51, 0.7, 0.95, 1.2])
def test_repulsion_is_minus_the_gradient_of_its_potential(rho: float) -> None:
    h = 1e-6
    slope = (repulsion_potential(rho + h, 1.0, FIELD) - repulsion_potential(rho - h, 1.0, FIELD)) / (2 * h)
    got = repulsion_at((rho, 0, 0), geometry.points([(0, 0, 0)]))
    assert got == pytest.approx([-slope, 0, 0], rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("cap_m", [1.0, math.inf])
@pytest.mark.parametrize("rho", [0.1, 0.9, 1.1, 30.0])
def test_attraction_is_minus_the_gradient_of_its_potential(rho: float, cap_m: float) -> None:
    field, h = FieldConstants(cap_m=cap_m), 1e-6
    slope = (attraction_potential(rho + h, field) - attraction_potential(rho - h, field)) / (2 * h)
    assert attraction_at((0, rho, 0), (0, 0, 0), field) == pytest.approx([0, -slope, 0], rel=1e-6)


def test_gradient_in_space_of_several_shapes() -> None:
    table = geometry.table(
        [geometry.sphere((1, 0, 0), 0.6), geometry.box((-2, -1, -1), (-0.5, 1, 1)), geometry.point((0, 0.8, 0.1))]
    )

    def total(q: np.ndarray) -> float:
        return sum(repulsion_potential(d, 1.0, FIELD) for d in surface(table, q)[0])

    h = 1e-6
    for q in np.random.default_rng(1).uniform(-0.3, 0.3, (20, 3)):
        gradient = [(total(q + h * e) - total(q - h * e)) / (2 * h) for e in np.eye(3)]
        assert repulsion_at(q, table) == pytest.approx(-np.array(gradient), rel=1e-5, abs=1e-5)


@pytest.mark.parametrize("edge", [1.0, 0.5])
def test_repulsion_and_its_potential_are_continuous_at_both_edges(edge: float) -> None:
    table, d = geometry.points([(0, 0, 0)]), 1e-9
    assert repulsion_potential(edge - d, 1.0, FIELD) == pytest.approx(
        repulsion_potential(edge + d, 1.0, FIELD), abs=1e-6
    )
    assert repulsion_at((edge - d, 0, 0), table) == pytest.approx(repulsion_at((edge + d, 0, 0), table), abs=1e-6)


fields = st.builds(
    FieldConstants,
    k0=st.floats(0.1, 100.0),
    k1=st.floats(0.1, 20.0),
    a=st.floats(0.0, 3.0),
    b=st.floats(0.1, 0.9),
    repulsion_range_m=st.floats(0.5, 5.0),
    cap_m=st.floats(0.1, 10.0),
)
away = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda d: math.hypot(*d) > 0.1)


@settings(max_examples=300, deadline=None)
@given(fields, away, st.floats(0.03, 6.0))
def test_any_field_is_minus_the_gradient_in_space(
    field: FieldConstants, direction: tuple[float, ...], rho: float
) -> None:
    q, h = rho * np.array(direction) / math.hypot(*direction), 1e-6 * rho
    edges = (field.cap_m, field.repulsion_range_m, field.b * field.repulsion_range_m)
    table = geometry.points([(0, 0, 0)])

    def slope(potential: object) -> np.ndarray:
        def of(q: np.ndarray) -> float:
            return potential(float(np.linalg.norm(q)))  # type: ignore[operator, no-any-return]

        return np.array([(of(q + h * e) - of(q - h * e)) / (2 * h) for e in np.eye(3)])

    # A central difference across an edge sees half of the bend: allow for its second derivative times h.
    near_edge = 1e-3 if min(abs(rho - edge) for edge in edges) < 2 * h else 1e-5
    repulsion = -slope(lambda d: repulsion_potential(d, field.repulsion_range_m, field))
    size = field.k1 / rho**3 + field.k0 * rho
    assert repulsion_at(q, table, field) == pytest.approx(repulsion, rel=1e-5, abs=near_edge * size)
    attraction = -slope(lambda d: attraction_potential(d, field))
    assert attraction_at(q, (0, 0, 0), field) == pytest.approx(attraction, rel=1e-5, abs=near_edge * size)


@settings(max_examples=200, deadline=None)
@given(fields, st.booleans())
def test_any_repulsion_is_c1_at_both_edges(field: FieldConstants, inner: bool) -> None:
    edge = field.repulsion_range_m * (field.b if inner else 1.0)
    table, d = geometry.points([(0, 0, 0)]), 1e-9 * edge
    below, above = (repulsion_at((edge + s * d, 0, 0), table, field)[0] for s in (-1, 1))
    steepest = field.k1 * (1 + field.a) * 4 / edge**4  # of F_o at the edge, times a range
    assert below == pytest.approx(above, abs=10 * d * steepest)
    potentials = [repulsion_potential(edge + s * d, field.repulsion_range_m, field) for s in (-1, 1)]
    assert potentials[0] == pytest.approx(potentials[1], abs=4 * d * max(abs(below), abs(above)) + 1e-12 * field.k1)


def test_potential_has_the_closed_value() -> None:
    # rho = 1/4: ½·2·(4 - 1)² + ½·½·2·(4 - 2)² = 9 + 2
    assert repulsion_potential(0.25, 1.0, FIELD) == pytest.approx(11)


def test_beyond_its_range_nothing_repels() -> None:
    assert (repulsion_at((1.0000001, 0, 0), geometry.points([(0, 0, 0)])) == 0).all()


def test_inside_a_volume_the_force_is_finite_strong_and_points_out() -> None:
    table = geometry.table([geometry.box((-5, -5, -5), (5, 5, 5))])
    for q in [(4, 0, 0), (5, 0, 0), (5 + SURFACE_FLOOR_M / 2, 0, 0)]:
        push = repulsion_at(q, table)
        assert np.isfinite(push).all()
        assert push[0] > 1000 * FIELD.k0
        assert (push[1:] == 0).all()
    assert np.isfinite(repulsion_at((0, 0, 0), geometry.points([(0, 0, 0)]))).all()


def test_a_way_point_attracts_only_within_its_range_and_a_target_always() -> None:
    def attraction(waypoint: object, tracked: object) -> np.ndarray:
        return force(
            (0, 0, 0), tracked=tracked, waypoints=waypoint, repulsors=geometry.table([]), ranges_m=[], field=FIELD
        )[0]

    assert attraction([(0.5, 0, 0)], []) == pytest.approx([7.5, 0, 0])
    assert attraction([(1.5, 0, 0)], []) == pytest.approx([0, 0, 0])
    assert attraction([], [(0, 400, 0)]) == pytest.approx([0, 15, 0])
    assert attraction([(0.5, 0, 0)], [(0, 400, 0)]) == pytest.approx([7.5, 15, 0])


def test_range_widens_by_speed_times_age() -> None:
    assert widened_range(1.0, [2.0, 3.0, 3.0], [0.5, 0.0, -1.0]) == pytest.approx([2.0, 1.0, 1.0])


def walk(start_nwu: object, field: FieldConstants) -> tuple[int, float, float]:
    """Full steps κF/|F|, as docs/model/planner.md#potential-field was measured, by way of LEGS: steps, length,
    clearance in m."""
    table = geometry.points(EXAMPLE_1)
    ranges = np.ones(len(table))
    path = [NWU_TO_NED * start_nwu]
    for goal in LEGS:
        while np.linalg.norm(path[-1] - goal) > 0.1:
            total = sum(force(path[-1], tracked=[goal], waypoints=[], repulsors=table, ranges_m=ranges, field=field))
            path.append(path[-1] + field.step_m * total / np.linalg.norm(total))
            assert len(path) < 400
    return len(path) - 1, (len(path) - 1) * field.step_m, float(geometry.clearance(table, np.array(path)).min())


def test_example_1_takes_the_published_steps_and_clearance() -> None:
    steps, _, clearance = walk((0, 0, 0), FIELD)
    assert steps == 146
    assert clearance == pytest.approx(0.451, abs=0.0005)


def test_example_1_uncapped_is_pressed_to_the_published_clearance() -> None:
    assert walk((0, 0, 0), FieldConstants(cap_m=math.inf))[2] == pytest.approx(0.356, abs=0.0005)


@pytest.mark.parametrize(("start", "length_m"), [((0, 0, 0), 14.5), ((0, 5, 0), 12.5), ((0, -5, 0), 18.6)])
def test_paths_have_the_published_lengths_to_one_step(start: object, length_m: float) -> None:
    assert walk(start, FIELD)[1] == pytest.approx(length_m, abs=FIELD.step_m + 1e-9)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("k0", 0), ("k1", -1), ("a", -0.1), ("b", 0), ("b", 1), ("attraction_range_m", 0),
        ("repulsion_range_m", math.nan), ("step_m", 0), ("step_m", math.inf), ("cap_m", 0), ("cap_m", math.nan),
        ("repulsion_range_m", 0.01),
    ],
)  # fmt: skip
def test_a_parameter_out_of_range_is_refused_by_name(name: str, value: float) -> None:
    with pytest.raises(ValueError, match=name):
        FieldConstants(**{name: value})
