"""A program of ours ends at once, with the status that it has come to and all that it has said."""

import os
import subprocess
import sys

import pytest

BUFFERED = {name: value for name, value in os.environ.items() if name != "PYTHONUNBUFFERED"}
LEAVES = """
import atexit, sys
from skytender.exit import leave
atexit.register(lambda: print("torn down"))
sys.stdout.write("said")
sys.stderr.write("complained")
leave(int(sys.argv[1]))
"""


def left(status: int, stdout: int) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", LEAVES, str(status)]
    return subprocess.run(command, stdout=stdout, stderr=subprocess.PIPE, text=True, check=False, env=BUFFERED)


@pytest.mark.parametrize("status", [0, 70])
def test_what_was_said_is_out_and_nothing_is_torn_down(status: int) -> None:
    done = left(status, subprocess.PIPE)
    assert (done.returncode, done.stdout, done.stderr) == (status, "said", "complained")


@pytest.mark.parametrize(("status", "ends"), [(0, 1), (130, 130)])
def test_what_cannot_be_written_is_no_success(status: int, ends: int) -> None:
    with open("/dev/full", "wb") as full:
        done = left(status, full.fileno())
    assert done.returncode == ends
    assert "<stdout> cannot be written: No space left on device" in done.stderr


def test_a_reader_that_has_gone_is_no_error() -> None:
    read, write = os.pipe()
    os.close(read)
    try:
        done = left(0, write)
    finally:
        os.close(write)
    assert (done.returncode, done.stderr) == (0, "complained")
