"""Figure 11: a short session from prompt to prompt, beside importing alone what it is made of and its flight."""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from measure import Figure

ROUNDS = 5
IMPORTS = "import numpy, pydantic, pymavlink"
ALLOWED = 1.2
"""times the imports, and the flight"""


def figures() -> list[Figure]:
    """Wall time on a machine that does nothing else, in rounds that alternate."""
    fly()  # so that bytecode is there, as it is from the second session on
    rounds = []
    for _ in range(ROUNDS):
        took_s, flight_s = fly()
        rounds.append((took_s, flight_s, took([sys.executable, "-c", IMPORTS])))
    took_s, flight_s, imports_s = (statistics.median(column) for column in zip(*rounds, strict=True))
    return [
        Figure(
            11, "gcs run paper/example1, from prompt to prompt", took_s, "s", ALLOWED * imports_s + flight_s, True,
            peer=f"{IMPORTS}, and its flight", peer_value=imports_s + flight_s,
        ),
        Figure(11, "  all but its flight", took_s - flight_s, "s", peer=IMPORTS, peer_value=imports_s, at_most=True),
    ]  # fmt: skip


def fly() -> tuple[float, float]:
    """Wall time of the whole command, s, and of its flight."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "session"
        command = [sys.executable, "-m", "gcs", "run", "paper/example1", "--lockstep", "--quiet", "--no-report"]
        took_s = took([*command, "--out", str(out)])
        summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    return took_s, summary["wall_time_s"]


def took(command: list[str]) -> float:
    """Wall time of a command that may keep its bytecode, s."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    begun_s = time.perf_counter()
    subprocess.run(command, env=environment, check=True)
    return time.perf_counter() - begun_s
