"""Processes: deaths are told at once and by name, and nothing outlives its session, whoever is killed."""

from __future__ import annotations

import json
import signal
from collections.abc import Callable, Iterator
from pathlib import Path

import psutil
import pytest
from sessions import Outcome, Running, all_gone, demo, fly, merged, small

PACED = {"clock": {"mode": "real", "speed": 5.0}, "goal": {"duration_s": 300.0, "refuelled_at_least": 0}}


@pytest.fixture
def running(tmp_path: Path) -> Iterator[Running]:
    session = Running(merged(demo(), PACED), tmp_path, "--json")
    try:
        session.wait_for(lambda s: s["t_s"] > 4.0)
        yield session
    finally:
        family = session.family() if session.process.poll() is None else []
        session.stop()
        assert not all_gone(family)


def events(stdout: str) -> list[dict[str, object]]:
    lines = [json.loads(line) for line in stdout.splitlines()]
    return [event for line in lines if line["type"] == "snapshot" for event in line["events"]]


def assert_tlog_is_whole(outcome: Outcome) -> None:
    """pymavlink reads it to the end, and the last frame is the last byte."""
    read = sum(8 + len(m.get_msgbuf()) for _, m in outcome.messages())
    assert read == (outcome.folder / "session.tlog").stat().st_size > 0


def test_a_killed_vehicle_is_named_and_the_others_fly_on(running: Running) -> None:
    victim = running.vehicle(3)
    victim.send_signal(signal.SIGKILL)
    told = running.wait_for(lambda s: any(e["sysid"] == 3 and e["level"] == "critical" for e in s["events"]))
    (event,) = (e for e in told["events"] if e["sysid"] == 3 and e["level"] == "critical")
    assert "pursuer 3" in event["text"]
    assert "signal 9" in event["text"]
    later = running.wait_for(lambda s: s["t_s"] > told["t_s"] + 2.0)
    alive = {v["sysid"]: v["alive"] for v in later["vehicles"]}
    assert alive == {1: True, 2: True, 3: False, 4: True, 5: True, 101: True, 201: True}
    running.process.send_signal(signal.SIGINT)
    outcome = running.finish()
    assert outcome.status == 130
    assert outcome.vehicle(3)["final_mode"] == "dead"


def test_ctrl_c_saves_what_was_flown_and_leaves_nobody(running: Running) -> None:
    family = running.family()
    running.process.send_signal(signal.SIGINT)
    outcome = running.finish()
    assert outcome.status == 130
    assert outcome.summary["outcome"] == "interrupted"
    assert outcome.summary["completed"] is False
    assert not all_gone(family)
    assert_tlog_is_whole(outcome)
    assert not (outcome.folder / "session.sock").exists()


def the_run(session: Running) -> psutil.Process:
    return psutil.Process(session.process.pid)


def the_supervisor(session: Running) -> psutil.Process:
    return session.named("gcs.supervise")


def the_hatch(session: Running) -> psutil.Process:
    return session.named("hatch")


@pytest.mark.parametrize("victim", [the_run, the_supervisor, the_hatch])
def test_nothing_outlives_a_killed_process(running: Running, victim: Callable[[Running], psutil.Process]) -> None:
    family = running.family()
    assert len(family) == 1 + 1 + 1 + 8
    victim(running).send_signal(signal.SIGKILL)
    assert not all_gone(family)


def test_the_supervisor_saves_the_session_when_its_parent_is_killed(running: Running) -> None:
    supervisor = the_supervisor(running)
    running.process.send_signal(signal.SIGKILL)
    assert not all_gone([supervisor])
    outcome = running.finish()
    assert outcome.summary["outcome"] == "interrupted"
    assert_tlog_is_whole(outcome)


def test_a_killed_hatch_is_said_in_one_sentence(running: Running) -> None:
    the_hatch(running).send_signal(signal.SIGKILL)
    outcome = running.finish()
    assert outcome.status == 1
    assert "hatch" in outcome.stderr
    assert "Traceback" not in outcome.stderr


def test_a_killed_supervisor_is_said_in_one_sentence(running: Running) -> None:
    the_supervisor(running).send_signal(signal.SIGKILL)
    outcome = running.finish()
    assert outcome.status == 70
    assert str(outcome.folder) in outcome.stderr
    assert "Traceback" not in outcome.stderr


def test_a_vehicle_that_cannot_start_is_named_with_its_last_lines(tmp_path: Path) -> None:
    content = small()
    content["vehicles"]["pursuers"][0]["params"] = {"MPC_TKO_SPEED": 99.0}
    outcome = fly(content, tmp_path, "--plain")
    assert outcome.status != 0
    assert "pursuer 1" in outcome.stderr
    assert "MPC_TKO_SPEED" in outcome.stderr
    assert "Traceback" not in outcome.stderr


def test_a_full_disk_stops_the_session_with_closed_files(tmp_path: Path) -> None:
    outcome = fly(small(truth=False), tmp_path, "--plain", file_limit=200_000)
    assert outcome.status == 1
    assert "session.tlog" in outcome.stderr
    assert "Traceback" not in outcome.stderr
    assert_tlog_is_whole(outcome)
    assert not (outcome.folder / "session.sock").exists()
