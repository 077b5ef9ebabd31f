"""Other readings of the competition, against the solution without noise and delay, and a solver of delays by steps."""

from __future__ import annotations

import numpy as np
import pytest

from gcs.report.paper import readings
from skytender.winner_take_all import advance

V0, TAU = np.array([0.5, 0.1, 0.3]), np.array([0.4, 1.0, 0.7])


def test_without_noise_the_states_come_to_rest_where_the_law_does() -> None:
    mean, spread = readings.rectified_noise(V0, TAU, p=2.0, rate=1.0, variance=0.0)
    assert mean == pytest.approx(advance(V0, TAU, 300.0, p=2.0, rate=1.0), abs=1e-9)
    assert spread == pytest.approx(0.0, abs=1e-7)


def test_noise_never_carries_a_state_below_zero_and_its_mean_above() -> None:
    """A loser near 0 is a reflected Ornstein-Uhlenbeck process with decay 1 - τ: its mean is sd √(2/π) of the free one,
    whose variance is σ² h/(2 (1 - τ))."""
    mean, _ = readings.rectified_noise(V0, TAU, p=2.0, rate=1.0, variance=1.0)
    free = np.sqrt(1.0 * readings.NOISE_STEP_S / (2.0 * (1.0 - TAU[0])))
    # Clipped, not reflected, and the winner's square is a little below 1: within a third.
    assert mean[0] == pytest.approx(free * np.sqrt(2.0 / np.pi), rel=0.35)
    assert mean[1] == pytest.approx(1.0, abs=0.01)


def test_a_whole_vector_without_delay_is_the_law_and_with_delay_converges() -> None:
    still = readings.delayed_whole(V0, TAU, np.zeros(3), p=1.5, rate=1.0)
    assert still == pytest.approx(advance(V0, TAU, 1000.0, p=1.5, rate=1.0), abs=1e-9)
    late = readings.delayed_whole(V0, TAU, np.array([0.1, 0.2, 0.3]), p=1.5, rate=1.0)
    assert late == pytest.approx([0.0, 1.0, 0.0], abs=1e-6)
