"""Turbulence against the spectra of MIL-F-8785C, discrete gusts, and what the seed decides."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from rotor_vehicles import on_rotors
from scipy.interpolate import RegularGridInterpolator
from scipy.signal import welch

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.law import rows
from simvehicle.world import wind
from simvehicle.world.airframes import AIRFRAMES
from simvehicle.world.description import Air, World, WorldError, WorldVehicle, read_world
from simvehicle.world.estimate import EstimateErrors
from simvehicle.world.rows import GUST_NOISE, GUST_SIZE
from simvehicle.world.wind_field import WindField

DT_S, SPEED_M_S, HEIGHT_M, W20_M_S = 0.1, 8.0, 20.0, 7.7


def blown(steps: int, seed: int, dt_s: float = DT_S) -> np.ndarray:
    """Turbulence (steps, 3) at one height and air speed."""
    random = np.random.default_rng(seed)
    gust = wind.start_gust(random.standard_normal(GUST_SIZE))
    noise = random.standard_normal((steps, GUST_NOISE))
    out = np.empty((steps, 3))
    for k in range(steps):
        out[k] = wind.turbulence(gust, noise[k], HEIGHT_M, SPEED_M_S, W20_M_S, dt_s)
    return out


def theory(frequency_hz: np.ndarray) -> np.ndarray:
    """One-sided spectra (n, 3) in m²/s² per Hz, of MIL-F-8785C's formulas in feet, by frequency at an air speed."""
    height_ft = HEIGHT_M / 0.3048
    sigma_w = 0.1 * W20_M_S
    sigma_u = sigma_w / (0.177 + 0.000823 * height_ft) ** 0.4
    length_u = height_ft / (0.177 + 0.000823 * height_ft) ** 1.2 * 0.3048
    spatial = 2.0 * math.pi * frequency_hz / SPEED_M_S
    long_, wide, high = length_u * spatial, length_u * spatial, HEIGHT_M * spatial
    along = sigma_u**2 * 2.0 * length_u / math.pi / (1.0 + long_**2)
    across = sigma_u**2 * length_u / math.pi * (1.0 + 3.0 * wide**2) / (1.0 + wide**2) ** 2
    up = sigma_w**2 * HEIGHT_M / math.pi * (1.0 + 3.0 * high**2) / (1.0 + high**2) ** 2
    return np.stack([along, across, up], axis=1) * (2.0 * math.pi / SPEED_M_S)


def test_turbulence_has_the_spectra_of_dryden() -> None:
    series = blown(400_000, seed=1)
    frequency, spectra = welch(series, fs=1.0 / DT_S, nperseg=2048, axis=0)
    expected = theory(frequency)
    edges = np.geomspace(0.03, 1.2, 6)
    for low, high in pairwise(edges):
        band = (frequency >= low) & (frequency < high)
        assert spectra[band].mean(axis=0) == pytest.approx(expected[band].mean(axis=0), rel=0.1)


def test_turbulence_has_its_variance_at_any_step_and_from_the_start() -> None:
    sigma, sigma_w, _, _ = wind.dryden_scales(HEIGHT_M, W20_M_S)
    starts = np.array([blown(1, seed)[0] for seed in range(4000)])
    assert starts.std(axis=0) == pytest.approx([sigma, sigma, sigma_w], rel=0.05)
    fine = wind.start_gust(np.ones(5))
    coarse = fine.copy()
    for _ in range(200):
        wind.turbulence(fine, np.zeros(5), HEIGHT_M, SPEED_M_S, W20_M_S, 1e-5)
    wind.turbulence(coarse, np.zeros(5), HEIGHT_M, SPEED_M_S, W20_M_S, 2e-3)
    assert fine == pytest.approx(coarse, rel=1e-9)


def test_a_discrete_gust_rises_holds_and_falls_as_one_minus_cos() -> None:
    gusts = np.array([[10.0, 2.0, 3.0, 4.0, -2.0, 1.0]])
    at = {9.9: 0.0, 10.0: 0.0, 11.0: 0.5, 12.0: 1.0, 14.9: 1.0, 16.0: 0.5, 17.0: 0.0, 99.0: 0.0}
    for t, share in at.items():
        assert wind.discrete(gusts, t) == pytest.approx((4.0 * share, -2.0 * share, share), abs=1e-12)


def hovering(
    seed: int, sysid: int = 1, *, stretch_ms: int = 100, until_ms: int = 2000, errors: bool = True, w20: float = 7.7
) -> Vehicle:
    own = WorldVehicle(AIRFRAMES["iris"], EstimateErrors() if errors else None)
    one = on_rotors(own, Air(mean_nwu=(5.0, 2.0, 0.0), turbulence_m_s=w20), seed=seed, sysid=sysid)
    for t_ms in range(stretch_ms, until_ms + 1, stretch_ms):
        one.advance(t_ms)
    return one


def test_the_same_seed_gives_the_same_flight_however_it_is_cut_and_another_another() -> None:
    first = hovering(1)
    assert hovering(1).state.tobytes() == first.state.tobytes()
    assert hovering(2).state.tobytes() != first.state.tobytes()
    assert hovering(1, sysid=2).state.tobytes() != first.state.tobytes()
    assert hovering(1, errors=False, w20=0.0).state.tobytes() == hovering(2, errors=False, w20=0.0).state.tobytes()


def test_sensors_change_nothing_of_the_wind() -> None:
    blind, seeing = (hovering(1, errors=errors, stretch_ms=4, until_ms=4) for errors in (False, True))
    assert (blind.state[0, rows.GUST] == seeing.state[0, rows.GUST]).all()
    assert (blind.state[0, rows.WIND] == seeing.state[0, rows.WIND]).all()


def test_estimates_err_as_they_are_said_to_and_truth_stays_what_is_true() -> None:
    one = hovering(3)
    row = one.state[0]
    known = row[:12] - row[rows.ERROR]
    assert np.allclose(known[:6], row[rows.BODY][:6])
    assert one.true_motion_ned[:3] == pytest.approx(tuple(known[:3] * [1, -1, -1]))
    assert one.p_ned != one.true_motion_ned[:3]
    errors = EstimateErrors(position_s=0.5, velocity_s=0.5, attitude_s=0.5, rate_s=0.02)
    other = on_rotors(WorldVehicle(AIRFRAMES["iris"], errors), seed=4)
    seen = []
    for t_ms in range(100, 120_001, 100):
        other.set_clock(t_ms - 100, 0)
        other.advance(t_ms)
        seen.append(other.state[0, rows.ERROR].copy())
    deviations = np.std(seen, axis=0).reshape(4, 3).mean(axis=1)
    assert deviations == pytest.approx([0.3, 0.05, math.radians(0.3), math.radians(0.3)], rel=0.15)


def table(seed: int = 1) -> WindField:
    rows = np.random.default_rng(seed).uniform(-9.0, 9.0, (3 * 2 * 4, 3))
    return WindField((-20.0, 0.0, 35.0), (-5.0, 5.0), (0.0, 2.0, 10.0, 50.0), tuple(map(tuple, rows.tolist())))


def test_wind_between_places_is_theirs_in_proportion_and_beyond_them_the_edges() -> None:
    """By scipy's interpolation on the same grid; the place is held within it."""
    field = table()
    axes = (field.north_m, field.east_m, field.height_m)
    oracle = RegularGridInterpolator(axes, np.array(field.wind_m_s).reshape(3, 2, 4, 3))
    places = np.random.default_rng(2).uniform((-30.0, -8.0, -3.0), (45.0, 8.0, 60.0), (500, 3))
    places[:4] = [(-20.0, -5.0, 0.0), (35.0, 5.0, 50.0), (0.0, 0.0, 2.0), (-99.0, 99.0, 5.0)]
    held = np.clip(places, [axis[0] for axis in axes], [axis[-1] for axis in axes])
    found = [field.at_nwu((north, -east, up)) for north, east, up in places]
    assert np.array(found) * (1.0, -1.0, 1.0) == pytest.approx(oracle(held), abs=1e-12)


def test_a_table_of_one_wind_is_that_wind_and_one_that_changes_blows_by_place() -> None:
    def flown(air: Air, north_m: float) -> np.ndarray:
        one = on_rotors("iris", air, Start((north_m, 0.0, -20.0), airborne=True))
        for t_ms in range(100, 2001, 100):
            one.advance(t_ms)
        return one.state

    even = Air(turbulence_m_s=7.7, field=WindField((0.0,), (0.0,), (0.0,), ((3.0, -4.0, 0.5),)))
    mean = Air(turbulence_m_s=7.7, mean_nwu=(3.0, 4.0, 0.5))
    assert flown(even, 0.0).tobytes() == flown(mean, 0.0).tobytes()
    behind = WindField((-1.0, 1.0), (0.0,), (0.0,), ((0.0, 0.0, 0.0), (3.0, -4.0, 0.5)))
    sheltered = flown(Air(field=behind), -50.0)
    assert sheltered[0, rows.WIND] == pytest.approx([0.0, 0.0, 0.0])
    assert flown(Air(field=behind), 50.0).tobytes() == flown(Air(mean_nwu=(3.0, 4.0, 0.5)), 50.0).tobytes()


def test_a_world_that_cannot_be_is_refused() -> None:
    assert read_world({"vehicles": {3: {}}}) == World({3: WorldVehicle(AIRFRAMES["iris"])})
    for content, said in (
        ([], "the world must be keys"),
        ({"winds": {}}, "unknown key 'winds'"),
        ({"vehicles": {"x": {}}}, "'x' is no system id"),
        ({"vehicles": {1: {"airframe": "boeing"}}}, "no airframe 'boeing'"),
        ({"vehicles": {1: {"sensors": {"rate_s": -1}}}}, "sensors.rate_s is -1.0"),
        ({"vehicles": {}, "air_density_kg_m3": 0}, "air_density_kg_m3 is 0"),
        ({"vehicles": {}, "wind": {"speed_m_s": "fast"}}, "speed_m_s is 'fast'"),
        ({"vehicles": {}, "seed": -1}, "seed is '-1'"),
    ):
        with pytest.raises(WorldError, match=said.replace("(", r"\(")):
            read_world(content)
