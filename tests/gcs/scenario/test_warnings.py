"""What `gcs validate` warns of, and what it leaves alone: figures by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml
from sessions import fly, merged, small

from gcs.cli.main import run_argv
from gcs.scenario.accuracy import spreads_m
from gcs.scenario.file import find, load
from gcs.scenario.model import Scenario
from gcs.scenario.warnings import warnings
from gcs.scenario.warnings.distances import latency_s, stopping_m


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


def uncertain(error_m: float | None, **changes: Any) -> Scenario:
    """Two on the ground 2 m apart, and their target, which know their places to so much."""
    document = scenario(**changes).model_dump(exclude_unset=True)
    if error_m is not None:
        for vehicle in (v for group in document["vehicles"].values() for v in group):
            vehicle |= {"plant": "rotors", "sensors": {"position_m": error_m}}
    return Scenario.model_validate(document)


def test_places_without_room_for_what_vehicles_do_not_know_are_warned_of() -> None:
    assert about(uncertain(None)) == about(uncertain(0.01)) == []
    said = [one.text for one in warnings(uncertain(0.3)) if one.about == "accuracy"]
    assert any(" start 2.00 m apart" in text and "(planner.confidence 0.999)" in text for text in said), said
    near = uncertain(0.3, obstacles=[{"point_m": (-2.0, 0.3, -1.0), "name": "mast"}])
    assert any("the way up of pursuer 2 is 0.30 m from" in one.text for one in warnings(near)), warnings(near)
    (loose,) = [one.text for one in warnings(uncertain(0.3, planner={"safety": False})) if one.about == "accuracy"]
    assert "without the safety filter" in loose


@pytest.mark.parametrize(("ring_m", "warned"), [(1.0, True), (5.0, False)])
def test_a_ring_without_room_for_what_vehicles_do_not_know_is_warned_of(ring_m: float, warned: bool) -> None:
    said = [one.text for one in warnings(uncertain(0.2, formation={"ring_m": ring_m})) if "on the ring" in one.text]
    assert bool(said) == warned


def test_the_way_to_a_stand_is_latency_and_braking() -> None:
    """0.1 s + 0.37 s + 2 (0.1 + 0.05 / 2) s; at 3 m/s that times 3, and 9 / (2 · 5)."""
    slow = scenario(radio={"delay_s": 0.1, "jitter_s": 0.05})
    assert latency_s(slow) == pytest.approx(0.72)
    assert stopping_m(slow, 3.0) == pytest.approx(3.0 * 0.72 + 0.9)


@pytest.mark.parametrize(("gains", "airborne"), [(1, False), (1, True), (0, False)])
def test_gains_that_do_not_take_off_are_warned_of(gains: int, airborne: bool, tmp_path: Path) -> None:
    content = small(goal={"duration_s": 8.0, "refuelled_at_least": 0})
    pursuer = content["vehicles"]["pursuers"][0]
    pursuer |= {"params": {"SIM_GAIN_SET": gains}, "airborne": airborne, "start_m": [2.0, 0.0, -2.0 * airborne]}
    flown = fly(content, tmp_path)
    stays = flown.truth(1).p_ned[:, 2].min() == 0.0
    assert ("take-off" in about(load(tmp_path / "scenario.yaml"))) == stays == (gains == 1 and not airborne)


@pytest.mark.parametrize(("within_m", "warned"), [(2.4, ["pursue"]), (2.5, []), (3.0, [])])
def test_a_goal_nearer_to_the_target_than_the_ring_is_warned_of(within_m: float, warned: list[str]) -> None:
    """2 m beside it and 1.5 m above: 2.5 m away."""
    goal = {"pursue": {"within_m": within_m, "for_s": 5.0}}
    assert about(scenario(goal=goal, formation={"ring_m": 2.0, "height_m": 1.5})) == warned


@pytest.mark.parametrize(
    ("changes", "warned"),
    [
        ({"reserve_j": 3_000.0}, "3000 J (reserve_j), and lands by itself below 3000 J, 5 % of its battery"),
        ({"reserve_j": 3_001.0}, None),
        ({"reserve_j": 10_000.0}, None),
        ({"reserve_j": 10_000.0, "params": {"BAT_EMERGEN_THR": 0.2}}, "10000 J (reserve_j), and lands by itself below "
         "12000 J, 20 % of its battery"),
        ({"reserve_j": 3_000.0, "params": {"BAT_EMERGEN_THR": 0.0}}, None),
        ({"reserve_j": 3_000.0, "battery": {"capacity_j": 300_000.0}}, None),  # of which 2210 W for 40 s leave 212 kJ
    ],
)  # fmt: skip
def test_a_reserve_at_which_a_tanker_lands_is_warned_of(changes: dict[str, Any], warned: str | None) -> None:
    """A twentieth of 60 kJ is 3 kJ."""
    tanker = small()["vehicles"]["tankers"][0] | {"battery": {"capacity_j": 60_000.0}} | changes
    said = warnings(scenario(refuelling={"enabled": True}, vehicles={"tankers": [tanker]}))
    assert [one.text for one in said] == (
        []
        if warned is None
        else [f"tanker 201 gives until it holds {warned}: it is lost soon after that; raise reserve_j"]
    )
    assert warnings(scenario(vehicles={"tankers": [tanker]})) == []  # with refuelling off


def test_of_several_reserves_the_first_is_named() -> None:
    tanker = small()["vehicles"]["tankers"][0] | {"battery": {"capacity_j": 60_000.0}, "reserve_j": 1_000.0}
    second = tanker | {"sysid": 250, "start_m": [9.0, 9.0, 0.0]}
    (one,) = warnings(scenario(refuelling={"enabled": True}, vehicles={"tankers": [tanker, second]}))
    assert one.about == "refuelling"
    assert "1000 J (reserve_j), the first of 2 such tankers, and lands by itself below 3000 J" in one.text


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
    rules = {"cruise_m_s": speed_m_s, "repulsion_range_m": 1.1}
    assert about(scenario(planner={**rules, "safety": False})) == warned
    assert about(scenario(planner=rules)) == [], "the safety filter keeps them apart"


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
    unfiltered = {"planner": {"safety": False}}
    found = warnings(scenario(obstacles=[buoy], **unfiltered))
    assert ["buoy" in warning.text for warning in found] == [True]
    assert about(scenario(obstacles=[buoy])) == [], "the safety filter leads around it"
    wall = {"box_m": [(-3.0, -9.0, -9.0), (9.0, 9.0, -1.0)], "name": "wall"}
    rings = [one.text for one in warnings(scenario(obstacles=[wall])) if one.text.startswith("the ring of 2 m")]
    assert len(rings) == 1, "most of the ring is inside"
    assert about(scenario(obstacles=[{**buoy, "sphere_m": (0.0, 5.0, -2.5)}], **unfiltered)) == []


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


def test_strict_makes_warnings_errors(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "sunk.yaml"
    content = small()
    del content["formation"]
    path.write_text(yaml.safe_dump(content))
    assert run_argv(["validate", str(path), "--strict"]) == 2
    told = capsys.readouterr()
    assert f"{path}: error: separation: the place of pursuer 1 is the target's own (101)" in told.err
    assert "valid" not in told.out
    assert run_argv(["run", str(path), "--strict", "--out", str(tmp_path / "flown")]) == 2
    assert f"{path}: error: separation:" in capsys.readouterr().err
    assert not (tmp_path / "flown").exists()


@pytest.mark.parametrize("name", ["demo", "fleet", "pursuit"])
def test_the_scenarios_that_come_along_are_not_warned_of(name: str) -> None:
    assert warnings(load(find(name))) == []


def _target(**changes: Any) -> dict[str, Any]:
    return {"vehicles": {"targets": [{**small()["vehicles"]["targets"][0], **changes}]}}


@pytest.mark.parametrize(("percent", "warned"), [(0.45, ["battery"]), (1.0, ["battery"]), (1.5, []), (45.0, [])])
def test_a_share_for_per_cent_is_warned_of(percent: float, warned: list[str]) -> None:
    battery = {"capacity_j": 40_000.0, "initial_percent": percent}
    assert about(scenario(**_target(battery=battery))) == warned


@pytest.mark.parametrize(("speed_m_s", "params", "warned"), [
    (1.5, {}, []), (1.6, {}, ["speed"]), (5.0, {}, ["speed"]), (30.0, {}, ["speed", "speed"]),
    (12.0, {"MPC_XY_VEL_MAX": 12.0}, ["speed"]), (12.1, {"MPC_XY_VEL_MAX": 12.0}, ["speed", "speed"]),
])  # fmt: skip
def test_speeds_that_are_not_flown_or_not_followed_are_warned_of(
    speed_m_s: float, params: dict[str, float], warned: list[str]
) -> None:
    """Pursuers are planned to at 1.5 m/s at most; a launched vehicle flies 5 m/s at most, or what it is set to."""
    path = [[0.0, 0.0, -2.5], [3.0, 0.0, -2.5]]
    assert about(scenario(**_target(speed_m_s=speed_m_s, params=params, path_m=path))) == warned


@pytest.mark.parametrize(("corner_m", "warned"), [(60.0, []), (80.0, []), (81.0, ["path"]), (8000.0, ["path"])])
def test_a_path_of_which_less_than_half_is_flown_is_warned_of(corner_m: float, warned: list[str]) -> None:
    """40 s at 1 m/s."""
    path = [[0.0, 0.0, -2.5], [corner_m, 0.0, -2.5]]
    changes = _target(path_m=path, speed_m_s=1.0) | {"goal": {"duration_s": 40.0}}
    assert about(scenario(**changes)) == warned


@pytest.mark.parametrize(("laps", "length_m", "warned"), [
    ({}, 9.0, ["path"]), ({}, 10.0, []), ({"laps": 1}, 9.0, []), ({"laps": 3}, 9.0, []),
])  # fmt: skip
def test_a_closed_path_that_is_flown_once_and_soon_over_is_warned_of(
    laps: dict[str, int], length_m: float, warned: list[str]
) -> None:
    """To and fro over 9 m at 1 m/s is 18 s of 40."""
    path = [[0.0, 0.0, -2.5], [length_m, 0.0, -2.5]]
    changes = _target(path_m=path, speed_m_s=1.0, closed=True, **laps) | {"goal": {"duration_s": 40.0}}
    found = warnings(scenario(**changes))
    assert [warning.about for warning in found] == warned
    assert all("hovers until the end at 40 s" in warning.text and "3 to fill" in warning.text for warning in found)


@pytest.mark.parametrize(("far_m", "warned"), [(59.9, []), (60.1, ["waypoints"])])
def test_way_points_out_of_reach_are_warned_of(far_m: float, warned: list[str]) -> None:
    """1.5 m/s for 40 s is 60 m."""
    way = {"start_m": (0.0, 8.0, 0.0), "waypoints_m": ((far_m, 8.0, -1.0),)}
    pursuers = [{**small()["vehicles"]["pursuers"][0], **way}]
    changes = {"vehicles": {"pursuers": pursuers}, "goal": {"duration_s": 40.0}}
    assert about(scenario(**changes)) == warned


def test_degrees_for_metres_are_warned_of() -> None:
    origin = small()["origin"]
    there = (round(origin["lat_deg"], 3), round(origin["lon_deg"], 3))
    bases = [{"name": "north", "position_m": (*there, 0.0), "stock_j": 20_000.0}]
    (found,) = (warning for warning in warnings(scenario(bases=bases)) if warning.about == "place")
    assert found.text.startswith(f"base north is [{there[0]:g}, {there[1]:g}] m from the origin")
    assert "place" not in about(scenario(bases=[{**bases[0], "position_m": (there[0], there[1] + 2.0, 0.0)}]))


BALL = {"name": "ball", "sphere_m": (4.0, 0.0, -2.0), "radius_m": 0.5}


def alone(obstacles: list[dict[str, Any]] | None = None, **changes: Any) -> Scenario:
    """One pursuer with a way point 6 m north of its start."""
    content = small(goal={"refuelled_at_least": 0}, obstacles=obstacles or [])
    pursuer = {
        "sysid": 1,
        "start_m": (4.0, 0.0, 0.0),
        "waypoints_m": ((10.0, 0.0, -2.5),),
        "battery": {"capacity_j": 24_000.0},
    }
    content["vehicles"] = {"pursuers": [merged(pursuer, changes.pop("vehicle", {}))]}
    del content["formation"]
    return Scenario.model_validate(merged(content, changes))


@pytest.mark.parametrize(("north_m", "said"), [
    (4.0, "the way up of pursuer 1 leads through the obstacle ball, and 0.2 m are kept (planner.clearance_m)"),
    (4.6, "the way up of pursuer 1 is 0.10 m from the obstacle ball, and 0.2 m are kept (planner.clearance_m)"),
    (4.71, None),
])  # fmt: skip
def test_an_obstacle_in_the_way_up_is_warned_of(north_m: float, said: str | None) -> None:
    found = warnings(alone([{**BALL, "sphere_m": (north_m, 0.0, -2.0)}]))
    assert [one.about for one in found] == ["clearance"] * (said is not None)
    assert all(one.text.startswith(said or "") for one in found)


def test_a_way_up_ends_where_the_vehicle_has_taken_off_and_there_is_none_in_the_air() -> None:
    """The ball's underside is 1.5 m up."""
    assert about(alone([BALL], vehicle={"takeoff_m": 1.2})) == []
    assert about(alone([BALL], vehicle={"takeoff_m": 1.4})) == ["clearance"]
    assert about(alone([BALL], vehicle={"airborne": True})) == []


def test_a_place_in_an_obstacle_is_warned_of_once_by_name() -> None:
    there = {**BALL, "sphere_m": (10.0, 0.0, -2.2)}
    (found,) = warnings(alone([there]))
    assert found.text.startswith("way point 1 of pursuer 1 is inside the obstacle ball, and 0.2 m are kept")
    (both,) = warnings(alone([BALL, there]))
    assert "the nearest of 2 such places" in both.text
    (one,) = warnings(alone([there], vehicle={"plant": "rotors", "sensors": {"position_m": 0.1}}))
    assert one.about == "clearance", "what is too near for any vehicle is not said again of one that is not sure"


@pytest.mark.parametrize(("east_m", "rules", "warned"), [
    (0.65, {}, ["clearance"]), (0.75, {}, []), (0.75, {"planner": {"clearance_m": 0.3}}, ["clearance"]),
    (0.65, {"planner": {"safety": False, "clearance_m": 9.0}}, []),
    (0.55, {"planner": {"safety": False}}, ["clearance"]),
    (0.55, {"planner": {"safety": False}, "goal": {"clearance_m": False}}, []),
    (0.75, {"goal": {"clearance_m": 0.3}}, ["clearance"]),
])  # fmt: skip
def test_places_are_held_against_what_is_kept_or_wanted(
    east_m: float, rules: dict[str, Any], warned: list[str]
) -> None:
    """The ball's surface is 0.5 m from its centre; without the safety filter only the goal wants a distance."""
    assert about(alone([{**BALL, "sphere_m": (10.0, east_m, -2.5)}], **rules)) == warned


def gap(wide_m: float, *, sensors: bool = True, **changes: Any) -> list[str]:
    """Warnings of a way that leads straight through a gap of such width, by a vehicle that knows its place to 0.2 m."""
    half_m = 0.5 * wide_m
    walls: list[dict[str, Any]] = [
        {"name": "left", "box_m": [(6.0, -9.0, -9.0), (7.0, -half_m, 0.0)]},
        {"name": "right", "box_m": [(6.0, half_m, -9.0), (7.0, 9.0, 0.0)]},
    ]
    vehicle = {"plant": "rotors", "sensors": {"position_m": 0.2}} if sensors else {}
    found = warnings(alone(walls, vehicle=vehicle | changes))
    return [one.text for one in found if "straight between" in one.text]


def test_a_gap_without_room_for_what_vehicles_do_not_know_is_warned_of() -> None:
    (text,) = gap(1.0)
    assert "pursuer 1 to way point 1 leads straight between the obstacles left and right, which leave 1.00 m: " in text
    kept_m = alone(vehicle={"plant": "rotors", "sensors": {"position_m": 0.2}})
    wide_m = 2.0 * (kept_m.planner.clearance_m + max(spreads_m(kept_m).values()))
    assert gap(wide_m - 0.02)
    assert not gap(wide_m + 0.02)
    assert not gap(1.0, sensors=False)


@pytest.mark.parametrize("way_m", [
    ((5.0, 0.0, -2.5), (4.0, 0.0, -2.5)), ((6.5, -4.0, -12.0), (6.5, 4.0, -12.0)), ((5.0, 3.0, -2.5),),
    ((5.0, 0.0, -12.0), (12.0, 0.0, -12.0)),
])  # fmt: skip
def test_a_way_that_ends_before_a_gap_or_leads_over_it_is_left_alone(way_m: tuple[Any, ...]) -> None:
    assert not gap(1.0, waypoints_m=way_m)


def test_a_battery_that_is_empty_at_once_is_warned_of() -> None:
    """200 W and 10 W draw 2100 J in 10 s."""
    found = warnings(alone(vehicle={"battery": {"capacity_j": 24.0}}))
    assert [one.about for one in found] == ["battery"]
    assert found[0].text.startswith("pursuer 1 hovers for 0.1 s with its full battery")
    assert "24 Wh are 86400 J" in found[0].text
    assert about(alone(vehicle={"battery": {"capacity_j": 2099.0}})) == ["battery"]
    assert about(alone(vehicle={"battery": {"capacity_j": 2100.0}})) == []


@pytest.mark.parametrize(("radio", "warned"), [
    ({"delay_s": 5.0}, 0), ({"delay_s": 5.1}, 1), ({"blackouts": ({"sysid": 1, "from_s": 39.0, "to_s": 99.0},)}, 0),
    ({"blackouts": ({"sysid": 1, "from_s": 40.0, "to_s": 99.0},)}, 1),
    ({"ground_blackouts": ({"from_s": 41.0, "to_s": 42.0}, {"from_s": 50.0, "to_s": 52.0})}, 1),
])  # fmt: skip
def test_radio_faults_that_fit_no_session_are_warned_of(radio: dict[str, Any], warned: int) -> None:
    """The session lasts 40 s."""
    assert about(alone(radio=radio)).count("radio") == warned
