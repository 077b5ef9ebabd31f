"""Times of convergence against closed forms: v_i/v_j = v_i(0)/v_j(0) e^(c (τ_i - τ_j) t)
(docs/model/competition.md#convergence-time)."""

import math

import numpy as np
import pytest

from gcs.report.paper import races

V0, TAU = np.array([0.5, 0.1, 0.3]), np.array([0.4, 1.0, 0.7])


@pytest.mark.parametrize("p", [1.5, 2.0, 5.0])
@pytest.mark.parametrize("rate", [1.0, 0.4])
def test_losers_fall_below_one_percent_when_their_ratio_says_so(p: float, rate: float) -> None:
    # Of the two losers the second bids more, and starts at three times the winner's state.
    expected = math.log(3.0 / 0.01) / (rate * 0.3)
    assert races.time_to_win(V0, TAU, p=p, rate=rate, criterion="ratio") == pytest.approx(expected, rel=1e-5)


def test_two_alike_share_until_the_winners_power_is_nine_times_the_others() -> None:
    # (v_2/v_1)^p = e^(p c Δτ t) = 9 from equal starts.
    expected = math.log(9.0) / (2.0 * 0.6)
    found = races.time_to_win(np.array([0.2, 0.2]), TAU[:2], p=2.0, rate=1.0, criterion="share")
    assert found == pytest.approx(expected, rel=1e-5)


def test_a_race_that_is_over_at_once_takes_no_time_and_a_tie_takes_for_ever() -> None:
    assert races.time_to_win(np.array([1e-9, 1.0]), TAU[:2], p=2.0, rate=1.0, criterion="ratio") == 0.0
    tie = races.time_to_win(np.array([0.2, 0.2]), np.array([1.0, 1.0]), p=2.0, rate=1.0, criterion="ratio")
    assert tie == math.inf


def test_remoteness_is_zero_at_the_limit_and_sees_winner_and_losers() -> None:
    tau = np.array([0.25, 0.01])
    assert races.remoteness(np.array([0.5, 0.0]), tau, 2.0) == 0.0
    assert races.remoteness(np.array([0.5, 0.1]), tau, 2.0) == pytest.approx(0.1)
    assert races.remoteness(np.array([0.3, 0.1]), tau, 2.0) == pytest.approx(0.2)


def test_the_least_effort_gets_the_greatest_bid() -> None:
    assert races.least_wins(np.array([3.0, 1.0, 2.0])) == pytest.approx([0.01, 1.0, 0.505])


@pytest.mark.parametrize("p", [1.5, 5.0])
def test_the_closed_form_solves_the_equation(p: float) -> None:
    assert races.solver_error(V0, TAU, p=p, duration_s=100.0) < 1e-8


def test_growth_beyond_all_bounds_is_no_result() -> None:
    def grows() -> np.ndarray:
        raise ArithmeticError("too much")

    assert races.disturbed(grows) is None
