"""Command lines and files for the fork server: plain data, read back as the vehicle's process reads them."""

from pathlib import Path
from typing import Any

import pytest
import yaml
from extremes import extremes, number_keys

from gcs.mavlink.parameters import renames
from gcs.planner.failsafes import failsafes_of
from gcs.processes.fork_server import Ended, ProcessSpec
from gcs.processes.vehicles import vehicle_order, vehicle_orders, vehicle_parameters
from gcs.scenario.file import load, shipped_folder
from gcs.scenario.model import Scenario, ScenarioError, VehicleBase
from simvehicle.autopilot.parameters import Parameters

LINK = ("--supervised", "udpout:127.0.0.1:5000")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "vehicles").mkdir()
    return tmp_path


def scenario(**changed: Any) -> Scenario:
    battery = {"capacity_j": 24_000.0, "initial_percent": 60.0, "hover_w": 180.0, "avionics_w": 12.0}
    return Scenario.model_validate({
        "schema": 1, "name": "l", "axes": "ned", "origin": {"lat_deg": 47.25, "lon_deg": -8.5, "alt_m": 400.5},
        "goal": {"duration_s": 60.0}, "refuelling": {"capture_m": 1.75, "relative_speed_m_s": 0.25},
        "vehicles": {"pursuers": [
            {"sysid": 3, "start_m": (-1.5, 2.0, -3.25), "velocity_m_s": (-1.0, 0.5, 0.0), "airborne": True,
             "attitude_deg": (-5.0, 10.0, 90.0), "battery": battery,
             "params": {"SIM_XFER_DIST": 2.5, "MPC_TILTMAX_AIR": 30.0}},
            {"sysid": 4, "start_m": (9.0, 9.0, 0.0), "battery": battery},
        ]},
        "traffic": [{"callsign": "NORTH1", "path_m": [(1.0, -2.0, -3.0), (4.0, 5.0, -6.0)], "speed_m_s": 0.5,
                     "closed": True, "start_s": 10.0}],
    } | changed)  # fmt: skip


def parameters_of(vehicle: VehicleBase, world: Scenario) -> dict[str, float]:
    return vehicle_parameters(vehicle, world, failsafes_of(world)[vehicle.sysid])


def options(order: ProcessSpec) -> dict[str, str | None]:
    """An option's value by its name; None for a flag."""
    words, found = list(order.argv), {}
    while words:
        name = words.pop(0)
        assert name.startswith("--")
        takes_value = words and not words[0].startswith("--")
        found[name] = words.pop(0) if takes_value else None
    return found


def test_a_vehicles_argv_says_all_of_the_scenario(folder: Path) -> None:
    world = scenario()
    order = vehicle_order([world.vehicles.pursuers[0]], world, folder, LINK, failsafes_of(world))
    assert (order.sysid, order.log) == (3, folder / "vehicles" / "3.log")
    assert options(order) == {
        "--sysid": "3",
        "--supervised": "udpout:127.0.0.1:5000",
        "--position": "-1.5,2.0,-3.25",
        "--velocity": "-1.0,0.5,0.0",
        "--attitude": "-5.0,10.0,90.0",
        "--home": "47.25,-8.5,400.5",
        "--params": str(folder / "vehicles" / "3.params.yaml"),
        "--airborne": None,
        "--separation": str(folder / "vehicles" / "separation.json"),
        "--truth": str(folder / "vehicles" / "3.truth"),
    }


def test_on_the_ground_and_without_truth_the_flags_are_missing(folder: Path) -> None:
    world = scenario(truth=False)
    order = vehicle_order([world.vehicles.pursuers[1]], world, folder, LINK, failsafes_of(world))
    assert {"--airborne", "--truth"}.isdisjoint(order.argv)


def test_parameters_are_the_scenarios_and_the_vehicles_own_win(folder: Path) -> None:
    world = scenario()
    first, second = world.vehicles.pursuers
    vehicle_order([first], world, folder, LINK, failsafes_of(world))
    written = yaml.safe_load((folder / "vehicles" / "3.params.yaml").read_text())
    assert written == parameters_of(first, world) == {
        "SIM_BAT_CAP_J": 24_000.0, "SIM_BAT_INIT_J": 14_400.0, "SIM_BAT_HOVER_W": 180.0, "SIM_BAT_AVION_W": 12.0,
        "SIM_XFER_DIST": 2.5, "SIM_XFER_SPEED": 0.25, "MPC_TILTMAX_AIR": 30.0,
        "RTL_RETURN_ALT": 5.0, "COM_OF_LOSS_T": 0.5,
    }  # fmt: skip
    assert parameters_of(second, world)["SIM_XFER_DIST"] == 1.75


def test_failsafes_are_cautious_only_where_the_filter_flies() -> None:
    slow = scenario(clock={"mode": "lockstep", "period_s": 0.04}, radio={"jitter_s": 0.1})
    assert parameters_of(slow.vehicles.pursuers[1], slow)["COM_OF_LOSS_T"] == pytest.approx(0.18)
    lossy = scenario(clock={"mode": "lockstep", "period_s": 0.04}, radio={"jitter_s": 0.1, "loss": 0.1})
    assert parameters_of(lossy.vehicles.pursuers[1], lossy)["COM_OF_LOSS_T"] == pytest.approx(0.3)
    bare = scenario(planner={"safety": False})
    assert {"RTL_RETURN_ALT", "COM_OF_LOSS_T"}.isdisjoint(parameters_of(bare.vehicles.pursuers[1], bare))


@pytest.mark.parametrize(
    ("status", "lines", "sentence"),
    [
        (-9, (), "pursuer 3 (process 77) was killed by signal 9"),
        (
            74,
            (),
            "pursuer 3 (process 77) could not write its log or its truth: is the disk of the session's folder full?",
        ),
        (1, ("a", "b"), "pursuer 3 (process 77) ended with status 1; its last lines: a | b"),
    ],
)
def test_a_death_is_one_sentence(status: int, lines: tuple[str, ...], sentence: str) -> None:
    assert Ended(3, 77, status, lines).sentence("pursuer 3") == sentence


def test_a_blocks_argv_lists_each_vehicles_own_values_in_order(folder: Path) -> None:
    battery = {"capacity_j": 24_000.0}
    vehicles = [{"sysid": s, "start_m": (3.0 * s, 0.0, 0.0), "battery": battery} for s in (3, 4, 5, 7)]
    vehicles.append({"sysid": 8, "start_m": (90.0, 0.0, -5.0), "airborne": True, "battery": battery})
    world = scenario(vehicles={"pursuers": vehicles})
    orders = vehicle_orders(world, folder, LINK, per_process=2)
    assert [order.sysids for order in orders] == [(3, 4), (5,), (7,), (8,)]
    words = orders[0].argv
    assert [words[i + 1] for i, word in enumerate(words) if word == "--position"] == ["9.0,0.0,0.0", "12.0,0.0,0.0"]
    assert [Path(words[i + 1]).name for i, word in enumerate(words) if word == "--truth"] == ["3.truth", "4.truth"]
    assert words[words.index("--count") + 1] == "2"
    assert [order.argv.count("--airborne") for order in orders] == [0, 0, 0, 1]
    assert [order.sysids for order in vehicle_orders(world, folder, LINK)] == [
        (3,),
        (4,),
        (5,),
        (7,),
        (8,),
    ]


@pytest.mark.parametrize(
    "key",
    [
        "clock.period_s",
        "radio.jitter_s",
        "refuelling.capture_m",
        "refuelling.relative_speed_m_s",
        *sorted(set(number_keys("vehicles.defaults.battery")) - {"vehicles.defaults.battery.resistance_ohm"}),
    ],
)
def test_vehicles_take_the_least_and_the_greatest_that_a_scenario_may_say(key: str) -> None:
    taken = 0
    for value in extremes(key):
        settings = {key: value, "refuelling.height_m": 0.05}
        try:
            scenario = load(shipped_folder() / "demo.yaml", set=settings)
        except ScenarioError:  # too long a period for refuelling, and the like
            continue
        for vehicle in scenario.vehicles.launched:
            Parameters(parameters_of(vehicle, scenario))
            taken += 1
    assert taken


@pytest.mark.parametrize(("kind", "table"), [("ardupilot", renames.ARDUPILOT), ("px4", renames.PX4)])
def test_a_launched_autopilot_has_other_versions_names_of_its_parameters(
    folder: Path, kind: str, table: renames.Table
) -> None:
    battery = {"capacity_j": 24_000.0, "hover_w": 180.0, "avionics_w": 12.0}
    one = {
        "sysid": 3,
        "start_m": (0.0, 0.0, 0.0),
        "battery": battery,
        "autopilot": {kind: "/bin/true"},
        "params": {"OTHER": 1.0, **dict.fromkeys(table, 5.0)},
    }
    vehicle_orders(scenario(vehicles={"pursuers": [one]}, traffic=[]), folder, LINK)
    content = yaml.safe_load((folder / "vehicles" / "3.autopilot.yaml").read_text())
    assert content["parameters"] == {"OTHER": 1.0, **dict.fromkeys(table, 5.0)}
    assert content["renamed"].keys() == table.keys()
    assert all(f"calls it {row.now}" in content["renamed"][name] for name, row in table.items())
