"""What a session amounts to, for a reader: its series, its services, its ledgers; and in words what came of the goal
and what went wrong, the worst first."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np

from gcs.recording import series
from gcs.recording.series import Series, Track, VehicleInfo
from gcs.recording.session_folder import Recorded
from gcs.report import distances
from gcs.report.junit import cases
from gcs.scenario.model import Scenario

Level = Literal["bad", "warn", "note"]
FEW = 8
CRITICAL, WARNING = 3, 4
"""MAV_SEVERITY: ERROR and worse; WARNING."""


@dataclass(frozen=True)
class SessionProblem:
    """Something that went wrong, in a sentence."""

    level: Level
    text: str


@dataclass(frozen=True)
class GoalPart:
    """One part of the goal; `met` None: not known."""

    wanted: str
    reached: str
    met: bool | None


@dataclass(frozen=True)
class ServiceFinding:
    """One refuelling, with why it ended."""

    receiver: int
    tanker: int | None
    base: str | None
    by: str
    decided_at_s: float
    joined_at_s: float | None
    start_s: float | None
    end_s: float | None
    energy_j: float
    bids: Mapping[str, float]
    reason: str

    @property
    def giver(self) -> str:
        """Who gives, for a person."""
        return f"base {self.base}" if self.tanker is None else f"tanker {self.tanker}"


class Findings:
    """Everything that the page tells, from what was recorded."""

    def __init__(self, recorded: Recorded) -> None:
        self.recorded = recorded
        self.scenario: Scenario | None = recorded.scenario
        self.summary = recorded.summary
        self.end_s = recorded.end_s
        self.vehicles: list[VehicleInfo] = series.vehicles(recorded)
        self.tracks: dict[int, Track] = series.tracks(recorded)
        self.traffic: dict[str, Track] = series.traffic(recorded)
        self.attitudes = series.attitudes(recorded)
        self.batteries = series.batteries(recorded)
        self.contest = series.contest(recorded)
        self.base_contest = series.contest(recorded, for_bases=True)
        self.links = series.links(recorded, self.tracks)
        self.nearness = distances.measure(recorded, self.tracks, self.traffic)
        self.errors = distances.tracking_errors(recorded, self.tracks)
        self.texts = series.texts(recorded)
        lost = sorted(set(series.heard(recorded)) - self.tracks.keys())
        if lost:
            where = f"The paths of {few(lost)} are not known: it was never told where their frame's zero lies."
            recorded.problems.append(where)

    @cached_property
    def speeds(self) -> dict[int, Series]:
        """m/s"""
        return {s: series.with_gaps(Series(t.t_s, np.linalg.norm(t.v_ned, axis=1))) for s, t in self.tracks.items()}

    @cached_property
    def heights(self) -> dict[int, Series]:
        """m above the scenario's origin"""
        return {s: series.with_gaps(Series(t.t_s, 0.0 - t.p_ned[:, 2])) for s, t in self.tracks.items()}

    @cached_property
    def battery_percent(self) -> dict[int, Series]:
        """% of the capacity"""
        return {
            s: Series(b.remaining.t_s, 100.0 * b.remaining.values / b.capacity_j) for s, b in self.batteries.items()
        }

    @property
    def rates(self) -> dict[int, Series]:
        """1/s"""
        return {sysid: link.rate_hz for sysid, link in self.links.items()}

    @property
    def losses(self) -> dict[int, Series]:
        """frames"""
        return {sysid: link.lost for sysid, link in self.links.items()}

    @cached_property
    def services(self) -> list[ServiceFinding]:
        """Each refuelling in the order of decision: by the decisions, else by the summary."""
        found: list[ServiceFinding] = []
        for decision in self.recorded.decisions:
            if decision["kind"] == "served":
                told: dict[str, Any] = {"base": None, **decision}
                found.append(ServiceFinding(**{key: told[key] for key in ServiceFinding.__dataclass_fields__}))
        ended = {(s.receiver, s.tanker, s.decided_at_s) for s in found}
        if self.summary is not None:
            found += [
                ServiceFinding(**s.model_dump(), reason="not ended")
                for s in self.summary.refuelling
                if (s.receiver, s.tanker, s.decided_at_s) not in ended
            ]
        elif self.recorded.decisions:
            for d in self.recorded.decisions:
                if d["kind"] == "decided" and (d["receiver"], d["tanker"], d["t_s"]) not in ended:
                    pair = d["receiver"], d["tanker"], d.get("base"), d["by"], d["t_s"]
                    found.append(ServiceFinding(*pair, None, None, None, 0.0, d["bids"], "not ended"))
        return sorted(found, key=lambda service: service.decided_at_s)

    @cached_property
    def ledgers(self) -> list[dict[str, Any]]:
        """Each vehicle's energies in J, by the summary."""
        if self.summary is None:
            return []
        return [{"id": v.sysid, **v.energy.model_dump(exclude={"source"})} for v in self.summary.vehicles]

    # the goal

    @cached_property
    def parts(self) -> list[GoalPart]:
        """The goal, part by part, and what was reached."""
        if self.scenario is None:
            return []
        return [GoalPart(name, *self._reached(key)) for key, name in cases(self.scenario.goal)]

    def _reached(self, key: str) -> tuple[str, bool | None]:
        goal, summary = self.scenario.goal if self.scenario else None, self.summary
        assert goal is not None
        if key == "vehicle_lost":
            if summary is None:
                return "not known", None
            dead = [v.sysid for v in summary.vehicles if v.final_mode == "dead"]
            return (f"lost: {few(dead)}" if dead else "none was lost"), not dead
        if key == "duration_s":
            return f"{self.end_s:.1f} s", self.end_s >= goal.duration_s - 1e-6
        if key == "pursue" and goal.pursue is not None:
            held = self.nearness.held_s
            if not held or not self.tracks:
                return "not known", None
            if self.scenario is not None and self.scenario.pursuit.by == "competition":
                # One pursuer each is chosen for the targets: the summary judges them, and the pursuers tell little.
                met = None if summary is None else summary.outcome != "pursue"
                return "by the chosen pursuers", met
            worst = min(held, key=lambda sysid: (held[sysid], sysid))
            return f"{held[worst]:.1f} s by the worst, vehicle {worst}", held[worst] >= goal.pursue.for_s - 1e-6
        done = len(summary.refuel_order) if summary else sum(s.energy_j > 0 for s in self.services)
        return f"{done} refuelled", done >= goal.refuelled_at_least

    @property
    def outcome(self) -> str:
        """The headline, a few words."""
        if self.summary is None:
            return "No outcome is known"
        words = {
            "met": "The goal was met",
            "vehicle_lost": "A vehicle was lost",
            "interrupted": "The session was interrupted",
            "duration_s": "The session ended early",
            "pursue": "The targets were not pursued long enough",
            "refuelled_at_least": "Too few were refuelled",
        }
        return words.get(self.summary.outcome, f"The goal was not met: {self.summary.outcome}")

    # what went wrong

    @cached_property
    def problems(self) -> list[SessionProblem]:
        """What went wrong in flight, the worst first."""
        order: dict[Level, int] = {"bad": 0, "warn": 1, "note": 2}
        return sorted(self._problems(), key=lambda problem: order[problem.level])

    def _problems(self) -> Iterator[SessionProblem]:
        for part in self.parts:
            if part.met is False:
                yield SessionProblem("bad", f"Not reached: {part.wanted} ({part.reached}).")
        yield from self._said()
        yield from self._too_near()
        yield from self._services_cut_short()
        failed: dict[str, list[dict[str, Any]]] = {}
        for decision in self.recorded.decisions:
            if decision["kind"] == "policy failed":
                failed.setdefault(f"{decision['policy']} {decision['problem']}", []).append(decision)
            elif decision["kind"] == "unable":
                yield SessionProblem(
                    "note", f"Vehicle {decision['receiver']} takes no energy in the air: {decision['reason']}."
                )
            elif decision["kind"] == "death":
                yield SessionProblem("bad", f"{decision['text']} ({decision['t_s']:.1f} s)")
        for what, times in failed.items():
            yield SessionProblem("warn", f"{what} ({_times(len(times), times[0]['t_s'])}).")
        yield from self._of_the_link()

    def _said(self) -> Iterator[SessionProblem]:
        """What vehicles said of themselves, alike said once."""
        alike: dict[tuple[str, int], list[tuple[float, int]]] = {}
        for t_s, sysid, severity, text in self.texts:
            alike.setdefault((text, severity), []).append((t_s, sysid))
        for (text, severity), said in alike.items():
            who = sorted({sysid for _, sysid in said})
            level: Level = "bad" if severity <= CRITICAL else "warn"
            plural = "vehicle" if len(who) == 1 else f"{len(who)} vehicles:"
            yield SessionProblem(level, f"“{text}” said by {plural} {few(who)} ({_times(len(said), said[0][0])}).")

    def _too_near(self) -> Iterator[SessionProblem]:
        separation, clearance = self.nearness.separation, self.nearness.clearance
        wanted_m = self.scenario.planner.separation_m if self.scenario else 0.0
        if np.isfinite(separation.values).any():
            k = int(np.nanargmin(separation.values))
            least_m = float(separation.values[k])
            if least_m < wanted_m:
                a, b = sorted(self.nearness.pair[k].tolist())
                what = f"Vehicles {a} and {b} came within {least_m:.2f} m of each other at {separation.t_s[k]:.1f} s"
                yield SessionProblem("bad", f"{what}; {wanted_m:g} m were wanted.")
        if np.isfinite(clearance.values).any():
            k = int(np.nanargmin(clearance.values))
            if clearance.values[k] <= 0.0:
                hit = f"Vehicle {self.nearness.nearest[k]} was inside an obstacle at {clearance.t_s[k]:.1f} s"
                yield SessionProblem("bad", f"{hit}, {-float(clearance.values[k]):.2f} m deep.")

    def _services_cut_short(self) -> Iterator[SessionProblem]:
        broken = [d for d in self.recorded.decisions if d["kind"] == "broken off"]
        if broken:
            who = sorted({d["receiver"] for d in broken})
            yield SessionProblem(
                "warn", f"Transfers to {few(who)} were broken off ({_times(len(broken), broken[0]['t_s'])})."
            )
        for s in self.services:
            if s.energy_j <= 0 and s.reason != "not ended":
                when = f"decided at {s.decided_at_s:.1f} s"
                yield SessionProblem(
                    "warn", f"Refuelling of {s.receiver} by {s.giver} moved no energy: {s.reason} ({when})."
                )
        lost = {row["id"]: row["lost_j"] for row in self.ledgers if row["lost_j"] > 0}
        if lost:
            yield SessionProblem(
                "warn", f"{sum(lost.values()):.0f} J given by {few(sorted(lost))} were never credited."
            )

    def _of_the_link(self) -> Iterator[SessionProblem]:
        if self.summary is None:
            return
        link = self.summary.link
        counts: tuple[tuple[int, str, Level], ...] = (
            (link.lost, "frames were lost", "warn"),
            (link.malformed, "datagrams held bytes that were no frame", "warn"),
            (link.overflowed, "datagrams were dropped by the system: its buffers are too small", "warn"),
            (link.command_retries, "commands had to be sent again", "note"),
        )
        for count, what, level in counts:
            if count:
                yield SessionProblem(level, f"{count} {what}.")
        if self.summary.lag_s >= 0.1:
            yield SessionProblem(
                "warn", f"The session fell {self.summary.lag_s:.1f} s behind its pace: the machine was busy."
            )
        for vehicle in self.summary.vehicles:
            if vehicle.missing_streams:
                what = " and ".join(vehicle.missing_streams)
                yield SessionProblem(
                    "warn", f"Vehicle {vehicle.sysid} did not send {what} as often as it was asked to."
                )

    def greatest(self, lines: Mapping[int, Series]) -> tuple[float, int] | None:
        """The greatest value of any line, and whose."""
        known = {s: float(np.nanmax(line.values)) for s, line in lines.items() if np.isfinite(line.values).any()}
        if not known:
            return None
        whose = max(known, key=lambda s: known[s])
        return known[whose], whose

    def least(self, line: Series) -> tuple[float, float] | None:
        """The least value of a line, and when."""
        if not np.isfinite(line.values).any():
            return None
        k = int(np.nanargmin(line.values))
        return float(line.values[k]), float(line.t_s[k])


def few(sysids: list[int]) -> str:
    """Ids for a sentence; of many the first."""
    if len(sysids) <= FEW:
        return ", ".join(map(str, sysids))
    return f"{', '.join(map(str, sysids[: FEW - 2]))} and {len(sysids) - FEW + 2} more"


def _times(count: int, first_s: float) -> str:
    return f"at {first_s:.1f} s" if count == 1 else f"{count} times, first at {first_s:.1f} s"


def finite(value: float | None) -> float | None:
    """The value, None where there is none."""
    return value if value is not None and math.isfinite(value) else None
