"""Spawned sessions: the digest of a session of its own, whatever died before it, and nothing left behind."""

from __future__ import annotations

import contextlib
import json
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from multiprocessing.connection import Connection
from pathlib import Path

import psutil
import pytest
from patience import PATIENCE_S
from sessions import all_gone, small

import gcs
from gcs.campaign.flight import Flight, fly
from gcs.processes.spawned import SpawnedProcess
from gcs.scenario.file import find, load
from gcs.scenario.model import Scenario
from gcs.session.spawning.spawner import SessionSpawner


def example(duration_s: float) -> Scenario:
    return load(find("paper/example1"), set={"goal.duration_s": duration_s}).flown(lockstep=True)


def digest(folder: Path) -> str:
    return str(json.loads((folder / "summary.json").read_text(encoding="utf-8"))["digest"])


def title(process: psutil.Process) -> str:
    try:
        return " ".join(process.cmdline()).strip()
    except psutil.NoSuchProcess:
        return ""


def processes(sessions: SessionSpawner) -> list[psutil.Process]:
    """The fork servers and all that they have forked."""
    servers = [psutil.Process(pid) for pid in sessions.pids]
    return [*servers, *(child for server in servers for child in server.children(recursive=True))]


def supervisor(sessions: SessionSpawner) -> psutil.Process:
    """The supervisor that flies, once its vehicles are there."""
    deadline_s = time.monotonic() + PATIENCE_S
    while time.monotonic() < deadline_s:
        named = {title(child): child for child in processes(sessions)}
        if "gcs session" in named and "simvehicle 5" in named:
            return named["gcs session"]
    raise AssertionError("no supervisor came up")


def test_a_spawned_session_is_that_of_a_session_of_its_own_also_after_a_supervisor_was_killed(tmp_path: Path) -> None:
    with gcs.Session(example(4.0), out=tmp_path / "alone") as alone:
        alone.finish()
    ended: list[Flight] = []
    with SessionSpawner() as sessions:
        first = fly(sessions, example(4.0), "first")
        flying = threading.Thread(target=lambda: ended.append(fly(sessions, example(80_000.0), "killed")))
        flying.start()
        supervisor(sessions).kill()
        flying.join()
        assert ended[0].error == "the supervisor was killed by signal 9 before the session's end"
        second = fly(sessions, example(4.0), "second")
        limited = fly(sessions, example(80_000.0), "limited", wall_limit_s=1.0)
        third = fly(sessions, example(4.0), "third")
        assert limited.error == "it took longer than 1 s of wall time and was ended"
        assert [flight.error for flight in (first, second, third)] == [None] * 3
        assert {digest(flight.folder) for flight in (first, second, third)} == {digest(tmp_path / "alone")}
        assert first.cpu_s > 0.0
        folder, started = first.folder.parent, processes(sessions)
        first.complete()
        assert load(first.folder / "scenario.yaml") == example(4.0)
    assert not folder.exists()
    assert not [process for process in started if process.is_running()]


def test_sessions_of_python_are_forked_from_one_spawner_and_are_those_of_their_own(tmp_path: Path) -> None:
    with gcs.Session(example(4.0), out=tmp_path / "alone") as alone:
        alone.finish()
    with SessionSpawner() as spawner:
        before = processes(spawner)
        for name in ("first", "second"):
            with gcs.Session(example(4.0), out=tmp_path / name, spawner=spawner) as session:
                session.step()
                with pytest.raises(gcs.SessionError, match="one session at a time"):
                    gcs.Session(example(4.0), out=tmp_path / f"beside {name}", spawner=spawner).__enter__()
                assert not (tmp_path / f"beside {name}").exists()
                assert session.finish().digest == digest(tmp_path / "alone")
        assert processes(spawner) == before
    assert not [process for process in before if process.is_running()]
    with pytest.raises(gcs.SessionError, match="the spawner has ended"):
        gcs.Session(example(4.0), spawner=spawner).__enter__()
    files = [sorted(str(path.relative_to(root)) for path in root.rglob("*")) for root in (
        tmp_path / "alone", tmp_path / "first")]  # fmt: skip
    assert files[0] == files[1]


def test_own_objects_answer_in_a_spawned_session(tmp_path: Path) -> None:
    asked: list[int] = []

    class First:
        def choose(self, request: gcs.RefuellingRequest) -> int:
            asked.append(request.candidates[0].sysid)
            return asked[-1]

    digests = []
    with SessionSpawner() as spawner:
        for name in ("first", "second"):
            scenario = gcs.Scenario.model_validate(small())
            with gcs.Session(scenario, policy=First(), out=tmp_path / name, spawner=spawner) as session:
                digests.append(session.finish().digest)
    assert set(asked) == {1}
    assert digests[0] == digests[1]


PROGRAM = """
import os, sys, signal, gcs
with gcs.SessionSpawner() as spawner:
    with gcs.Session(sys.argv[1], lockstep=True, out=sys.argv[2], spawner=spawner) as session:
        session.step()
        fork = os.fork() if "fork" in sys.argv else 1
        if fork:
            print(*spawner.pids, spawner.folder, fork, flush=True)
        signal.pause()
"""


@pytest.mark.parametrize("forked", [[], ["fork"]])
def test_a_program_that_is_killed_leaves_a_saved_session_and_no_process(forked: list[str], tmp_path: Path) -> None:
    """Also where a fork of it lives on."""
    with subprocess.Popen(
        [sys.executable, "-c", PROGRAM, "demo", str(tmp_path / "session"), *forked], stdout=subprocess.PIPE, text=True
    ) as program:
        assert program.stdout is not None
        *pids, folder, fork = program.stdout.readline().split()
        servers = [psutil.Process(int(pid)) for pid in pids]
        family = [*servers, *(child for server in servers for child in server.children(recursive=True))]
        program.kill()
        assert not all_gone(family)
        if forked:
            os.kill(int(fork), signal.SIGKILL)
    summary = json.loads((tmp_path / "session" / "summary.json").read_text(encoding="utf-8"))
    with gcs.Session("demo", lockstep=True, out=tmp_path / "stopped") as stopped:
        stopped.step()
        assert summary["sim_time_s"] == stopped.stop().sim_time_s, "it was not flown on without its program"
    assert summary["outcome"] == "interrupted"
    assert not Path(folder).exists()


def test_a_start_that_is_interrupted_leaves_nothing_to_the_next_session(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(_: SpawnedProcess) -> int:
        raise KeyboardInterrupt

    with SessionSpawner() as spawner:
        session = gcs.Session(example(4.0), out=tmp_path / "interrupted", spawner=spawner)
        with monkeypatch.context() as patch:
            patch.setattr(SpawnedProcess, "_forked", interrupted)
            with pytest.raises(KeyboardInterrupt):
                session.__enter__()
        for name in ("first", "second"):
            with gcs.Session(example(4.0), out=tmp_path / name, spawner=spawner) as session:
                assert session.finish().outcome == "met"


def test_a_spawner_that_is_closed_in_flight_lets_the_session_save_what_it_flew(tmp_path: Path) -> None:
    spawner = SessionSpawner()
    with gcs.Session(example(4.0), out=tmp_path / "session", spawner=spawner) as session:
        session.step()
        spawner.close()
        summary = json.loads((tmp_path / "session" / "summary.json").read_text(encoding="utf-8"))
        assert summary["outcome"] == "interrupted"


def test_a_relative_folder_is_that_of_the_programs_current_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with SessionSpawner() as spawner:
        monkeypatch.chdir(tmp_path)
        with gcs.Session(example(0.5), out="session", spawner=spawner) as session:
            monkeypatch.chdir("/")
            assert session.finish().digest == digest(tmp_path / "session")


@pytest.mark.parametrize("spawned", [True, False])
def test_a_session_ends_also_beside_a_fork_of_its_program_which_may_not_act(spawned: bool, tmp_path: Path) -> None:
    with (
        SessionSpawner() if spawned else contextlib.nullcontext() as spawner,
        gcs.Session(example(0.5), out=tmp_path / "session", spawner=spawner) as session,
    ):
        session.step()

        def act(answers: Connection) -> None:
            for call in (session.step, session.finish, session.stop):
                try:
                    call()
                except gcs.SessionError as error:
                    answers.send(str(error))
            signal.pause()

        ours, theirs = multiprocessing.Pipe()
        fork = multiprocessing.get_context("fork").Process(target=act, args=(theirs,))
        fork.start()
        refused = "the session is that of the process that began it, of which this is a fork"
        assert [ours.recv() for _ in range(3)] == [refused] * 3
        assert session.finish().outcome == "met"
        fork.kill()
        fork.join()
