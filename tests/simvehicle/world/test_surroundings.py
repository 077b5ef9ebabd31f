"""The air and the magnetic field that sensors read, against published values."""

from __future__ import annotations

import math
from datetime import UTC, datetime

import numpy as np
import pytest
from numpy.typing import NDArray

from simvehicle.world.atmosphere import air_at
from simvehicle.world.magnetic_field import field_ned_t
from simvehicle.world.sensors import PRESSURE_NOISE_PA, RATE_NOISE_RAD_S, SensorNoise


@pytest.mark.parametrize(
    ("alt_m", "pressure_pa", "celsius"),  # ISO 2533, by geopotential height
    [(0.0, 101_325.0, 15.0), (1000.0, 89_874.6, 8.5), (5000.0, 54_019.9, -17.5), (11_000.0, 22_632.1, -56.5)],
)
def test_the_air_is_that_of_the_standard_atmosphere(alt_m: float, pressure_pa: float, celsius: float) -> None:
    air = air_at(alt_m)
    assert air.pressure_pa == pytest.approx(pressure_pa, rel=1e-5)
    assert air.celsius == pytest.approx(celsius, abs=1e-9)


YEAR_2025 = datetime(2025, 1, 1, tzinfo=UTC).timestamp()


@pytest.mark.parametrize(("lat_deg", "lon_deg", "down"), [(85.76, 139.30, 1.0), (-63.85, 135.08, -1.0)])
def test_the_field_is_upright_at_the_dip_poles(lat_deg: float, lon_deg: float, down: float) -> None:
    field = np.array(field_ned_t(lat_deg, lon_deg, 0.0, YEAR_2025))
    assert field[2] * down == pytest.approx(np.linalg.norm(field), rel=1e-3)  # within 2.6 degrees
    assert 5e-5 < np.linalg.norm(field) < 7e-5


@pytest.mark.parametrize(
    ("lat_deg", "lon_deg", "declination_deg"), [(34.05, -118.24, 11.3), (35.68, 139.69, -7.9), (47.38, 8.54, 3.5)]
)
def test_a_compass_errs_as_charts_say(lat_deg: float, lon_deg: float, declination_deg: float) -> None:
    north, east, _ = field_ned_t(lat_deg, lon_deg, 100.0, YEAR_2025)  # Los Angeles, Tokyo, Zurich
    assert math.degrees(math.atan2(east, north)) == pytest.approx(declination_deg, abs=0.5)


def test_the_field_is_to_be_had_also_outside_of_the_models_years() -> None:
    before, after = (field_ned_t(47.4, 8.5, 400.0, datetime(y, 6, 1, tzinfo=UTC).timestamp()) for y in (2020, 2035))
    assert math.dist(before, after) < 2e-6


def test_noise_is_white_of_the_deviation_and_by_seed_and_vehicle() -> None:
    def drawn(seed: int, sysid: int) -> NDArray[np.float64]:
        noise = SensorNoise(seed=seed, sysid=sysid)
        return np.array([(*reading.rates, reading.pressure_pa) for reading in (noise.step() for _ in range(4000))])

    one = drawn(1, 2)
    assert one.std(axis=0) == pytest.approx([*[RATE_NOISE_RAD_S] * 3, PRESSURE_NOISE_PA], rel=0.05)
    assert np.abs(np.corrcoef(one[:-1].T, one[1:].T)).max(initial=0.0, where=~np.eye(8, dtype=bool)) < 0.08
    assert np.array_equal(one, drawn(1, 2))
    assert not np.array_equal(one, drawn(2, 2))
    assert not np.array_equal(one, drawn(1, 3))
