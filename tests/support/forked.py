"""pytest whose workers are forked from a process that has imported all tests: `forked.py 8 OPTIONS`.

A worker by itself imports for seconds what other workers run. xdist starts each as a Python of its own
(`popen//python=…`): that Python is this file again, which hands its files to the process that has imported, and ends
with the worker that is forked there. What a module makes when it is imported, all workers have: ports and the like, of
which each needs its own, are made when they are first asked for.
"""

from __future__ import annotations

import contextlib
import io
import os
import select
import signal
import socket
import subprocess
import sys
import tempfile
from pathlib import Path

STANDARD_FILES = (0, 1, 2)


def ask_for_a_worker(address: str) -> None:
    """Hand over this process's files; the other end is closed when the worker ends, however it does."""
    with socket.socket(socket.AF_UNIX) as there:
        there.connect(address)
        socket.send_fds(there, [b"files"], STANDARD_FILES)
        there.recv(1)


def work(asked: socket.socket) -> None:
    """Be a worker on the files that come, as execnet's Python is: its first line is a program."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for standard, given in zip(STANDARD_FILES, socket.recv_fds(asked, 8, len(STANDARD_FILES))[1], strict=True):
        os.dup2(given, standard)
        os.close(given)
    sys.argv = ["-c"]
    exec(eval(sys.stdin.readline()), {"__name__": "__main__"})


def main(count: str, *options: str) -> int:
    """The status of a run with so many workers."""
    import pytest  # noqa: PLC0415 - who asks for a worker needs none

    with contextlib.redirect_stdout(io.StringIO()):  # what is wrong is said where it is collected again
        pytest.main(["--collect-only", *options])
    workers = []
    with tempfile.TemporaryDirectory() as folder, socket.socket(socket.AF_UNIX) as listener:
        listener.bind(address := f"{folder}/workers")
        listener.listen()
        python = f"{sys.executable} -S {Path(__file__).resolve()} {address}"
        command = [sys.executable, "-m", "pytest", "--tx", f"{count}*popen//python={python}", *options]
        with subprocess.Popen(command) as controller:
            signal.signal(signal.SIGINT, signal.SIG_IGN)
            ended = os.pidfd_open(controller.pid)
            while ended not in select.select([listener, ended], [], [])[0]:
                asked, _ = listener.accept()
                workers.append(os.fork())
                if workers[-1] == 0:
                    try:
                        listener.close()
                        work(asked)
                    finally:
                        os._exit(0)
                asked.close()
        for worker in workers:
            os.waitpid(worker, 0)
    return controller.returncode


if __name__ == "__main__":
    if sys.argv[1].startswith("/"):
        ask_for_a_worker(sys.argv[1])
    else:
        sys.exit(main(*sys.argv[1:]))
