"""No set point leaves the fence: its border and walls by dense sampling, the filter by random fences and wishes."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from sessions import merged, small

from gcs.planner.fence import FenceBorder
from gcs.planner.route import Router
from gcs.scenario.fence import Area, FenceRules
from gcs.scenario.model import Scenario
from skytender import geometry
from skytender.safety.safety_filter import FilterSettings, Leaders, filter_step

Floats = NDArray[np.float64]
seeds = st.integers(0, 2**32 - 1)
fixed = settings(derandomize=True, deadline=None, max_examples=25, database=None)
CLEAR_M, MARGIN_M, BRAKE_M_S2 = 0.2, 0.1, 5.0
BAY = ((-8, -8), (8, -8), (8, 8), (2, 8), (2, -4), (-2, -4), (-2, 8), (-8, 8))
"""A U that opens to the east, by its corners (north, east)."""


def fence_of(rules: FenceRules, clearance_m: float = CLEAR_M, **more: object) -> FenceBorder:
    made = Scenario.model_validate(small(**more)).model_copy(update={"fence": rules})
    return FenceBorder(made, clearance_m)


def drawn(random: np.random.Generator) -> FenceRules:
    """One to three overlapping stars and circles to stay in, up to two to stay out of."""

    def area(reach_m: float, spread_m: float) -> Area:
        n, e = random.uniform(-spread_m, spread_m, 2).tolist()
        if random.random() < 0.4:
            return Area(circle_m=(n, e), radius_m=reach_m * random.uniform(0.5, 1.0))
        turns = np.sort(random.uniform(0.0, 2.0 * math.pi, int(random.integers(3, 9)))).tolist()
        return Area(polygon_m=tuple(
            (n + r * math.cos(t), e + r * math.sin(t))
            for t, r in zip(turns, random.uniform(0.3 * reach_m, reach_m, len(turns)).tolist(), strict=True)
        ))  # fmt: skip

    inside = tuple(area(10.0, 4.0) for _ in range(random.integers(1, 4)))
    return FenceRules(inside=inside, outside=tuple(area(3.0, 6.0) for _ in range(random.integers(0, 3))))


def sampled(a: Floats, b: Floats, step_m: float = 0.02) -> Floats:
    return a + np.linspace(0.0, 1.0, 2 + int(math.dist(a, b) / step_m))[:, None] * (b - a)


def test_a_way_past_a_wall_is_as_far_from_it_as_its_nearest_place() -> None:
    random = np.random.default_rng(4)
    crossed = 0
    for _ in range(100):
        a, b, c, d = random.uniform(-5.0, 5.0, (4, 2))
        table = geometry.table([geometry.wall(tuple(a), tuple(b))])
        least, share, gn, ge = geometry.way_past_wall(table, 0, c, d)
        on_wall, on_way = sampled(a, b), sampled(c, d)
        truth = np.hypot(*(on_way[:, None] - on_wall[None]).transpose(2, 0, 1)).min()
        left = np.array([-(b - a)[1], (b - a)[0]]) / math.dist(a, b)
        beyond = [(end - a) @ left for end in (c, d)]
        if least < 0.0:  # so far beyond as its end is
            crossed += 1
            assert truth < 0.04
            assert share == 1.0
            assert abs(least) == pytest.approx(abs(beyond[1]))
            assert np.sign(np.array([gn, ge]) @ left) == np.sign(beyond[0])
        else:
            assert least == pytest.approx(truth, abs=0.021)
            nearest = c + share * (d - c)
            assert math.dist(nearest - least * np.array([gn, ge]), nearest) == pytest.approx(least)
    assert 8 < crossed < 50


@fixed
@given(seeds)
def test_the_border_lies_between_where_one_may_be_and_where_not(seed: int) -> None:
    """By the scenario's own rule, which has true circles: places nearer to the border than those and chords differ are
    left out. On a straight way one may be at all places, or at none, exactly where it crosses no wall."""
    random = np.random.default_rng(seed)
    rules = drawn(random)
    fence = fence_of(rules)
    for c, d in random.uniform(-14.0, 14.0, (4, 2, 2)):
        places = sampled(c, d, 0.2)
        clear = geometry.clearance(fence.walls, np.pad(places, ((0, 0), (0, 1)))) > 0.03
        allowed = np.array([rules.allows(n, e) for n, e in places.tolist()])
        assert (fence.allows(places)[clear] == allowed[clear]).all()
        walls = range(len(fence.walls))
        crosses = any(geometry.way_past_wall(fence.walls, i, np.array(c), np.array(d))[0] < 0.0 for i in walls)
        if clear.all():
            assert crosses is (len(set(allowed.tolist())) == 2)


def test_areas_that_touch_or_overlap_have_no_border_between_them() -> None:
    west, east = (Area(polygon_m=((-5, e), (5, e), (5, e + 4), (-5, e + 4))) for e in (-4.0, 0.0))
    fence = fence_of(FenceRules(inside=(west, east, Area(circle_m=(0.0, 0.0), radius_m=3.0))))
    assert geometry.way_past_wall(fence.walls, 0, np.array([0.0, -3.0]), np.array([0.0, 3.0]))[0] > 0.0
    length_m = 2.0 * np.hypot(*fence.walls[:, geometry.SIZE_1 : geometry.SIZE_2 + 1].T).sum()
    assert length_m == pytest.approx(2 * 10.0 + 2 * 8.0)


@pytest.mark.parametrize(
    ("place", "brought"),
    [((-5.0, 0.0), (-5.0, 0.0)), ((12.0, 3.0), (7.5, 3.0)), ((0.5, 1.0), (2.5, 1.0)), ((-20.0, -20.0), (-7.5, -7.5))],
)
def test_a_place_beyond_is_brought_inside(place: tuple[float, float], brought: tuple[float, float]) -> None:
    fence = fence_of(FenceRules(inside=(Area(polygon_m=BAY),)), 0.5)
    assert fence.brought_inside((*place, -3.0)) == pytest.approx((*brought, -3.0))


def test_without_the_safety_layer_or_a_fence_nothing_is_forbidden() -> None:
    rules = FenceRules(inside=(Area(polygon_m=BAY),))
    for fence in (fence_of(rules, planner={"safety": False}), fence_of(FenceRules())):
        assert len(fence.walls) == 0
        assert fence.allows(np.array([[99.0, 99.0, -1.0]])).all()
        assert fence.brought_inside((99.0, 99.0, -1.0)) == (99.0, 99.0, -1.0)


@settings(fixed, max_examples=10)
@given(seeds, st.booleans())
def test_who_is_inside_stays_inside_whatever_is_wished(seed: int, poor: bool) -> None:
    """All places of each period's flight, at up to 5 m/s, among fences of bays, spikes and circles; a projection too
    poor to help is caught by the check."""
    random = np.random.default_rng(seed)
    fence = fence_of(drawn(random))
    rules = FilterSettings(rounds=1, sweeps=1, buffer_m=0.0) if poor else FilterSettings()
    places = np.column_stack([random.uniform(-14.0, 14.0, (400, 2)), np.full(400, -4.0)])
    clear = (geometry.clearance(fence.walls, places) > CLEAR_M + MARGIN_M + 0.01) & fence.allows(places)
    p = places[clear][:5]
    apart = [k for k in range(len(p)) if all(math.dist(p[k], p[j]) > 1.0 for j in range(k))]
    p = p[apart]
    if not len(p):
        return
    v, wish = np.zeros_like(p), np.zeros_like(p)
    for k in range(60):
        if k % 9 == 0:
            wish = random.normal(size=p.shape) * (5.0 if k % 2 else 1e3)
        leaders = Leaders(np.arange(len(p)), p, v, 5.0, BRAKE_M_S2, MARGIN_M)
        out = filter_step(leaders, wish, rules=rules, obstacles=fence.walls, beyond=~fence.allows(p))
        for s in np.linspace(0.0, rules.period_s, 9):
            way = p + s * v + 0.5 * s * s * out.u_ned
            assert fence.allows(way).all()
            assert geometry.clearance(fence.walls, way).min() >= CLEAR_M + MARGIN_M - 1e-6
        p, v = out.p_next_ned, out.v_next_ned


def test_who_is_beyond_may_come_back_and_is_then_kept() -> None:
    fence = fence_of(FenceRules(inside=(Area(polygon_m=BAY),)))
    p, v, wish = np.array([[12.0, -6.0, -3.0]]), np.zeros((1, 3)), np.array([[-4.0, 0.0, 0.0]])
    seen = []
    for _ in range(120):
        leaders = Leaders([1], p, v, 4.0, BRAKE_M_S2, MARGIN_M)
        out = filter_step(leaders, wish, rules=FilterSettings(), obstacles=fence.walls, beyond=~fence.allows(p))
        p, v = out.p_next_ned, out.v_next_ned
        seen.append(bool(fence.allows(p)[0]))
    assert seen == sorted(seen)
    assert not seen[0]
    assert p[0, 0] == pytest.approx(-8.0 + CLEAR_M + MARGIN_M, abs=0.05)  # through the fence to its other side


@pytest.mark.parametrize("height_m", [3.0, 40.0])
def test_a_route_goes_around_the_bay_at_the_height_it_is_flown_at(height_m: float) -> None:
    """From one arm of the U to the other; the shortest way by hand touches both inner corners, at the clearance."""
    places = [[5.0, 6.0, -height_m], [-5.0, 6.0, -height_m]]
    content = merged(small(), {"vehicles": {"targets": []}})
    content["vehicles"]["targets"] = [{**small()["vehicles"]["targets"][0], "path_m": places}]
    made = Scenario.model_validate(content).model_copy(update={"fence": FenceRules(inside=(Area(polygon_m=BAY),))})
    fence = FenceBorder(made, 0.6)
    found = Router(fence.walls, 0.6, floor_m=0.3).plan(places[0], places[1])
    assert found is not None
    assert found.reaches_goal
    path = np.array([places[0], *found.points_ned.tolist()])
    for a, b in itertools.pairwise(path):
        assert fence.allows(sampled(a, b)).all()
    assert np.ptp(path[:, 2]) < 0.5
    by_hand_m = 2 * math.hypot(3.0 - 0.6, 10.0) + 2 * math.hypot(2.6, 0.6)
    assert found.length_m == pytest.approx(by_hand_m, rel=0.05)
    assert Router(fence.walls, 0.6, floor_m=0.3).plan(places[0], [20.0, 6.0, -height_m]) is None


def test_a_wall_is_tight_between_cells_of_any_size() -> None:
    """A wide fence is searched in cells far wider than its clearance: no two of them meet through the border."""
    corners = tuple((400.0 * n, 400.0 * e) for n, e in ((-1, -0.9), (0.3, -1), (1, 0.2), (-0.2, 1)))
    fence = fence_of(FenceRules(inside=(Area(polygon_m=corners),)))
    router = Router(fence.walls, 0.6, floor_m=0.3, cell_m=7.0)
    assert router.plan([0.0, 0.0, -3.0], [600.0, 600.0, -3.0]) is None
    within = router.plan([0.0, 0.0, -3.0], [-300.0, -300.0, -3.0])
    assert within is not None
    assert within.reaches_goal
