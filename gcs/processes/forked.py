"""A function in a fork of this process, with pipes, used as subprocess.Popen is: what is loaded need not be again."""

from __future__ import annotations

import contextlib
import os
import select
import signal
import subprocess
import sys
import threading
import traceback
from collections.abc import Callable, Collection
from typing import IO

from setproctitle import setproctitle

from skytender.exit import INTERNAL_ERROR


def can_fork() -> bool:
    """Whether a fork of this process is whole: no other thread would be missing there, and no standard stream is."""
    return threading.active_count() == 1 and None not in (sys.__stdin__, sys.__stdout__, sys.__stderr__)


def await_end(process: subprocess.Popen[bytes] | ForkedProcess, patience_s: float) -> None:
    """Wait until a child has ended; it is killed where that takes longer."""
    try:
        process.wait(timeout=patience_s)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


class ForkedProcess:
    """A child in a POSIX session of its own, without our descriptors; `run` in it returns its exit status."""

    def __init__(
        self, run: Callable[[], int], title: str, stderr: IO[bytes] | None = None, keep: Collection[int] = ()
    ) -> None:
        """`keep` are descriptors of ours that it has too."""
        ours, theirs = os.pipe(), os.pipe()
        for stream in (sys.stdout, sys.stderr):
            stream.flush()
        self.pid = os.fork()
        if not self.pid:
            be(run, title, (theirs[0], ours[1], 2 if stderr is None else stderr.fileno()), keep)
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


def be(run: Callable[[], int], title: str, streams: tuple[int, int, int], keep: Collection[int]) -> None:
    """Be the child of a fork to its end, with these standard streams and what is to be kept of other descriptors."""
    status = INTERNAL_ERROR
    try:
        os.setsid()
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, signal.SIG_DFL)
        signal.set_wakeup_fd(-1)
        for standard, given in enumerate(streams):
            os.dup2(given, standard)
        _close_all_but({0, 1, 2, *keep})
        setproctitle(title)
        status = run()
    except BaseException:
        traceback.print_exc()
    finally:
        for stream in (sys.stdout, sys.stderr):
            with contextlib.suppress(OSError, ValueError):  # nobody may read it any more
                stream.flush()
        os._exit(status)


def _close_all_but(kept: Collection[int]) -> None:
    """Close our parent's descriptors: a pipe that we hold open, nobody sees the end of."""
    for descriptor in map(int, os.listdir("/proc/self/fd")):
        if descriptor not in kept:
            with contextlib.suppress(OSError):  # the listing's own
                os.close(descriptor)
