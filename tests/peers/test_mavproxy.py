"""MAVProxy, in a process of its own, with real vehicle processes: what is typed, and what it says."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path
from typing import Any

import pytest
from conversation import Conversation
from onlookers import mavproxy

PLAN = """QGC WPL 110
0	1	0	16	0	0	0	0	47.397742	8.545594	488.0	1
1	0	3	22	0	0	0	0	0	0	2.0	1
2	0	3	16	0	0	0	0	47.397769	8.545594	2.5	1
3	0	3	16	0.5	0	0	0	47.397769	8.545620	3.0	1
4	0	3	20	0	0	0	0	0	0	0	1
"""
ALARM = re.compile(
    r"error|warn|fail|breach|timeout|timed out|lost|no link|denied|unsupported|rejected|jump|retry|bad |unknown|disab",
    re.IGNORECASE,
)


def at(port: int) -> str:
    """Where MAVProxy waits for a vehicle."""
    return f"udpin:127.0.0.1:{port}"


def connected(talk: Conversation) -> None:
    talk.hear("online system 1", "GPS lock", "Received", "parameters")


def alarms(talk: Conversation) -> list[str]:
    return [line for line in talk.said.splitlines() if ALARM.search(line)]


@pytest.mark.parametrize("autopilot", ["px4", "ardupilot"])
def test_it_connects_without_an_error_or_a_warning(
    peers: Path, port: int, fly: Any, tmp_path: Path, autopilot: str
) -> None:
    fly(port, 1, "--autopilot", autopilot)
    with mavproxy(peers, at(port), tmp_path) as talk:
        connected(talk)
        talk.type("fence list")
        talk.hear("0 fence items")
        talk.type("rally list")
        talk.hear("0 rally items")
        talk.type("wp list")
        talk.hear("0 waypoints")
        assert alarms(talk) == []


def test_it_tunes_arms_takes_off_guides_and_flies_a_waypoint_file(
    peers: Path, port: int, fly: Any, tmp_path: Path
) -> None:
    plan = tmp_path / "plan.txt"
    plan.write_text(PLAN)
    fly(port, 1, "--autopilot", "ardupilot")
    with mavproxy(peers, at(port), tmp_path) as talk:
        connected(talk)
        talk.type("param set MPC_XY_CRUISE 4")
        talk.ask("param fetch MPC_XY_CRUISE", "MPC_XY_CRUISE = 4.0")
        talk.type(f"wp load {plan}")
        talk.hear("Loaded 5 waypoints", "Got MISSION_ACK: TYPE_MISSION: ACCEPTED")
        talk.type("mode guided")
        talk.hear("Mode GUIDED")
        talk.type("arm throttle")
        talk.hear("ARMED")
        talk.type("takeoff 2")
        talk.hear("NAV_TAKEOFF: ACCEPTED", "Guided, hold")
        talk.type("guided 47.397751 8.545594 2.5")
        talk.hear("DO_REPOSITION: ACCEPTED")
        talk.type("set guided_use_reposition 0")
        talk.type("guided 47.397760 8.545594 2.5")
        talk.hear("Got MISSION_ACK: TYPE_MISSION: ACCEPTED")
        talk.type("mode loiter")
        talk.hear("Mode LOITER")
        talk.type("mode auto")
        talk.hear("Mode AUTO", "waypoint 2", "waypoint 3", "Mode RTL", "Mode LAND", "DISARMED")
        assert alarms(talk) == []


def test_a_px4_is_armed_taken_off_and_landed_by_commands(peers: Path, port: int, fly: Any, tmp_path: Path) -> None:
    """MAVProxy 1.8.75 cannot send a PX4's modes by name; a PX4's altitudes are above sea level."""
    fly(port)
    with mavproxy(peers, at(port), tmp_path) as talk:
        connected(talk)
        talk.type("arm throttle")
        talk.hear("ARMED")
        talk.type("takeoff 490")
        talk.hear("Mode TAKEOFF", "Mode LOITER")
        talk.type("long MAV_CMD_NAV_LAND")
        talk.hear("Mode LAND", "DISARMED")
        assert alarms(talk) == []


def test_it_gives_a_vehicle_a_key_and_flies_it_signed(peers: Path, port: int, fly: Any, tmp_path: Path) -> None:
    """From then on the vehicle acts on nothing that is not signed, and MAVProxy takes nothing that is not."""
    state = tmp_path / "state"
    fly(port, 1, "--autopilot", "ardupilot", "--state", str(state))
    with mavproxy(peers, at(port), tmp_path) as talk:
        connected(talk)
        talk.type("signing setup swordfish")
        talk.hear("Sent secret_key", "Setup signing key")
        talk.type("mode guided")
        talk.hear("Mode GUIDED")
        talk.type("arm throttle")
        talk.hear("ARMED")
        assert alarms(talk) == []
    assert (state / "1.key").read_text().strip() == hashlib.sha256(b"swordfish").hexdigest()
