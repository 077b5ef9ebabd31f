"""The verifier by cases whose answer is known in closed form: one receiver, one tanker, one base."""

from __future__ import annotations

import ast
import copy
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from gcs.benchmark import verifier

INSTANCE: dict[str, Any] = {
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
    """It leaves 10 m north at 10 s, stands there for 4 s, and is 16 m north again at 17 s: 6 m in 3 s."""
    stop = {"receiver": 1, "base": "pad", "leave_s": 10.0, "start_s": 10.0, "end_s": 14.0, "back_s": 20.0}
    found = verdict(stop | {"energy_j": 4_000.0})
    assert found["feasible"]  # drawn for 96 s, 4,000 J are left of the 1,000, less 9,600, and 4,000 more: 60.0 s + 4 s
    assert found["lost"] == [{"receiver": 1, "at_s": 74.0}]
    assert "cannot fly between its path and pad" in verdict(stop | {"energy_j": 4_000.0, "back_s": 15.0})["problems"][0]
    assert verdict(stop | {"energy_j": 4_000.0}, bases=[INSTANCE["bases"][0] | {"stock_j": 3_000.0}])["problems"] == [
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
    assert len(own.read_text(encoding="utf-8").splitlines()) <= 150
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


def test_it_runs_by_itself(tmp_path: Path) -> None:
    for name, content in (("i", INSTANCE), ("s", {"services": [service(start_s=3.0)]})):
        (tmp_path / name).write_text(json.dumps(content))
    done = subprocess.run(
        [sys.executable, "-I", verifier.__file__, tmp_path / "i", tmp_path / "s"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert json.loads(done.stdout)["feasible"] is False
