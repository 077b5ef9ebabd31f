"""`gcs params` without a link: what is written and only counted, what Ctrl-C leaves, and what a slip is answered by."""

from __future__ import annotations

import json
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from dialogue import exchange
from pymavlink.dialects.v20 import common as mav

from gcs.cli.main import run_argv
from gcs.cli.parameter_writing import LIST_FROM, why, write
from gcs.mavlink.autopilots import ARDUCOPTER
from gcs.mavlink.parameters.client import ParameterClient

REAL32 = mav.MAV_PARAM_TYPE_REAL32
MANY = {f"P{i:03d}": float(i) for i in range(LIST_FROM + 50)}
PROFILE = replace(ARDUCOPTER, parameter_file="")


class Vehicle:
    """Its parameters, all floats; a write of `stubborn` ones changes nothing, and an unknown name is refused."""

    def __init__(self, stubborn: tuple[str, ...] = ()) -> None:
        self.parameters, self.stubborn = dict(MANY), stubborn
        self.asked: list[str] = []

    def value(self, name: str, index: int = 65535) -> Any:
        number = self.parameters[name]
        return mav.MAVLink_param_value_message(name.encode(), number, REAL32, len(self.parameters), index)

    def hear(self, m: Any) -> list[Any]:
        self.asked.append(m.get_type())
        if m.get_type() == "PARAM_REQUEST_LIST":
            return [self.value(name, index) for index, name in enumerate(self.parameters)]
        if m.param_id not in self.parameters:
            return [mav.MAVLink_param_error_message(255, 190, m.param_id.encode(), -1, 1)]
        if m.get_type() == "PARAM_SET" and m.param_id not in self.stubborn:
            self.parameters[m.param_id] = m.param_value
        return [self.value(m.param_id)]


class Fleet:
    """Vehicles of these numbers, without a link. Ctrl-C is pressed once a vehicle has been written to so often."""

    def __init__(self, *vehicles: Vehicle, ends_after: int | None = None) -> None:
        self.vehicles = dict(enumerate(vehicles, 1))
        self.profiles = dict.fromkeys(self.vehicles, PROFILE)
        self.ends_after = ends_after

    def converse(self, clients: list[Any]) -> None:
        now_s = 0.0
        while under_way := [client for client in clients if not client.done]:
            for client in under_way:
                vehicle = self.vehicles[client.sysid]
                exchange(client, vehicle, now_s)
                if self.ends_after is not None and vehicle.asked.count("PARAM_SET") >= self.ends_after:
                    raise KeyboardInterrupt
            now_s += 0.1


def written(fleet: Any, numbers: dict[str, float], *, plain: bool = False, loaded: bool = True) -> int:
    addresses = {(sysid, 1): dict(numbers) for sysid in fleet.vehicles}
    return write(fleet, addresses, dry_run=False, plain=plain, loaded=loaded)


def test_a_load_says_what_it_writes_and_counts_the_rest(capsys: pytest.CaptureFixture[str]) -> None:
    fleet = Fleet(Vehicle(stubborn=("P004",)))
    status = written(fleet, MANY | {"P003": 7.5, "P004": 8.0, "NO_SUCH": 1.0})
    lines = capsys.readouterr().out.splitlines()
    assert status == 1
    assert sorted(lines[:-1]) == [
        "  1  NO_SUCH           unknown: it does not know it",
        "  1  P003              3 -> 7.5, read back",
        "  1  P004              refused: it keeps 4",
    ]
    assert lines[-1] == f"1 written, {len(MANY) - 2} already as in the file, 1 unknown, 1 refused"


def test_of_several_vehicles_each_is_counted(capsys: pytest.CaptureFixture[str]) -> None:
    fleet = Fleet(Vehicle(), Vehicle())
    fleet.vehicles[2].parameters["P003"] = 7.0
    assert written(fleet, MANY) == 0
    counts = [f"vehicle 1: 0 written, {len(MANY)} already", f"vehicle 2: 1 written, {len(MANY) - 1} already"]
    assert capsys.readouterr().out.splitlines() == [
        "  2  P003              7 -> 3, read back",
        *(f"{count} as in the file" for count in counts),
    ]


def test_json_has_all_facts_of_a_load(capsys: pytest.CaptureFixture[str]) -> None:
    assert written(Fleet(Vehicle()), MANY | {"P003": 7.5}, plain=True) == 0
    rows = json.loads(capsys.readouterr().out)["results"]
    assert {row["name"]: row["outcome"] for row in rows} == dict.fromkeys(MANY, "kept") | {"P003": "set"}


def test_what_is_set_by_name_is_said_each(capsys: pytest.CaptureFixture[str]) -> None:
    assert written(Fleet(Vehicle()), {"P001": 1.0}, loaded=False) == 0
    assert capsys.readouterr().out == "  1  P001              1 already\n"


@pytest.mark.parametrize(("names", "asked"), [(LIST_FROM, 0), (LIST_FROM - 1, LIST_FROM - 1)])
def test_many_are_compared_with_a_list_and_few_asked_for_by_name(names: int, asked: int) -> None:
    fleet = Fleet(Vehicle())
    assert written(fleet, dict(list(MANY.items())[:names])) == 0
    assert fleet.vehicles[1].asked.count("PARAM_REQUEST_READ") == asked
    assert fleet.vehicles[1].asked.count("PARAM_REQUEST_LIST") == (not asked)


def test_ctrl_c_says_what_has_been_written(capsys: pytest.CaptureFixture[str]) -> None:
    fleet = Fleet(Vehicle(), ends_after=20)
    changed = {name: number + 0.5 for name, number in list(MANY.items())[: LIST_FROM + 20]}
    with pytest.raises(KeyboardInterrupt):
        written(fleet, changed | {"P149": 149.0})
    said = capsys.readouterr()
    counts = dict(word.split(" ", 1)[::-1] for word in said.err.removeprefix("gcs: interrupted: ").strip().split(", "))
    assert list(counts) == ["written", "already as in the file", "sent and not read back", "not yet"]
    assert sum(map(int, counts.values())) == LIST_FROM + 21
    assert counts["already as in the file"] == "1"
    assert int(counts["written"]) == said.out.count("read back") > 0
    assert fleet.vehicles[1].asked.count("PARAM_SET") <= int(counts["written"]) + int(counts["sent and not read back"])


def test_ctrl_c_names_each_of_several_vehicles(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(KeyboardInterrupt):
        written(Fleet(Vehicle(), Vehicle(), ends_after=0), {"P001": 5.0, "P002": 5.0}, loaded=False)
    assert capsys.readouterr().err == (
        "gcs: interrupted: vehicle 1: 0 written, 2 sent and not read back, 0 not yet; vehicle 2: 0 written, 2 not yet\n"
    )


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("wp_spd", "; did you mean WP_SPD?"),
        ("fence_enable", "; did you mean FENCE_ENABLE?"),
        ("WPNAV_SPED", "; did you mean WPNAV_SPEED?"),
        ("FENCE_ENABEL", ""),
        ("WPNAV_SPEED", "; ArduPilot 4.7 calls it WP_SPD, 0.01 times the old number, metres for centimetres"),
    ],
)
def test_a_name_that_is_mistyped_is_answered_by_the_one_that_is_meant(typed: str, meant: str) -> None:
    """Where that is known without a list; what the table of renames says comes before it."""
    client, vehicle = ParameterClient(1, 1, PROFILE), Vehicle()
    client.read([typed])
    exchange(client, vehicle, 0.0)
    (result,) = client.results
    assert why(client, result) == f"it does not know it{meant}"


def test_a_name_that_is_mistyped_is_compared_with_what_the_vehicle_has_said() -> None:
    client, vehicle = ParameterClient(1, 1, PROFILE), Vehicle()
    vehicle.parameters["FENCE_ENABLE"] = 1.0
    client.read(["FENCE_ENABLE"])
    exchange(client, vehicle, 0.0)
    client.expect(["FENCE_ENABEL"])
    assert why(client, client.results[-1]) == "it does not know it; did you mean FENCE_ENABLE?"


@pytest.fixture
def two(monkeypatch: pytest.MonkeyPatch) -> Fleet:
    """The fleet of two vehicles, of which the second has one parameter more, that commands find."""
    fleet = Fleet(Vehicle(), Vehicle())
    fleet.vehicles[2].parameters["FENCE_ENABLE"] = 1.0
    monkeypatch.setattr("gcs.cli.params.fleet_at", lambda **_: nullcontext(fleet))
    return fleet


@pytest.mark.usefixtures("two")
@pytest.mark.parametrize(
    ("names", "status", "out", "err"),
    [
        (["P00?"], 0, 10, ""),
        (["FENCE_*"], 0, 1, ""),
        (["NOPE*"], 1, 0, "gcs: no vehicle has a parameter named NOPE*\n"),
        (["P00?", "NOPE*", "NO_[AB]"], 1, 10, "gcs: no vehicle has a parameter named NOPE*, NO_[AB]\n"),
        (["P00?", "FENCE_ENABLE"], 0, 11, ""),
        (["P00?", "NOPE"], 1, 10, "gcs: no vehicle has a parameter named NOPE\n"),
        (["FENCE_ENABLE"], 1, 1, "gcs: vehicle 1: FENCE_ENABLE: it does not know it\n"),
    ],
)
def test_a_name_that_names_nothing_is_said_with_asterisks_too(
    names: list[str], status: int, out: int, err: str, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert run_argv(["params", "get", *names]) == status
    said = capsys.readouterr()
    assert (len(said.out.splitlines()), said.err) == (out, err)
    assert run_argv(["params", "save", str(tmp_path / "some.params"), *names]) == status
    assert capsys.readouterr().err == err


def test_nothing_is_written_where_a_name_with_asterisks_names_nothing(
    two: Fleet, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run_argv(["params", "set", "P001=5", "P00?=6", "NOPE*=1"]) == 2
    assert capsys.readouterr().err == "gcs: no vehicle has a parameter named NOPE*\n"
    assert two.vehicles[1].parameters == MANY


def test_blanks_around_the_parts_of_a_setting_do_not_count(two: Fleet) -> None:
    assert run_argv(["params", "set", " P001 = 5 "]) == 0
    assert [vehicle.parameters["P001"] for vehicle in two.vehicles.values()] == [5.0, 5.0]


@pytest.mark.parametrize(
    ("setting", "problem"),
    [
        ("WP_SPD=fast", "'WP_SPD=fast': 'fast' is no number; write NAME=VALUE, such as FENCE_RADIUS=80."),
        ("WP_SPD=", "'WP_SPD=': '' is no number; write NAME=VALUE, such as FENCE_RADIUS=80."),
        ("WP_SPD", "'WP_SPD' is no setting; write NAME=VALUE, such as FENCE_RADIUS=80."),
        ("=5", "'=5' is no setting; write NAME=VALUE, such as FENCE_RADIUS=80."),
        ("A_MUCH_TOO_LONG_NAME=5", "'A_MUCH_TOO_LONG_NAME=5': a parameter's name has 16 letters at most, not 20."),
    ],
)
def test_what_is_no_setting_is_answered_by_what_is_wrong_with_it(setting: str, problem: str) -> None:
    done = gcs("params", "set", setting)
    assert done.returncode == 2
    assert done.stderr.splitlines()[-1] == f"gcs: {problem}"
