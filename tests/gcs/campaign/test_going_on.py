"""A campaign's folder is gone on with only by what its sessions were flown by."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pyarrow.compute as pc
import pytest
import yaml
from click.testing import CliRunner
from commands import gcs as gcs_command

import gcs
from gcs.campaign import table
from gcs.campaign.cluster import EngineError
from gcs.cli.campaign.command import campaign

SCENARIO = """
schema: 1
name: near
axes: ned
origin: {lat_deg: 47.4, lon_deg: 8.5, alt_m: 488.0}
goal: {duration_s: 3}
planner: {cruise_m_s: 1.0}
vehicles:
  pursuers: [{sysid: 1, start_m: [2, 0, -3], airborne: true, battery: {capacity_j: 20000}}]
"""


def begun(folder: Path, **content: Any) -> Path:
    """A campaign's file beside its scenario, and its folder `flown`, which has the only row."""
    (folder / "near.yaml").write_text(SCENARIO, encoding="utf-8")
    file = folder / "campaign.yaml"
    whole = {"schema": 1, "name": "near", "scenario": "near.yaml", "sessions": 1, **content}
    file.write_text(yaml.safe_dump({key: value for key, value in whole.items() if value is not None}))
    flown = folder / "flown"
    flown.mkdir()
    plan = gcs.Campaign(file, trust=True).plan
    plan.write(flown)
    row = {"row": 0, "session": 0, "combination": 0, "seed": 1, "ok": True, "digest": "sha256:x"}
    table.Writer(flown, plan.campaign).write([row])
    return file


def test_from_python_a_changed_scenario_is_refused_as_by_the_command(tmp_path: Path) -> None:
    file, out = begun(tmp_path), tmp_path / "flown"
    assert gcs.Campaign(file, out=out).fly()["digest"].to_pylist() == ["sha256:x"]
    (tmp_path / "near.yaml").write_text(SCENARIO.replace("cruise_m_s: 1.0", "cruise_m_s: 2.5"), encoding="utf-8")
    with pytest.raises(gcs.ScenarioError, match=r"^near\.yaml: was changed since its sessions were flown, and only"):
        gcs.Campaign(file, out=out).fly()
    (tmp_path / "near.yaml").write_text(SCENARIO, encoding="utf-8")
    assert gcs.Campaign(file, out=out).fly().num_rows == 1


def test_from_python_sessions_may_grow_and_not_shrink(tmp_path: Path) -> None:
    file, out = begun(tmp_path), tmp_path / "flown"
    rows = gcs.Campaign(file, out=out, sessions=2, workers=1).fly()
    assert sorted(rows["row"].to_pylist()) == [0, 1]
    assert rows.filter(pc.equal(rows["row"], 0))["digest"].to_pylist() == ["sha256:x"]
    assert yaml.safe_load((out / "campaign.yaml").read_text())["sessions"] == 2
    with pytest.raises(EngineError, match=r"holds another campaign; give a new folder$"):
        gcs.Campaign(file, out=out).fly()


@pytest.mark.parametrize("beside", [True, False])
def test_errors_are_flown_again_where_that_is_asked_for(beside: bool, tmp_path: Path) -> None:
    """Beside a row that is none in the same part, or alone in theirs."""
    file, out = begun(tmp_path), tmp_path / "flown"
    plan = gcs.Campaign(file, sessions=3).plan
    plan.write(out)
    (kept,) = table.read(out, plan.campaign).to_pylist()
    fails = [{**kept, "row": k, "session": k, "ok": False, "error": "killed", "digest": None} for k in (1, 2)]
    for part in (out / "rows").glob("*.parquet"):
        part.unlink()
    writer = table.Writer(out, plan.campaign)
    for rows in ([kept, *fails],) if beside else ([kept], fails):
        writer.write(rows)
    assert gcs_command("campaign", "resume", str(out), "--quiet").returncode == 1
    assert table.read(out, plan.campaign)["error"].to_pylist() == [None, "killed", "killed"]
    assert gcs_command("campaign", "resume", str(out), "--errors", "--quiet").returncode == 0
    again = table.read(out, plan.campaign)
    assert (again["row"].to_pylist(), again["error"].to_pylist()) == ([0, 1, 2], [None] * 3)
    digests = again["digest"].to_pylist()
    assert digests[0] == "sha256:x"
    assert all(len(digest) == len("sha256:") + 64 for digest in digests[1:])


CODE = """
class Own:
    def __init__(self, scenario):
        pass

    def plan(self, vehicle, situation):
        return vehicle.p_now_ned(), (0.0, 0.0, 0.0)

    def choose(self, request):
        return request.candidates[0].sysid

def near(seed):
    import pathlib
    import yaml
    return yaml.safe_load((pathlib.Path(__file__).parent / "near.yaml").read_text())
"""


@pytest.mark.parametrize(
    ("module", "content"),
    [
        ("own_planner", {"set": {"planner.method": "own_planner:Own"}}),
        ("own_policies", {"vary": {"competition.policy": ["own_policies:Own"]}}),
        ("own_drawn", {"draw": {"competition.policy": {"choice": ["optimal", "own_drawn:Own"]}}}),
        ("own_family", {"scenario": None, "generate": "own_family:near"}),
    ],
)
def test_changed_code_that_a_campaign_names_is_not_mixed_in(
    module: str, content: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    source, out = tmp_path / f"{module}.py", tmp_path / "flown"
    source.write_text(CODE, encoding="utf-8")
    file = begun(tmp_path, **content)
    again = ["resume", str(out), "--quiet", "--trust"]
    assert CliRunner().invoke(campaign, again, standalone_mode=False).return_value == 0
    source.write_text(CODE.replace("(0.0,", "(0.1,"), encoding="utf-8")
    refused = CliRunner().invoke(campaign, again)
    assert refused.exit_code == 2
    assert f"{module}.py: was changed since its sessions were flown" in " ".join(refused.output.split())
    with pytest.raises(gcs.ScenarioError, match=rf"{module}\.py: was changed since its sessions were flown"):
        gcs.Campaign(file, out=out, trust=True).fly()
    assert CliRunner().invoke(campaign, ["status", str(out)], standalone_mode=False).return_value == 0
    about = json.loads((out / "plan.json").read_text(encoding="utf-8"))
    del about["sources"]  # as folders were written before
    (out / "plan.json").write_text(json.dumps(about), encoding="utf-8")
    assert CliRunner().invoke(campaign, again, standalone_mode=False).return_value == 0
