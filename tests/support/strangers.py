"""Vehicles that a session did not start: free-running processes that end with the test."""

from __future__ import annotations

import contextlib
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from sessions import ROOT

SIMVEHICLE = [sys.executable, "-c", "from simvehicle.cli import main; main()"]
ARDUCOPTER = [sys.executable, str(ROOT / "tests" / "peers" / "arducopter.py")]


@contextmanager
def strangers(folder: Path, *commands: Sequence[str]) -> Iterator[list[Path]]:
    """Start each; the files that hold what they say. All are gone at the end."""
    folder.mkdir(parents=True, exist_ok=True)
    with contextlib.ExitStack() as stack:
        logs: list[Path] = []
        for i, command in enumerate(commands):
            logs.append(folder / f"stranger{i + 1}.log")
            said = stack.enter_context(logs[-1].open("wb"))
            process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=said, stderr=said)
            stack.enter_context(process)
            stack.callback(process.kill)
        yield logs
