"""Signed links flown: who has the key flies the vehicle, who has not moves nothing, and both sides say so."""

from __future__ import annotations

import contextlib
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from ports import free_port
from pymavlink.dialects.v20 import common as mav
from sessions import fly, small
from station import ACCEPTED, Station
from strangers import SIMVEHICLE, strangers

from gcs.link.keys import new_key
from skytender.key_files import read_key

ARM = mav.MAV_CMD_COMPONENT_ARM_DISARM


@pytest.fixture
def keys(tmp_path: Path) -> tuple[Path, Path]:
    """Two key files, of which only the first is the vehicle's."""
    for name in ("own.key", "other.key"):
        new_key(tmp_path / name)
    return tmp_path / "own.key", tmp_path / "other.key"


def scenario(connect: str, key: Path | None, **more: Any) -> dict[str, Any]:
    block = {"sysid": 7, "connect": connect, "capacity_j": 200_000, **more}
    if key is not None:
        block["signing"] = {"key_file": str(key)}
    return small(
        vehicles={"pursuers": [{"external": block}], "tankers": []}, clock={"mode": "real"},
        goal={"duration_s": 8.0, "refuelled_at_least": 0},
    )  # fmt: skip


def vehicle(*options: str) -> list[str]:
    return [*SIMVEHICLE, "--sysid", "7", *options]


def test_a_session_flies_a_vehicle_whose_key_it_has(keys: tuple[Path, Path], tmp_path: Path) -> None:
    own, _ = keys
    port = free_port()
    one = vehicle("--connect", f"udpout:127.0.0.1:{port}", "--key-file", str(own), "--position", "2,0,0")
    with strangers(tmp_path / "said", one):
        flown = fly(scenario(f"udpin:127.0.0.1:{port}", own), tmp_path)
    assert (flown.status, flown.summary["outcome"]) == (0, "met"), flown.stdout
    assert flown.vehicle(7)["refused_messages"] == 0
    assert flown.summary["link"]["malformed"] == 0
    assert flown.vehicle(7)["path_length_m"] > 1.0
    positions = [message for _, message in flown.messages("LOCAL_POSITION_NED") if message.get_srcSystem() == 7]
    assert len(positions) > 50
    assert all(message.get_msgbuf()[2] & 1 for message in positions)


@pytest.mark.parametrize("has", ["another key", "no key"])
def test_who_has_not_the_key_flies_nothing_and_is_told_why_on_both_sides(
    keys: tuple[Path, Path], tmp_path: Path, has: str
) -> None:
    own, other = keys
    port = free_port()
    key = other if has == "another key" else None
    why, said = ("signed with another key",) * 2
    if key is None:
        why, said = "signed, and there is no key to check it with", "not signed"
    one = vehicle("--connect", f"udpin:127.0.0.1:{port}", "--key-file", str(own))
    with subprocess.Popen(one, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert f"udpin:127.0.0.1:{port}" in process.stdout.readline()
        refused = fly(scenario(f"udpout:127.0.0.1:{port}", key, found_within_s=2.5), tmp_path)
        line = process.stdout.readline()
        process.kill()
    assert refused.status == 1
    assert not (refused.folder / "summary.json").exists()
    assert said in line
    assert "vehicle 7: 1 message refused, the last of system 255: " in line
    # a vehicle that waits answers only whom it believes, so that nothing of it comes
    assert "no HEARTBEAT of pursuer 7" in refused.stderr
    spoken = free_port()
    with strangers(tmp_path / "more", vehicle("--connect", f"udpout:127.0.0.1:{spoken}", "--key-file", str(own))):
        (tmp_path / "again").mkdir()
        refused = fly(scenario(f"udpin:127.0.0.1:{spoken}", key, found_within_s=10.0), tmp_path / "again")
        given = ("--key-file", str(key)) if key else ()
        asked = gcs("params", "get", "COM_DL_LOSS_T", "--connect", f"udpin:127.0.0.1:{spoken}", *given, "--wait", "3")
    assert f"messages of pursuer 7 came and were refused: {why}" in refused.stderr
    assert (asked.returncode, f"messages of vehicle 7 came and were refused: {why}" in asked.stderr) == (2, True)


@contextmanager
def flying(folder: Path, key: Path) -> Iterator[tuple[Station, int]]:
    """A signed vehicle that listens, and a station of pymavlink's that signs with its key."""
    port = free_port()
    one = vehicle("--connect", f"udpin:127.0.0.1:{port}", "--key-file", str(key))
    with strangers(folder, one), Station(7) as station:
        station.speaks_to("127.0.0.1", port)
        sign(station, key)
        yield station, port


def sign(station: Station, key: Path, stamp: int | None = None) -> None:
    signing = station._mav.signing
    signing.secret_key, signing.sign_outgoing, signing.link_id = read_key(key), True, 4
    signing.timestamp = int((time.time() - 1_420_070_400) * 1e5) if stamp is None else stamp


def test_no_forged_stale_replayed_or_unsigned_command_moves_a_vehicle(keys: tuple[Path, Path], tmp_path: Path) -> None:
    own, other = keys
    with flying(tmp_path / "said", own) as (station, port):
        station.hear("HEARTBEAT")
        arm = mav.MAVLink_command_long_message(7, 1, ARM, 0, 1, 0, 0, 0, 0, 0, 0)
        forgers = [Station(7) for _ in range(3)]
        with contextlib.ExitStack() as stack:
            unsigned, wrong, stale = map(stack.enter_context, forgers)
            sign(wrong, other)
            sign(stale, own, stamp=int((time.time() - 1_420_070_400 - 61.0) * 1e5))
            for forger in forgers:
                forger.speaks_to("127.0.0.1", port)
                for _ in range(5):
                    forger.send(arm)
            assert station.command(mav.MAV_CMD_REQUEST_MESSAGE, float(mav.MAVLINK_MSG_ID_HEARTBEAT)) == ACCEPTED
            after = [m for m in station.heard if m.get_type() == "HEARTBEAT"][-1]
            assert not after.base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED
            assert not [m for m in station.heard if m.get_type() == "COMMAND_ACK" and m.command == ARM]
            # what the owner sent once does nothing when it is sent again
            raw = arm.pack(station._mav)
            station.socket.sendto(raw, ("127.0.0.1", port))
            station.hear("COMMAND_ACK", lambda ack: ack.command == ARM)
            assert station.command(ARM, 0.0) == ACCEPTED
            for _ in range(5):
                unsigned.socket.sendto(raw, ("127.0.0.1", port))
            assert station.command(mav.MAV_CMD_REQUEST_MESSAGE, float(mav.MAVLINK_MSG_ID_HEARTBEAT)) == ACCEPTED
            last = [m for m in station.heard if m.get_type() == "HEARTBEAT"][-1]
            assert not last.base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED
            assert all(message.get_signed() for message in station.heard)
