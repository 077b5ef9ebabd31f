"""The figures as data for the page's script: which lines, in which units, with which marks and limits.

With many vehicles a figure shows the range of all of them, and lines only of the chosen; every vehicle's line is there
to be chosen.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gcs.recording.series import CompetitionSeries, Series
from gcs.report import decimate
from gcs.report.findings import Findings, ServiceFinding
from gcs.report.flight import flight
from gcs.report.pack import Pack

MANY = 16
"""With more vehicles than this, lines of all would hide each other."""
BUCKETS, BUCKETS_OF_MANY = 1000, 400
"""Pixels of a figure's width; of many vehicles each line has fewer, so that the page stays small."""
DEGREES = 180.0 / math.pi
CHOSEN = 6

Lines = Mapping[int, Series]


@dataclass
class ChartPanel:
    """One pair of axes: lines by vehicle, or lines of their own by name; limits are horizontal lines."""

    title: str
    unit: str
    of_vehicles: Lines
    of_session: Mapping[str, Series] | None = None
    limits: Sequence[tuple[float, str]] = ()
    digits: int = 2
    from_zero: bool = False
    span: tuple[float, float] | None = None

    @property
    def has_lines(self) -> bool:
        """Whether any line has a value."""
        lines = (*self.of_vehicles.values(), *(self.of_session or {}).values())
        return any(np.isfinite(line.values).any() for line in lines)


class Charts:
    """Turns findings into the page's model; `pack` holds the numbers."""

    def __init__(self, findings: Findings) -> None:
        self._found = findings
        self.end_s = max(findings.end_s, 1e-3)
        self.pack = Pack(0.0, self.end_s)
        self.many = len(findings.vehicles) > MANY
        self.buckets = BUCKETS_OF_MANY if self.many else BUCKETS
        scenario = findings.scenario
        self._colours = {v.sysid: k for k, v in enumerate(scenario.vehicles.all)} if scenario is not None else {}

    def model(self) -> dict[str, Any]:
        """Data that the script draws: the vehicles, and each figure by its name; a figure without data is left out."""
        found = self._found
        figures = self._of_time()
        if found.services:
            figures["timeline"] = self._timeline()
        if found.ledgers:
            figures["ledger"] = {"kind": "ledger", "rows": found.ledgers}
        return {
            "end_s": self.end_s,
            "many": self.many,
            "flight": flight(found, self.pack),
            "vehicles": [
                {"id": v.sysid, "role": v.role, "label": v.label, "colour": self._colours.get(v.sysid, v.sysid - 1)}
                for v in found.vehicles
            ],
            "chosen": notable(found) if self.many else [v.sysid for v in found.vehicles],
            "figures": figures,
        }

    def panels(self) -> dict[str, list[ChartPanel]]:
        """The figures over time that have any line, by name: their axes, one below the other."""
        found, scenario = self._found, self._found.scenario
        goal = scenario.goal.pursue if scenario else None
        within = [(goal.within_m, f"goal: within {goal.within_m:g} m")] if goal else []
        wanted = {name: [(limit, f"goal: {limit:g} m")] for name, limit in found.limits.items()}
        attitudes = found.attitudes.items()
        roll, pitch, yaw = (
            {sysid: Series(reported[i].t_s, DEGREES * reported[i].values) for sysid, reported in attitudes}
            for i in range(3)
        )
        near = found.nearness
        distances = (
            ("separation", "separation of two vehicles", near.separation),
            ("clearance", "clearance to obstacles", near.clearance),
            ("traffic", "distance to traffic", near.traffic),
        )
        frames = [ChartPanel("Frames received", "1/s", found.rates, digits=0, from_zero=True)]
        if any(line.values.max(initial=0.0) > 0.0 for line in found.losses.values()):
            frames.append(ChartPanel("Frames missing so far", "1", found.losses, digits=0, from_zero=True))
        figures = {
            "target": [ChartPanel("Distance to target", "m", near.to_target, limits=within, from_zero=True)],
            "error": [ChartPanel("Tracking error", "m", found.errors, digits=3, from_zero=True)],
            "motion": [
                ChartPanel("Speed", "m/s", found.speeds, from_zero=True),
                ChartPanel("Height", "m", found.heights),
            ],
            "attitude": [
                ChartPanel("Roll", "°", roll, digits=1),
                ChartPanel("Pitch", "°", pitch, digits=1),
                ChartPanel("Yaw", "°", yaw),
            ],
            "battery": [ChartPanel("Battery", "%", found.battery_percent, digits=1, from_zero=True)],
            "contest": self._competition("tanker", found.competition),
            "base-contest": self._competition("base", found.base_competition),
            "nearness": [
                ChartPanel(f"Least {words}", "m", {}, {name: line}, wanted.get(name, []))
                for name, words, line in distances
                if name != "traffic" or np.isfinite(line.values).any()
            ],
            "link": frames,
        }
        return {name: panels for name, panels in figures.items() if any(panel.has_lines for panel in panels)}

    def _competition(self, giver: str, states: CompetitionSeries) -> list[ChartPanel]:
        """One competition's states and its leader's share."""
        scenario = self._found.scenario
        share = [(scenario.competition.share, "share needed to win")] if scenario else []
        return [
            ChartPanel(f"State v of each competitor for a {giver}", "1", states.v, digits=3, span=(-0.03, 1.06)),
            ChartPanel("Leader's share of Σ vᵖ", "1", {}, {"share": states.share}, share, 3, span=(-0.03, 1.06)),
        ]

    def _of_time(self) -> dict[str, Any]:
        """The figures over time as data, with the marks of what happened."""
        services = self._found.services
        faults = [
            {"t_s": t_s, "label": "fault", "text": text, "bad": False, **({"id": sysid} if sysid else {})}
            for t_s, sysid, text in self._found.faults
        ]
        broken = [
            {"t_s": t_s, "id": sysid, "label": "✗", "text": text, "bad": True}
            for name in ("separation", "clearance", "traffic")
            for t_s, sysid, text in self._found.violations(name)
        ]
        marks: dict[str, list[dict[str, Any]]] = dict.fromkeys(("target", "error", "motion", "link"), faults)
        marks["nearness"] = broken + faults
        marks["contest"] = _handed_over(service for service in services if service.base is None)
        marks["base-contest"] = _handed_over(service for service in services if service.base is not None)
        spans = [
            {"from": s.start_s, "to": s.end_s if s.end_s is not None else self.end_s, "id": s.receiver}
            for s in services
            if s.start_s is not None
        ]
        return {
            name: {
                "kind": "time",
                "panels": [self._panel(panel) for panel in panels],
                "marks": marks.get(name, []),
                "spans": spans if name == "battery" else [],
            }
            for name, panels in self.panels().items()
        }

    def _panel(self, panel: ChartPanel) -> dict[str, Any]:
        known = {s: line for s, line in panel.of_vehicles.items() if np.isfinite(line.values).any()}
        own = {name: line for name, line in (panel.of_session or {}).items() if np.isfinite(line.values).any()}
        made: dict[str, Any] = {
            "title": panel.title,
            "unit": "" if panel.unit == "1" else panel.unit,
            "digits": panel.digits,
            "zero": panel.from_zero,
            "range": panel.span,
            "limits": [{"y": y, "label": label} for y, label in panel.limits],
            "lines": [{"id": s, **self.pack.line(self._fewer(line))} for s, line in sorted(known.items())],
            "own": [
                {"label": name, **self.pack.line(decimate.min_max(line, BUCKETS, 0.0, self.end_s))}
                for name, line in own.items()
            ],
        }
        if self.many and len(known) > MANY:
            t_s, least, median, greatest = decimate.band(list(known.values()), BUCKETS_OF_MANY, 0.0, self.end_s)
            names = zip(("least", "median", "greatest"), (least, median, greatest), strict=True)
            made["band"] = {name: self.pack.line(Series(t_s, values)) for name, values in names}
            made["band"]["count"] = len(known)
        return made

    def _fewer(self, line: Series) -> Series:
        return decimate.min_max(line, self.buckets, 0.0, self.end_s)

    def _timeline(self) -> dict[str, Any]:
        found = self._found
        labels = {v.sysid: v.label for v in found.vehicles}
        bars = []
        for s in found.services:
            end_s = s.end_s if s.end_s is not None else self.end_s
            steps = [s.decided_at_s, s.joined_at_s, s.start_s]
            row = labels.get(s.receiver, str(s.receiver))
            bids = sorted(s.bids.items(), key=lambda bid: -bid[1])[:5]
            reported = ", ".join(f"{sysid}: {bid:.2f}" for sysid, bid in bids)
            text = f"by {s.giver}, decided by {s.by}, {s.energy_j:.0f} J ({s.reason}); bids {reported or 'none'}"
            for stage, (begin, *later) in enumerate((steps, steps[1:], steps[2:])):
                if begin is not None:
                    until = next((t for t in later if t is not None), end_s)
                    bars.append({"row": row, "stage": stage, "from": begin, "to": until, "text": text})
        rows = list(dict.fromkeys(labels.get(s.receiver, str(s.receiver)) for s in found.services))
        return {"kind": "timeline", "rows": rows, "bars": bars}


def _handed_over(services: Iterable[ServiceFinding]) -> list[dict[str, Any]]:
    """Marks where a competition handed a giver over."""
    return [{"t_s": s.decided_at_s, "id": s.receiver, "label": f"→ {s.receiver}"} for s in services]


def notable(found: Findings) -> list[int]:
    """The vehicles that a reader would look at first, of many: by error, battery, distance to target, loss."""
    picks: list[int] = []
    worst: Iterable[tuple[Lines, int, bool]] = (
        (found.errors, 2, True),
        (found.battery_percent, 2, False),
        (found.nearness.to_target, 1, True),
        (found.speeds, 1, True),
    )
    for lines, count, greatest in worst:
        extremes = {
            s: float(np.nanmax(line.values) if greatest else -np.nanmin(line.values))
            for s, line in lines.items()
            if np.isfinite(line.values).any() and s not in picks
        }
        picks += sorted(extremes, key=lambda s: (-extremes[s], s))[:count]
    return sorted(picks[:CHOSEN])
