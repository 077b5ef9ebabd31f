"""MAVSDK flies real vehicle processes, nothing special-cased; `with_mavsdk.py` is what it flies."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

import pytest

SCRIPT = Path(__file__).with_name("with_mavsdk.py")
WITHIN_S = 55.0
pytestmark = pytest.mark.timeout(60)


def flown(peers: Path, port: int, scene: str, *sysids: str) -> None:
    """Run a scene; what MAVSDK and the scene said is the reason where it fails."""
    argv = [str(peers / "python"), str(SCRIPT), str(port), scene, *sysids]
    done = subprocess.run(argv, capture_output=True, text=True, timeout=WITHIN_S, check=False)
    assert done.returncode == 0, done.stdout[-1500:] + done.stderr[-3000:]


@pytest.mark.parametrize("scene", ["flight", "offboard", "mission", "follow", "failures", "motor"])
def test_px4_flies(peers: Path, port: int, fly: Any, scene: str) -> None:
    fly(port)
    flown(peers, port, scene)


@pytest.mark.parametrize("autopilot", ["ardupilot", "generic"])
def test_other_identities_fly_too(peers: Path, port: int, fly: Any, autopilot: str) -> None:
    fly(port, 1, "--autopilot", autopilot)
    flown(peers, port, "identity")


def test_four_on_one_port_obey_only_their_own(peers: Path, port: int, fly: Any) -> None:
    for sysid in (1, 2, 3, 4):
        fly(port, sysid, "--position", f"0,{3 * sysid},0")
    flown(peers, port, "four", "1", "2", "3", "4")


def test_parameters_and_mission_survive_a_reboot_with_a_state(peers: Path, port: int, fly: Any, tmp_path: Path) -> None:
    fly(port, 1, "--state", str(tmp_path / "state"))
    flown(peers, port, "reboot_keeps")


def test_parameters_and_mission_are_forgotten_by_a_reboot_without_a_state(peers: Path, port: int, fly: Any) -> None:
    fly(port)
    flown(peers, port, "reboot_forgets")
