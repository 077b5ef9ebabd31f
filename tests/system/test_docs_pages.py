"""What each page of the documentation has run, run in an empty folder; `test_readme.py` types what waits for others."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from pages import DOCS, PAGES, run, run_lines

INDEX = DOCS / "index.md"
RUN = [page for page in PAGES if page != INDEX and run_lines(page)]


def test_the_index_runs_nothing_that_the_first_hour_does_not() -> None:
    assert set(run_lines(INDEX)) <= set(run_lines(DOCS / "first-hour.md"))


@pytest.mark.slow
@pytest.mark.timeout(900)
@pytest.mark.parametrize("page", RUN, ids=lambda page: page.stem)
def test_what_a_page_has_run_does_what_it_says(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(Path(sys.executable).parent), prepend=":")
    run(page, tmp_path, within_s=400.0)
    if page.stem == "first-hour":
        names = ("7", "7-again", "8", "python")
        digests = [json.loads((tmp_path / f"pair-{name}" / "summary.json").read_text())["digest"] for name in names]
        assert digests[0] == digests[1]
        assert len(set(digests)) == 3
        json.loads((tmp_path / "scenario.schema.json").read_text())
    if page.stem == "act":
        first, second = (json.loads((tmp_path / name / "summary.json").read_text()) for name in ("first", "second"))
        assert first["digest"] == second["digest"]
        assert [fault["fault"] for fault in first["faults"]] == ["motor"]
    if page.stem == "own-policy":
        services = json.loads((tmp_path / "turns-flight" / "summary.json").read_text())["refuelling"]
        assert {service["by"] for service in services} == {"policy"}
    if page.stem == "ci":
        assert "testsuite" in (tmp_path / "outcome.xml").read_text()
