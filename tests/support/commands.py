"""A command line of `gcs` run in this process: what it says and its status, without a start of Python for each."""

from __future__ import annotations

import contextlib
import io
import subprocess

from gcs.cli.main import run_argv


def gcs(*argv: str) -> subprocess.CompletedProcess[str]:
    """The command's end, as a process would tell it."""
    said, complained = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(complained):
        status = run_argv(list(argv))
    return subprocess.CompletedProcess(argv, status, said.getvalue(), complained.getvalue())
