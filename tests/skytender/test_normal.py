"""Normal numbers against their distribution, and however they are drawn."""

from __future__ import annotations

import numpy as np
from scipy import stats

from skytender.normal import standard_normal


def test_they_are_normal_and_independent() -> None:
    drawn = standard_normal(np.random.default_rng(1), 40_000, 5)
    assert stats.kstest(drawn.ravel(), "norm").pvalue > 0.01
    assert np.abs(np.corrcoef(drawn.T) - np.eye(5)).max() < 0.02
    assert np.abs(np.corrcoef(drawn[1:, 0], drawn[:-1, 0])[0, 1]) < 0.02


def test_rows_drawn_one_by_one_are_those_drawn_at_once() -> None:
    at_once, by_row = np.random.default_rng(2), np.random.default_rng(2)
    whole = standard_normal(at_once, 7, 3)
    assert np.array_equal(whole, np.concatenate([standard_normal(by_row, n, 3) for n in (1, 4, 2)]))
