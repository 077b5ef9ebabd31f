"""Vehicles that a scenario expects: what it must say of them, what it may not, and with which clock."""

from pathlib import Path
from typing import Any

import pytest
import yaml

from gcs.scenario.file import dump, load
from gcs.scenario.model import Scenario, ScenarioError

BLOCK = {"connect": "udpin:127.0.0.1:14550", "sysid": 3, "capacity_j": 250000}


def content(**changed: Any) -> dict[str, Any]:
    return {
        "schema": 1, "name": "strangers", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400.0},
        "goal": {"duration_s": 20.0}, "vehicles": {"pursuers": [{"external": BLOCK}]},
    } | changed  # fmt: skip


def fleet(*pursuers: dict[str, Any], **groups: Any) -> dict[str, Any]:
    return content(vehicles={"pursuers": list(pursuers), **groups})


def loaded(tmp_path: Path, said: dict[str, Any]) -> Scenario:
    file = tmp_path / "scenario.yaml"
    file.write_text(yaml.safe_dump(said), encoding="utf-8")
    return load(file)


def refusals(tmp_path: Path, said: dict[str, Any]) -> list[str]:
    with pytest.raises(ScenarioError) as error:
        loaded(tmp_path, said)
    return [problem.message for problem in error.value.problems]


def test_the_block_alone_says_enough_and_is_written_out_in_full(tmp_path: Path) -> None:
    scenario = loaded(tmp_path, content())
    (pursuer,) = scenario.vehicles.pursuers
    assert (pursuer.sysid, pursuer.battery.capacity_j) == (3, 250000.0)
    assert scenario.vehicles.external == {3: pursuer.external}
    assert scenario.vehicles.launched == ()
    assert (pursuer.external.autopilot, pursuer.external.at_end) == ("auto", "hold")  # type: ignore[union-attr]
    (tmp_path / "again.yaml").write_text(dump(scenario), encoding="utf-8")
    assert load(tmp_path / "again.yaml") == scenario


def test_system_id_and_capacity_may_stand_beside_the_block(tmp_path: Path) -> None:
    beside = {"sysid": 3, "battery": {"capacity_j": 250000}, "external": {"connect": BLOCK["connect"]}}
    assert loaded(tmp_path, fleet(beside)) == loaded(tmp_path, content())


def test_defaults_give_strangers_what_they_can_use_and_launched_vehicles_the_rest(tmp_path: Path) -> None:
    defaults = {
        "battery": {"capacity_j": 20000}, "airborne": True, "params": {"MPC_XY_VEL_MAX": 3.0}, "takeoff_m": 4.0,
        "start_m": [0, 0, -4],
    }  # fmt: skip
    said = fleet({"external": BLOCK}, {"sysid": 4}, defaults=defaults)
    stranger, own = loaded(tmp_path, said).vehicles.pursuers
    assert (stranger.takeoff_m, stranger.airborne, stranger.params, stranger.battery.capacity_j) == (
        4.0, False, {}, 250000.0,
    )  # fmt: skip
    assert (own.airborne, own.battery.capacity_j) == (True, 20000.0)


def test_many_may_share_an_address_by_way_of_defaults(tmp_path: Path) -> None:
    defaults = {"external": {"connect": BLOCK["connect"], "capacity_j": 9e4}}
    scenario = loaded(tmp_path, fleet({"sysid": 3}, {"sysid": 4}, defaults=defaults))
    assert {sysid: block.connect for sysid, block in scenario.vehicles.external.items()} == {
        3: BLOCK["connect"], 4: BLOCK["connect"],
    }  # fmt: skip


@pytest.mark.parametrize(
    ("vehicle", "message"),
    [
        ({"external": {**BLOCK, "connect": "com3:57600"}}, "must be udpin:HOST:PORT or tcpin:HOST:PORT, where the veh"),
        ({"external": {**BLOCK, "connect": "serial:/dev/ttyUSB0"}}, "or serial:DEVICE:BAUD, such as udpin:"),
        ({"external": {**BLOCK, "connect": "udpin:127.0.0.1:0"}}, "must be udpin:HOST:PORT"),
        ({"external": {k: BLOCK[k] for k in ("connect", "sysid")}}, "external lacks the key 'capacity_j'"),
        ({"external": {k: BLOCK[k] for k in ("connect", "capacity_j")}}, "pursuers[0] lacks the key 'sysid'"),
        ({"external": {**BLOCK, "autopilot": "betaflight"}}, "external.autopilot must be"),
        ({"external": {**BLOCK, "at_end": "crash"}}, "external.at_end must be"),
        ({"external": {**BLOCK, "conect": "x"}}, "unknown key 'conect'"),
        ({"sysid": 4, "external": BLOCK}, "pursuer 4 is given another sysid here: 3"),
        ({"battery": {"capacity_j": 7}, "external": BLOCK}, "pursuer 3 is given two values of capacity_j"),
        ({"airborne": True, "external": BLOCK}, "airborne is for launched vehicles; leave it out"),
        ({"velocity_m_s": [1, 0, 0], "external": BLOCK}, "velocity_m_s is for launched vehicles"),
        ({"attitude_deg": [0, 0, 90], "external": BLOCK}, "attitude_deg is for launched vehicles"),
        ({"params": {"MPC_XY_VEL_MAX": 3.0}, "external": BLOCK}, "params is for launched vehicles"),
    ],
)
def test_what_cannot_be_is_one_sentence(tmp_path: Path, vehicle: dict[str, Any], message: str) -> None:
    (said,) = refusals(tmp_path, fleet(vehicle))
    assert message in said


def test_a_stranger_as_tanker_must_be_told_where_to_wait(tmp_path: Path) -> None:
    assert refusals(tmp_path, fleet(tankers=[{"external": BLOCK}])) == [
        "tanker 3 is external: say where it waits, home_m"
    ]
    loaded(tmp_path, fleet(tankers=[{"home_m": [0, 0, -4], "external": BLOCK}]))


def test_a_strangers_place_is_where_it_is(tmp_path: Path) -> None:
    """Neither an obstacle at, nor another vehicle near, the place that it does not have."""
    said = fleet({"external": BLOCK}, {"sysid": 4, "start_m": [0, 0.4, 0], "battery": {"capacity_j": 1e4}})
    loaded(tmp_path, said | {"obstacles": [{"sphere_m": [0, -1, 0], "radius_m": 1.05}]})


def test_strangers_live_on_their_own_clock(tmp_path: Path) -> None:
    sentence = "pursuer 3 (external) lives on its own clock, which waits for no supervisor: leave out lockstep"
    assert refusals(tmp_path, content(clock={"mode": "lockstep"})) == [sentence]
    scenario = loaded(tmp_path, content())
    with pytest.raises(ValueError, match="leave out lockstep"):
        scenario.flown(lockstep=True)
    assert scenario.flown(speed=3.0, seed=4).clock.speed == 3.0  # whether they keep it is seen before they are armed


def test_control_effort_that_nobody_reports_cannot_compete(tmp_path: Path) -> None:
    target = {"sysid": 9, "battery": {"capacity_j": 1000}, "start_m": [5, 5, 0], "path_m": [[5, 5, -3]], "speed_m_s": 1}
    by_effort = fleet({"external": BLOCK}, targets=[target]) | {"pursuit": {"by": "competition", "bids": "measured"}}
    assert "external vehicles report no control effort" in refusals(tmp_path, by_effort)[0]
    assert loaded(tmp_path, by_effort | {"pursuit": {"by": "competition"}}).pursuit.bids == "predicted"
    assert refusals(tmp_path, content(competition={"bids": "effort"}))[0].endswith("or bids: need")
