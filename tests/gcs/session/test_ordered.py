"""Vehicles that are ordered before their supervisor is loaded."""

import json
from pathlib import Path
from typing import Any, cast

import yaml

from gcs.processes.hatch import Hatch, ProcessSpec
from gcs.scenario.file import find, load
from gcs.session.ordered import order_early, own_keys


class Written:
    """What a hatch is told."""

    def __init__(self) -> None:
        self.orders: list[ProcessSpec] = []
        self.secret: int | None = None

    def start(self, orders: list[ProcessSpec], secret: int) -> None:
        self.orders, self.secret = orders, secret


def test_all_of_the_sessions_own_are_ordered_to_answer_on_the_link(tmp_path: Path) -> None:
    scenario = load(find("demo"))
    (tmp_path / "vehicles").mkdir()
    hatch = Written()
    ordered = order_early(scenario, tmp_path, 0.0, cast(Hatch, hatch))
    assert ordered is not None
    assert hatch.orders == ordered.orders
    assert hatch.secret == ordered.link.secret
    assert {sysid for one in ordered.orders for sysid in one.sysids} == {sysid for sysid, _ in own_keys(scenario)}
    told = {argument for one in ordered.orders for argument in one.argv if argument.startswith("udpout:")}
    assert told == {f"udpout:127.0.0.1:{ordered.link.port}"}
    ordered.link.close()


def test_where_it_cannot_be_written_nothing_is_ordered_and_the_link_is_closed(tmp_path: Path) -> None:
    hatch: Any = Written()
    assert order_early(load(find("demo")), tmp_path / "missing", 0.0, hatch) is None
    assert hatch.orders == []


def test_a_file_of_all_vehicles_is_there_whole_or_not_at_all(tmp_path: Path) -> None:
    """A directory stands where the file is written at first, as a full disk would refuse it."""
    scenario = load(find("demo"), set={"vehicles.pursuers.*.plant": "rotors"})
    folder = tmp_path / "vehicles"
    (folder / "world.yaml.new").mkdir(parents=True)
    hatch: Any = Written()
    assert order_early(scenario, tmp_path, 0.0, hatch) is None
    assert not (folder / "world.yaml").exists()
    (folder / "world.yaml.new").rmdir()
    ordered = order_early(scenario, tmp_path, 0.0, hatch)
    assert ordered is not None
    ordered.link.close()
    assert sorted(yaml.safe_load((folder / "world.yaml").read_text())["vehicles"]) == [1, 2, 3, 4, 5]
    assert not (folder / "world.yaml.new").exists()
    assert json.dumps([one.argv for one in ordered.orders]).count("--world") == 5
