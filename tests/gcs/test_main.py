"""Ctrl-C where a program of ours cannot answer it as a command does: while it loads, and beneath compiled code."""

import subprocess
import sys

import pytest

PRESSED_WHILE_LOADING = """
import signal, sys

class CtrlC:
    def find_spec(self, name, *_):
        if name == "click":
            signal.raise_signal(signal.SIGINT)

sys.meta_path.insert(0, CtrlC())
from {package}.__main__ import main
main()
"""
PRESSED_IN_A_CALLBACK = """
import ctypes, signal, threading
from gcs.cli import main as module
from gcs.__main__ import main

def command(*_, **__):
    ctypes.CFUNCTYPE(None)(lambda: signal.raise_signal(signal.SIGINT))()
    threading.Event().wait(60)

module.cli.main = command
main()
"""


@pytest.mark.parametrize("package", ["gcs", "simvehicle"])
def test_ctrl_c_while_modules_load_ends_the_program_without_a_word(package: str) -> None:
    assert ended(PRESSED_WHILE_LOADING.format(package=package)) == (130, "", "")


def test_an_ignored_ctrl_c_stays_ignored_while_modules_load() -> None:
    ignored = "import signal; signal.signal(signal.SIGINT, signal.SIG_IGN)\n"
    status, _, said = ended(ignored + PRESSED_WHILE_LOADING.format(package="gcs"), "--version")
    assert (status, said) == (0, "")


def test_ctrl_c_in_a_callback_of_compiled_code_is_not_lost() -> None:
    assert ended(PRESSED_IN_A_CALLBACK) == (130, "", "")


def ended(program: str, *words: str) -> tuple[int, str, str]:
    done = subprocess.run(
        [sys.executable, "-c", program, *words], capture_output=True, text=True, check=False, timeout=50
    )
    return done.returncode, done.stdout, done.stderr
