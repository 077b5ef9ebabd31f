"""Planners and policies that a program gives its session as objects: whole sessions by real processes."""

from __future__ import annotations

import json
import subprocess
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
from commands import gcs as run_gcs
from pages import DOCS, block
from sessions import ROOT, small

import gcs

PAGE = DOCS / "how-to" / "own-planner.md"
SPACE: dict[str, Any] = {}
exec(block(PAGE, "my_planner.py"), SPACE)
Ring: Any = SPACE["Ring"]


class First:
    """The policy that serves the first candidate."""

    def __init__(self, scenario: gcs.Scenario) -> None:
        self.asked = 0

    def choose(self, request: gcs.RefuellingRequest) -> int:
        self.asked += 1
        return request.candidates[0].sysid


def write(folder: Path, content: str) -> Path:
    path = folder / "scenario.yaml"
    path.write_text(content, encoding="utf-8")
    return path


def lines(folder: Path, *kinds: str) -> list[dict[str, Any]]:
    read = map(json.loads, (folder / "decisions.jsonl").read_text(encoding="utf-8").splitlines())
    return [line for line in read if line["kind"] in kinds]


def decide(folder: Path) -> subprocess.CompletedProcess[str]:
    again = run_gcs("replay", str(folder), "--decide")
    assert (again.returncode, again.stdout.endswith("agree\n")) == (0, True), again.stdout + again.stderr
    return again


@pytest.mark.slow
def test_a_class_flies_as_the_module_that_a_scenario_names(tmp_path: Path) -> None:
    path = write(tmp_path, block(PAGE, "ring.yaml").replace("duration_s: 40", "duration_s: 13"))
    (tmp_path / "my_planner.py").write_text(block(PAGE, "my_planner.py"), encoding="utf-8")
    with gcs.Session(path, lockstep=True, planner=Ring, out=tmp_path / "object") as session:
        for _ in session:
            pass
    with gcs.Session(path, lockstep=True, trust=True, out=tmp_path / "module") as named:
        named.finish()
    assert lines(session.folder, "set_point") == lines(named.folder, "set_point")
    for sysid in (1, 2, 3, 101):
        truth = Path("vehicles") / f"{sysid}.truth"
        assert (session.folder / truth).read_bytes() == (named.folder / truth).read_bytes()
    assert "my_planner" not in (session.folder / "scenario.yaml").read_text()
    schema = json.loads((ROOT / "gcs" / "schemas" / "decisions.schema.json").read_text(encoding="utf-8"))
    told = lines(session.folder, "program", "planned")
    for line in told:
        jsonschema.Draft202012Validator(schema).validate(line)
    assert told[0] == {"t_s": 0.0, "kind": "program", "part": "planner", "name": "Ring", "assigns": False}
    assert not lines(named.folder, "program", "planned")
    said = decide(session.folder).stderr
    assert "the planner Ring was a Python object of that program and cannot be asked again" in said


def test_an_object_sees_what_the_program_changes_and_repeats(tmp_path: Path) -> None:
    path, digests = write(tmp_path, block(PAGE, "ring.yaml")), []

    seen: set[tuple[str, ...]] = set()

    class Watching(Ring):  # type: ignore[misc]
        def plan(self, vehicle: gcs.VehicleView, situation: gcs.Situation) -> tuple[np.ndarray, np.ndarray]:
            seen.add(tuple(str(one.name) for one in situation.obstacles))
            planned: tuple[np.ndarray, np.ndarray] = super().plan(vehicle, situation)
            return planned

    for name in ("first", "second"):
        seen.clear()
        with gcs.Session(path, lockstep=True, planner=Watching, out=tmp_path / name) as session:
            while session.step().time_s < 8.0:
                pass
            session.obstacles.add({"name": "ball", "sphere_m": (9, 9, -3), "radius_m": 0.5})
            while session.step().time_s < 10.0:
                pass
        digests.append(session.summary.digest)
        assert seen == {(), ("ball",)}
    assert digests[0] == digests[1]
    decide(session.folder)


def test_what_a_planner_raises_reaches_its_program(tmp_path: Path) -> None:
    path = write(tmp_path, block(PAGE, "ring.yaml"))
    failed: list[str] = []
    causes: list[type] = []

    class Failing(Ring):  # type: ignore[misc]
        def plan(self, vehicle: gcs.VehicleView, situation: gcs.Situation) -> tuple[np.ndarray, np.ndarray]:
            if vehicle.sysid == 2 and 6.95 < situation.time_s < 7.15:
                raise LookupError("nothing there")
            planned: tuple[np.ndarray, np.ndarray] = super().plan(vehicle, situation)
            return planned

    scenario = gcs.load(path)
    with gcs.Session(path, lockstep=True, planner=Failing(scenario), out=tmp_path / "out") as session:
        for _ in range(90):
            try:
                session.step()
            except gcs.SessionError as error:
                causes.append(type(error.__cause__))
                failed.append(str(error))
    assert causes == [LookupError, LookupError]
    assert failed == [f"planner Failing failed at {t_s} s: LookupError('nothing there')" for t_s in (7, 7.1)]
    (told,) = lines(session.folder, "policy failed")
    assert (told["sysid"], told["t_s"]) == (2, pytest.approx(7.0))
    decide(session.folder)


def test_a_call_while_another_is_under_way_is_refused(tmp_path: Path) -> None:
    """Here from inside a step: the planner calls its own session, and so does a thread that it waits for."""
    refused: list[str] = []

    def call(what: Callable[[], Any]) -> None:
        with pytest.raises(gcs.SessionError) as caught:
            what()
        refused.append(str(caught.value))

    class Calling(Ring):  # type: ignore[misc]
        def plan(self, vehicle: gcs.VehicleView, situation: gcs.Situation) -> tuple[np.ndarray, np.ndarray]:
            if not refused:
                for what in (session.step, lambda: session.command(1, "hold"), session.stop, session.finish):
                    call(what)
                    thread = threading.Thread(target=call, args=(what,))
                    thread.start()
                    thread.join()
            planned: tuple[np.ndarray, np.ndarray] = super().plan(vehicle, situation)
            return planned

    path = write(tmp_path, block(PAGE, "ring.yaml"))
    with gcs.Session(path, lockstep=True, planner=Calling, out=tmp_path / "out") as session:
        while not refused:
            session.step()
        assert session.command(1, "hold").command == "hold"
        assert session.step().time_s > 0.0
    assert len(refused) == 8
    assert set(refused) == {
        "another call of this session is under way: call it from one thread, and not from its own planner or policy"
    }
    assert not lines(session.folder, "policy failed")


def test_a_policy_is_asked_and_its_answers_are_decided_again(tmp_path: Path) -> None:
    content = small(goal={"duration_s": 40.0}, competition={"policy": "optimal"})
    policy = First(gcs.Scenario.model_validate(content))
    with gcs.Session(
        gcs.Scenario.model_validate(content), lockstep=True, policy=policy, out=tmp_path / "out"
    ) as session:
        session.finish()
    assert policy.asked > 0
    assert session.summary.refuelling
    chosen = lines(session.folder, "chosen")
    assert len(chosen) == policy.asked
    assert {line["by"] for line in lines(session.folder, "decided")} == {"policy"}
    assert "the policy First was a Python object" in decide(session.folder).stderr


def test_what_cannot_be_used_is_one_sentence(tmp_path: Path) -> None:
    path = write(tmp_path, block(PAGE, "ring.yaml"))
    with pytest.raises(ValueError, match=r"planner and policy as objects need lockstep=True"):
        gcs.Session(path, planner=Ring)
    with (
        pytest.raises(TypeError, match=r"int has no method 'plan', which a planner needs"),
        gcs.Session(path, lockstep=True, planner=7, out=tmp_path / "out"),  # type: ignore[arg-type]
    ):
        pass
    assert not (tmp_path / "out").exists()
