"""A campaign in its folder from start to end, or on from where it stopped."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable, Iterator
from datetime import datetime
from pathlib import Path
from types import FrameType
from typing import Any

from gcs.campaign import table
from gcs.campaign.cluster import EngineError
from gcs.campaign.engine import CampaignStore, Progress, fly
from gcs.campaign.plan import Plan, PlannedRow
from gcs.extras import require

DEFAULT_FOLDER = "campaigns"
NEEDED = {"pyarrow": "pyarrow", "matplotlib": "Matplotlib"}


def make_folder(plan: Plan, out: Path | None) -> Path:
    """A new campaign folder with the plan in it. Raises EngineError, and MissingExtra where it could not be flown."""
    require("a campaign", NEEDED, "campaign")
    stamp = datetime.now().astimezone().strftime("%Y%m%d-%H%M%S")
    folder = out or Path(DEFAULT_FOLDER) / f"{plan.campaign.name}-{stamp}"
    try:
        folder.mkdir(mode=0o700, parents=True)
        plan.write(folder)
    except FileExistsError:
        raise EngineError(
            f"{folder} exists already and is left as it is; gcs campaign resume goes on with it"
        ) from None
    except OSError as error:
        raise EngineError(f"cannot write in {folder}: {error.strerror}; give --out a place to write") from None
    return folder


class Runner:
    """Flies what a campaign's folder lacks. Ctrl-C stops it; what has come is written.

    rows: other rows than the plan's, as many as it has. errors: fly those again that ended with an error.
    """

    def __init__(
        self,
        folder: Path,
        plan: Plan,
        *,
        scheduler: str | None = None,
        workers: int | None = None,
        notify: Callable[[Progress, dict[str, Any] | None], None] = lambda _progress, _row: None,
        rows: Iterator[PlannedRow | None] | None = None,
        errors: bool = False,
    ) -> None:
        self._rows, self._errors = rows, errors
        self._folder, self._plan = folder, plan
        self._scheduler, self._workers = scheduler, workers
        self._notify = notify
        self._stopped = False
        self.interrupted = 0
        """the signal that stopped it; 0 where none did"""

    def run(self) -> Progress:
        """Fly until every row is there, or a signal comes. Raises EngineError."""
        store = CampaignStore(self._folder, self._plan)
        handlers = _handled(self._interrupt)
        try:
            if self._errors:
                store.drop_errors()
            done = set(table.read(self._folder, self._plan.campaign)["row"].to_pylist())
            progress = Progress(self._plan.rows, len(done))

            def keep(row: dict[str, Any]) -> None:
                store.keep(row)
                progress.done += 1
                progress.flown += 1
                progress.failed += not row["ok"]
                progress.errors += row["error"] is not None
                self._notify(progress, row)

            def look(workers: int) -> bool:
                store.look()
                progress.workers = workers
                self._notify(progress, None)
                return not self._stopped

            def started(dashboard: str) -> None:
                progress.dashboard = dashboard
                progress.began_s = time.monotonic()

            try:
                if len(done) < progress.total:
                    fly(
                        self._plan,
                        self._rows or (self._plan.row(k) for k in range(progress.total) if k not in done),
                        keep,
                        scheduler=self._scheduler,
                        workers=self._workers,
                        look=look,
                        on_start=started,
                    )
            finally:
                store.flush()
            return progress
        finally:
            for number, handler in handlers.items():
                signal.signal(number, handler)
            store.close()

    def _interrupt(self, number: int, _: FrameType | None) -> None:
        self.interrupted = self.interrupted or number
        self._stopped = True


def _handled(handler: Callable[[int, FrameType | None], None]) -> dict[int, Any]:
    """SIGINT and SIGTERM call this; what they did before. Nothing changes outside the main thread."""
    try:
        return {number: signal.signal(number, handler) for number in (signal.SIGINT, signal.SIGTERM)}
    except ValueError:
        return {}
