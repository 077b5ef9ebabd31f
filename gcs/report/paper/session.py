"""A recorded session as arrays: each vehicle's set points, its truth, its telemetry. Paper axes (x, y, z up)."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from gcs.recording import tlog_reader, truth
from gcs.recording.decisions_reader import DecisionLines
from gcs.recording.recorder import DECISIONS, TLOG
from gcs.recording.series import Floats
from gcs.scenario.model import Scenario

NED_TO_PAPER = np.array([1.0, -1.0, -1.0])
EFFORT = b"CtlEffort"
_KNOWN = (*truth.MOTION, "roll", "pitch", "yaw")


@dataclass(frozen=True)
class RecordedFlight:
    """One vehicle's session; k records of its own knowledge, j set points, r reports of control effort.

    time_s (k,), p (k, 3) m, v (k, 3) m/s and attitude (k, 3) rad (φ, θ, ψ) are what the vehicle itself knows.
    plan_time_s (j,), plan_p (j, 3), plan_v (j, 3) are the recorded set points; each velocity is reached one `period_s`
    after it was sent. effort_time_s (r,), effort (r,) are the control efforts that it reported over MAVLink.
    """

    sysid: int
    period_s: float
    time_s: Floats
    p: Floats
    v: Floats
    attitude: Floats
    plan_time_s: Floats
    plan_p: Floats
    plan_v: Floats
    effort_time_s: Floats
    effort: Floats

    def reference(self) -> tuple[Floats, Floats]:
        """v_d (k, 3) m/s and v_d' (k, 3) m/s² at `time_s`: linear between the set points' velocities
        (docs/model/control.md#guidance).

        Before the first set point the vehicle flies on its own initial velocity.
        """
        reached_s = np.concatenate(([self.plan_time_s[0]], self.plan_time_s + self.period_s))
        velocity = np.concatenate((self.v[:1], self.plan_v))
        slope = np.diff(velocity, axis=0) / np.diff(reached_s)[:, np.newaxis]
        leg = np.clip(np.searchsorted(reached_s, self.time_s - 1e-6) - 1, -1, len(slope) - 1)
        v_d = np.column_stack([np.interp(self.time_s, reached_s, velocity[:, axis]) for axis in range(3)])
        return v_d, np.where(((leg >= 0) & (self.time_s <= reached_s[-1] + 1e-6))[:, np.newaxis], slope[leg], 0.0)

    @property
    def arrived_s(self) -> float:
        """When the planned point came to rest for good: the time of its first set point of the last, constant kind."""
        changes = np.flatnonzero((self.plan_v != self.plan_v[-1]).any(axis=1))
        return float(self.plan_time_s[changes[-1] + 1] if changes.size else self.plan_time_s[0])

    @property
    def constant_from_s(self) -> float:
        """When the vehicle's reference became constant for good."""
        return self.arrived_s + self.period_s

    def effort_at(self, time_s: float | Floats) -> Floats:
        """Reported control effort, linear between the reports and from 0 at the start."""
        at = np.concatenate(([0.0], self.effort_time_s))
        return np.asarray(np.interp(time_s, at, np.concatenate(([0.0], self.effort))))


def flights_of(scenario: Scenario, folder: Path) -> list[RecordedFlight]:
    """The pursuers' flights, in order of system id. Raises OSError, ValueError where the recording lacks one."""
    return read(folder, [p.sysid for p in scenario.vehicles.pursuers], scenario.clock.period_s)


def world(scenario: Scenario) -> tuple[Floats, Floats, Floats]:
    """Obstacle points (m, 3), way point and end (3,), paper axes."""
    course = np.array(scenario.vehicles.pursuers[0].waypoints_m) * NED_TO_PAPER
    obstacles = np.array([obstacle.low_m for obstacle in scenario.obstacles]) * NED_TO_PAPER
    return obstacles, course[0], course[-1]


def read(folder: Path, sysids: list[int], period_s: float) -> list[RecordedFlight]:
    """The flights of these vehicles in a session's folder. Raises OSError, ValueError where the recording lacks one."""
    plans: dict[int, list[list[float]]] = {sysid: [] for sysid in sysids}
    for decision in decisions(folder):
        if decision["kind"] == "set_point" and decision["sysid"] in plans:
            plans[decision["sysid"]].append([decision["t_s"], *decision["p_ned"], *decision["v_ned"]])
    efforts: dict[int, list[tuple[float, float]]] = {sysid: [] for sysid in sysids}
    for chunk in tlog_reader.read(folder / TLOG, session=True).chunks():
        reports = chunk.table("NAMED_VALUE_FLOAT")
        for report in reports[reports["name"] == EFFORT]:
            if report["sysid"] in efforts:
                efforts[int(report["sysid"])].append((int(report["time_boot_ms"]) / 1e3, float(report["value"])))
    flights = []
    for sysid in sysids:
        flown = truth.read(folder, sysid, _KNOWN)
        if not plans[sysid] or not efforts[sysid] or flown is None:
            raise ValueError(f"{folder}: vehicle {sysid} received or reported nothing; fly the session again")
        plan, effort = np.array(plans[sysid]), np.array(efforts[sysid])
        flights.append(
            RecordedFlight(
                sysid=sysid,
                period_s=period_s,
                time_s=flown[:, 0],
                p=flown[:, 1:4] * NED_TO_PAPER,
                v=flown[:, 4:7] * NED_TO_PAPER,
                attitude=flown[:, 7:10] * NED_TO_PAPER,
                plan_time_s=plan[:, 0],
                plan_p=plan[:, 1:4] * NED_TO_PAPER,
                plan_v=plan[:, 4:7] * NED_TO_PAPER,
                effort_time_s=effort[:, 0],
                effort=effort[:, 1],
            )
        )
    return flights


def decisions(folder: Path) -> Iterator[dict[str, Any]]:
    """Each recorded decision. Raises OSError."""
    return iter(DecisionLines(folder / DECISIONS))


def summary(folder: Path) -> dict[str, Any]:
    """The session's summary.json. Raises OSError."""
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))
