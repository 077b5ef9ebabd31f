"""Closest approach between two ticks, against closed forms: two lines pass each other, a line passes a point."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gcs.scenario.model import Obstacle
from gcs.telemetry import approach
from gcs.telemetry.approach import STRAIGHT, FleetWatch, nearest_to
from skytender.geometry import clearance, of_scenario

METRES = st.floats(-5.0, 5.0, width=32)
VECTOR = st.tuples(METRES, METRES, METRES)
NO_PAIRS = np.empty((0, 2), dtype=np.int64)


def nearest_pair(
    before: Any,
    now: Any,
    v_before: Any,
    v_now: Any,
    period_s: float,
    ours: Any,
    exempt: Any,
    limit_m: float,
    worth_m: float,
    found: Any,
) -> tuple[float, int, int, float, int]:
    """(distance, row, row, share, how many are too near) of an interval in which all fly and all places are known."""
    last = np.zeros((2, len(now), 3))
    last[0] = before
    last[1, : len(v_before)] = v_before
    watch = FleetWatch(last, of_scenario([]), np.empty((len(now), approach.WAY)), found)
    flying = np.ones(len(now), dtype=bool)
    return watch.look(now, v_now, period_s, flying, ours, exempt, limit_m, worth_m, 0.0, 0.0)[1:6]


def pair(
    before: np.ndarray,
    now: np.ndarray,
    *,
    ours: tuple[bool, ...] = (True, True),
    exempt: object = (),
    limit_m: float = 0.0,
) -> tuple[float, float, int]:
    """(distance, share, how many are too near) of two vehicles."""
    pairs = np.array(exempt, dtype=np.int64).reshape(-1, 2)
    flags = np.array(ours)
    found = np.empty((approach.MOST_FOUND, 4))
    least_m, _, _, share, count = nearest_pair(
        before, now, STRAIGHT, STRAIGHT, 0.1, flags, pairs, limit_m, math.inf, found
    )
    return least_m, share, count


def test_two_who_fly_through_each_other_between_two_ticks_touch() -> None:
    """Head on, 10 m/s together: 0.5 m apart at both ticks, at one place half way."""
    before, now = np.array([[0.0, 0, 0], [0.5, 0, 0]]), np.array([[0.5, 0.0, 0], [0.0, 0, 0]])
    assert pair(before, now, limit_m=0.6) == pytest.approx((0.0, 0.5, 1))


@given(VECTOR, VECTOR, VECTOR, VECTOR)
@settings(max_examples=60, deadline=None)
def test_straight_ways_come_as_near_as_relative_motion_says(a0: object, a1: object, b0: object, b1: object) -> None:
    """|r + s d|² is least at s = -r·d/d², within 0 to 1."""
    before, now = np.array([a0, b0], dtype=float), np.array([a1, b1], dtype=float)
    r, d = before[0] - before[1], (now[0] - before[0]) - (now[1] - before[1])
    share = float(np.clip(-(r @ d) / (d @ d), 0.0, 1.0)) if d @ d > 0 else 0.0
    least_m, _, _ = pair(before, now)
    assert least_m == pytest.approx(float(np.linalg.norm(r + share * d)), abs=1e-9)


def test_a_curve_is_followed_to_the_millimetre() -> None:
    """Two fly towards each other, 5 m/s² each sideways and back: x(t) = ±(1/2) a t (T - t) from x = 0 at both ticks."""
    period_s, a_m_s2, apart_m = 0.1, 5.0, 0.05
    before = now = np.array([[0.0, 0.0, 0.0], [0.0, apart_m, 0.0]])
    v0 = np.array([[0.0, a_m_s2 * period_s / 2, 0.0], [0.0, -a_m_s2 * period_s / 2, 0.0]])
    found = np.empty((4, 4))
    least_m, _, _, share, _ = nearest_pair(
        before, now, v0, -v0, period_s, np.ones(2, dtype=bool), NO_PAIRS, 0.0, math.inf, found
    )
    assert least_m == pytest.approx(apart_m - 2 * a_m_s2 * period_s**2 / 8, abs=1e-4)
    assert share == pytest.approx(0.5, abs=0.05)


def test_curves_that_come_near_far_beside_their_chords_are_looked_at() -> None:
    """As above with T = 0.8 s: each is 0.4 m beside its chord half way, and their chords are 1.5 m apart."""
    period_s, a_m_s2 = 0.8, 5.0
    before = now = np.array([[0.0, 0.0, 0.0], [0.0, 1.5, 0.0]])
    v0 = np.array([[0.0, a_m_s2 * period_s / 2, 0.0], [0.0, -a_m_s2 * period_s / 2, 0.0]])
    found = np.empty((4, 4))
    ours = np.ones(2, dtype=bool)
    least_m, _, _, _, count = nearest_pair(before, now, v0, -v0, period_s, ours, NO_PAIRS, 1.0, 0.0, found)
    assert (least_m, count) == (pytest.approx(0.7, abs=2e-3), 1)


def test_partners_and_those_whom_nobody_of_ours_flies_are_left_out() -> None:
    before, now = np.array([[0.0, 0, 0], [0.3, 0, 0]]), np.array([[0.1, 0.0, 0], [0.2, 0, 0]])
    assert pair(before, now, exempt=[(1, 0)])[0] == math.inf
    assert pair(before, now, ours=(False, False))[0] == math.inf


@pytest.mark.parametrize(("moves", "counts"), [(0, True), (1, False)])
def test_beside_one_that_somebody_else_flies_only_closing_in_counts(moves: int, counts: bool) -> None:
    """0 is ours, 1 is not; one of them stands."""
    before = np.array([[0.0, 0, 0], [0.5, 0, 0]])
    now = before.copy()
    now[moves, 0] += 0.2 if moves == 0 else -0.2
    assert (pair(before, now, ours=(True, False), limit_m=0.6)[2] == 1) is counts


def test_every_pair_too_near_is_told_and_the_least_of_all_is_the_same_by_brute_force() -> None:
    rng = np.random.default_rng(3)
    before = rng.uniform(-4.0, 4.0, (40, 3))
    now = before + rng.uniform(-0.3, 0.3, (40, 3))
    gaps = []
    for i in range(40):
        for j in range(i):
            r, d = before[i] - before[j], (now[i] - before[i]) - (now[j] - before[j])
            gaps.append(float(np.linalg.norm(r + np.clip(-(r @ d) / (d @ d), 0, 1) * d)))
    found = np.empty((200, 4))
    least_m, _, _, _, count = nearest_pair(
        before, now, STRAIGHT, STRAIGHT, 0.1, np.ones(40, dtype=bool), NO_PAIRS, 1.0, math.inf, found
    )
    assert least_m == pytest.approx(min(gaps))
    assert count == sum(gap < 1.0 for gap in gaps) > 5
    assert sorted(found[:count, 2]) == pytest.approx(sorted(gap for gap in gaps if gap < 1.0))


def test_traffic_is_met_between_ticks() -> None:
    """A vehicle stands at 0.3 m beside the way of an aircraft that flies 20 m/s."""
    stands = np.array([[1.0, 0.3, 0.0]])
    others = np.array([[9.0, 9, 9], [0.0, 0, 0]]), np.array([[9.0, 9, 9], [2.0, 0, 0]])
    least, which, shares = nearest_to(stands, stands, STRAIGHT, STRAIGHT, *others, 0.1)
    assert (least[0], which[0], shares[0]) == pytest.approx((0.3, 1, 0.5))


def test_traffic_is_met_on_the_curve_of_a_vehicle() -> None:
    """s = 1/2 a t (T - t) towards an aircraft that stands 0.3 m away: it is nearest half way."""
    period_s, a_m_s2 = 0.4, 5.0
    stands, v = np.zeros((1, 3)), np.array([[a_m_s2 * period_s / 2, 0.0, 0.0]])
    other = np.array([[0.3, 0.0, 0.0]])
    least, _, shares = nearest_to(stands, stands, v, -v, other, other, period_s)
    assert (least[0], shares[0]) == pytest.approx((0.3 - a_m_s2 * period_s**2 / 8, 0.5), abs=0.03)
    assert least[0] == pytest.approx(0.2, abs=1e-3)


@pytest.mark.parametrize(
    ("shape", "least_m"),
    [(Obstacle(point_m=(1.0, 0.2, 0.0)), 0.2), (Obstacle(sphere_m=(1.0, 0.5, 0.0), radius_m=0.6), -0.1)],
)
def test_an_obstacle_is_passed_between_ticks(shape: Obstacle, least_m: float) -> None:
    """Places at both ticks are 1 m before and 1 m behind it."""
    last, ways = np.zeros((2, 1, 3)), np.empty((1, approach.WAY))
    watch = FleetWatch(last, of_scenario([shape]), ways, np.empty((4, 4)))
    every, none = np.ones(1, dtype=bool), np.empty((0, 2), dtype=np.int64)
    watch.look(np.array([[2.0, 0.0, 0.0]]), STRAIGHT, 0.1, every, every, none, 0.0, 0.0, 1.0, 1.0)
    assert (ways[0, approach.CLEAR_M], ways[0, approach.CLEAR_AT]) == pytest.approx((least_m, 0.5), abs=0.005)


def test_an_obstacle_is_passed_on_the_curve_between_ticks() -> None:
    """s = 1/2 a t (T - t) towards a point 0.2 m away, from 0 at both ticks, where its chord stays."""
    period_s, a_m_s2 = 0.2, 5.0
    last, ways = np.zeros((2, 1, 3)), np.empty((1, approach.WAY))
    last[1, 0, 1] = a_m_s2 * period_s / 2
    watch = FleetWatch(last, of_scenario([Obstacle(point_m=(0.0, 0.2, 0.0))]), ways, np.empty((4, 4)))
    every, none = np.ones(1, dtype=bool), np.empty((0, 2), dtype=np.int64)
    clearest = watch.look(np.zeros((1, 3)), -last[1], period_s, every, every, none, 0.0, 0.0, 0.18, 0.0)[-1]
    assert clearest == 0
    bulge_m = a_m_s2 * period_s**2 / 8
    found = ways[0, approach.CLEAR_M], ways[0, approach.CLEAR_AT], *ways[0, approach.CLEAR_PLACE :][:3]
    assert found == pytest.approx((0.2 - bulge_m, 0.5, 0.0, bulge_m, 0.0), abs=1e-3)


def cleared(shapes: Any, r0: Any, r1: Any, v0: Any, v1: Any, period_s: float) -> tuple[float, float]:
    """The least clearance on the cubic curve of one vehicle, looked at in 4000 places, and the share."""
    s = np.linspace(0.0, 1.0, 4001)[:, None]
    fall, rise = (1 + 2 * s) * (1 - s) ** 2, s**2 * (3 - 2 * s)
    way = fall * r0 + s * (1 - s) ** 2 * period_s * v0 + rise * r1 + s**2 * (s - 1) * period_s * v1
    each = clearance(shapes, way)
    return float(each.min()), float(s[each.argmin(), 0])


def test_a_look_at_a_fleet_takes_in_only_those_whose_place_is_known_then_and_now() -> None:
    """Tick by tick against numpy's choice of rows, nearest_pair and the curve in numpy: some land, some fall silent,
    one is not ours, of one no velocity is known. Those that were not known at the last look are where they are now."""
    rng, n, period_s = np.random.default_rng(7), 9, 0.1
    shapes = of_scenario([Obstacle(sphere_m=(0.0, 0.0, 0.0), radius_m=0.4), Obstacle(point_m=(1.0, 1.0, 0.0))])
    exempt, ours = np.array([[0, 1], [2, 8]]), np.arange(n) != 4
    last, ways_of_all = np.zeros((2, n, 3)), np.empty((n, approach.WAY))
    p_last, v_last, before = last[0], last[1], ways_of_all[:, :3]
    clear_m, clear_at = ways_of_all[:, approach.CLEAR_M], ways_of_all[:, approach.CLEAR_AT]
    p_last[:] = np.nan
    found, expected_found = np.empty((64, 4)), np.empty((64, 4))
    watch = FleetWatch(last, shapes, ways_of_all, found)
    near_in_all = too_near_in_all = 0
    for tick in range(60):
        p, v, flying = rng.uniform(-2.0, 2.0, (n, 3)), rng.uniform(-3.0, 3.0, (n, 3)), rng.random(n) < 0.8
        p[rng.random(n) < 0.2 * (tick % 3 > 0)] = np.nan
        v[3] = np.nan
        rows = np.flatnonzero(flying & ~np.isnan(p[:, 0]))
        was = np.where(np.isnan(p_last[rows]), p[rows], p_last[rows])
        known = ~(np.isnan(p_last[rows]).any(axis=1) | np.isnan(v_last[rows] + v[rows]).any(axis=1))[:, None]
        chord = (p[rows] - was) / period_s
        places = {row: k for k, row in enumerate(rows.tolist())}
        pairs = [(places[a], places[b]) for a, b in exempt.tolist() if a in places and b in places]
        ways = (was, p[rows], np.where(known, v_last[rows], chord), np.where(known, v[rows], chord))
        least, one, other, share, near = nearest_pair(
            *ways, period_s, ours[rows], np.array(pairs, dtype=np.int64).reshape(-1, 2), 0.8, math.inf, expected_found
        )
        own = ours[rows]
        expected = np.array([cleared(shapes, *(one[k] for one in ways), period_s) for k in np.flatnonzero(own)])
        expected_m, expected_at = expected.reshape(-1, 2).T
        known = np.where(np.isin(np.arange(n), rows)[:, None], p, np.nan)
        count, *told, clearest = watch.look(p, v, period_s, flying, ours, exempt, 0.8, math.inf, 0.5, 0.3)
        clear = expected_m < 0.5
        assert clearest == (rows[own][expected_m.argmin()] if clear.any() else -1)
        found_m, found_at = clear_m[rows[own]], clear_at[rows[own]]
        assert found_m[clear] == pytest.approx(expected_m[clear], abs=1e-3)
        flown = clear & (p[rows][own] != was[own]).any(axis=1)
        assert found_at[flown] == pytest.approx(expected_at[flown], abs=0.02)
        assert (found_m[~clear] >= 0.5).all()
        too_near_in_all += int(clear.any())
        assert count == len(rows)
        assert told == [least, *((rows[one], rows[other]) if one >= 0 else (-1, -1)), share, near]
        told_rows = found[:near, :2].astype(int)
        assert told_rows.tolist() == rows[expected_found[:near, :2].astype(int)].tolist()
        assert found[:near, 2:].tolist() == expected_found[:near, 2:].tolist()
        assert np.isinf(np.delete(clear_m, rows[own])).all()
        assert before[rows].tolist() == was.tolist()
        np.testing.assert_array_equal(v_last, v)
        np.testing.assert_array_equal(p_last, known)
        near_in_all += near
    assert near_in_all > 50
    assert 0 < too_near_in_all < 60


def test_way_points_are_passed_in_their_order_on_the_straight_way_from_tick_to_tick() -> None:
    rng, within_m = np.random.default_rng(3), 0.5
    ways = [rng.uniform(-1.5, 1.5, (count, 3)) for count in (5, 0, 60, 1)]
    end = np.cumsum([len(way) for way in ways])
    ahead = end - [len(way) for way in ways]
    points, last, left = np.concatenate(ways), np.full((4, 3), np.nan), [way.tolist() for way in ways]
    before: list[Any] = [None] * 4
    for _ in range(400):
        p = rng.uniform(-1.5, 1.5, (4, 3))
        p[rng.random(4) < 0.1] = np.nan
        some_left = approach.pass_points(p, last, np.zeros(4, np.uint8), points, ahead, end, within_m**2)
        for row, place in enumerate(p):
            known = not np.isnan(place[0])
            begin = place if before[row] is None else before[row]
            shares = np.linspace(0.0, 1.0, 2001)[:, None]
            on_way = begin + shares * (place - begin)
            while known and left[row] and np.linalg.norm(on_way - left[row][0], axis=1).min() <= within_m:
                left[row].pop(0)
            before[row] = place if known else None
        assert (end - ahead).tolist() == [len(way) for way in left]
        assert some_left == sum(map(bool, left))
    assert [len(left[row]) for row in (0, 1, 3)] == [0, 0, 0]
    assert len(left[2]) < 60
