"""Another ground station, pymavlink's, that a session forwards to: it hears everyone, and lands one where it may."""

from __future__ import annotations

import json
import socket
import subprocess
import time
from collections import Counter
from pathlib import Path
from typing import Any

import yaml
from commands import gcs
from onlookers import pymavlink_station
from pymavlink.dialects.v20 import common as mav
from sessions import GCS, Outcome, fly, small


def flown(folder: Path, *options: str) -> Outcome:
    return fly(small(goal={"duration_s": 12.0, "refuelled_at_least": 0}), folder, "--quiet", *options)


def test_looking_on_changes_nothing_and_an_order_without_leave_reaches_nobody(tmp_path: Path) -> None:
    alone = flown(tmp_path / "alone")
    with pymavlink_station(lands=1) as one:
        watched = flown(tmp_path / "watched", "--forward", one.address, "--forward", "tcp:127.0.0.1:9")
    assert one.orders > 0
    assert one.acked == []
    assert watched.summary["digest"] == alone.summary["digest"]
    recorded: Counter[tuple[int, str]] = Counter()
    for _, message in watched.messages():
        if message.get_srcSystem() != 255:
            recorded[message.get_srcSystem(), message.get_type()] += 1
    assert {sysid for sysid, _ in recorded} == {1, 101, 201}
    relayed = {"FOLLOW_TARGET", "NAMED_VALUE_INT"}  # recorded again on their way to another vehicle
    for key, count in recorded.items():
        assert one.heard[key] == count or (key[1] in relayed and one.heard[key] > 0), key  # each, and none twice
    assert not [line for line in watched.decisions if line["kind"] == "operator"]


def test_where_it_may_it_lands_one_that_nobody_flies_from_then_on(tmp_path: Path) -> None:
    content = small(goal={"duration_s": 20.0, "refuelled_at_least": 0})
    with pymavlink_station(lands=1) as one:
        content["forward"] = {"to": [one.address], "control": True}
        outcome = fly(content, tmp_path, "--quiet", "--speed", "3")
    assert (1, mav.MAV_RESULT_ACCEPTED, 255) in one.acked
    orders = [line for line in outcome.decisions if line["kind"] == "operator"]
    assert [(line["command"], line["sysid"], line["taken"]) for line in orders[:2]] == [
        ("release", 1, True), ("forward", 1, True),
    ]  # fmt: skip
    assert orders[1]["text"] == f"NAV_LAND to pursuer 1 by 255/190 at {one.address}"
    released_s = orders[0]["t_s"]
    led = [
        (t_s, message.target_system)
        for t_s, message in outcome.messages("SET_POSITION_TARGET_LOCAL_NED")
        if t_s > released_s + 0.2
    ]
    assert {target for _, target in led} == {101, 201}
    assert outcome.vehicle(1)["final_mode"] == "land"
    armed: list[Any] = [
        message.base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED
        for _, message in outcome.messages("HEARTBEAT")
        if message.get_srcSystem() == 1
    ]
    assert armed[-1] == 0


def test_launched_vehicles_are_behind_one_address_of_any_kind(tmp_path: Path) -> None:
    """TCP on IPv6: both are heard there, and each obeys what names it."""
    path = tmp_path / "fleet.yaml"
    path.write_text(yaml.safe_dump(small()), encoding="utf-8")
    argv = [*GCS, "launch", str(path), "--connect", "tcpin:[::1]:0", "--json", "--until-eof"]
    with subprocess.Popen(argv, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        vehicles = json.loads(process.stdout.readline())["vehicles"]
        (where,) = {vehicle["address"] for vehicle in vehicles}
        assert where.startswith("tcpin:[::1]:")
        station = mav.MAVLink(None, srcSystem=245, srcComponent=190)
        asked: dict[int, float] = {}
        answered: set[int] = set()
        with socket.create_connection(("::1", int(where.rpartition(":")[2])), timeout=20.0) as stream:
            while answered != {1, 101, 201}:
                for message in station.parse_buffer(stream.recv(4096)) or []:
                    sysid = message.get_srcSystem()
                    if message.get_type() == "COMMAND_ACK":
                        answered.add(sysid)
                    elif message.get_type() == "HEARTBEAT" and sysid not in asked:
                        asked[sysid] = time.monotonic()
                        ask = mav.MAVLink_command_long_message(sysid, 1, 512, 0, 148, 0, 0, 0, 0, 0, 0)
                        stream.sendall(bytes(ask.pack(station)))
        process.communicate(timeout=30)


def test_what_cannot_be_forwarded_to_is_a_sentence(tmp_path: Path) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", 0))
        in_use = flown(tmp_path, "--forward", f"udpin:127.0.0.1:{taken.getsockname()[1]}")
    assert in_use.status == 2
    assert "cannot be listened at: Address already in use; another program" in in_use.stderr
    for argv, words in (
        (["--forward", "14550"], "must be udpin|udpout|tcp|tcpin:HOST:PORT or serial:DEVICE:BAUD"),
        (["--forward-control"], "--forward-control needs --forward"),
    ):
        refused = gcs("run", "demo", "--out", str(tmp_path / "none"), *argv)
        assert refused.returncode == 2
        assert words in " ".join(refused.stderr.split())
