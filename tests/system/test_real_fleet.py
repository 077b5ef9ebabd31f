"""Three real ArduCopters in their own simulators at three times real time, where SKYTENDER_ARDUCOPTER names one.

What is set up before a flight, what is kept in it, and what is fetched after it. It takes two minutes.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pymap3d
import pytest
import yaml
from commands import gcs
from sessions import Outcome, fly
from strangers import free_port, strangers

PROGRAM = os.environ.get("SKYTENDER_ARDUCOPTER", "")
DEFAULTS = Path("Tools", "autotest", "default_params", "copter.parm")
ORIGIN = (47.397742, 8.545594, 488.0)
COPTERS = (1, 2, 3)
SPEED = 3.0
FENCE_M = 12.0
BEYOND_M = 25.0
SETTINGS = (
    "FENCE_ENABLE=1",
    "FENCE_TYPE=4",
    "FENCE_ACTION=1",
    "RTL_ALT=600",
    "WPNAV_SPEED=300",
    "LOG_FILE_DSRMROT=1",
    "LOG_DISARMED=0",
)
pytestmark = [
    pytest.mark.timeout(400),
    pytest.mark.skipif(not PROGRAM, reason="SKYTENDER_ARDUCOPTER names no ArduCopter's simulator"),
]


def defaults() -> Path:
    """The parameters that ArduPilot's own tests start with."""
    named = os.environ.get("SKYTENDER_ARDUCOPTER_DEFAULTS")
    known = [Path(named)] if named else [folder / DEFAULTS for folder in Path(PROGRAM).resolve().parents]
    known += [folder / "ardupilot" / DEFAULTS for folder in Path(PROGRAM).resolve().parents]
    found = next((path for path in known if path.is_file()), None)
    assert found is not None, f"no {DEFAULTS} around {PROGRAM}: name it with SKYTENDER_ARDUCOPTER_DEFAULTS"
    return found.resolve()


def command(sysid: int, port: int, folder: Path) -> list[str]:
    folder.mkdir()
    lat, lon, alt = pymap3d.ned2geodetic(0.0, 8.0 * (sysid - 2), 0.0, *ORIGIN)
    return [
        "env", "-C", str(folder), PROGRAM, "-w", "--model", "quad", "--speedup", f"{SPEED:g}", "--slave", "0",
        "--sysid", str(sysid), "-I", str(20 + sysid), "--defaults", str(defaults()),
        "--home", f"{lat:.7f},{lon:.7f},{alt:.2f},0", "--sim-address", "127.0.0.1", "--rc-in-port", str(free_port()),
        "--serial0", f"udpclient:127.0.0.1:{port}", "--serial1", "none", "--serial2", "none",
    ]  # fmt: skip


@dataclass
class Flown:
    outcome: Outcome
    set_s: float
    settings: dict[str, Any]
    checked: dict[str, Any]
    own_logs: dict[int, Path]

    @property
    def said(self) -> str:
        return (self.outcome.folder / "session.log").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Flown]:
    """Parameters are set, the list is checked, and each flies along its line to the north, the second to the fence."""
    folder = tmp_path_factory.mktemp("copters")
    port = free_port()
    at = f"udpin:127.0.0.1:{port}"
    rules = {"connect": at, "capacity_j": 150_000, "found_within_s": 60, "at_end": "land"}
    made = {
        "schema": 1, "name": "real", "axes": "ned",
        "origin": dict(zip(("lat_deg", "lon_deg", "alt_m"), ORIGIN, strict=True)),
        "clock": {"mode": "real", "speed": SPEED}, "logs": True,
        "goal": {"duration_s": 60.0, "lost_at_most": 3, "waypoints": "none"},
        "planner": {"separation_m": 2.0, "repulsion_range_m": 2.0},
        "fence": {"inside": [{"polygon_m": [[-20, -20], [FENCE_M, -20], [FENCE_M, 20], [-20, 20]]}]},
        "vehicles": {"pursuers": [
            {"external": {**rules, "sysid": sysid},
             "waypoints_m": [[BEYOND_M if sysid == 2 else 6.0, 8.0 * (sysid - 2), -4.0]]}
            for sysid in COPTERS
        ]},
    }  # fmt: skip
    file = folder / "real.yaml"
    file.write_text(yaml.safe_dump(made), encoding="utf-8")
    ids = [word for sysid in COPTERS for word in ("--sysid", str(sysid))]
    with strangers(folder / "said", *(command(sysid, port, folder / str(sysid)) for sysid in COPTERS)):
        gcs("params", "get", "SYSID_THISMAV", "--connect", at, "--within", "90", *ids, "--json")  # until they are there
        began_s = time.monotonic()
        done = gcs("params", "set", *SETTINGS, "--connect", at, *ids, "--json")
        set_s = time.monotonic() - began_s
        assert done.returncode == 0, done.stdout + done.stderr
        checked = json.loads(gcs("check", str(file), "--wait-ready", "120", "--json").stdout)
        outcome = fly(made, folder)
        own = {sysid: max((folder / str(sysid) / "logs").glob("*.BIN")) for sysid in COPTERS}
        yield Flown(outcome, set_s, json.loads(done.stdout), checked, own)


def test_parameters_of_three_are_set_and_verified_within_ten_seconds(flown: Flown) -> None:
    print(f"parameters: {flown.set_s:.1f} s")
    assert flown.set_s < 10.0


def test_the_check_list_passes_before_the_flight(flown: Flown) -> None:
    failed = [(v["sysid"], i) for v in flown.checked["vehicles"] for i in v["check_list"] if not i["passed"]]
    assert not failed
    for vehicle in flown.checked["vehicles"]:
        keys = {item["key"] for item in vehicle["check_list"]}
        assert {"fence", "origin", "pace", "ready", "streams"} <= keys


def test_the_fence_is_there_and_kept(flown: Flown) -> None:
    """The second is told to go 25 m north. Each one's own frame begins at its home, on the common frame's zero line."""
    for sysid in COPTERS:
        fence = next(item for item in flown.outcome.vehicle(sysid)["check_list"] if item["key"] == "fence")
        assert fence["passed"], fence
    north_m = dict.fromkeys(COPTERS, -math.inf)
    for _, m in flown.outcome.messages("LOCAL_POSITION_NED"):
        north_m[m.get_srcSystem()] = max(north_m[m.get_srcSystem()], m.x)
    print("farthest north:", {sysid: round(n, 2) for sysid, n in north_m.items()})
    assert 5.0 < north_m[1] < 8.0
    assert 9.0 < north_m[2] <= FENCE_M + 2.0  # it brakes from 1.5 m/s and turns back


def test_three_times_real_time_is_held(flown: Flown) -> None:
    summary = flown.outcome.summary
    print(f"speed: {summary['speed_achieved']:.2f}")
    assert summary["speed_achieved"] == pytest.approx(SPEED, rel=0.05)
    assert "does not keep speed" not in flown.said
    for sysid in COPTERS:
        boots = [m.time_boot_ms / 1e3 for _, m in flown.outcome.messages("ATTITUDE") if m.get_srcSystem() == sysid]
        assert boots[-1] - boots[0] == pytest.approx(summary["sim_time_s"], abs=4.0)


def test_logs_lie_in_the_sessions_folder_equal_by_checksum(flown: Flown) -> None:
    logs = flown.outcome.folder / "logs"
    content = json.loads((logs / "logs.json").read_text(encoding="utf-8"))
    assert content["problems"] == []
    assert sorted(row["sysid"] for row in content["files"]) == list(COPTERS)
    for row in content["files"]:
        own = flown.own_logs[row["sysid"]].read_bytes()
        print(f"log of {row['sysid']}: {row['size_bytes']} bytes")
        assert row["sha256"] == hashlib.sha256(own).hexdigest()
