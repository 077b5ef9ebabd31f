"""Real autopilots in their own simulators come home apart when gcs is killed: ArduCopters where SKYTENDER_ARDUCOPTER
names one, PX4s (SIH) where SKYTENDER_PX4 names a build.

Four start in a row and change places twenty metres away, so that their ways home cross. A fleet takes a minute or two.
"""

from __future__ import annotations

import contextlib
import itertools
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import pytest
from listener import Listener
from ports import free_port
from real_simulators import ARDUCOPTER, FIRST_PX4, ORIGIN, PX4, PX4_PORT, PX4_SECOND_PORT, TrueWays, simulator
from sessions import Running
from strangers import strangers

SPEED = 3.0
SEPARATION_M = 2.0
APART_M = 4.0
NORTH_M = 20.0
COUNT = 4
HOME_WITHIN_S = 200.0
"""Wall time."""
pytestmark = pytest.mark.timeout(500)


@dataclass(frozen=True)
class Killed:
    """True places (vehicles, times, 3) at these times, when gcs was killed on the same clock, and where all started."""

    times: np.ndarray
    ways: np.ndarray
    killed_s: float
    starts: np.ndarray


def scenario(sysids: list[int], port: int) -> dict[str, Any]:
    external = {"connect": f"udpin:127.0.0.1:{port}", "capacity_j": 150_000, "found_within_s": 60}
    pursuers = [
        {
            "takeoff_m": 4.0,
            "external": {**external, "sysid": sysid},
            "waypoints_m": [[NORTH_M, APART_M * (COUNT - 1 - i), -4.0]],
        }
        for i, sysid in enumerate(sysids)
    ]
    return {
        "schema": 1, "name": "killed", "axes": "ned",
        "origin": dict(zip(("lat_deg", "lon_deg", "alt_m"), ORIGIN, strict=True)),
        "clock": {"mode": "real", "speed": SPEED},
        "goal": {"duration_s": 300.0},
        "planner": {"separation_m": SEPARATION_M, "repulsion_range_m": 2.0, "cruise_m_s": 3.0},
        "vehicles": {"pursuers": pursuers},
    }  # fmt: skip


def fly_until_killed(kind: str, folder: Path) -> Killed:
    """They fly to their places, gcs is killed with all its processes, and they are followed until all have landed."""
    first, port = (FIRST_PX4, PX4_PORT) if kind == "px4" else (1, free_port())
    sysids = [first + i for i in range(COUNT)]
    ends = np.array([[NORTH_M, APART_M * (COUNT - 1 - i), -4.0] for i in range(COUNT)])

    def there(seen: dict[str, Any]) -> bool:
        places = [one["p_ned"] for one in seen["vehicles"]]
        return None not in places and float(np.linalg.norm(np.array(places) - ends, axis=1).max()) < 1.5

    with TrueWays(PX4_SECOND_PORT if kind == "px4" else 0) as truth:
        second = f"udpclient:127.0.0.1:{truth.port}"
        programs = [
            simulator(kind, sysid, port, folder / str(sysid), APART_M * i, SPEED, second)
            for i, sysid in enumerate(sysids)
        ]
        with strangers(folder / "said", *programs):
            running = Running(scenario(sysids, port), folder, "--json", "--set", "preflight=enforce")
            try:
                running.wait_for(there)
                killed_s = time.monotonic()
                for process in running.family():
                    with contextlib.suppress(psutil.NoSuchProcess):
                        process.kill()
            finally:
                running.stop()
            with Listener(port) as ear:
                ear.until_disarmed(sysids, HOME_WITHIN_S)
    times, ways = truth.read()
    return Killed(times, ways, killed_s, np.array([[0.0, APART_M * i, 0.0] for i in range(COUNT)]))


@pytest.mark.parametrize(
    "kind",
    [
        pytest.param("arducopter", marks=pytest.mark.skipif(not ARDUCOPTER, reason="SKYTENDER_ARDUCOPTER is not set")),
        pytest.param("px4", marks=pytest.mark.skipif(not PX4, reason="SKYTENDER_PX4 is not set")),
    ],
)
def test_when_gcs_is_killed_four_come_home_one_by_one_and_land_apart(kind: str, tmp_path: Path) -> None:
    """By their simulators' truth none comes nearer to another than separation_m, from the kill to the ground."""
    killed = fly_until_killed(kind, tmp_path)
    after = killed.ways[:, killed.times >= killed.killed_s]
    nearest_m = min(
        float(np.linalg.norm(after[a] - after[b], axis=1).min()) for a, b in itertools.combinations(range(COUNT), 2)
    )
    tops_m = np.sort(-after[:, :, 2].min(axis=1))
    from_start_m = np.linalg.norm(after[:, -1, :2] - killed.starts[:, :2], axis=1)
    print(f"nearest pair {nearest_m:.2f} m; heights {tops_m.round(2)}; from their starts {from_start_m.round(2)}")
    assert nearest_m > SEPARATION_M
    assert from_start_m.max() < 2.0
