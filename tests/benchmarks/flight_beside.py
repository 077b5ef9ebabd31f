"""Figure 17: the flight law of fleets beside closed loops of other simulators, which `make simulators` installs."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from pathlib import Path

import laws
from measure import ROOT, Figure

PYTHON = Path(os.environ.get("SKYTENDER_SIMULATORS", ROOT / ".venv-simulators" / "bin" / "python"))
FLEETS = (1, 100, 10_000)
PEERS = {"crazyflow": FLEETS, "gym-pybullet-drones": (1,), "pyflyt": (1,), "rotorpy": (1,)}
"""And the fleets that each flies here: the last three fly one vehicle after the other, each at the same cost."""
PATIENCE_S = 600.0


def figures() -> list[Figure]:
    ours = {n: laws.vehicle_seconds(n) for n in FLEETS}
    made = []
    for peer, fleets in PEERS.items():
        for n in fleets:
            name, version, value = f"law, fleet of {n:,}", *_beside(peer, n)
            goal = 1.0 if value else None
            made.append(
                Figure(
                    17, name, ours[n], "vehicle-s/CPU s", goal, goal_is_ratio=bool(value), peer=f"{peer}{version}",
                    peer_value=value,
                )
            )  # fmt: skip
    return made


def _beside(peer: str, n: int) -> tuple[str, float | None]:
    """Its version, or why there is none, and its vehicle-seconds per CPU second."""
    if not PYTHON.exists():
        return ": see `make simulators`", None
    command = [str(PYTHON), str(Path(__file__).with_name("simulators.py")), peer, f"{n}"]
    environment = {**os.environ, "JAX_PLATFORMS": "cpu"}
    with tempfile.TemporaryDirectory() as folder:  # for the logs that they write where they are called
        done = subprocess.run(
            command, cwd=folder, env=environment, capture_output=True, text=True, timeout=PATIENCE_S, check=False
        )
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)} failed:\n{done.stderr}")
    said = json.loads(done.stdout.splitlines()[-1])
    return (": not installed", None) if "missing" in said else (f" {said['version']}", said["vehicle_seconds"])
