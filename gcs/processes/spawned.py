"""A child of a fork server, as subprocess.Popen runs a program."""

from __future__ import annotations

import contextlib
import os
import select
import signal
import subprocess
import time
from collections.abc import Mapping, Sequence
from typing import IO, Any, Self

from gcs.processes.fork_server import Ended, ForkServer, LaunchError
from gcs.processes.forks import close_in_forks

FORKED_WITHIN_S = 60.0


class SpawnedProcess:
    """A child of a fork server, known to it by a number of its own; its standard input and output are pipes to us."""

    def __init__(self, server: ForkServer, number: int, order: Mapping[str, Any], descriptors: Sequence[int]) -> None:
        """Wait until it is forked. The server gets the ends of the two pipes before `descriptors`, and the number as
        the `sysid` of the order, which its reports name.

        Raises LaunchError where that does not happen.
        """
        self._server, self._number = server, number
        self.ended: Ended | None = None
        reading, writing = os.pipe()
        out, theirs = os.pipe()
        self.stdin: IO[bytes] = os.fdopen(writing, "wb")
        self.stdout: IO[bytes] = os.fdopen(out, "rb")
        close_in_forks(self.stdin)
        try:
            try:
                server.start([{**order, "sysid": number}], [reading, theirs, *descriptors])
            finally:
                os.close(reading)
                os.close(theirs)
            self.pid = self._forked()
        except BaseException:
            self.close()  # it ends with its standard input
            raise

    def _forked(self) -> int:
        deadline_s = time.monotonic() + FORKED_WITHIN_S
        while self._server.alive and time.monotonic() < deadline_s:
            self._read(FORKED_WITHIN_S)
            for pid, number in self._server.pids.items():
                if number == self._number:
                    return pid
            if self.ended is not None:
                return self.ended.pid
        raise LaunchError("its fork server has died, or has forked nothing")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Close the pipes."""
        with contextlib.suppress(BrokenPipeError):
            self.stdin.close()
        self.stdout.close()

    @property
    def returncode(self) -> int | None:
        """Exit status, negative for a signal, as it is known."""
        if self.ended is None and not self._server.alive:
            return -signal.SIGKILL  # the kernel kills it with the server
        return None if self.ended is None else self.ended.status

    def poll(self) -> int | None:
        """Exit status, negative for a signal; None while it lives."""
        if self.returncode is None:
            self._read(0.0)
        return self.returncode

    def wait(self, timeout: float | None = None) -> int | None:
        """The same, at its end. Raises subprocess.TimeoutExpired where that does not come within `timeout` s."""
        deadline_s = float("inf") if timeout is None else time.monotonic() + timeout
        while self.poll() is None:
            left_s = None if timeout is None else max(deadline_s - time.monotonic(), 0.0)
            if not select.select([self._server], [], [], left_s)[0]:
                raise subprocess.TimeoutExpired("fork", timeout or 0.0)
        return self.returncode

    def kill(self) -> None:
        """End it at once."""
        if self.poll() is None:
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.pid, signal.SIGKILL)

    def _read(self, within_s: float) -> None:
        ours = (end for end in self._server.events(within_s) if end.sysid == self._number)
        self.ended = next(ours, self.ended)
