"""Exit status of the programs, and their end: streams flushed, no signal heeded any more."""

import errno
import os
import signal
import sys
from typing import NoReturn

DONE = 0
NOT_DONE = 1
BAD_INPUT = 2
INTERNAL_ERROR = 70
CANNOT_WRITE = 74
ABANDONED = 75
"""A vehicle's supervisor has been silent for too long."""
AUTOPILOT_GONE = 76
"""The autopilot that a vehicle flies cannot be started, was not ready, or has ended."""
INTERRUPTED = 130
STANDARD_OUTPUT = "standard output"
"""in the place of a file's name"""
TOO_FEW_FILES = (errno.EMFILE, errno.ENFILE)
RAISE_LIMIT = "too few files may be open at once here: raise the limit (ulimit -n)"
"""sentence for these errors of the system"""


class Terminated(BaseException):
    """A signal that asks this program to end, raised where it came, so that what was begun is cleaned up."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.number = number

    @property
    def status(self) -> int:
        """The program's exit status, as shells have it."""
        return 128 + self.number


def ending() -> list[signal.Signals]:
    """The signals that ask this program to end: SIGHUP only where its caller does not ignore it, as nohup does."""
    hang_up = [] if signal.getsignal(signal.SIGHUP) is signal.SIG_IGN else [signal.SIGHUP]
    return [signal.SIGINT, signal.SIGTERM, *hang_up]


def terminate(number: int, _: object) -> NoReturn:
    """A handler of signals that raises them."""
    raise Terminated(number)


def leave(status: int) -> NoReturn:
    """End the process with this status, its streams flushed.

    A reader that has gone is no error; what cannot be written for another reason turns success into NOT_DONE.
    """
    for number in ending():
        signal.signal(number, signal.SIG_IGN)
    for stream in (sys.stdout, sys.stderr):
        if stream is None:  # closed before the program began
            continue
        try:
            stream.flush()
        except OSError as error:
            if error.errno != errno.EPIPE:
                status = status or NOT_DONE
                os.write(2, f"{stream.name} cannot be written: {error.strerror}\n".encode())
        except (ValueError, RuntimeError):  # closed, or a signal's handler has broken into a write that waits
            pass
    os._exit(status)
