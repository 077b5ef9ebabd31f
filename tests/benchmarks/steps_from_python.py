"""Figure 15: steps a second of a session that a program in Python steers, beside the same session by `gcs run`."""

from __future__ import annotations

import statistics
import tempfile
import time
from pathlib import Path

import numpy as np
import sessions_timed
import yaml
from measure import Figure, Scale

import gcs

VEHICLES, PER_PROCESS = 50, 25
SESSIONS = 3
UP_S, DURATION_S = 15.0, 45.0
"""All vehicles are in the air by the first; steps count from there to the end."""
PERIOD_S = 0.1
GOAL_STEPS_S = 200.0


def figures(scale: Scale) -> list[Figure]:
    """Watched and steered sessions, and `gcs run`, in turn."""
    rates: dict[str, list[float]] = {"run": [], "watched": [], "steered": []}
    content = sessions_timed.example_1(VEHICLES, DURATION_S, PER_PROCESS)
    for _ in range(SESSIONS):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            rates["run"].append(sessions_timed.fly(content, folder)[0] / PERIOD_S)
            path = folder / "scenario.yaml"
            path.write_text(yaml.safe_dump(content), encoding="utf-8")
            for kind in ("watched", "steered"):
                rates[kind].append(_steps_s(path, folder / kind, steers=kind == "steered"))
    run, watched, steered = (statistics.median(rates[kind]) for kind in ("run", "watched", "steered"))
    what, goal = f"steps of {VEHICLES} vehicles from Python", GOAL_STEPS_S * scale.wall
    peer = "ticks of gcs run"
    return [
        Figure(15, f"{what}, set points to all", steered, "1/s", goal, peer=peer, peer_value=run),
        Figure(15, "  without acting", watched, "1/s", goal, peer=peer, peer_value=run),
    ]


def _steps_s(path: Path, out: Path, *, steers: bool) -> float:
    """Steps per second of wall time, vehicles in flight: every vehicle is to be 0.1 m north of where it is."""
    with gcs.Session(path, lockstep=True, out=out) as session:
        snapshot = session.step()
        while snapshot.time_s < UP_S:
            snapshot = session.step()
        set_points, ahead_ned = np.zeros((VEHICLES, 2, 3)), np.array([PERIOD_S, 0.0, 0.0])
        steps, begun_s = 0, time.perf_counter()
        while snapshot.time_s < DURATION_S - PERIOD_S:
            set_points[:, 0] = snapshot.p_ned + ahead_ned
            snapshot = session.step(dict(zip(snapshot.sysid.tolist(), set_points, strict=True)) if steers else None)
            steps += 1
        return steps / (time.perf_counter() - begun_s)
