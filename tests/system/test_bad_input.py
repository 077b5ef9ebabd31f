"""A whole session among senders of nonsense: it flies as if they were not there, and says who claims another's id."""

from __future__ import annotations

import json
import math
import random
import socket
import struct
from pathlib import Path
from typing import Any

import psutil
import pytest
from pymavlink.dialects.v20 import common as mav
from sessions import Outcome, Running, fly, small

GOAL = {"duration_s": 12.0, "refuelled_at_least": 0}
VICTIM = 1


def framed(message: Any, seq: int = 0, sender: tuple[int, int] = (VICTIM, 1)) -> bytes:
    writer = mav.MAVLink(None, *sender)
    writer.seq = seq
    return bytes(message.pack(writer))


def nonsense(chance: random.Random, t_ms: int) -> list[bytes]:
    """To the ground station: broken frames of a vehicle, whole ones from a wrong address or with no numbers, noise."""
    heartbeat = framed(mav.MAVLink_heartbeat_message(2, 12, 0x81, 6 << 16, 4, 3))
    time = framed(mav.MAVLink_system_time_message(0, t_ms), 1)
    place = mav.MAVLink_local_position_ned_message(t_ms, 50.0, 50.0, -50.0, math.nan, math.inf, 0.0)
    battery = mav.MAVLink_battery_status_message(0, 0, 0, 0, [0] * 10, 0, 0, 2**31 - 1, 0)
    wrong = bytearray(heartbeat)
    wrong[-1] ^= 0xFF
    unknown = struct.pack("<BBBBBBBHB", 0xFD, 4, 0, 0, 9, VICTIM, 1, 0xFFFF, 0x0F) + b"\1\2\3\4" + b"xy"
    return [
        heartbeat + time,
        heartbeat[: chance.randrange(1, len(heartbeat))],
        bytes(wrong),
        unknown,
        framed(place, 200) + framed(battery, 201) + time,
        time + heartbeat + time + heartbeat,
        framed(mav.MAVLink_command_ack_message(400, 4, 0, 0, 255, 190), 3) + time,
        framed(mav.MAVLink_heartbeat_message(2, 3, 0, 0, 4, 3), 0, (77, 1)),
        chance.randbytes(60_000),
        b"\xfd" * 300,
        b"",
    ]


def orders(t_ms: int) -> list[bytes]:
    """To a vehicle: what its supervisor could say, from somewhere else; and set points of no number."""
    supervisor = (255, 190)
    disarm = mav.MAVLink_command_long_message(VICTIM, 1, 400, 0, 0.0, 21196.0, *[math.nan] * 5)
    point = mav.MAVLink_set_position_target_local_ned_message(0, VICTIM, 1, 1, 3576, math.nan, 1e30, 0, *[0] * 8)
    grant = framed(mav.MAVLink_system_time_message(0, t_ms + 5000), 2, supervisor)
    return [framed(disarm, 0, supervisor) + framed(point, 1, supervisor) + grant, grant, grant[:9], b"\xfd" * 1400]


def port_of(process: psutil.Process) -> int:
    (port,) = {connection.laddr.port for connection in process.net_connections(kind="udp4")}
    return int(port)


@pytest.fixture(scope="module")
def disturbed(tmp_path_factory: pytest.TempPathFactory) -> tuple[Outcome, list[str], int]:
    """A session that hears nonsense all the time, what it said, and the port that the nonsense came from."""
    chance = random.Random(4)
    content = small(goal=GOAL, clock={"mode": "real", "speed": 5.0})
    running = Running(content, tmp_path_factory.mktemp("disturbed"), "--json")
    told: list[str] = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.bind(("127.0.0.1", 0))
        try:
            seen = running.wait_for(lambda seen: seen["t_s"] > 0.5)
            station, vehicle = port_of(running.named("gcs.session.process")), port_of(running.vehicle(VICTIM))
            for line in running.lines():
                t_ms = round(1000.0 * seen["t_s"])
                for datagram in nonsense(chance, t_ms):
                    stranger.sendto(datagram, ("127.0.0.1", station))
                for datagram in orders(t_ms):
                    stranger.sendto(datagram, ("127.0.0.1", vehicle))
                seen = json.loads(line)
                told += [event["text"] for event in seen.get("events", ())]
                if seen["type"] == "end":
                    break
            return running.finish(), told, int(stranger.getsockname()[1])
        finally:
            running.stop()


def test_nothing_that_strangers_send_changes_the_flight(disturbed: Any, tmp_path: Path) -> None:
    outcome, _, _ = disturbed
    quiet = fly(small(goal=GOAL), tmp_path)
    assert (outcome.status, quiet.status) == (0, 0)
    assert outcome.summary["link"]["malformed"] == 0  # what comes from elsewhere is not looked into
    assert outcome.summary["digest"] == quiet.summary["digest"]


def test_who_claims_the_id_of_another_is_named_once_and_refused(disturbed: Any) -> None:
    outcome, told, port = disturbed
    claims = [text for text in told if "says that it is" in text]
    assert claims == [f"Another vehicle says that it is {VICTIM}, from 127.0.0.1:{port}: ignored"]
    assert outcome.summary["link"]["lost"] == 0
    assert {vehicle["sysid"] for vehicle in outcome.summary["vehicles"]} == {1, 101, 201}
