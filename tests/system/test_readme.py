"""What the README and the documentation have a reader type, each as it is printed there."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from pages import PAGES, README, ROOT, files, run_lines, terminal_lines

PRINTED = README.read_text(encoding="utf-8")
PROGRAMS = Path(sys.executable).parent
COMMANDS = [
    line.split("  #")[0].strip()
    for line in PRINTED.splitlines()
    if re.match(r"^ {4}(gcs|simvehicle|make|skytender) [a-z-]", line) and "──" not in line and "→" not in line
]
TYPED = [line for page in PAGES for line in terminal_lines(page)]
BUILT_UPON = {"gcs init mine"}
"""What others of these need, and so is typed here too."""
ELSEWHERE = {
    **{line: "tests/system/test_docs_pages.py" for page in PAGES for line in run_lines(page)},
    "make run": "`gcs run demo` in an environment that it makes",
    "make test": "runs this",
    "make bench": "takes minutes",
    "make docs": "tests/test_docs.py builds the site",
    "python tests/benchmarks --only 1,3": "takes minutes",
    "git clone … skytender && cd skytender": "the checkout is here",
    "python3 -m venv .venv && . .venv/bin/activate": "the environment is here",
    "pip install '.[pandas,parquet,plots]'": "tests/system/test_wheel.py installs what is built",
    'eval "$(_GCS_COMPLETE=bash_source gcs)"': "the completion is tested below",
    'eval "$(_SIMVEHICLE_COMPLETE=bash_source simvehicle)"': "likewise",
    "gcs mission set survey.plan": "tests/system/test_fleet_missions.py",
    "gcs mission show survey.plan": "tests/gcs/cli/test_mission.py",
    "python fly_with_mavsdk.py": "tests/peers/test_docs.py, where MAVSDK is",
    "gcs check --connect udpin:127.0.0.1:14550": "tests/system/test_check.py",
    "gcs check --connect udpin:127.0.0.1:14550 --arm": "tests/system/test_check.py",
    "gcs check --connect udpin:127.0.0.1:14550 --json": "tests/system/test_check.py",
    "SKYTENDER_PX4=~/PX4-Autopilot/build/px4_sitl_default python -m pytest "
    "tests/peers/test_real_px4.py tests/system/test_real_fleet.py tests/system/test_real_returns.py": "needs a PX4",
    "SKYTENDER_ARDUCOPTER=~/ardupilot/build/sitl/bin/arducopter python -m pytest "
    "tests/peers/test_real_arducopter.py tests/system/test_real_fleet.py "
    "tests/system/test_real_returns.py": "needs an ArduCopter",
}
"""What is not typed here, and why."""
UNTIL = {
    "gcs run demo": "Take-off",
    "gcs run demo --forward udpout:127.0.0.1:14550": "Take-off",
    "gcs run demo --web": "page: http://127.0.0.1:",
    "gcs run demo --lockstep --json": '"type": "snapshot"',
    "gcs run fleet": "Take-off",
    "gcs run external.yaml --plain": "pursuer 3: ",
    "gcs monitor": "offboard",
    "gcs monitor --connect udpin:127.0.0.1:14550": "First heard of",
    "gcs replay flown": "Take-off",
    "gcs launch demo": "tanker",
    "gcs launch demo --json --until-eof": '"vehicles"',
    "gcs launch demo --connect udpout:127.0.0.1:14550": "tanker",
    "simvehicle --sysid 1 --connect udpout:127.0.0.1:14550": "vehicle 1: ",
    "simvehicle --sysid 2 --connect udpin:127.0.0.1:14541 --autopilot ardupilot": "vehicle 2: ",
    "simvehicle --sysid 1 --count 25 --connect udpout:127.0.0.1:14550": "vehicle 25: ",
}
"""What goes on until someone ends it: the words on stdout after which Ctrl-C does."""
GROWS = {"gcs run demo --lockstep --quiet --out flown": "flown/session.tlog"}
"""What would go on for long without a word: the file after whose first MB Ctrl-C ends it. To its end
`tests/system/test_demo.py` flies it."""

ONE_VEHICLE = "simvehicle --sysid 1 --connect udpout:127.0.0.1:14550"
COMPANIONS = {
    "gcs monitor": "gcs run demo --plain",
    "gcs monitor --connect udpin:127.0.0.1:14550": ONE_VEHICLE,
    "gcs check --connect udpin:127.0.0.1:14550 --wait-ready 60": ONE_VEHICLE,
    "gcs params get 'RTL_*'": ONE_VEHICLE,
    "gcs logs get": ONE_VEHICLE,
    "gcs check external.yaml": ONE_VEHICLE.replace("sysid 1", "sysid 3"),
    "gcs run external.yaml --plain": ONE_VEHICLE.replace("sysid 1", "sysid 3"),
}
"""What runs meanwhile in the reader's other terminal."""


@contextmanager
def beside(command: str, folder: Path) -> Iterator[None]:
    """Its companion, if it has one, until it has said a first line and from then on."""
    if command not in COMPANIONS:
        yield
        return
    argv = words(COMPANIONS[command])
    with subprocess.Popen(argv, cwd=folder, stdout=subprocess.PIPE, text=True, env=environment()) as companion:
        assert companion.stdout is not None
        lines = iter(companion.stdout.readline, "")
        assert any(re.match(r"vehicle \d+: ", line) or "Offboard" in line for line in lines)
        try:
            yield
        finally:
            companion.send_signal(signal.SIGINT)
            companion.communicate(timeout=60)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where a reader stands, with the files that the pages print; the README's commands build upon each other."""
    folder = tmp_path_factory.mktemp("reader")
    for page in PAGES:
        for name, text in files(page).items():
            (folder / name).write_text(text, encoding="utf-8")
    return folder


def words(command: str) -> list[str]:
    program, *rest = shlex.split(command)
    return [str(PROGRAMS / program), *rest]


def environment() -> dict[str, str]:
    return {**os.environ, "PYTHONUNBUFFERED": "1"}


def test_the_commands_are_found() -> None:
    assert {"make run", "gcs init mine", "gcs doctor", "gcs replay flown"} <= set(COMMANDS)
    run_by_pages = {line for page in PAGES for line in run_lines(page)}
    assert {*ELSEWHERE, *UNTIL, *COMPANIONS} - run_by_pages <= {*COMMANDS, *TYPED}


@pytest.mark.parametrize(
    "command", [c for c in dict.fromkeys([*COMMANDS, *TYPED]) if c in BUILT_UPON or c not in ELSEWHERE]
)
def test_a_command_does_what_the_reader_expects(command: str, folder: Path) -> None:
    with beside(command, folder):
        does_what_is_said(command, folder)


def does_what_is_said(command: str, folder: Path) -> None:
    if command in UNTIL or command in GROWS:
        process = subprocess.Popen(
            words(command),
            cwd=folder,
            stdin=subprocess.PIPE if "--until-eof" in command else None,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=environment(),
        )
        assert process.stdout is not None
        try:
            if command in GROWS:
                said = has_grown(folder / GROWS[command], process)
            else:
                said = any(UNTIL[command] in line for line in process.stdout)
            process.send_signal(signal.SIGINT)
            _, errors = process.communicate(timeout=60)
            assert said, (process.returncode, errors)
        finally:
            process.kill()
            process.communicate()
        assert process.returncode in (0, 130), errors
        return
    done = subprocess.run(words(command), cwd=folder, capture_output=True, text=True, timeout=100, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def has_grown(file: Path, process: subprocess.Popen[str]) -> bool:
    """Whether a file has come to a MB before its process ended."""
    while process.poll() is None:
        if file.exists() and file.stat().st_size > 1e6:
            return True
        with suppress(subprocess.TimeoutExpired):
            process.wait(0.1)
    return False


def test_the_program_flies_the_readers_scenario(folder: Path) -> None:
    if not (folder / "mine.yaml").exists():
        subprocess.run(words("gcs init mine"), cwd=folder, check=True, capture_output=True)
    (printed,) = re.findall(r"```python\n(.*?)```", PRINTED, re.DOTALL)
    program = [sys.executable, "-W", "error", "-c", printed]
    done = subprocess.run(program, cwd=folder, capture_output=True, text=True, timeout=100, check=False)
    assert done.returncode == 0, done.stderr
    first, lowest = done.stdout.splitlines()
    assert re.fullmatch(r"met \[2(, \d+)*\]", first)
    assert re.match(r"\{1: 0\.\d+, 2: 0\.\d+, ", lowest)


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
@pytest.mark.parametrize("program", ["gcs", "simvehicle"])
def test_a_shell_gets_its_completion(program: str, shell: str) -> None:
    asked = {**os.environ, f"_{program.upper()}_COMPLETE": f"{shell}_source"}
    done = subprocess.run(words(program), env=asked, capture_output=True, text=True, check=False)
    if shell == "bash" and shutil.which("bash") is None:
        pytest.skip("no bash here")
    assert program in done.stdout


def test_an_option_of_the_vehicle_is_completed() -> None:
    asked = {
        **os.environ, "_SIMVEHICLE_COMPLETE": "bash_complete", "COMP_WORDS": "simvehicle --auto", "COMP_CWORD": "1"
    }  # fmt: skip
    done = subprocess.run(words("simvehicle"), env=asked, capture_output=True, text=True, check=False)
    assert "plain,--autopilot" in done.stdout.splitlines()


def test_a_shipped_scenario_is_completed() -> None:
    asked = {**os.environ, "_GCS_COMPLETE": "bash_complete", "COMP_WORDS": "gcs run paper/", "COMP_CWORD": "2"}
    done = subprocess.run(words("gcs"), env=asked, capture_output=True, text=True, check=False)
    assert "plain,paper/example1" in done.stdout.splitlines()


def test_the_ci_example_runs_the_demo_in_lockstep_and_keeps_its_folder() -> None:
    text = (ROOT / ".github" / "workflows" / "demo.yml").read_text(encoding="utf-8")
    flown = next(line for line in text.splitlines() if "gcs run" in line)
    assert "demo --lockstep" in flown
    out = flown.split("--out ")[1].split()[0]
    assert f"            {out}\n" in text.split("upload-artifact")[1]
