"""The bound on losses: by hand, and never above what an exhaustive search of a kinder world finds."""

import itertools

import numpy as np
import pytest

from gcs.refuelling.loss_bound import least_lost


def test_by_hand() -> None:
    """Three at 100 W with 1 kJ, a session of 30 s: each lacks 2 kJ. One tanker of 200 W from 0 s on gives 6 kJ until
    then: enough. 160 W are too few for three from 21.4 s on, 130 W for two from 28.6 s on."""
    three = {"left_j": [1e3] * 3, "power_w": [100.0] * 3, "end_s": 30.0}
    assert least_lost(**three, rate_w=200.0, spare_j=[1e5]) == 0
    assert least_lost(**three, rate_w=160.0, spare_j=[1e5]) == 1
    assert least_lost(**three, rate_w=130.0, spare_j=[1e5]) == 2
    assert least_lost(**three, rate_w=160.0, spare_j=[1e5, 1e5]) == 0
    assert least_lost(**three, rate_w=1e6, spare_j=[2.5e3]) == 2
    assert least_lost(**three, rate_w=1e6, spare_j=[1e5], first_s=10.5) == 3
    assert least_lost([5e3], [100.0], end_s=30.0, rate_w=1.0, spare_j=[]) == 0


def kept_at_best(left_j: np.ndarray, power_w: np.ndarray, end_s: float, rate_w: float) -> int:
    """One tanker without ways or pauses that fills by quanta of 1 s, every choice of each second tried."""
    best = 0
    for choice in itertools.product(range(len(left_j)), repeat=round(end_s)):
        left, alive = left_j.copy(), np.ones(len(left_j), dtype=bool)
        for served in choice:
            left[served] += rate_w
            left -= power_w
            alive &= left >= 0.0
        best = max(best, int(alive.sum()))
    return best


@pytest.mark.parametrize("seed", range(6))
def test_no_schedule_loses_fewer(seed: int) -> None:
    rng = np.random.default_rng(seed)
    left_j, power_w = rng.uniform(50.0, 400.0, 3), rng.uniform(50.0, 150.0, 3)
    lost = 3 - kept_at_best(left_j, power_w, 7.0, 200.0)
    assert least_lost(left_j, power_w, end_s=7.0, rate_w=200.0, spare_j=[1e6]) <= lost
