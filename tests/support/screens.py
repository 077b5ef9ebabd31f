"""A program in a terminal of its own: a pseudo terminal whose keys the test presses and whose output it reads."""

from __future__ import annotations

import contextlib
import fcntl
import os
import pty
import re
import select
import signal
import struct
import subprocess
import termios
import time
from collections.abc import Sequence
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import psutil
from patience import PATIENCE_S

ALTERNATE, MAIN = b"\x1b[?1049h", b"\x1b[?1049l"
_ESCAPES = re.compile(rb"\x1b(?:\[[0-?]*[ -/]*[@-~]|[@-_])")
LOCAL_FLAGS = 3


class Screen:
    """A program that has a pseudo terminal, `columns` x `rows`, as its controlling terminal."""

    def __init__(
        self,
        command: Sequence[str],
        *,
        columns: int = 100,
        rows: int = 30,
        cwd: Path | None = None,
        pass_fds: Sequence[int] = (),
        **environment: str,
    ) -> None:
        self._keys, terminal = pty.openpty()
        self._terminal = terminal
        self.resize(columns, rows)
        self.before = termios.tcgetattr(terminal)
        self.process = subprocess.Popen(
            list(command),
            stdin=terminal,
            stdout=terminal,
            stderr=terminal,
            cwd=cwd,
            env={**os.environ, "TERM": "xterm-256color", "LC_ALL": "C.UTF-8", **environment},
            start_new_session=True,
            pass_fds=pass_fds,
            preexec_fn=_take_terminal,  # noqa: PLW1509 - nothing here has threads
        )
        self.seen = b""
        self._from = 0

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        family = self.family()
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        for process in family:
            with contextlib.suppress(psutil.Error):
                process.resume()
                process.kill()
        os.close(self._keys)
        os.close(self._terminal)

    def family(self) -> list[psutil.Process]:
        """The program and everything that it has started."""
        with contextlib.suppress(psutil.Error):
            head = psutil.Process(self.process.pid)
            return [head, *head.children(recursive=True)]
        return []

    def named(self, word: str) -> psutil.Process:
        """The process of the family that has this word among its arguments."""
        return next(p for p in self.family() if word in " ".join(p.cmdline()).split())

    def press(self, keys: str) -> None:
        """Type."""
        os.write(self._keys, keys.encode())

    def resize(self, columns: int, rows: int) -> None:
        """Another size, of which the kernel tells the program."""
        fcntl.ioctl(self._terminal, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))

    def modes(self) -> list[Any]:
        """The terminal's settings now."""
        return termios.tcgetattr(self._terminal)

    @property
    def cooked(self) -> bool:
        """Whether the terminal echoes and reads in lines, as a shell leaves it."""
        return self.modes()[LOCAL_FLAGS] == self.before[LOCAL_FLAGS]

    def until(self, *words: str) -> str:
        """Read on until all of `words` have come since the last call; what has come, without escape sequences."""
        deadline_s = time.monotonic() + PATIENCE_S
        wanted = [word.encode() for word in words]
        while True:
            fresh = self.seen[self._from :]
            plain = _ESCAPES.sub(b"", fresh)
            if all(word in fresh or word in plain for word in wanted):
                self._from = len(self.seen)
                return plain.decode(errors="replace")
            left_s = deadline_s - time.monotonic()
            if left_s <= 0.0 or not self._read(left_s):
                raise AssertionError(f"{words} did not come; this did: {plain.decode(errors='replace')[-2000:]}")

    def finish(self) -> int:
        """Read to the program's end; its exit status."""
        deadline_s = time.monotonic() + PATIENCE_S
        while self.process.poll() is None and time.monotonic() < deadline_s:
            self._read(0.2)
        while self._read(0.0):
            pass
        return self.process.wait(timeout=1.0)

    def _read(self, within_s: float) -> bool:
        if not select.select([self._keys], [], [], min(within_s, 0.5))[0]:
            return within_s > 0.0
        try:
            chunk = os.read(self._keys, 1 << 16)
        except OSError:
            return False
        self.seen += chunk
        return bool(chunk)


def _take_terminal() -> None:
    fcntl.ioctl(0, termios.TIOCSCTTY, 0)
    signal.pthread_sigmask(signal.SIG_SETMASK, set())
