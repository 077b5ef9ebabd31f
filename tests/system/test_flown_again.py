"""The report's way to fly a session again, taken as it is printed (real sessions, in lockstep)."""

from __future__ import annotations

import html
import json
import os
import re
import shlex
import subprocess
from pathlib import Path
from typing import Any

import pytest
from sessions import GCS, fly, small

import gcs
from gcs.recording.session_folder import read
from gcs.report import tables
from gcs.report.findings import Findings

PLANNER = """
class Stays:
    def __init__(self, scenario):
        pass

    def plan(self, vehicle, situation):
        return vehicle.p_ned, (0.0, 0.0, 0.0)
"""


@pytest.mark.parametrize("by_path", [True, False])
def test_a_session_with_a_planner_of_another_folder_is_flown_again_as_the_report_says(
    by_path: bool, tmp_path: Path
) -> None:
    own, elsewhere = tmp_path / "own", tmp_path / "elsewhere"
    own.mkdir()
    (own / "stays.py").write_text(PLANNER, encoding="utf-8")
    content: dict[str, Any] = small(goal={"duration_s": 5.0, "refuelled_at_least": 0}, planner="stays:Stays")
    fly(content, own).folder.rename(tmp_path / "session")
    again = html.unescape(tables.again(Findings(read(tmp_path / "session"))))
    assert "The scenario names code, planner stays:Stays, which is not in the session's folder." in again
    found = re.search(r"<code>gcs (run .*?)</code>", again)
    assert found is not None
    elsewhere.mkdir()
    (own / "stays.py").rename((elsewhere if by_path else tmp_path) / "stays.py")
    path = os.pathsep.join([str(elsewhere), os.environ.get("PYTHONPATH", "")])
    environment = {**os.environ, "PYTHONPATH": path}
    words = [*GCS, *shlex.split(found[1]), "--trust", "--quiet"]
    subprocess.run(words, cwd=tmp_path, env=environment, check=False, capture_output=True)
    flown = json.loads((tmp_path / "again" / "summary.json").read_text(encoding="utf-8"))
    assert flown["digest"] == json.loads((tmp_path / "session" / "summary.json").read_text(encoding="utf-8"))["digest"]


@pytest.mark.parametrize("part", ["set point", "policy", None])
def test_a_session_in_which_a_program_took_part_says_so(part: str | None, tmp_path: Path) -> None:
    class First:
        def choose(self, request: gcs.RefuellingRequest) -> int:
            return request.candidates[0].sysid

    scenario = gcs.Scenario.model_validate(small(goal={"duration_s": 6.0, "refuelled_at_least": 0}))
    policy = First() if part == "policy" else None
    with gcs.Session(scenario, policy=policy, out=tmp_path / "session") as session:
        while session.step().time_s < 5.0:
            pass
        if part == "set point":
            session.step({1: ((4.0, 0.0, -3.0), (0.0, 0.0, 0.0))})
        session.finish()
    again = html.unescape(tables.again(Findings(read(tmp_path / "session"))))
    assert ("A program in Python took part; without it the flight is another." in again) == (part is not None)
    assert ("<code>gcs replay session --decide</code>" in again) == (part is not None)
