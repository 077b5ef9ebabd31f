"""A campaign's folder is gone on with only by what its sessions were flown by."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

import gcs
from gcs.campaign import table

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


def begun(folder: Path) -> Path:
    """A campaign's file beside its scenario, and its folder `flown`, which has the only row."""
    (folder / "near.yaml").write_text(SCENARIO, encoding="utf-8")
    file = folder / "campaign.yaml"
    file.write_text(yaml.safe_dump({"schema": 1, "name": "near", "scenario": "near.yaml", "sessions": 1}))
    flown = folder / "flown"
    flown.mkdir()
    plan = gcs.Campaign(file).plan
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
