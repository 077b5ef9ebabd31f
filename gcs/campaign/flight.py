"""One session of a campaign, from its start to its end."""

from __future__ import annotations

import json
import shutil
import subprocess
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from gcs.processes.forked import end
from gcs.scenario.file import dump
from gcs.scenario.model import Scenario
from gcs.session.spawning.spawner import SessionSpawner, SpawnError

ENDS_WITHIN_S = 20.0
"""Wall time that a session has to save itself once it was asked to end; then it is killed."""
OUTPUT = "output.log"


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


def fly(
    sessions: SessionSpawner,
    scenario: Scenario,
    name: str,
    *,
    modules: Sequence[str] = (),
    wall_limit_s: float | None = None,
) -> Flight:
    """Fly a session in a folder of this name; one that takes longer than `wall_limit_s` is ended.

    Raises SpawnError where a fork server has died or the folder cannot be made.
    """
    sessions.wait_ready()
    folder, began_s, limited = sessions.folder / name, time.monotonic(), False
    try:
        (folder / "vehicles").mkdir(parents=True)
    except OSError as error:
        raise SpawnError(f"cannot make the folder {folder}: {error.strerror}") from None
    with sessions.start(scenario, folder, modules=modules, log=folder / OUTPUT) as process:
        try:
            process.wait(wall_limit_s)
        except subprocess.TimeoutExpired:
            limited = True
            process.stdin.close()
            end(process, ENDS_WITHIN_S)
        last_word = next((line for line in process.stdout if line.startswith(b'{"exit"')), None)
    supervisor, vehicles = process.ended, sessions.vehicles_ended()
    if supervisor is None:
        raise SpawnError("a process that forks sessions has died while one flew")
    wall_s, cpu_s = time.monotonic() - began_s, supervisor.cpu_s + vehicles.cpu_s
    verdict = {} if last_word is None else json.loads(last_word)
    why = verdict.get("error")
    if limited:
        why = f"it took longer than {wall_limit_s:g} s of wall time and was ended"
    elif last_word is None:
        why = f"the supervisor {supervisor.how()} before the session's end"
    return Flight(folder, scenario, verdict.get("outcome") or "", why, wall_s, cpu_s)
