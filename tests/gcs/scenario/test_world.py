"""Keys of the world: which vehicles fly on rotors, and what the vehicles' programs are told of it."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml
from scenarios import SMALL, changed, loaded, refusal

from gcs.processes.vehicles import vehicle_orders
from simvehicle.world.airframes import AIRFRAMES
from simvehicle.world.description import WorldVehicle, read_world
from simvehicle.world.estimate import EstimateErrors

KEYS = "sysid: 1, plant: rotors, airframe: hummingbird, sensors: {position_m: 0.5},"
WEATHER = """wind:
  speed_m_s: 8
  from_deg: 270
  turbulence_m_s: 7.7
  gusts: [{at_s: 3, rise_s: 0.5, hold_s: 2, speed_m_s: 4, up_m_s: 1}]
  field: {height_m: [0, 10], wind_m_s: [[0, 0, 0], [-2, 3, 0.5]]}
air_density_kg_m3: 1.1
"""
"""West wind blows towards the east, and east is -y in nwu axes."""
OHM = changed(SMALL, "capacity_j: 1000}", "capacity_j: 1000, resistance_ohm: 0.1}")
ON_ROTORS = changed(OHM, "sysid: 1,", KEYS) + WEATHER


def test_vehicles_on_rotors_are_told_of_the_world_and_others_are_not(tmp_path: Path) -> None:
    (tmp_path / "vehicles").mkdir()
    scenario = loaded(tmp_path / "s.yaml", ON_ROTORS)
    rotors, *others = vehicle_orders(scenario, tmp_path, ())
    path = tmp_path / "vehicles" / "world.yaml"
    assert rotors.argv[rotors.argv.index("--world") + 1] == str(path)
    told = read_world(yaml.safe_load(path.read_text()))
    assert told.vehicles == {1: WorldVehicle(AIRFRAMES["hummingbird"], EstimateErrors(position_m=0.5), 0.1)}
    assert told.seed == 1
    assert told.air.density_kg_m3 == 1.1
    assert told.air.mean_nwu == pytest.approx((0.0, -8.0, 0.0), abs=1e-12)
    assert told.air.turbulence_m_s == 7.7
    assert told.air.mean_at_nwu((50.0, 9.0, 5.0)) == pytest.approx((-1.0, -9.5, 0.25), abs=1e-12)
    assert told.air.gusts_nwu[0] == pytest.approx((3.0, 0.5, 2.0, -4.0, 0.0, 1.0), abs=1e-12)
    assert all("--world" not in other.argv for other in others)


def test_without_rotors_there_is_no_world(tmp_path: Path) -> None:
    (tmp_path / "vehicles").mkdir()
    orders = vehicle_orders(loaded(tmp_path / "s.yaml", SMALL), tmp_path, ())
    assert all("--world" not in order.argv for order in orders)
    assert not (tmp_path / "vehicles" / "world.yaml").exists()


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        ("airframe: iris,", "pursuer 1 has an airframe; it needs 'plant: rotors'"),
        ("plant: rotors, airframe: boeing,", "boeing"),
        ("plant: rotor,", "rotor"),
        ("sensors: {},", "pursuer 1 has sensors; it needs 'plant: rotors'"),
    ],
)
def test_keys_that_do_not_fit_are_refused(tmp_path: Path, keys: str, said: str) -> None:
    assert said in refusal(tmp_path / "s.yaml", changed(SMALL, "sysid: 1,", f"sysid: 1, {keys}"))


@pytest.mark.parametrize(
    ("field", "said"),
    [
        ("{height_m: [0, 10], wind_m_s: [[1, 2, 3]]}", "wind_m_s has 1 rows, but 1 x 1 x 2 places need 2"),
        ("{north_m: [5, 5], wind_m_s: [[1, 2, 3], [1, 2, 3]]}", "must ascend"),
        ("{wind_m_s: [[99, 2, 3]]}", "less than or equal to 60"),
    ],
)
def test_a_table_of_wind_that_does_not_fit_is_refused(tmp_path: Path, field: str, said: str) -> None:
    text = changed(SMALL, "sysid: 1,", "sysid: 1, plant: rotors,") + f"wind: {{field: {field}}}\n"
    assert said in refusal(tmp_path / "s.yaml", text)


def test_weather_without_rotors_is_refused_and_is_random_only_where_it_is(tmp_path: Path) -> None:
    path = tmp_path / "s.yaml"
    assert "wind moves vehicles with 'plant: rotors'" in refusal(path, SMALL + "wind: {speed_m_s: 5}\n")
    assert "air_density_kg_m3 is for vehicles" in refusal(path, SMALL + "air_density_kg_m3: 1.0\n")
    assert loaded(path, ON_ROTORS).random_weather
    calm = changed(SMALL, "sysid: 1,", "sysid: 1, plant: rotors,") + "wind: {speed_m_s: 8}\n"
    assert not loaded(path, calm).random_weather
    assert loaded(path, changed(calm, "plant: rotors,", "plant: rotors, sensors: {},")).random_weather
