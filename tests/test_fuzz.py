"""A short part of `make fuzz`, the same in every run."""

import subprocess
import sys
from pathlib import Path

FUZZ = Path(__file__).parent / "fuzz"
TARGETS, READERS = 5, 5


def test_hostile_input_harms_nothing() -> None:
    command = [sys.executable, str(FUZZ), "--within", "--frames", "1000", "--files", "20"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    lines = done.stdout.splitlines()
    assert len(lines) == TARGETS + READERS
    assert all(line.endswith("  ok") for line in lines)
