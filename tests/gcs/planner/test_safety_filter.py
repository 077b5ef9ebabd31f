# ruff: noqa: E501
"""Tests of the safety filter. The oracle below follows ways densely in numpy and shares no code with the kernels."""

import math

import leaders
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from skytender import geometry as shapes
from skytender.safety.braking_clearance import stop_way
from skytender.safety.safety_constraints import OBSTACLE, OTHER, PAIR, PLANE, clearances
from skytender.safety.safety_filter import KINDS, FilterSettings, Leaders, Others, filter_step

DT, SUB = 0.1, 8
RULES = FilterSettings()
POOR = FilterSettings(rounds=1, sweeps=1, buffer_m=0.0)
"""A projection so poor that the check is what keeps the invariant."""
A = 5.0
MARGIN = 0.1
D = RULES.separation_m + 2 * MARGIN
CLEAR = RULES.clearance_m + MARGIN
FLOOR = -0.3
seeds = st.integers(0, 2**32 - 1)
fixed = settings(derandomize=True, deadline=None, max_examples=60, database=None)


def brake(v, b, dt=DT):
    speed = np.linalg.norm(v, axis=-1, keepdims=True)
    return np.where(speed <= b * dt, -v / dt, -b * v / np.maximum(speed, 1e-300))


def way(p, v, u, b, periods):
    """Dense samples (time, n, 3) of one period with u and then braking; b (n, 1)."""
    rows = []
    for _ in range(periods):
        s = np.linspace(0, DT, SUB + 1)[:, None, None]
        rows.append(p + s * v + 0.5 * s * s * u)
        p, v = p + DT * v + 0.5 * DT * DT * u, v + DT * u
        u = brake(v, b)
    return np.concatenate(rows)


def least(rows, table=None):
    """Least distance of each pair (n, n) and to any shape (n,) over samples."""
    n = rows.shape[1]
    apart = np.linalg.norm(rows[:, :, None] - rows[:, None], axis=3).min(axis=0) + 1e9 * np.eye(n)
    if table is None or not len(table):
        return apart, np.full(n, np.inf)
    return apart, shapes.clearance(table, rows.reshape(-1, 3)).reshape(-1, n).min(axis=0)


def world(rng, m=4):
    rows = []
    for k in range(m):
        at = rng.uniform((-4, -4, -5), (4, 4, -1))
        rows.append([shapes.sphere(at, rng.uniform(0.1, 0.8)), shapes.box(at, at + rng.uniform(0.2, 2, 3)),
                     shapes.cylinder(at, rng.uniform(0.1, 0.6), rng.uniform(0.5, 3)), shapes.point(at)][k % 4])  # fmt: skip
    return shapes.table(rows)


def safe_state(rng, n, table, speed=5.0, b=0.8 * A, d=D):
    """A random state whose braking keeps everything: velocities are halved until it does."""
    p = []
    size = 1.0 + n ** (1 / 3)
    while len(p) < n:
        q = rng.uniform((-size, -size, -size - 1), (size, size, FLOOR - 0.05))
        if all(np.linalg.norm(q - o) > d + 0.02 for o in p) and (
            not len(table) or shapes.clearance(table, q)[0] > CLEAR + 0.02
        ):
            p.append(q)
        elif rng.random() < 0.02:
            size *= 1.1
    p = np.array(p)
    v = rng.normal(size=(n, 3))
    v *= speed * rng.uniform(0, 1, (n, 1)) / np.linalg.norm(v, axis=1, keepdims=True)
    for _ in range(40):
        rows = way(p, v, brake(v, b), np.full((n, 1), b), 18)
        apart, clear = least(rows, table)
        bad = (apart < d + 0.01).any(axis=1) | (clear < CLEAR + 0.01) | (rows[:, :, 2].max(axis=0) > FLOOR)
        if not bad.any():
            return p, v
        v[bad] *= 0.5
        if _ > 20:
            v[bad] = 0.0
    return p, np.zeros_like(v)


def nasty(rng, p, speed):
    """Wishes that press everyone together, change at once, or are far beyond every limit."""
    kind = rng.integers(4)
    if kind == 0:
        return rng.normal(size=p.shape) * speed
    if kind == 1:
        return (
            speed * (p.mean(axis=0) - p) / np.maximum(np.linalg.norm(p.mean(axis=0) - p, axis=1, keepdims=True), 1e-9)
        )
    if kind == 2:
        return rng.normal(size=p.shape) * 1e3
    return np.roll(p, 1, axis=0) - p + np.array([0, 0, speed])


@fixed
@given(seeds, st.sampled_from([RULES, POOR]))
def test_what_starts_apart_stays_apart_whatever_is_wished(seed, rules):
    rng = np.random.default_rng(seed)
    n, table = int(rng.integers(2, 9)), world(rng)
    p, v = safe_state(rng, n, table)
    fleet = {"ids": rng.permutation(n) + 1, "v_max_m_s": rng.uniform(3, 6, n), "a_max_m_s2": A, "margin_m": MARGIN}
    for k in range(40):
        if k % 7 == 0:
            wish = nasty(rng, p, 5.0)
        out = filter_step(
            Leaders(p_ned=p, v_ned=v, high_ned=(9, 9, FLOOR + MARGIN), **fleet), wish, rules=rules, obstacles=table
        )
        apart, clear = least(way(p, v, out.u_ned, np.full((n, 1), 0.8 * A), 1), table)
        assert apart.min() >= D - 1e-6
        assert clear.min() >= CLEAR - 1e-6
        assert np.linalg.norm(out.u_ned, axis=1).max() <= A + 1e-9
        assert ((out.changed_m_s2 > 0) == (out.binding_kind > 0)).all()
        p, v = out.p_next_ned, out.v_next_ned
        assert p[:, 2].max() <= FLOOR + 1e-6
    assert (np.linalg.norm(v, axis=1) <= fleet["v_max_m_s"] + 1e-9).all()


@fixed
@given(seeds, st.sampled_from([RULES, POOR]))
def test_from_any_state_braking_clearance_is_at_least_what_braking_keeps(seed, rules):
    """The equation (2) of the module, also where distances are broken already, with unlike vehicles and others."""
    rng = np.random.default_rng(seed)
    n, table, m = int(rng.integers(2, 8)), world(rng, 3), int(rng.integers(0, 3))
    p, v = rng.uniform((-2, -2, -4), (2, 2, -1), (n, 3)), rng.normal(size=(n, 3)) * 2
    a, margin = rng.uniform(2, 8, n), rng.uniform(0, 0.3, n)
    b = 0.8 * a[:, None]
    other = np.hstack([rng.uniform(-3, 3, (m, 3)), rng.normal(size=(m, 3)) * 3])
    radius = rng.uniform(0.3, 1.0, m)
    out = filter_step(
        Leaders(np.arange(n), p, v, 6.0, a, margin), nasty(rng, p, 5.0), rules=rules, obstacles=table,
        others=Others(other[:, :3], other[:, 3:], radius),
    )  # fmt: skip
    periods = 60
    chosen, braked = way(p, v, out.u_ned, b, periods), way(p, v, brake(v, b), b, periods)
    required = RULES.separation_m + margin[:, None] + margin[None]
    for (got, clear), (kept, kept_clear) in [(least(chosen, table), least(braked, table))]:
        # Bounds are a little below true distances, so both sides may differ by what a period of braking bends.
        slack = 0.125 * DT * DT * 2 * 8 + 5e-3
        assert (got >= np.minimum(required, kept) - slack).all()
        assert (clear >= np.minimum(RULES.clearance_m + margin, kept_clear) - slack).all()
    upto = int(RULES.horizon_s / DT) * (SUB + 1)
    t = np.concatenate([k * DT + np.linspace(0, DT, SUB + 1) for k in range(periods)])[:upto, None]
    for k in range(m):
        at = other[k, :3] + t * other[k, 3:]
        got = np.linalg.norm(chosen[:upto] - at[:, None], axis=2).min(axis=0)
        kept = np.linalg.norm(braked[:upto] - at[:, None], axis=2).min(axis=0)
        assert (got >= np.minimum(radius[k] + margin, kept) - slack).all()


@fixed
@given(seeds)
def test_braking_never_lowers_what_the_kernels_say_of_it(seed):
    """(1) of braking_clearance.py for the bounds themselves, on which the guarantee rests: pairs, shapes, walls, others."""
    rng = np.random.default_rng(seed)
    p, v, b = rng.uniform(-2, 2, (2, 3)), rng.normal(size=(2, 3)) * 3, rng.uniform(2, 6, 2)
    table, other = world(rng), np.concatenate([rng.uniform(-2, 2, 3), np.zeros(3), [0.5, 0.0, 0.0]])[None]
    fence = np.full((2, 6), -3.0)
    rows = np.array(
        [(PAIR, 0, 1), (PLANE, 0, 1), *((OBSTACLE, 0, k) for k in range(len(table))), (OTHER, 1, 0)], dtype=np.int64
    )
    last = np.full(len(rows), -math.inf)
    for _ in range(30):
        u = brake(v, b[:, None])
        found = clearances(rows, 99.0, p, v, u, b, other, table, fence, DT, RULES.horizon_s)
        now = found[:, :2].min(axis=1)
        assert (now >= last - 1e-9).all()
        last, p, v = now, p + DT * v + 0.5 * DT * DT * u, v + DT * u


@fixed
@given(seeds)
def test_one_period_of_braking_leads_along_the_same_way(seed):
    rng = np.random.default_rng(seed)
    v, b = rng.normal(size=(1, 3)) * rng.choice([0.01, 1.0, 5.0]), np.array([[rng.uniform(1, 8)]])
    periods = math.ceil(float(np.linalg.norm(v)) / (b[0, 0] * DT)) + 2
    whole = way(np.zeros((1, 3)), v, brake(v, b), b, periods)
    u = brake(v, b)
    tail = way(DT * v + 0.5 * DT * DT * u, v + DT * u, brake(v + DT * u, b), b, periods - 1)
    assert np.abs(whole[SUB + 1 :] - tail).max() < 1e-12
    assert np.linalg.norm(whole[-1]) == pytest.approx(stop_way(float(np.linalg.norm(v)), float(b[0, 0]), DT), abs=1e-9)


@fixed
@given(seeds)
def test_who_hovers_lets_traffic_pass(seed):
    """Traffic flies straight on at up to 8 m/s, from beyond the horizon; 1 m is kept, margin included."""
    rng = np.random.default_rng(seed)
    p, v = np.array([[0.0, 0.0, -5.0]]), np.zeros((1, 3))
    w = rng.normal(size=3) * (1, 1, 0.2)
    w *= rng.uniform(0.5, 8) / np.linalg.norm(w)
    q = p[0] + rng.normal(size=3) * 0.4 - w * (RULES.horizon_s + 1)
    nearest = math.inf
    for _ in range(80):
        out = filter_step(
            Leaders([7], p, v, 3.0, A, MARGIN), 2 * ([0, 0, -5.0] - p), rules=RULES, others=Others([q], [w], 0.9)
        )
        for s in np.linspace(0, DT, 11):
            nearest = min(nearest, float(np.linalg.norm(p + s * v + 0.5 * s * s * out.u_ned - q - s * w)))
        p, v, q = out.p_next_ned, out.v_next_ned, q + DT * w
    assert nearest > 1.0 - 1e-6


@pytest.mark.parametrize("speed", [1.5, 2.5, 4.0, 5.0])
@pytest.mark.parametrize("scene", [lambda s: leaders.circle(8, s), lambda s: leaders.circle(16, s), lambda s: leaders.circle(24, s),
                                   lambda s: leaders.rows(6, s), lambda s: leaders.rows(1, s), lambda s: leaders.circle(2, s)])  # fmt: skip
def test_circles_and_rows_arrive_and_keep_their_distance(scene, speed):
    made = scene(speed)
    outcome = leaders.fly(made, RULES)
    assert outcome.least_m >= D - 1e-6
    assert outcome.stuck == 0
    assert outcome.time_s < 2 + 1.8 * np.linalg.norm(made.goal - made.start, axis=1).max() / speed + speed / 2.5


def test_head_on_straight_up_and_down_passes():
    start = np.array([[0, 0, -3.0], [0, 0, -9.0]])
    outcome = leaders.fly(leaders.Scene("up and down", start, start[::-1].copy(), 3.0), RULES)
    assert outcome.stuck == 0
    assert outcome.least_m >= D - 1e-6


def test_partners_of_a_transfer_may_be_near_but_not_nearer_than_theirs():
    p, v = np.array([[0, 0, -5.0], [3.0, 0, -5.0], [0, 3.0, -5]]), np.zeros((3, 3))
    for _ in range(80):
        wish = 2 * (np.array([0, 0, -5.0]) - p)
        out = filter_step(
            Leaders([5, 2, 9], p, v, 2.0, A, MARGIN), wish, rules=RULES, pair_required_m=[(2, 5, 0.3), (2, 77, 1.0)]
        )
        p, v = out.p_next_ned, out.v_next_ned
        assert np.linalg.norm(p[0] - p[1]) >= 0.3 - 1e-6
        assert min(np.linalg.norm(p[2] - p[0]), np.linalg.norm(p[2] - p[1])) >= D - 1e-6
    assert np.linalg.norm(p[0] - p[1]) < 0.4


def fleet(n=30, seed=3):
    rng = np.random.default_rng(seed)
    p, v = safe_state(rng, n, world(rng), 3.0)
    return (
        rng,
        Leaders(rng.permutation(n) + 10, p, v, 4.0, A, rng.uniform(0, 0.2, n)),
        nasty(rng, p, 4.0),
        world(rng),
    )


@pytest.mark.parametrize("n", [30, 60])
def test_equal_inputs_give_equal_bits(n):
    _, vehicles, wish, table = fleet(n)
    once, again = (
        filter_step(vehicles, wish, rules=RULES, obstacles=table, others=Others([[0, 0, 0]], [[1, 1, 0]], 1.0))
        for _ in range(2)
    )
    for name in ("u_ned", "p_next_ned", "v_next_ned", "changed_m_s2", "binding", "binding_kind", "checked"):
        assert getattr(once, name).tobytes() == getattr(again, name).tobytes()


@pytest.mark.parametrize("n", [30, 60])
def test_the_order_of_vehicles_does_not_matter_to_the_bit(n):
    rng, vehicles, wish, table = fleet(n)
    k = rng.permutation(n)
    mixed = Leaders(vehicles.ids[k], vehicles.p_ned[k], vehicles.v_ned[k], 4.0, A, vehicles.margin_m[k])
    once = filter_step(vehicles, wish, rules=RULES, obstacles=table)
    again = filter_step(mixed, wish[k], rules=RULES, obstacles=table)
    assert (once.changed_m_s2 > 0).any()
    assert once.u_ned[k].tobytes() == again.u_ned.tobytes()
    pairs = again.binding_kind == KINDS.index("vehicle")
    assert np.array_equal(once.binding_kind[k], again.binding_kind)
    assert np.array_equal(once.binding[k][pairs], k[again.binding[pairs]])


@fixed
@given(seeds)
def test_with_nothing_near_the_wish_is_flown_within_limits(seed):
    rng = np.random.default_rng(seed)
    p = np.stack([np.arange(5) * 30.0, np.zeros(5), np.full(5, -20.0)], 1)
    v = rng.normal(size=(5, 3))
    wish = v + rng.normal(size=(5, 3)) * 0.1
    out = filter_step(Leaders(np.arange(5), p, v, 9.0, A, 0.1, high_ned=(np.inf, np.inf, 0)), wish, rules=RULES)
    assert np.allclose(out.v_next_ned, wish, atol=1e-12)
    assert not out.changed_m_s2.any()
    assert (out.binding == -1).all()
    assert not out.binding_kind.any()
    far = filter_step(Leaders(np.arange(5), p, v, 9.0, A, 0.1), wish * 100, rules=RULES)
    assert np.linalg.norm(far.u_ned, axis=1).max() <= A + 1e-9
    assert not far.changed_m_s2.any()


@pytest.mark.parametrize("moving", [0.0, 3.0])
def test_a_formation_at_exactly_its_distance_is_left_in_peace(moving):
    p = np.array([[x * D, y * D, -5.0] for x in range(4) for y in range(4)])
    v = np.tile([moving, 0.0, 0.0], (16, 1))
    for _ in range(50):
        out = filter_step(Leaders(np.arange(16), p, v, 5.0, A, MARGIN), v, rules=RULES)
        assert np.abs(out.u_ned).max() < 1e-6
        assert not out.checked.any()
        p, v = out.p_next_ned, out.v_next_ned


def test_slots_nearer_than_allowed_come_to_rest_without_chatter():
    goal = np.array([[x * 0.6, 0.0, -5.0] for x in range(5)])
    p, v, last = goal * (2, 1, 1), np.zeros((5, 3)), []
    for _ in range(300):
        out = filter_step(Leaders(np.arange(5), p, v, 2.0, A, MARGIN), 1.5 * (goal - p), rules=RULES)
        p, v = out.p_next_ned, out.v_next_ned
        last.append(np.linalg.norm(out.u_ned, axis=1).max())
    assert max(last[-50:]) < 0.1
    assert least(p[None])[0].min() >= D - 1e-6


@pytest.mark.parametrize("n", [2, 3, 8])
@pytest.mark.parametrize("spread", [0.0, 1e-13, 1e-6, 0.3])
def test_what_is_too_near_parts(n, spread):
    rng = np.random.default_rng(n)
    p, v = np.tile([1.0, 2.0, -6.0], (n, 1)) + spread * rng.normal(size=(n, 3)), np.zeros((n, 3))
    if spread == 0.3:
        v = rng.normal(size=(n, 3))
    for _ in range(60):
        out = filter_step(Leaders(np.arange(n), p, v, 3.0, A, MARGIN), np.zeros((n, 3)), rules=RULES)
        assert np.isfinite(out.u_ned).all()
        p, v = out.p_next_ned, out.v_next_ned
    assert least(p[None])[0].min() >= D - 1e-6


def test_inside_obstacles_under_the_floor_and_at_centres_it_comes_out():
    table = shapes.table(
        [
            shapes.box((-1, -1, -3), (1, 1, -1)),
            shapes.sphere((5, 0, -2), 0.7),
            shapes.cylinder((9, 0, -2), 0.5, 2),
            shapes.point((13, 0, -2)),
        ]
    )
    p, v = np.array([[0, 0, -2.0], [5, 0, -2], [9, 0, -2], [13, 0, -2], [17, 0, 0.5]]), np.zeros((5, 3))
    for _ in range(60):
        out = filter_step(Leaders(np.arange(5), p, v, 3.0, A, MARGIN, high_ned=(np.inf, np.inf, FLOOR + MARGIN)), np.zeros((5, 3)), rules=RULES, obstacles=table,
                          others=Others([[5, 0, -2.0]], [[0, 0, 0]], 0.3))  # fmt: skip
        assert np.isfinite(out.u_ned).all()
        p, v = out.p_next_ned, out.v_next_ned
    assert shapes.clearance(table, p).min() >= CLEAR - 1e-6
    assert p[:, 2].max() <= FLOOR + 1e-6


def test_the_fence_holds_and_names_its_side():
    p, v = np.array([[0, 0, -5.0]]), np.array([[4.0, 0, 0]])
    for _ in range(200):
        out = filter_step(Leaders([1], p, v, 5.0, A, 0.0, (-3, -3, -9), (3, 3, -1)), [[5, 1, -1]], rules=RULES)
        p, v = out.p_next_ned, out.v_next_ned
        assert (p <= np.array([3, 3, -1]) + 1e-9).all()
        assert (p >= np.array([-3, -3, -9]) - 1e-9).all()
    assert np.abs(v).max() < 1e-3
    assert KINDS[out.binding_kind[0]] == "wall"


def test_a_growing_silence_takes_more_room():
    def room(growth):
        p, v = np.array([[0, 0, -5.0]]), np.zeros((1, 3))
        for k in range(40):
            out = filter_step(Leaders([1], p, v, 3.0, A, MARGIN), [[2.0, 0, 0]], rules=RULES,
                              others=Others([[5.0, 0, -5]], [[0, 0, 0]], 0.8 + growth * k * DT, growth))  # fmt: skip
            p, v = out.p_next_ned, out.v_next_ned
        return 5.0 - p[0, 0]

    assert room(0.2) > room(0.0) + 0.2


def test_nobody_gives_way_to_what_no_distance_is_wanted_of():
    """A leader flies through the presumed place of its own silent vehicle as if nothing were there; others brake."""
    p, v, wish = np.array([[-1.5, 0, -5.0]]), np.array([[2.0, 0, 0]]), [[2.0, 0, 0]]
    place = Others([[0.5, 0, -5.0]], [[0, 0, 0]], 0.8, 0.5)
    own = filter_step(
        Leaders([1], p, v, 3.0, A, MARGIN), wish, rules=RULES, others=place, other_required_m=[(1, 0, 0.0)]
    )
    free = filter_step(Leaders([1], p, v, 3.0, A, MARGIN), wish, rules=RULES)
    assert (own.v_next_ned == free.v_next_ned).all()
    assert own.changed_m_s2[0] == 0.0
    other = filter_step(
        Leaders([2], p, v, 3.0, A, MARGIN), wish, rules=RULES, others=place, other_required_m=[(1, 0, 0.0)]
    )
    assert other.changed_m_s2[0] > 1.0


def test_empty_fleets_and_wrong_arguments():
    empty = filter_step(Leaders([], np.zeros((0, 3)), np.zeros((0, 3)), 1.0, 1.0), np.zeros((0, 3)), rules=RULES)
    assert empty.u_ned.shape == (0, 3)
    good = {"ids": [1, 2], "p_ned": np.zeros((2, 3)), "v_ned": np.zeros((2, 3)), "v_max_m_s": 1.0, "a_max_m_s2": 1.0}
    for bad, words in (
        ({"ids": [1, 1]}, "ids"), ({"p_ned": np.zeros((3, 3))}, r"p_ned has shape"), ({"v_ned": [[0, 0, math.nan]] * 2}, "v_ned holds a value"),
        ({"v_max_m_s": 0.0}, "v_max_m_s holds"), ({"a_max_m_s2": [1, -1]}, "a_max_m_s2 holds"), ({"margin_m": -0.1}, "margin_m"), ({"low_ned": math.nan}, "low_ned"),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=words):
            filter_step(Leaders(**(good | bad)), np.zeros((2, 3)), rules=RULES)
    with pytest.raises(ValueError, match="v_wanted_ned"):
        filter_step(Leaders(**good), np.zeros((1, 3)), rules=RULES)
    with pytest.raises(ValueError, match="brake_share"):
        FilterSettings(brake_share=1.5)


def test_leaders_that_need_not_keep_apart_share_a_place_and_still_heed_obstacles():
    p = np.array([[0.0, 0.0, -5.0]] * 3)
    v_wanted = np.array([[1.0, 0, 0], [1.0, 0, 0], [0, 1.0, 0]])
    together = Leaders([1, 2, 3], p, np.zeros((3, 3)), 2.0, A, MARGIN)
    alone = filter_step(together, v_wanted, rules=RULES, apart=False)
    assert np.array_equal(alone.changed_m_s2, np.zeros(3))
    assert filter_step(together, v_wanted, rules=RULES).changed_m_s2.max() > 0.0
    ball = shapes.table([shapes.sphere((0.5, 0.0, -5.0), 0.15)])
    assert (
        filter_step(together, v_wanted, rules=RULES, apart=False, obstacles=ball).binding_kind.tolist()[:2]
        == [KINDS.index("obstacle")] * 2
    )


@pytest.mark.parametrize(("one_m", "other_m", "apart_m"), [(0.0, 0.0, D), (0.3, 0.4, D + 0.5), (0.5, 0.0, D + 0.5)])
def test_what_two_do_not_know_of_their_places_keeps_them_apart_by_the_root_of_its_squares(one_m, other_m, apart_m):
    """Pressed together for 10 s they come to rest at the separation, both margins and that, and a buffer."""
    p, v = np.array([[0.0, -4.0, -5.0], [0.0, 4.0, -5.0]]), np.zeros((2, 3))
    nearest = math.inf
    for _ in range(100):
        out = filter_step(
            Leaders([1, 2], p, v, 1.5, A, MARGIN, spread_m=[one_m, other_m]), np.sign(-p) * [0.0, 1.5, 0.0], rules=RULES
        )
        p, v = out.p_next_ned, out.v_next_ned
        nearest = min(nearest, float(np.linalg.norm(p[0] - p[1])))
    assert apart_m - 1e-6 <= nearest <= apart_m + 0.5


def test_what_a_vehicle_does_not_know_of_its_place_keeps_it_from_obstacles_traffic_and_ground():
    """Each is pressed against one of them."""
    p = np.array([[0.0, 0.0, -5.0], [20.0, 0.0, -5.0], [40.0, 0.0, -5.0]])
    wall, spread_m = shapes.table([shapes.box((3.0, -9.0, -20.0), (4.0, 9.0, 0.0))]), 0.7
    traffic = Others(p_ned=[[23.0, 0.0, -5.0]], v_ned=[[0.0, 0.0, 0.0]], radius_m=[1.0])
    v, wanted = np.zeros((3, 3)), np.array([[1.5, 0.0, 0.0], [1.5, 0.0, 0.0], [0.0, 0.0, 1.5]])
    least_m = np.full(3, np.inf)
    for _ in range(100):
        out = filter_step(
            Leaders([1, 2, 3], p, v, 1.5, A, MARGIN, high_ned=(np.inf, np.inf, FLOOR), spread_m=spread_m), wanted,
            rules=RULES, obstacles=wall, others=traffic,
        )  # fmt: skip
        p, v = out.p_next_ned, out.v_next_ned
        gaps = (shapes.clearance(wall, p[:1])[0], np.linalg.norm(p[1] - [23.0, 0.0, -5.0]), FLOOR - p[2, 2])
        least_m = np.minimum(least_m, gaps)
    wanted_m = np.array([CLEAR, 1.0 + MARGIN, MARGIN]) + spread_m
    assert (least_m >= wanted_m - 1e-6).all(), least_m - wanted_m
    assert least_m[0] <= wanted_m[0] + 0.3
    assert least_m[2] <= wanted_m[2] + 0.3


@pytest.mark.parametrize("spread_m", [-0.1, math.nan, math.inf])
def test_a_spread_that_is_none_is_refused(spread_m):
    with pytest.raises(ValueError, match="spread_m holds"):
        filter_step(
            Leaders([1], np.zeros((1, 3)), np.zeros((1, 3)), 1.5, A, 0.1, spread_m=spread_m),
            np.zeros((1, 3)),
            rules=RULES,
        )
