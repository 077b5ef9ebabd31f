"""A forked process by its pipes, its end and what it has of ours."""

import subprocess
import sys

import pytest

BEGINNING = """
import os, signal, subprocess, sys, threading, time
from gcs.processes.forked import ForkedProcess, can_fork

def echo():
    print(os.read(0, 99).decode(), os.getsid(0) == os.getpid(), sorted(os.listdir("/proc/self/fd")), flush=True)
    return 7

def wait():
    return len(os.read(0, 99))

def fail():
    raise RuntimeError("of no use")

"""


def printed(program: str) -> tuple[str, str]:
    """Standard output and error of a program that begins so."""
    done = subprocess.run(
        [sys.executable, "-c", BEGINNING + program], capture_output=True, text=True, timeout=50, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout, done.stderr


def test_it_has_its_pipes_a_session_of_its_own_and_nothing_else_of_ours() -> None:
    out, _ = printed("""
kept = os.open("/dev/null", os.O_RDONLY)
child = ForkedProcess(echo, "echo")
child.stdin.write(b"word")
child.stdin.close()
print(child.stdout.read().decode().strip(), child.wait(20), child.poll())
""")
    assert out == "word True ['0', '1', '2', '3'] 7 7\n"  # 3 is the listing's own


def test_its_end_is_waited_for_as_long_as_wanted_and_a_signal_is_its_status() -> None:
    out, _ = printed("""
child = ForkedProcess(wait, "wait")
try:
    child.wait(0.01)
except subprocess.TimeoutExpired:
    print("not yet", child.poll())
child.kill()
print(child.wait(20) == -signal.SIGKILL)
""")
    assert out == "not yet None\nTrue\n"


def test_an_error_is_its_traceback_and_status() -> None:
    out, err = printed('print(ForkedProcess(fail, "fail").wait(20))')
    assert out == "70\n"
    assert "of no use" in err


@pytest.mark.parametrize(
    ("before", "can"),
    [("", True), ("threading.Thread(target=time.sleep, args=(1,), daemon=True).start()", False)],
    ids=["alone", "with a thread"],
)
def test_a_process_with_threads_is_not_forked(before: str, can: bool) -> None:
    assert printed(f"{before}\nprint(can_fork())")[0] == f"{can}\n"
