"""The auction against scipy's exact assignment."""

import numpy as np
import pytest
from scipy.optimize import linear_sum_assignment

from gcs.refuelling.policies import auction


@pytest.mark.parametrize(("m", "n"), [(1, 1), (1, 7), (4, 4), (5, 30), (8, 200)])
def test_its_sum_is_within_m_epsilon_of_the_greatest(m: int, n: int) -> None:
    for seed in range(10):
        benefit = np.random.default_rng(seed).normal(0.0, 20.0, (m, n))
        held = auction(benefit, 0.05)
        assert len(set(held.tolist())) == m
        best = benefit[linear_sum_assignment(benefit, maximize=True)].sum()
        assert benefit[np.arange(m), held].sum() >= best - 0.05 * m - 1e-9


def test_more_bidders_than_objects_are_refused() -> None:
    with pytest.raises(ValueError, match="3 bidders for 2 objects"):
        auction(np.zeros((3, 2)), 0.1)
