"""The hatch, the `simvehicle` program that forks vehicles: started, given orders, ended (docs/protocol.md#processes).

It loads next to nothing, since the hatch is what a session starts first.
"""

from __future__ import annotations

import contextlib
import json
import os
import select
import shutil
import signal
import subprocess
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any, Self

from gcs.processes.python import beside_python

READY_WITHIN_S = 120.0
ENDED_WITHIN_S = 10.0
CANNOT_WRITE = 74
"""Exit status of a vehicle whose files cannot be written."""


class LaunchError(RuntimeError):
    """Vehicles that could not be started; the text says why and what to do."""


@dataclass(frozen=True)
class ProcessSpec:
    """One process to start: the system ids that live in it, its arguments and its log."""

    sysids: tuple[int, ...]
    argv: tuple[str, ...]
    log: Path

    @property
    def sysid(self) -> int:
        """The first, by which the hatch reports it."""
        return self.sysids[0]


@dataclass(frozen=True)
class Ended:
    """A process that is no more; `status` is negative for a signal."""

    sysid: int
    pid: int
    status: int
    last_lines: tuple[str, ...]

    def sentence(self, label: str) -> str:
        """One sentence for a person."""
        how = f"was killed by signal {-self.status}" if self.status < 0 else f"ended with status {self.status}"
        if self.status == CANNOT_WRITE:
            how = "could not write its log or its truth: is the disk of the session's folder full?"
        last = f"; its last lines: {' | '.join(self.last_lines)}" if self.last_lines else ""
        return f"{label} (process {self.pid}) {how}{last}"


def vehicle_program() -> str | None:
    """The program `simvehicle`: beside this Python, or on PATH; None where there is none."""
    beside = beside_python("simvehicle")
    return str(beside) if beside.exists() else shutil.which("simvehicle")


class Hatch:
    """The running hatch; its context's end ends every process it made, and itself unless it is to be `kept`."""

    def __init__(self, *, kept: bool = False) -> None:
        self.kept = kept
        """whether it goes on to the next session"""
        command = vehicle_program()
        if command is None:
            raise LaunchError("the program 'simvehicle' is not installed beside gcs; install Skytender again with pip")
        self._process = subprocess.Popen(
            [command, "hatch"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, start_new_session=True
        )
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._in: IO[bytes] = self._process.stdin
        self._out = self._process.stdout.fileno()
        self._death = os.pidfd_open(self._process.pid)
        os.set_blocking(self._out, False)
        self._pending = b""
        self.pids: dict[int, int] = {}
        self.alive = True
        self.ended_cpu_s: float | None = None
        """what all ended processes used in all, once `end_session` has been answered"""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self.kept:
            self.end_session()
        else:
            self.close()

    def fileno(self) -> int:
        """For select: readable when something has happened."""
        return self._out

    @property
    def pid(self) -> int:
        """The hatch's own process."""
        return self._process.pid

    def start(self, orders: Sequence[ProcessSpec], secret: int | None = None) -> None:
        """Fork a process per order; each `pid` is reported by `events`.

        secret: by which a supervised link knows them. It goes through the pipe: all can read a command line.
        """
        more = {} if secret is None else {"secret": secret}
        lines = [json.dumps({"argv": order.argv, "log": str(order.log), **more}) + "\n" for order in orders]
        try:
            self._in.write("".join(lines).encode())
            self._in.flush()
        except BrokenPipeError:
            self.alive = False

    def events(self) -> tuple[bool, list[Ended]]:
        """(whether the hatch became ready, processes that ended) since the last call; never waits."""
        ready, ended = False, []
        for content in self._messages():
            if content.get("ready"):
                ready = True
            elif "ended" in content:
                self.pids.clear()
                self.ended_cpu_s = content["cpu_s"]
            elif "exit" in content:
                self.pids.pop(content["pid"], None)
                ended.append(Ended(content["sysid"], content["pid"], content["exit"], tuple(content["last_lines"])))
            else:
                self.pids[content["pid"]] = content["sysid"]
        return ready, ended

    def _messages(self) -> list[dict[str, Any]]:
        while self.alive:
            try:
                chunk = os.read(self._out, 65536)
            except BlockingIOError:
                break
            if not chunk:
                self.alive = False
                break
            self._pending += chunk
        *lines, self._pending = self._pending.split(b"\n")
        return [json.loads(line) for line in lines]

    def end_session(self) -> bool:
        """End every process it made, but not the hatch; returns when they are gone, False if the hatch has died."""
        self.ended_cpu_s = None
        try:
            self._in.write(b'{"end": true}\n')
            self._in.flush()
        except BrokenPipeError:
            self.alive = False
        deadline_s = time.monotonic() + ENDED_WITHIN_S
        while self.alive and self.ended_cpu_s is None and time.monotonic() < deadline_s:
            select.select([self._out], [], [], max(deadline_s - time.monotonic(), 0.0))
            self.events()
        return self.alive and self.ended_cpu_s is not None

    @property
    def descriptors(self) -> tuple[int, ...]:
        """File descriptors that a fork of this process must keep open to have it."""
        return self._in.fileno(), self._out, self._death

    def release(self) -> None:
        """Leave it to a fork of this process: with the fork's end of the pipe it ends."""
        self._in.close()

    def dismiss(self) -> None:
        """Let it begin to end, unless it is kept: its context's end waits for that."""
        if not self.kept:
            with contextlib.suppress(BrokenPipeError):
                self._in.close()

    def discard(self) -> None:
        """End it at once, if that has not been done, also by a fork that has it."""
        if self._process.returncode is not None:
            return
        with contextlib.suppress(BrokenPipeError):
            self._in.close()
        self._process.kill()
        self._end()

    def close(self) -> None:
        """End the hatch; returns when all its processes are gone. It need not be a child of this process."""
        if self._process.returncode is not None:
            return
        with contextlib.suppress(BrokenPipeError):
            self._in.close()
        if not select.select([self._death], [], [], ENDED_WITHIN_S)[0]:
            signal.pidfd_send_signal(self._death, signal.SIGKILL)
        self._end()

    def _end(self) -> None:
        select.select([self._death], [], [])
        self._process.wait()
        os.close(self._death)
        assert self._process.stdout is not None
        self._process.stdout.close()


@contextmanager
def early(wanted: bool) -> Iterator[Hatch | None]:
    """A hatch that loads while it is found out what is to fly; it ends with this context."""
    hatch = None
    if wanted:
        with contextlib.suppress(LaunchError, OSError):  # the session tries again, and says why
            hatch = Hatch()
    try:
        yield hatch
    finally:
        if hatch is not None:
            hatch.discard()
