"""Every start of a program in the source, and an interpreter that finds no module in the current folder."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from gcs.processes.python import SAFE_PATH, safe_path, start_python

ROOT = Path(__file__).resolve().parents[3]
STARTS = {
    "asyncio": ("create_subprocess_exec", "create_subprocess_shell"),
    "os": ("exec", "posix_spawn", "spawn", "system", "popen", "startfile"),
    "pty": ("spawn",),
    "runpy": ("",),
    "subprocess": ("Popen", "run", "call", "check_", "getoutput", "getstatusoutput"),
    "multiprocessing": ("Process", "Pool", "get_context", "set_executable", "popen", "context"),
    "sys": ("executable",),
}
"""Names by module, or what they begin with, that start a program or name the interpreter."""
POOLS = ("ProcessPoolExecutor", "LocalCluster")
MAY_START = re.compile(rf"\b({'|'.join((*POOLS, *STARTS))})\b")
KNOWN = {
    ("gcs.processes.python", "subprocess.Popen"): "our modules",
    ("gcs.processes.python", "sys.executable"): "the interpreter",
    ("gcs.campaign.pool", "multiprocessing.get_context"): "a campaign's workers, with PYTHONSAFEPATH",
    ("gcs.processes.fork_server", "subprocess.Popen"): "simvehicle",
    ("gcs.cli.doctor", "subprocess.run"): "simvehicle --version",
    ("gcs.report.paper.vehicle", "subprocess.run"): "simvehicle paper",
    ("simvehicle.sitl.autopilot_process", "subprocess.Popen"): "ArduPilot or PX4",
}
"""Every start that there is, and what it starts; only the first starts an interpreter by itself."""


def started(tree: ast.AST) -> Iterator[str]:
    """Names in a module that start a program, but for its types and what an f-string prints."""
    passed_over: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.FormattedValue):
            passed_over |= {id(one) for one in ast.walk(node)}
        hints = [getattr(node, "annotation", None), getattr(node, "returns", None)]
        passed_over |= {id(one) for hint in hints if hint is not None for one in ast.walk(hint)}
        if id(node) in passed_over:
            continue
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            module, name = node.value.id, node.attr
        elif isinstance(node, ast.ImportFrom):
            for alias in node.names:
                module = str(node.module).partition(".")[0]
                if alias.name in POOLS or (module in STARTS and alias.name.startswith(STARTS[module])):
                    yield f"{module}.{alias.name}"
            continue
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if re.match(r"multiprocessing\.|pty|runpy", alias.name))
            continue
        else:
            continue
        if module in STARTS and name.startswith(STARTS[module]):
            yield f"{module}.{name}"


def test_each_start_of_a_program_is_known_and_one_alone_starts_an_interpreter() -> None:
    found = set()
    for program in ("gcs", "simvehicle"):
        for path in (ROOT / program).rglob("*.py"):
            module = ".".join(path.relative_to(ROOT).with_suffix("").parts)
            text = path.read_text(encoding="utf-8")
            if MAY_START.search(text):
                found |= {(module, name) for name in started(ast.parse(text))}
    assert found == set(KNOWN)


@pytest.mark.parametrize(
    "source",
    [
        "import subprocess, sys\nsubprocess.run([sys.executable, '-m', 'x'])",
        "from subprocess import Popen",
        "import os\nos.spawnl(0, 'python3')",
        "from concurrent.futures import ProcessPoolExecutor",
        "import multiprocessing.pool",
    ],
)
def test_no_way_to_start_an_interpreter_is_overlooked(source: str) -> None:
    assert list(started(ast.parse(source)))


@pytest.fixture
def hostile(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The current folder, where modules of the standard library's names lie; `probe` is found beside it."""
    (tmp_path / "here").mkdir()
    for name in ("selectors", "sitecustomize", "mine"):
        (tmp_path / "here" / f"{name}.py").write_text("from pathlib import Path\nPath('ran').touch()\n")
    (tmp_path / "found").mkdir()
    (tmp_path / "found" / "probe.py").write_text(
        "import selectors, subprocess, sys\nsubprocess.run([sys.executable, '-c', 'import selectors'], check=True)\n"
    )
    monkeypatch.chdir(tmp_path / "here")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path / "found"))
    monkeypatch.delenv(SAFE_PATH, raising=False)
    return tmp_path / "here"


@pytest.mark.parametrize(("module", "ends"), [("mine", 1), ("probe", 0)])
def test_what_is_started_runs_nothing_of_the_current_folder_nor_does_what_it_starts(
    hostile: Path, module: str, ends: int
) -> None:
    with start_python(module, stderr=subprocess.DEVNULL) as process:
        pass
    assert (process.returncode, (hostile / "ran").exists()) == (ends, False)


def test_what_a_library_starts_runs_nothing_of_it_either(hostile: Path) -> None:
    command = [sys.executable, "-c", "import selectors"]  # as multiprocessing does: no word of -P
    with safe_path():
        subprocess.run(command, check=True)
    assert not (hostile / "ran").exists()
    subprocess.run(command, check=True)
    assert (hostile / "ran").exists(), "the attack itself works"
