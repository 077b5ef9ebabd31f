"""A real ArduCopter in its own simulator, where one is named: SKYTENDER_ARDUCOPTER=/path/to/build/sitl/bin/arducopter.

The parameters that it starts with are those of ArduPilot's own tests, in the source tree around the program, or in
the file that SKYTENDER_ARDUCOPTER_DEFAULTS names. It takes two minutes, half of which ArduCopter needs to find its
place. A second link to it stands for the transmitter in somebody's hand.
"""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import Any, NamedTuple

import pymap3d
import pytest
from ports import free_port
from pymavlink.dialects.v20 import ardupilotmega as mav
from sessions import GCS, Outcome, Running
from station import Station
from strangers import strangers

PROGRAM = os.environ.get("SKYTENDER_ARDUCOPTER", "")
DEFAULTS = Path("Tools", "autotest", "default_params", "copter.parm")
ORIGIN = (47.397742, 8.545594, 488.0)
STARTS_M = (-3.0, 2.0, 0.0)
COPTER, TARGET = 7, 101
BRAKE, GUIDED, LAND = 17, 4, 9
CUSTOM = 1.0
RING_M, CAPACITY_J = 3.0, 150_000.0
READY_WITHIN_S = 90.0
pytestmark = pytest.mark.skipif(not PROGRAM, reason="SKYTENDER_ARDUCOPTER names no ArduCopter's simulator")


class Flown(NamedTuple):
    """What came of it."""

    check_status: int
    check: dict[str, Any]
    outcome: Outcome

    @property
    def said(self) -> str:
        return (self.outcome.folder / "session.log").read_text(encoding="utf-8")


def defaults() -> Path:
    """The parameters' file."""
    named = os.environ.get("SKYTENDER_ARDUCOPTER_DEFAULTS")
    known = [Path(named)] if named else [folder / DEFAULTS for folder in Path(PROGRAM).resolve().parents]
    found = next((path for path in known if path.is_file()), None)
    assert found is not None, f"no {DEFAULTS} around {PROGRAM}: name it with SKYTENDER_ARDUCOPTER_DEFAULTS"
    return found.resolve()


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Flown]:
    """It is checked, and then follows a target of ours; on the way somebody takes it for a while."""
    folder = tmp_path_factory.mktemp("arducopter")
    port = free_port()
    lat, lon, alt = pymap3d.ned2geodetic(*STARTS_M, *ORIGIN)
    with Station(COPTER) as hand:
        program = [PROGRAM, "-w", "--model", "quad", "--speedup", "1", "--slave", "0", "--sysid", str(COPTER)]
        program += ["--defaults", str(defaults()), "--home", f"{lat:.7f},{lon:.7f},{alt:.2f},0"]
        program += ["--sim-address", "127.0.0.1", "--rc-in-port", str(free_port())]
        program += ["--serial0", f"udpclient:127.0.0.1:{port}", "--serial1", f"udpclient:127.0.0.1:{hand.port}"]
        program += ["--serial2", "none"]
        with strangers(folder, ["env", "-C", str(folder), *program]):
            hand.hear("HEARTBEAT", within_s=30.0)
            for message in (mav.MAVLINK_MSG_ID_SYS_STATUS, mav.MAVLINK_MSG_ID_LOCAL_POSITION_NED):
                hand.command(mav.MAV_CMD_SET_MESSAGE_INTERVAL, message, 5e5)
            hand.hear("LOCAL_POSITION_NED", within_s=READY_WITHIN_S)
            ready = mav.MAV_SYS_STATUS_PREARM_CHECK
            hand.hear("SYS_STATUS", lambda m: m.onboard_control_sensors_health & ready, READY_WITHIN_S)
            argv = [*GCS, "check", "--arm", "--json", "--connect", f"udpin:127.0.0.1:{port}"]
            checked = subprocess.run(argv, capture_output=True, text=True, timeout=60, check=False)
            running = Running(scenario(port), folder, "--json")
            try:
                running.wait_for(lambda seen: stage(seen) == "fly")
                hand.command(mav.MAV_CMD_DO_SET_MODE, CUSTOM, BRAKE)
                running.wait_for(lambda seen: stage(seen) == "yielded")
                hand.command(mav.MAV_CMD_DO_SET_MODE, CUSTOM, GUIDED)
                running.wait_for(lambda seen: stage(seen) == "fly")
                yield Flown(checked.returncode, json.loads(checked.stdout), running.finish())
            finally:
                running.stop()


def scenario(port: int) -> dict[str, Any]:
    """One to be followed, by one who is somebody else's."""
    path = [[0.0, 0.0, -3.0], [12.0, 0.0, -3.0]]
    external = {"connect": f"udpin:127.0.0.1:{port}", "sysid": COPTER, "capacity_j": CAPACITY_J, "at_end": "land"}
    target = {"sysid": TARGET, "start_m": [0.0, 0.0, 0.0], "battery": {"capacity_j": CAPACITY_J}}
    return {
        "schema": 1,
        "name": "real-arducopter",
        "axes": "ned",
        "origin": dict(zip(("lat_deg", "lon_deg", "alt_m"), ORIGIN, strict=True)),
        "vehicles": {"pursuers": [{"external": external}], "targets": [{**target, "path_m": path, "speed_m_s": 0.5}]},
        "formation": {"ring_m": RING_M},
        "goal": {"duration_s": 40.0, "pursue": {"within_m": RING_M + 1.5, "for_s": 8.0}},
    }


def stage(seen: dict[str, Any]) -> str:
    """How far it is."""
    found: str = next(vehicle["stage"] for vehicle in seen["vehicles"] if vehicle["sysid"] == COPTER)
    return found


def test_the_check_finds_nothing_that_its_peers_would_miss(flown: Flown) -> None:
    assert [f for f in flown.check["findings"] if f["outcome"] in ("missing", "wrong")] == []
    assert (flown.check_status, flown.check["autopilot"]) == (0, "ardupilot")


def test_it_follows_the_target_and_lands_when_nobody_steers_it_any_more(flown: Flown) -> None:
    summary = flown.outcome.summary
    assert (flown.outcome.status, summary["outcome"], summary["completed"]) == (0, "met", True), flown.said
    assert flown.outcome.vehicle(COPTER)["missing_streams"] == []


def test_it_is_left_to_who_takes_it_and_flies_on_when_it_is_given_back(flown: Flown) -> None:
    modes = [m.custom_mode for _, m in flown.outcome.messages("HEARTBEAT") if m.get_srcSystem() == COPTER]
    assert [mode for mode, _ in groupby(modes)][-4:] == [GUIDED, BRAKE, GUIDED, LAND]
    asked = [m.command for _, m in flown.outcome.messages("COMMAND_LONG") if m.target_system == COPTER]
    assert asked.count(mav.MAV_CMD_DO_SET_MODE) == 1  # before it was armed
    assert "A pilot or another station flies it (BRAKE)" in flown.said


def test_it_refuses_nothing_that_it_is_told_once_it_is_armed(flown: Flown) -> None:
    refused, armed = [], False
    for time_s, message in flown.outcome.messages("HEARTBEAT", "COMMAND_ACK"):
        if message.get_srcSystem() == COPTER and message.get_type() == "HEARTBEAT":
            armed |= bool(message.base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED)
        elif message.get_srcSystem() == COPTER and armed and message.result != mav.MAV_RESULT_ACCEPTED:
            refused.append((time_s, message.command, message.result))
    assert refused == []


def test_the_energy_drawn_is_what_it_says_itself(flown: Flown) -> None:
    """By BATTERY_STATUS, in hectojoules since its start."""
    told = [m.energy_consumed for _, m in flown.outcome.messages("BATTERY_STATUS") if m.get_srcSystem() == COPTER]
    energy = flown.outcome.vehicle(COPTER)["energy"]
    assert energy["source"] == "energy_consumed"
    assert energy["drawn_j"] == pytest.approx(100.0 * told[-1], abs=1000.0)
    assert energy["drawn_j"] > 1000.0
