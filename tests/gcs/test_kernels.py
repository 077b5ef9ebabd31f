"""Kernels on disk: compiled once, read without the compiler, compiled anew when their source changes."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

SOURCE = """
from {package}.kernels import kernel

@kernel()
def least(values):
    return values.min() + {offset}
"""
PROGRAM = """
import sys
import numpy as np
from source import least
print(least(np.array([3.0, 2.0])), "numba.np.arraymath" in sys.modules, least.stats.cache_hits[least.signatures[0]])
"""


@pytest.mark.parametrize("package", ["gcs", "simvehicle"])
def test_a_kernel_is_compiled_once_and_again_when_its_source_changes(package: str, tmp_path: Path) -> None:
    def printed(offset: float) -> list[str]:
        (tmp_path / "source.py").write_text(SOURCE.format(package=package, offset=offset))
        environment = os.environ | {
            "NUMBA_CACHE_DIR": str(tmp_path / "kept"),
            "PYTHONPATH": os.pathsep.join([str(tmp_path), *filter(None, [os.environ.get("PYTHONPATH")])]),
        }
        command = [sys.executable, "-c", PROGRAM]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout.split()

    assert printed(1.5) == ["3.5", "True", "0"]
    assert printed(1.5) == ["3.5", "False", "1"]
    assert printed(-1.5) == ["0.5", "True", "0"]
