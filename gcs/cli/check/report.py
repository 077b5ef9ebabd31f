"""Results of a vehicle check, as text lines and as JSON."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from gcs.cli.check.dialogue import CheckedVehicle, CheckFinding

FAULTS = frozenset({"missing", "wrong"})
"""Outcomes after which a vehicle does not pass; a late answer is reported, but peers that ask again get it."""


def line(finding: CheckFinding) -> str:
    """One finding as a line, and below it each peer that would miss it with what that peer would show."""
    took = f" ({1e3 * finding.after_s:.0f} ms)" if finding.after_s is not None and finding.outcome != "skipped" else ""
    said = f": {finding.text}" if finding.text else ""
    lines = [f"{finding.outcome:<8} {finding.question.what}{said}{took}"]
    if finding.outcome not in ("ok", "skipped"):
        lines += [f"{'':<8} -> {peer} {shows}" for peer, shows in finding.question.misses.items()]
    return "\n".join(lines)


def counted(findings: Iterable[CheckFinding]) -> dict[str, int]:
    """Number of each outcome."""
    counts = dict.fromkeys(("ok", "late", "missing", "wrong", "skipped"), 0)
    for finding in findings:
        counts[finding.outcome] += 1
    return counts


def passed(findings: Iterable[CheckFinding]) -> bool:
    """Whether nothing is missing or wrong."""
    return not any(finding.outcome in FAULTS for finding in findings)


def as_json(vehicle: CheckedVehicle, others: Iterable[int], findings: Sequence[CheckFinding]) -> dict[str, Any]:
    """Everything as one object."""
    return {
        "sysid": vehicle.sysid,
        "compid": vehicle.compid,
        "autopilot": vehicle.profile.name,
        "others": sorted(others),
        "passed": passed(findings),
        "counts": counted(findings),
        "findings": [
            {
                "key": f.question.key,
                "what": f.question.what,
                "outcome": f.outcome,
                "text": f.text,
                "after_s": f.after_s,
                "misses": dict(f.question.misses) if f.outcome not in ("ok", "skipped") else {},
            }
            for f in findings
        ],
    }
