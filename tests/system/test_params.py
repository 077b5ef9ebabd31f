"""`gcs params` over three vehicles at once: a PX4 and an ArduPilot of ours, and the scripted ArduCopter."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from ports import free_port
from strangers import ARDUCOPTER, SIMVEHICLE, strangers

from gcs.link.fleet_client import FleetClient
from gcs.scenario.file import load


class Params:
    """The command at the port of the three."""

    def __init__(self, port: int) -> None:
        self.port = port

    def __call__(self, *argv: str, sysids: tuple[int, ...] = (1, 2, 3)) -> Any:
        only = [word for sysid in sysids for word in ("--sysid", str(sysid))]
        return gcs("params", *argv, "--connect", f"udpin:127.0.0.1:{self.port}", "--wait", "40", *only)


@pytest.fixture(scope="module")
def params(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Params]:
    port = free_port()
    to = ["--connect", f"udpout:127.0.0.1:{port}"]
    commands = [
        [*SIMVEHICLE, "--sysid", "1", *to],
        [*SIMVEHICLE, "--sysid", "2", "--autopilot", "ardupilot", *to],
        [*ARDUCOPTER, "--sysid", "3", *to],
    ]
    with strangers(tmp_path_factory.mktemp("three"), *commands):
        yield Params(port)


def test_parameters_of_three_are_set_and_verified_saved_compared_and_loaded(params: Params, tmp_path: Path) -> None:
    file = tmp_path / "before.params"
    saved = params("save", str(file))
    assert saved.returncode == 0, saved.stderr
    lines = [line.split("\t") for line in file.read_text().splitlines() if not line.startswith("#")]
    assert {line[0] for line in lines} == {"1", "2", "3"}
    assert ["3", "1", "RTL_ALT", "1500", "6"] in lines

    dry = params("set", "RTL_ALT=2000", "WPNAV_SPEED=312.5", "--dry-run", sysids=(3,))
    assert dry.returncode == 0
    assert "RTL_ALT           1500 -> 2000, not written: a dry run" in dry.stdout
    done = json.loads(params("set", "*SPEED_DN=140", "--json", sysids=(3,)).stdout)
    assert [(row["name"], row["outcome"]) for row in done["results"]] == [("WPNAV_SPEED_DN", "set")]
    everyone = params("set", "SIM_BAT_CAP_J=81000", "MIS_TAKEOFF_ALT=4.5", sysids=(1, 2))
    assert everyone.returncode == 0, everyone.stdout + everyone.stderr
    assert everyone.stdout.count("read back") + everyone.stdout.count("already") == 4

    differs = params("diff", str(file), "--json", sysids=(3,))
    assert differs.returncode == 1
    rows = json.loads(differs.stdout)["differences"]
    assert rows["WPNAV_SPEED_DN"] == {"3": 140.0, "file": 150.0}
    chosen = tmp_path / "chosen.params"
    names = {"WPNAV_SPEED_DN", "RTL_ALT", "SIM_BAT_CAP_J", "MIS_TAKEOFF_ALT"}
    chosen.write_text("".join("\t".join(line) + "\n" for line in lines if line[2] in names))
    began_s = time.monotonic()
    back = params("load", str(chosen))
    took_s = time.monotonic() - began_s
    assert back.returncode == 0, back.stdout + back.stderr
    assert back.stdout.count("read back") == 5
    assert "  3  WPNAV_SPEED_DN    140 -> 150, read back" in back.stdout
    assert back.stdout.splitlines()[-1] == "vehicle 3: 1 written, 1 already as in the file"
    assert took_s < 10.0  # parameters of three, found, set and verified
    got = json.loads(params("get", "WPNAV_SPEED_DN", "RTL_ALT", "--json", sysids=(3,)).stdout)
    assert got == {"vehicles": {"3": {"RTL_ALT": 1500.0, "WPNAV_SPEED_DN": 150.0}}}


def test_what_cannot_be_done_is_a_sentence(params: Params, tmp_path: Path) -> None:
    unknown = params("get", "NO_SUCH_PARAM", sysids=(1,))
    assert unknown.returncode == 1
    assert "gcs: vehicle 1: NO_SUCH_PARAM: it does not know it" in unknown.stderr
    lower = params("get", "rtl_alt", sysids=(3,))
    assert lower.returncode == 1
    assert lower.stderr.endswith("; did you mean RTL_ALT?\n")
    (tmp_path / "bad").write_text("RTL_ALT 15\nRTL_ALT high\n")
    bad = params("load", str(tmp_path / "bad"), sysids=(3,))
    assert bad.returncode == 2
    assert "bad:2: 'RTL_ALT high': 'high' is no number" in bad.stderr
    nobody = gcs("params", "get", "A", "--connect", f"udpin:127.0.0.1:{free_port()}", "--wait", "0.2")
    assert nobody.returncode == 2
    assert "no HEARTBEAT of any vehicle came within 0.2 s" in nobody.stderr


def test_ctrl_c_says_that_nothing_was_written_yet(params: Params, monkeypatch: pytest.MonkeyPatch) -> None:
    def pressed(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(FleetClient, "exchange", pressed)
    for setting, words in (("WPNAV_*=150", "nothing was written"), ("RTL_ALT=1500", "0 written, 1 not yet")):
        stopped = params("set", setting, sysids=(3,))
        assert stopped.returncode == 130
        assert stopped.stderr.rstrip().endswith(f"gcs: interrupted: {words}")


def test_a_scenario_is_made_of_the_vehicles_that_are_heard(params: Params, tmp_path: Path) -> None:
    made = gcs("init", str(tmp_path / "field.yaml"), "--connect", f"udpin:127.0.0.1:{params.port}")
    assert made.returncode == 0, made.stderr
    scenario = load(tmp_path / "field.yaml")
    external = scenario.vehicles.external
    assert sorted(external) == [1, 2, 3]
    assert external[1].capacity_j == 24000.0 == external[2].capacity_j
    assert external[3].capacity_j == pytest.approx(70 * 3600.0, rel=0.2)  # its 70 Wh, by mAh times the present volts
    assert (scenario.origin.lat_deg, scenario.origin.lon_deg) == pytest.approx((47.397742, 8.545594), abs=1e-5)


def test_meanings_come_from_each_vehicles_own_metadata(params: Params) -> None:
    shown = params("get", "MPC_XY_CRUISE", "SYS_AUTOSTART", "--describe", sysids=(1, 2))
    assert shown.returncode == 0, shown.stderr
    assert "m/s on the way home  [m/s]  0.5..20  default 5" in shown.stdout
    done = params("get", "RTL_ALT", "--describe", "--json", sysids=(3,))
    assert json.loads(done.stdout) == {"vehicles": {"3": {"RTL_ALT": 1500.0}}, "meanings": {"3": {}}}
    assert "vehicle 3 does not say what its parameters are: it has no metadata" in done.stderr
