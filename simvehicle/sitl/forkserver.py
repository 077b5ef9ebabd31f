"""Preload once, fork a vehicle per line: docs/protocol.md#processes.

stdin: one JSON line per process, {"argv": ["--sysid", "1", …], "log": PATH, "secret": N}; the secret, by which a
supervisor knows its own vehicles, may be left out. stdout: {"ready": true} once preloaded,
then {"sysid", "pid"} at each fork and {"sysid", "pid", "exit", "last_lines"} at each end; `exit` is negative for a
signal. The line {"end": true} ends all processes without ending the hatch: {"ended": true, "cpu_s"} follows, the CPU
time of all that it ever forked. The end of stdin ends the hatch, and its children die with it, however it dies. `ps`
shows `simvehicle 1`.
"""

from __future__ import annotations

import contextlib
import ctypes
import errno
import gc
import json
import os
import resource
import selectors
import signal
import sys
import traceback
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from setproctitle import getproctitle, setproctitle

from simvehicle.sitl.secret import hand_over
from skytender.exit import BAD_INPUT, CANNOT_WRITE, INTERNAL_ERROR, INTERRUPTED
from skytender.loading import gathered

PR_SET_PDEATHSIG = 1
LAST_LINES = 8
END = {"end": True}
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)


class _Order(NamedTuple):
    """A process to fork."""

    sysid: int
    title: str
    log: Path
    secret: object
    flight: Callable[[], int]


def run(
    sysid_of: Callable[[Sequence[str]], int],
    title_of: Callable[[Sequence[str]], str],
    prepare: Callable[[Sequence[str]], Callable[[], int]],
) -> int:
    """Serve until stdin ends. `sysid_of` and `title_of` name a vehicle by its argv; `prepare` does all for it that can
    be done before its process is forked, and gives back what that is to call.

    Orders that come together are prepared before the first is forked: from then on whatever this process writes to is
    copied.
    """
    with contextlib.suppress(PermissionError):
        os.setsid()
    libc = ctypes.CDLL(None, use_errno=True)
    getproctitle()  # which makes room for titles: once here, and not in each process
    lasts = False
    _say({"ready": True})
    # poll, not epoll: stdin may be a file or /dev/null, which epoll refuses.
    with selectors.PollSelector() as selector:
        selector.register(0, selectors.EVENT_READ)
        children: dict[int, tuple[int, int, Path]] = {}
        pending = b""
        while True:
            for key, _ in selector.select():
                if key.fd != 0:
                    if key.fd in children:  # it may have been ended meanwhile
                        _report_end(selector, key.fd, *children.pop(key.fd))
                    continue
                chunk = os.read(0, 65536)
                if not chunk:
                    _end_all(pid for pid, _, _ in children.values())
                    return 0
                *lines, pending = (pending + chunk).split(b"\n")
                orders: list[_Order] = []
                for line in lines:
                    try:
                        order = json.loads(line)
                        if order == END:
                            _fork_all(orders, selector, children, libc)
                            orders.clear()
                            _end_session(selector, children)
                            if not lasts:
                                lasts = True
                                gathered()  # more sessions will come
                            continue
                        argv, log = list(map(str, order["argv"])), Path(order["log"])
                        secret = order.get("secret")
                    except (ValueError, KeyError, TypeError):
                        print(f"hatch: no order: {line[:100]!r}", file=sys.stderr, flush=True)
                        _end_all(pid for pid, _, _ in children.values())
                        return BAD_INPUT
                    orders.append(_Order(sysid_of(argv), title_of(argv), log, secret, prepare(argv)))
                _fork_all(orders, selector, children, libc)


def _fork_all(
    orders: Iterable[_Order],
    selector: selectors.BaseSelector,
    children: dict[int, tuple[int, int, Path]],
    libc: ctypes.CDLL,
) -> None:
    """Fork a process for each order, and say so."""
    for order in orders:
        pid = _fork(order, libc, list(children))
        pidfd = os.pidfd_open(pid)
        children[pidfd] = (pid, order.sysid, order.log)
        selector.register(pidfd, selectors.EVENT_READ)
        _say({"sysid": order.sysid, "pid": pid})


def _end_session(selector: selectors.BaseSelector, children: dict[int, tuple[int, int, Path]]) -> None:
    """End all processes, say so, and be ready for more."""
    _end_all(pid for pid, _, _ in children.values())
    for pidfd in children:
        selector.unregister(pidfd)
        os.close(pidfd)
    children.clear()
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    _say({"ended": True, "cpu_s": used.ru_utime + used.ru_stime})


def _fork(order: _Order, libc: ctypes.CDLL, inherited: list[int]) -> int:
    parent = os.getpid()
    pid = os.fork()
    if pid:
        return pid
    status = INTERNAL_ERROR
    try:
        gc.freeze()  # a collection would write to whatever it looks at
        libc.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        if os.getppid() != parent:
            os._exit(INTERNAL_ERROR)
        for fd in inherited:
            os.close(fd)
        setproctitle(order.title)
        hand_over(order.secret)
        try:
            out = os.open(order.log, os.O_WRONLY | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o644)
        except OSError as error:
            print(f"hatch: cannot write {order.log}: {error.strerror}", file=sys.stderr)
            raise SystemExit(CANNOT_WRITE) from error
        null = os.open(os.devnull, os.O_RDONLY)
        os.dup2(null, 0)
        os.dup2(out, 1)
        os.dup2(out, 2)
        status = order.flight()
    except SystemExit as end:
        status = end.code if isinstance(end.code, int) else 1
    except KeyboardInterrupt:
        status = INTERRUPTED
    except OSError as error:  # a full disk takes no log either
        status = CANNOT_WRITE if error.errno in FULL else INTERNAL_ERROR
        with contextlib.suppress(OSError):
            traceback.print_exc()
    except BaseException:
        traceback.print_exc()
    finally:
        with contextlib.suppress(OSError, ValueError):
            sys.stdout.flush()
            sys.stderr.flush()
        os._exit(status)


def _report_end(selector: selectors.BaseSelector, pidfd: int, pid: int, sysid: int, log: Path) -> None:
    selector.unregister(pidfd)
    os.close(pidfd)
    status = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
    try:
        last = log.read_text(encoding="utf-8", errors="replace").splitlines()[-LAST_LINES:]
    except OSError:
        last = []
    _say({"sysid": sysid, "pid": pid, "exit": status, "last_lines": last})


def _end_all(pids: Iterable[int]) -> None:
    """All at once, not one after the other: to give back its memory takes each a while."""
    pids = list(pids)
    for pid in pids:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)
    for pid in pids:
        with contextlib.suppress(ChildProcessError):
            os.waitpid(pid, 0)


def _say(content: dict[str, Any]) -> None:
    line = json.dumps(content).encode() + b"\n"
    with contextlib.suppress(BrokenPipeError):
        os.write(1, line)
