"""An ArduPilot with its simulation in one process, here the stand-in: how it boots, what it says, how it fails."""

from __future__ import annotations

import socket
import sys
from pathlib import Path
from typing import Any

import psutil
import pytest
from autopilot_units import fixes_around_an_outage
from pymavlink.dialects.v20 import common

from simvehicle.mavlink.codec import split
from simvehicle.mavlink.connection import Connection
from simvehicle.sitl import ardupilot_link, ardupilot_process, autopilot_unit
from simvehicle.sitl.ardupilot import ArduPilotUnit
from simvehicle.sitl.ardupilot_process import SERIAL_PORT, simulation_port
from simvehicle.sitl.autopilot_process import HOST, AutopilotError, read_wanted

STAND_IN = Path(__file__).resolve().parents[2] / "peers" / "json_arducopter.py"
COPTER = 7


def unit(
    folder: Path, program: Path | None = None, *, like: str = "4.7", **parameters: float
) -> tuple[ArduPilotUnit, Connection]:
    """The stand-in for a version, or another program, booted. Raises AutopilotError."""
    if program is None:
        program = folder / "arducopter"
        program.write_text(f'#!/bin/sh\nexec {sys.executable} {STAND_IN} --like {like} "$@"\n')
        program.chmod(0o755)
    content: dict[str, Any] = {
        "program": str(program),
        "folder": str(folder / "own"),
        "home": [47.4, 8.5, 488.0],
        "start_ned": [1.0, 2.0, 0.0],
        "yaw_deg": 30.0,
        "epoch_s": 1_700_000_000,
        "battery": {"capacity_j": 60000.0, "initial_j": 30000.0, "hover_w": 200.0, "avionics_w": 10.0},
        "capture_m": 1.5,
        "relative_speed_m_s": 0.5,
        "parameters": parameters,
        "truth": None,
        "world": {"vehicles": {COPTER: {"airframe": "iris"}}},
    }
    wanted, plant = read_wanted(content, COPTER, ArduPilotUnit.step_ms / 1e3)
    connection = Connection(COPTER)
    return ArduPilotUnit(wanted, plant, connection), connection


def test_it_boots_before_the_session_and_its_battery_is_ours(tmp_path: Path) -> None:
    booted, connection = unit(tmp_path)
    with booted:
        assert connection.frames() == []  # what it said in its boot is its own
        booted.start_clock(5000, 0)
        interval = common.MAVLink_command_long_message(
            COPTER, 1, common.MAV_CMD_SET_MESSAGE_INTERVAL, 0, common.MAVLINK_MSG_ID_SYS_STATUS, 2e5, 0, 0, 0, 0, 0
        )
        (frame,) = split(bytes(interval.pack(common.MAVLink(None, 255, 190))))
        booted.receive(frame, connection)
        booted.advance(8000)
        said = common.MAVLink(None).parse_buffer(b"".join(connection.frames())) or []
        kinds = {m.get_type() for m in said}
        assert {"HEARTBEAT", "SYS_STATUS", "BATTERY_STATUS", "COMMAND_ACK", "NAMED_VALUE_INT"} <= kinds
        assert not kinds & {"SYSTEM_TIME", "PARAM_VALUE"}
        assert {m.custom_mode for m in said if m.get_type() == "HEARTBEAT"} == {4}
        *_, status = (m for m in said if m.get_type() == "SYS_STATUS")
        *_, battery = (m for m in said if m.get_type() == "BATTERY_STATUS")
        assert status.voltage_battery == pytest.approx(sum(battery.voltages[:4]), abs=60)  # set once a second
        assert status.battery_remaining == battery.battery_remaining == 50


def test_its_receiver_has_no_fix_while_gnss_fails(tmp_path: Path) -> None:
    booted, connection = unit(tmp_path)
    with booted:
        booted.start_clock(0, 0)
        assert fixes_around_an_outage(booted, connection, COPTER) == [1, 6]


@pytest.mark.parametrize("like", ["4.6", "4.7"])
def test_it_flies_on_an_estimate_whatever_its_version_defaults_to(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, like: str
) -> None:
    """One that flies on truth is ready before it can know its place."""
    monkeypatch.setattr(autopilot_unit, "BOOTS_WITHIN_S", 3.0)
    with pytest.raises(AutopilotError, match="was not ready in 3 s of its time"):
        unit(tmp_path, like=like, READY_S=1e6)


@pytest.mark.parametrize(
    ("program", "parameters", "said"),
    [
        ("none", {}, "cannot be started: No such file or directory"),
        ("/bin/true", {}, "ended with status 0, and said nothing"),
        ("", {"CRASH": 1.0}, "ended with status 3; its last lines: PANIC: a parameter that it cannot bear"),
        ("", {"KIND": 1.0}, "is no ArduCopter with four rotors: its HEARTBEAT has type 1 and autopilot 3, not 2 and 3"),
        ("", {"READY_S": 1e6}, "was not ready in 3 s of its time; its last lines: Starting sketch 'ArduCopter'"),
        ("", {"KILLED_AT_S": 1.0}, "was killed by signal 9"),
        ("", {"WP_SPD": 5.0, "WPNAV_SPEED": 500.0}, "has not taken its params: WP_SPD: it does not know it"),
    ],
)
def test_one_that_cannot_be_had_is_one_sentence(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, program: str, parameters: dict[str, float], said: str
) -> None:
    monkeypatch.setattr(autopilot_unit, "BOOTS_WITHIN_S", 3.0)
    with pytest.raises(AutopilotError) as refused:
        unit(tmp_path, Path(program) if program else None, **parameters)
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)


def test_one_that_opens_no_port_is_one_sentence_and_is_ended(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(ardupilot_link, "READY_WITHIN_S", 0.2)
    program = tmp_path / "mute"
    program.write_text("#!/bin/sh\nexec sleep 99\n")
    program.chmod(0o755)
    with pytest.raises(AutopilotError, match=r"opened no port \d+ in 0 s, and said nothing$"):
        unit(tmp_path, program)
    assert not [child for child in psutil.Process().children() if "sleep" in child.name()]


def test_ports_that_others_have_are_passed_over(monkeypatch: pytest.MonkeyPatch) -> None:
    first, instance = simulation_port()
    with first, socket.socket(socket.AF_INET, socket.SOCK_STREAM) as taken:
        second, after = simulation_port()
        second.close()
        assert after > instance
        taken.bind((HOST, SERIAL_PORT + 10 * after))
        taken.listen()
        third, later = simulation_port()
        third.close()
        assert later > after
        monkeypatch.setattr(ardupilot_process, "MOST_INSTANCES", after + 1)
        with pytest.raises(AutopilotError, match="no ports are free for an autopilot: UDP 9002 and TCP 5760"):
            simulation_port()
