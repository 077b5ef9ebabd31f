"""Sessions whose place fails them: its name, its disk, its end while they fly, and too few files that may be open."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from sessions import Running, fly, small


def test_a_folder_whose_name_is_no_utf8_is_flown_into_and_shown_as_text(tmp_path: Path) -> None:
    outcome = fly(small(goal={"duration_s": 2.0, "refuelled_at_least": 0}), tmp_path / "x\udcff", "--json")
    assert outcome.status == 0, outcome.stderr
    assert outcome.summary["outcome"] == "met"
    end = json.loads(outcome.stdout.splitlines()[-1])
    assert end["session"].endswith("/x\ufffd/session")
    json.dumps([json.loads(line) for line in outcome.stdout.splitlines()], ensure_ascii=False).encode()
    reported = gcs("report", str(outcome.folder))
    assert reported.returncode == 0, reported.stderr
    (outcome.folder / "report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize("record", [{}, {"rotate_mb": 1}])
def test_a_folder_that_is_removed_in_flight_ends_the_session_and_is_named(
    tmp_path: Path, record: dict[str, Any]
) -> None:
    clock = {"mode": "real", "speed": 5.0}
    session = Running(small(clock=clock, goal={"duration_s": 3000.0}, record=record), tmp_path, "--json", report=True)
    try:
        session.wait_for(lambda s: s["t_s"] > 2.0)
        shutil.rmtree(session.folder)
        outcome = session.finish()
    finally:
        session.stop()
    assert outcome.status == 1
    said = f"{session.folder} is gone, and with it what was recorded there; the session has ended"
    assert f"gcs: {said}" in outcome.stderr.splitlines()
    assert json.loads(outcome.stdout.splitlines()[-1])["error"] == said
    assert "kept" not in outcome.stderr
    assert ".summary" not in outcome.stderr
    assert not session.folder.exists()
