"""A session's outcome as JUnit XML: one test case for each part of the scenario's goal, for CI systems to show."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

from gcs.scenario.goal import INTERRUPTED, Measured, judge
from gcs.scenario.model import Scenario

NO_XML = dict.fromkeys((*range(9), 11, 12, *range(14, 32), 0xFFFE, 0xFFFF), "\ufffd")
"""Characters that no XML file may hold."""


def document(scenario: Scenario, summary: dict[str, Any] | None, error: str | None, folder: Path) -> str:
    """The XML. `summary` is summary.json's content, None where none was written; `error` is why the session failed."""
    judged = {part["part"]: part for part in (summary or {}).get("goal", ())}
    wanted_of = {one.part: one.wanted for one in judge(scenario, Measured())}
    added = {part: str(one["wanted"]) for part, one in judged.items() if part not in wanted_of}  # in flight
    parts = list((wanted_of | added).items())
    suite = ET.Element("testsuite", name=scenario.name, tests=str(len(parts)))
    counts = dict.fromkeys(("failures", "errors", "skipped"), 0)
    wall_s = summary["wall_time_s"] if summary else 0.0
    each_s = f"{wall_s / max(len(parts), 1):.3f}"  # one flight for all parts: the suite's time is the sum of its cases
    ended = summary is not None and not error and summary["outcome"] != INTERRUPTED
    for i, (part, wanted) in enumerate(parts):
        case = ET.SubElement(suite, "testcase", classname=f"skytender.{scenario.name}", name=wanted, time=each_s)
        found = judged.get(part)
        if not ended and i == 0:
            counts["errors"] += 1
            why = error or (summary.get("outcome_text") or INTERRUPTED if summary else "the session left no summary")
            ET.SubElement(case, "error", message=_text(why)).text = _text(f"{why}\nsession: {folder}")
        elif not ended or found is None:
            counts["skipped"] += 1
            ET.SubElement(case, "skipped", message="not judged")
        elif not found["met"]:
            counts["failures"] += 1
            said = _text(f"not met: {part} {found['reached']}")
            ET.SubElement(case, "failure", message=said).text = _text(f"session: {folder}")
    for key, number in counts.items():
        suite.set(key, str(number))
    suite.set("time", f"{wall_s:.3f}")
    if summary is not None:
        keys = (
            *("seed", "clock", "digest", "sim_time_s", "outcome", "min_separation_m", "min_clearance_m"),
            *("min_traffic_m", "refuel_order"),
        )
        properties = ET.Element("properties")
        for key in keys:
            ET.SubElement(properties, "property", name=key, value=_text(json.dumps(summary.get(key)).strip('"')))
        suite.insert(0, properties)
    return _xml(suite)


def refused(scenario: str, why: str) -> str:
    """The XML for a scenario, by name or file, that could not be flown: one test case, in error."""
    counts = {"tests": "1", "failures": "0", "errors": "1", "skipped": "0", "time": "0"}
    suite = ET.Element("testsuite", {"name": _text(scenario)} | counts)
    case = ET.SubElement(suite, "testcase", classname="skytender", name="the scenario can be flown", time="0")
    ET.SubElement(case, "error", message=_text(why.splitlines()[0])).text = _text(why)
    return _xml(suite)


def flown(folder: Path, scenario: Scenario, error: str | None) -> str:
    """The XML for the session in `folder`."""
    try:
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        summary = None
    return document(scenario, summary, error, folder)


def _xml(suite: ET.Element) -> str:
    root = ET.Element("testsuites")
    root.append(suite)
    ET.indent(root)
    return ET.tostring(root, encoding="unicode", xml_declaration=True) + "\n"


def _text(words: str) -> str:
    return words.translate(NO_XML)
