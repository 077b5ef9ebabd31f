"""A session's outcome as CI systems read it."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest

from gcs import load
from gcs.cli.main import run_argv
from gcs.report.junit import document
from gcs.scenario.file import find

DEMO = load(find("demo"))


def suite(outcome: str | None, error: str | None = None) -> ET.Element:
    summary: dict[str, Any] | None = None
    if outcome is not None:
        keys = ("seed", "clock", "digest", "sim_time_s", "min_separation_m", "min_clearance_m", "refuel_order")
        summary = {"outcome": outcome, "wall_time_s": 1.5, **dict.fromkeys(keys)}
    root = ET.fromstring(document(DEMO, summary, error, Path("there")))
    assert root.tag == "testsuites"
    (found,) = root
    return found


def verdicts(element: ET.Element) -> list[str]:
    return [case[0].tag if len(case) else "passed" for case in element.iter("testcase")]


@pytest.mark.parametrize(
    ("outcome", "wanted"),
    [
        ("met", ["passed"] * 4),
        ("vehicle_lost", ["failure", "skipped", "skipped", "skipped"]),
        ("pursue", ["passed", "passed", "failure", "skipped"]),
        ("refuelled_at_least", ["passed", "passed", "passed", "failure"]),
        ("interrupted", ["error", "skipped", "skipped", "skipped"]),
        (None, ["error", "skipped", "skipped", "skipped"]),
    ],
)
def test_each_part_of_the_goal_is_a_case_and_the_counts_agree(outcome: str | None, wanted: list[str]) -> None:
    found = suite(outcome)
    assert verdicts(found) == wanted
    assert (found.get("tests"), found.get("failures"), found.get("errors"), found.get("skipped")) == tuple(
        str(number) for number in (4, wanted.count("failure"), wanted.count("error"), wanted.count("skipped"))
    )


def test_an_error_is_told_even_with_what_no_xml_may_hold() -> None:
    (case, *_) = suite(None, "died \x00 at <once>").iter("testcase")
    assert case[0].get("message") == "died \ufffd at <once>"


def test_a_scenario_that_cannot_be_flown_is_an_error_in_the_file_too(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    scenario, out = tmp_path / "mine.yaml", tmp_path / "outcome.xml"
    scenario.write_text("schema: 1\nname: mine\nsped: 3\n")
    assert run_argv(["run", str(scenario), "--junit", str(out), "--out", str(tmp_path / "session")]) == 2
    (found,) = ET.parse(out).getroot()
    assert verdicts(found) == ["error"]
    assert [found.get(key) for key in ("tests", "errors", "failures")] == ["1", "1", "0"]
    assert "sped" in "".join(found.itertext())
    assert "sped" in capsys.readouterr().err
    assert not (tmp_path / "session").exists()
