"""Kernels on disk: compiled once, read without the compiler, compiled anew when their source changes."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numba import njit
from numba.core.errors import TypingError

from simvehicle.kernels import UNCOUNTED

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


def test_an_uncounted_function_counts_no_references_and_refuses_to_make_an_array() -> None:
    row = np.array([3.0, 2.0])

    def foot(values: Any) -> Any:
        while values.size > 1 and values[0] > values[1]:
            values = values[1:]
        return values[0]

    code = {}
    for name, options in (("usual", {}), ("uncounted", UNCOUNTED)):
        compiled: Any = njit(**options)(foot)
        assert compiled(row) == 2.0
        code[name] = compiled.inspect_llvm(compiled.signatures[0])
    assert "NRT_incref" in code["usual"]
    assert "NRT_incref" not in code["uncounted"]

    @njit(**UNCOUNTED)  # type: ignore[untyped-decorator]
    def longer(values: Any) -> Any:
        return np.zeros(values.size + 1)

    with pytest.raises(TypingError, match="zeros"):
        longer(row)
