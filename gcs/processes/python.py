"""The one place where Python is started: modules of ours by name, and the children of libraries that start it too.

An interpreter that is started with `-m` or `-c` looks for modules in the current folder first. A stranger's `yaml.py`
that lies there would run, so every one of ours has `-P`, and PYTHONSAFEPATH for what it starts itself. A program of
the user's gets none of that (skytender.processes.environment_for_programs).
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from skytender.processes import BY_US, SAFE_PATH


def start_python(
    module: str, *words: str, env: Mapping[str, str] | None = None, **streams: Any
) -> subprocess.Popen[bytes]:
    """Start `python -m MODULE WORDS…` with this interpreter; `streams` as of subprocess.Popen. Raises OSError."""
    environment = os.environ if env is None else env
    safe = {**environment, SAFE_PATH: environment.get(SAFE_PATH) or BY_US}
    return subprocess.Popen([sys.executable, "-P", "-m", module, *words], env=safe, **streams)


@contextlib.contextmanager
def safe_path() -> Iterator[None]:
    """Let interpreters that a library starts meanwhile, as multiprocessing does, look for modules as ours do."""
    before = os.environ.get(SAFE_PATH)
    os.environ[SAFE_PATH] = before or BY_US
    try:
        yield
    finally:
        if before is None:
            del os.environ[SAFE_PATH]
        else:
            os.environ[SAFE_PATH] = before


def current_folders() -> list[Path]:
    """The current folder, where a user's modules may lie; none where it has been removed."""
    try:
        return [Path.cwd()]
    except FileNotFoundError:
        return []


def beside_python(program: str) -> Path:
    """Where a program that was installed with this interpreter lies."""
    return Path(sys.executable).with_name(program)
