"""Which autopilot it is, is asked in one place: a scan of the ground station's source, and what it would find."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

GCS = Path(__file__).resolve().parents[3] / "gcs"
TABLE = GCS / "mavlink" / "autopilots.py"
PROFILES = {"PX4", "ARDUCOPTER", "ARDUPLANE", "ARDUROVER", "ARDUSUB", "BLIMP", "GENERIC"}
NAMES = {"px4", "ardupilot", "generic"}
NUMBERS = {"MAV_AUTOPILOT_PX4", "MAV_AUTOPILOT_ARDUPILOTMEGA"}
ASKED = {"autopilot", "name", "profile"}
MAY_ASK = re.compile("|".join(PROFILES | NAMES | NUMBERS))
"""In a file that has none of these words no question is looked for: reading it takes long."""


def questions(tree: ast.AST) -> Iterator[ast.AST]:
    """Places that ask which autopilot it is: comparisons and matches with a profile, its name or its number."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Compare):
            sides = [part for side in (node.left, *node.comparators) for part in ast.walk(side)]
            attributes = {part.attr for part in sides if isinstance(part, ast.Attribute)}
            named = attributes | {part.id for part in sides if isinstance(part, ast.Name)}
            texts = {part.value for part in sides if isinstance(part, ast.Constant)}
            if named & (PROFILES | NUMBERS) or (named & ASKED and texts & NAMES):
                yield node
        elif isinstance(node, ast.MatchValue):
            if any(isinstance(part, ast.Attribute) and part.attr in NUMBERS for part in ast.walk(node)):
                yield node
        elif isinstance(node, ast.Subscript | ast.Dict):  # a table of one's own is the same question
            keys = node.keys if isinstance(node, ast.Dict) else [node.slice]
            if any(isinstance(key, ast.Name | ast.Attribute) and _last(key) in PROFILES | NUMBERS for key in keys):
                yield node


def _last(key: ast.Name | ast.Attribute) -> str:
    return key.id if isinstance(key, ast.Name) else key.attr


def test_nothing_but_the_table_asks_which_autopilot_it_is() -> None:
    found = [
        f"{path.relative_to(GCS)}:{node.lineno}"  # type: ignore[attr-defined]
        for path in sorted(GCS.rglob("*.py"))
        if path != TABLE
        if MAY_ASK.search(text := path.read_text(encoding="utf-8"))
        for node in questions(ast.parse(text))
    ]
    assert found == []


@pytest.mark.parametrize(
    "line",
    [
        "if vehicle.profile is ARDUCOPTER: pass",
        "if vehicle.profile not in (PX4, GENERIC): pass",
        "x = 1 if view.profile.name == 'px4' else 2",
        "if rules.autopilot != 'ardupilot': pass",
        "if beat.autopilot == mav.MAV_AUTOPILOT_ARDUPILOTMEGA: pass",
        "habits = {mav.MAV_AUTOPILOT_PX4: 1}",
        "habits = {PX4: 1, ARDUCOPTER: 2}",
        "match beat.autopilot:\n    case mav.MAV_AUTOPILOT_PX4:\n        pass",
    ],
)
def test_the_scan_finds(line: str) -> None:
    assert list(questions(ast.parse(line)))


@pytest.mark.parametrize("line", ["profile = profile_of(beat.autopilot)", "if profile.streams_on_request: pass"])
def test_the_scan_passes(line: str) -> None:
    assert not list(questions(ast.parse(line)))
