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


NAMES = ["lost", "duration", "separation", "clearance", "traffic", "ground", "pursue", "refuelled"]


def suite(unmet: tuple[str, ...], *, outcome: str = "", left: bool = True, error: str | None = None) -> ET.Element:
    summary: dict[str, Any] | None = None
    if left:
        goal = [{"part": name, "reached": "0.02 m", "met": name not in unmet} for name in NAMES]
        summary = {"outcome": outcome or (*unmet, "met")[0], "wall_time_s": 1.5, "goal": goal, "seed": 3}
    root = ET.fromstring(document(DEMO, summary, error, Path("there")))
    assert root.tag == "testsuites"
    (found,) = root
    return found


def verdicts(element: ET.Element) -> list[str]:
    return [case[0].tag if len(case) else "passed" for case in element.iter("testcase")]


@pytest.mark.parametrize("unmet", [(), ("lost",), ("pursue",), ("separation", "refuelled")])
def test_each_part_of_the_goal_is_a_case_that_is_judged_by_itself(unmet: tuple[str, ...]) -> None:
    found = suite(unmet)
    assert verdicts(found) == ["failure" if name in unmet else "passed" for name in NAMES]
    counts = [found.get(key) for key in ("tests", "failures", "errors", "skipped")]
    assert counts == ["8", str(len(unmet)), "0", "0"]
    told = [case[0].get("message") for case in found.iter("testcase") if len(case)]
    assert told == [f"not met: {name} 0.02 m" for name in NAMES if name in unmet]


@pytest.mark.parametrize("ended", [{"outcome": "interrupted"}, {"left": False}, {"error": "died"}])
def test_what_did_not_come_to_its_end_is_an_error_and_not_judged(ended: dict[str, Any]) -> None:
    found = suite((), **ended)
    assert verdicts(found) == ["error", *["skipped"] * 7]
    assert [found.get(key) for key in ("tests", "failures", "errors", "skipped")] == ["8", "0", "1", "7"]


def test_an_error_is_told_even_with_what_no_xml_may_hold() -> None:
    (case, *_) = suite((), left=False, error="died \x00 at <once>").iter("testcase")
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


@pytest.mark.parametrize(
    ("out", "junit"),
    [("new", "new"), ("new", "./new"), ("new/deep/session", "new"), ("here/new", "there/new"), (None, "sessions")],
)
def test_a_file_where_the_session_has_its_folder_is_refused_before_the_flight(
    out: str | None, junit: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "here").mkdir()
    (tmp_path / "there").symlink_to("here")
    monkeypatch.chdir(tmp_path)
    words = [] if out is None else ["--out", out]
    assert run_argv(["run", "demo", "--lockstep", "--plain", *words, "--junit", junit]) == 2
    said = f"gcs: --junit: {Path(junit)} will be a folder, as the session's folder is there; name a file."
    assert capsys.readouterr().err.splitlines()[-1] == said
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["here", "there"]
