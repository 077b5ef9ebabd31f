"""Warnings of plan B's heights, by hand: heights that the scenario gives, and the greatest height."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

from gcs.cli.main import run_argv
from gcs.planner.returns.warnings import warnings
from gcs.scenario.file import find, load
from gcs.scenario.model import Scenario

TOWER = {"name": "tower", "cylinder_m": [5.0, 0.0], "radius_m": 0.5, "bottom_m": 0.0, "top_m": -15.0}


def content(count: int = 1, altitude_m: float | None = None, up_m: float = 4.0, **changed: Any) -> dict[str, Any]:
    """A row of pursuers, 3 m apart, whose way points 10 m north are in the opposite order."""
    params = {} if altitude_m is None else {"RTL_RETURN_ALT": altitude_m}
    pursuers = [
        {
            "sysid": i + 1,
            "start_m": [0.0, 3.0 * i, 0.0],
            "waypoints_m": [[10.0, 3.0 * (count - 1 - i), -up_m]],
            "battery": {"capacity_j": 60000.0},
            "params": params,
        }
        for i in range(count)
    ]
    plain: dict[str, Any] = {
        "schema": 1,
        "name": "row",
        "axes": "ned",
        "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400.0},
        "goal": {"duration_s": 300.0},
        "vehicles": {"pursuers": pursuers},
    }
    return plain | changed


def said(**changed: Any) -> list[str]:
    return [one.text for one in warnings(Scenario.model_validate(content(**changed)))]


@pytest.mark.parametrize("count", [1, 2, 12])
def test_heights_that_are_left_to_plan_b_are_not_warned_of(count: int) -> None:
    assert said(count=count, up_m=8.0, obstacles=[TOWER]) == []


def test_one_given_height_of_several_is_warned_of_with_their_names() -> None:
    (text,) = said(count=5, altitude_m=20.0)
    assert text.startswith("pursuer 1, pursuer 2, pursuer 3 and 2 more return at one height, 20 m, ")
    assert "leave RTL_RETURN_ALT out of their params" in text
    (pair,) = said(count=2, altitude_m=20.0)
    assert pair.startswith("pursuer 1 and pursuer 2 return at one height")
    assert said(count=2, altitude_m=20.0, planner={"vehicles_repel": False}) == []


@pytest.mark.parametrize("safety", [True, False])
@pytest.mark.parametrize(("altitude_m", "low"), [(7.9, True), (8.0, False)])
def test_a_given_height_below_a_place_is_warned_of(altitude_m: float, low: bool, safety: bool) -> None:
    found = said(altitude_m=altitude_m, up_m=8.0, planner={"safety": safety})
    assert len(found) == low
    assert all("(pursuer 1 at 7.9 m, highest place at 8 m): leave RTL_RETURN_ALT out" in text for text in found)


@pytest.mark.parametrize("safety", [True, False])
@pytest.mark.parametrize(("altitude_m", "north_m", "low"), [
    (14.0, 5.0, True), (15.3, 5.0, False), (14.0, 30.0, False),
])  # fmt: skip
def test_a_given_height_below_an_obstacle_on_the_way_home_is_warned_of(
    altitude_m: float, north_m: float, low: bool, safety: bool
) -> None:
    tower = {**TOWER, "cylinder_m": [north_m, 0.6]}
    found = said(altitude_m=altitude_m, obstacles=[tower], planner={"safety": safety})
    assert len(found) == low
    assert all("(pursuer 1 at 14 m, tower at 15 m): leave RTL_RETURN_ALT out" in text for text in found)


def test_an_obstacle_that_hangs_above_the_way_home_is_left_alone() -> None:
    assert said(altitude_m=6.0, obstacles=[{"name": "lamp", "sphere_m": [5.0, 0.0, -9.0], "radius_m": 0.5}]) == []


def test_followers_are_sent_to_where_their_target_is() -> None:
    row = content(altitude_m=6.0)
    (pursuer,) = row["vehicles"]["pursuers"]
    del pursuer["waypoints_m"]
    target = {k: v for k, v in pursuer.items() if k != "params"} | {"sysid": 9, "start_m": [0.0, 30.0, 0.0]}
    target |= {"path_m": [[0.0, 30.0, -8.0]], "speed_m_s": 1.0}
    row["vehicles"]["targets"], row["formation"] = [target], {"ring_m": 2.0, "height_m": 1.0}
    (text,) = [one.text for one in warnings(Scenario.model_validate(row))]
    assert "(pursuer 1 at 6 m, highest place at 9 m)" in text


def test_the_end_of_all_heights_is_warned_of() -> None:
    shared, low = said(count=3, up_m=160.0)
    assert shared.startswith("pursuer 1, pursuer 2 and pursuer 3 return at one height, 150 m")
    assert "heights end at 150 m" in shared
    assert "highest place at 160 m): RTL_RETURN_ALT is 150 m at most, so move the places" in low
    (many,) = said(count=120, planner={"separation_m": 1.5})
    assert "heights end at 150 m" in many


@pytest.mark.parametrize("name", ["demo", "pursuit", *(f"paper/example{k}" for k in (1, 2, 3, 4))])
def test_scenarios_that_come_along_are_not_warned_of(name: str) -> None:
    assert list(warnings(load(find(name)))) == []


def test_validate_and_run_say_it_and_strict_refuses_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "row.yaml"
    path.write_text(yaml.safe_dump(content(count=2, altitude_m=20.0)))
    assert run_argv(["validate", "-q", str(path)]) == 0
    assert f"{path}: warning: plan B: pursuer 1 and pursuer 2 return" in capsys.readouterr().err
    assert run_argv(["validate", "-q", "--strict", str(path)]) == 2
    capsys.readouterr()
    assert run_argv(["run", "--strict", str(path), "--out", str(tmp_path / "flown")]) == 2
    assert f"{path}: error: plan B: " in capsys.readouterr().err
