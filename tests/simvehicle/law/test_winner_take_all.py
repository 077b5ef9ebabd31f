"""The law on board against the ground station's, to the last bit, and against the closed form of its ratios."""

from __future__ import annotations

import numpy as np
import pytest

from gcs.refuelling import k_winners, winner_take_all
from simvehicle.law.winner_take_all import Bidder, advance_ln, bounded, standing


def states(seed: int, n: int) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    return rng.uniform(-30.0, 0.0, n), rng.uniform(0.01, 1.0, n)


@pytest.mark.parametrize("p", [1.0, 1.5, 2.0, 5.0])
@pytest.mark.parametrize("n", [1, 2, 10, 40])
def test_both_programs_compute_the_same_bits(p: float, n: int) -> None:
    for seed in range(20):
        ln_v, tau = states(seed, n)
        for places in (1, 4):
            own = bounded(advance_ln(ln_v, tau, 0.1, p=p, rate=20.0), places, 0.01)
            theirs = k_winners.bounded(winner_take_all.advance_ln(ln_v, tau, 0.1, p=p, rate=20.0), places, 0.01)
            assert own.tobytes() == theirs.tobytes()


def test_ratios_are_those_of_the_closed_form() -> None:
    """v_i/v_j = const · e^(c (τ_i - τ_j) t), whatever p is."""
    ln_v, tau = states(3, 12)
    for p in (1.5, 2.0, 5.0):
        after = advance_ln(ln_v, tau, 0.7, p=p, rate=20.0)
        assert after - after[0] == pytest.approx(ln_v - ln_v[0] + 20.0 * 0.7 * (tau - tau[0]), rel=1e-12)


def test_the_winner_settles_where_the_law_says() -> None:
    """The greatest τ is left alone at v = τ^(1/p)."""
    tau = np.array([0.4, 0.9, 0.6])
    ln_v = np.log(np.full(3, 0.01))
    for _ in range(200):
        ln_v = advance_ln(ln_v, tau, 0.1, p=2.0, rate=20.0)
    assert np.exp(ln_v) == pytest.approx([0.0, 0.9**0.5, 0.0], abs=1e-12)


def test_both_programs_read_the_same_winners() -> None:
    rng = np.random.default_rng(8)
    for _ in range(50):
        n = int(rng.integers(2, 12))
        ln_v, times_s = rng.uniform(-10.0, 0.0, n), rng.uniform(0.0, 60.0, n).round(0)
        rows = [
            (i + 1, float(x), float(t), (0.0, float(i))) for i, (x, t) in enumerate(zip(ln_v, times_s, strict=True))
        ]
        for k in range(1, n):
            own = standing([Bidder(*row) for row in rows], k, p=2.0, tie_s=2.0)
            assert own == tuple(k_winners.read([k_winners.Competitor(*row) for row in rows], k, p=2.0, tie_s=2.0))
