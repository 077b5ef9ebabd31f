"""A short part of `make fuzz`, the same in every run."""

import subprocess
import sys
from pathlib import Path

import pytest

FUZZ = Path(__file__).parent / "fuzz"


@pytest.mark.parametrize("target", ["simvehicle", "supervised link", "external link", "monitor", "session.sock"])
def test_hostile_input_harms_nothing(target: str) -> None:
    command = [sys.executable, str(FUZZ), "--within", "--only", target, "--frames", "2000", "--files", "20"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.stdout.rstrip().endswith("  ok"), done.stdout + done.stderr
