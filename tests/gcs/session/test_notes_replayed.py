"""What a vehicle's note says of its part in the refuelling is in a replay what it was in the session."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest
from sessions import fly, small

from gcs.session.replay import Replay
from gcs.session.timeline import Moments

TAKEN, SKIPPED, OUT = "taken by the operator", "skipped by the operator", "out of order"
RELEASED = "taken by another ground station"


def notes(snapshot: dict[str, Any]) -> dict[int, str]:
    return {row["sysid"]: row["note"] for row in snapshot["vehicles"]}


def test_a_tanker_out_of_order_is_shown_for_as_long_as_the_session_showed_it(tmp_path: Path) -> None:
    faults = [{"fault": "tanker_out", "sysid": 201, "at_s": 4.0, "for_s": 3.0}]
    flown = fly(small(faults=faults, goal={"duration_s": 12.0}), tmp_path, "--no-report", "--json", "--speed", "4")
    live = [line for line in map(json.loads, flown.stdout.splitlines()) if line["type"] == "snapshot"]
    replay = Replay(flown.folder)
    changes_s = [one["t_s"] for one in flown.decisions if one["kind"] == "fault"]
    assert len(changes_s) == 2
    for snapshot in live:
        if snapshot["t_s"] in changes_s:
            continue  # it was shown before the change of that time, or after it
        replay.advance(snapshot["t_s"], math.inf)
        was_out = notes(snapshot)[201] == OUT
        assert (notes(replay.snapshot(speed=None))[201] == OUT) == was_out, snapshot["t_s"]
    replay.seek(5.0)
    assert notes(replay.snapshot(speed=None))[201] == "out of order"
    replay.seek(7.5)
    assert notes(replay.snapshot(speed=None))[201] != "out of order"


@pytest.mark.parametrize(
    ("said", "asked", "out"),
    [
        (["hold"], [], {1: TAKEN}),
        (["hold", "release"], [], {1: RELEASED}),
        (["release", "hold"], [], {1: TAKEN}),
        (["release"], [], {1: RELEASED}),
        (["release", "skip"], [], {1: RELEASED}),
        (["land", "rejoin"], [], {}),
        (["skip"], [], {1: SKIPPED}),
        (["skip", "skip"], [], {}),
        (["skip", "hold"], [], {1: TAKEN}),
        (["skip", "hold", "rejoin"], [], {1: SKIPPED}),
        (["hold", "skip", "rejoin"], [], {1: SKIPPED}),
        (["hold", "skip", "skip"], [], {1: TAKEN}),
        (["refuel"], [1], {}),
        (["refuel", "decided"], [], {}),
        (["refuel", "skip"], [], {1: SKIPPED}),
        (["refuel", "death"], [], {}),
        (["begins"], [], {1: OUT}),
        (["begins", "ends"], [], {}),
        (["begins", "hold", "ends"], [], {1: TAKEN}),
        (["begins", "hold", "rejoin"], [], {1: OUT}),
        (["begins", "hold", "rejoin", "ends"], [], {}),
        (["mission flown"], [], {}),
    ],
)
def test_orders_faults_and_decisions_leave_the_notes_that_they_left_in_the_session(
    said: list[str], asked: list[int], out: dict[int, str]
) -> None:
    moments = Moments()
    for t_s, word in enumerate(said):
        record: dict[str, Any] = {"kind": "operator", "command": word, "taken": True, "sysid": 1}
        if word in ("begins", "ends"):
            record = {"kind": "fault", "fault": "tanker_out", "state": word, "sysid": 1}
        elif word in ("decided", "death"):
            record = {"kind": word, "receiver": 1, "sysid": 1}
        elif word == "mission flown":
            record = {"kind": "mission", "state": "flown", "sysid": 1}
        moments.take(float(t_s), record)
    after, before = moments.participation(math.inf), moments.participation(-1.0)
    assert (after.asked, after.out) == (asked, out)
    assert (before.asked, before.out) == ([], {})
