"""What stands in a campaign's folder is gone on with as it began, or refused."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pyarrow.compute as pc
import pyarrow.parquet as pq
import pytest
import yaml
from commands import gcs

CAMPAIGN: dict[str, Any] = {
    "schema": 1, "name": "kept", "scenario": "paper/example1", "sessions": 1, "seed": 7,
    "set": {"goal.duration_s": 5}, "measure": ["outcome", "min_clearance_m"],
}  # fmt: skip
SEARCH = {
    "search": {"minimise": "min_clearance_m", "trials": 4, "batch": 2},
    "draw": {"planner.cruise_m_s": {"uniform": [0.8, 2.0]}},
}


def test_a_search_that_is_stopped_goes_on_and_flies_its_own_trials(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "small.yaml").write_text(yaml.safe_dump({**CAMPAIGN, **SEARCH}), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert gcs("campaign", "search", "small.yaml", "--out", "whole", "--quiet").returncode == 0
    folder = tmp_path / "stopped"
    shutil.copytree(tmp_path / "whole", folder)
    (folder / "worst.yaml").unlink()
    parts = sorted((folder / "rows").glob("*.parquet"))
    flown = pq.read_table(folder / "rows")
    for part in parts:
        part.unlink()
    pq.write_table(flown.filter(pc.less(flown["row"], 2)), parts[0])
    assert gcs("campaign", "resume", "stopped", "--quiet").returncode == 0
    assert (folder / "worst.yaml").read_bytes() == (tmp_path / "whole" / "worst.yaml").read_bytes()
    digests = dict(zip(flown["row"].to_pylist(), flown["digest"].to_pylist(), strict=True))
    again = gcs("campaign", "fly", "stopped", "3", "--out", "three", "--quiet")
    assert json.loads((tmp_path / "three" / "summary.json").read_text(encoding="utf-8"))["digest"] == digests[3]
    assert "other versions" not in again.stderr


def test_a_campaign_whose_file_is_changed_is_not_gone_on_with(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "small.yaml").write_text(yaml.safe_dump(CAMPAIGN), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    gcs("campaign", "run", "small.yaml", "--out", "kept", "--quiet")
    file = tmp_path / "kept" / "campaign.yaml"
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace("goal.duration_s: 5", "goal.duration_s: 6"), encoding="utf-8")
    done = gcs("campaign", "resume", "kept")
    assert (done.returncode, "was changed since its sessions were flown" in done.stderr) == (2, True)
    file.write_text(text.replace("sessions: 1", "sessions: 2"), encoding="utf-8")
    assert "kept  2 of 2" in gcs("campaign", "resume", "kept", "--plain").stdout
    assert gcs("campaign", "shrink", "small.yaml", "--out", "small.yaml").returncode == 2
