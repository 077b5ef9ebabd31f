"""MAVSDK reads a vehicle's metadata and its events."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

from patience import PATIENCE_S
from quick_vehicles import Fly

from skytender.vehicle.parameters import ALONE, TABLE

SCRIPT = Path(__file__).with_name("events_by_mavsdk.py")


def test_mavsdk_has_the_metadata_and_says_the_events(peers: Path, fly: Fly, port: int) -> None:
    fly(port)
    argv = [str(peers / "python"), str(SCRIPT), str(port)]
    done = subprocess.run(argv, capture_output=True, text=True, timeout=2.0 * PATIENCE_S, check=False)
    assert done.returncode == 0, done.stdout[-1500:] + done.stderr[-3000:]
    learnt = json.loads(done.stdout.splitlines()[-1])
    parameters = {row["name"]: row for row in learnt["files"]["PARAMETER"]["parameters"]}
    assert parameters.keys() == {row.name for row in (*TABLE, *ALONE)}
    assert parameters["MPC_XY_CRUISE"]["units"] == "m/s"
    said = [message for message, _, namespace in learnt["said"] if namespace == "skytender"]
    flown = ["Armed", "Take-off", "Land", "Landed, disarmed"]
    assert [message for message in said if message in flown] == flown
    assert {level for message, level, _ in learnt["said"] if message in flown} == {"INFO"}
