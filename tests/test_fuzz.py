"""A short part of `make fuzz`, the same in every run."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

FUZZ = Path(__file__).parent / "fuzz"
TARGETS, READERS = 8, 10


def test_hostile_input_harms_nothing() -> None:
    command = [sys.executable, str(FUZZ), "--within", "--frames", "1000", "--files", "20"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    lines = done.stdout.splitlines()
    assert len(lines) == TARGETS + READERS
    assert all(line.endswith("  ok") for line in lines)


@pytest.mark.slow
def test_nor_does_input_that_coverage_finds(tmp_path: Path) -> None:
    """What earlier campaigns have found, and some runs beyond it, guided by the vehicle's branches alone."""
    pytest.importorskip("atheris")
    runs = {"datagrams": 2000, "scenario": 200, "answers": 500, "rows": 100, "signed frames": 300, "packed": 100}
    targets = [word for name, count in runs.items() for word in ("--target", f"{name}:{count}")]
    command = [sys.executable, str(FUZZ / "guided.py"), *targets]
    looks_into = {**os.environ, "FUZZ_LOOKS_INTO": "simvehicle"}
    done = subprocess.run(
        command, capture_output=True, text=True, errors="replace", cwd=tmp_path, check=False, env=looks_into
    )
    assert done.returncode == 0, done.stderr
    assert [int(count) for count in re.findall(r"Done (\d+) runs", done.stderr)] == list(runs.values())
