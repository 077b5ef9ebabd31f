"""The k greatest: the law in logarithms against an adaptive solver, the reading against cases made by hand."""

import itertools
import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from skytender.k_winners import Competitor, Standings, bounded, read, share_of
from skytender.winner_take_all import advance, advance_ln


def competitors(ln_v: list[float], times_s: list[float] | None = None) -> list[Competitor]:
    bids = times_s or [10.0 * i for i in range(len(ln_v))]
    return [Competitor(i + 1, x, t, (0.0, float(i))) for i, (x, t) in enumerate(zip(ln_v, bids, strict=True))]


@pytest.mark.parametrize("p", [1.1, 1.5, 2.0, 5.0])
def test_logarithms_agree_with_an_adaptive_solver_and_with_the_states(p: float) -> None:
    rng = np.random.default_rng(5)
    ln_v, tau = np.log(rng.uniform(0.01, 1.0, 12)), rng.uniform(0.01, 1.0, 12)
    solved = solve_ivp(
        lambda _, x: 10.0 * (tau - (np.exp(x) ** p).sum()), (0, 4.0), ln_v, method="DOP853", rtol=1e-11, atol=1e-11
    ).y[:, -1]
    assert advance_ln(ln_v, tau, 4.0, p=p, rate=10.0) == pytest.approx(solved, abs=1e-7)
    assert np.exp(advance_ln(ln_v, tau, 0.3, p=p, rate=10.0)) == pytest.approx(
        advance(np.exp(ln_v), tau, 0.3, p=p, rate=10.0), rel=1e-12
    )


def test_ratios_outlive_the_range_of_floats() -> None:
    """After 400 s at c = 10 the fourth lies e^-2000 below the first, and the fifth e^-40 below the fourth."""
    tau = np.array([1.0, 0.9, 0.8, 0.5, 0.49])
    ln_v = np.full(5, math.log(0.01))
    for _ in range(4000):
        ln_v = advance_ln(ln_v, tau, 0.1, p=2.0, rate=10.0)
    assert ln_v - ln_v[0] == pytest.approx(10.0 * (tau - 1.0) * 400.0, rel=1e-9)
    with np.errstate(over="raise", invalid="raise"):
        assert advance([0.01] * 5, tau, 400.0, p=2.0, rate=10.0)[3] == 0.0  # where the logarithm still tells them apart


@pytest.mark.parametrize("p", [1.5, 2.0, 5.0])
@pytest.mark.parametrize("k", [1, 3])
def test_the_set_is_clear_when_the_closed_form_says_whoever_leads(p: float, k: int) -> None:
    """The ODE itself: the k-th holds the share against the next one at ln(share/(1 - share))/(p c Δτ)."""
    tau = np.array([1.0, 0.7, 0.65, 0.5, 0.2])
    gap = tau[k - 1] - tau[k]
    after_s = math.log(0.9 / 0.1) / (p * 10.0 * gap)
    solved = solve_ivp(
        lambda _, v: 10.0 * (tau - (v**p).sum()) * v, (0, after_s), [0.05] * 5, method="DOP853", rtol=1e-11, atol=1e-15
    ).y[:, -1]
    assert solved[k - 1] ** p / (solved[k - 1] ** p + solved[k] ** p) == pytest.approx(0.9, abs=1e-6)
    assert share_of(math.log(solved[k - 1] / solved[k]), p) == pytest.approx(0.9, abs=1e-6)


def test_the_winners_are_those_of_the_greatest_bids_for_every_k() -> None:
    rng = np.random.default_rng(2)
    for n, k in itertools.product((2, 5, 30), (1, 2, 4)):
        if k >= n:
            continue
        times_s = rng.permutation(np.arange(n) * 3.0)
        ln_v = advance_ln(np.full(n, -9.0), 1.0 - times_s / 100.0, 5.0, p=2.0, rate=10.0)
        found = read(competitors(list(ln_v), list(times_s)), k, p=2.0, tie_s=2.0)
        assert set(found.winners) == {int(i) + 1 for i in np.argsort(times_s)[:k]}
        assert found.share > 0.9


def test_who_ties_takes_the_place_by_rank() -> None:
    """3 and 4 lie within 2 s of each other at the edge of two places: 4 comes first by rank, though 3 leads by v."""
    four = [
        Competitor(1, 0.0, 5.0, (0.0,)),
        Competitor(3, -1.0, 20.0, (2.0,)),
        Competitor(4, -1.1, 21.0, (1.0,)),
        Competitor(9, -4.0, 40.0, (3.0,)),
    ]
    found = read(four, 2, p=2.0, tie_s=2.0)
    assert (found.winners, found.ties) == ((1, 4), {3, 4})
    assert found.share == pytest.approx(share_of(3.0, 2.0))
    assert read(four, 2, p=2.0, tie_s=0.0).winners == (1, 3)
    assert read(four[1:3], 1, p=2.0, tie_s=2.0).share == 1.0  # nobody is left to be told apart


def test_drawing_together_keeps_what_losers_have_of_each_other() -> None:
    """Floor e^-2 and two places: 1 may lie 2 above 2, that 2 above 3, the others 2 below that at most."""
    drawn = bounded([0.0, -50.0, -51.0, -51.5, -90.0], 2, math.exp(-2.0))
    assert drawn == pytest.approx([0.0, -2.0, -3.0, -3.5, -5.0])
    near = np.array([-3.0, 0.0, -1.0])
    assert bounded(near, 2, math.exp(-2.0)) == pytest.approx(near)
    assert bounded([], 3, 0.01).shape == (0,)


def test_one_that_was_last_of_many_comes_back_in_bounded_time() -> None:
    """200 for 8 places over a minute, then the last bids most: floor 0.01 is 4.6 a place, 9 places, 0.6 s each at 8."""
    n, places = 200, 8
    tau = np.linspace(0.9, 0.1, n)
    ln_v = np.full(n, places * math.log(0.01))
    for _ in range(600):
        ln_v = bounded(advance_ln(ln_v, tau, 0.1, p=2.0, rate=10.0), places, 0.01)
    tau[-1] = 1.0
    ticks = next(
        t
        for t in itertools.count()
        if (ln_v := bounded(advance_ln(ln_v, tau, 0.1, p=2.0, rate=10.0), places, 0.01)).argmax() == n - 1
    )
    assert ticks * 0.1 <= 9 * 4.61 / (10.0 * 0.1) + 0.2


def test_a_set_is_clear_only_while_states_and_bids_name_it_and_counts_from_then_on() -> None:
    standings = Standings(p=2.0, tie_s=2.0, share=0.9)
    states = [0.0, -3.0, -4.0]
    standings.advance(competitors(states, [0.0, 30.0, 60.0]), 2, 1.0)
    standings.advance(competitors(states, [0.0, 30.0, 60.0]), 2, 1.5)
    assert standings.clear_s(1, 1.5) == 0.5
    standings.advance(competitors(states, [60.0, 30.0, 0.0]), 2, 2.0)  # the bids jump, the states still name vehicle 1
    assert standings.clear_s(1, 2.0) < 0.0
    standings.advance(competitors([-4.0, -3.0, 0.0], [60.0, 30.0, 0.0]), 2, 2.5)
    found = standings.reading(1)
    assert found is not None
    assert found.winners == (3,)
    assert standings.clear_s(1, 3.0) == 0.5
    assert standings.reading(3) is None


def test_what_was_clear_of_two_places_is_clear_of_one_when_a_winner_has_left() -> None:
    standings = Standings(p=2.0, tie_s=2.0, share=0.9)
    standings.advance(competitors([0.0, -3.0, -9.0], [0.0, 30.0, 60.0]), 2, 4.0)
    standings.without(1)
    found = standings.reading(1)
    assert found is not None
    assert found.winners == (2,)
    assert standings.clear_s(1, 4.5) == 0.5
    assert standings.reading(2) is None
