"""Other readings of the competition, on Example 3's states: v >= 0 as the paper's eq. 2 says, the rate 1/p, and the
whole vector delayed (docs/model/competition.md#noise-and-delay; paper Figs. 10, 13, 14).

    v_i' = c (τ_i - Σ_j v_j(t - d_i)^p) v_i(t - d_i) + ϑ_i,   v_i >= 0
"""

from __future__ import annotations

import itertools

import numpy as np

from gcs.recording.series import Floats
from gcs.refuelling.simulated_competition import simulate
from gcs.report.paper import races
from gcs.report.paper.disturbed import delayed, noisy
from gcs.report.paper.examples import EXPONENTS
from gcs.report.paper.robustness import DELAYS_S, DURATION_S, NOISY_EXPONENTS, SEED, VARIANCES, WINDOW_S
from gcs.report.paper.study import Measurement, Study, Table

NOISE_STEP_S, DELAY_STEP_S = 0.001, 0.01
CONVERGED, STARTS, START_SEED = 0.01, 1000, 1
ONE_LAW_S = 100.0


def readings(v0: Floats, tau: Floats) -> Study:
    """All of them, on initial states v0 (n,) and bids tau (n,)."""
    winner = int(tau.argmax())
    losers = np.arange(len(tau)) != winner
    rows, off, spread = [], {}, {}
    for p in NOISY_EXPONENTS:
        _, of_rate = rectified_noise(v0, tau, p=p, rate=1.0 / p, variance=1.0)
        spread[p] = float(of_rate[losers].mean())
    for p, variance in itertools.product(NOISY_EXPONENTS, VARIANCES):
        still = simulate(v0, tau, np.array([0.0, DURATION_S]), p=p, rate=1.0)[-1]
        mean, _ = rectified_noise(v0, tau, p=p, rate=1.0, variance=variance)
        off[p, variance] = float(np.abs(mean - still).max())
        rows.append([f"{p:g}", f"{variance:g}", f"{mean[winner]:.4f}", f"{off[p, variance]:.4f}"])
    measured = {
        f"nonneg-noise-{variance:g}": Measurement(
            max(off[p, variance] for p in NOISY_EXPONENTS),
            ", ".join(f"p = {p:g}: {off[p, variance]:.3g}" for p in NOISY_EXPONENTS),
        )
        for variance in VARIANCES
    }
    measured["rate-noise-p"] = Measurement([spread[p] for p in NOISY_EXPONENTS], "p = 1.5, 2, 2.5")
    groups = {f"{d:g} s": np.full(len(tau), d) for d in DELAYS_S} | {
        "0.1, 0.2, 0.3 s": np.repeat(DELAYS_S, len(tau) // len(DELAYS_S))
    }
    left = {
        (p, name): races.remoteness(delayed_whole(v0, tau, delays, p=p, rate=1.0), tau, p)
        for p, (name, delays) in itertools.product(EXPONENTS, groups.items())
    }
    worst = max(left, key=lambda case: left[case])
    measured["whole-delay"] = Measurement(
        sum(one <= CONVERGED for one in left.values()), f"of {len(left)}; the worst is {left[worst]:.1e} off"
    )
    measured["rate-one-law"] = Measurement(_one_law(v0, tau))
    measured["rate-delay"] = Measurement(_delayed_at_rate(v0, tau), "worst of p = 1.5, 2, 2.5, 5")
    measured["any-start"] = Measurement(_any_start(tau), f"worst of {STARTS} random starts and four p")
    measured["ratio-of-p"] = Measurement(
        _ratio_of_p(v0, tau), "ln(v_i/v_j)' = c (τ_i - τ_j): the norm cancels, whatever p is"
    )
    columns = ["p", "variance", "winner's mean, last 60 s", "worst error"]
    return Study(measured, (), [Table("Noise held for 1 ms, v >= 0, c = 1", columns, rows)])


def rectified_noise(v0: Floats, tau: Floats, *, p: float, rate: float, variance: float) -> tuple[Floats, Floats]:
    """Mean and standard deviation (n,) over the last WINDOW_S of DURATION_S, noise of a variance held for 1 ms, v >= 0;
    explicit Euler in the steps of the noise."""
    steps, last = round(DURATION_S / NOISE_STEP_S), round(WINDOW_S / NOISE_STEP_S)
    noise = np.random.default_rng(SEED).standard_normal((steps, len(tau))) * np.sqrt(variance)
    total, squares = np.zeros(len(tau)), np.zeros(len(tau))
    noisy(v0.copy(), tau, noise, p, rate, NOISE_STEP_S, steps - last, total, squares)
    mean = total / last
    return mean, np.sqrt(np.maximum(squares / last - mean**2, 0.0))


def delayed_whole(v0: Floats, tau: Floats, delays_s: Floats, *, p: float, rate: float) -> Floats:
    """States (n,) after EVENTUALLY_S where vehicle i hears everything, its own state too, delays_s[i] late; v >= 0,
    constant history, explicit Euler in steps of 10 ms."""
    delays = np.round(delays_s / DELAY_STEP_S).astype(np.int64)
    return delayed(v0, tau, delays, p, rate, DELAY_STEP_S, round(races.EVENTUALLY_S / DELAY_STEP_S))


def _one_law(v0: Floats, tau: Floats) -> float:
    """Greatest difference among p of w = v^p, from the same w(0), with c = 1/p."""
    times = np.linspace(0.0, ONE_LAW_S, 101)
    w = [simulate(v0 ** (1.0 / p), tau, times, p=p, rate=1.0 / p) ** p for p in EXPONENTS]
    return max(float(np.abs(each - w[0]).max()) for each in w)


def _delayed_at_rate(v0: Floats, tau: Floats) -> float:
    delay = np.repeat(DELAYS_S, len(tau) // len(DELAYS_S))
    times = np.array([0.0, races.EVENTUALLY_S])
    return max(
        races.remoteness(simulate(v0, tau, times, p=p, rate=1.0 / p, delay_s=delay)[-1], tau, p) for p in EXPONENTS
    )


def _any_start(tau: Floats) -> float:
    starts = np.random.default_rng(START_SEED).uniform(0.01, 1.0, (STARTS, len(tau)))
    return max(races.remoteness(races.eventually(start, tau, p=p), tau, p) for p in EXPONENTS for start in starts)


def _ratio_of_p(v0: Floats, tau: Floats) -> float:
    """Greatest difference among p of the logarithm of any state's ratio to the first, over 20 s at c = 1."""
    times = np.linspace(0.0, 20.0, 21)
    ratios = []
    for p in EXPONENTS:
        v = simulate(v0, tau, times, p=p, rate=1.0)
        ratios.append(np.log(v / v[:, :1]))
    return max(float(np.abs(each - ratios[0]).max()) for each in ratios)
