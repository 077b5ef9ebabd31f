"""What `gcs validate` warns of, and what it leaves alone: figures by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml
from sessions import merged, small

from gcs.cli.main import run_argv
from gcs.scenario.model import Scenario
from gcs.scenario.warnings import latency_s, stopping_m, warnings


def scenario(**changes: Any) -> Scenario:
    content = small(goal={"refuelled_at_least": 0}, refuelling={"enabled": False})
    content["vehicles"]["pursuers"].append(
        {**content["vehicles"]["pursuers"][0], "sysid": 2, "start_m": [-2.0, 0.0, 0.0]}
    )
    del content["vehicles"]["tankers"]
    content = merged(content, changes)
    for key in [key for key, value in content.items() if value is None]:
        del content[key]
    for vehicle in (v for group in content["vehicles"].values() for v in group):
        for key in ("start_m", "path_m"):
            if key in vehicle:
                vehicle[key] = tuple(tuple(p) if isinstance(p, list) else p for p in vehicle[key])
    return Scenario.model_validate(content)


def about(checked: Scenario) -> list[str]:
    return [warning.about for warning in warnings(checked)]


def test_a_scenario_whose_figures_fit_is_left_alone() -> None:
    assert warnings(scenario()) == []


def test_the_way_to_a_stand_is_latency_and_braking() -> None:
    """0.1 s + 0.37 s + 2 (0.1 + 0.05 / 2) s; at 3 m/s that times 3, and 9 / (2 · 5)."""
    slow = scenario(radio={"delay_s": 0.1, "jitter_s": 0.05})
    assert latency_s(slow) == pytest.approx(0.72)
    assert stopping_m(slow, 3.0) == pytest.approx(3.0 * 0.72 + 0.9)


@pytest.mark.parametrize(("within_m", "warned"), [(2.4, ["pursue"]), (2.5, []), (3.0, [])])
def test_a_goal_nearer_to_the_target_than_the_ring_is_warned_of(within_m: float, warned: list[str]) -> None:
    """2 m beside it and 1.5 m above: 2.5 m away."""
    goal = {"pursue": {"within_m": within_m, "for_s": 5.0}}
    assert about(scenario(goal=goal, formation={"ring_m": 2.0, "height_m": 1.5})) == warned


@pytest.mark.parametrize(("transfer", "warned"), [(None, ["refuelling"]), (True, ["refuelling"]), (False, [])])
def test_bases_that_nobody_may_use_are_warned_of(transfer: bool | None, warned: list[str]) -> None:
    content = small()
    for pursuer in content["vehicles"]["pursuers"]:
        pursuer["transfer"] = transfer
    pursuers = content["vehicles"]["pursuers"]
    bases = [{"name": "north", "position_m": (9.0, 0.0, 0.0), "stock_j": 20_000.0}]
    assert about(scenario(bases=bases, refuelling={"enabled": True}, vehicles={"pursuers": pursuers})) == warned


@pytest.mark.parametrize(("until", "warned"), [(0.5, ["refuelling"]), (0.6, ["refuelling"]), (0.61, [])])
def test_a_service_that_ends_where_the_next_is_wanted_is_warned_of(until: float, warned: list[str]) -> None:
    rules: dict[str, Any] = {"refuelling": {"enabled": True, "until": until}, "competition": {"need_from": 0.4}}
    assert about(scenario(**rules, vehicles={"tankers": small()["vehicles"]["tankers"]})) == warned
    assert about(scenario(**rules)) == [], "nobody is there to serve"


@pytest.mark.parametrize(("speed_m_s", "warned"), [(1.5, []), (2.0, []), (2.5, ["separation"]), (5.0, ["separation"])])
def test_a_speed_at_which_two_cannot_stop_in_time_is_warned_of(speed_m_s: float, warned: list[str]) -> None:
    """Head on with 0.6 m of separation and 1 m of range each: 2 (0.47 v + v²/10) is 2.6 m at 2.0 m/s, 3.6 at 2.5."""
    found = about(scenario(planner={"cruise_m_s": speed_m_s, "repulsion_range_m": 1.1}))
    assert found == warned


def test_a_pursuer_whose_place_is_its_targets_is_warned_of() -> None:
    found = warnings(scenario(formation=None))
    assert [warning.about for warning in found] == ["separation"]
    assert "formation.ring_m" in found[0].text


def test_a_ring_without_room_is_warned_of() -> None:
    """Two on a ring of 0.7 m are 1.4 m apart."""
    assert about(scenario(formation={"ring_m": 0.7}, planner={"separation_m": 0.6})) == []
    assert about(scenario(formation={"ring_m": 1.6}, planner={"separation_m": 1.5, "repulsion_range_m": 2.0})) == []
    found = about(scenario(formation={"ring_m": 0.7, "height_m": 2.0}, planner={"separation_m": 1.5}))
    assert found == ["separation"]


def test_an_obstacle_on_the_ring_is_warned_of_by_name() -> None:
    buoy = {"sphere_m": (0.0, 2.2, -2.5), "radius_m": 0.4, "name": "buoy"}
    found = warnings(scenario(obstacles=[buoy]))
    assert ["buoy" in warning.text for warning in found] == [True]
    assert about(scenario(obstacles=[{**buoy, "sphere_m": (0.0, 5.0, -2.5)}])) == []


def test_places_below_the_ground_are_warned_of_by_name() -> None:
    target = small()["vehicles"]["targets"][0]
    target["path_m"] = [[4.0, 0.0, 2.5], [4.0, 4.0, 2.5], [0.0, 0.0, -2.5]]
    (found,) = warnings(scenario(vehicles={"targets": [target]}))
    assert found.about == "ground"
    assert found.text.startswith("corner 1 of target 101 and 1 more lie below the ground, the first 2.5 m below")


def test_what_the_goal_does_not_ask_is_not_warned_of() -> None:
    assert about(scenario(formation=None, goal={"separation_m": False})) == []


def test_validate_prints_warnings_and_ends_with_0(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "sunk.yaml"
    content = small()
    del content["formation"]
    path.write_text(yaml.safe_dump(content))
    assert run_argv(["validate", str(path)]) == 0
    told = capsys.readouterr()
    assert f"{path}: warning: separation: the place of pursuer 1 is the target's own (101)" in told.err
    assert "valid" in told.out
