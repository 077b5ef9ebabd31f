"""A fork server, such as `simvehicle fork-server`: started, given orders, ended
(docs/protocol/processes.md#processes)."""

from __future__ import annotations

import contextlib
import json
import os
import select
import shutil
import socket
import subprocess
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from gcs.processes.forked import end
from gcs.processes.forks import close_in_forks
from gcs.processes.python import beside_python

ENDED_WITHIN_S = 10.0
READ_BYTES = 65536
CANNOT_WRITE = 74
"""Exit status of a vehicle whose files cannot be written."""


class LaunchError(RuntimeError):
    """Processes that could not be started; the text says why and what to do."""


@dataclass(frozen=True)
class ProcessSpec:
    """One process of vehicles to start: the system ids that live in it, its arguments and its log."""

    sysids: tuple[int, ...]
    argv: tuple[str, ...]
    log: Path

    @property
    def sysid(self) -> int:
        """The first, by which the fork server reports it."""
        return self.sysids[0]

    def order(self, secret: int | None = None) -> dict[str, Any]:
        """The line that the fork server reads. `secret`, by which a supervised link knows the process, stands in no
        command line, which all can read."""
        return {"argv": self.argv, "log": str(self.log), **({} if secret is None else {"secret": secret})}


@dataclass(frozen=True)
class Ended:
    """A process that has ended; `status` is negative for a signal, `sysid` 0 for one without a vehicle."""

    sysid: int
    pid: int
    status: int
    last_lines: tuple[str, ...]
    cpu_s: float = 0.0

    def how(self) -> str:
        """How it ended, the end of a clause."""
        return f"was killed by signal {-self.status}" if self.status < 0 else f"ended with status {self.status}"

    def sentence(self, label: str) -> str:
        """One sentence for a person."""
        how = self.how()
        if self.status == CANNOT_WRITE:
            how = "could not write its log or its truth: is the disk of the session's folder full?"
        last = f"; its last lines: {' | '.join(self.last_lines)}" if self.last_lines else ""
        return f"{label} (process {self.pid}) {how}{last}"


def vehicle_program() -> str | None:
    """The program `simvehicle`: beside this Python, or on PATH; None where there is none."""
    beside = beside_python("simvehicle")
    return str(beside) if beside.exists() else shutil.which("simvehicle")


class ForkServer:
    """A running fork server by its socket; its context's end ends the server and every process that it has forked."""

    def __init__(self, connection: socket.socket, process: subprocess.Popen[bytes] | None = None) -> None:
        """`process` is the server's own, where it is a child of this one."""
        self._socket, self._process = connection, process
        self._pending = b""
        self.ready = False
        """whether it has loaded what its processes need"""
        self.alive = True
        self.pids: dict[int, int] = {}
        """first system id of each process that runs"""

    @classmethod
    def started(cls, start: Callable[..., subprocess.Popen[bytes]]) -> Self:
        """Start one by a function with the arguments of subprocess.Popen. Raises OSError."""
        while (unused := os.open(os.devnull, os.O_RDWR)) <= 2:
            pass  # a closed standard stream: a socket in its place would be the server's own too
        os.close(unused)
        ours, theirs = socket.socketpair()
        with theirs:
            try:
                return cls(ours, start(stdin=theirs, stdout=theirs, start_new_session=True))
            except OSError:
                ours.close()
                raise

    @classmethod
    def of_vehicles(cls) -> Self:
        """Start the vehicles' one. Raises LaunchError, OSError."""
        program = vehicle_program()
        if program is None:
            raise LaunchError("the program 'simvehicle' is not installed beside gcs; install Skytender again with pip")
        return cls.started(lambda **streams: subprocess.Popen([program, "fork-server"], **streams))

    def adopted(self) -> Self:
        """The same one for a fork of this process that has inherited the socket."""
        return type(self)(self._socket)

    def hand_over(self) -> None:
        """Leave it to a fork of this process that has inherited the socket: it ends with the fork."""
        self._socket.close()

    def discard(self) -> None:
        """Kill it, and wait for its end; the kernel kills its processes with it."""
        self._socket.close()
        if self._process is not None:
            self._process.kill()
            self._process.wait()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def fileno(self) -> int:
        """For select: readable when something has happened."""
        return self._socket.fileno()

    @property
    def pid(self) -> int | None:
        """The server's own process, where it is a child of this one."""
        return None if self._process is None else self._process.pid

    @property
    def running(self) -> bool:
        """Whether it lives, also where its end has not been read yet."""
        return self.alive and (self._process is None or self._process.poll() is None)

    def close_in_forks(self) -> None:
        """Keep its socket from processes that are forked from this one: it ends with this process alone."""
        close_in_forks(self._socket)

    def start(self, orders: Sequence[Mapping[str, Any]], descriptors: Sequence[int] = ()) -> None:
        """Fork a process for each order, which `pids` holds from a call of `events` on.

        descriptors: files of ours that one order is about; the server gets copies.
        """
        raw = "".join(json.dumps(order) + "\n" for order in orders).encode()
        try:
            sent = socket.send_fds(self._socket, [raw], descriptors)
            self._socket.sendall(raw[sent:])
        except OSError:
            self.alive = False

    def events(self, within_s: float = 0.0) -> list[Ended]:
        """Processes that have ended since the last call; waits so long for the first word of the server."""
        ended = []
        for content in self._reports(within_s):
            if content.get("ready"):
                self.ready = True
            elif "exit" in content:
                self.pids.pop(content["pid"], None)
                last = tuple(content["last_lines"])
                ended.append(Ended(content.get("sysid", 0), content["pid"], content["exit"], last, content["cpu_s"]))
            else:
                self.pids[content["pid"]] = content.get("sysid", 0)
        return ended

    def _reports(self, within_s: float) -> list[dict[str, Any]]:
        while self.alive and select.select([self._socket], [], [], within_s)[0]:
            within_s = 0.0
            with contextlib.suppress(ConnectionResetError):
                if chunk := self._socket.recv(READ_BYTES):
                    self._pending += chunk
                    continue
            self.alive = False
        *lines, self._pending = self._pending.split(b"\n")
        return [json.loads(line) for line in lines]

    def close(self) -> None:
        """End the server; returns when all its processes are gone. A second call changes nothing."""
        if self._socket.fileno() < 0:
            return
        with contextlib.suppress(OSError):  # it has ended already
            self._socket.shutdown(socket.SHUT_WR)
        deadline_s = time.monotonic() + ENDED_WITHIN_S
        while self.alive and time.monotonic() < deadline_s:
            self.events(max(deadline_s - time.monotonic(), 0.0))
        self._socket.close()
        self.alive = False
        if self._process is not None:
            end(self._process, 0.0 if time.monotonic() >= deadline_s else ENDED_WITHIN_S)


@contextlib.contextmanager
def early(wanted: bool) -> Iterator[ForkServer | None]:
    """The vehicles' fork server, which loads while it is found out what is to fly; it ends with this context."""
    server = None
    if wanted:
        with contextlib.suppress(LaunchError, OSError):  # the session tries again, and says why
            server = ForkServer.of_vehicles()
    try:
        yield server
    finally:
        if server is not None:
            server.discard()
