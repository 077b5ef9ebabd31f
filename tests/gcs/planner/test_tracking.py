"""Tracking error and lag of vehicles that fly a known way behind their leaders."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gcs.planner.tracking import DECAY_S, Tracking

PERIOD_S = 0.1
ROW = np.array([0])


def flown(lag_s: float, aside_m: float, *, fleet_lag_s: float, ticks: int = 200) -> Tracking:
    """A leader at 2 m/s north; its vehicle where that was `lag_s` ago, `aside_m` to the east."""
    tracking = Tracking(1, 0.37)
    for k in range(ticks):
        now_s = k * PERIOD_S
        tracking.measure(ROW, np.array([(2.0 * (now_s - lag_s), aside_m, 0.0)]), now_s, PERIOD_S, fleet_lag_s)
        tracking.lead(ROW, now_s + PERIOD_S, np.array([(2.0 * (now_s + PERIOD_S), 0.0, 0.0)]))
    return tracking


def test_the_lag_is_measured_and_who_flies_it_has_no_error() -> None:
    tracking = flown(0.62, 0.0, fleet_lag_s=0.62)
    assert tracking.lag_s[0] == pytest.approx(0.62, abs=1e-3)
    assert tracking.now_m[0] == pytest.approx(0.0, abs=1e-9)


def test_being_aside_and_being_late_are_errors() -> None:
    assert flown(0.37, 0.3, fleet_lag_s=0.37).now_m[0] == pytest.approx(0.3)
    assert flown(0.87, 0.0, fleet_lag_s=0.37).now_m[0] == pytest.approx(2.0 * 0.5)
    assert flown(0.87, 0.3, fleet_lag_s=0.37).now_m[0] == pytest.approx(math.hypot(1.0, 0.3))


def test_an_error_fades() -> None:
    tracking = flown(0.37, 0.3, fleet_lag_s=0.37)
    greatest_m = tracking.error_m[0]
    for k in range(200, 400):
        now_s = k * PERIOD_S
        tracking.measure(ROW, np.array([(2.0 * (now_s - 0.37), 0.0, 0.0)]), now_s, PERIOD_S, 0.37)
        tracking.lead(ROW, now_s + PERIOD_S, np.array([(2.0 * (now_s + PERIOD_S), 0.0, 0.0)]))
    assert tracking.error_m[0] == pytest.approx(greatest_m * math.exp(-20.0 / DECAY_S), rel=1e-6)


def test_a_new_leader_begins_without_error() -> None:
    tracking = flown(0.37, 0.3, fleet_lag_s=0.37)
    tracking.restart(0)
    assert tracking.now_m[0] == 0.0
    tracking.measure(ROW, np.array([(0.0, 99.0, 0.0)]), 30.0, PERIOD_S, 0.37)
    assert tracking.now_m[0] == 0.0
