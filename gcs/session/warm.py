"""Sessions one after the other from a process that stays warm (gcs/session/forkserver.py): each as by `gcs run`.

    with WarmSessions() as sessions:
        flight = sessions.fly(scenario, "first")

Each has processes and sockets of its own and the digest of `gcs run SCENARIO --lockstep`; only starting is cheaper.
"""

from __future__ import annotations

import base64
import contextlib
import json
import os
import pickle
import select
import shutil
import subprocess
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from gcs.processes.forked import await_end
from gcs.processes.python import start_python
from gcs.scenario.file import dump
from gcs.scenario.model import Scenario

WARM_WITHIN_S = 60.0
ENDS_WITHIN_S = 20.0
"""Wall time that a session has to save itself once it was asked to end; then it is killed."""


class WarmError(RuntimeError):
    """Sessions cannot be flown here; the text says why."""


@dataclass(frozen=True)
class Flight:
    """A session that has ended, and its folder, which lasts until `discard` or the end of the warm process."""

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


class WarmSessions:
    """The warm process; its context's end ends it and whatever flies."""

    def __init__(self, core: int | None = None) -> None:
        """`core`: on which all its processes stay; otherwise on any."""
        on_core = [] if core is None else [str(core)]
        self._process = start_python(
            "gcs.session.forkserver",
            *on_core,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            start_new_session=True,
        )
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._in, self._out = self._process.stdin, self._process.stdout
        os.set_blocking(self._out.fileno(), False)
        self._pending = b""
        self._folder: Path | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def alive(self) -> bool:
        """Whether it can fly."""
        return self._process.poll() is None

    @property
    def pid(self) -> int:
        """The warm process."""
        return self._process.pid

    def warm_up(self) -> None:
        """Wait until everything is loaded. Raises WarmError."""
        deadline_s = time.monotonic() + WARM_WITHIN_S
        while self._folder is None:
            content = next(self._messages(deadline_s), None)
            if content is None:
                raise WarmError("the process that forks supervisors did not come up; gcs doctor looks for the reason")
            if content.get("ready"):
                self._folder = Path(content["folder"])

    def fly(
        self,
        scenario: Scenario,
        name: str,
        *,
        modules: Sequence[str] = (),
        wall_limit_s: float | None = None,
    ) -> Flight:
        """Fly a session in a folder of this name; one that takes longer than `wall_limit_s` is ended.

        Raises WarmError where the warm process has died or the folder cannot be made.
        """
        self.warm_up()
        assert self._folder is not None
        folder, began_s = self._folder / name, time.monotonic()
        try:
            (folder / "vehicles").mkdir(parents=True)
        except OSError as error:
            raise WarmError(f"cannot make the folder {folder}: {error.strerror}") from None
        pickled = base64.b64encode(pickle.dumps(scenario)).decode()
        self._send({"folder": str(folder), "modules": list(modules), "scenario": pickled})
        deadlines_s = [] if wall_limit_s is None else [began_s + wall_limit_s, began_s + wall_limit_s + ENDS_WITHIN_S]
        verdict: dict[str, Any] = {}
        limited = False
        while True:
            for content in self._messages(deadlines_s[0] if deadlines_s else None):
                if "exit" in content:
                    verdict = content
                if "ended" in content:
                    wall_s, cpu_s = time.monotonic() - began_s, float(content["cpu_s"])
                    why = verdict.get("error") or _fate(verdict, content["status"])
                    if limited:
                        why = f"it took longer than {wall_limit_s:g} s of wall time and was ended"
                    return Flight(folder, scenario, verdict.get("outcome") or "", why, wall_s, cpu_s)
            if deadlines_s and time.monotonic() >= deadlines_s[0]:
                self._send({"kill": True} if limited else {"stop": True})
                limited = True
                del deadlines_s[0]
            elif not self.alive:
                raise WarmError(f"the process that forks supervisors has died while the session {name} flew")

    def close(self) -> None:
        """End the process and everything that it made."""
        with contextlib.suppress(OSError):
            self._in.close()
        await_end(self._process, ENDS_WITHIN_S)
        self._out.close()
        if self._folder is not None:
            shutil.rmtree(self._folder, ignore_errors=True)

    def _send(self, order: dict[str, Any]) -> None:
        try:
            self._in.write(json.dumps(order).encode() + b"\n")
            self._in.flush()
        except OSError:
            raise WarmError("the process that forks supervisors has died") from None

    def _messages(self, deadline_s: float | None) -> Iterator[dict[str, Any]]:
        """Its next messages, waiting for them; none where it says no more, or not until the deadline."""
        while b"\n" not in self._pending:
            left_s = None if deadline_s is None else max(deadline_s - time.monotonic(), 0.0)
            if not select.select([self._out], [], [], left_s)[0]:
                return
            chunk = os.read(self._out.fileno(), 65536)
            if not chunk:
                self._process.wait()
                return
            self._pending += chunk
        line, _, self._pending = self._pending.partition(b"\n")
        yield json.loads(line)


def _fate(verdict: dict[str, Any], status: int) -> str | None:
    """Sentence on a supervisor that ended without a last word."""
    if verdict:
        return None
    how = f"was killed by signal {-status}" if status < 0 else f"ended with status {status}"
    return f"the supervisor {how} before the session's end"
