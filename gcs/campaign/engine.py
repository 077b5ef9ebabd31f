"""Rows of a campaign flown on Dask's workers: here by default, anywhere by `--scheduler`.

The workers fly and measure; this process alone writes the table. A row counts once it is written, so that whatever
dies in between costs nothing but the sessions that were in the air.
"""

from __future__ import annotations

import contextlib
import fcntl
import os
import queue
import signal
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import CancelledError
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any

from gcs.campaign import table, worker
from gcs.campaign.plan import Plan, PlannedRow
from gcs.extras import missing
from gcs.supervisor.summarise import versions

FLUSH_EVERY_S = 2.0
FLUSH_ROWS = 200
LOOK_EVERY_S = 0.2
COUNT_EVERY_S = 1.0
AHEAD = 3
"""Rows handed out for each that a worker can fly at once."""
DEATHS = 5
"""Number of times that a row's worker may die before the row is an error."""
CONNECT_WITHIN_S = 20.0
SETTINGS = {
    "distributed.scheduler.allowed-failures": DEATHS,
    "distributed.worker.profile.enabled": False,
    "distributed.admin.system-monitor.interval": "5s",
    "distributed.admin.system-monitor.disk": False,
    "distributed.admin.tick.interval": "500ms",
    "distributed.comm.timeouts.connect": CONNECT_WITHIN_S,
    "distributed.admin.log-length": 100,
    "distributed.worker.memory.target": False,
    "distributed.worker.memory.spill": False,
}
SESSIONS = "sessions"
END = object()


class EngineError(RuntimeError):
    """A campaign that cannot go on; the text says why, and rows that were written stay."""


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
    whether to go on. Raises EngineError.
    """
    with _cluster(scheduler, workers) as client:
        on_start(_dashboard(client))
        came: queue.Queue[Any] = queue.Queue()
        waiting = iter(rows)
        flying: dict[str, tuple[Any, PlannedRow]] = {}
        exhausted, threads, counted_s = False, 0, -COUNT_EVERY_S
        while True:
            if time.monotonic() - counted_s >= COUNT_EVERY_S:
                threads, counted_s = _threads(client), time.monotonic()
            while not exhausted and len(flying) < max(AHEAD * threads, AHEAD):
                row = next(waiting, END)
                exhausted = row is END
                if not isinstance(row, PlannedRow):
                    break
                future = client.submit(
                    worker.fly_row, plan, row, pure=False, key=f"row-{row.number}-{os.urandom(4).hex()}"
                )
                flying[future.key] = (future, row)
                future.add_done_callback(came.put)
            if exhausted and not flying:
                return True
            with contextlib.suppress(queue.Empty):
                future = came.get(timeout=LOOK_EVERY_S)
                if future.key in flying:
                    keep(_result(plan, future, flying.pop(future.key)[1]))
            if not look(threads):
                return False


def _threads(client: Any) -> int:
    """Number of rows that can be flown at once. Raises EngineError where the scheduler does not answer."""
    try:
        return sum(client.nthreads().values())
    except (OSError, TimeoutError, RuntimeError, ValueError):
        raise EngineError("the scheduler is lost") from None


def _result(plan: Plan, future: Any, row: PlannedRow) -> dict[str, Any]:
    """The row that was flown, or why it was not. Raises EngineError where the scheduler has gone, with it or before."""
    from distributed.scheduler import KilledWorker  # noqa: PLC0415 - an extra

    try:
        if future.status == "finished":
            result: dict[str, Any] = future.result()
            future.release()
            return result
        error = None if future.status in ("cancelled", "lost") else future.exception()
    except (OSError, CancelledError):  # it went while the result was on its way
        error = None
    if error is None:
        raise EngineError("the scheduler is lost")
    why = f"the worker failed: {type(error).__name__}: {error}"
    if isinstance(error, KilledWorker):
        why = f"its workers died, {DEATHS + 1} times"
    return worker.failed(plan, row, " ".join(why.split()))


@contextlib.contextmanager
def _cluster(scheduler: str | None, workers: int | None) -> Iterator[Any]:
    """A client of a cluster in this command, or of one that runs; its end leaves nothing of ours behind."""
    try:
        import dask  # noqa: PLC0415 - an extra
        from distributed import Client, LocalCluster  # noqa: PLC0415
    except ImportError:
        raise missing("a campaign", "Dask", "campaign") from None

    with contextlib.ExitStack() as stack:
        stack.enter_context(dask.config.set(SETTINGS))
        _quieten_dask()
        if scheduler is None:
            stack.enter_context(_without_main())
            scratch = stack.enter_context(
                tempfile.TemporaryDirectory(prefix="gcs-campaign-", ignore_cleanup_errors=True)
            )
            cores = sorted(os.sched_getaffinity(0))
            with _sigint_blocked():  # Ctrl-C is for this process: workers and what they start never see it
                cluster = stack.enter_context(
                    LocalCluster(
                        n_workers=workers or len(cores),
                        threads_per_worker=1,
                        processes=True,
                        dashboard_address="127.0.0.1:0",
                        local_directory=scratch,
                        silence_logs=50,
                    )
                )
                client = stack.enter_context(Client(cluster))
            if (workers or len(cores)) >= len(cores):  # fewer use the others' cores, too
                client.run(worker.take_core, cores)
        else:
            try:
                client = stack.enter_context(Client(scheduler, timeout=CONNECT_WITHIN_S))
            except (OSError, ValueError, TimeoutError) as error:
                why = " ".join(str(error).split())
                raise EngineError(f"no scheduler can be reached at {scheduler}: {why}") from None
            _check_workers(client)
        yield client


@contextlib.contextmanager
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


def _check_workers(client: Any) -> None:
    """Raises EngineError unless there are workers, all with the versions that we have."""
    try:
        client.wait_for_workers(1, timeout=CONNECT_WITHIN_S)
        found = client.run(versions)
    except TimeoutError:
        raise EngineError("the scheduler has no workers; start some with `dask worker ADDRESS --nthreads 1`") from None
    except Exception as error:
        raise EngineError(f"a worker cannot load Skytender: {type(error).__name__}: {error}") from None
    ours = versions()
    for address, theirs in found.items():
        for package, wanted in ours.items():
            if theirs.get(package) != wanted:
                has = theirs.get(package)
                raise EngineError(f"the worker {address} has {package} {has}, not {wanted}: install the same there")


@contextlib.contextmanager
def _sigint_blocked() -> Iterator[None]:
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _quieten_dask() -> None:
    """Dask's own words about lost workers and schedulers are reported by us."""
    import logging  # noqa: PLC0415

    for name in list(logging.root.manager.loggerDict):
        if name.split(".")[0] in ("distributed", "tornado", "asyncio"):
            logging.getLogger(name).setLevel(logging.CRITICAL + 1)


def _dashboard(client: Any) -> str:
    """Address of Dask's own page; empty where there is none."""
    served = client.scheduler_info().get("services", {})
    return str(client.dashboard_link) if "dashboard" in served else ""


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
