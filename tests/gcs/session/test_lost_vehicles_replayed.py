"""A vehicle that was lost is trouble in replay and report too, until it flies again."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Any

from sessions import fly, small

from gcs.recording.session_folder import read
from gcs.report.watched import Watched
from gcs.session.replay import Replay
from gcs.session.timeline import Moments


def seen_at(replay: Replay, t_s: float) -> dict[int, dict[str, Any]]:
    replay.advance(t_s, math.inf)
    return {row["sysid"]: row for row in replay.snapshot(speed=None)["vehicles"]}


def test_a_vehicle_whose_motor_failed_is_no_vehicle_that_is_well(tmp_path: Path) -> None:
    faults = [{"fault": "motor", "sysid": 1, "at_s": 9.0}]
    folder = fly(small(faults=faults, goal={"duration_s": 16.0}), tmp_path, "--no-report").folder
    replay = Replay(folder)
    assert "not flying" not in seen_at(replay, 8.0)[1]["trouble"]
    crashed = seen_at(replay, 15.0)[1]
    assert ("not flying" in crashed["trouble"], crashed["severity"]) == (True, 2)
    assert "not flying" in Watched(read(folder)).health[1][-1][1].texts


def lost_at(replay: Replay, t_s: float) -> list[str]:
    replay.advance(t_s, math.inf)
    broken = [part["text"] for part in replay.snapshot(speed=None)["goal"]["broken"] if part["part"] == "lost"]
    return [re.sub(r"\d+\.\d s", "T", text) for text in broken]


def test_the_goal_names_those_that_were_lost_at_the_time_that_is_shown(tmp_path: Path) -> None:
    """One crashes at 9 s; one is landed by its failsafe from 11 s on; one dies at 14 s."""
    faults = [
        {"fault": "motor", "sysid": 1, "at_s": 9.0},
        {"fault": "gps_off", "sysid": 101, "at_s": 11.0},
        {"fault": "kill", "sysid": 201, "at_s": 14.0},
    ]
    folder = fly(small(faults=faults, goal={"duration_s": 17.0}), tmp_path, "--no-report").folder
    crashed, lands, died = (
        "1 at T: crashed, or disarmed in flight",
        "101 at T: its failsafe flies it (Land)",
        "201 at T: its process died",
    )
    wanted = {
        8.0: [],
        10.5: [f"lost 1 ({crashed})"],
        12.5: [f"lost 2 ({crashed}; {lands})"],
        16.0: [f"lost 3 ({crashed}; {lands}; {died})"],
    }
    replay = Replay(folder)
    assert {t_s: lost_at(replay, t_s) for t_s in wanted} == wanted
    (folder / "summary.json").unlink()
    killed = Replay(folder)
    assert {t_s: lost_at(killed, t_s) for t_s in wanted} == wanted


def test_a_loss_that_the_goal_allows_is_trouble_as_it_was_in_flight(tmp_path: Path) -> None:
    """It is in no decision; what the session said in flight is in its lines of JSON."""
    faults = [{"fault": "motor", "sysid": 1, "at_s": 9.0}]
    goal = {"duration_s": 16.0, "lost_at_most": 1}
    flown = fly(small(faults=faults, goal=goal), tmp_path, "--no-report", "--json")
    lines = [json.loads(line) for line in flown.stdout.splitlines()]
    last = [line for line in lines if line["type"] == "snapshot"][-1]
    live = {row["sysid"]: (row["trouble"], row["severity"], row["condition"]) for row in last["vehicles"]}
    assert live[1] == (["not flying", "not ready: motors"], 2, "failing")
    assert not [record for record in flown.decisions if record.get("part") == "lost"]
    found = seen_at(Replay(flown.folder), last["t_s"])
    assert {sysid: (row["trouble"], row["severity"], row["condition"]) for sysid, row in found.items()} == live
    assert Watched(read(flown.folder)).health[1][-1][1].texts == ("not flying", "not ready: motors")


def test_orders_do_not_hide_a_loss_but_a_landing_by_order_after_it_rejoined_is_none() -> None:
    moments = Moments()
    moments.take(4.0, {"kind": "violation", "part": "lost", "at_s": 4.0, "sysids": [1]})
    orders = [(6.0, "hold", {1}), (8.0, "rejoin", {1}), (20.0, "hold", {1}), (30.0, "land", set())]
    assert (moments.lost(3.0), moments.lost(5.0)) == (set(), {1})
    for t_s, command, lost in orders:
        moments.take(t_s, {"kind": "operator", "taken": True, "sysid": 1, "command": command})
        assert moments.lost(t_s + 1.0) == lost
    assert moments.lost(25.0) == {1}


def test_a_recording_that_ends_inside_a_set_point_says_so(tmp_path: Path) -> None:
    folder = fly(small(goal={"duration_s": 10.0}), tmp_path, "--no-report").folder
    file = folder / "decisions.jsonl"
    lines = file.read_bytes().splitlines(keepends=True)
    last = max(k for k, line in enumerate(lines) if line.startswith(b'{"kind":"set_point"'))
    file.write_bytes(b"".join(lines[:last]) + lines[last][:40])
    assert any("decisions.jsonl" in problem for problem in Replay(folder).problems)
