"""Processes: deaths are told at once and by name, and nothing outlives its session, whoever is killed."""

from __future__ import annotations

import contextlib
import json
import os
import pty
import signal
import subprocess
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import pytest
import yaml
from sessions import GCS, Outcome, Running, all_gone, fly, fly_apart, merged, run_words, small
from small_disk import run_on_small_disk

from gcs.cli.main import run_argv
from gcs.recording.reserve import PER_SESSION_BYTES, PER_VEHICLE_BYTES

PACED = {"clock": {"mode": "real", "speed": 5.0}, "goal": {"duration_s": 300.0, "refuelled_at_least": 0}}


@pytest.fixture
def running(tmp_path: Path) -> Iterator[Running]:
    session = Running(merged(small(), PACED), tmp_path, "--json")
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
    victim = running.vehicle(1)
    victim.send_signal(signal.SIGKILL)
    told = running.wait_for(lambda s: any(e["sysid"] == 1 and e["kind"] == "death" for e in s["events"]))
    (event,) = (e for e in told["events"] if e["sysid"] == 1 and e["kind"] == "death")
    assert event["level"] == "critical"
    assert "pursuer 1" in event["text"]
    assert "signal 9" in event["text"]
    later = running.wait_for(lambda s: s["t_s"] > told["t_s"] + 2.0)
    alive = {v["sysid"]: v["alive"] for v in later["vehicles"]}
    assert alive == {1: False, 101: True, 201: True}
    running.process.send_signal(signal.SIGINT)
    outcome = running.finish()
    assert outcome.status == 130
    assert outcome.vehicle(1)["final_mode"] == "dead"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
@pytest.mark.parametrize("written", [False, True])
def test_a_folder_that_nothing_was_written_to_is_removed_by_a_signal(
    written: bool, number: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    request: pytest.FixtureRequest,
) -> None:  # fmt: skip
    scenario, folder = tmp_path / "small.yaml", tmp_path / "out"
    scenario.write_text(yaml.safe_dump(small()), encoding="utf-8")

    def interrupt(*_: object, **__: object) -> None:
        assert (folder / "vehicles").is_dir()
        if written:
            (folder / "scenario.yaml").write_text("name: small", encoding="utf-8")
        signal.raise_signal(number)

    monkeypatch.setattr("gcs.cli.run._view", interrupt)  # before the supervisor, which writes to the folder
    request.addfinalizer(partial(signal.signal, signal.SIGHUP, signal.getsignal(signal.SIGHUP)))
    signal.signal(signal.SIGHUP, signal.SIG_DFL)  # `nohup` has it ignored
    before = [signal.getsignal(one) for one in (signal.SIGTERM, signal.SIGHUP)]
    assert run_argv(["run", str(scenario), "--plain", "--out", str(folder)]) == 128 + number
    assert [signal.getsignal(one) for one in (signal.SIGTERM, signal.SIGHUP)] == before
    assert folder.exists() is written
    stands = f"interrupted; what was written by then stands in {folder}"
    removed = f"interrupted before the session began; its folder {folder} is removed"
    assert capsys.readouterr().err.rstrip() == f"gcs: {stands if written else removed}"


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


def test_a_terminal_that_is_closed_ends_the_session_and_saves_it(tmp_path: Path) -> None:
    """It sends SIGHUP and takes no line more."""
    words = run_words(merged(small(), PACED), tmp_path, "--plain", report=True)
    ours, theirs = pty.openpty()
    own = ["env", "--default-signal=HUP", "setsid", "--ctty"]  # `nohup` has it ignored
    with subprocess.Popen([*own, *GCS, *words], stdin=theirs, stdout=theirs, stderr=theirs) as process:
        os.close(theirs)
        shown = b""
        while b"Offboard" not in shown:
            shown += os.read(ours, 65536)
        os.close(ours)
    assert process.returncode == 129
    assert json.loads((tmp_path / "session" / "summary.json").read_text())["outcome"] == "interrupted"
    assert (tmp_path / "session" / "report.html").is_file()


def the_supervisor(session: Running) -> psutil.Process:
    return session.named("gcs.session.process")


def the_fork_server(session: Running) -> psutil.Process:
    return session.named("fork-server")


HANGS = """
from pathlib import Path

class Hangs:
    def __init__(self, scenario):
        pass

    def plan(self, vehicle, situation):
        if situation.time_s < 6.0:
            return vehicle.p_now_ned(), (0.0, 0.0, 0.0)
        Path(__file__).with_name("asked").touch()
        return sum(range(10**13))
"""


def hanging(folder: Path, **changes: Any) -> Path:
    """A scenario whose planner hangs in compiled code from 6 s on."""
    (folder / "hanging.py").write_text(HANGS)
    scenario = folder / "scenario.yaml"
    scenario.write_text(yaml.safe_dump(small(planner="hanging:Hangs", refuelling={"enabled": False}, **changes)))
    return scenario


@pytest.mark.slow
def test_a_planner_that_hangs_in_compiled_code_is_ended_and_named_and_its_pursuers_are_held(tmp_path: Path) -> None:
    """In lockstep the session goes on, the same each time, and its status tells."""
    goal = {"duration_s": 11.0, "refuelled_at_least": 0}
    digests = set()
    for folder in (tmp_path / "first", tmp_path / "second"):
        folder.mkdir()
        outcome = fly(yaml.safe_load(hanging(folder, goal=goal).read_text()), folder, "--plain")
        digests.add(outcome.summary["digest"])
    assert len(digests) == 1
    assert outcome.status == 1, outcome.stderr
    said = "planner hanging:Hangs did not answer within 3 s at hanging.py:12 in plan and was ended"
    assert f"{said}; its pursuers are held" in outcome.stdout
    assert outcome.stdout.count("and was ended; its") == 1
    (part,) = outcome.summary["unmet"]
    assert (part["part"], part["reached"]) == ("plugins", f"failed ({said} at {part['t_s']:.1f} s)")
    assert [d["sysid"] for d in outcome.decisions if d["kind"] == "policy failed"] == [0]
    truth = outcome.truth(1)
    assert np.ptp(truth.p_ned[truth.time_s > 7.0], axis=0).max() < 0.3
    assert outcome.vehicle(1)["final_mode"] == "offboard"
    assert outcome.summary["completed"]


def the_plugins(run: psutil.Process) -> psutil.Process:
    return next(p for p in run.children(recursive=True) if p.cmdline()[0] == "gcs plug-ins")


def the_owner(run: psutil.Process) -> psutil.Process:
    parent = the_plugins(run).parent()
    assert parent is not None
    return parent


@pytest.mark.parametrize(
    ("victim", "number", "status"),
    [
        (the_owner, signal.SIGKILL, 70),
        (the_plugins, signal.SIGKILL, 1),
        (lambda run: run, signal.SIGINT, 130),
    ],
    ids=["kill the supervisor", "kill the plug-in", "Ctrl-C"],
)
def test_nothing_is_left_of_a_session_whose_planner_hangs(
    victim: Callable[[psutil.Process], psutil.Process], number: int, status: int, tmp_path: Path
) -> None:
    """While it hangs, before its deadline."""
    name = hanging(tmp_path, goal={"duration_s": 12.0, "refuelled_at_least": 0}).name
    command = [*GCS, "run", name, "--trust", "--lockstep", "--plain", "--no-report", "--out", "session"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as run:
        process = psutil.Process(run.pid)
        while not (tmp_path / "asked").exists():
            assert run.poll() is None
            all_gone([process], within_s=0.05)
        family = [process, *process.children(recursive=True)]
        victim(process).send_signal(number)
        assert not all_gone(family)
    assert run.returncode == status


def test_the_supervisor_saves_the_session_when_its_parent_is_killed_and_nothing_outlives_it(running: Running) -> None:
    family = running.family()
    assert len(family) == 1 + 1 + 1 + 3
    running.process.send_signal(signal.SIGKILL)
    assert not all_gone(family)
    outcome = running.finish()
    assert outcome.summary["outcome"] == "interrupted"
    assert_tlog_is_whole(outcome)


def test_a_killed_fork_server_is_said_in_one_sentence_and_nothing_outlives_it(running: Running) -> None:
    family = running.family()
    the_fork_server(running).send_signal(signal.SIGKILL)
    outcome = running.finish()
    assert not all_gone(family)
    assert outcome.status == 1
    assert json.loads(outcome.stdout.splitlines()[-1])["outcome"] == outcome.summary["outcome"] == "lost"
    assert "fork server" in outcome.stderr
    assert "Traceback" not in outcome.stderr


def last_s(outcome: Outcome) -> float:
    """The session time of the last recorded frame."""
    return max(t_s for t_s, _ in outcome.messages())


def test_a_killed_supervisor_is_said_in_one_sentence_and_loses_no_more_than_the_tick_it_was_at(tmp_path: Path) -> None:
    """Vehicles write what they flew before they answer: that is at most what was granted after the last record."""
    period_s = 0.1
    session = Running(small(goal={"duration_s": 600.0}), tmp_path, "--json")
    try:
        session.wait_for(lambda s: s["t_s"] > 20.0)
        family = session.family()
        the_supervisor(session).send_signal(signal.SIGKILL)
        outcome = session.finish()
    finally:
        session.stop()
    assert not all_gone(family)
    assert outcome.status == 70
    assert str(outcome.folder) in outcome.stderr
    assert "Traceback" not in outcome.stderr
    flown_s = max(float(outcome.truth(sysid).time_s[-1]) for sysid in (1, 101, 201))
    assert flown_s > 20.0
    assert last_s(outcome) >= flown_s - 2.0 * period_s - 1e-6
    lines = (outcome.folder / "decisions.jsonl").read_bytes().split(b"\n")
    assert max(json.loads(line)["t_s"] for line in lines[:-1]) >= flown_s - 2.0 * period_s - 1e-6


def test_a_supervisor_that_hangs_and_is_ended_unsaved_is_said_so(running: Running) -> None:
    the_supervisor(running).suspend()
    running.process.terminate()
    assert running.process.stderr is not None
    assert any("twice more ends it unsaved" in line for line in running.process.stderr)
    for number in (signal.SIGINT, signal.SIGTERM):  # two of one kind at once may be one
        running.process.send_signal(number)
    outcome = running.finish()
    assert outcome.status == 143
    assert f"the supervisor of {outcome.folder} was killed by signal 9 before the session's end" in outcome.stderr
    assert not (outcome.folder / "summary.json").exists()


def test_a_supervisor_that_is_told_to_end_saves_the_session(running: Running) -> None:
    family = running.family()
    the_supervisor(running).send_signal(signal.SIGTERM)
    outcome = running.finish()
    assert outcome.status == 130
    assert outcome.summary["outcome"] == "interrupted"
    assert any("SIGTERM" in str(event["text"]) for event in events(outcome.stdout))
    assert_tlog_is_whole(outcome)
    assert not all_gone(family)


def stopped_at(line: str, tmp_path: Path) -> tuple[Outcome, str]:
    """A session stopped by Ctrl-C, and stopped again as soon as a line has begun so; the lines after that one."""
    content = small(goal={"duration_s": 3000.0}, clock={"mode": "real", "speed": 5.0})
    session = Running(content, tmp_path, "--plain", report=True)
    try:
        next(said for said in session.lines() if "Offboard" in said)
        family = session.family()
        session.process.send_signal(signal.SIGINT)
        next(said for said in session.lines() if said.startswith(line))
        session.process.send_signal(signal.SIGINT)
        outcome = session.finish()
    finally:
        session.stop()
    assert not all_gone(family)
    assert outcome.status == 130
    assert outcome.summary["outcome"] == "interrupted"
    assert_tlog_is_whole(outcome)
    assert "Traceback" not in outcome.stderr
    assert not [path.name for path in outcome.folder.iterdir() if path.name.startswith(".")]
    return outcome, outcome.stderr


def test_a_second_ctrl_c_leaves_out_the_report_and_nothing_else(tmp_path: Path) -> None:
    outcome, said = stopped_at("saved; making the report", tmp_path)
    assert f"gcs report {outcome.folder} makes it" in said
    assert not (outcome.folder / "report.html").exists()


def test_ctrl_c_after_the_last_line_changes_nothing(tmp_path: Path) -> None:
    outcome, said = stopped_at("report: ", tmp_path)
    assert not said.strip()
    assert (outcome.folder / "report.html").stat().st_size > 0


def test_a_vehicle_that_may_not_arm_says_so_once(tmp_path: Path) -> None:
    content = small(goal={"duration_s": 60.0, "refuelled_at_least": 0})
    content["vehicles"]["pursuers"][0]["battery"] = {"capacity_j": 24000, "initial_percent": 2}
    outcome = fly(content, tmp_path, "--plain")
    assert outcome.stdout.count("Arming refused") == 1
    asked = [t_s for t_s, m in outcome.messages("COMMAND_LONG") if (m.target_system, m.command) == (1, 400)]
    assert len(asked) == 6  # at 0, 1, 3, 7, 15 and 31 s


def test_a_vehicle_that_cannot_start_is_named_with_its_last_lines_and_there_is_no_report(tmp_path: Path) -> None:
    content = small()
    content["vehicles"]["pursuers"][0]["params"] = {"SIM_GAIN_RATE": 600.0}  # only the vehicle knows its law
    outcome = fly_apart(content, tmp_path, "--plain", report=True)
    assert outcome.status != 0
    assert "report" not in outcome.stdout + outcome.stderr
    assert not (outcome.folder / "report.html").exists()
    assert "pursuer 1" in outcome.stderr
    assert "gains.rate is 600.0" in outcome.stderr
    assert "Traceback" not in outcome.stderr


def on_a_disk_of(size_kib: int, tmp_path: Path) -> Outcome:
    """A session on a disk of its own."""
    (tmp_path / "scenario.yaml").write_text(yaml.safe_dump(small(goal={"duration_s": 300.0})), encoding="utf-8")
    script = '"$@"; status=$?; cp -r disk/session session; exit $status'
    flown = [*GCS, "run", "scenario.yaml", "--plain", "--out", "disk/session"]
    done = run_on_small_disk(f"{size_kib}k", script, flown, tmp_path)
    assert "no space left on device" in done.stderr.lower()
    assert "give --out another place" in done.stderr
    assert "Traceback" not in done.stderr
    return Outcome(done.returncode, tmp_path / "session", done.stdout, done.stderr)


def test_on_a_full_disk_nothing_is_flown(tmp_path: Path) -> None:
    outcome = on_a_disk_of(40, tmp_path)
    assert outcome.status == 2
    assert "gcs: disk/session cannot be written: No space left on device; give --out another place" in outcome.stderr
    assert (outcome.folder / "session.tlog").stat().st_size == 0
    assert not (outcome.folder / "summary.json").exists()


def test_on_a_disk_that_fills_there_is_room_for_what_the_session_came_to(tmp_path: Path) -> None:
    outcome = on_a_disk_of(400, tmp_path)
    assert outcome.status == 1
    assert outcome.summary["outcome"] == "interrupted"
    assert outcome.summary["sim_time_s"] > 1.0
    assert_tlog_is_whole(outcome)


def reserved_bytes(supervisor: psutil.Process) -> int:
    """What the supervisor keeps of the disk for its last words: the file without a name."""
    for fd in Path(f"/proc/{supervisor.pid}/fd").iterdir():
        with contextlib.suppress(OSError):
            if "/.reserve." in os.readlink(fd):
                return fd.stat().st_size
    return 0


def test_room_for_the_summary_grows_with_each_refuelling(tmp_path: Path) -> None:
    session = Running(small(clock={"mode": "real", "speed": 5.0}, goal={"duration_s": 300.0}), tmp_path, "--json")
    try:
        session.wait_for(lambda s: s["refuelled"] >= 1)
        assert reserved_bytes(session.named("gcs.session.process")) > PER_SESSION_BYTES + 3 * PER_VEHICLE_BYTES
    finally:
        session.stop()


def test_a_full_disk_stops_the_session_with_closed_files(tmp_path: Path) -> None:
    outcome = fly_apart(small(truth=False), tmp_path, "--plain", file_limit=200_000)
    assert outcome.status == 1
    assert "session.tlog" in outcome.stderr
    assert "Traceback" not in outcome.stderr
    assert_tlog_is_whole(outcome)
    assert not (outcome.folder / "session.sock").exists()
