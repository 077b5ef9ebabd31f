"""A campaign from Python:

table = gcs.Campaign("policies", sessions=20).fly()
print(table.to_pandas().groupby("competition.policy")["delivered_j"].mean())
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from gcs.campaign import file, table
from gcs.campaign.cluster import EngineError, check_scheduler
from gcs.campaign.engine import Progress
from gcs.campaign.plan import NotAllowed, make, read
from gcs.campaign.runner import Runner, make_folder
from gcs.scenario.document import path_of
from gcs.scenario.parts.trust import require

if TYPE_CHECKING:
    import pyarrow as pa


class Campaign:
    """One campaign and its folder.

    campaign: a file, the name of a shipped one, or its content as plain data. sessions, seed: instead of its own.
    out: a new folder, or one to go on with, which then needs to be of this campaign, with no more sessions than this
    one has; `campaigns/NAME-TIME` without it.
    scheduler: address of a Dask scheduler, by mutual TLS (docs/how-to/campaigns.md); otherwise so many `workers` here,
    one per core by default.

    trust: let it use the code, programs, key files and addresses that it and its scenario name, which is remembered
    until they change, as of `--trust`. Raises TrustError where that has not been agreed to, ScenarioError where it
    cannot be flown, EngineError for a scheduler without TLS and for fewer than one worker.
    """

    def __init__(
        self,
        campaign: str | os.PathLike[str] | Mapping[str, Any],
        *,
        sessions: int | None = None,
        seed: int | None = None,
        out: str | os.PathLike[str] | None = None,
        scheduler: str | None = None,
        workers: int | None = None,
        trust: bool = False,
    ) -> None:
        if scheduler is not None:
            check_scheduler(scheduler)
        if workers is not None and workers < 1:
            raise EngineError(f"workers is {workers}, but a campaign needs at least 1; None: one per core")
        beside: list[Path] = []
        if isinstance(campaign, Mapping):
            loaded = file.from_data(dict(campaign))
        else:
            wanted = "a file, the name of a shipped one, or its content as plain data"
            path = file.find(path_of(campaign, "campaign", wanted))
            loaded, beside = file.load(path), [path.parent]
        changes = {key: value for key, value in (("sessions", sessions), ("seed", seed)) if value is not None}
        if changes:
            plain = loaded.model_dump(mode="json", by_alias=True, exclude_none=True)
            loaded = file.from_data(plain | changes, loaded.name)
        self.plan = make(loaded, beside)
        try:
            self.plan = self.plan.checked()
        except NotAllowed as asks:
            name = loaded.name if isinstance(campaign, Mapping) else os.fspath(campaign)
            require(name, asks.named, self.plan.trusted_by, trust=trust)
            self.plan = replace(self.plan, trusted=True).checked()
        self._scheduler, self._workers = scheduler, workers
        self._out = None if out is None else Path(path_of(out, "out"))
        self._folder: Path | None = None

    @property
    def folder(self) -> Path:
        """Folder of its rows. Raises EngineError before `fly`."""
        if self._folder is None:
            raise EngineError("the campaign has no folder before it is flown")
        return self._folder

    @property
    def table(self) -> pa.Table:
        """The rows so far; `to_pandas` makes a frame of them."""
        return table.read(self.folder, self.plan.campaign)

    @property
    def failures(self) -> list[str]:
        """A sentence for each session that is not as expected."""
        rows = self.table.select(["row", "ok", "fault", "error"]).to_pylist()
        return [f"row {row['row']}: {row['error'] or row['fault']}" for row in rows if not row["ok"]]

    def fly(
        self,
        notify: Callable[[Progress, dict[str, Any] | None], None] = lambda _progress, _row: None,
        *,
        errors: bool = False,
    ) -> pa.Table:
        """Fly what is missing, and with `errors` also what ended with an error; the table. `notify` is called with each
        row. Raises EngineError, KeyboardInterrupt, and
        ScenarioError where the scenario, a module that is named, or what is in `out` was changed since its sessions
        were flown."""
        folder = self._folder or self._out
        if folder is not None and (folder / "plan.json").exists():
            flown = read(folder)
            before, wanted = flown.campaign.sessions, self.plan.campaign.sessions
            if wanted < before or flown.campaign.model_copy(update={"sessions": wanted}) != self.plan.campaign:
                raise EngineError(f"{folder} holds another campaign; give a new folder")
            self.plan.refuse_other(flown.fingerprint, self.plan.file)
            self.plan.refuse_changed_code(flown.sources)
            if wanted > before:
                self.plan.write(folder)
            self._folder = folder
        else:
            self._folder = make_folder(self.plan, folder)
        runner = Runner(
            self._folder, self.plan, scheduler=self._scheduler, workers=self._workers, notify=notify, errors=errors
        )
        runner.run()
        if runner.interrupted:
            raise KeyboardInterrupt
        return self.table
