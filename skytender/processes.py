"""Forked processes, and processes that end with the one that started them."""

from __future__ import annotations

import contextlib
import ctypes
import errno
import gc
import os
import signal
import sys
import traceback
from collections.abc import Callable, Collection

from setproctitle import setproctitle

from skytender.exit import CANNOT_WRITE, INTERNAL_ERROR, INTERRUPTED

PR_SET_PDEATHSIG = 1
"""of prctl(2): the signal that the kernel sends a process when its parent dies"""
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
SAFE_PATH, BY_US = "PYTHONSAFEPATH", "skytender"
"""variable that keeps the current folder out of Python's path, and its value where Skytender has set it"""


def environment_for_programs() -> dict[str, str]:
    """The environment as the user set it, for a program of the user's: one in Python finds modules beside itself."""
    return {name: value for name, value in os.environ.items() if (name, value) != (SAFE_PATH, BY_US)}


def printable(name: str | os.PathLike[str]) -> str:
    """A file's name, or words with one in it, as text that can be encoded: names need not be UTF-8."""
    return os.fsencode(name).decode(errors="replace")


def end_with(parent: int, number: signal.Signals = signal.SIGKILL) -> None:
    """Let the kernel send this process a signal when its parent dies, also by SIGKILL.

    parent: process id of the parent; where it has died already, the signal is sent at once.
    """
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, number)
    if os.getppid() != parent:
        os.kill(os.getpid(), number)


def fork(
    run: Callable[[], int],
    title: str,
    streams: tuple[int, int, int],
    *,
    keep: Collection[int] = (),
    survives: bool = False,
) -> int:
    """Fork a process that ends with the exit status that `run` returns; its process id.

    streams: descriptors of its standard input, output and error.
    keep: further descriptors that it inherits.
    survives: it outlives this process; otherwise it is killed when this one dies.

    It has a POSIX session of its own. What `run` raises is a traceback on its standard error and an exit status.
    """
    parent = os.getpid()
    streams_used = [stream for stream in (sys.stdout, sys.stderr) if stream is not None]  # None: closed at the start
    for stream in streams_used:
        stream.flush()
    pid = os.fork()
    if pid:
        return pid
    status = INTERNAL_ERROR
    try:
        if not survives:
            end_with(parent)
        gc.freeze()  # a collection would write to, and so copy, the memory shared with the parent
        _separate(streams, keep)
        setproctitle(printable(title))
        status = run()
    except SystemExit as end:
        status = end.code if isinstance(end.code, int) else 1
    except KeyboardInterrupt:
        status = INTERRUPTED
    except BaseException as error:
        if isinstance(error, OSError) and error.errno in FULL:
            status = CANNOT_WRITE
        with contextlib.suppress(OSError):  # a full disk takes no traceback either
            traceback.print_exc()
    finally:
        for stream in streams_used:
            with contextlib.suppress(OSError, ValueError):  # the reader may be gone
                stream.flush()
        os._exit(status)


def _separate(streams: tuple[int, int, int], keep: Collection[int]) -> None:
    """Leave the parent's POSIX session, signal handlers and descriptors: the end of a pipe is seen once no process
    holds its other end."""
    os.setsid()
    signal.set_wakeup_fd(-1)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    for standard, given in enumerate(streams):
        os.dup2(given, standard)
    kept = {0, 1, 2, *keep}
    for given in {*streams} - kept:  # first, as the listing below needs a descriptor
        os.close(given)
    for descriptor in map(int, os.listdir("/proc/self/fd")):
        if descriptor not in kept:
            with contextlib.suppress(OSError):  # the listing's own is closed already
                os.close(descriptor)
