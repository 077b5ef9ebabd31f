"""Findings of a session, for a reader: its series, its services, its ledgers; and in words what came of the goal
and what went wrong, the worst first."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np

from gcs.recording import series
from gcs.recording.missing import NO_REASON
from gcs.recording.series import Series, Track, VehicleInfo
from gcs.recording.session_folder import Recorded
from gcs.recording.summary import Nearness
from gcs.report import distances
from gcs.report.watched import Watched
from gcs.scenario import goal
from gcs.scenario.goal import Judgement, Measured, Nearest
from gcs.scenario.guard import PluginFault
from gcs.scenario.model import Scenario
from gcs.session.message_types import ServedRow
from gcs.telemetry.changes import NO_TELEMETRY
from gcs.telemetry.state import STALE_S
from gcs.telemetry.voltage_watch import VoltageWatches

Level = Literal["bad", "warn", "note"]
FEW = 8
CRITICAL = 3
"""MAV_SEVERITY: ERROR and worse."""


@dataclass(frozen=True)
class SessionProblem:
    """Something that went wrong, in a sentence."""

    level: Level
    text: str


NOT_ENDED = "not ended"
"""Why a service ended that was under way when the session did."""


class ServiceFinding(ServedRow):
    """One refuelling, with why it ended."""

    bids: Mapping[str, float]

    @property
    def giver(self) -> str:
        """Giver, for a person."""
        return f"base {self.base}" if self.tanker is None else f"tanker {self.tanker}"


class Findings:
    """Everything that the page shows, from the recording."""

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
        self.competition = series.competition(recorded)
        self.base_competition = series.competition(recorded, for_bases=True)
        self.links = series.links(recorded, self.tracks)
        self.nearness = distances.measure(recorded, self.tracks, self.traffic)
        self.errors = distances.tracking_errors(recorded, self.tracks)
        self.texts = series.texts(recorded)
        lost = sorted(set(series.senders(recorded)) - self.tracks.keys())
        if lost:
            where = f"The paths of {few(lost)} are not known: their frame's origin was never reported."
            recorded.problems.append(where)

    @cached_property
    def watched(self) -> Watched:
        """Link events and health, as a replay shows them."""
        return Watched(self.recorded)

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

    @cached_property
    def greatest_errors(self) -> dict[int, float]:
        """m, of each vehicle whose tracking error is known: by the summary, which has the whole flight, else by what
        was recorded."""
        shown = {s: line.values for s, line in self.errors.items() if np.isfinite(line.values).any()}
        reported = {v.sysid: v.max_tracking_error_m for v in self.summary.vehicles} if self.summary is not None else {}
        found = {s: reported.get(s) for s in shown}
        return {s: float(np.nanmax(shown[s])) if error is None else error for s, error in found.items()}

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
        for _, served in self.recorded.services:
            if served is not None:
                reported: dict[str, Any] = {"base": None, **served}
                found.append(ServiceFinding(**{key: reported[key] for key in ServiceFinding.__struct_fields__}))
        if self.summary is not None:
            ended = {(s.receiver, s.tanker, s.decided_at_s) for s in found}
            found += [
                ServiceFinding(**s.model_dump(), reason=NOT_ENDED if s.end_s is None else NO_REASON)
                for s in self.summary.refuelling
                if (s.receiver, s.tanker, s.decided_at_s) not in ended
            ]
        else:
            for d, served in self.recorded.services:
                if d is not None and served is None:
                    pair = d["receiver"], d["tanker"], d.get("base"), d["by"], d["t_s"]
                    found.append(ServiceFinding(*pair, None, None, None, 0.0, NOT_ENDED, d["bids"]))
        return sorted(found, key=lambda service: service.decided_at_s)

    @property
    def refuelled(self) -> int:
        """How many services count as refuellings: by the summary, which has joules that were reported late."""
        if self.summary is not None:
            return len(self.summary.refuel_order)
        return sum(goal.is_refuelling(s.end_s, s.energy_j) for s in self.services)

    @cached_property
    def ledgers(self) -> list[dict[str, Any]]:
        """Each vehicle's energies in J, by the summary."""
        if self.summary is None:
            return []
        return [{"id": v.sysid, **v.energy.model_dump(exclude={"source"})} for v in self.summary.vehicles]

    # the goal

    @property
    def judged(self) -> Scenario | None:
        """Scenario by which the goal was judged: an obstacle may have been added in flight."""
        worlds = self.recorded.worlds
        return None if worlds is None else worlds.judged

    @cached_property
    def parts(self) -> list[Judgement]:
        """The goal, part by part, and what was reached: as the session judged it, or, where it left no summary, as far
        as its recording shows."""
        if self.judged is None:
            return []
        reported = {part.part: part for part in self.summary.goal} if self.summary is not None else {}
        return [
            replace(one, wanted=part.wanted, reached=part.reached, met=part.met)
            if (part := reported.get(one.part))
            else one
            for one in goal.judge(self.judged, self._measured())
        ]

    def _measured(self) -> Measured:
        """Figures from the recording alone."""
        near = self.nearness
        held = near.held_s if self.scenario is not None and self.scenario.pursuit.by != "competition" else {}
        return Measured(
            time_s=self.end_s,
            separation=self._closest(near.separation, near.pair) if self.tracks else None,
            lost=self._losses() or None,
            pursuit_held_s=min(held.values()) if held and self.tracks else None,
            refuelled=self.refuelled,
            late=self._late(),
        )

    def _late(self) -> list[tuple[float, str]]:
        """Answers of planners and policies that did not come."""
        failed = [d for d in self.recorded.decisions if d["kind"] == "policy failed"]
        faults = [(d["t_s"], PluginFault(int(d["sysid"]), d["policy"], d["problem"])) for d in failed]
        return [(t_s, f"{fault.policy} {fault.problem}") for t_s, fault in faults if fault.is_late]

    def _losses(self) -> list[goal.Loss]:
        """Vehicles that the session counted as lost while it flew."""
        found, died = {}, {}
        for d in self.recorded.decisions:
            if d["kind"] == "death":
                died[int(d["sysid"])] = goal.Loss(int(d["sysid"]), d["t_s"], "its process died")
            elif d["kind"] == "violation" and d["part"] == "lost" and d["sysids"]:
                found[d["sysids"][0]] = goal.Loss(d["sysids"][0], d["at_s"], d["text"].partition(" is lost: ")[2])
        return list((found | died).values())

    def _closest(self, line: Series, pair: Any) -> Nearest:
        """Nearest approach by the recording."""
        if not np.isfinite(line.values).any():
            return Nearest()
        k = int(np.nanargmin(line.values))
        return Nearest(float(line.values[k]), tuple(sorted(np.atleast_1d(pair[k]).tolist())), float(line.t_s[k]))

    def closest(self, name: Nearness) -> Nearest | None:
        """Nearest approach as judged; None where that is not known."""
        reported = self.summary.closest.get(name) if self.summary is not None else None
        if reported is None:
            return None
        return Nearest(reported.distance_m, tuple(reported.sysids), reported.t_s, reported.what)

    @property
    def limits(self) -> dict[str, float]:
        """Demands of the goal, by part."""
        return goal.asked(self.judged) if self.judged is not None else {}

    def violations(self, part: str) -> list[tuple[float, int, str]]:
        """(when, which vehicle, what to say) of each time that a part of the goal was broken."""
        return [
            (d["at_s"], d["sysids"][0] if d["sysids"] else 0, d["text"])
            for d in self.recorded.decisions
            if d["kind"] == "violation" and d["part"] == part
        ]

    @property
    def faults(self) -> list[tuple[float, int, str]]:
        """(when, which vehicle or 0, what) of each fault that was injected, where it begins."""
        return [
            (d["t_s"], d["sysid"], d["text"])
            for d in self.recorded.decisions
            if d["kind"] == "fault" and d["state"] == "begins"
        ]

    @property
    def outcome(self) -> str:
        """The headline: what came of the goal."""
        if self.summary is None:
            return "No outcome is known"
        if self.summary.outcome == goal.MET:
            return "The goal was met" + self.summary.outcome_text.removeprefix(goal.MET)
        if self.summary.outcome == goal.INTERRUPTED:
            return f"The session was {self.summary.outcome_text or goal.INTERRUPTED}"
        text = self.summary.outcome_text.removeprefix("not met: ") or self.summary.outcome
        return f"The goal was not met: {text}"

    # what went wrong

    @cached_property
    def problems(self) -> list[SessionProblem]:
        """Faults in flight, the worst first."""
        order: dict[Level, int] = {"bad": 0, "warn": 1, "note": 2}
        return sorted(self._problems(), key=lambda problem: order[problem.level])

    def _problems(self) -> Iterator[SessionProblem]:
        for part in self.parts:
            if part.met is False:
                yield SessionProblem("bad", f"Not reached: {part.wanted} ({part.reached}).")
        yield from self._said()
        yield from self._voltages()
        yield from self._silences()
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
        for fault in self.summary.faults if self.summary is not None else ():
            came = "survived" if fault.survived else "not survived"
            yield SessionProblem("note", f"Injected fault, {came}: {fault.text}.")
        for what, times in failed.items():
            yield SessionProblem("warn", f"{what} ({_times(len(times), times[0]['t_s'])}).")
        yield from self._of_the_link()

    def _said(self) -> Iterator[SessionProblem]:
        """Status texts of the vehicles, equal ones once."""
        alike: dict[tuple[str, int], list[tuple[float, int]]] = {}
        for t_s, sysid, severity, text in self.texts:
            alike.setdefault((text, severity), []).append((t_s, sysid))
        for (text, severity), said in alike.items():
            who = sorted({sysid for _, sysid in said})
            level: Level = "bad" if severity <= CRITICAL else "warn"
            plural = "vehicle" if len(who) == 1 else f"{len(who)} vehicles:"
            yield SessionProblem(level, f"“{text}” said by {plural} {few(who)} ({_times(len(said), said[0][0])}).")

    def _voltages(self) -> Iterator[SessionProblem]:
        tables = self.recorded.tables
        if "SYS_STATUS" in tables and "BATTERY_STATUS" in tables:
            statuses, batteries = tables["SYS_STATUS"], tables["BATTERY_STATUS"]
            for sysid, t_s, note in VoltageWatches().take(statuses, statuses["t_s"], batteries, batteries["t_s"]):
                yield SessionProblem("warn", f"Vehicle {sysid}: {note} ({t_s:.1f} s).")

    def _silences(self) -> Iterator[SessionProblem]:
        silent = [event for event in self.watched.events if event.text.startswith(NO_TELEMETRY)]
        if silent:
            whose = sorted({event.sysid for event in silent})
            times = _times(len(silent), silent[0].t_s)
            yield SessionProblem("warn", f"No telemetry of {few(whose)} for more than {STALE_S:g} s ({times}).")

    def _too_near(self) -> Iterator[SessionProblem]:
        for part in ("separation", "clearance", "traffic", "ground"):
            found = self.violations(part)
            for t_s, _, text in found[:FEW]:
                when = "" if " at " in text else f" ({t_s:.1f} s)"
                yield SessionProblem("bad", f"{text[:1].upper()}{text[1:]}{when}.")
            if len(found) > FEW:
                yield SessionProblem("bad", f"{len(found) - FEW} more broke the goal's {part}.")

    def _services_cut_short(self) -> Iterator[SessionProblem]:
        broken = [d for d in self.recorded.decisions if d["kind"] == "broken off"]
        if broken:
            who = sorted({d["receiver"] for d in broken})
            yield SessionProblem(
                "warn", f"Refuelling of {few(who)} was interrupted ({_times(len(broken), broken[0]['t_s'])})."
            )
        for s in self.services:
            if s.energy_j <= 0 and s.reason != NOT_ENDED:
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
