"""MAVSDK flies real vehicle processes, nothing special-cased; `with_mavsdk.py` is what it flies."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import pytest
from patience import PATIENCE_S
from ports import free_port
from quick_vehicles import Fly, flying

SCRIPT = Path(__file__).with_name("with_mavsdk.py")
PX4_SCENES = ("flight", "offboard", "mission", "follow", "failures", "motor")
IDENTITIES = ("ardupilot", "generic")
FOUR = ("1", "2", "3", "4")


def start_four(fly: Fly, port: int, _: Path) -> None:
    for sysid in map(int, FOUR):
        fly(port, sysid, "--position", f"0,{3 * sysid},0")


SCENES: dict[str, tuple[list[str], Callable[[Fly, int, Path], None]]] = {
    **{scene: ([scene], lambda fly, port, _: fly(port)) for scene in (*PX4_SCENES, "reboot_forgets")},
    "ardupilot": (["identity"], lambda fly, port, _: fly(port, 1, "--autopilot", "ardupilot")),
    "generic": (["identity"], lambda fly, port, _: fly(port, 1, "--autopilot", "generic")),
    "four": (["four", *FOUR], start_four),
    "reboot_keeps": (["reboot_keeps"], lambda fly, port, folder: fly(port, 1, "--state", str(folder / "state"))),
}
"""Arguments of `with_mavsdk.py`, and what starts the vehicles."""


def flown(peers: Path, scene: str, port: int, folder: Path) -> None:
    """Run a scene; what MAVSDK and the scene said is the reason where it fails."""
    arguments, start = SCENES[scene]
    with flying(folder) as fly:
        start(fly, port, folder)
        argv = [str(peers / "python"), str(SCRIPT), str(port), *arguments]
        done = subprocess.run(argv, capture_output=True, text=True, timeout=2.0 * PATIENCE_S, check=False)
    assert done.returncode == 0, done.stdout[-1500:] + done.stderr[-3000:]


@pytest.fixture(scope="module")
def scenes(peers: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Future[None]]:
    """All scenes at once, each with vehicles and a port of its own: what they take is real time, and little else."""
    with ThreadPoolExecutor(len(SCENES)) as pool:
        return {
            scene: pool.submit(flown, peers, scene, free_port(), tmp_path_factory.mktemp(scene)) for scene in SCENES
        }


@pytest.mark.parametrize("scene", PX4_SCENES)
def test_px4_flies(scenes: dict[str, Future[None]], scene: str) -> None:
    scenes[scene].result()


@pytest.mark.parametrize("autopilot", IDENTITIES)
def test_other_identities_fly_too(scenes: dict[str, Future[None]], autopilot: str) -> None:
    scenes[autopilot].result()


def test_four_on_one_port_obey_only_their_own(scenes: dict[str, Future[None]]) -> None:
    scenes["four"].result()


def test_parameters_and_mission_survive_a_reboot_with_a_state(scenes: dict[str, Future[None]]) -> None:
    scenes["reboot_keeps"].result()


def test_parameters_and_mission_are_forgotten_by_a_reboot_without_a_state(scenes: dict[str, Future[None]]) -> None:
    scenes["reboot_forgets"].result()
