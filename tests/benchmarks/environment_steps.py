"""Figure 16: steps a second of `gcs.parallel_env`, beside those of the session that it steps."""

from __future__ import annotations

import contextlib
import statistics
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
from measure import Figure

import gcs
from gcs.scenario.document import Document
from gcs.scenario.file import resolve

VEHICLES, PER_PROCESS, ROUNDS, STEPS = 25, 25, 3, 300
GOAL_RATIO = 0.5
"""An environment may take as long as the session below it, for observations, rewards and set points."""


def hovering(vehicles: int) -> gcs.Scenario:
    """This many vehicles in the air, 3 m apart, for an hour, in one process for each 25 of them."""
    pursuers = [
        {"sysid": k + 1, "start_m": [3.0 * (k % 5), 3.0 * (k // 5), -5.0], "airborne": True} for k in range(vehicles)
    ]
    content: dict[str, Any] = {
        "schema": 1,
        "name": "hovering",
        "axes": "ned",
        "origin": {"lat_deg": 47.4, "lon_deg": 8.5, "alt_m": 488.0},
        "goal": {"duration_s": 3600.0},
        "vehicles": {"defaults": {"battery": {"capacity_j": 10_000_000}}, "pursuers": pursuers},
        "vehicles_per_process": PER_PROCESS,
    }
    return resolve(Document("hovering.yaml", content), {})


def figures() -> list[Figure]:
    """Environment and session in turn."""
    rates: dict[str, list[float]] = {"environment": [], "session": []}
    for _ in range(ROUNDS):
        rates["environment"].append(_environment())
        rates["session"].append(_session())
    of_environment, of_session = (statistics.median(rates[kind]) for kind in ("environment", "session"))
    return [
        Figure(
            16, f"steps of an environment with {VEHICLES} agents", of_environment, "1/s", GOAL_RATIO,
            peer="steps of gcs.Session, set points to all", peer_value=of_session, goal_is_ratio=True,
        )
    ]  # fmt: skip


def _environment() -> float:
    with contextlib.closing(gcs.parallel_env(hovering(VEHICLES))) as env:
        env.reset(seed=1)
        still = dict.fromkeys(env.agents, np.zeros(3, np.float32))
        begun_s = time.perf_counter()
        for _ in range(STEPS):
            env.step(still)
        return STEPS / (time.perf_counter() - begun_s)


def _session() -> float:
    with (
        tempfile.TemporaryDirectory() as folder,
        gcs.Session(hovering(VEHICLES), lockstep=True, out=Path(folder) / "session") as session,
    ):
        snapshot = session.step()
        set_points = np.zeros((VEHICLES, 2, 3))
        set_points[:, 0] = snapshot.p_ned
        points = dict(zip(snapshot.sysid.tolist(), set_points, strict=True))
        begun_s = time.perf_counter()
        for _ in range(STEPS):
            session.step(points)
        return STEPS / (time.perf_counter() - begun_s)
