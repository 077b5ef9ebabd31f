"""A function in a fork of this process, as subprocess.Popen runs a program; and the end of both."""

from __future__ import annotations

import os
import select
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Collection
from typing import IO, Protocol

from skytender.processes import fork


def can_fork() -> bool:
    """Whether a fork of this process is whole: no other thread would be missing there, and no standard stream is."""
    return threading.active_count() == 1 and None not in (sys.__stdin__, sys.__stdout__, sys.__stderr__)


class Process(Protocol):
    """A running program, as subprocess.Popen has it."""

    def wait(self, timeout: float | None = None) -> int | None: ...
    def kill(self) -> None: ...


def end(process: Process, patience_s: float) -> None:
    """Wait for the end of a child that has been asked for it; kill it where that takes longer."""
    try:
        process.wait(timeout=patience_s)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


class ForkedProcess:
    """A child that calls a function and ends with the exit status that it returns; it may outlive this process."""

    def __init__(
        self, run: Callable[[], int], title: str, stderr: IO[bytes] | None = None, keep: Collection[int] = ()
    ) -> None:
        """`keep` are descriptors of ours that it inherits; its standard input and output are pipes to us."""
        ours, theirs = os.pipe(), os.pipe()
        streams = (theirs[0], ours[1], 2 if stderr is None else stderr.fileno())
        self.pid = fork(run, title, streams, keep=keep, survives=True)
        os.close(theirs[0])
        os.close(ours[1])
        self.stdin: IO[bytes] | None = os.fdopen(theirs[1], "wb")
        self.stdout: IO[bytes] | None = os.fdopen(ours[0], "rb")
        self.returncode: int | None = None

    def poll(self) -> int | None:
        """Exit status, negative for a signal; None while it lives."""
        if self.returncode is None:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                self.returncode = os.waitstatus_to_exitcode(status)
        return self.returncode

    def wait(self, timeout: float | None = None) -> int | None:
        """The same, at its end. Raises subprocess.TimeoutExpired where that does not come within `timeout` s."""
        death = os.pidfd_open(self.pid) if self.poll() is None else None
        if death is not None:
            ended = select.select([death], [], [], timeout)[0]
            os.close(death)
            if timeout is not None and not ended:
                raise subprocess.TimeoutExpired("fork", timeout)
        return self.poll()

    def kill(self) -> None:
        """End it at once."""
        if self.poll() is None:
            os.kill(self.pid, signal.SIGKILL)
