"""`gcs params` and every MAV_PARAM_TYPE at its limits, on vehicles of both encodings and on a component beside the
autopilot: what they hold is read from their own bytes."""

from __future__ import annotations

import json
import math
import struct
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from ports import free_port
from sessions import ROOT
from strangers import strangers

from gcs.mavlink.parameters import renames

HOLDER = [sys.executable, str(ROOT / "tests" / "peers" / "parameter_holder.py")]
FORMS = {"UINT8": "B", "INT8": "b", "UINT16": "H", "INT16": "h", "UINT32": "I", "INT32": "i", "REAL32": "f"}
WIDE = {"UINT64": "Q", "INT64": "q", "REAL64": "d"}
PX4, ARDUPILOT = 1, 2


def single(number: float) -> float:
    return float(struct.unpack("<f", struct.pack("<f", number))[0])


def numbers(form: str) -> list[int | float]:
    near = [sign * (2**24 + d) for sign in (1, -1) for d in (-1, 0, 1)]
    if form in "fd":
        return [0.5, *map(float, near), 3.4028234663852886e38, 1e-45, math.inf, -math.inf, -0.0, math.nan, 0.1]
    bits, signed = 8 * struct.calcsize(form), form.islower()
    least, most = (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) if signed else (0, 2**bits - 1)
    return [n for n in (1, least, most, *near, 0) if least <= n <= most]


class Fleet:
    """The command at their port, and what they say that they hold."""

    def __init__(self, port: int, logs: list[Path]) -> None:
        self.port, self.logs = port, logs

    def __call__(self, *argv: str, sysid: int | None = None) -> Any:
        only = ["--sysid", str(sysid)] if sysid else ["--sysid", "1", "--sysid", "2"]
        return gcs("params", *argv, "--connect", f"udpin:127.0.0.1:{self.port}", "--wait", "30", *only)

    def held(self, sysid: int) -> dict[tuple[int, str], bytes]:
        words = [line.split() for line in self.logs[sysid - 1].read_text().splitlines()]
        assert all(word[0] == "SET" for word in words), words
        return {(int(compid), name): bytes.fromhex(raw) for _, compid, name, raw in words}


@pytest.fixture(scope="module")
def fleet(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Fleet]:
    port = free_port()
    kinds = [("px4", PX4), ("ardupilot", ARDUPILOT)]
    commands = [[*HOLDER, "--port", str(port), "--sysid", str(n), "--autopilot", kind] for kind, n in kinds]
    with strangers(tmp_path_factory.mktemp("holders"), *commands) as logs:
        yield Fleet(port, logs)


@pytest.mark.parametrize("sysid", [PX4, ARDUPILOT])
def test_every_type_at_its_limits_is_set_read_saved_compared_and_loaded(
    fleet: Fleet, tmp_path: Path, sysid: int
) -> None:
    forms = {name: "<" + form for name, form in (FORMS if sysid == PX4 else FORMS | WIDE).items()}
    wanted = {f"{name}_{i}": (form, n) for name, form in forms.items() for i, n in enumerate(numbers(form[1]))}
    whole = {name: n for name, (_, n) in wanted.items() if isinstance(n, int)}
    lost = {name for name, n in whole.items() if sysid == ARDUPILOT and single(n) != n}
    done = fleet("set", *(f"{name}={number!r}" for name, (_, number) in wanted.items()), "--json", sysid=sysid)
    results = {row["name"]: row for row in json.loads(done.stdout)["results"]}
    assert results.keys() == wanted.keys()
    assert {name for name, row in results.items() if row["outcome"] == "refused"} == lost
    assert done.returncode == (1 if lost else 0)
    assert all("cannot be sent: this vehicle's parameters travel as floats" in results[name]["why"] for name in lost)
    held = fleet.held(sysid)
    for name in wanted.keys() - lost:
        form, number = wanted[name]
        carried = single(number) if form == "<d" else number
        mine, now = held.get((1, name), bytes(struct.calcsize(form))), results[name]["now"]
        assert mine == struct.pack(form, carried) or (carried == 0 and not any(mine)), name
        assert struct.pack(form, float(now) if isinstance(now, str) else now) == mine, name
        assert type(now) is (str if not math.isfinite(carried) else float if form[1] in "fd" else int), name
    got = json.loads(fleet("get", *wanted, "--json", sysid=sysid).stdout)["vehicles"][str(sysid)]
    assert {(name, repr(got[name])) for name in wanted.keys() - lost} == {
        (name, repr(results[name]["now"])) for name in wanted.keys() - lost
    }

    file = tmp_path / "saved.params"
    saved = fleet("save", str(file), sysid=sysid)
    assert saved.returncode == 0, saved.stderr
    assert fleet("diff", str(file), sysid=sysid).stdout == "no difference\n"
    again = fleet("load", str(file), sysid=sysid)
    assert again.returncode == 0, again.stdout
    assert again.stdout == f"0 written, {len(file.read_text().splitlines()) - 1} already as in the file\n"
    assert fleet.held(sysid) == held

    assert fleet("set", *(f"{name}_*=7" for name in forms), sysid=sysid).returncode == 0
    rows = json.loads(fleet("diff", str(file), "--json", sysid=sysid).stdout)["differences"]
    assert wanted.keys() <= rows.keys()
    for name in wanted.keys() - lost:
        text, now = rows[name]["file"], results[name]["now"]
        assert rows[name][str(sysid)] == 7
        assert text == now
    back = fleet("load", str(file), sysid=sysid)
    assert back.returncode == 0, back.stdout
    after = fleet.held(sysid)
    assert {name: after[name] for name in held} == held


def test_an_integer_whose_bytes_are_a_signalling_nans_is_held_and_read_exactly(fleet: Fleet) -> None:
    for number in (-4194305, 2139095041, 2**31 - 1, -1):
        assert fleet("set", f"INT32_0={number}", sysid=PX4).returncode == 0
        assert fleet.held(PX4)[1, "INT32_0"] == struct.pack("<i", number)
        assert fleet("get", "INT32_0", sysid=PX4).stdout.split() == ["INT32_0", str(number)]


def test_what_no_vehicle_can_hold_is_refused_before_it_is_written(fleet: Fleet) -> None:
    before = fleet.held(PX4), fleet.held(ARDUPILOT)
    done = fleet("set", "UINT8_0=256", "INT8_0=-129", "INT16_0=0.5", "UINT32_0=-1", "REAL32_0=1e39", "LOCKED=7")
    assert done.returncode == 1
    assert done.stdout.count("does not fit its type") == 8
    assert done.stdout.count("0.5 is no whole number, and its type is INT16") == 2
    assert done.stdout.count("LOCKED            refused: it lets no ground station write it (PERMISSION_DENIED)") == 2
    assert (fleet.held(PX4), fleet.held(ARDUPILOT)) == before


def test_two_vehicles_that_differ_by_one_beyond_what_a_float_holds_differ(fleet: Fleet) -> None:
    assert fleet("set", "INT32_0=16777216").returncode == 0
    assert "INT32_0" not in fleet("diff").stdout
    assert fleet("set", "INT32_0=16777217", sysid=PX4).stdout.count("16777216 -> 16777217, read back") == 1
    assert "INT32_0           1: 16777217  2: 16777216" in fleet("diff").stdout


def test_a_components_parameters_are_its_own(fleet: Fleet, tmp_path: Path) -> None:
    file = tmp_path / "two.params"
    file.write_text("1\t1\tUINT8_0\t3\t1\n1\t154\tU8\t9\t1\n")
    loaded = fleet("load", str(file), sysid=PX4)
    assert loaded.returncode == 0, loaded.stdout
    assert "1/154  U8                0 -> 9, read back" in loaded.stdout
    assert fleet.held(PX4)[154, "U8"] == b"\x09"
    assert fleet.held(PX4)[1, "UINT8_0"] == b"\x03"
    assert fleet("set", "U8=8", "F32=0.25", "--compid", "154", sysid=PX4).returncode == 0
    got = json.loads(fleet("get", "--compid", "154", "--json", sysid=PX4).stdout)
    assert got == {"vehicles": {"1/154": {"F32": 0.25, "U8": 8}}}
    assert "U8                1/154: 8  file: 9" in fleet("diff", str(file), sysid=PX4).stdout
    saved = tmp_path / "saved.params"
    assert fleet("save", str(saved), "UINT8*", "U8", "--compid", "1", "--compid", "154", sysid=PX4).returncode == 0
    assert [line.split("\t")[:3] for line in saved.read_text().splitlines()[1:]] == [
        *(["1", "1", f"UINT8_{number}"] for number in sorted(range(16), key=str)),
        ["1", "154", "U8"],
    ]
    assert fleet("load", str(file), "--compid", "1", "--dry-run", sysid=PX4).stdout.count("already") == 1


def test_a_file_with_names_that_a_vehicle_does_not_know_differs(fleet: Fleet, tmp_path: Path) -> None:
    file = tmp_path / "old.parm"
    file.write_text("WPNAV_SPEED 500\nNO_SUCH_PARAM = 1\n")
    differs = fleet("diff", str(file), sysid=ARDUPILOT)
    assert differs.returncode == 1
    assert "WPNAV_SPEED       2: -  file: 500" in differs.stdout
    advice = "it does not know it; ArduPilot 4.7 calls it WP_SPD, 0.01 times the old number, metres for centimetres"
    assert f"gcs: vehicle 2: WPNAV_SPEED: {advice}\n" in differs.stderr
    assert "gcs: vehicle 2: NO_SUCH_PARAM: it does not know it\n" in differs.stderr
    loaded = fleet("load", str(file), sysid=ARDUPILOT)
    assert loaded.returncode == 1
    assert f"unknown: {advice}" in loaded.stdout
    assert "EKF2_POS_LOCK" in fleet("set", "EKF2_ENGINE_WRM=1", sysid=PX4).stdout


@pytest.mark.parametrize(("sysid", "table"), [(PX4, renames.PX4), (ARDUPILOT, renames.ARDUPILOT)])
def test_each_renamed_parameter_that_is_set_loaded_or_compared_is_answered_by_its_new_name(
    fleet: Fleet, tmp_path: Path, sysid: int, table: renames.Table
) -> None:
    """The vehicle knows neither name, as one of another version knows only the other."""
    file = tmp_path / "old.param"
    file.write_text("".join(f"{name} 1\n" for name in table))
    for argv in (("set", *(f"{name}=1" for name in table)), ("load", str(file)), ("diff", str(file))):
        done = fleet(*argv, sysid=sysid)
        assert done.returncode == 1, argv[0]
        lines = (done.stdout + done.stderr).splitlines()
        for name, row in table.items():
            assert [line for line in lines if f" {name}" in line and f"calls it {row.now}" in line], (argv[0], name)
