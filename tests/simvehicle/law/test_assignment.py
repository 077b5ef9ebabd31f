"""Assignments against scipy's, which is another implementation of the problem."""

import numpy as np
import pytest
from scipy.optimize import linear_sum_assignment

from simvehicle.law.assignment import least_cost_columns


@pytest.mark.parametrize(("n", "m"), [(1, 1), (1, 4), (2, 2), (3, 7), (8, 8), (12, 20)])
def test_the_sum_is_the_least(n: int, m: int) -> None:
    rng = np.random.default_rng(n * m)
    for scale in (0.0, 1.0, 1e6):
        for _ in range(20):
            cost = rng.integers(0, 9, (n, m)) + scale * rng.random((n, m))
            columns = least_cost_columns(cost.tolist())
            assert len(set(columns)) == n
            least = cost[linear_sum_assignment(cost)].sum()
            assert cost[np.arange(n), columns].sum() == pytest.approx(least, rel=1e-12)


def test_nobody_is_matched_to_nobody() -> None:
    assert least_cost_columns([]) == []
