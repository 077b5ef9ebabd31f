"""What errors of places add to the distances that are kept, against SciPy's normal distribution and a union bound."""

from __future__ import annotations

import math
from typing import Any

import pytest
from scipy.stats import norm

from gcs.scenario.accuracy import spreads_m, widest_m
from gcs.scenario.model import Scenario


def fleet(*errors_m: float | None, confidence: float = 0.999, duration_s: float = 120.0) -> Scenario:
    pursuers: list[dict[str, Any]] = []
    for row, error_m in enumerate(errors_m):
        known = {} if error_m is None else {"plant": "rotors", "sensors": {"position_m": error_m, "position_s": 60.0}}
        pursuers.append({"sysid": row + 1, "start_m": (10.0 * row, 0.0, 0.0), "battery": {"capacity_j": 2e4}, **known})
    return Scenario.model_validate(
        {
            "schema": 1, "name": "errors", "axes": "ned", "origin": {"lat_deg": 47.4, "lon_deg": 8.5, "alt_m": 488.0},
            "goal": {"duration_s": duration_s}, "vehicles": {"pursuers": pursuers},
            "planner": {"confidence": confidence},
        }
    )  # fmt: skip


def test_vehicles_that_know_their_places_are_kept_no_farther_apart() -> None:
    assert spreads_m(fleet(None, None)) == {1: 0.0, 2: 0.0}
    assert widest_m(fleet(None, None)) == (0.0, 0.0)


@pytest.mark.parametrize("confidence", [0.5, 0.9, 0.999, 0.999999])
@pytest.mark.parametrize("count", [1, 2, 12, 100])
def test_a_spread_is_exceeded_in_no_more_sessions_than_the_confidence_leaves(count: int, confidence: float) -> None:
    """Three correlation times, count (count - 1) / 2 pairs and each vehicle alone: the sum of all tails."""
    k = spreads_m(fleet(*[0.5] * count, confidence=confidence))[1] / 0.5
    chances = 3.0 * (math.comb(count, 2) + count)
    assert norm.sf(k + 0.005) * chances <= 1.0 - confidence <= norm.sf(k - 0.005) * chances


def test_two_spreads_add_as_independent_errors_do() -> None:
    one_m, other_m = spreads_m(fleet(0.3, 0.4)).values()
    pair_m, alone_m = widest_m(fleet(0.3, 0.4))
    assert (pair_m, alone_m) == (pytest.approx(math.hypot(one_m, other_m)), other_m)
    assert widest_m(fleet(0.3, None)) == (pytest.approx(alone_m * 0.75), pytest.approx(alone_m * 0.75))
