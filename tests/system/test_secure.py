"""Whole sessions under attack by another user of the machine, and with a supervisor that was suspended."""

from __future__ import annotations

import contextlib
import math
import os
import random
import signal
import socket
import stat
import struct
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import psutil
import pytest
from ports import free_port
from pymavlink.dialects.v20 import common as mav
from sessions import Outcome, Running, fly, small
from strangers import ARDUCOPTER, SIMVEHICLE, strangers

SHORT = small(goal={"duration_s": 12.0, "refuelled_at_least": 0})
IDS = (1, 101, 201)
AWAY_S = 3.3


def hello(sysid: int) -> bytes:
    """What a vehicle says first, as anybody can read it in the protocol."""
    beat = framed(mav.MAVLink_heartbeat_message(2, 12, 0, 0, 3, 3), 0, (sysid, 1))
    return beat + framed(mav.MAVLink_system_time_message(0, 0), 1, (sysid, 1))


def nonsense(chance: random.Random) -> list[bytes]:
    """Broken frames of a vehicle, whole ones with no numbers, noise; and what a supervisor could say, and set points of
    no number."""
    t_ms = chance.randrange(12_000)
    heartbeat = framed(mav.MAVLink_heartbeat_message(2, 12, 0x81, 6 << 16, 4, 3))
    time_told = framed(mav.MAVLink_system_time_message(0, t_ms), 1)
    place = mav.MAVLink_local_position_ned_message(t_ms, 50.0, 50.0, -50.0, math.nan, math.inf, 0.0)
    battery = mav.MAVLink_battery_status_message(0, 0, 0, 0, [0] * 10, 0, 0, 2**31 - 1, 0)
    unknown = struct.pack("<BBBBBBBHB", 0xFD, 4, 0, 0, 9, 1, 1, 0xFFFF, 0x0F) + b"\1\2\3\4" + b"xy"
    supervisor = (255, 190)
    disarm = mav.MAVLink_command_long_message(1, 1, 400, 0, 0.0, 21196.0, *[math.nan] * 5)
    point = mav.MAVLink_set_position_target_local_ned_message(0, 1, 1, 1, 3576, math.nan, 1e30, 0, *[0] * 8)
    grant = framed(mav.MAVLink_system_time_message(0, t_ms + 5000), 2, supervisor)
    return [
        heartbeat + time_told,
        heartbeat[: chance.randrange(1, len(heartbeat))],
        heartbeat[:-1] + bytes([heartbeat[-1] ^ 0xFF]),
        unknown,
        framed(place, 200) + framed(battery, 201) + time_told,
        time_told + heartbeat + time_told + heartbeat,
        framed(mav.MAVLink_command_ack_message(400, 4, 0, 0, 255, 190), 3) + time_told,
        framed(mav.MAVLink_heartbeat_message(2, 3, 0, 0, 4, 3), 0, (77, 1)),
        framed(disarm, 0, supervisor) + framed(point, 1, supervisor) + grant,
        grant[:9],
        b"\xfd" * 60_000,
        b"",
    ]


def framed(message: Any, seq: int = 0, sender: tuple[int, int] = (1, 1)) -> bytes:
    writer = mav.MAVLink(None, *sender)
    writer.seq = seq
    return bytes(message.pack(writer))


def bound_ports() -> set[int]:
    """UDP ports of the processes that this one has started, and of theirs: another test's are none of the thief's."""
    ports: set[int] = set()
    for process in psutil.Process().children(recursive=True):
        with contextlib.suppress(psutil.Error):
            ports |= {connection.laddr.port for connection in process.net_connections("udp")}
    return ports


@contextmanager
def thief() -> Iterator[None]:
    """Says to every new port of a session, its vehicles' too, that it is each of them, and much that is nothing."""
    known, done = bound_ports(), threading.Event()
    hellos, chance = [hello(sysid) for sysid in IDS], random.Random(4)

    def steal() -> None:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
            while not done.is_set():
                for port in bound_ports() - known:
                    with contextlib.suppress(OSError):
                        for datagram in (*hellos, *nonsense(chance)):
                            one.sendto(datagram, ("127.0.0.1", port))
                time.sleep(0.005)

    thread = threading.Thread(target=steal)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    return fly(SHORT, tmp_path_factory.mktemp("alone"))


def test_a_stranger_takes_no_vehicle_and_changes_nothing(alone: Outcome, tmp_path: Path) -> None:
    with thief():
        attacked = fly(SHORT, tmp_path)
    assert attacked.summary["digest"] == alone.summary["digest"]
    assert attacked.summary["outcome"] == alone.summary["outcome"] == "met"
    link = attacked.summary["link"]
    assert (link["malformed"], link["lost"]) == (0, 0)  # what comes from elsewhere is not looked into
    said = (attacked.folder / "session.log").read_text(encoding="utf-8")
    assert said.count("Another vehicle says that it is 1, from 127.0.0.1:") == 1
    assert {vehicle["sysid"] for vehicle in attacked.summary["vehicles"]} == set(IDS)


def test_nobody_else_may_look_into_a_session(alone: Outcome) -> None:
    assert stat.S_IMODE(alone.folder.stat().st_mode) == 0o700


def test_a_supervisor_that_was_suspended_goes_on_with_all_its_vehicles(alone: Outcome, tmp_path: Path) -> None:
    """Paced, so that there is time to stop it; what it exchanges with its vehicles is the same as in lockstep."""
    running = Running(SHORT, tmp_path, "--json", "--speed", "4")
    try:
        running.wait_for(lambda seen: seen["phase"] == "flying")
        supervisor = running.named("gcs.session.process").pid
        os.kill(supervisor, signal.SIGSTOP)
        time.sleep(AWAY_S)  # this is how long it is away
        os.kill(supervisor, signal.SIGCONT)
        outcome = running.finish()
    finally:
        running.stop()
    assert outcome.summary["digest"] == alone.summary["digest"]
    assert " s: the session stood still, and goes on" in outcome.stdout


def external(port: int, **more: Any) -> dict[str, Any]:
    return {"sysid": 7, "connect": f"udpin:127.0.0.1:{port}", "capacity_j": 200_000, **more}


def test_two_who_say_that_they_are_one_vehicle_keep_a_session_from_flying(tmp_path: Path) -> None:
    port = free_port()
    said = small(
        vehicles={"pursuers": [{"external": external(port)}], "tankers": []}, clock={"mode": "real"},
        goal={"duration_s": 3.0, "refuelled_at_least": 0},
    )  # fmt: skip
    one = [*SIMVEHICLE, "--sysid", "7", "--connect", f"udpout:127.0.0.1:{port}"]
    with strangers(tmp_path / "said", one, one):
        refused = fly(said, tmp_path)
    assert refused.status == 1
    assert "two say that they are pursuer 7 at udpin:127.0.0.1:" in refused.stderr
    assert not (refused.folder / "summary.json").exists()


def test_a_vehicle_that_lies_is_named_and_keeps_the_session_from_being_met(tmp_path: Path) -> None:
    """It tells a place as far away as numbers go, and a battery below nothing; what it does is another matter."""
    port = free_port()
    said = small(
        vehicles={"pursuers": [{"external": external(port, arm_within_s=20)}], "tankers": []}, clock={"mode": "real"},
        goal={"duration_s": 6.0, "refuelled_at_least": 0},
    )  # fmt: skip
    one = [*ARDUCOPTER, "--sysid", "7", "--connect", f"udpout:127.0.0.1:{port}", "--lies"]
    with strangers(tmp_path / "said", one):
        flown = fly(said, tmp_path)
    summary = flown.summary
    assert summary["outcome"] == "lost"
    assert "it is not believed" in next(part["reached"] for part in summary["goal"] if part["part"] == "lost")
    (pursuer,) = (vehicle for vehicle in summary["vehicles"] if vehicle["sysid"] == 7)
    assert pursuer["path_length_m"] < 10.0
    assert "Is not believed: its position is more than 1000 km away" in (flown.folder / "session.log").read_text()
