"""Assignments against scipy's, ties included, and against all permutations."""

import itertools

import numpy as np
import pytest
from scipy.optimize import linear_sum_assignment

from skytender.assignment import least_cost


@pytest.mark.parametrize("values", [2, 4, 1000])  # few values: many equal sums
def test_it_is_the_assignment_that_scipy_finds(values: int) -> None:
    rng = np.random.default_rng(values)
    for _ in range(400):
        cost = rng.integers(-values, values, rng.integers(1, 12, 2)).astype(float)
        if values == 1000:
            cost += rng.uniform(0.0, 1.0, cost.shape)
        expected = [side.tolist() for side in linear_sum_assignment(cost)]
        assert [side.tolist() for side in least_cost(cost)] == expected


def test_no_permutation_costs_less() -> None:
    cost = np.random.default_rng(1).uniform(0.0, 1.0, (6, 6))
    rows, columns = least_cost(cost)
    best = min(sum(cost[i, j] for i, j in enumerate(order)) for order in itertools.permutations(range(6)))
    assert cost[rows, columns].sum() == pytest.approx(best)


def test_nothing_is_matched_to_nothing() -> None:
    assert [len(side) for side in least_cost(np.zeros((0, 3)))] == [0, 0]
    assert [len(side) for side in least_cost(np.zeros((3, 0)))] == [0, 0]


@pytest.mark.parametrize("value", [np.inf, -np.inf, np.nan])
def test_a_cost_that_is_no_number_is_refused(value: float) -> None:
    with pytest.raises(ValueError, match="not finite"):
        least_cost(np.array([[0.0, value]]))
