"""What commands say as JSON, for programs that call them."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
import yaml
from click.testing import CliRunner
from sessions import small

import gcs
from gcs.cli.main import cli


def said(*words: str | Path, status: int = 0) -> Any:
    """Standard output of a command as JSON."""
    done = CliRunner().invoke(cli, [str(word) for word in words])
    assert done.exit_code == status, done.output
    return json.loads(done.stdout)


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("flown")
    path = folder / "scenario.yaml"
    path.write_text(yaml.safe_dump(small(goal={"duration_s": 3.0, "refuelled_at_least": 0})), encoding="utf-8")
    with gcs.Session(path, lockstep=True, out=folder / "sessions" / "first") as session:
        session.finish()
    return folder / "sessions" / "first"


@pytest.mark.parametrize("axes", ["ned", "paper"])
def test_validate_lists_problems_and_warnings(axes: str, tmp_path: Path) -> None:
    content = small(axes=axes)
    lat_deg, lon_deg = 47.397742, 8.545594
    content["origin"] = {"lat_deg": lat_deg, "lon_deg": lon_deg, "alt_m": 488.0}
    content["vehicles"]["pursuers"][0]["start_m"] = [lat_deg, lon_deg, 0.0]
    path = tmp_path / "scenario.yaml"
    path.write_text(yaml.safe_dump(content), encoding="utf-8")
    found = said("validate", path, "--json")
    assert found["valid"]
    assert found["problems"] == []
    assert any("places are in metres" in text for text in found["warnings"])
    assert any(text.startswith("plan B:") for text in found["facts"])
    strict = said("validate", path, "--json", "--strict", status=2)
    assert not strict["valid"]
    assert len(strict["problems"]) == len(found["warnings"])
    path.write_text("schema: 1\nnme: x\n", encoding="utf-8")
    broken = said("validate", path, "--json", status=2)
    assert not broken["valid"]
    assert any(text.startswith(f"{path}:2:1: unknown key 'nme'") for text in broken["problems"])


def test_export_and_report_name_what_they_wrote(flown: Path, tmp_path: Path) -> None:
    tables = said("export", flown, "--format", "csv", "--out", tmp_path / "tables", "--json")
    assert tables["problems"] == []
    for name, rows in tables["rows"].items():
        written = (Path(tables["tables"]) / f"{name}.csv").read_text(encoding="utf-8").splitlines()
        assert len(written) == rows + 1, name
    one = said("report", flown, "--out", tmp_path / "one.html", "--json")
    assert Path(one["report"]).read_text(encoding="utf-8").startswith("<!")


def test_sessions_and_scenarios_are_listed(flown: Path, tmp_path: Path) -> None:
    killed = tmp_path / "sessions" / "killed"
    killed.mkdir(parents=True)
    shutil.copy(flown / "session.tlog", killed / "session.tlog")
    shutil.copytree(flown, killed.with_name("whole"))
    found = said("list", tmp_path / "sessions", "--json")
    assert "paper/example1" in [one["name"] for one in found["scenarios"]]
    assert all(one["description"] for one in found["scenarios"])
    sessions = {Path(one["folder"]).name: one for one in found["sessions"]}
    summary = json.loads((flown / "summary.json").read_text(encoding="utf-8"))
    assert sessions["whole"]["outcome"] == summary["outcome"]
    assert sessions["whole"]["digest"] == summary["digest"]
    assert sessions["killed"]["digest"] is None
    shown = CliRunner().invoke(cli, ["list", str(tmp_path / "sessions")])
    assert "still flies, or was killed" in shown.stdout
    assert said("list", flown, "--json")["sessions"] == []
    assert CliRunner().invoke(cli, ["list", str(tmp_path / "none")]).exit_code == 2
