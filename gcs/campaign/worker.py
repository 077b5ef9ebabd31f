"""One row of a campaign, flown from this process's session spawner (gcs/session/spawning), on a campaign's workers.

A worker thread keeps its spawner from row to row. Whatever goes wrong with a session becomes its row's error.
"""

from __future__ import annotations

import atexit
import io
import tarfile
import threading
import time
from pathlib import Path
from typing import Any

from gcs.campaign import measures
from gcs.campaign.flight import Flight, fly
from gcs.campaign.plan import Plan, PlannedRow, RowError
from gcs.scenario.model import Scenario
from gcs.session.spawning.spawner import SessionSpawner, SpawnError

ATTEMPTS = 4
"""Number of times that a row is flown whose spawner dies."""
_here = threading.local()
_all: list[SessionSpawner] = []
_lock = threading.Lock()


def fly_row(plan: Plan, row: PlannedRow) -> dict[str, Any]:
    """Fly a row of a plan; the row as the table has it, and `folder`, the session's as a tar, if it is kept."""
    began_s, cpu_s = time.monotonic(), time.thread_time()
    try:
        scenario, values = plan.resolved(row)
    except RowError as error:
        return failed(plan, row, str(error))
    try:
        flight = _flown(scenario, f"row-{row.number}", plan)
    except SpawnError as error:
        return {**failed(plan, row, str(error)), **values}
    try:
        # Where a session was broken off is no finding of it: the next flight would end elsewhere.
        digest, measured, why = None, dict.fromkeys(plan.campaign.measured), flight.error
        if not why:
            try:
                flown = measures.Flown(flight.folder, scenario)
                digest = flown.summary["digest"]
                measured = {name: measures.measure(name, flown) for name in plan.campaign.measured}
            except (OSError, ValueError, KeyError):
                why = "the session left no summary"
        fault = None if why else _fault(plan, measured)
        row_done = {**_head(row), **values, **measured, "fault": fault, "error": why, "ok": not fault and not why}
        row_done["digest"] = digest
        row_done["kept"] = plan.campaign.keep == "all" or (plan.campaign.keep == "failed" and not row_done["ok"])
        if row_done["kept"]:
            flight.complete()
            row_done["folder"] = _packed(flight.folder)
    finally:
        flight.discard()
    row_done["wall_s"] = time.monotonic() - began_s
    row_done["cpu_s"] = flight.cpu_s + time.thread_time() - cpu_s
    return row_done


def failed(plan: Plan, row: PlannedRow, why: str) -> dict[str, Any]:
    """The row of a session that could not be flown."""
    return {
        **_head(row),
        **row.values,
        **dict.fromkeys(plan.campaign.measured),
        "ok": False,
        "error": why,
        "wall_s": 0.0,
        "cpu_s": 0.0,
        "kept": False,
    }


def _head(row: PlannedRow) -> dict[str, int]:
    return {"row": row.number, "session": row.session, "combination": row.combination, "seed": row.seed}


def close() -> None:
    """End every spawner of this process."""
    with _lock:
        for sessions in _all:
            sessions.close()
        _all.clear()


def _flown(scenario: Scenario, name: str, plan: Plan) -> Flight:
    """A flight; a spawner that has died is replaced, ATTEMPTS - 1 times."""
    for attempt in range(1, ATTEMPTS + 1):
        try:
            limit_s = plan.campaign.limits.wall_s
            return fly(_sessions(), scenario, f"{name}-{attempt}", modules=plan.modules, wall_limit_s=limit_s)
        except SpawnError:
            _drop()
            if attempt == ATTEMPTS:
                raise
    raise AssertionError("unreachable")


def _sessions() -> SessionSpawner:
    sessions: SessionSpawner | None = getattr(_here, "sessions", None)
    if sessions is None or not sessions.alive:
        if sessions is not None:
            _drop()
        sessions = _here.sessions = SessionSpawner()
        with _lock:
            if not _all:
                atexit.register(close)
            _all.append(sessions)
    return sessions


def _drop() -> None:
    sessions: SessionSpawner = _here.sessions
    with _lock:
        if sessions in _all:
            _all.remove(sessions)
    _here.sessions = None
    sessions.close()


def _fault(plan: Plan, measured: dict[str, Any]) -> str | None:
    expected = plan.campaign.expect
    faults = [fault for name, limits in expected.items() if (fault := limits.fault(name, measured.get(name)))]
    if not expected and measured.get("outcome", "met") != "met":
        faults.append(f"the goal was not met: {measured['outcome']}")
    return "; ".join(faults) or None


def _packed(folder: Path) -> bytes:
    """A session's folder as a tar; what is no file, such as a socket, is left out."""
    content = io.BytesIO()
    with tarfile.open(fileobj=content, mode="w:gz", compresslevel=1) as tar:
        for path in sorted(folder.rglob("*")):
            if path.is_file():
                tar.add(path, path.relative_to(folder).as_posix())
    return content.getvalue()


def unpack(content: bytes, folder: Path) -> None:
    """Write a packed session into a folder; raises OSError."""
    folder.mkdir(parents=True, exist_ok=True)
    with tarfile.open(fileobj=io.BytesIO(content)) as tar:
        tar.extractall(folder, filter="data")
