"""What is wrong with a vehicle is the same in a session, in its replay and in its report."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest
from sessions import fly, small

from gcs.recording.session_folder import read
from gcs.report.watched import Watched
from gcs.session.replay import Replay

WRONG = {
    (1, "not ready: motors", "warned"),
    (201, "out of order", "warned"),
    (101, "failsafe: Hold", "failing"),
}


def seen(*snapshots: dict[str, Any]) -> set[tuple[int, str, str]]:
    rows = [row for snapshot in snapshots for row in snapshot["vehicles"]]
    return {(row["sysid"], text, row["condition"]) for row in rows for text in row["trouble"]}


def test_what_does_not_arm_gives_no_energy_or_is_in_a_failsafe_is_not_well(tmp_path: Path) -> None:
    faults = [
        {"fault": "motor", "sysid": 1, "at_s": 0.0},
        {"fault": "tanker_out", "sysid": 201, "at_s": 4.0, "for_s": 3.0},
        {"fault": "gcs_silent", "at_s": 7.0, "for_s": 3.5},
    ]
    flown = fly(small(faults=faults, goal={"duration_s": 12.0}), tmp_path, "--no-report", "--json", "--speed", "4")
    live = [line for line in map(json.loads, flown.stdout.splitlines()) if line["type"] == "snapshot"]
    replay = Replay(flown.folder)
    replayed = []
    for k in range(120):
        replay.advance(0.1 * k, math.inf)
        replayed.append(replay.snapshot(speed=None))
    reported = Watched(read(flown.folder)).health
    first, last = replayed[55], replayed[-1]
    assert {
        (sysid, text, one.condition) for sysid, seen in reported.items() for _, one in seen for text in one.texts
    } >= WRONG
    assert seen(*replayed) >= WRONG
    changes_s = [one["t_s"] for one in flown.decisions if one["kind"] == "fault"]
    again = Replay(flown.folder)
    for snapshot in live:
        if snapshot["t_s"] in changes_s:
            continue  # it was shown before the change of that time, or after it
        again.advance(snapshot["t_s"], math.inf)
        assert seen(snapshot) & WRONG == seen(again.snapshot(speed=None)) & WRONG, snapshot["t_s"]
    troubles = {row["sysid"]: row["trouble"] for row in first["vehicles"]}
    assert troubles == {1: ["not ready: motors"], 101: [], 201: ["out of order"]}
    assert {row["sysid"]: row["trouble"] for row in last["vehicles"]} == troubles | {201: []}
    assert reported[101][-1][1].texts == ()


def test_two_that_meet_are_marked_while_they_are_too_near(tmp_path: Path) -> None:
    """They fly towards each other at 3 m/s, 0.3 m beside each other; 1.5 m are wanted."""
    ways = {3: [[16.0, 0.0, -3.0]], 4: [[0.0, 0.3, -3.0]]}
    start_m = {3: [0.0, 0.0, 0.0], 4: [16.0, 0.3, 0.0]}
    pursuers = [
        {"sysid": k, "start_m": start_m[k], "waypoints_m": ways[k], "battery": {"capacity_j": 60_000}} for k in ways
    ]
    content = small(planner={"cruise_m_s": 3.0, "separation_m": 1.5, "safety": False})
    content |= {"goal": {"duration_s": 12.0}, "vehicles": {"pursuers": pursuers}}
    del content["formation"]
    flown = fly(content, tmp_path, "--no-report", "--json", "--speed", "4")
    broken = [one for one in flown.decisions if one["kind"] == "violation" and one["by"] == "reports"]
    assert [(one["part"], one["sysids"]) for one in broken] == [("separation", [3, 4])]
    replay = Replay(flown.folder)
    marked = []
    for k in range(120):
        replay.advance(0.1 * k, math.inf)
        rows = {row["sysid"]: row for row in replay.snapshot(speed=None)["vehicles"]}
        if any("from pursuer" in text for text in rows[3]["trouble"]):
            marked.append(0.1 * k)
            assert (rows[3]["condition"], rows[4]["condition"]) == ("failing", "failing")
    assert marked[0] == pytest.approx(broken[0]["t_s"], abs=0.15)
    assert 0.2 <= marked[-1] - marked[0] <= 2.0
    reported = Watched(read(flown.folder)).health
    assert any("from pursuer 4" in text for _, one in reported[3] for text in one.texts)
    again = Replay(flown.folder)
    for snapshot in (line for line in map(json.loads, flown.stdout.splitlines()) if line["type"] == "snapshot"):
        again.advance(snapshot["t_s"], math.inf)
        near = [
            {one for one in seen(each) if "from pursuer" in one[1]} for each in (snapshot, again.snapshot(speed=None))
        ]
        assert near[0] == near[1], snapshot["t_s"]
