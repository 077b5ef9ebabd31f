"""A plan that `gcs mission set` has written, as MAVSDK and MAVProxy read it from the vehicle."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from onlookers import mavproxy
from patience import PATIENCE_S

SCRIPT = Path(__file__).with_name("plans_by_mavsdk.py")
PLACES = [[47.3977 + 1e-4 * k, 8.5456 - 7e-5 * k] for k in range(18)]


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """Twenty items, two fences, two rally points."""

    def item(command: int, *params: float | None, frame: int = 3, number: int = 0) -> dict[str, Any]:
        return {"type": "SimpleItem", "command": command, "frame": frame, "params": params, "autoContinue": True,
                "doJumpId": number}  # fmt: skip

    ways = [item(16, k % 4, k % 3, 0, None, *PLACES[k], 20.0 + 0.25 * k) for k in range(16)]
    items = [item(22, 0, 0, 0, None, *PLACES[0], 20), item(178, 1, 4.5, -1, 0, 0, 0, 0, frame=2), *ways]
    items += [item(93, 3, -1, -1, -1, 0, 0, 0, frame=2), item(20, 0, 0, 0, 0, 0, 0, 0, frame=2)]
    path = tmp_path / "survey.plan"
    mission = {
        "items": [one | {"doJumpId": k} for k, one in enumerate(items, 1)],
        **{"plannedHomePosition": [*PLACES[0], 488.0], "version": 2, "firmwareType": 12, "vehicleType": 2},
        **{"cruiseSpeed": 15, "hoverSpeed": 5},
    }
    circle = {"circle": {"center": PLACES[0], "radius": 900.5}, "inclusion": True, "version": 1}
    polygon = {"polygon": PLACES[14:17], "inclusion": False, "version": 1}
    content = {
        "fileType": "Plan", "version": 1, "groundStation": "QGroundControl", "mission": mission,
        "geoFence": {"circles": [circle], "polygons": [polygon], "version": 2},
        "rallyPoints": {"points": [[*PLACES[1], 30.0], [*PLACES[2], 41.0]], "version": 2},
    }  # fmt: skip
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
    assert [float(row[8]) for row in rows[2:18]] == pytest.approx([lat for lat, _ in PLACES[:16]], abs=2e-7)
