"""A fork server: it has loaded what its children need, and forks one for each order
(docs/protocol/processes.md#processes).

Standard input, a Unix socket, pipe or file, takes a JSON line per order; descriptors may come with it over the socket.
Standard output reports {"ready": true}, then {…, "pid"} at each fork and {…, "pid", "exit", "last_lines", "cpu_s"} at
each end. `exit` is negative for a signal, "cpu_s" the CPU time of the child and of the processes that it has waited
for. The end of standard input ends all children, at once or when their patience is over, and then the server. Its
death, also by SIGKILL, kills them.
"""

from __future__ import annotations

import contextlib
import json
import os
import select
import selectors
import signal
import socket
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from setproctitle import getproctitle

from skytender.exit import BAD_INPUT, CANNOT_WRITE, DONE
from skytender.processes import fork

LAST_LINES = 8
READ_BYTES = 65536
MOST_DESCRIPTORS = 8


class Child(NamedTuple):
    """A process to fork."""

    report: Mapping[str, object]
    """what each report on it holds besides"""
    title: str
    log: Path | None
    """takes its standard error, and its standard output where that goes nowhere else; None: this process's take them"""
    run: Callable[[], int]
    """returns its exit status"""
    stdin: int | None = None
    """a descriptor; without one it reads /dev/null"""
    stdout: int | None = None
    keep: Sequence[int] = ()
    """further descriptors that it inherits"""
    patience_s: float = 0.0
    """time that it has for an end of its own once the server's standard input has ended"""


Prepare = Callable[[Mapping[str, Any], Sequence[int]], Child]
"""Reads an order, with the descriptors that came with it, and does all that can be done before the fork. Raises
ValueError, KeyError or TypeError for what is no order."""


def serve(prepare: Prepare) -> int:
    """Serve until standard input ends; the exit status.

    Orders that come together are all prepared before the first is forked: what this process writes to afterwards is
    copied.
    """
    getproctitle()  # makes room for titles: here once, and not in each child
    null = os.open(os.devnull, os.O_RDWR | os.O_CLOEXEC)  # takes the place of standard error where that is closed
    children: dict[int, tuple[int, Child]] = {}
    pending, given = b"", []
    _report({"ready": True})
    # poll, not epoll: standard input may be a file, which epoll refuses
    with selectors.PollSelector() as selector:
        selector.register(0, selectors.EVENT_READ)
        try:
            while True:
                for key, _ in selector.select():
                    if key.fd:
                        selector.unregister(key.fd)
                        os.close(key.fd)
                        _report_end(*children.pop(key.fd))
                        continue
                    chunk, descriptors = _received()
                    if not chunk:
                        _let_end(children)
                        return DONE
                    given += descriptors
                    *lines, pending = (pending + chunk).split(b"\n")
                    for child in [_prepared(prepare, line, given) for line in lines]:
                        pid = _fork(child, null)
                        death = os.pidfd_open(pid)
                        children[death] = (pid, child)
                        selector.register(death, selectors.EVENT_READ)
                        _report({**child.report, "pid": pid})
                    if lines:
                        for descriptor in given:
                            os.close(descriptor)
                        given.clear()
        except _NoOrder as problem:
            print(f"fork server: no order: {problem}", file=sys.stderr, flush=True)
            return BAD_INPUT
        finally:
            _end_all([pid for pid, _ in children.values()])


class _NoOrder(Exception):
    """A line that is no order."""


def _prepared(prepare: Prepare, line: bytes, given: Sequence[int]) -> Child:
    try:
        return prepare(json.loads(line), given)
    except (ValueError, KeyError, TypeError):
        raise _NoOrder(repr(line[:100])) from None


def _received() -> tuple[bytes, list[int]]:
    """Bytes of standard input, with the descriptors that came with them over a socket."""
    try:
        orders = socket.socket(fileno=0)
    except OSError:  # a pipe or a file
        return os.read(0, READ_BYTES), []
    try:
        chunk, descriptors, _, _ = socket.recv_fds(orders, READ_BYTES, MOST_DESCRIPTORS)
    except ConnectionResetError:
        return b"", []
    finally:
        orders.detach()
    return chunk, descriptors


def _fork(child: Child, null: int) -> int:
    streams = (null if child.stdin is None else child.stdin, 2 if child.stdout is None else child.stdout, 2)
    return fork(partial(_run, child), child.title, streams, keep=child.keep)


def _run(child: Child) -> int:
    """Be the child: with its log, to its end."""
    if child.log is None:
        return child.run()
    try:
        log = os.open(child.log, os.O_WRONLY | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o644)
    except OSError as error:
        print(f"fork server: cannot write {child.log}: {error.strerror}", file=sys.stderr)
        return CANNOT_WRITE
    for standard in (1, 2) if child.stdout is None else (2,):
        os.dup2(log, standard)
    os.close(log)
    return child.run()


def _report_end(pid: int, child: Child) -> None:
    _, status, used = os.wait4(pid, 0)
    last: list[str] = []
    with contextlib.suppress(OSError):
        if child.log is not None:
            last = child.log.read_text(encoding="utf-8", errors="replace").splitlines()[-LAST_LINES:]
    end = {"exit": os.waitstatus_to_exitcode(status), "last_lines": last, "cpu_s": used.ru_utime + used.ru_stime}
    _report({**child.report, "pid": pid, **end})


def _let_end(children: dict[int, tuple[int, Child]]) -> None:
    """Wait for the ends of those with patience, which are taken out."""
    left_s = {death: child.patience_s for death, (_, child) in children.items() if child.patience_s}
    began_s = time.monotonic()
    while left_s:
        within_s = max(began_s + max(left_s.values()) - time.monotonic(), 0.0)
        ready = select.select([*left_s], [], [], within_s)[0]
        if not ready:
            return
        for death in ready:
            del left_s[death]
            _report_end(*children.pop(death))


def _end_all(pids: Sequence[int]) -> None:
    """Kill all children before waiting for the first: each takes a while to give back its memory."""
    for pid in pids:
        os.kill(pid, signal.SIGKILL)
    for pid in pids:
        os.waitpid(pid, 0)


def _report(content: Mapping[str, object]) -> None:
    with contextlib.suppress(BrokenPipeError):
        os.write(1, json.dumps(content).encode() + b"\n")
