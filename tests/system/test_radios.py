"""Vehicles on every kind of link in one session: TCP both ways, a cable at 57,600 baud, three behind a router on IPv6.

In flight the cable and one TCP connection are pulled for ten seconds, and plugged in again.
"""

from __future__ import annotations

import contextlib
import math
import socket
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from lanes import lanes, start
from ports import free_port
from pymavlink import mavutil
from radios import BUFFER_BYTES, Cable, Router, Tcp
from sessions import Outcome, Running, fly
from strangers import ARDUCOPTER, SIMVEHICLE, strangers

BAUD = 57600
OFFBOARD = 6 << 16
AWAY_S = 10.0
FLOWN_S = 27.0
GOAL = {"duration_s": FLOWN_S, "lost_at_most": 6}
CABLE, TCP, TCPIN, ROUTED = 1, 2, 3, (4, 5, 6)
POINT_S = 2.0
NEAR_M = 0.6


@dataclass
class Flown:
    outcome: Outcome
    cable: Cable
    onlooker: list[bytes]
    snapshots: list[dict[str, Any]]
    pulled_s: float
    plugged_s: float

    @property
    def events(self) -> list[dict[str, Any]]:
        return [event for snapshot in self.snapshots for event in snapshot["events"]]

    def row(self, snapshot: dict[str, Any], sysid: int) -> dict[str, Any]:
        found: dict[str, Any] = next(v for v in snapshot["vehicles"] if v["sysid"] == sysid)
        return found


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Flown]:
    folder = tmp_path_factory.mktemp("radios")
    six, listens = free_port(), free_port()
    device = folder / "ttyRadio"
    snapshots: list[dict[str, Any]] = []
    with contextlib.ExitStack() as stack:
        cable, tcp = Cable(device, BAUD), Tcp()
        tcpin, router = Tcp(("127.0.0.1", listens)), Router(("::1", six))
        ports = {CABLE: cable.port, TCP: tcp.port, TCPIN: tcpin.port} | dict.fromkeys(ROUTED, router.port)
        for relay in (cable, tcp, tcpin, router):
            stack.enter_context(relay)
        connects = {
            CABLE: f"serial:{device}:{BAUD}",
            TCP: f"tcp:127.0.0.1:{tcp.far_port}",
            TCPIN: f"tcpin:127.0.0.1:{listens}",
        } | dict.fromkeys(ROUTED, f"udpin:[::1]:{six}")
        commands = [
            [*ARDUCOPTER, "--sysid", str(sysid), "--connect", f"udpout:127.0.0.1:{port}", "--origin", start(sysid),
             "--refuse-arming-s", "1", "--battery-told", "energy"]
            for sysid, port in ports.items()
            if sysid != TCP
        ]  # fmt: skip
        px4 = [*SIMVEHICLE, "--sysid", str(TCP), "--connect", f"udpout:127.0.0.1:{tcp.port}", "--home", start(TCP)]
        commands.append(px4)  # which has a failsafe
        stack.enter_context(strangers(folder, *commands))
        onlooker = stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
        onlooker.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
        onlooker.bind(("127.0.0.1", 0))
        onlooker.setblocking(False)
        forward = f"udpout:127.0.0.1:{onlooker.getsockname()[1]}"
        running = Running(lanes(connects, GOAL), folder, "--json", "--forward", forward)
        stack.callback(running.stop)

        there: set[int] = set()

        def seen(snapshot: dict[str, Any]) -> None:
            snapshots.append(snapshot)
            there.update(v["sysid"] for v in snapshot["vehicles"] if v["p_ned"] and v["p_ned"][0] > 3.0 - NEAR_M)

        def all_fly(snapshot: dict[str, Any]) -> bool:
            seen(snapshot)
            return all(v["stage"] == "fly" for v in snapshot["vehicles"])

        running.wait_for(all_fly)

        def both_have_been_at_first_point(snapshot: dict[str, Any]) -> bool:
            """Also before the others had taken off."""
            seen(snapshot)
            return {CABLE, TCP} <= there

        pulled_s = running.wait_for(both_have_been_at_first_point)["t_s"]
        cable.pull()
        tcp.pull()

        def away(snapshot: dict[str, Any]) -> bool:
            seen(snapshot)
            return bool(snapshot["t_s"] >= pulled_s + AWAY_S)

        plugged_s = running.wait_for(away)["t_s"]
        cable.plug()
        tcp.plug()
        with contextlib.suppress(AssertionError):
            running.wait_for(lambda snapshot: bool(seen(snapshot)))  # to the end
        outcome, forwarded = running.finish(), []
        with contextlib.suppress(BlockingIOError):
            while True:
                forwarded.append(onlooker.recv(1000))
        yield Flown(outcome, cable, forwarded, snapshots, pulled_s, plugged_s)


def test_a_mission_on_every_kind_of_link(flown: Flown) -> None:
    """By what the vehicles reported: everyone went to the first point of its line."""
    reached = dict.fromkeys((CABLE, TCP, TCPIN, *ROUTED), math.inf)
    for _, message in flown.outcome.messages("LOCAL_POSITION_NED"):
        sysid = message.get_srcSystem()
        reached[sysid] = min(reached[sysid], math.dist((message.x, message.z), (3.0, -3.0)))
    assert all(away_m < NEAR_M for away_m in reached.values()), reached
    assert flown.outcome.status in (0, 1)
    assert flown.outcome.summary["completed"] is True


def test_the_recording_is_on_true_time_and_energy_counts_from_its_start(flown: Flown) -> None:
    """Beside an autopilot's own log: the last frame was recorded when the session's file was written last."""
    log = flown.outcome.folder / "session.tlog"
    reader = mavutil.mavlogfile(str(log), robust_parsing=False)
    try:
        first = reader.recv_match()._timestamp
    finally:
        reader.close()
    assert log.stat().st_mtime - first == pytest.approx(flown.outcome.summary["sim_time_s"], abs=5.0)
    for vehicle in flown.outcome.summary["vehicles"]:
        assert 0.0 < vehicle["energy"]["drawn_j"] < 30_000.0


def test_who_looks_on_hears_them_all(flown: Flown) -> None:
    """As many as the kernel kept, of those that the session received."""
    assert {raw[5] for raw in flown.onlooker} == {CABLE, TCP, TCPIN, *ROUTED}
    assert len(flown.onlooker) > 1000


def test_nothing_more_goes_over_the_cable_than_its_rate_carries(flown: Flown) -> None:
    assert flown.cable.passed <= BAUD / 10 * (FLOWN_S + 30) + BUFFER_BYTES
    assert flown.cable.lost <= 0.02 * flown.cable.passed


def test_a_pulled_cable_is_told_and_the_vehicle_flies_on_by_itself(flown: Flown) -> None:
    texts = [event["text"] for event in flown.events]
    assert any(
        f"ttyRadio:{BAUD} is lost: the device is gone" in text or "is lost: there is no device" in text
        for text in texts
    )
    assert any(text.startswith("tcp:127.0.0.1:") and "is lost: the other end has closed" in text for text in texts)
    last = [s for s in flown.snapshots if flown.pulled_s + 8.0 < s["t_s"] < flown.plugged_s]
    for sysid in (CABLE, TCP):
        assert all(flown.row(s, sysid)["heard_s"] > 5.0 for s in last)
    for sysid in (TCPIN, *ROUTED):
        assert all(flown.row(s, sysid)["heard_s"] < 3.0 for s in last)


def test_it_is_flown_again_without_a_restart(flown: Flown) -> None:
    back = [s for s in flown.snapshots if s["t_s"] >= flown.plugged_s]
    rows = [[flown.row(s, sysid) for sysid in (CABLE, TCP, TCPIN, *ROUTED)] for s in back]
    assert any(all(row["stage"] == "fly" and row["heard_s"] < 3.0 for row in each) for each in rows), rows[-1]
    held = [m for t_s, m in flown.outcome.messages("HEARTBEAT") if m.get_srcSystem() == TCP and t_s >= flown.plugged_s]
    assert held[0].custom_mode != OFFBOARD  # its failsafe took it
    assert any(m.custom_mode == OFFBOARD for m in held[1:])
    texts = [event["text"] for event in flown.events]
    assert sum(text.endswith("is there again") for text in texts) == 2
    moved = {CABLE: 0.0, TCP: 0.0}
    led: dict[int, list[float]] = {CABLE: [], TCP: []}
    for t_s, message in flown.outcome.messages("LOCAL_POSITION_NED"):
        if message.get_srcSystem() in led and t_s > flown.plugged_s + POINT_S:
            led[message.get_srcSystem()].append(message.x)
    moved = {sysid: max(xs) - min(xs) for sysid, xs in led.items()}
    assert all(way_m > 1.0 for way_m in moved.values()), moved


def test_what_is_waited_for_is_said_in_one_sentence(tmp_path: Path) -> None:
    said = lanes({1: f"tcp:127.0.0.1:{free_port()}"}, GOAL)
    said["vehicles"]["pursuers"][0]["external"]["found_within_s"] = 1.0
    outcome = fly(said, tmp_path, "--plain")
    assert outcome.status == 1
    assert "within 1 s: it cannot be reached (Connection refused): does the simulator or the router" in outcome.stderr
    assert len(outcome.stderr.strip().splitlines()) == 1


def test_check_says_what_is_wrong_with_a_link(tmp_path: Path) -> None:
    began_s = time.monotonic()
    missing = gcs("check", "--connect", f"serial:{tmp_path}/ttyUSB7:57600", "--wait", "0.3")
    assert missing.returncode == 2
    assert f"there is no device {tmp_path}/ttyUSB7" in missing.stderr
    (tmp_path / "file").write_text("no device")
    refused = gcs("check", "--connect", f"serial:{tmp_path}/file:57600")
    assert refused.returncode == 2
    assert "it is no serial device" in refused.stderr
    assert time.monotonic() - began_s < 60.0
