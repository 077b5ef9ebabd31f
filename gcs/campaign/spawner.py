"""Sessions one after the other from processes that stay loaded: each as by `gcs run`.

    with SessionSpawner() as sessions:
        flight = sessions.fly(scenario, "first")

Each has processes and sockets of its own and the digest of `gcs run SCENARIO --lockstep`; only starting is cheaper: its
supervisor is forked from one fork server (gcs/campaign/fork_server.py), its vehicles from another.
"""

from __future__ import annotations

import base64
import contextlib
import json
import math
import os
import pickle
import select
import shutil
import signal
import socket
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Self

from gcs.processes.fork_server import Ended, ForkServer, LaunchError
from gcs.processes.python import start_python
from gcs.scenario.file import dump
from gcs.scenario.model import Scenario

READY_WITHIN_S = 60.0
ENDS_WITHIN_S = 20.0
"""Wall time that a session has to save itself once it was asked to end; then it is killed."""


class SpawnError(RuntimeError):
    """Sessions cannot be flown here; the text says why."""


@dataclass(frozen=True)
class Flight:
    """A session that has ended, and its folder, which lasts until `discard` or the end of its spawner."""

    folder: Path
    scenario: Scenario
    outcome: str
    """as in the summary; empty where there is none"""
    error: str | None
    """why it could not be flown to its end, one sentence"""
    wall_s: float
    cpu_s: float
    """of its supervisor and its vehicles"""

    def discard(self) -> None:
        """Remove the folder."""
        shutil.rmtree(self.folder, ignore_errors=True)

    def complete(self) -> None:
        """Write the scenario into the folder, which then is as `gcs run` leaves it; raises OSError."""
        (self.folder / "scenario.yaml").write_text(dump(self.scenario), encoding="utf-8")


class SessionSpawner:
    """The two fork servers; its context's end ends them and the session that flies."""

    def __init__(self) -> None:
        """Start them. Raises SpawnError."""
        with contextlib.ExitStack() as opened:
            self._folder = Path(tempfile.mkdtemp(prefix="gcs-sessions-"))
            opened.callback(shutil.rmtree, self._folder, ignore_errors=True)
            start = partial(start_python, "gcs.campaign.fork_server", str(self._folder))
            try:
                self._vehicles = opened.enter_context(ForkServer.of_vehicles())
                self._supervisors = opened.enter_context(ForkServer.started(start))
            except (LaunchError, OSError) as error:
                raise SpawnError(f"sessions cannot be started: {error}") from None
            self._opened = opened.pop_all()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def alive(self) -> bool:
        """Whether it can fly."""
        return self._vehicles.alive and self._supervisors.alive

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
                raise SpawnError("a process that forks sessions did not come up; gcs doctor looks for the reason")

    def fly(
        self,
        scenario: Scenario,
        name: str,
        *,
        modules: Sequence[str] = (),
        wall_limit_s: float | None = None,
    ) -> Flight:
        """Fly a session in a folder of this name; one that takes longer than `wall_limit_s` is ended.

        Raises SpawnError where a fork server has died or the folder cannot be made.
        """
        self.wait_ready()
        folder, began_s = self._folder / name, time.monotonic()
        try:
            (folder / "vehicles").mkdir(parents=True)
        except OSError as error:
            raise SpawnError(f"cannot make the folder {folder}: {error.strerror}") from None
        reading, writing = os.pipe()
        with open(writing, "wb") as stdin:
            self._start(scenario, folder, modules, reading)
            asks_at_s = math.inf if wall_limit_s is None else began_s + wall_limit_s
            if limited := not self._ended_by(asks_at_s):
                stdin.close()
                if not self._ended_by(asks_at_s + ENDS_WITHIN_S):
                    for pid in self._supervisors.pids:
                        os.kill(pid, signal.SIGKILL)
                    self._ended_by(math.inf)
        supervisor, vehicles = self._ends[self._supervisors], self._ends[self._vehicles]
        wall_s, cpu_s = time.monotonic() - began_s, supervisor.cpu_s + vehicles.cpu_s
        last_word = next((line for line in reversed(supervisor.last_lines) if line.startswith('{"exit"')), None)
        verdict = {} if last_word is None else json.loads(last_word)
        why = verdict.get("error")
        if limited:
            why = f"it took longer than {wall_limit_s:g} s of wall time and was ended"
        elif last_word is None:
            why = f"the supervisor {supervisor.how()} before the session's end"
        return Flight(folder, scenario, verdict.get("outcome") or "", why, wall_s, cpu_s)

    def close(self) -> None:
        """End all processes, and remove the folders."""
        self._opened.close()

    def _start(self, scenario: Scenario, folder: Path, modules: Sequence[str], stdin: int) -> None:
        """Have a fork server forked for the session's vehicles, and a supervisor that holds its socket; `stdin`, which
        is closed here, is the supervisor's."""
        self._ends: dict[ForkServer, Ended] = {}
        ours, theirs = socket.socketpair()
        pickled = base64.b64encode(pickle.dumps(scenario)).decode()
        order = {"folder": str(folder), "modules": list(modules), "scenario": pickled}
        log = folder / "vehicles" / "fork_server.log"
        with ours, theirs:
            self._vehicles.start([{"argv": ["fork-server"], "log": str(log)}], [theirs.fileno()])
            self._supervisors.start([order], [stdin, ours.fileno()])
        os.close(stdin)

    def _ended_by(self, deadline_s: float) -> bool:
        """Wait until the session's supervisor and its vehicles' fork server have ended, or until the monotonic clock
        says this; whether they have. Raises SpawnError."""
        servers = (self._supervisors, self._vehicles)
        while len(self._ends) < len(servers):
            left_s = None if deadline_s == math.inf else max(deadline_s - time.monotonic(), 0.0)
            if not select.select(servers, [], [], left_s)[0]:
                return False
            for server in servers:
                self._ends.update((server, end) for end in server.events())
            if not self.alive:
                raise SpawnError("a process that forks sessions has died while one flew")
        return True
