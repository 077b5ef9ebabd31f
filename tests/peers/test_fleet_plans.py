"""A plan that `gcs mission set` has written, as MAVSDK and MAVProxy read it from the vehicle."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest
import survey_plans
from commands import gcs
from onlookers import mavproxy
from patience import PATIENCE_S

SCRIPT = Path(__file__).with_name("plans_by_mavsdk.py")


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    path = tmp_path / "survey.plan"
    content = survey_plans.plan(second_rally_m=41.0)
    content["mission"]["items"][0]["params"] = (0, *content["mission"]["items"][0]["params"][1:])
    path.write_text(json.dumps(content))
    return path


def written(plan: Path, port: int) -> None:
    done = gcs("mission", "set", str(plan), "--connect", f"udpin:127.0.0.1:{port}", "--wait", "40")
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize(("autopilot", "home"), [("px4", "0"), ("ardupilot", "1")])
def test_mavsdk_reads_what_it_reads_in_the_file(
    peers: Path, port: int, fly: Any, plan: Path, autopilot: str, home: str
) -> None:
    fly(port, 1, "--autopilot", autopilot)
    written(plan, port)
    argv = [str(peers / "python"), str(SCRIPT), str(port), str(plan), home]
    done = subprocess.run(argv, capture_output=True, text=True, timeout=2.0 * PATIENCE_S, check=False)
    assert done.returncode == 0, done.stdout[-1500:] + done.stderr[-3000:]
    assert done.stdout.split("\n")[-4:-1] == ["mission 20", "fence 4", "rally 2"]


def test_mavproxy_saves_the_mission_that_was_written(
    peers: Path, port: int, fly: Any, plan: Path, tmp_path: Path
) -> None:
    fly(port, 1, "--autopilot", "ardupilot")
    written(plan, port)
    saved = tmp_path / "saved.txt"
    with mavproxy(peers, f"udpin:127.0.0.1:{port}", tmp_path) as talk:
        talk.hear("online system 1", "Received", "parameters")
        talk.type("wp list")
        talk.hear("Requesting 21 waypoints")
        talk.type(f"wp save {saved}")
        talk.hear("Saved 21 waypoints")
    differs = gcs("mission", "diff", str(saved), "--connect", f"udpin:127.0.0.1:{port}", "--wait", "40")
    assert (differs.returncode, differs.stdout) == (0, "vehicle 1: no difference\n")
    rows = [line.split() for line in saved.read_text().splitlines()[2:]]
    own = json.loads(plan.read_text())["mission"]["items"]
    assert [int(row[3]) for row in rows] == [one["command"] for one in own]
    placed = [(row, one) for row, one in zip(rows, own, strict=True) if one["frame"] != 2]
    assert [float(row[8]) for row, _ in placed] == pytest.approx([one["params"][4] for _, one in placed], abs=2e-7)
