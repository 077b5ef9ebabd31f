"""The command line: help, bad input, and vehicles for another ground station."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from commands import gcs as said
from pymavlink.dialects.v20 import common as mav

from gcs.cli.main import cli, run_argv

GCS = str(Path(sys.executable).with_name("gcs"))
TWO = """
schema: 1
name: two
axes: ned
origin: {lat_deg: 47.0, lon_deg: 8.0, alt_m: 400.0}
goal: {duration_s: 10}
vehicles:
  defaults: {battery: {capacity_j: 20000}}
  pursuers: [{sysid: 3, start_m: [0.0, 0.0, 0.0]}]
  tankers: [{sysid: 200, start_m: [5.0, 0.0, 0.0]}]
"""


@pytest.fixture
def two(tmp_path: Path) -> Path:
    """A scenario of two vehicles."""
    path = tmp_path / "two.yaml"
    path.write_text(TWO)
    return path


def gcs(*words: str, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    return subprocess.run([GCS, *words], capture_output=True, text=True, timeout=100, cwd=cwd, check=False)


@pytest.mark.parametrize("words", [("run", "--help"), ("--version",)])
def test_help_loads_nothing_heavy(words: tuple[str, ...]) -> None:
    program = (
        "import sys\nfrom gcs.cli.main import run_argv\nstatus = run_argv(sys.argv[1:])\n"
        "heavy = {'numba', 'numpy', 'pydantic', 'scipy', 'pymavlink', 'rich', 'yaml'} & set(sys.modules)\n"
        "sys.exit(f'loaded: {heavy}' if heavy else status)"
    )
    done = subprocess.run([sys.executable, "-c", program, *words], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("words", [("schema",), ("run", "--help")])
def test_a_full_disk_behind_standard_output_is_one_sentence(words: tuple[str, ...]) -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run([GCS, *words], stdout=full, stderr=subprocess.PIPE, text=True, timeout=100, check=False)
    sentence = "gcs: standard output cannot be written: No space left on device\n"
    assert (done.returncode, done.stderr) == (1, sentence)


def test_what_needs_an_extra_says_which(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setitem(sys.modules, "scipy", None)
    assert run_argv(["paper"]) == 2
    said = "gcs: gcs paper needs SciPy, which is not installed: pip install '.[paper]' in Skytender's checkout\n"
    assert capsys.readouterr().err == said


def test_a_plan_is_drawn_with_an_extra_alone(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    assert run_argv(["validate", "demo", "--image", str(tmp_path / "plan.svg")]) == 2
    said = "gcs: an image of a plan needs Matplotlib, which is not installed: pip install '.[plots]' in "
    assert capsys.readouterr().err.startswith(said)
    assert run_argv(["validate", "demo", "--quiet"]) == 0


@pytest.mark.parametrize("command", ["run", "launch", "paper"])
def test_help_has_what_it_does_examples_and_exit_statuses(command: str) -> None:
    page = CliRunner().invoke(cli, [command, "--help"])
    assert page.exit_code == 0
    assert re.search(rf"Examples:\n +gcs {command}", page.output)
    assert "Exit status:" in page.output
    assert re.search(r"^ +130 ", page.output, re.MULTILINE)
    assert max(map(len, page.output.splitlines())) <= 100


def test_both_names_of_the_program_say_their_version() -> None:
    for name in ("gcs", "skytender"):
        program = Path(sys.executable).with_name(name)
        done = subprocess.run([program, "--version"], capture_output=True, text=True, check=True)
        assert re.fullmatch(rf"{name} \d+\.\d+\.\d+\S*\n", done.stdout)


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["run", "demo", "--speed", "0"], "0.0 is not a speed above 0 and up to 1000."),
        (["run", "demo", "--speed", "nan"], "nan is not a speed above 0 and up to 1000."),
        (["run", "demo", "--speed", "fast"], "'fast' is not a valid float."),
        (["run", "demo", "--speed", "2", "--lockstep"], "--lockstep and --speed exclude each other"),
        (["run", "demo", "--plain", "--json"], "--plain and --json exclude each other"),
        (["run", "demo", "--seed", "-1"], "-1 is not a whole number from 0 to 2^63 - 1."),
        (["run", "demo", "--drop-datagrams", "0.95"], "0.95 is not a share from 0 to 0.9."),
        (["run"], "Missing argument 'SCENARIO'."),
        (["launch", "demo", "--connect", "127.0.0.1:14550"], "write udpin|udpout|tcp|tcpin:HOST:PORT or serial:DEV"),
        (["launch", "demo", "--connect", "udpout:127.0.0.1:0"], "write udpin|udpout|tcp|tcpin:HOST:PORT or serial"),
        (["launch", "demo", "--connect", "udpout:nowhere.invalid:14550"], "the host nowhere.invalid cannot be found"),
        (["launch", "demo", "--connect", f"udpout:{'x' * 70}.y:14550"], "cannot be found"),
        (["fly", "demo"], "No such command 'fly'."),
    ],
)
def test_a_bad_option_is_refused_with_a_sentence(
    words: list[str], sentence: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(cli, words)
    assert os.listdir() == []
    assert done.exit_code == 2
    assert sentence in " ".join(done.output.split())


@pytest.fixture
def here(two: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The scenario's folder, which is the current one."""
    monkeypatch.chdir(two.parent)
    return two.parent


@pytest.mark.parametrize("command", ["run", "launch"])
def test_an_unknown_scenario_is_named_with_the_nearest_known_one(command: str, here: Path) -> None:
    done = said(command, "dmeo")
    assert done.returncode == 2
    (line,) = done.stderr.splitlines()
    assert line.startswith("gcs: dmeo: no such file, and no shipped scenario of that name")
    assert "did you mean 'demo'" in line
    assert os.listdir(here) == ["two.yaml"]


def test_every_problem_of_a_scenario_is_a_line_with_its_place(here: Path) -> None:
    (here / "two.yaml").write_text(TWO.replace("duration_s: 10", "duration_s: -1, duraton: 2"))
    done = said("run", "two.yaml")
    assert done.returncode == 2
    lines = done.stderr.splitlines()
    assert len(lines) == 2
    assert all(re.match(r"two\.yaml:6:\d+: ", line) for line in lines)
    assert os.listdir(here) == ["two.yaml"]


@pytest.mark.parametrize("command", ["run", "launch"])
def test_an_existing_folder_is_left_as_it_is_and_one_that_cannot_be_made_is_named(command: str, here: Path) -> None:
    (here / "there").mkdir()
    done = said(command, "two.yaml", "--out", "there")
    assert done.returncode == 2
    assert "gcs: there exists already and is left as it is; give another folder" in done.stderr.splitlines()
    assert os.listdir(here / "there") == []
    done = said(command, "two.yaml", "--out", "/proc/session")
    assert done.returncode == 2
    assert "gcs: cannot make the folder /proc/session: " in done.stderr


@contextmanager
def launched(*words: str) -> Iterator[subprocess.Popen[str]]:
    process = subprocess.Popen([GCS, "launch", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        with process:
            yield process
            process.kill()
    finally:
        process.kill()


def listing(process: subprocess.Popen[str]) -> list[dict[str, Any]]:
    assert process.stdout is not None
    return json.loads(process.stdout.readline())["vehicles"]  # type: ignore[no-any-return]


def test_launched_vehicles_answer_at_the_addresses_printed_and_end_with_ctrl_c(two: Path, tmp_path: Path) -> None:
    kept = tmp_path / "kept"
    with launched(str(two), "--json", "--out", str(kept)) as process:
        vehicles = listing(process)
        assert [(v["sysid"], v["role"], v["label"]) for v in vehicles] == [
            (3, "pursuer", "pursuer 3"),
            (200, "tanker", "tanker 200"),
        ]
        for vehicle in vehicles:
            kind, host, port = vehicle["address"].split(":")
            assert kind == "udpout"
            assert _who_answers(host, int(port)) == vehicle["sysid"]
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert err == "starting 2 vehicles ...\n"
    assert {"3.log", "200.log", "3.params.yaml"} <= set(os.listdir(kept / "vehicles"))


def _who_answers(host: str, port: int) -> int:
    """The system id in the first HEARTBEAT that comes back from an address."""
    parser = mav.MAVLink(None, srcSystem=254, srcComponent=190)
    beat = parser.heartbeat_encode(mav.MAV_TYPE_GCS, mav.MAV_AUTOPILOT_INVALID, 0, 0, 0).pack(parser)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as station:
        station.settimeout(30.0)
        station.sendto(beat, (host, port))
        while True:
            for message in parser.parse_buffer(station.recv(2048)) or ():
                if message.get_type() == "HEARTBEAT":
                    return int(message.get_srcSystem())


def test_a_launched_vehicle_that_dies_is_named_at_once_and_the_others_fly_on(two: Path) -> None:
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as station,
        launched(str(two), "--json", "--connect", _bound(station)) as process,
    ):
        vehicles = listing(process)
        assert {v["address"] for v in vehicles} == {f"udpout:127.0.0.1:{station.getsockname()[1]}"}
        (server,) = _children(process.pid)
        first = min(_children(server))
        os.kill(first, signal.SIGKILL)
        assert process.stderr is not None
        assert process.stderr.readline() == "starting 2 vehicles ...\n"
        line = process.stderr.readline()
        assert re.match(
            rf"gcs: (pursuer 3|tanker 200) \(process {first}\) was killed by signal 9; its last lines: ", line
        )
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
    assert process.returncode == 143
    assert not Path(vehicles[0]["log"]).exists()


def test_the_end_of_all_launched_vehicles_is_no_bad_input(two: Path) -> None:
    with launched(str(two), "--json") as process:
        listing(process)
        (server,) = _children(process.pid)
        os.kill(server, signal.SIGKILL)
        _, err = process.communicate(timeout=60)
    assert process.returncode == 1
    assert "gcs: the fork server of the vehicles has ended, and all of them with it\n" in err


def test_vehicles_end_with_a_standard_input_that_has_nothing_to_read(two: Path) -> None:
    done = subprocess.run(
        [GCS, "launch", str(two), "--until-eof"], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=100,
        check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (0, "")
    assert "standard input ended before the vehicles were there" in done.stderr


@pytest.mark.parametrize("closed", ["<&- >&- 2>&-"])
def test_a_session_flies_where_standard_streams_are_closed(two: Path, tmp_path: Path, closed: str) -> None:
    two.write_text(TWO.replace("duration_s: 10", "duration_s: 1"))
    script = f'exec "$0" run "$1" --lockstep --no-report --out "$2" {closed}'
    words = [script, GCS, str(two), str(tmp_path / "out")]
    done = subprocess.run(["sh", "-c", *words], stderr=subprocess.PIPE, text=True, timeout=100, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["outcome"] == "met"


def _bound(station: socket.socket) -> str:
    station.bind(("127.0.0.1", 0))
    return f"udpout:127.0.0.1:{station.getsockname()[1]}"


def _children(pid: int) -> list[int]:
    return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


FAULT = "faults: [{{fault: delay, delay_s: 0.01, at_s: 0.5, for_s: 0.1, chance: {}}}]\n"


@pytest.mark.parametrize(
    ("more", "words", "told"),
    [
        ("", (), False),
        ("radio: {loss: 0.01}\n", ("--seed", "7"), False),
        (FAULT.format(0.5), ("--seed", "7"), False),
        (FAULT.format(1.0), ("--seed", "7"), True),
    ],
)
def test_a_seed_that_changes_nothing_is_told(more: str, words: tuple[str, ...], told: bool, here: Path) -> None:
    (here / "two.yaml").write_text(TWO.replace("duration_s: 10", "duration_s: 1") + more)
    done = said("run", "two.yaml", "--lockstep", "--plain", "--no-report", "--out", "out", *words)
    assert done.returncode == 0, done.stderr
    assert ("gcs: --seed changes nothing" in done.stderr) == told
