"""Spawned sessions: the digest of a session of its own, whatever died before it, and nothing left behind."""

from __future__ import annotations

import json
import threading
import time
from pathlib import Path

import psutil
from patience import PATIENCE_S

import gcs
from gcs.campaign.spawner import Flight, SessionSpawner
from gcs.scenario.file import find, load
from gcs.scenario.model import Scenario


def example(duration_s: float) -> Scenario:
    return load(find("paper/example1"), set={"goal.duration_s": duration_s}).flown(lockstep=True)


def digest(folder: Path) -> str:
    return str(json.loads((folder / "summary.json").read_text(encoding="utf-8"))["digest"])


def title(process: psutil.Process) -> str:
    try:
        return " ".join(process.cmdline()).strip()
    except psutil.NoSuchProcess:
        return ""


def processes(sessions: SessionSpawner) -> list[psutil.Process]:
    """The fork servers and all that they have forked."""
    servers = [psutil.Process(pid) for pid in sessions.pids]
    return [*servers, *(child for server in servers for child in server.children(recursive=True))]


def supervisor(sessions: SessionSpawner) -> psutil.Process:
    """The supervisor that flies, once its vehicles are there."""
    deadline_s = time.monotonic() + PATIENCE_S
    while time.monotonic() < deadline_s:
        named = {title(child): child for child in processes(sessions)}
        if "gcs session" in named and "simvehicle 5" in named:
            return named["gcs session"]
    raise AssertionError("no supervisor came up")


def test_a_spawned_session_is_that_of_a_session_of_its_own_also_after_a_supervisor_was_killed(tmp_path: Path) -> None:
    with gcs.Session(example(4.0), out=tmp_path / "alone") as alone:
        alone.finish()
    ended: list[Flight] = []
    with SessionSpawner() as sessions:
        first = sessions.fly(example(4.0), "first")
        flying = threading.Thread(target=lambda: ended.append(sessions.fly(example(80_000.0), "killed")))
        flying.start()
        supervisor(sessions).kill()
        flying.join()
        assert ended[0].error == "the supervisor was killed by signal 9 before the session's end"
        second = sessions.fly(example(4.0), "second")
        limited = sessions.fly(example(80_000.0), "limited", wall_limit_s=1.0)
        third = sessions.fly(example(4.0), "third")
        assert limited.error == "it took longer than 1 s of wall time and was ended"
        assert [flight.error for flight in (first, second, third)] == [None] * 3
        assert {digest(flight.folder) for flight in (first, second, third)} == {digest(tmp_path / "alone")}
        assert first.cpu_s > 0.0
        folder, started = first.folder.parent, processes(sessions)
        first.complete()
        assert load(first.folder / "scenario.yaml") == example(4.0)
    assert not folder.exists()
    assert not [process for process in started if process.is_running()]
