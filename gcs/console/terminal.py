"""The console's process as `gcs run` sees it: started in this terminal, watched, and cleaned up after.

It may be closed, suspended or killed at any time. Then the terminal is put back as it was, and lines of text take over.
"""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import tempfile
import termios
from collections.abc import Callable
from pathlib import Path
from typing import Any

from gcs.console.job import can_suspend
from gcs.console.text import given_environment
from gcs.processes.forked import end
from gcs.processes.python import start_python
from gcs.session.plain_text import View
from skytender.exit import INTERRUPTED

CONSOLE = "gcs.console"
ENDS_WITHIN_S = 3.0
RESET = "\x1b[?1000l\x1b[?1003l\x1b[?1015l\x1b[?1006l\x1b[?2004l\x1b[?1004l\x1b[?2048l\x1b[?2026l\x1b[<u\x1b[?7h"
RESET += "\x1b[?1049l\x1b[?25h\x1b[0m"
"""Mouse, paste, focus and size reports, frames and keyboard protocol off, wrapping on, main screen, cursor on."""


def usable() -> bool:
    """Whether a console can run here: a terminal to read from and to draw on, that is not a dumb one."""
    named = os.environ.get("TERM", "")
    return os.isatty(0) and os.isatty(1) and named not in ("", "dumb", "unknown")


class ConsoleView(View):
    """Shows the session of `folder` in a console of its own, and through `plain` while there is none.

    The supervisor's standard error goes to `stderr`: it is passed on when the console does not draw.
    """

    def __init__(self, folder: Path, title: str, plain: View, say: Callable[[str], object]) -> None:
        self._words = [str(folder), title, str(os.getpid())]
        self._folder, self._plain, self._say = folder, plain, say
        self._process: subprocess.Popen[bytes] | None = None
        self._suspended = self._over = False
        self._terminal: list[Any] | None = None
        self.stderr = tempfile.TemporaryFile()  # noqa: SIM115 - closed with the view
        self._passed_on = 0

    @property
    def _drawing(self) -> bool:
        return self._process is not None and not self._suspended

    def show(self, snapshot: Any) -> None:
        """Leave it to the console, or print it in lines."""
        if not self._drawing:
            self._plain.show(snapshot)

    def tick(self, now_s: float) -> None:
        """Start the console, the first time; see what has become of it."""
        if self._process is None and not self._over:
            self._start()
        if self._process is not None:
            self._look()
        if not self._drawing:
            self._pass_on()
            self._plain.tick(now_s)

    def close(self) -> None:
        """End the console and put the terminal back."""
        if self._process is not None:
            self._process.terminate()
            with contextlib.suppress(ProcessLookupError):
                self._process.send_signal(signal.SIGCONT)  # a suspended process cannot end
            end(self._process, ENDS_WITHIN_S)
            self._ended()
        elif self._over:
            self._plain.close()
        self._pass_on()
        self.stderr.close()

    def _start(self) -> None:
        with contextlib.suppress(termios.error):
            self._terminal = termios.tcgetattr(0)
        # Ctrl-C until the console has its keys in hand is ours alone: the mask is inherited, and lifted there.
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            self._process = start_python(CONSOLE, *self._words, stderr=1, env=given_environment())
        except OSError as error:
            self._over = True
            self._say(f"the console cannot be started: {error.strerror}; the session goes on in lines")
        finally:
            signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})

    def _look(self) -> None:
        assert self._process is not None
        pid = self._process.pid
        with contextlib.suppress(ChildProcessError):
            change = os.waitid(os.P_PID, pid, os.WSTOPPED | os.WCONTINUED | os.WNOHANG)
            if change is not None and change.si_pid == pid:
                if change.si_code == os.CLD_CONTINUED:
                    self._suspended = False
                else:
                    self._stopped()
        status = self._process.poll()
        if status is None:
            return
        self._ended()
        if status == INTERRUPTED:
            os.kill(os.getpid(), signal.SIGINT)
            return
        how = "closed" if status == 0 else f"killed by signal {-status}" if status < 0 else f"ended, status {status}"
        self._say(
            f"the console was {how}; the session goes on: Ctrl-C stops it, "
            f"`gcs monitor {self._folder}` in another terminal shows it"
        )

    def _stopped(self) -> None:
        """The console is suspended: so are we, if there is a shell to continue us; the supervisor flies on."""
        if self._suspended:
            return
        self._suspended = True
        self._restore()
        if can_suspend():
            self._say("suspended; the session goes on, `fg` shows it again")
            self._suspended = False
            os.killpg(os.getpgrp(), signal.SIGTSTP)
        else:
            self._say("the console is suspended; the session goes on in lines")

    def _ended(self) -> None:
        assert self._process is not None
        bad = self._process.returncode not in (0, INTERRUPTED)
        self._process = None
        self._suspended, self._over = False, True
        self._restore(thoroughly=bad)

    def _restore(self, *, thoroughly: bool = False) -> None:
        """The terminal as it was before; `thoroughly` also where the console could not clean up itself."""
        with contextlib.suppress(OSError, termios.error):
            if os.tcgetpgrp(0) != os.getpgrp():
                return
            if thoroughly:
                os.write(1, RESET.encode())
                termios.tcflush(0, termios.TCIFLUSH)
            if self._terminal is not None:
                termios.tcsetattr(0, termios.TCSADRAIN, self._terminal)

    def _pass_on(self) -> None:
        """The supervisor's output meanwhile."""
        size = os.fstat(self.stderr.fileno()).st_size
        if size > self._passed_on:
            said = os.pread(self.stderr.fileno(), size - self._passed_on, self._passed_on)
            self._passed_on = size
            with contextlib.suppress(OSError):
                os.write(2, said)
