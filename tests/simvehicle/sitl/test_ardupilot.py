"""An ArduPilot with its simulation in one process, here the stand-in: how it boots, what it says, how it fails."""

from __future__ import annotations

import socket
from pathlib import Path

import psutil
import pytest
from autopilot_units import fixes_around_an_outage, launched, said_in_flight, stand_in
from pymavlink.dialects.v20 import common

from simvehicle.mavlink.connection import Connection
from simvehicle.sitl import ardupilot_link, ardupilot_process, autopilot_unit
from simvehicle.sitl.ardupilot import ArduPilotUnit
from simvehicle.sitl.ardupilot_process import SERIAL_PORT, simulation_port
from simvehicle.sitl.autopilot_process import HOST, AutopilotError


def unit(
    folder: Path, program: Path | None = None, *, like: str = "4.7", **parameters: float
) -> tuple[ArduPilotUnit, Connection]:
    """The stand-in for a version, or another program, booted. Raises AutopilotError."""
    program = program or stand_in(folder / "arducopter", "json_arducopter.py", like)
    return launched(ArduPilotUnit, program, folder, **parameters)


def test_it_boots_before_the_session_and_its_battery_is_ours(tmp_path: Path) -> None:
    booted, connection = unit(tmp_path)
    with booted:
        streamed = common.MAVLINK_MSG_ID_SYS_STATUS
        said = said_in_flight(booted, connection, streamed, within_mv=60)  # it is given its voltage once a second
    assert {m.custom_mode for m in said["HEARTBEAT"]} == {4}


def test_its_receiver_has_no_fix_while_gnss_fails(tmp_path: Path) -> None:
    booted, connection = unit(tmp_path)
    with booted:
        booted.start_clock(0, 0)
        assert fixes_around_an_outage(booted, connection) == [1, 6]


def test_it_flies_on_an_estimate_whatever_its_version_defaults_to(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """One that flies on truth is ready before it can know its place."""
    monkeypatch.setattr(autopilot_unit, "BOOTS_WITHIN_S", 3.0)
    with pytest.raises(AutopilotError, match="was not ready in 3 s of its time"):
        unit(tmp_path, like="4.6", READY_S=1e6)


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
