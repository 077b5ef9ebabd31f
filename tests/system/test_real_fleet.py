"""Three real autopilots in their own simulators at three times real time: ArduCopters where SKYTENDER_ARDUCOPTER names
one, PX4s (SIH) where SKYTENDER_PX4 names a build.

What is set up before a flight, what is kept in it, and what is fetched after it. Each fleet takes two minutes.
"""

from __future__ import annotations

import hashlib
import json
import math
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import copter_names
import pytest
import yaml
from commands import gcs
from ports import free_port
from real_simulators import ARDUCOPTER, FIRST_PX4, ORIGIN, PX4, PX4_PORT, simulator
from sessions import Outcome, fly_apart
from strangers import strangers

SPEED = 3.0
FENCE_M = 12.0
BEYOND_M = 25.0
STOPS_WITHIN_M = 3.0
"""Beyond the fence, from 1.6 m/s: PX4 1.18 brakes in 1.6 m and drifts on, to 2.2 m, while it holds for 5 s before it
returns (COM_FAIL_ACT_T)."""
FETCHED_WITHIN_S = 300.0
"""Flight, landing, and 110 MB of logs: PX4 writes 0.6 MB in a second of its time."""
SETTINGS = {
    "arducopter": (
        "FENCE_ENABLE=1", "FENCE_TYPE=4", "FENCE_ACTION=1", "LOG_FILE_DSRMROT=1", "LOG_DISARMED=0",
        *(
            f"{name}={value:g}"
            for known in (copter_names.height_of_return(ARDUCOPTER, 6.0), copter_names.speed(ARDUCOPTER, 3.0))
            for name, value in known.items()
        ),
    ),
    "px4": (
        "GF_ACTION=3", "GF_SOURCE=0", "RTL_RETURN_ALT=6", "RTL_DESCEND_ALT=4", "RTL_LAND_DELAY=0", "MPC_XY_CRUISE=3",
        "SDLOG_MODE=0",
    ),
}  # fmt: skip
"""The fence sends who crosses it home; a log is of one flight."""
pytestmark = pytest.mark.timeout(400)


@dataclass(frozen=True)
class Fleet:
    """Which autopilots fly, by system id; the middle one is sent beyond the fence."""

    name: str
    kinds: dict[int, str]

    @property
    def missing(self) -> str:
        """The variable that names no program."""
        needed = {"arducopter": ("SKYTENDER_ARDUCOPTER", ARDUCOPTER), "px4": ("SKYTENDER_PX4", PX4)}
        return next((needed[kind][0] for kind in self.kinds.values() if not needed[kind][1]), "")

    @property
    def sysids(self) -> list[int]:
        return list(self.kinds)

    @property
    def beyond(self) -> int:
        return self.sysids[1]


FLEETS = (
    Fleet("arducopters", dict.fromkeys((1, 2, 3), "arducopter")),
    Fleet("px4s", dict.fromkeys(range(FIRST_PX4, FIRST_PX4 + 3), "px4")),
)


@dataclass
class Flown:
    fleet: Fleet
    outcome: Outcome
    set_s: float
    checked: dict[str, Any]
    own_logs: dict[int, Path]

    @property
    def said(self) -> str:
        return (self.outcome.folder / "session.log").read_text(encoding="utf-8")


@pytest.fixture(scope="module", params=FLEETS, ids=lambda fleet: fleet.name)
def flown(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Flown]:
    """Parameters are set, the list is checked, and each flies along its line to the north, one of them to the fence.

    Without the safety layer, which would not let it go there: that the autopilot keeps the fence itself is to be seen.
    """
    fleet: Fleet = request.param
    if fleet.missing:
        pytest.skip(f"{fleet.missing} names no program")
    folder = tmp_path_factory.mktemp(fleet.name)
    port = PX4_PORT if "px4" in fleet.kinds.values() else free_port()
    at = f"udpin:127.0.0.1:{port}"
    rules = {"connect": at, "capacity_j": 150_000, "found_within_s": 60, "at_end": "land"}
    made = {
        "schema": 1, "name": "real", "axes": "ned",
        "origin": dict(zip(("lat_deg", "lon_deg", "alt_m"), ORIGIN, strict=True)),
        "clock": {"mode": "real", "speed": SPEED}, "logs": True,
        "goal": {"duration_s": 60.0, "lost_at_most": 3, "waypoints": "none"},
        "planner": {"separation_m": 2.0, "repulsion_range_m": 2.0, "safety": False},
        "fence": {"inside": [{"polygon_m": [[-20, -20], [FENCE_M, -20], [FENCE_M, 20], [-20, 20]]}]},
        "vehicles": {"pursuers": [
            {"external": {**rules, "sysid": sysid},
             "waypoints_m": [[BEYOND_M if sysid == fleet.beyond else 6.0, 8.0 * (sysid - fleet.beyond), -4.0]]}
            for sysid in fleet.sysids
        ]},
    }  # fmt: skip
    file = folder / "real.yaml"
    file.write_text(yaml.safe_dump(made), encoding="utf-8")
    ids = {kind: [word for sysid in fleet.sysids if fleet.kinds[sysid] == kind for word in ("--sysid", str(sysid))]
           for kind in dict.fromkeys(fleet.kinds.values())}  # fmt: skip
    programs = (
        simulator(fleet.kinds[sysid], sysid, port, folder / str(sysid), 8.0 * (sysid - fleet.beyond), SPEED)
        for sysid in fleet.sysids
    )
    with strangers(folder / "said", *programs):
        for kind, words in ids.items():  # until they are there
            gcs("params", "get", SETTINGS[kind][0].split("=")[0], "--connect", at, "--wait", "90", *words, "--json")
        began_s = time.monotonic()
        done = [gcs("params", "set", *SETTINGS[kind], "--connect", at, *words) for kind, words in ids.items()]
        set_s = time.monotonic() - began_s
        assert not any(one.returncode for one in done), [one.stdout + one.stderr for one in done]
        checked = json.loads(gcs("check", str(file), "--wait-ready", "120", "--json").stdout)
        outcome = fly_apart(made, folder, patience_s=FETCHED_WITHIN_S)
        own = {sysid: max(p for p in (folder / str(sysid)).rglob("*") if p.suffix in (".BIN", ".ulg"))
               for sysid in fleet.sysids}  # fmt: skip
        yield Flown(fleet, outcome, set_s, checked, own)


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
    """One is told to go 25 m north. Each one's own frame begins at its home, on the common frame's zero line."""
    fleet = flown.fleet
    for sysid in fleet.sysids:
        fence = next(item for item in flown.outcome.vehicle(sysid)["check_list"] if item["key"] == "fence")
        assert fence["passed"], fence
    north_m = dict.fromkeys(fleet.sysids, -math.inf)
    for _, m in flown.outcome.messages("LOCAL_POSITION_NED"):
        north_m[m.get_srcSystem()] = max(north_m[m.get_srcSystem()], m.x)
    print("farthest north:", {sysid: round(n, 2) for sysid, n in north_m.items()})
    assert 5.0 < north_m[fleet.sysids[0]] < 8.0
    assert 9.0 < north_m[fleet.beyond] <= FENCE_M + STOPS_WITHIN_M


def test_three_times_real_time_is_held(flown: Flown) -> None:
    summary = flown.outcome.summary
    print(f"speed: {summary['speed_achieved']:.2f}")
    assert summary["speed_achieved"] == pytest.approx(SPEED, rel=0.05)
    assert "does not keep speed" not in flown.said
    for sysid in flown.fleet.sysids:
        boots = [m.time_boot_ms / 1e3 for _, m in flown.outcome.messages("ATTITUDE") if m.get_srcSystem() == sysid]
        assert boots[-1] - boots[0] == pytest.approx(summary["sim_time_s"], abs=4.0)


def test_logs_lie_in_the_sessions_folder_equal_by_checksum(flown: Flown) -> None:
    logs = flown.outcome.folder / "logs"
    content = json.loads((logs / "logs.json").read_text(encoding="utf-8"))
    assert content["problems"] == []
    assert sorted(row["sysid"] for row in content["files"]) == flown.fleet.sysids
    for row in content["files"]:
        own = flown.own_logs[row["sysid"]].read_bytes()
        print(f"log of {row['sysid']}: {row['size_bytes']} bytes")
        assert row["sha256"] == hashlib.sha256(own).hexdigest()
