"""Workers of a campaign on this machine: processes that rows reach through pipes. Nothing listens, and no other user
can reach them."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
from collections import deque
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from typing import Any

from gcs.campaign import worker
from gcs.campaign.plan import Plan, PlannedRow
from gcs.processes.python import safe_path
from skytender.processes import end_with

DEATHS = 5
"""Number of times that a row's worker may die before the row is an error."""
AHEAD = 2
"""Rows of each worker: the one in the air, and the next."""


class WorkerPool:
    """So many processes, each with rows of its own; one that dies is replaced. Its context's end ends them all.

    On as many as there are cores, or more, each keeps its sessions on one core.
    """

    dashboard = ""

    def __init__(self, plan: Plan, workers: int | None) -> None:
        cores = sorted(os.sched_getaffinity(0))
        self.count = workers or len(cores)
        self._cores = [cores[i % len(cores)] if self.count >= len(cores) else None for i in range(self.count)]
        self._plan = plan
        self._deaths: dict[int, int] = {}

    def __enter__(self) -> WorkerPool:
        self._workers = [_Worker(self._plan, core) for core in self._cores]
        return self

    def __exit__(self, *_: object) -> None:
        for one in self._workers:
            one.process.kill()  # what it has started ends with its pipes
        for one in self._workers:
            one.close()

    @property
    def room(self) -> int:
        """Rows that can be under way at once."""
        return AHEAD * self.count

    def submit(self, row: PlannedRow) -> None:
        """Give a row to the worker that has fewest."""
        min(self._workers, key=lambda one: len(one.rows)).give(row)

    def collect(self, within_s: float) -> list[dict[str, Any]]:
        """Rows that have come, waiting so long for the first."""
        came = []
        ready = wait([one.pipe for one in self._workers], within_s)
        for i, one in enumerate(self._workers):
            if one.pipe in ready:
                try:
                    came.append(one.take())
                except (EOFError, OSError):
                    came += self._replace(i)
        return came

    def _replace(self, i: int) -> list[dict[str, Any]]:
        """Let a new worker fly what a dead one had; the row that was in the air, where it has cost too many."""
        dead, new = self._workers[i], _Worker(self._plan, self._cores[i])
        dead.close()
        self._workers[i] = new
        lost: list[dict[str, Any]] = []
        if dead.rows:
            first = dead.rows[0]
            self._deaths[first.number] = self._deaths.get(first.number, 0) + 1
            if self._deaths[first.number] > DEATHS:
                lost.append(worker.failed(self._plan, dead.rows.popleft(), died(DEATHS)))
        for row in dead.rows:
            new.give(row)
        return lost


def died(deaths: int) -> str:
    """Why a row was not flown whose workers may die so often."""
    return f"its workers died, {deaths + 1} times"


class _Worker:
    """One process with its pipe, and the rows that it has, in order."""

    def __init__(self, plan: Plan, core: int | None) -> None:
        self.pipe, theirs = multiprocessing.Pipe()
        self.rows: deque[PlannedRow] = deque()
        self.process = multiprocessing.get_context("spawn").Process(
            target=_serve, args=(theirs, plan, core, os.getpid()), daemon=True
        )
        with ExitStack() as stack:
            for prepared in (safe_path, _without_main, _sigint_blocked):
                stack.enter_context(prepared())
            self.process.start()
        theirs.close()

    def give(self, row: PlannedRow) -> None:
        self.rows.append(row)
        try:
            self.pipe.send(row)
        except OSError:
            return  # it is dead, as a reader sees by the end of its pipe

    def take(self) -> dict[str, Any]:
        """The row that it has flown. Raises EOFError or OSError where it is dead."""
        flown: dict[str, Any] = self.pipe.recv()
        self.rows.popleft()
        return flown

    def close(self) -> None:
        self.process.join()
        self.process.close()
        self.pipe.close()


def _serve(pipe: Connection, plan: Plan, core: int | None, parent: int) -> None:
    """Fly the rows that come, in the worker; it ends with its parent, or with the pipe.

    The processes of a session in lockstep take turns: on one `core` they find its caches full of theirs, and wake each
    other without waking a core.
    """
    end_with(parent)
    if core is not None:
        with suppress(OSError):  # it is only slower elsewhere
            os.sched_setaffinity(0, {core})
    try:
        while True:
            row = pipe.recv()
            try:
                flown = worker.fly_row(plan, row)
            except Exception as error:
                why = f"the worker failed: {type(error).__name__}: {error}"
                flown = worker.failed(plan, row, " ".join(why.split()))
            pipe.send(flown)
    except (EOFError, OSError):
        worker.close()


@contextmanager
def _without_main() -> Iterator[None]:
    """Processes that are spawned meanwhile do not run this one's main module again.

    Workers import what they need by name. Without this a script that calls `fly` outside of `if __name__ ==
    "__main__":` would be run by each worker, and fly a campaign of its own.
    """
    main = sys.modules["__main__"]
    kept = {name: getattr(main, name) for name in ("__file__", "__spec__") if hasattr(main, name)}
    try:
        for name in kept:
            setattr(main, name, None)
        yield
    finally:
        for name, value in kept.items():
            setattr(main, name, value)


@contextmanager
def _sigint_blocked() -> Iterator[None]:
    """Ctrl-C is for this process: workers and what they start never see it."""
    resource_tracker.ensure_running()  # its start, which would come with the first worker's, unblocks the signal
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
