"""Truth: an adaptive solver, the limit, the invariant ratio, and hand-made shares."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from skytender import winner_take_all

EXTREMES = [(p, n) for p in (1.1, 2.0, 10.0) for n in (1, 2, 1000)]


def draw(n: int, seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    return rng.uniform(0.01, 1, n), rng.uniform(0.01, 1, n)


@pytest.mark.parametrize("p", [1.1, 1.5, 2.0, 2.5, 5.0, 10.0])
@pytest.mark.parametrize("rate", [1.0, 5.0])
def test_it_agrees_with_an_adaptive_solver(p: float, rate: float) -> None:
    v, tau = draw(15)
    solved = solve_ivp(
        lambda _, x: rate * (tau - (x**p).sum()) * x, (0, 7), v, method="DOP853", rtol=1e-10, atol=1e-14
    ).y[:, -1]
    assert winner_take_all.advance(v, tau, 7.0, p=p, rate=rate) == pytest.approx(solved, rel=1e-7, abs=1e-10)


@pytest.mark.parametrize(("p", "n"), EXTREMES)
def test_the_winner_settles_at_tau_to_the_1_over_p(p: float, n: int) -> None:
    v, tau = draw(n, seed=n)
    settled = winner_take_all.advance(v, tau, 1e6, p=p, rate=5.0)
    winner = int(tau.argmax())
    assert settled[winner] == pytest.approx(tau[winner] ** (1 / p), rel=1e-12)
    assert np.delete(settled, winner) == pytest.approx(np.zeros(n - 1), abs=1e-12)


@pytest.mark.parametrize("p", [1.1, 2.0, 10.0])
def test_the_ratio_of_two_grows_at_the_gap_of_their_taus_whatever_p(p: float) -> None:
    v, tau = draw(8)
    for t in (0.001, 1.0, 20.0):
        after = winner_take_all.advance(v, tau, t, p=p, rate=2.0)
        ratio = np.log(after / after[0]) - np.log(v / v[0])
        assert ratio == pytest.approx(2.0 * (tau - tau[0]) * t, abs=1e-11)


def test_two_half_steps_are_one_step() -> None:
    v, tau = draw(40)
    half = winner_take_all.advance(v, tau, 1.5, p=2, rate=5)
    assert winner_take_all.advance(half, tau, 1.5, p=2, rate=5) == pytest.approx(
        winner_take_all.advance(v, tau, 3.0, p=2, rate=5), rel=1e-12
    )


@pytest.mark.parametrize(("p", "n"), EXTREMES)
def test_extremes_stay_finite_and_bounded(p: float, n: int) -> None:
    _, tau = draw(n)
    for smallest, dt_s in itertools.product((1e-300, 1e-3, 1.0, 1e3), (0.0, 1e-300, 1e-9, 0.1, 1e3, 1e6)):
        with np.errstate(over="raise", invalid="raise"):
            after = winner_take_all.advance(np.full(n, smallest), tau, dt_s, p=p, rate=1.0)
        assert np.isfinite(after).all(), (smallest, dt_s)
        assert (after >= 0).all(), (smallest, dt_s)
        assert after.max() <= max(1.0, smallest) * (1 + 1e-9), (smallest, dt_s)


@settings(max_examples=300)
@given(
    st.floats(1.1, 10.0),
    st.one_of(st.integers(1, 12), st.just(1000)),
    st.floats(-300.0, 0.0),
    st.floats(-9.0, 6.0),
    st.integers(0, 2**32 - 1),
)
def test_any_competition_stays_finite_ordered_and_bounded(
    p: float, n: int, lg_v: float, lg_t: float, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    v, tau = 10.0 ** rng.uniform(lg_v, 0.0, n), rng.uniform(0.01, 1.0, n)
    with np.errstate(over="raise", invalid="raise", divide="raise"):
        after = winner_take_all.advance(v, tau, 10.0**lg_t, p=p, rate=1.0)
    assert np.isfinite(after).all()
    assert (after >= 0).all()
    # Σ w_j stays below the larger of its start and the largest τ, where its growth turns negative.
    assert (after**p).sum() <= max((v**p).sum(), tau.max()) * (1 + 1e-9)
    # v_i/v_j = const · e^(c (τ_i - τ_j) t), where neither has left what floats hold
    kept = np.flatnonzero(after > 1e-290)
    gain = np.log(after[kept] / v[kept])
    size = 1.0 + abs(10.0**lg_t) + abs(lg_v)
    assert gain - gain[0] == pytest.approx((tau[kept] - tau[kept[0]]) * 10.0**lg_t, abs=1e-11 * size)


def test_from_the_smallest_floats_it_grows_as_the_linear_law_says() -> None:
    after = winner_take_all.advance([1e-300, 2e-300], [1.0, 0.5], 100.0, p=2, rate=1.0)
    assert after == pytest.approx([1e-300 * math.exp(100), 2e-300 * math.exp(50)], rel=1e-10)


def test_zero_never_moves_and_does_not_disturb_the_others() -> None:
    v, tau = draw(5)
    with_zero = winner_take_all.advance([*v, 0.0], [*tau, 1.0], 3.0, p=2, rate=5)
    assert with_zero[-1] == 0
    assert with_zero[:-1] == pytest.approx(winner_take_all.advance(v, tau, 3.0, p=2, rate=5), rel=1e-14)
    assert (winner_take_all.advance([0.0, 0.0], [1.0, 0.5], 3.0, p=2, rate=5) == 0).all()


def test_nobody_competes_without_trouble() -> None:
    assert winner_take_all.advance([], [], 1.0, p=2, rate=5).shape == (0,)
    assert winner_take_all.normalise([], low=0.01, high=1).shape == (0,)
    assert winner_take_all.share([], 2, 0.01) == 0


def test_a_revived_loser_wins_later_as_soon_as_published() -> None:
    # docs/model/competition.md#exact-solution: 14 s at l = 0.01, a gap of 0.4, c = 1, p = 2, until 0.9 of the sum is
    # the newcomer's.
    v, tau = np.array([0.01, 0.6**0.5]), np.array([1.0, 0.6])
    after = [winner_take_all.advance(v, tau, t, p=2, rate=1.0) for t in np.arange(0, 20, 0.1)]
    first = next(k for k, x in enumerate(after) if x[0] ** 2 >= 0.9 * (x**2).sum())
    assert first * 0.1 == pytest.approx(14, abs=0.5)


def test_normalise_is_min_max_either_way() -> None:
    assert winner_take_all.normalise([2, 4, 3], low=0.01, high=1) == pytest.approx([0.01, 1, 0.505])
    assert winner_take_all.normalise([2, 4, 3], low=0.01, high=1, largest_wins=False) == pytest.approx([1, 0.01, 0.505])


def test_normalise_reaches_its_ends_exactly() -> None:
    tau = winner_take_all.normalise(np.random.default_rng(4).normal(3e5, 1e4, 50), low=0.01, high=1)
    assert (tau.min(), tau.max()) == (0.01, 1.0)


def test_among_equals_the_first_is_first() -> None:
    assert list(winner_take_all.normalise([7, 7, 7], low=0.01, high=1)) == [1, 0.01, 0.01]
    assert list(winner_take_all.normalise([7], low=0.01, high=1, largest_wins=False)) == [1]


def test_revive_lifts_to_the_floor_only() -> None:
    assert list(winner_take_all.revive([0, 0.005, 0.5], 0.01)) == [0.01, 0.01, 0.5]


def test_share_counts_what_stands_above_the_floor() -> None:
    # p = 2, floor 1: 9 - 1 = 8 of (8 + 3), with any number of losers on the floor.
    assert winner_take_all.share([3, 2, 1, 1, 1], 2, 1) == pytest.approx(8 / 11)
    assert winner_take_all.share([1.0] + [0.01] * 999, 1.1, 0.01) == 1
    assert winner_take_all.share([0.01] * 5, 2, 0.01) == 0
    assert winner_take_all.share([0.5, 0.5], 2, 0.01) == pytest.approx(0.5)


GOOD = {"v": [0.1, 0.2], "tau": [0.5, 1.0], "dt_s": 0.1, "p": 2, "rate": 5}


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("v", [0.1]), ("v", [0.1, -0.1]), ("v", [0.1, math.nan]), ("v", [[0.1, 0.2]]), ("tau", [0.5, 0.0]),
        ("tau", [0.5, math.inf]), ("dt_s", -1), ("dt_s", math.inf), ("p", 0), ("p", 0.999), ("p", math.nan),
        ("rate", 0),
    ],
)  # fmt: skip
def test_advance_refuses_bad_arguments_by_name(name: str, value: object) -> None:
    with pytest.raises(ValueError, match=name):
        winner_take_all.advance(**(GOOD | {name: value}))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("x", "low", "high", "says"),
    [([1, math.nan], 0.01, 1, "x"), ([1, 2], 0, 1, "low"), ([1, 2], 0.5, 0.5, "high"), ([1, 2], 0.1, math.inf, "high")],
)
def test_normalise_refuses_bad_arguments_by_name(x: object, low: float, high: float, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        winner_take_all.normalise(x, low=low, high=high)  # type: ignore[arg-type]


@pytest.mark.parametrize("floor", [0, -1, math.nan])
def test_a_floor_that_is_none_is_refused(floor: float) -> None:
    with pytest.raises(ValueError, match="floor"):
        winner_take_all.revive([0.1], floor)
    with pytest.raises(ValueError, match="floor"):
        winner_take_all.share([0.1], 2, floor)


def test_a_norm_below_one_is_refused_with_its_condition() -> None:
    with pytest.raises(ValueError, match=r"p is 0\.5; it must be finite and at least 1"):
        winner_take_all.share([0.1], 0.5, 0.01)
    with pytest.raises(ValueError, match=r"p is 0\.5; it must be finite and at least 1"):
        winner_take_all.advance([0.1], [1.0], 1.0, p=0.5, rate=1.0)
