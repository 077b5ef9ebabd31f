"""Errors of sensors: their statistics, and that they are the seed's and the vehicle's own."""

from __future__ import annotations

import numpy as np
import pytest

from simvehicle.world.estimate import EstimateErrors
from simvehicle.world.sensors import SensorErrors

DT_S = 0.004


def series(steps: int, *, seed: int = 3, sysid: int = 2, errors: EstimateErrors | None = None) -> np.ndarray:
    """(steps, 15)"""
    sensors = SensorErrors(errors or EstimateErrors(), DT_S, seed=seed, sysid=sysid)
    return np.array([np.concatenate(sensors.step()) for _ in range(steps)])


def test_each_has_its_deviation_and_its_correlation_time() -> None:
    times = {f"{name}_s": 0.02 for name in ("position", "velocity", "attitude", "rate", "accel")}
    errors = EstimateErrors(position_m=2.0, velocity_m_s=0.5, attitude_deg=1.0, rate_deg_s=3.0, accel_m_s2=0.2, **times)
    found = series(60_000, errors=errors)
    wanted = np.repeat([2.0, 0.5, np.radians(1.0), np.radians(3.0), 0.2], 3)
    assert found.std(axis=0) == pytest.approx(wanted, rel=0.05)
    assert np.abs(found.mean(axis=0) / wanted).max() < 0.06
    later = 5  # steps of one correlation time: e to the -1 is left
    for column in found.T:
        assert np.corrcoef(column[:-later], column[later:])[0, 1] == pytest.approx(np.exp(-1.0), abs=0.03)


def test_seed_and_vehicle_decide() -> None:
    assert np.array_equal(series(50), series(50))
    assert not np.array_equal(series(50), series(50, seed=4))
    assert not np.array_equal(series(50), series(50, sysid=3))
