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


def test_all_of_the_sessions_own_are_to_answer_on_its_link_and_have_its_secret(tmp_path: Path) -> None:
    (tmp_path / "vehicles").mkdir()
    server = Written()
    own = OwnVehicles(load(find("demo")), tmp_path, server=cast(ForkServer, server))
    assert {sysid for order in own.orders for sysid in order.sysids} == {sysid for sysid, _ in own.keys}
    assert len(server.orders) == len(own.orders) == 8
    assert {order["secret"] for order in server.orders} == {own.link.secret}
    given = {argument for order in server.orders for argument in order["argv"] if argument.startswith("udpout:")}
    assert given == {f"udpout:127.0.0.1:{own.link.port}"}
    own.link.close()


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
