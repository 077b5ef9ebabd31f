"""Nothing that a session calls is left to be compiled when the first grant goes out."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

SHOW = """
import json
from numba.core.dispatcher import Dispatcher
from gcs import metrics
from gcs.rehearsal import rehearse
from gcs.configs import find
from gcs.planner import fuzzy, leader, obstacles, potential_field
from gcs.scenario import load

rehearse(load(find("demo")))
modules = (metrics, leader, fuzzy, obstacles, potential_field)
print(json.dumps([
    name
    for module in modules
    for name, it in vars(module).items()
    if isinstance(it, Dispatcher) and it.py_func.__module__ == module.__name__ and not it.signatures
]))
"""


@pytest.fixture(scope="module")
def uncompiled() -> list[str]:
    """Functions that a process of its own has not compiled after `rehearse`."""
    done = subprocess.run([sys.executable, "-c", SHOW], capture_output=True, text=True, check=True)
    found: list[str] = json.loads(done.stdout)
    return found


@pytest.mark.parametrize("entry", ["_advance_all", "_least_separation", "_distance_to_path"])
def test_what_python_calls_is_compiled(uncompiled: list[str], entry: str) -> None:
    assert entry not in uncompiled
