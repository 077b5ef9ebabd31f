"""What is wrong with a vehicle is the same in a session, in its replay and in its report."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

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
    again = Replay(flown.folder)
    for snapshot in live:
        again.advance(snapshot["t_s"], math.inf)
        assert seen(snapshot) & WRONG == seen(again.snapshot(speed=None)) & WRONG, snapshot["t_s"]
    troubles = {row["sysid"]: row["trouble"] for row in first["vehicles"]}
    assert troubles == {1: ["not ready: motors"], 101: [], 201: ["out of order"]}
    assert {row["sysid"]: row["trouble"] for row in last["vehicles"]} == troubles | {201: []}
    assert reported[101][-1][1].texts == ()
