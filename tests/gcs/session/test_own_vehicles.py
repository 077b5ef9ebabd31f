"""A session's own vehicles: what their fork server is given, and the files that they read."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, cast

import pytest
import yaml

from gcs.processes.fork_server import ForkServer
from gcs.scenario.file import find, load
from gcs.session.own_vehicles import OwnVehicles


class Written:
    """What a fork server is given."""

    def __init__(self) -> None:
        self.orders: list[Mapping[str, Any]] = []

    def start(self, orders: Sequence[Mapping[str, Any]]) -> None:
        self.orders += orders

    def close(self) -> None:
        """Nothing runs."""


def test_a_file_of_all_vehicles_is_there_whole_or_not_at_all(tmp_path: Path) -> None:
    """A directory stands where the file is written at first, as a full disk would refuse it."""
    scenario = load(find("demo"), set={"vehicles.pursuers.*.plant": "rotors"})
    folder = tmp_path / "vehicles"
    (folder / "world.yaml.new").mkdir(parents=True)
    server = Written()
    with pytest.raises(IsADirectoryError):
        OwnVehicles(scenario, tmp_path, server=cast(ForkServer, server))
    assert not server.orders
    assert not (folder / "world.yaml").exists()
    (folder / "world.yaml.new").rmdir()
    OwnVehicles(scenario, tmp_path, server=cast(ForkServer, server)).link.close()
    assert sorted(yaml.safe_load((folder / "world.yaml").read_text())["vehicles"]) == [1, 2, 3, 4, 5]
    assert not (folder / "world.yaml.new").exists()
    assert sum("--world" in order["argv"] for order in server.orders) == 5
