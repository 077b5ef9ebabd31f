"""Rows of a campaign flown by workers: processes of this machine by default, a cluster's by `--scheduler`.

The workers fly and measure; this process alone writes the table. A row counts once it is written, so that whatever
dies in between costs nothing but the sessions that were in the air.
"""

from __future__ import annotations

import fcntl
import os
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any

from gcs.campaign import table, worker
from gcs.campaign.cluster import Cluster, EngineError
from gcs.campaign.plan import Plan, PlannedRow
from gcs.campaign.pool import WorkerPool
from gcs.processes.python import current_folders

FLUSH_EVERY_S = 2.0
FLUSH_ROWS = 200
LOOK_EVERY_S = 0.2
COUNT_EVERY_S = 1.0
SESSIONS = "sessions"
END = object()


@dataclass
class Progress:
    """Progress of a campaign."""

    total: int
    done: int = 0
    failed: int = 0
    errors: int = 0
    workers: int = 0
    began_s: float = field(default_factory=time.monotonic)
    flown: int = 0
    """in this run alone"""
    dashboard: str = ""

    @property
    def rate(self) -> float:
        """Rows per second of this run."""
        return self.flown / max(time.monotonic() - self.began_s, 1e-9)

    @property
    def left_s(self) -> float | None:
        """Wall time to the end; None while it is unknown."""
        return (self.total - self.done) / self.rate if self.flown else None


def fly(
    plan: Plan,
    rows: Iterable[PlannedRow | None],
    keep: Callable[[dict[str, Any]], None],
    *,
    scheduler: str | None = None,
    workers: int | None = None,
    look: Callable[[int], bool] = lambda _: True,
    on_start: Callable[[str], None] = lambda _: None,
) -> bool:
    """Fly rows, each handed to `keep` as it comes, in any order; False where `look` stopped it.

    None among the rows means that those to follow depend on what is still in the air.
    `on_start` gets the address of Dask's dashboard. `look` gets the number of workers several times a second, and says
    whether to go on. Raises EngineError, and MissingExtra where a scheduler is given without Dask.
    """
    if scheduler is None and not current_folders():
        raise EngineError("the current folder is gone, without which Python starts no worker; change to another one")
    with WorkerPool(plan, workers) if scheduler is None else Cluster(plan, scheduler) as flyers:
        on_start(flyers.dashboard)
        waiting, flying, exhausted = iter(rows), 0, False
        count, room, counted_s = 0, 0, -COUNT_EVERY_S
        while True:
            if time.monotonic() - counted_s >= COUNT_EVERY_S:
                count, room, counted_s = flyers.count, flyers.room, time.monotonic()
            while not exhausted and flying < room:
                row = next(waiting, END)
                exhausted = row is END
                if not isinstance(row, PlannedRow):
                    break
                flyers.submit(row)
                flying += 1
            if exhausted and not flying:
                return True
            for flown in flyers.collect(LOOK_EVERY_S):
                flying -= 1
                keep(flown)
            if not look(count):
                return False


class CampaignStore:
    """A campaign's folder while it is written: rows in parts, kept sessions; one writer at a time."""

    def __init__(self, folder: Path, plan: Plan) -> None:
        self._lock: IO[str] = (folder / ".lock").open("w", encoding="utf-8")
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            self._lock.close()
            raise EngineError(f"{folder} is being flown by another process") from None
        self.folder = folder
        self._writer = table.Writer(folder, plan.campaign)
        self._pending: list[dict[str, Any]] = []
        self._flushed_s = time.monotonic()

    def drop_errors(self) -> None:
        """Take the rows that are errors out of the table; raises EngineError."""
        try:
            self._writer.drop_errors()
        except OSError as error:
            raise self._full(error) from None

    def keep(self, row: dict[str, Any]) -> None:
        """Keep a row, soon on disk; raises EngineError."""
        content = row.pop("folder", None)
        try:
            if content is not None:
                worker.unpack(content, self.folder / SESSIONS / str(row["row"]))
        except OSError as error:
            raise self._full(error) from None
        self._pending.append(row)
        if len(self._pending) >= FLUSH_ROWS:
            self.flush()

    def look(self) -> None:
        """Write what has waited long enough; raises EngineError."""
        if time.monotonic() - self._flushed_s >= FLUSH_EVERY_S:
            self.flush()

    def flush(self) -> None:
        """Write what waits; raises EngineError."""
        self._flushed_s = time.monotonic()
        rows, self._pending = self._pending, []
        try:
            self._writer.write(rows)
        except OSError as error:
            raise self._full(error) from None

    def close(self) -> None:
        """Let go of the folder."""
        self._lock.close()

    def _full(self, error: OSError) -> EngineError:
        why = os.strerror(error.errno) if error.errno else str(error)  # Arrow's own text is a longer one
        return EngineError(f"{self.folder} cannot be written: {why}; make room there")
