"""A log that MAVProxy wrote: replayed and exported, against what pymavlink reads in it."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pandas as pd
import pytest
from conversation import Conversation
from pymavlink import mavutil
from sessions import GCS


@pytest.fixture
def tlog(peers: Path, port: int, fly: Any, tmp_path: Path) -> Path:
    """A flight of an ArduPilot vehicle of ours under MAVProxy: armed, taken off, told to land; then it is killed."""
    fly(port, 5, "--autopilot", "ardupilot")
    argv = [str(peers / "python"), "-u", str(peers / "mavproxy.py"), f"--master=udpin:127.0.0.1:{port}"]
    argv += [f"--state-basedir={tmp_path}", "--aircraft=peer", "--mav20"]
    with subprocess.Popen(
        argv, cwd=tmp_path, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    ) as process:
        try:
            talk = Conversation(process)
            talk.hear("online system 5", "GPS lock", "Received", "parameters")
            talk.type("mode guided")
            talk.hear("Mode GUIDED")
            talk.type("arm throttle")
            talk.hear("ARMED")
            talk.type("takeoff 2")
            talk.hear("NAV_TAKEOFF: ACCEPTED", "Guided, hold")
            talk.type("mode land")
            talk.hear("Mode LAND", "DISARMED")
        finally:
            process.kill()
    found: list[Path] = sorted(tmp_path.rglob("*.tlog"))
    assert len(found) == 1
    return found[0]


def gcs(*argv: str) -> str:
    done = subprocess.run([*GCS, *argv], capture_output=True, text=True, check=True)
    assert "Traceback" not in done.stderr
    return done.stdout


def test_mavproxys_log_replays_and_exports(tlog: Path, tmp_path: Path) -> None:
    reader = mavutil.mavlogfile(str(tlog), robust_parsing=True)
    counted: dict[str, int] = {}
    heights = []
    while (message := reader.recv_match()) is not None:
        counted[message.get_type()] = counted.get(message.get_type(), 0) + 1
        if message.get_type() == "GLOBAL_POSITION_INT":
            heights.append(message.relative_alt / 1e3)
    reader.close()
    assert max(heights) > 1.0

    lines = [json.loads(line) for line in gcs("replay", str(tlog), "--json").splitlines()]
    snapshots = [line for line in lines if line["type"] == "snapshot"]
    flown = [snapshot["vehicles"][0] for snapshot in snapshots if snapshot["vehicles"]]
    assert {vehicle["sysid"] for vehicle in flown} == {5}
    assert flown[-1]["autopilot"] == "ardupilot"
    modes = [vehicle["mode"] for vehicle in flown]
    assert [mode for i, mode in enumerate(modes) if mode not in modes[:i]][-2:] == ["offboard", "land"]
    places = [vehicle["p_ned"] for vehicle in flown if vehicle["p_ned"] is not None]
    climbed = max(-place[2] for place in places) - min(-place[2] for place in places)
    assert climbed == pytest.approx(max(heights) - min(heights), abs=0.6)  # one snapshot a second

    gcs("export", str(tlog), "--format", "csv", "--out", str(tmp_path / "tables"))
    rows = {path.stem: len(pd.read_csv(path)) for path in (tmp_path / "tables").glob("*.csv")}
    known = {name: number for name, number in counted.items() if name != "BAD_DATA" and not name.startswith("UNKNOWN")}
    assert {name: number for name, number in rows.items() if name != "UNKNOWN"} == known
    table = pd.read_csv(tmp_path / "tables" / "GLOBAL_POSITION_INT.csv")
    assert table.relative_alt_m.tolist() == heights
    assert set(pd.read_csv(tmp_path / "tables" / "PARAM_VALUE.csv").direction) == {"from"}
    beats = pd.read_csv(tmp_path / "tables" / "HEARTBEAT.csv")
    assert set(beats[beats.direction == "to"].type) <= {6, 18}
