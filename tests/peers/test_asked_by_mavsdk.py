"""MAVSDK lists modes, sets a standard one, takes control of a real vehicle process and gives it back; CONTROL_STATUS is
read by newer.xml, which its own definitions lack, the modes by its own."""

from __future__ import annotations

import subprocess
from pathlib import Path

from newer import DEFINITIONS
from patience import PATIENCE_S
from quick_vehicles import Fly

SCRIPT = Path(__file__).with_name("asked_by_mavsdk.py")


def test_mavsdk_lists_and_sets_modes_and_takes_control(peers: Path, fly: Fly, port: int) -> None:
    fly(port)
    argv = [str(peers / "python"), str(SCRIPT), str(port), str(DEFINITIONS)]
    done = subprocess.run(argv, capture_output=True, text=True, timeout=2.0 * PATIENCE_S, check=False)
    assert done.returncode == 0, done.stdout[-1500:] + done.stderr[-3000:]
