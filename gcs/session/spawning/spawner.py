"""Sessions one after the other from processes that stay loaded: each as by `gcs run`.

Each has processes and sockets of its own and the digest of `gcs run SCENARIO --lockstep`; only starting is cheaper: its
supervisor is forked from one fork server (gcs/session/spawning/fork_server.py), its vehicles from another.
"""

from __future__ import annotations

import base64
import contextlib
import itertools
import os
import pickle
import shutil
import socket
import subprocess
import tempfile
import time
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Self

from gcs.processes.fork_server import Ended, ForkServer, LaunchError
from gcs.processes.python import start_python
from gcs.processes.spawned import SpawnedProcess
from gcs.scenario.model import Scenario
from gcs.session.program.turn import SessionError

SUPERVISORS = "gcs.session.spawning.fork_server"
READY_WITHIN_S = 60.0
SAVES_WITHIN_S = 10.0
NOT_UP = "a process that forks sessions did not come up; gcs doctor looks for the reason"


class SpawnError(SessionError):
    """Sessions cannot be started; the text says why."""


class SessionSpawner:
    """Two processes that stay loaded, from which sessions are forked, one at a time: each begins sooner.

        with gcs.SessionSpawner() as spawner:
            for seed in range(100):
                with gcs.Session("demo", lockstep=True, seed=seed, spawner=spawner) as session:
                    print(session.finish().digest)

    The end of its context ends them, and a session that still flies. The processes have the environment and the current
    folder that were this program's when it was made. Raises SessionError where they cannot be started.
    """

    def __init__(self) -> None:
        with contextlib.ExitStack() as opened:
            self.folder = Path(tempfile.mkdtemp(prefix="gcs-sessions-"))
            """for what is not to last: it is removed with the spawner, also where this process is killed"""
            opened.callback(shutil.rmtree, self.folder, ignore_errors=True)
            start = partial(start_python, SUPERVISORS, str(self.folder))
            try:
                self._vehicles = opened.enter_context(ForkServer.of_vehicles())
                self._supervisors = opened.enter_context(ForkServer.started(start))
            except (LaunchError, OSError) as error:
                raise SpawnError(f"sessions cannot be started: {error}") from None
            for server in (self._vehicles, self._supervisors):
                server.close_in_forks()
            self._numbers = itertools.count(1)
            self._flight: SpawnedProcess | None = None
            self._pid = os.getpid()
            self._opened = opened.pop_all()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def alive(self) -> bool:
        """Whether it can fly: its processes live, and this is no fork of the program that made it."""
        return os.getpid() == self._pid and self._vehicles.running and self._supervisors.running

    @property
    def pids(self) -> tuple[int, ...]:
        """The fork servers' own processes."""
        return tuple(server.pid for server in (self._supervisors, self._vehicles) if server.pid is not None)

    def wait_ready(self) -> None:
        """Wait until both have loaded what they fork. Raises SpawnError."""
        deadline_s = time.monotonic() + READY_WITHIN_S
        for server in (self._supervisors, self._vehicles):
            while server.alive and not server.ready and time.monotonic() < deadline_s:
                server.events(READY_WITHIN_S)
            if not server.ready:
                raise SpawnError(NOT_UP)

    def check(self) -> None:
        """See that a session can begin. Raises SpawnError."""
        if not self.alive:
            raise SpawnError(
                "the spawner has ended, its processes have died, or this is a fork of its program; make another one"
            )
        if self._flight is not None and not self._flight.stdin.closed and self._flight.poll() is None:
            raise SpawnError("a spawner flies one session at a time; make another one for sessions side by side")

    def start(
        self,
        scenario: Scenario,
        folder: Path,
        *,
        modules: Sequence[str] = (),
        log: Path | None = None,
        every_ms: int | None = None,
        program: int | None = None,
        objects: int | None = None,
    ) -> SpawnedProcess:
        """Begin a session in `folder`, which has a folder `vehicles`: its supervisor. One session flies at a time.

        log: takes the supervisor's standard error instead of ours. The others: as of gcs.session.process.fly. Raises
        SpawnError.
        """
        ours, theirs = socket.socketpair()
        pickled = base64.b64encode(pickle.dumps(scenario)).decode()
        given = {name: one for name, one in (("program", program), ("objects", objects)) if one is not None}
        order = {
            "folder": os.path.abspath(folder),
            "modules": list(modules),
            "scenario": pickled,
            "log": None if log is None else os.path.abspath(log),
            "every_ms": every_ms,
            "given": list(given),
        }
        number = self._number = next(self._numbers)
        with ours, theirs:
            self._vehicles.start([{"argv": ["fork-server"], "sysid": number}], [theirs.fileno()])
            try:
                self._flight = SpawnedProcess(self._supervisors, number, order, [ours.fileno(), *given.values()])
            except LaunchError:
                raise SpawnError(NOT_UP) from None
        return self._flight

    def vehicles_ended(self) -> Ended:
        """The end of the vehicles' fork server of the last session, whose supervisor has ended. Raises SpawnError."""
        while self._vehicles.alive:
            for end in self._vehicles.events(READY_WITHIN_S):
                if end.sysid == self._number:
                    return end
        raise SpawnError("a process that forks sessions has died while one flew")

    def close(self) -> None:
        """End all processes, once a session that still flies has saved what it flew, and remove the folder."""
        if os.getpid() != self._pid:
            return
        if self._flight is not None and not self._flight.stdin.closed:
            self._flight.stdin.close()
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._flight.wait(SAVES_WITHIN_S)
        self._opened.close()
