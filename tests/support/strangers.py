"""Vehicles that a session did not start: free-running processes that end with the test."""

from __future__ import annotations

import contextlib
import os
import socket
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from sessions import ROOT

SIMVEHICLE = [sys.executable, "-c", "from simvehicle.cli import main; main()"]
ARDUCOPTER = [sys.executable, str(ROOT / "tests" / "peers" / "arducopter.py")]


WORKER, WORKERS = os.environ.get("PYTEST_XDIST_WORKER", "gw0"), int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
_given: set[int] = set()


def free_port(host: str = "127.0.0.1") -> int:
    """A UDP port that nobody has, and that no test beside this one or before it was given: one of its vehicles may
    still speak to it."""
    while True:
        with socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, socket.SOCK_DGRAM) as one:
            one.bind((host, 0))
            port = int(one.getsockname()[1])
        if port not in _given and port % WORKERS == int(WORKER.removeprefix("gw")):
            _given.add(port)
            return port


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
