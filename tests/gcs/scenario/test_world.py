"""Keys of the world: which vehicles fly on rotors, and what the vehicles' programs are told of it."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml
from scenarios import SMALL, changed, loaded, refusal

from gcs.processes.vehicles import vehicle_orders

ON_ROTORS = changed(SMALL, "sysid: 1,", "sysid: 1, plant: rotors, airframe: hummingbird,")


def test_vehicles_on_rotors_are_told_of_the_world_and_others_are_not(tmp_path: Path) -> None:
    (tmp_path / "vehicles").mkdir()
    scenario = loaded(tmp_path / "s.yaml", ON_ROTORS)
    rotors, *others = vehicle_orders(scenario, tmp_path, ())
    path = tmp_path / "vehicles" / "world.yaml"
    assert rotors.argv[rotors.argv.index("--world") + 1] == str(path)
    assert yaml.safe_load(path.read_text())["vehicles"] == {1: {"airframe": "hummingbird"}}
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
    ],
)
def test_keys_that_do_not_fit_are_refused(tmp_path: Path, keys: str, said: str) -> None:
    assert said in refusal(tmp_path / "s.yaml", changed(SMALL, "sysid: 1,", f"sysid: 1, {keys}"))
