"""Sessions whose place fails them: its name, its disk, its end while they fly, and too few files that may be open."""

from __future__ import annotations

import json
from pathlib import Path

from commands import gcs
from sessions import fly, small


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
