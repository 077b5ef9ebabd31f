"""Recordings played: against the session that made them, and against pymavlink's reading of it."""

from __future__ import annotations

import json
import math
import os
import pty
import re
import select
import shutil
import struct
import subprocess
import time
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from pymavlink.dialects.v20 import ardupilotmega as mav
from sessions import GCS, Outcome, fly, two_refuellings

from gcs.recording import rotation
from gcs.recording.recorder import DECISIONS
from gcs.session.replay import Replay, ReplayError, ReplaySource


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    return fly(two_refuellings(), tmp_path_factory.mktemp("flown"), "--plain")


@pytest.fixture
def replay(session: Outcome) -> Replay:
    return Replay(session.folder)


def rows(snapshot: dict[str, Any]) -> dict[int, dict[str, Any]]:
    json.dumps(snapshot, allow_nan=False)
    return {row["sysid"]: row for row in snapshot["vehicles"]}


# playing


def test_positions_are_those_that_were_recorded(session: Outcome, replay: Replay) -> None:
    """All origins are the common one's here, so that pymavlink's local positions are the places."""
    assert replay.advance(20.0, math.inf)
    last: dict[int, tuple[float, Any]] = {}
    for t_s, message in session.messages("LOCAL_POSITION_NED"):
        if t_s <= 20.0:
            last[message.get_srcSystem()] = max(last.get(message.get_srcSystem(), (-1.0, None)),
                                                (message.time_boot_ms / 1e3, message), key=lambda e: e[0])  # fmt: skip
    found = rows(replay.snapshot(speed=1.0))
    for sysid, (told_s, message) in last.items():
        assert found[sysid]["p_ned"] == pytest.approx((message.x, message.y, message.z), abs=1e-6)
        assert found[sysid]["age_s"] == pytest.approx(20.0 - told_s, abs=1e-6)


def test_the_end_shows_the_summarys_energies_losses_and_refuellings(session: Outcome, replay: Replay) -> None:
    replay.advance(replay.to_s, math.inf)
    snapshot = replay.snapshot(speed=1.0)
    found = rows(snapshot)
    for vehicle in session.summary["vehicles"]:
        energy = vehicle["energy"]
        expected = energy["initial_j"] + energy["received_j"] - energy["drawn_j"] - energy["given_j"]
        assert found[vehicle["sysid"]]["remaining_j"] == pytest.approx(expected)
        assert (found[vehicle["sysid"]]["role"], found[vehicle["sysid"]]["mode"]) == (
            vehicle["role"],
            vehicle["final_mode"],
        )
    assert sum(row["lost"] for row in found.values()) == session.summary["link"]["lost"] > 0
    served = [record for record in session.decisions if record["kind"] == "served"]
    assert len(served) >= 2
    assert [(h["receiver"], h["end_s"], h["energy_j"]) for h in snapshot["history"]] == [
        (record["receiver"], record["end_s"], record["energy_j"]) for record in served
    ]
    assert snapshot["phase"] == "ended"


def test_the_goals_pursuit_has_been_held_for_as_long_as_the_session_said(session: Outcome, replay: Replay) -> None:
    """As lines tell it, in whole seconds, cut off until there is enough and rounded from then on."""
    float_s = 1e-6
    said = re.findall(r"^ *([\d.]+) s of .* pursuit (\d+)(?: of 5)? s", session.stdout, re.MULTILINE)
    assert len(said) >= 2
    for t_s, held_s in said:
        replay.seek(float(t_s))
        goal = replay.snapshot(speed=1.0)["goal"]
        assert goal["pursue_for_s"] == 5.0
        least_s, most_s = (-0.5, 0.5) if float(held_s) >= 5.0 else (0.0, 1.0)
        assert least_s - float_s <= goal["pursue_held_s"] - float(held_s) <= most_s + float_s
    assert goal["pursue_held_s"] > 5.0


def test_a_service_under_way_is_shown_with_its_reason(session: Outcome, replay: Replay) -> None:
    begun = next(record for record in session.decisions if record["kind"] == "transfer")
    replay.advance(begun["t_s"] + 1.0, math.inf)
    snapshot = replay.snapshot(speed=1.0)
    service = snapshot["services"][0]
    assert (service["receiver"], service["tanker"], service["phase"]) == (begun["receiver"], 201, "transfer")
    assert "refuelled now" in service["why"]
    assert 0 < service["energy_j"] < 2500
    found = rows(snapshot)
    assert (found[begun["receiver"]]["state"], found[201]["state"]) == ("served", "serves")
    assert any(event["kind"] == "decision" for event in snapshot["events"])


def test_services_that_vehicles_decided_before_the_session_knew_have_the_summarys_times(
    session: Outcome, tmp_path: Path
) -> None:
    """As where they compete on board: the session notes decisions 0.1 s later, and one has not ended when it does."""
    folder = Path(shutil.copytree(session.folder, tmp_path / "flown"))
    lines = [json.loads(line) for line in (folder / "decisions.jsonl").read_text(encoding="utf-8").splitlines()]
    last = max(line["end_s"] for line in lines if line["kind"] == "served")
    lines = [line for line in lines if line["kind"] != "served" or line["end_s"] != last]
    for line in lines:
        line["t_s"] += 0.1 * (line["kind"] == "decided")
    (folder / "decisions.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    cut = next(row for row in summary["refuelling"] if row["end_s"] == last)
    cut["end_s"] = None
    (folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
    replay = Replay(folder)
    replay.advance(cut["decided_at_s"] + 0.05, math.inf)
    assert replay.snapshot(speed=1.0)["services"] == []
    replay.advance(replay.to_s, math.inf)
    snapshot = replay.snapshot(speed=1.0)
    told = {(row["receiver"], row["decided_at_s"]) for row in (*snapshot["history"], *snapshot["services"])}
    assert told == {(row["receiver"], row["decided_at_s"]) for row in summary["refuelling"]}
    assert len(snapshot["services"]) == 1


@pytest.mark.parametrize("killed", [False, True])
def test_services_whose_decisions_were_not_kept_are_shown(session: Outcome, tmp_path: Path, killed: bool) -> None:
    """The first part that was kept begins in the second service; a killed session left no summary of the first."""
    folder = Path(shutil.copytree(session.folder, tmp_path / "flown"))
    first, second, *_ = (record for record in session.decisions if record["kind"] == "served")
    begin_s = 0.5 * (second["start_s"] + second["end_s"])
    lines = (folder / DECISIONS).read_bytes().splitlines(keepends=True)
    kept = b"".join(line for line in lines if json.loads(line)["t_s"] >= begin_s)
    (folder / DECISIONS).write_bytes(b"")
    rotation.part(folder / DECISIONS, 2).write_bytes(kept)
    if killed:
        (folder / "summary.json").unlink()
    replay = Replay(folder)
    assert replay.problems == []
    replay.advance(begin_s, math.inf)
    (service,) = replay.snapshot(speed=1.0)["services"]
    told = {key: service[key] for key in ("receiver", "by", "decided_at_s", "bids")}
    assert told == {key: second[key] for key in ("receiver", "by", "decided_at_s", "bids")}
    assert service["why"].endswith("its decision is in no part of the recording that was kept.")
    replay.advance(replay.to_s, math.inf)
    history = replay.snapshot(speed=1.0)["history"]
    before = [] if killed else [(first["receiver"], first["end_s"], first["energy_j"], "the reason is not recorded")]
    left = [record for record in session.decisions if record["kind"] == "served" and record["t_s"] >= begin_s]
    assert [(row["receiver"], row["end_s"], row["energy_j"], row["reason"]) for row in history] == [
        *before,
        *((row["receiver"], row["end_s"], row["energy_j"], row["reason"]) for row in left),
    ]


@pytest.mark.parametrize("t_s", [0.0, 7.3, 24.0, 45.0])
def test_seeking_shows_what_playing_there_shows(session: Outcome, t_s: float) -> None:
    """Blocks much smaller than the log, so that what was known comes from the index and not from playing it all."""
    played, sought = (Replay(session.folder, block_bytes=1 << 14) for _ in range(2))
    played.advance(t_s, math.inf)
    sought.seek(45.0)
    sought.seek(t_s)
    there, here = played.snapshot(speed=1.0), sought.snapshot(speed=1.0)
    for sysid, row in rows(there).items():
        other = rows(here)[sysid]
        power_w = row.pop("power_w")
        assert other.pop("power_w") == (None if power_w is None else pytest.approx(power_w, rel=0.2, abs=15.0))
        derived = ("endurance_s", "trouble", "severity", "condition", "figure", "urgency", "lost_share")
        for key in derived:  # they follow from the draw, and from before
            row.pop(key), other.pop(key)
        assert other == row
    assert all(here[key] == there[key] for key in ("t_s", "services", "history", "competition", "goal", "traffic"))


def test_a_long_log_is_opened_and_sought_in_at_once(tmp_path: Path) -> None:
    """40 vehicles for ten minutes, 240,000 frames: a second of processor time is the promise."""
    sender = mav.MAVLink(None)
    stretch = []
    for tick in range(600):
        for sysid in range(1, 41):
            sender.srcSystem, sender.srcComponent, sender.seq = sysid, 1, tick % 256
            message: Any = mav.MAVLink_local_position_ned_message(100 * tick, float(tick), sysid, -2.0, 1.0, 0.0, 0.0)
            if tick % 10 == 0:
                message = mav.MAVLink_heartbeat_message(2, 12, 0x81, 6 << 16, 4, 3)
            stretch.append((tick, bytes(message.pack(sender))))
    path = tmp_path / "long.tlog"
    with path.open("wb") as file:
        for minute in range(10):
            file.write(b"".join(struct.pack(">Q", 10**15 + (600 * minute + t) * 100_000) + raw for t, raw in stretch))
    replay = Replay(path)
    for t_s in (599.0, 3.0, 300.0):
        begun_s = time.process_time()
        replay.seek(t_s)
        snapshot = replay.snapshot(speed=1.0)
        assert time.process_time() - begun_s < 1.0
        assert snapshot["t_s"] == t_s
        assert len(snapshot["vehicles"]) == 40


class Wall:
    """A clock that a test moves."""

    def __init__(self) -> None:
        self.now_s = 100.0

    def __call__(self) -> float:
        return self.now_s


def newest(source: ReplaySource) -> dict[str, Any]:
    return [dict(m) for m in source.receive() if m["type"] == "snapshot"][-1]


def test_speed_pause_and_seek_are_obeyed_and_orders_are_not(replay: Replay) -> None:
    wall = Wall()
    source = ReplaySource(replay, clock=wall, patience_s=math.inf)
    assert [m["type"] for m in source.receive()] == ["session", "snapshot"]
    wall.now_s += 2.0
    assert newest(source)["t_s"] == pytest.approx(2.0)
    source.send({"command": "speed", "speed": 4.0, "id": "a"})
    wall.now_s += 1.0
    messages = source.receive()
    assert messages[0] == {"type": "reply", "id": "a", "ok": True, "text": "The recording plays at x4."}
    assert messages[-1]["t_s"] == pytest.approx(6.0)
    source.send({"command": "pause"})
    wall.now_s += 5.0
    paused = newest(source)
    assert (paused["t_s"], paused["phase"]) == (pytest.approx(6.0), "paused")
    assert paused["replay"] == {"from_s": 0.0, "to_s": 45.0, "speed": 4.0, "paused": True}
    source.send({"command": "seek", "t_s": 1.5})
    wall.now_s += 0.2
    assert newest(source)["t_s"] == pytest.approx(1.5)
    source.send({"command": "seek", "t_s": "later"})
    source.send({"command": "speed", "speed": -1})
    source.send({"command": "land", "sysid": 1})
    replies = [m for m in source.receive() if m["type"] == "reply"]
    assert [reply["ok"] for reply in replies] == [False, False, False]
    assert "takes no command" in replies[2]["text"] or "take no command" in replies[2]["text"]


def test_it_plays_on_from_the_end_again(replay: Replay) -> None:
    wall = Wall()
    source = ReplaySource(replay, speed=100.0, clock=wall, patience_s=math.inf)
    source.receive()
    wall.now_s += 1.0
    assert newest(source)["phase"] == "ended"
    source.send({"command": "resume"})
    assert newest(source)["t_s"] == 0.0
    wall.now_s += 0.2
    assert newest(source)["t_s"] == pytest.approx(20.0)


def test_what_cannot_be_kept_up_with_is_played_as_fast_as_the_machine_can(replay: Replay) -> None:
    """No patience at all: each call plays some frames and returns, and nothing is left out."""
    wall = Wall()
    source = ReplaySource(replay, speed=1000.0, clock=wall, patience_s=0.0)
    times = [newest(source)["t_s"]]
    while not replay.ended:
        wall.now_s += 0.2
        times.append(newest(source)["t_s"])
    assert len(times) > 10
    assert times == sorted(times)
    assert times[-1] == 45.0


# strangers' logs and bad input


def record(t_us: int, message: Any, sysid: int, compid: int = 1, *, mavlink1: bool = False) -> bytes:
    sender = mav.MAVLink(None, srcSystem=sysid, srcComponent=compid)
    return struct.pack(">Q", t_us) + bytes(message.pack(sender, force_mavlink1=mavlink1))


def strangers() -> bytes:
    """An ArduCopter over MAVLink 1, told only in global positions, and the ground station that keeps the log."""
    parts = []
    for i in range(80):
        t_us = 10**15 + 100_000 * i
        if i % 10 == 0:
            parts.append(record(t_us, mav.MAVLink_heartbeat_message(2, 3, 0x81, 3, 4, 3), 3, mavlink1=True))
            parts.append(record(t_us, mav.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3), 255, 230))
        place = mav.MAVLink_global_position_int_message(100 * i, 470_000_000 + 100 * i, 80_000_000, 410_000, 10_000,
                                                        1113, 0, 0, 0)  # fmt: skip
        parts.append(record(t_us, place, 3, mavlink1=True))
    return b"".join(parts)


def test_a_strangers_log_plays_without_a_word_of_configuration(tmp_path: Path) -> None:
    """1e-4 degrees of latitude a second are 11.1 m/s north. Its place is the origin once it has told no other."""
    (tmp_path / "flight.tlog").write_bytes(strangers())
    replay = Replay(tmp_path / "flight.tlog")
    replay.advance(7.9, math.inf)
    found = rows(replay.snapshot(speed=1.0))
    assert found.keys() == {3}
    assert (found[3]["mode"], found[3]["autopilot"], found[3]["landed"]) == ("mission", "ardupilot", False)
    assert found[3]["p_ned"][0] == pytest.approx((7.9 - 3.0) * 11.12, abs=0.1)
    assert found[3]["height_m"] == pytest.approx(10.0, abs=0.01)


@pytest.fixture
def changes(tmp_path: Path) -> Path:
    """A .tlog of 8 s of a PX4 that changes its mode (Hold, Takeoff, Offboard) at 2.43 and at 2.71 s."""
    parts = []
    for t_ms in sorted({*range(0, 8001, 100), 2430, 2710}):
        mode = 3 << 24 | 4 << 16 if t_ms < 2430 else 2 << 24 | 4 << 16 if t_ms < 2710 else 6 << 16
        parts.append(record(10**15 + 1000 * t_ms, mav.MAVLink_heartbeat_message(2, 12, 0x81, mode, 4, 3), 1))
    (tmp_path / "changes.tlog").write_bytes(b"".join(parts))
    return tmp_path / "changes.tlog"


@pytest.mark.parametrize("step_s", [0.13, 0.5, 6.0])
def test_changes_are_found_at_the_recordings_own_times_however_seldom_it_is_shown(changes: Path, step_s: float) -> None:
    """The next tenth of a second after each."""
    wall, replay = Wall(), Replay(changes)
    source = ReplaySource(replay, clock=wall, patience_s=math.inf)
    events = []
    while not replay.ended:
        events += [e for message in source.receive() for e in message.get("events", ())]
        wall.now_s += step_s
    found = [(event["t_s"], event["text"]) for event in events if event["kind"] == "mode"]
    assert found == [(2.5, "Hold -> Takeoff"), (2.8, "Takeoff -> Offboard")]


def test_what_a_replay_writes_is_the_same_at_each_speed(changes: Path) -> None:
    for form in ("--plain", "--json"):
        written = [
            gcs("replay", str(changes), form, *more).stdout for more in ((), ("--speed", "1000"), ("--speed", "40"))
        ]
        assert written[1:] == written[:1] * 2
    times = [line["t_s"] for line in map(json.loads, written[0].splitlines()) if line["type"] == "snapshot"]
    assert times == [float(t_s) for t_s in range(9)]


def test_a_cut_log_and_foreign_bytes_are_said_and_the_rest_is_played(tmp_path: Path) -> None:
    whole = strangers()
    (tmp_path / "cut.tlog").write_bytes(whole[:400] + b"boot console text" + whole[400:-7])
    played = gcs("replay", str(tmp_path / "cut.tlog"), "--json")
    assert played.returncode == 0
    assert "belong to no MAVLink frame" in played.stderr
    assert "ends inside a frame" in played.stderr
    lines = [json.loads(line) for line in played.stdout.splitlines()]
    assert lines[0]["type"] == "session"
    assert lines[-1]["phase"] == "ended"
    assert lines[-1]["t_s"] == pytest.approx(7.8)


@pytest.mark.parametrize(
    ("name", "content", "word"),
    [
        ("empty.tlog", b"", "empty"),
        ("words.tlog", b"These are no frames. " * 40, "no tlog"),
        ("nowhere", None, "does not exist"),
    ],
)
def test_what_is_no_recording_is_refused_in_a_sentence(
    tmp_path: Path, name: str, content: bytes | None, word: str
) -> None:
    if content is not None:
        (tmp_path / name).write_bytes(content)
    refused = gcs("replay", str(tmp_path / name), "--plain")
    assert refused.returncode == 2
    assert word in refused.stderr
    assert "Traceback" not in refused.stderr


def test_a_folder_with_files_missing_plays_what_it_has_and_says_what_it_lacks(session: Outcome, tmp_path: Path) -> None:
    (tmp_path / "session.tlog").symlink_to(session.folder / "session.tlog")
    bare = Replay(tmp_path)
    assert any("scenario.yaml" in problem for problem in bare.problems)
    bare.advance(30.0, math.inf)
    found = rows(bare.snapshot(speed=1.0))
    assert {row["role"] for row in found.values()} == {"copter"}
    (tmp_path / "scenario.yaml").symlink_to(session.folder / "scenario.yaml")
    half = Replay(tmp_path)
    assert half.problems == [f"{tmp_path} has no decisions.jsonl: decisions are not shown."]
    (tmp_path / "session.tlog").unlink()
    with pytest.raises(ReplayError, match=r"no session\.tlog"):
        Replay(tmp_path)


def test_a_file_that_is_there_and_no_scenario_is_told_from_one_that_is_not_there(
    session: Outcome, tmp_path: Path
) -> None:
    (tmp_path / "session.tlog").symlink_to(session.folder / "session.tlog")
    assert [problem.partition(":")[0] for problem in Replay(tmp_path).problems] == [f"{tmp_path} has no scenario.yaml"]
    (tmp_path / "scenario.yaml").write_text("vehicles: [")
    (problem,) = Replay(tmp_path).problems
    assert problem.startswith(f"{tmp_path / 'scenario.yaml'} is no scenario (1:")
    told = gcs("replay", str(tmp_path), "--plain")
    assert (told.stdout + told.stderr).count("is no scenario") == 1


def test_decisions_passed_on_the_way_to_a_later_time_are_told_and_no_later_ones(
    session: Outcome, replay: Replay
) -> None:
    source = ReplaySource(replay)
    source.receive()
    source.send({"command": "pause"})
    source.send({"command": "seek", "t_s": 30.0})
    told = [event for message in source.receive() for event in message.get("events", ())]
    decided = [event["t_s"] for event in told if event["kind"] == "decision"]
    kinds = ("decided", "transfer", "served", "broken off", "safety")
    made = [record["t_s"] for record in session.decisions if record["kind"] in kinds]
    assert decided == [t_s for t_s in made if t_s <= 30.0]
    replay.seek(30.0, reported_s=-math.inf)  # as `--from` does it
    assert [event["t_s"] for event in replay.snapshot(speed=1.0)["events"] if event["kind"] == "decision"] == decided
    contest = replay.session()["contest"]
    assert contest[-1][0] < 30.0
    assert all(replay._timeline._competition_at(t_s).v == {int(k): x for k, x in v.items()} for t_s, v in contest)
    source.send({"command": "seek", "t_s": 20.0})
    again = [event for message in source.receive() for event in message.get("events", ())]
    assert not [event for event in again if event["kind"] == "decision"]


# the command


def test_lines_tell_the_session_without_waiting_for_it(session: Outcome) -> None:
    told = gcs("replay", str(session.folder), "--plain", "--from", "10")
    assert told.returncode == 0
    assert "Refuelling of 1 by 201 ended" in told.stdout or "Refuelling of 2 by 201 ended" in told.stdout
    assert told.stdout.splitlines()[-1].lstrip().startswith("45.0 s of 45 s | ended | ")
    first = float(told.stdout.split()[0])
    assert first >= 10.0
    beyond = gcs("replay", str(session.folder), "--plain", "--from", "46")
    assert beyond.returncode == 2
    assert "from 0 to 45 s" in " ".join(beyond.stderr.split())


def test_a_terminal_gets_the_console(session: Outcome) -> None:
    """A real pseudo-terminal; the console draws there, and `q` or Ctrl-C ends it."""
    ours, theirs = pty.openpty()
    environment = {**os.environ, "TERM": "xterm-256color", "COLUMNS": "100", "LINES": "30"}
    process = subprocess.Popen(
        [*GCS, "replay", str(session.folder)], stdin=theirs, stdout=theirs, stderr=theirs, env=environment
    )
    os.close(theirs)
    drawn = b""
    try:
        deadline_s = time.monotonic() + 30.0
        while b"\x1b[?1049h" not in drawn:
            ready, _, _ = select.select([ours], [], [], max(deadline_s - time.monotonic(), 0.0))
            assert ready, drawn
            drawn += os.read(ours, 65536)
    finally:
        process.kill()
        process.wait()
        os.close(ours)
