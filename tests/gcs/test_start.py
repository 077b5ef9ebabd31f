"""What no command of the start loads: measured, each of these takes from 10 to 400 ms."""

import subprocess
import sys
from pathlib import Path

import pytest

LATER = {
    "asyncio",
    "distributed",
    "matplotlib",
    "pandas",
    "pyarrow",
    "pymavlink",
    "rich",
    "scipy.linalg",
    "scipy.ndimage",
    "scipy.optimize",
    "scipy.spatial",
    "scipy.stats",
    "starlette",
    "textual",
    "uvicorn",
    "xml.etree.ElementTree",
}
FLIGHT = {"numpy", "skytender.mavlink"}
MODELS = {"pydantic", "yaml"}

LISTED = """
import os, sys
from pathlib import Path

folder, program, really = Path(sys.argv.pop(1)), sys.argv.pop(1), os._exit

def leave(status):
    (folder / f"{os.getpid()}").write_text("\\n".join(sys.modules))
    really(status)

os._exit = leave
sys.argv[0] = program
if program == "gcs":
    from gcs.__main__ import main
else:
    from simvehicle.__main__ import main
main()
"""


def loaded(folder: Path, program: str, *arguments: str) -> list[set[str]]:
    """Names of the modules of each process that a command was, the command's own first."""
    folder.mkdir()
    command = [sys.executable, "-c", LISTED, str(folder), program, *arguments]
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, cwd=folder) as process:
        process.communicate()
    assert process.returncode == 0
    own = folder / str(process.pid)
    others = [path for path in folder.iterdir() if path.name.isdecimal() and path != own]
    return [set(path.read_text().splitlines()) for path in (own, *others)]


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> list[set[str]]:
    folder = tmp_path_factory.mktemp("run")
    words = ("run", "paper/example1", "--lockstep", "--quiet", "--no-report", "--set", "goal.duration_s=1")
    loaded(folder / "first", "gcs", *words, "--out", "compiled")
    return loaded(folder / "second", "gcs", *words, "--out", "flown")


def test_gcs_run_leaves_the_flight_to_its_supervisor(run: list[set[str]]) -> None:
    command, _ = run
    assert "pydantic" in command
    assert not command & (LATER | FLIGHT)


def test_the_supervisor_loads_nothing_that_only_others_need(run: list[set[str]]) -> None:
    _, supervisor = run
    assert supervisor >= FLIGHT
    assert not supervisor & LATER


def test_the_vehicles_host_loads_nothing_that_only_others_need(tmp_path: Path) -> None:
    (host,) = loaded(tmp_path / "host", "simvehicle", "fork-server")
    assert host >= FLIGHT
    assert not host & (LATER | {"pydantic"})


def test_help_loads_neither_models_nor_what_flies(tmp_path: Path) -> None:
    (command,) = loaded(tmp_path / "help", "gcs", "--help")
    assert not command & (LATER | FLIGHT | MODELS)


def test_validate_loads_nothing_that_flies(tmp_path: Path) -> None:
    (command,) = loaded(tmp_path / "validate", "gcs", "validate", "--quiet", "demo")
    assert not command & LATER


def test_vehicles_are_started_before_what_steers_them_is_loaded() -> None:
    code = "import sys, gcs.session.process; print(*sys.modules)"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "gcs.link.lockstep" in found
    assert not {"gcs.planner.planner", "gcs.recording.recorder", "gcs.supervisor.supervisor"} & set(found)
