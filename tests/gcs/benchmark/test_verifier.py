"""The verifier by cases whose answer is known in closed form: one receiver, one tanker, one base."""

from __future__ import annotations

import ast
import copy
import json
import math
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from gcs.benchmark import verifier
from gcs.cli.main import run_argv

INSTANCE: dict[str, Any] = {
    "format": "skytender-refuelling-instance/1", "name": "one", "kind": "by hand", "tightness": 0.0, "seed": 1,
    "horizon_s": 100.0, "setup_s": 2.0, "rate_w": 1000.0,
    "receivers": [
        # 1 m/s north; 3,000 J above what it lands at are gone after 30 s at 100 W
        {"id": 1, "path": [[0.0, 0.0, 0.0, -5.0], [100.0, 100.0, 0.0, -5.0]], "speed_m_s": 2.0,
         "capacity_j": 10_000.0, "energy_j": 4_000.0, "power_w": 100.0, "lands_at_j": 1_000.0},
    ],
    "tankers": [
        {"id": 9, "position_m": [0.0, 20.0, -5.0], "speed_m_s": 5.0, "capacity_j": 50_000.0, "energy_j": 30_000.0,
         "power_w": 100.0, "reserve_j": 5_000.0},
    ],
    "bases": [{"name": "pad", "position_m": [10.0, 0.0, -5.0], "stock_j": 9_000.0, "rate_w": 2000.0}],
}  # fmt: skip


def service(**changed: Any) -> dict[str, Any]:
    """The tanker meets the receiver at 10 s, 10 m north, and gives 8,000 J until 20 s: 22.4 m of way take 4.5 s."""
    return {"receiver": 1, "tanker": 9, "start_s": 10.0, "end_s": 20.0, "energy_j": 8_000.0} | changed


def stop(**changed: Any) -> dict[str, Any]:
    """The receiver leaves 10 m north at 10 s, stands at the base there for 4 s, and is 20 m north again at 20 s."""
    times = {"leave_s": 10.0, "start_s": 10.0, "end_s": 14.0, "back_s": 20.0}
    return {"receiver": 1, "base": "pad", "energy_j": 4_000.0} | times | changed


def verdict(*services: dict[str, Any], **changed: Any) -> dict[str, Any]:
    return verifier.verify(copy.deepcopy(INSTANCE) | changed, {"services": list(services)})


def test_without_a_service_it_is_lost_when_its_energy_is_gone() -> None:
    found = verdict()
    assert (found["feasible"], found["lost"]) == (True, [{"receiver": 1, "at_s": 30.0}])
    assert (found["delivered_j"], found["way_m"], found["idle_s"]) == (0.0, 0.0, 100.0)


def test_a_service_keeps_it_to_the_horizon() -> None:
    found = verdict(service())
    assert (found["feasible"], found["lost"]) == (True, [])  # 4,000 - 10,000 + 8,000 J are left of the 1,000
    assert found["delivered_j"] == 8_000.0
    assert found["way_m"] == pytest.approx(500.0**0.5 + 10.0)
    assert found["idle_s"] == pytest.approx(90.0 - 500.0**0.5 / 5.0)


def test_too_little_is_lost_later() -> None:
    assert verdict(service(energy_j=1_000.0))["lost"] == [{"receiver": 1, "at_s": 40.0}]


@pytest.mark.parametrize(
    ("services", "problem"),
    [
        ([service(energy_j=8_001.0)], "more than 1000 W"),
        ([service(start_s=3.0)], "cannot fly"),  # 20.2 m in 3 s
        ([service(), service(start_s=19.0, end_s=25.0, energy_j=100.0)], "before service 0 ends"),
        ([service(start_s=29.0, end_s=39.0, energy_j=100.0)], "is lost at 30.00 s"),
        ([service(receiver=2)], "each of the instance"),
        ([service(tanker=None)], "two of receiver, tanker and base"),
        ([service(receiver=9, tanker=1)], "each of the instance"),
        ([service(end_s=9.0)], "that cannot be"),
        ([service(end_s=101.0)], "that cannot be"),
        ([service(energy_j=math.nan)], "that cannot be"),
        ([service(start_s=math.nan)], "that cannot be"),
        ([service(end_s=math.inf)], "that cannot be"),
        ([stop(back_s=math.inf)], "that cannot be"),
        ([stop(leave_s=None)], "service 0 of a receiver at a base needs leave_s and back_s"),
        ([stop(back_s=None)], "service 0 of a receiver at a base needs leave_s and back_s"),
    ],
)
def test_what_cannot_be_carried_out_is_named(services: list[dict[str, Any]], problem: str) -> None:
    found = verdict(*services)
    assert not found["feasible"]
    assert any(problem in line for line in found["problems"]), found["problems"]


def test_a_receiver_gets_no_more_than_it_holds() -> None:
    full = copy.deepcopy(INSTANCE["receivers"])
    full[0]["energy_j"] = 9_000.0
    assert verdict(service(), receivers=full)["problems"] == ["vehicle 1 gets more than it holds"]


def test_a_tanker_keeps_its_reserve() -> None:
    poor = copy.deepcopy(INSTANCE["tankers"])
    poor[0]["energy_j"] = 20_000.0  # of which it flies 10,000 and keeps 5,000
    assert verdict(service(), tankers=poor)["problems"] == ["tanker 9 is below its reserve at 70.00 s"]
    reload = {"tanker": 9, "base": "pad", "start_s": 30.0, "end_s": 35.0, "energy_j": 6_000.0}
    assert verdict(service(), reload, tankers=poor)["feasible"]
    assert verdict(service(), reload | {"start_s": 21.0, "end_s": 26.0}, tankers=poor)["problems"] == [
        "service 1: tanker 9 cannot fly 10.00 m in 1.00 s"
    ]


def test_a_receiver_at_a_base_flies_there_and_back() -> None:
    found = verdict(stop())
    assert found["feasible"]  # drawn for 96 s, 4,000 J are left of the 1,000, less 9,600, and 4,000 more: 60.0 s + 4 s
    assert found["lost"] == [{"receiver": 1, "at_s": 74.0}]
    assert "cannot fly between its path and pad" in verdict(stop(back_s=15.0))["problems"][0]
    assert verdict(stop(), bases=[INSTANCE["bases"][0] | {"stock_j": 3_000.0}])["problems"] == [
        "pad gives 1000 J more than it has"
    ]


def imported(path: Path) -> set[str]:
    """Modules that a file names in its imports, in functions too."""
    nodes = list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
    plain = {name.name for node in nodes if isinstance(node, ast.Import) for name in node.names}
    found = [node for node in nodes if isinstance(node, ast.ImportFrom)]
    return plain | {f"{node.module}.{name.name}" for node in found for name in node.names}


def test_it_shares_no_code_with_what_makes_schedules() -> None:
    """It imports from Python alone, and of all other modules only those that judge call it."""
    own = Path(verifier.__file__)
    lines = own.read_text(encoding="utf-8").splitlines()
    judges = [line.startswith("def place(") for line in lines].index(True)
    reads = [line.startswith("def check(") for line in lines].index(True)
    assert reads - judges <= 150
    assert len(lines) <= 250
    assert {name.split(".")[0] for name in imported(own)} <= sys.stdlib_module_names
    root = own.parents[1]
    users = {
        path.relative_to(root).as_posix()
        for path in root.rglob("*.py")
        if any(name.startswith("gcs.benchmark.verifier") for name in imported(path))
    }
    assert users == {"benchmark/compare.py", "benchmark/solve.py", "cli/benchmark.py"}
    for judge in ("compare", "solve"):
        assert "gcs.benchmark.verifier.verify" in imported(own.with_name(f"{judge}.py"))


def alone(folder: Path, instance: str, schedule: str) -> tuple[int, str, str]:
    """Exit status and what is printed, of the verifier run by itself on two files with such content."""
    for name, content in (("i.json", instance), ("s.json", schedule)):
        (folder / name).write_text(content, encoding="utf-8")
    program = [sys.executable, "-I", verifier.__file__, "i.json", "s.json"]
    done = subprocess.run(program, capture_output=True, text=True, check=False, cwd=folder)
    return done.returncode, done.stdout, done.stderr


def as_file(*services: dict[str, Any]) -> str:
    return json.dumps({"format": "skytender-refuelling-schedule/1", "instance": "one", "services": services})


def test_it_runs_by_itself(tmp_path: Path) -> None:
    status, out, _ = alone(tmp_path, json.dumps(INSTANCE), as_file(service(start_s=3.0)))
    assert (status, json.loads(out)["feasible"]) == (1, False)
    status, out, _ = alone(tmp_path, json.dumps(INSTANCE), as_file(service(leave_s=None)))
    assert (status, json.loads(out)["lost"]) == (0, [])


def changed(group: str, **values: Any) -> str:
    """The instance with the first of a group changed."""
    first, *others = INSTANCE[group]
    return json.dumps(INSTANCE | {group: [first | values, *others]})


GIVEN = json.dumps(INSTANCE)
BACK = "receivers[0].path[1] is at 1 s, not later than the corner before (2 s)"
JUMP = "receivers[0].path[1] is at 2 s, not later than the corner before (2 s)"


@pytest.mark.parametrize(
    ("instance", "sentence"),
    [
        (json.dumps(INSTANCE | {"receivers": 2 * INSTANCE["receivers"]}), "receivers[1] has the id 1 of receivers[0]"),
        (changed("tankers", id=1), "tankers[0] has the id 1 of receivers[0]"),
        (json.dumps(INSTANCE | {"bases": 2 * INSTANCE["bases"]}), "bases[1] has the name pad of bases[0]"),
        (changed("receivers", path=[[2.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]]), BACK),
        (changed("receivers", path=[[2.0, 0.0, 0.0, 0.0], [2.0, 9.0, 0.0, 0.0]]), JUMP),
    ],
)
def test_names_and_paths_that_are_none_are_refused_by_both_programs_in_one_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], instance: str, sentence: str
) -> None:
    expected = f"i.json is no instance (docs/refuelling-benchmark.md#format): {sentence}\n"
    assert alone(tmp_path, instance, as_file()) == (2, "", expected)
    for command in (
        ["verify", str(tmp_path / "i.json"), str(tmp_path / "s.json")],
        ["solve", str(tmp_path / "i.json")],
    ):
        assert run_argv(["benchmark", *command]) == 2
        assert capsys.readouterr().err == f"gcs: {tmp_path}/{expected}"


def test_a_path_may_name_a_corner_twice(tmp_path: Path) -> None:
    corner = [0.0, 0.0, 0.0, -5.0]
    assert alone(tmp_path, changed("receivers", path=[corner, corner]), as_file())[0] == 0


@pytest.mark.parametrize(
    ("instance", "schedule", "sentence"),
    [
        (GIVEN, as_file(service(energy_j=math.nan)), "no schedule .*: services[0].energy_j is no number"),
        (GIVEN, as_file(service(end_s="20")), "no schedule .*: services[0].end_s is no number"),
        (GIVEN, as_file(service(end=20.0)), "no schedule .*: services[0].end is unknown"),
        (GIVEN, as_file({"receiver": 1}), "no schedule .*: services[0].start_s is missing"),
        (GIVEN, "[]", "no schedule .*: it is no object"),
        (GIVEN, "", "no schedule .*: Expecting value"),
        (GIVEN, GIVEN, "no schedule .*: instance is missing"),
        (json.dumps(INSTANCE | {"name": "two"}), as_file(), "s.json is a schedule of 'one', and .*i.json is 'two'"),
        (json.dumps(INSTANCE | {"horizon_s": math.inf}), as_file(), "no instance .*: horizon_s is no number above 0"),
        (GIVEN.replace("100.0", "1e999", 1), as_file(), "no instance .*: horizon_s is no number above 0"),
        (changed("receivers", id=1.0), as_file(), "no instance .*: receivers[0].id is no whole number from 1 to 254"),
        (changed("receivers", path=[]), as_file(), "no instance .*: receivers[0].path has no corner"),
        (changed("receivers", path=[[0.0, 1.0]]), as_file(), "no instance .*: receivers[0].path[0] is no array of 4"),
        (changed("tankers", energy_j=-1.0), as_file(), "no instance .*: tankers[0].energy_j is no number from 0 on"),
    ],
)  # fmt: skip
def test_a_file_that_is_none_is_refused_by_both_programs(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], instance: str, schedule: str, sentence: str
) -> None:
    status, out, err = alone(tmp_path, instance, schedule)
    assert (status, out) == (2, "")
    assert re.search(sentence.replace("[", r"\["), err), err
    assert run_argv(["benchmark", "verify", str(tmp_path / "i.json"), str(tmp_path / "s.json")]) == 2
    assert re.search(sentence.partition(" .*: ")[0], capsys.readouterr().err)
