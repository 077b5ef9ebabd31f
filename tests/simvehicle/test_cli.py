"""The command line: help for newcomers, and one sentence for what is wrong."""

import socket
import subprocess
import sys
from pathlib import Path

import pytest

from simvehicle.cli import run_argv
from simvehicle.cli.fork_server import sysid_of, title_of

FINE = ["--sysid", "1", "--connect", "udpin:127.0.0.1:0"]


def complaint(argv: list[str], capfd: pytest.CaptureFixture[str]) -> str:
    """What a bad command line is told: one line, status 2."""
    assert run_argv(argv) == 2
    out, err = capfd.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert err.startswith("simvehicle: ")
    return err


@pytest.mark.parametrize(
    ("argv", "said"),
    [
        ([], "--sysid is missing"),
        (["--connect", "udpin:127.0.0.1:0"], "--sysid is missing"),
        (["--sysid", "1"], "no station would hear it: give --connect udpout:127.0.0.1:14550"),
        (["--sysid", "0", *FINE[2:]], "0 is not in the range 1<=x<=254"),
        (["--sysid", "255", *FINE[2:]], "255 is not in the range 1<=x<=254"),
        (["--sysid", "one", *FINE[2:]], "'one' is not a valid integer"),
        (["--sysid", "1", "--connect", "127.0.0.1:14550"], "'127.0.0.1:14550' is no connection; write udpout:"),
        (["--sysid", "1", "--supervised", "udpout:127.0.0.1"], "'udpout:127.0.0.1' is no connection"),
        (["--sysid", "1", "--supervised", "udpin:127.0.0.1:9"], "write udpout:127.0.0.1:9"),
        (["traffic", "none.yaml", "--supervised", "udpin:127.0.0.1:0"], "write udpout:127.0.0.1:PORT"),
        ([*FINE, "--connect", "udpout:no.such.host.invalid:1"], "cannot use udpout:no.such.host.invalid:1"),
        ([*FINE, "--position", "0,0"], "'0,0' is not three numbers; write N,E,D"),
        ([*FINE, "--position", "a,b,c"], "'a,b,c' is not three numbers"),
        ([*FINE, "--position", "nan,0,0"], "no place or speed"),
        ([*FINE, "--position", "0,0,1e30"], "no place or speed"),
        ([*FINE, "--position", "0,0,2"], "--position lies below the ground: down must be 0 or negative"),
        ([*FINE, "--home", "91,0,0"], "--home 91, 0, 0 is no origin"),
        ([*FINE, "--home", "0,181,0"], "--home 0, 181, 0 is no origin"),
        ([*FINE, "--autopilot", "dji"], "'dji' is not one of 'px4', 'ardupilot', 'generic'"),
        ([*FINE, "--colour", "red"], "No such option"),
        (["fly"], "No such command 'fly'"),
        (["traffic", "none.yaml", "--supervised", "udpout:127.0.0.1:9"], "none.yaml: No such file"),
        (["traffic", "none.yaml", "--supervised", "nowhere"], "'nowhere' is no connection"),
    ],
)
def test_bad_command_line_is_told_in_one_sentence(
    argv: list[str], said: str, capfd: pytest.CaptureFixture[str]
) -> None:
    assert said in complaint(argv, capfd)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (None, ": No such file or directory"),
        (b"", ": write one 'NAME: number' per line."),
        (b"\xff\xfe\x00\x80", " is no text file"),
        (b"\x00\x01", ": unacceptable character"),
        (b"just words", ": write one 'NAME: number' per line."),
        (b"SIM_BAT_CAP_J: 100\nSIM_BAT_CAPJ: 5", ": unknown parameter SIM_BAT_CAPJ, did you mean SIM_BAT_CAP_J?"),
        (b"MPC_LAND_SPEED: 99", ": MPC_LAND_SPEED = 99 is outside 0.1 .. 3"),
        (b"MPC_LAND_SPEED: nan", ": MPC_LAND_SPEED = nan is outside 0.1 .. 3"),
        (b"MPC_LAND_SPEED: 1\nMPC_XY_CRUISE: .nan", ", line 2: MPC_XY_CRUISE is '.nan', which is no number"),
        (b"MPC_LAND_SPEED: fast", ", line 1: MPC_LAND_SPEED is 'fast', which is no number"),
        (b"MPC_LAND_SPEED: true", ", line 1: MPC_LAND_SPEED is 'true', which is no number"),
        (b"MPC_LAND_SPEED: [1]", ", line 1: write 'NAME: number'."),
        (b"MPC_LAND_SPEED: 1\nMPC_LAND_SPEED: 2", ", line 2: MPC_LAND_SPEED is given twice"),
        (b"SIM_BAT_CAP_J: " + b"9" * 400, ": SIM_BAT_CAP_J = inf is outside"),
        (b"SIM_BAT_CAP_J: 10\nSIM_BAT_INIT_J: 11", ": SIM_BAT_INIT_J is above SIM_BAT_CAP_J"),
        (
            b"SIM_GAIN_RATE: 600",
            ": the flight law refuses these values: gains.rate is 600.0, but it must be less than 500",
        ),
        (b"a: {", ": while parsing"),
    ],
)
def test_bad_parameter_file_is_named(
    content: bytes | None, said: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "params.yaml"
    if content is not None:
        path.write_bytes(content)
    assert f"--params {path}{said}" in complaint([*FINE, "--params", str(path)], capfd)


def test_directory_for_a_file_is_named(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert "is a directory" in complaint([*FINE, "--params", str(tmp_path)], capfd)


def test_truth_is_never_overwritten_and_needs_a_folder(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "1.truth"
    path.write_text("precious")
    assert f"--truth {path} exists already" in complaint([*FINE, "--truth", str(path)], capfd)
    assert "No such file" in complaint([*FINE, "--truth", str(tmp_path / "none" / "1.truth")], capfd)
    assert path.read_text() == "precious"


def test_port_in_use_is_named(capfd: pytest.CaptureFixture[str]) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        address = f"udpin:127.0.0.1:{other.getsockname()[1]}"
        told = complaint(["--sysid", "1", "--connect", address], capfd)
    assert f"cannot use {address}: the port is in use" in told


def test_ports_of_a_block_that_would_count_beyond_the_last_are_refused(capfd: pytest.CaptureFixture[str]) -> None:
    said = complaint(["--sysid", "1", "--count", "10", "--connect", "udpin:127.0.0.1:65527"], capfd)
    assert said == "simvehicle: cannot use udpin:127.0.0.1:65527 for 10 vehicles: ports end at 65535; begin at 65526\n"


@pytest.mark.parametrize(("argv", "speaker"), [(["--help"], "simvehicle"), (FINE, "vehicle 1")])
def test_a_full_disk_behind_standard_output_is_one_sentence(argv: list[str], speaker: str) -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "simvehicle", *argv], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60,
            check=False,
        )  # fmt: skip
    sentence = f"{speaker}: cannot write standard output: No space left on device\n"
    assert (done.returncode, done.stderr) == (74, sentence)


def test_help_is_a_page_for_newcomers_and_loads_no_compiler() -> None:
    script = (
        "import sys; from simvehicle.cli import run_argv; status = run_argv(['--help']);"
        "sys.exit(status or 10 * bool({'numba', 'numpy', 'pymavlink'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    for word in ("--sysid", "--connect", "--supervised", "--position", "--airborne", "--params", "fork-server",
                 "traffic",
                 "Examples: simvehicle --sysid 1 --connect udpout:127.0.0.1:14550", "Exit status: 2",
                 "Ctrl-C"):  # fmt: skip
        assert word in " ".join(done.stdout.split())
    assert len(done.stdout.splitlines()) < 60
    assert max(map(len, done.stdout.splitlines())) <= 100


@pytest.mark.parametrize(
    ("argv", "sysid"),
    [(["--sysid", "7"], 7), (["--home", "0,0,0", "--sysid", "254"], 254), (["traffic", "f"], 255), ([], 0),
     (["--sysid"], 0), (["--sysid", "x"], 0), (["--sysid", "²"], 0)],
)  # fmt: skip
def test_argv_names_its_system(argv: list[str], sysid: int) -> None:
    assert sysid_of(argv) == sysid


@pytest.mark.parametrize(
    ("argv", "title"),
    [(["--sysid", "7"], "simvehicle 7"), (["traffic", "f"], "simvehicle traffic"), ([], "simvehicle"),
     (["--sysid", "7", "--count", "3"], "simvehicle 7-9"), (["--count", "x", "--sysid", "7"], "simvehicle 7")],
)  # fmt: skip
def test_argv_gives_its_process_a_title(argv: list[str], title: str) -> None:
    assert title_of(argv) == title


def test_a_blocks_options_are_given_once_or_once_for_each(capfd: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    two = ["--position", "0,0,0", "--position", "5,0,0"]
    assert "--position is given 2 times" in complaint([*FINE, *two, "--count", "3"], capfd)
    assert "--position is given 2 times" in complaint([*FINE, *two], capfd)
    assert "system ids end at 254; begin at 251" in complaint([*FINE, "--sysid", "252", "--count", "4"], capfd)
    assert "give it 3 times" in complaint([*FINE, "--count", "3", "--truth", str(tmp_path / "t")], capfd)


def test_broken_or_unusable_state_is_told_in_one_sentence(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    kept = tmp_path / "1.parameters.json"
    for content, said in (
        ("{", "1.parameters.json holds no parameters"),
        ('{"NO_SUCH": 1}', "unknown parameter NO_SUCH"),
    ):
        kept.write_text(content)
        assert said in complaint([*FINE, "--state", str(tmp_path)], capfd)
    assert "--state" in complaint([*FINE, "--state", str(kept / "below")], capfd)
