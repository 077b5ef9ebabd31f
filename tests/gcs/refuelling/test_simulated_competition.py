"""Truth: the exact solution, an adaptive solver, the method of steps, and variances of linear stochastic systems."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from gcs.refuelling import simulated_competition
from skytender import winner_take_all

PAPER_DELAYS = np.repeat([0.1, 0.2, 0.3], 5)


def draw(n: int, seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    return rng.uniform(0.1, 0.9, n), rng.uniform(0.05, 1, n)


@pytest.mark.parametrize("p", [1.0, 2.0, 5.0])
def test_without_noise_and_delay_it_is_the_exact_solution(p: float) -> None:
    v, tau = draw(15)
    times = np.array([3.0, 3.1, 9.0, 1e6])
    states = simulated_competition.simulate(v, tau, times, p=p, rate=2.0)
    for row, t in zip(states, times, strict=True):
        assert np.array_equal(row, winner_take_all.advance(v, tau, t - 3.0, p=p, rate=2.0))


@pytest.mark.parametrize("p", [1.0, 1.5, 2.0, 2.5, 5.0])
def test_its_steps_agree_with_the_exact_solution(p: float) -> None:
    v, tau = draw(15)
    times = np.linspace(0.0, 4.0, 37)  # between steps too
    stepped = simulated_competition.simulate(v, lambda _: tau, times, p=p, rate=1.0)
    exact = np.array([winner_take_all.advance(v, tau, t, p=p, rate=1.0) for t in times])
    assert stepped == pytest.approx(exact, abs=2e-9)


@pytest.mark.parametrize("p", [1.5, 2.0, 5.0])
def test_a_tau_of_time_agrees_with_an_adaptive_solver(p: float) -> None:
    v, _ = draw(5)
    phase = np.arange(5.0)

    def tau(t: float) -> np.ndarray:
        return 0.5 + 0.4 * np.sin(0.7 * t + phase)

    def rate(t: float, x: np.ndarray) -> np.ndarray:
        return (tau(t) - (x**p).sum()) * x

    times = np.linspace(2.0, 12.0, 21)
    solved = solve_ivp(rate, (2.0, 12.0), v, t_eval=times, method="DOP853", rtol=1e-10, atol=1e-14).y.T
    assert simulated_competition.simulate(v, tau, times, p=p, rate=1.0) == pytest.approx(solved, abs=2e-9)


def test_a_row_of_tau_holds_until_the_next() -> None:
    v, _ = draw(3)
    rows = np.array([[1.0, 0.5, 0.2], [0.2, 0.5, 1.0], [0.1, 0.1, 0.1]])
    states = simulated_competition.simulate(v, rows, [0.0, 8.0, 20.0], p=2, rate=1.0)
    middle = winner_take_all.advance(v, rows[0], 8.0, p=2, rate=1.0)
    assert states[1] == pytest.approx(middle, rel=1e-12)
    assert states[2] == pytest.approx(winner_take_all.advance(middle, rows[1], 12.0, p=2, rate=1.0), rel=1e-12)
    assert states[2].argmax() == 2


def test_rows_of_tau_hold_in_steps_as_in_the_exact_solution() -> None:
    v, _ = draw(3)
    rows, times = draw(3 * 41, seed=3)[1].reshape(41, 3), np.linspace(0.0, 4.0, 41)
    exact = simulated_competition.simulate(v, rows, times, p=2, rate=1.0)
    # With any delay it goes in steps. This one is a fourth competitor's, whose state stays 0 and changes no other's.
    stepped = simulated_competition.simulate(
        [*v, 0.0], np.hstack([rows, rows[:, :1]]), times, p=2, rate=1.0, delay_s=[0, 0, 0, 1]
    )
    assert stepped[:, :3] == pytest.approx(exact, abs=1e-9)


def test_a_delay_agrees_with_the_closed_form_of_the_method_of_steps() -> None:
    """One alone, p = 2, r = √τ: artanh(v/r)' = r c v(t - d), which v0, then r tanh, then its integral solve."""
    tau, v0, c, d = 0.7, 0.3, 1.3, 0.15
    r = math.sqrt(tau)
    times = np.linspace(0.0, 2 * d, 50)
    first, grow = math.atanh(v0 / r), r * c * v0
    in_first = r * np.tanh(grow * times + first)
    end = grow * d + first
    since = np.maximum(times - d, 0.0)
    area = r / grow * (np.log(np.cosh(grow * since + first)) - math.log(math.cosh(first)))
    truth = np.where(times <= d, in_first, r * np.tanh(r * c * area + end))
    got = simulated_competition.simulate([v0], [tau], times, p=2, rate=c, delay_s=[d])
    assert got[:, 0] == pytest.approx(truth, abs=1e-12)


@pytest.mark.parametrize("p", [1.5, 2.5])
def test_delays_of_a_fleet_agree_with_an_adaptive_solver_stage_by_stage(p: float) -> None:
    v, tau = draw(6, seed=8)
    delays = np.array([0.1, 0.2, 0.3, 0.1, 0.2, 0.0])
    stages = []

    def past(t: float, i: int) -> float:
        before = t - delays[i]
        return float(v[i] if before <= 0 else stages[min(int(before / 0.1 + 1e-9), len(stages) - 1)](before)[i])

    now, solved = v, [v]
    for k in range(10):

        def rate(t: float, x: np.ndarray) -> np.ndarray:
            old = np.array([x[i] if delays[i] == 0 else past(t, i) for i in range(6)])
            return 1.0 * (tau - (np.abs(x) ** p).sum()) * old

        run = solve_ivp(rate, (0.1 * k, 0.1 * (k + 1)), now, "DOP853", dense_output=True, rtol=1e-10, atol=1e-13)
        stages.append(run.sol)
        now = run.y[:, -1]
        solved.append(now)
    got = simulated_competition.simulate(v, tau, 0.1 * np.arange(11), p=p, rate=1.0, delay_s=delays)
    assert got == pytest.approx(np.array(solved), abs=1e-8)


def test_with_the_paper_s_delays_the_winner_still_settles_at_tau_to_the_1_over_p() -> None:
    _, tau = draw(15, seed=2)
    tau[7] = 1.0
    for p in (1.5, 2.0, 2.5, 5.0):
        v = np.full(15, 0.8)
        end = simulated_competition.simulate(
            v, np.minimum(tau, 0.9) + 0.1 * (tau == 1), [0, 200], p=p, rate=1, delay_s=PAPER_DELAYS
        )
        assert end[-1, 7] == pytest.approx(1.0, abs=1e-6)
        assert np.abs(np.delete(end[-1], 7)).max() < 1e-3


def test_held_noise_walks_with_variance_times_hold_and_an_sde_with_variance() -> None:
    """With c almost 0 only the noise is left: var(v - v0) after t is σ² hold t, or σ² t."""
    n, t, variance = 4000, 0.5, 2.0
    much = {"p": 2, "rate": 1e-9, "noise_variance": variance, "seed": 5}
    tau, v = np.full(n, 0.5), np.full(n, 0.1)
    for hold_s in (0.001, 0.01):
        walked = simulated_competition.simulate(v, tau, [0, t], noise="held", noise_hold_s=hold_s, **much)[-1] - v
        assert walked.var() == pytest.approx(variance * hold_s * t, rel=0.1)
        assert abs(walked.mean()) < 4 * math.sqrt(variance * hold_s * t / n)
    diffused = simulated_competition.simulate(v, tau, [0, t], noise="sde", **much)[-1] - v
    assert diffused.var() == pytest.approx(variance * t, rel=0.1)


def test_around_its_rest_a_winner_trembles_as_the_linear_system_does() -> None:
    """v' ≈ -c p τ (v - τ^(1/p)) + ϑ near the rest, an Ornstein-Uhlenbeck process: variance σ² hold/(2 c p τ)."""
    tau, p, c, variance = 0.6, 2.0, 5.0, 0.01
    times = np.arange(0.0, 1200.0, 0.5)
    v = simulated_competition.simulate(
        [tau ** (1 / p)], [tau], times, p=p, rate=c, noise="held", noise_variance=variance, seed=11
    )[20:, 0]
    assert v.mean() == pytest.approx(tau ** (1 / p), abs=1e-3)
    assert v.var() == pytest.approx(variance * 0.001 / (2 * c * p * tau), rel=0.1)


def test_held_samples_last_exactly_their_hold() -> None:
    """With c almost 0 the path is a chain of straight lines that bend only at multiples of the hold."""
    times = np.arange(0.0, 0.2, 0.0005)
    v = simulated_competition.simulate(
        [0.5], [0.5], times, p=2, rate=1e-12, noise="held", noise_variance=1.0, noise_hold_s=0.02, seed=1
    )[:, 0]
    bends = np.flatnonzero(np.abs(np.diff(v, 2)) > 1e-9) + 1
    assert times[bends] == pytest.approx(np.arange(1, 10) * 0.02)


@pytest.mark.parametrize("noise", ["held", "sde"])
def test_a_seed_is_a_path_whatever_times_are_asked_for(noise: str) -> None:
    v, tau = draw(4)
    more = {"p": 2, "rate": 1.0, "noise": noise, "noise_variance": 0.5, "delay_s": [0, 0.05, 0.0123, 0]}
    fine = simulated_competition.simulate(v, tau, np.linspace(0, 3, 3001), seed=3, **more)
    coarse = simulated_competition.simulate(v, tau, [0, 1.2345, 3.0], seed=3, **more)
    assert coarse[2] == pytest.approx(fine[-1], abs=1e-12)
    other = simulated_competition.simulate(v, tau, [0, 3.0], seed=4, **more)
    assert not np.allclose(other[-1], fine[-1], atol=1e-3)


def test_samples_of_noise_leave_the_winner_and_an_sde_of_that_intensity_does_not() -> None:
    """docs/model/competition.md#noise-and-delay: the winner's picture is kept by samples held for 1 ms, and lost even
    at σ² = 0.1 as an SDE."""
    tau = np.linspace(0.01, 1.0, 15)
    times = np.linspace(0.0, 100.0, 501)
    share = {}
    for noise in ("held", "sde"):
        v = simulated_competition.simulate(
            np.full(15, 0.8), tau, times, p=2, rate=1, noise=noise, noise_variance=0.1, seed=9
        )
        share[noise] = (np.abs(v[400:]).argmax(axis=1) == 14).mean()
    assert share["held"] == 1.0
    assert share["sde"] < 0.5


@settings(max_examples=60)
@given(
    st.integers(1, 6).flatmap(lambda n: st.lists(st.floats(1e-300, 1.0), min_size=n, max_size=n)),
    st.floats(1.1, 10.0),
    st.integers(0, 2**32 - 1),
)
def test_any_start_stays_finite_with_noise_and_delay(v: list[float], p: float, seed: int) -> None:
    rng = np.random.default_rng(seed)
    tau, delays = rng.uniform(0.01, 1, len(v)), rng.choice([0.0, 0.004, 0.1], len(v))
    states = simulated_competition.simulate(
        v, tau, [0, 0.05, 0.3], p=p, rate=1, noise="held", noise_variance=1.0, delay_s=delays, seed=seed
    )
    assert np.isfinite(states).all()
    assert np.array_equal(states[0], v)


def test_a_single_time_is_the_start() -> None:
    assert simulated_competition.simulate([0.1, 0.2], [0.5, 1], [7.0], p=2, rate=1).tolist() == [[0.1, 0.2]]


GOOD = {"v0": [0.1, 0.2], "tau": [0.5, 1.0], "times_s": [0.0, 0.1], "p": 2, "rate": 5}


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"v0": [0.1, -0.2]}, "v0 is"), ({"v0": [[0.1]]}, "v0 has shape"), ({"tau": [0.5]}, "tau has shape"),
        ({"tau": [[0.5, 1.0]]}, "tau has shape"), ({"tau": [0.5, 0.0]}, "tau is"), ({"p": 0.99}, "p is 0.99"),
        ({"tau": lambda _: [0.5, -1.0]}, "tau is"), ({"tau": lambda _: [0.5]}, "tau has shape"),
        ({"rate": 0}, "rate"), ({"times_s": []}, "times_s"), ({"times_s": [0.0, 0.0]}, "times_s"),
        ({"noise_variance": 0.1}, "noise is None"), ({"noise": "white"}, "noise is 'white'"),
        ({"noise": "sde", "noise_variance": -1}, "noise_variance"), ({"noise_hold_s": 0}, "noise_hold_s"),
        ({"noise": "held", "noise_variance": 1, "noise_hold_s": 1e-9}, "noise_hold_s"),
        ({"delay_s": [0.1]}, "delay_s"), ({"delay_s": [0.1, -0.1]}, "delay_s"), ({"delay_s": [0.1, 1e-9]}, "delay_s"),
        ({"delay_s": [0.1, 0.1], "rate": 1e6}, "at most 500"),
    ],
)  # fmt: skip
def test_bad_arguments_are_refused_by_name(change: dict[str, object], says: str) -> None:
    with pytest.raises(ValueError, match=says):
        simulated_competition.simulate(**(GOOD | change))  # type: ignore[arg-type]


def test_too_long_a_delay_is_told_and_not_returned() -> None:
    """v_i' follows a past, large v_i while the norm is already above τ: the swing grows without bound."""
    with pytest.raises(ArithmeticError, match="grew beyond all bounds"):
        simulated_competition.simulate([0.9, 0.5], [1.0, 0.5], [0, 60], p=2, rate=20, delay_s=[0.9, 0.9])
