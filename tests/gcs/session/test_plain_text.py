"""Lines of a session in a terminal."""

from __future__ import annotations

import math
from pathlib import Path

from sessions import fly, small

from gcs.session.plain_text import PlainView
from gcs.session.replay import Replay


def test_a_session_that_says_nothing_more_is_not_shown_as_flying(tmp_path: Path) -> None:
    replay = Replay(fly(small(goal={"duration_s": 5.0}), tmp_path, "--no-report").folder)
    lines: list[str] = []
    view = PlainView(lambda text: lines.append(str(text)))
    shown = []
    for wall_s in (0.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0):
        if wall_s in (0.0, 2.0, 10.0):
            replay.advance(wall_s / 4.0, math.inf)
            view.show(replay.snapshot(speed=None))
        lines.clear()
        view.tick(wall_s)
        shown.append(lines[-1])
    assert ["flying" in line for line in shown] == [True, True, True, False, False, True, True]
    assert shown[3:5] == ["the session has said nothing for 4 s", "the session has said nothing for 6 s"]


def test_a_session_that_says_only_what_went_wrong_says_that(tmp_path: Path) -> None:
    faults = [{"fault": "kill", "sysid": 1, "at_s": 4.0}]
    goal = {"duration_s": 6.0, "refuelled_at_least": 0}
    options = ("--quiet", "--no-report")
    failed = fly(small(faults=faults, goal=goal), tmp_path / "failed", *options)
    assert (failed.status, failed.stdout) == (1, "")
    (line,) = failed.stderr.splitlines()
    assert line.startswith("gcs: not met: lost 1 (1 at 4.")
    allowed = fly(small(faults=faults, goal={**goal, "lost_at_most": 1}), tmp_path / "allowed", *options)
    assert (allowed.status, allowed.stdout) == (0, "")
    (line,) = allowed.stderr.splitlines()
    assert line.startswith("gcs: lost: 1 (1 at 4.")
    well = fly(small(goal=goal), tmp_path / "well", *options)
    assert (well.status, well.stdout, well.stderr) == (0, "", "")
