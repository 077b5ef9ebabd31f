"""A session from Python:

    with gcs.Session("demo", lockstep=True) as session:
        for snapshot in session:
            ...
    print(session.summary.outcome_text)

The same processes as `gcs run` starts, and the same folder left behind; here the loop's body sees every snapshot, and
in lockstep the fleet waits for it.
"""

from __future__ import annotations

import contextlib
import json
import os
import select
import socket
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Self

from gcs.processes import plugin_process
from gcs.recording.summary import FILE, Summary
from gcs.scenario.file import find, load
from gcs.scenario.model import Scenario
from gcs.scenario.parts.reach import reached
from gcs.scenario.parts.trust import digest_of, require
from gcs.session.arrays import Snapshot, from_message
from gcs.session.client import NEXT, READ_BYTES, STOP
from gcs.session.supervised import PATIENCE_S, RunError, Supervised, make_folder, write_scenario


class SessionError(RuntimeError):
    """A session that could not be flown, or has not ended yet; the text says why and what to do."""


class Session:
    """One session; a context manager, and inside it an iterator of snapshots.

    scenario: a file, the name of a shipped one, or a `Scenario`. lockstep, speed, seed: instead of the scenario's, as
    `gcs run`'s options. out: the session's folder, which must not exist yet; `sessions/NAME-TIME` without it.
    every_s: session time between snapshots, a multiple of the scenario's clock.period_s; each period without it.

    On the real clock the fleet does not wait: a slow body misses snapshots. Ending the context before the session's
    end stops it and saves what was flown.

    trust: let the scenario use the code, programs, key files, devices and addresses that it names, which for a file is
    remembered until it changes, as of `--trust`. Raises TrustError where that has not been agreed to, ScenarioError,
    ValueError for options, SessionError.
    """

    def __init__(
        self,
        scenario: str | os.PathLike[str] | Scenario,
        *,
        lockstep: bool = False,
        speed: float | None = None,
        seed: int | None = None,
        out: str | os.PathLike[str] | None = None,
        every_s: float | None = None,
        trust: bool = False,
    ) -> None:
        if lockstep and speed is not None:
            raise ValueError("lockstep and speed exclude each other: lockstep is as fast as the machine can")
        folders = [Path.cwd()]
        if isinstance(scenario, Scenario):
            loaded, file, key = scenario, None, None
        else:
            file = find(os.fspath(scenario))
            loaded, key = load(file), digest_of(file)
            folders.insert(0, file.parent)
        require(loaded.name if file is None else str(scenario), reached(loaded), key, trust=trust)
        plugin_process.check(loaded, file, folders)
        self.scenario = loaded.flown(lockstep=lockstep, speed=speed, seed=seed)
        period_ms = round(1e3 * self.scenario.clock.period_s)
        self._every_ms = period_ms if every_s is None else round(1e3 * every_s)
        if self._every_ms <= 0 or self._every_ms % period_ms:
            raise ValueError(
                f"every_s is {every_s}; it must be a multiple of the scenario's period, {period_ms / 1e3} s"
            )
        self._arguments = [word for folder in folders for word in ("--modules", str(folder.resolve()))]
        self._out = None if out is None else Path(out)
        self._folder: Path | None = None
        self._process: Supervised | None = None
        self._channel: socket.socket | None = None
        self._summary: Summary | None = None

    @property
    def folder(self) -> Path:
        """Folder that the session leaves behind (docs/protocol.md#session-folder)."""
        if self._folder is None:
            raise SessionError("the session has no folder before it begins; use it as `with Session(...) as session:`")
        return self._folder

    @property
    def summary(self) -> Summary:
        """Result: outcome, distances, energy, refuellings, digest. Raises SessionError before the end."""
        if self._summary is None:
            raise SessionError("the session has not ended: read `summary` after the loop, or after the with block")
        return self._summary

    def __enter__(self) -> Self:
        if self._folder is not None:
            raise SessionError("a session flies once; make another one")
        try:
            self._folder = make_folder(self._out, self.scenario.name)
            write_scenario(self._folder, self.scenario)
        except RunError as error:
            raise SessionError(error.message) from None
        ours, theirs = socket.socketpair()
        with theirs:
            arguments = ["--reader", str(theirs.fileno()), "--every-ms", str(self._every_ms), *self._arguments]
            self._channel = ours
            self._process = Supervised(self._folder, arguments, (theirs.fileno(),))
        return self

    def __iter__(self) -> Iterator[Snapshot]:
        if self._channel is None:
            raise SessionError("the session does not fly; use it as `with Session(...) as session:`")
        pending = b""
        while True:
            with contextlib.suppress(OSError):
                self._channel.sendall(NEXT)
            while b"\n" not in pending:
                try:
                    chunk = self._channel.recv(READ_BYTES)
                except OSError:
                    chunk = b""
                if not chunk:
                    self._end()
                    return
                pending += chunk
            line, _, pending = pending.partition(b"\n")
            yield from_message(json.loads(line))

    def finish(self) -> Summary:
        """Fly on to the end without looking, and return the summary."""
        self._end()
        return self.summary

    def stop(self) -> Summary:
        """End the session now, save what was flown, and return the summary; its outcome is `interrupted`."""
        if self._channel is not None and self._summary is None:
            with contextlib.suppress(OSError):
                self._channel.sendall(STOP)
            self._end(time.monotonic() + PATIENCE_S[0])
        return self.summary

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        assert self._process is not None
        try:
            if self._channel is not None:
                with contextlib.suppress(SessionError) if kind is not None else contextlib.nullcontext():
                    self.stop()
        finally:
            self._close()
            self._process.__exit__()

    def _close(self) -> None:
        if self._channel is not None:
            self._channel.close()
            self._channel = None

    def _end(self, deadline_s: float = float("inf")) -> None:
        """Wait for the supervisor's last word and read the summary. Raises SessionError where there is none."""
        process = self._process
        if process is None or self._summary is not None:
            return
        if deadline_s == float("inf"):
            self._close()
        while not process.ended and time.monotonic() < deadline_s:
            select.select([process.death], [], [], 0.2)
            process.read()
        process.read()
        self._close()
        verdict = process.verdict
        if verdict is None:
            how = "was stopped" if process.status is None else f"ended with status {process.status}"
            raise SessionError(f"the supervisor {how} before the session's end; its files are in {self.folder}")
        if verdict.get("error"):
            raise SessionError(str(verdict["error"]))
        self._summary = Summary.model_validate_json((self.folder / FILE).read_text(encoding="utf-8"))
