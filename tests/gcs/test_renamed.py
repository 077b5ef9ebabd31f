"""Old names of modules and classes go on to work and tell the new ones."""

from __future__ import annotations

import importlib
import subprocess
import sys
import warnings
from pathlib import Path

import pytest
import yaml
from sessions import GCS, ROOT, fly, small

import gcs.renamed
import gcs.scenario
import simvehicle.renamed

EXAMPLES = ROOT / "tests" / "examples"
OLD_PLANNER = (
    (EXAMPLES / "my_planner.py")
    .read_text(encoding="utf-8")
    .replace(
        "from gcs import Scenario, Situation, VehicleView",
        "from gcs.planner.own import Situation\nfrom gcs.scenario import Scenario\nfrom gcs.views import VehicleView",
    )
)
OLD_POLICY = (
    (EXAMPLES / "my_policy.py")
    .read_text(encoding="utf-8")
    .replace(
        "from gcs import RefuellingRequest, Scenario",
        "from gcs.policies import Request\nfrom gcs.scenario import Scenario",
    )
    .replace("request: RefuellingRequest", "request: Request")
)
"""As the README printed them before the packages."""
TABLES = {**gcs.renamed.MODULES, **simvehicle.renamed.MODULES}
TOLD = {"gcs.planner.own is now gcs.planner.custom", "gcs.views is now", "gcs.policies is now", "Request is now"}


@pytest.mark.parametrize("old", TABLES)
def test_an_old_module_is_the_new_one_with_a_warning(old: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delitem(sys.modules, old, raising=False)
    with pytest.warns(DeprecationWarning, match=f"{old} is now {TABLES[old]}$") as caught:
        module = importlib.import_module(old)
    assert len(caught) == 1
    new = importlib.import_module(TABLES[old])
    public = [name for name in vars(new) if not name.startswith("_")]
    assert all(getattr(module, name) is getattr(new, name) for name in public)
    with pytest.raises(AttributeError, match="nothing"):
        _ = module.nothing


@pytest.mark.parametrize(("module", "old"), [(m, old) for m, names in gcs.renamed.CLASSES.items() for old in names])
def test_an_old_class_is_the_new_one_and_is_warned_of_once(
    module: str, old: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        if module in gcs.renamed.MODULES:
            monkeypatch.delitem(sys.modules, module, raising=False)
        home = importlib.import_module(module)
    monkeypatch.delitem(home.__dict__, old, raising=False)
    new = gcs.renamed.CLASSES[module][old]
    with pytest.warns(DeprecationWarning, match=f"{module}.{old} is now {new}$") as caught:
        classes = [getattr(home, old) for _ in range(2)]
    assert [found.__name__ for found in classes] == [new, new]
    assert [Path(warning.filename) for warning in caught] == [Path(__file__)]
    monkeypatch.delitem(home.__dict__, old)


def test_the_parts_of_a_scenario_are_where_they_were() -> None:
    assert gcs.scenario.Obstacle.__name__ == "Obstacle"
    with pytest.raises(AttributeError, match="Obstaccle"):
        _ = gcs.scenario.Obstaccle


def test_planner_and_policy_written_for_the_old_names_fly_and_are_told_once(tmp_path: Path) -> None:
    (tmp_path / "old_planner.py").write_text(OLD_PLANNER)
    (tmp_path / "old_policy.py").write_text(OLD_POLICY)
    flown = fly(small(planner="old_planner:Ring", competition="old_policy:InTurn"), tmp_path, "--plain")
    assert flown.status == 0, flown.stderr
    assert {service["by"] for service in flown.summary["refuelling"]} == {"policy"}
    for words in TOLD:
        assert flown.stderr.count(words) == 1, flown.stderr


def test_old_names_are_no_errors_where_warnings_are(tmp_path: Path) -> None:
    (tmp_path / "old_planner.py").write_text(OLD_PLANNER)
    (tmp_path / "own.yaml").write_text(yaml.safe_dump(small(planner="old_planner:Ring")))
    strict = [GCS[0], "-W", "error::DeprecationWarning", *GCS[1:], "validate", "--trust", "own.yaml"]
    done = subprocess.run(strict, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "gcs.views is now gcs.telemetry.state" in done.stderr


@pytest.mark.parametrize(
    ("old", "new"),
    [("heard_s", "last_received_s"), ("battery_told", "battery_reported"), ("given_told_s", "given_reported_s")],
)
def test_an_old_field_of_a_vehicle_is_the_new_one_with_a_warning(old: str, new: str) -> None:
    fields = gcs.VehicleView._fields
    view = gcs.VehicleView(*range(len(fields)))  # type: ignore[arg-type]
    with pytest.warns(DeprecationWarning, match=f"VehicleView.{old} is now VehicleView.{new}$") as caught:
        assert getattr(view, old) == fields.index(new)
    assert [Path(warning.filename) for warning in caught] == [Path(__file__)]
