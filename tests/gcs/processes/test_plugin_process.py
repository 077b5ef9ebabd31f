"""A planner's process that hangs, crashes, is killed or stopped: it is over soon, said with its line, and nobody waits
for it or is left."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import psutil
import pytest
from sessions import GCS, all_gone, small

from gcs.planner.request import Situation
from gcs.processes import plugin_process
from gcs.processes.plugin_process import PATIENCE_S, PluginProcess
from gcs.scenario.file import dump
from gcs.scenario.guard import PROCESS
from gcs.scenario.model import Scenario, ScenarioError
from gcs.scenario.plugins import PLANNER, POLICY
from gcs.supervisor.factory import make_fleet

SOON_S = PATIENCE_S + plugin_process.ENDS_WITHIN_S + 3.0
ENDLESS = """
open(__file__.replace(".py", ".begun"), "w").close()
sum(range(10**13))
class Mine:
    def plan(self, vehicle, situation): return None
"""
PLANNER_OF = """
import ctypes, os, signal, subprocess, sys, time

class Mine:
    def __init__(self, scenario):
        {made}

    def plan(self, vehicle, situation):
        {planned}
"""


def scenario_of(folder: Path, planned: str = "return vehicle.p_ned, vehicle.v_ned", made: str = "pass") -> Scenario:
    """A scenario whose planner is these lines, in a module of its own in `folder`."""
    name = re.sub(r"\W", "_", folder.name)
    (folder / f"{name}.py").write_text(PLANNER_OF.format(planned=planned, made=made))
    return Scenario.model_validate(small(planner=f"{name}:Mine"))


@contextmanager
def started(scenario: Scenario, folder: Path, parent: int | None = None) -> Iterator[PluginProcess]:
    with plugin_process.started(scenario, [str(folder)], folder, parent) as process:
        assert process is not None
        yield process
        family = [psutil.Process(process.pid)] if psutil.pid_exists(process.pid) else []
    assert not all_gone(family)


def asked_of(scenario: Scenario, time_s: float = 1.0) -> tuple[list[int], Situation]:
    """A planner's question about pursuer 1 at a place."""
    snapshot = make_fleet(scenario).snapshot(time_s)
    views = tuple(view._replace(p_ned=(1.0, 2.0, -3.0), v_ned=(0.1, 0.2, 0.3)) for view in snapshot.vehicles)
    return [1], Situation(time_s, 0.1, type(snapshot)(time_s, views, ()), {1: 101}, scenario.obstacles)


def test_a_planner_is_asked_and_answers_to_the_last_bit(tmp_path: Path) -> None:
    said = "print([*vehicle._replace(profile=vehicle.profile.name)])"
    planned = f"{said}; return vehicle.p_ned, (situation.target(vehicle).p_ned[0] / 3, 0.1 + 0.2, 1e-300)"
    scenario = scenario_of(tmp_path, planned)
    with started(scenario, tmp_path) as process:
        assert process.made(PLANNER) is False
        process.ask(PLANNER, asked_of(scenario))
        assert process.answers(PLANNER) == [(1, 1.0, 2.0, -3.0, 1.0 / 3, 0.1 + 0.2, 1e-300)]
        assert process.pop_faults() == []
    view = asked_of(scenario)[1].snapshot.vehicle(1)
    assert (tmp_path / plugin_process.OUTPUT).read_text() == f"{[*view._replace(profile=view.profile.name)]}\n"


ENDS = [
    ("return sum(range(10**13))", rf"did not answer within {PATIENCE_S:g} s at \w+.py:9 in plan and was ended"),
    ("ctypes.string_at(0)", r"was killed by signal 11 at \w+.py:9 in plan"),
    ("os._exit(3)", "ended with status 3"),
    ("os.kill(os.getpid(), signal.SIGSTOP)", rf"did not answer within {PATIENCE_S:g} s and was ended"),
]


@pytest.mark.parametrize(("planned", "said"), ENDS)
def test_a_process_that_does_not_come_back_is_over_and_said_once(planned: str, said: str, tmp_path: Path) -> None:
    scenario = scenario_of(tmp_path, planned)
    with started(scenario, tmp_path) as process:
        process.made(PLANNER)
        process.ask(PLANNER, asked_of(scenario))
        begun_s = time.monotonic()
        assert process.answers(PLANNER) == []
        assert time.monotonic() - begun_s < SOON_S
        (fault,) = process.pop_faults()
        assert fault.sysid == PROCESS
        assert re.fullmatch(said, fault.problem), fault.problem
        assert fault.sentence == f"{fault.policy} {fault.problem}; its pursuers are held"
        assert not psutil.pid_exists(process.pid)
        process.ask(PLANNER, asked_of(scenario))
        assert (process.ended, process.answers(PLANNER), process.pop_faults()) == (True, [], [])


def test_a_planner_slower_than_the_deadline_that_answers_vehicle_by_vehicle_is_waited_for(tmp_path: Path) -> None:
    """Five pursuers of 0.8 s each: longer than PATIENCE_S in all."""
    scenario = scenario_of(tmp_path, "time.sleep(0.8); return vehicle.p_ned, vehicle.v_ned")
    sysids, situation = [1] * 5, asked_of(scenario)[1]
    with started(scenario, tmp_path) as process:
        process.made(PLANNER)
        process.ask(PLANNER, (sysids, situation))
        assert [row[0] for row in process.answers(PLANNER)] == sysids
        assert not process.ended


@pytest.mark.parametrize(
    ("made", "said"),
    [
        ("scenario.nothing", r"planner.method: \w+:Mine cannot be made: AttributeError at main.py:\d+: .*nothing.*"),
        ("ctypes.string_at(0)", r"planner.method: planner \w+:Mine was killed by signal 11 at \w+.py:6 in __init__"),
    ],
)
def test_a_planner_that_cannot_be_made_is_one_sentence(made: str, said: str, tmp_path: Path) -> None:
    with (
        started(scenario_of(tmp_path, made=made), tmp_path) as process,
        pytest.raises(ScenarioError) as error,
    ):
        process.made(PLANNER)
    assert re.fullmatch(said, error.value.problems[0].message), error.value.problems


IMPORTS = [
    ("class Mine:\n    def plan(self): pass", ""),
    ("import time", r"there_is_\w+ \(.*there_is_\w+.py\) has no 'Mine'"),
    ("1 / 0", r"\w+ cannot be imported: ZeroDivisionError at \w+.py:1: division by zero"),
    ("sum(range(10**13))", r"planner \w+:Mine did not answer within 6 s at \w+.py:1 in <module> and was ended"),
    ("import os; os._exit(3)", r"planner \w+:Mine ended with status 3"),
]


@pytest.mark.parametrize(("source", "said"), IMPORTS, ids=[source for source, _ in IMPORTS])
def test_modules_are_looked_for_in_a_process_that_hangs_or_crashes_alone(
    source: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(plugin_process, "IMPORTED_WITHIN_S", 6.0 if "sum" in source else 60.0)
    name = f"there_is_{IMPORTS.index((source, said))}"
    (tmp_path / f"{name}.py").write_text(source + "\n")
    scenario = Scenario.model_validate(small(planner=f"{name}:Mine"))
    if not said:
        plugin_process.check(scenario, None, [tmp_path])
    else:
        with pytest.raises(ScenarioError) as error:
            plugin_process.check(scenario, None, [tmp_path])
        (problem,) = error.value.problems
        assert re.fullmatch(rf"planner.method: {said}", problem.message), problem
    assert name not in sys.modules
    assert not [p for p in psutil.Process().children() if p.name() == "gcs plug-ins"]


@pytest.mark.parametrize("command", ["run", "campaign run"])
def test_a_command_does_not_hang_with_a_module_that_never_comes_to_its_end(command: str, tmp_path: Path) -> None:
    """Ctrl-C while it is imported ends the command, and the import."""
    (tmp_path / "endless.py").write_text(ENDLESS)
    (tmp_path / "own.yaml").write_text(dump(Scenario.model_validate(small(planner="endless:Mine"))))
    (tmp_path / "many.yaml").write_text("{schema: 1, name: many, scenario: own.yaml, sessions: 1, keep: none}")
    words = [*command.split(), "own.yaml" if command == "run" else "many.yaml", "--trust", "--plain", "--out", "out"]
    with subprocess.Popen([*GCS, *words], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
        while not (tmp_path / "endless.begun").exists():
            assert process.poll() is None
            all_gone([psutil.Process(process.pid)], within_s=0.1)
        family = [psutil.Process(process.pid), *psutil.Process(process.pid).children(recursive=True)]
        process.send_signal(signal.SIGINT)
        assert not all_gone(family)
    assert process.returncode == 130
    assert not (tmp_path / "out").exists()


def test_making_takes_as_long_as_it_takes_but_no_longer_than_the_session_is_waited_for(tmp_path: Path) -> None:
    scenario = scenario_of(tmp_path, made="open(__file__ + '.begun', 'w').close(); sum(range(10**13))")
    reading, writing = os.pipe()
    with started(scenario, tmp_path, reading) as process:
        os.close(writing)
        process.made(PLANNER)
        assert process.ended
    os.close(reading)


def test_with_a_process_goes_what_it_has_started(tmp_path: Path) -> None:
    made = "self.child = subprocess.Popen(['sleep', '600']); print(self.child.pid, flush=True)"
    scenario = scenario_of(tmp_path, "return sum(range(10**13))", made)
    with started(scenario, tmp_path) as process:
        process.made(PLANNER)
        child = psutil.Process(int((tmp_path / plugin_process.OUTPUT).read_text()))
        process.ask(PLANNER, asked_of(scenario))
        process.answers(PLANNER)
    assert not all_gone([child])


def test_a_planner_and_a_policy_live_in_one_process(tmp_path: Path) -> None:
    scenario = scenario_of(tmp_path)
    (tmp_path / "both.py").write_text(f"import {scenario.planner.method.partition(':')[0]} as theirs\n{BOTH}")
    both = Scenario.model_validate(small(planner=scenario.planner.method, competition="both:Assigns"))
    with started(both, tmp_path) as process:
        assert (process.made(PLANNER), process.made(POLICY)) == (False, True)
        assert len(psutil.Process(process.pid).children()) == 0
        os.kill(process.pid, signal.SIGKILL)
        process.ask(PLANNER, asked_of(both))
        assert process.answers(PLANNER) == []
        assert [f.sentence.rpartition("; ")[2] for f in process.pop_faults()] == [
            "its pursuers are held",
            "only urgent vehicles are served",
        ]


BOTH = """
class Assigns:
    def __init__(self, scenario): pass
    def choose(self, request): return None
    def assign(self, request): return {}
"""
ORPHANING = """
import sys
from pathlib import Path
from gcs.processes import plugin_process
from gcs.scenario.file import load
folder = Path(sys.argv[1])
with plugin_process.started(load(folder / "scenario.yaml"), [str(folder)], folder) as process:
    print(process.pid, flush=True)
    process.made("planner.method")
"""


def test_a_process_in_compiled_code_ends_with_the_one_that_started_it(tmp_path: Path) -> None:
    """Killed while the planner is being made: nothing reads the socket then."""
    began = tmp_path / "began"
    scenario = scenario_of(tmp_path, made=f"open({str(began)!r}, 'w').close(); sum(range(10**13))")
    (tmp_path / "scenario.yaml").write_text(dump(scenario))
    command: list[Any] = [sys.executable, "-P", "-c", ORPHANING, tmp_path]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as parent:
        assert parent.stdout is not None
        process = psutil.Process(int(parent.stdout.readline()))
        while not began.exists():
            assert process.is_running()
            all_gone([process], within_s=0.1)
        parent.kill()
        assert not all_gone([process])
