"""The README's commands and programs, each as it is printed there."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
import yaml
from sessions import ROOT, small

README = (ROOT / "README.md").read_text(encoding="utf-8")
PROGRAMS = Path(sys.executable).parent
COMMANDS = [
    line.split("  #")[0].strip()
    for line in README.splitlines()
    if re.match(r"^ {4}(gcs|simvehicle|make|skytender) [a-z-]", line) and "──" not in line and "→" not in line
]
MAKE = {"make run", "make test", "make bench"}
"""`make test` runs this, `make run` is `gcs run demo` in the same environment, and `make bench` takes minutes."""
UNTIL = {
    "gcs run demo": "Take-off",
    "gcs run demo --lockstep --plain": "Take-off",
    "gcs run demo --lockstep --json": '"type": "snapshot"',
    "gcs run fleet": "Take-off",
    "gcs monitor": "offboard",
    "gcs monitor --connect udpin:127.0.0.1:14550": "First heard of",
    "gcs replay flown": "Take-off",
    "gcs launch demo": "tanker",
    "gcs launch demo --json": '"vehicles"',
    "gcs launch demo --connect udpout:127.0.0.1:14550": "tanker",
    "simvehicle --sysid 1 --connect udpout:127.0.0.1:14550": "vehicle 1: ",
    "simvehicle --sysid 1 --count 25 --connect udpout:127.0.0.1:14550": "vehicle 25: ",
}
"""What goes on until someone ends it: the words on stdout after which Ctrl-C does."""

COMPANIONS = {
    "gcs monitor": "gcs run demo --plain",
    "gcs monitor --connect udpin:127.0.0.1:14550": "simvehicle --sysid 1 --connect udpout:127.0.0.1:14550",
    "gcs check --connect udpin:127.0.0.1:14550": "simvehicle --sysid 1 --connect udpout:127.0.0.1:14550",
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
        assert any("vehicle 1: " in line or "offboard" in line for line in lines)
        try:
            yield
        finally:
            companion.send_signal(signal.SIGINT)
            companion.communicate(timeout=60)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where a reader stands; the README's commands build upon each other."""
    return tmp_path_factory.mktemp("reader")


def words(command: str) -> list[str]:
    program, *rest = shlex.split(command)
    return [str(PROGRAMS / program), *rest]


def environment() -> dict[str, str]:
    return {**os.environ, "PYTHONUNBUFFERED": "1"}


def test_the_commands_are_found() -> None:
    assert set(COMMANDS) >= MAKE | set(UNTIL) | {"gcs init mine", "gcs doctor", "gcs schema"}


@pytest.mark.parametrize("command", [c for c in dict.fromkeys(COMMANDS) if c not in MAKE])
def test_a_command_does_what_the_reader_expects(command: str, folder: Path) -> None:
    with beside(command, folder):
        does_what_is_said(command, folder)


def does_what_is_said(command: str, folder: Path) -> None:
    if command in UNTIL:
        process = subprocess.Popen(
            words(command), cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment()
        )
        assert process.stdout is not None
        try:
            assert any(UNTIL[command] in line for line in process.stdout)
            process.send_signal(signal.SIGINT)
            _, errors = process.communicate(timeout=60)
        finally:
            process.kill()
            process.communicate()
        assert process.returncode in (0, 130), errors
        return
    done = subprocess.run(words(command), cwd=folder, capture_output=True, text=True, timeout=100, check=False)
    # The demo breaks its goal's traffic part today, 0.43 m where 0.6 m is wanted (tests/system/test_demo.py, NOT_YET).
    assert done.returncode == (1 if command.startswith("gcs run demo") else 0), done.stdout + done.stderr
    if "--decide" in command:
        assert "decisions" in done.stdout
        assert done.stdout.rstrip().endswith("agree")
    if command == "gcs schema":
        json.loads(done.stdout)
    if "--junit" in command:
        assert "testsuite" in (folder / "outcome.xml").read_text()


def blocks() -> dict[str, str]:
    found = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    names = ("session", "planner", "policy", "fleet")
    assert len(found) == len(names)
    return dict(zip(names, found, strict=True))


def test_the_program_flies_the_readers_scenario(folder: Path) -> None:
    if not (folder / "mine.yaml").exists():
        subprocess.run(words("gcs init mine"), cwd=folder, check=True, capture_output=True)
    program = [sys.executable, "-W", "error", "-c", blocks()["session"]]
    done = subprocess.run(program, cwd=folder, capture_output=True, text=True, timeout=100, check=False)
    assert done.returncode == 0, done.stderr
    first, *rest = done.stdout.splitlines()
    assert re.fullmatch(r"met \[2(, \d+)*\]", first)
    assert any(line.startswith("2 ") for line in rest)


def test_the_printed_planner_and_policy_are_the_tested_examples() -> None:
    printed = blocks()
    for name in ("planner", "policy"):
        example = (ROOT / "tests" / "examples" / f"my_{name}.py").read_text(encoding="utf-8")
        assert example.split('"""\n\n', 1)[1] == printed[name]


def test_the_printed_test_passes_in_the_readers_own_suite(folder: Path) -> None:
    (folder / "test_mine.py").write_text(blocks()["fleet"])
    run = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "test_mine.py"]
    done = subprocess.run(run, cwd=folder, capture_output=True, text=True, timeout=100, check=False)
    assert "1 passed" in done.stdout, done.stdout + done.stderr


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_a_shell_gets_its_completion(shell: str) -> None:
    asked = {**os.environ, "_GCS_COMPLETE": f"{shell}_source"}
    done = subprocess.run(words("gcs"), env=asked, capture_output=True, text=True, check=False)
    if shell == "bash" and shutil.which("bash") is None:
        pytest.skip("no bash here")
    assert "gcs" in done.stdout


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


def test_the_printed_vehicles_of_ones_own_and_bases_make_a_scenario(tmp_path: Path) -> None:
    external, bases = (yaml.safe_load(block) for block in re.findall(r"```yaml\n(.*?)```", README, re.DOTALL))
    content = small(clock={"mode": "real", "speed": 1.0}) | bases
    content["vehicles"] = content["vehicles"] | external["vehicles"]
    (tmp_path / "own.yaml").write_text(yaml.safe_dump(content))
    done = subprocess.run(words("gcs validate own.yaml"), cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "pursuer 3" in done.stdout
