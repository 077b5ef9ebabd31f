"""`gcs monitor --connect`: real vehicles heard without a word to them; spoken to with --control only."""

from __future__ import annotations

import json
import os
import select
import signal
import socket
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
import yaml
from commands import gcs
from patience import PATIENCE_S
from pymavlink import mavutil
from pymavlink.dialects.v20 import common
from sessions import GCS, small
from strangers import ARDUCOPTER, strangers

from gcs.scenario.endpoint import Endpoint
from gcs.session.monitor import MonitorSource

mav = mavutil.mavlink


class Lines:
    """A program's standard output, line by line, each waited for at most a while."""

    def __init__(self, process: subprocess.Popen[bytes]) -> None:
        assert process.stdout is not None
        self._out = process.stdout.fileno()
        self._pending = b""

    def next(self, until_s: float) -> str:
        while b"\n" not in self._pending:
            ready, _, _ = select.select([self._out], [], [], max(until_s - time.monotonic(), 0.0))
            chunk = os.read(self._out, 65536) if ready else b""
            assert chunk, f"nothing more, but {self._pending!r}"
            self._pending += chunk
        line, _, self._pending = self._pending.partition(b"\n")
        return line.decode()

    def snapshot(self, wanted: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
        """The first snapshot that is as wanted."""
        until_s = time.monotonic() + PATIENCE_S
        while True:
            content: dict[str, Any] = json.loads(self.next(until_s))
            if content["type"] == "snapshot" and wanted(content):
                return content


@contextmanager
def monitor(*argv: str) -> Iterator[tuple[Lines, str]]:
    """`gcs monitor --json` at a port of the system's choice; its lines, and the address that it says it listens at."""
    process = subprocess.Popen([*GCS, "monitor", *argv, "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stderr is not None
    try:
        said = process.stderr.readline().decode()
        yield Lines(process), said.partition("udpin:")[2].partition(";")[0]
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=20) == 0
    finally:
        process.kill()
        process.communicate()


@contextmanager
def launched(folder: Path, where: str) -> Iterator[None]:
    """The small scenario's three vehicles, speaking to an address."""
    path = folder / "fleet.yaml"
    path.write_text(yaml.safe_dump(small()))
    argv = [*GCS, "launch", str(path), "--connect", f"udpout:{where}", "--until-eof"]
    process = subprocess.Popen(argv, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        yield
    finally:
        process.communicate(timeout=20)


class Tap:
    """Stands between vehicles and a monitor, passes on what either says, and counts what comes from each."""

    def __init__(self) -> None:
        self.front = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.front.bind(("127.0.0.1", 0))
        self.back = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.back.bind(("127.0.0.1", 0))
        self.forward = self.backward = 0

    @property
    def where(self) -> str:
        return f"127.0.0.1:{self.front.getsockname()[1]}"

    def pass_on(self, to: tuple[str, int], until: Callable[[], bool]) -> None:
        deadline_s = time.monotonic() + PATIENCE_S
        while not until():
            assert time.monotonic() < deadline_s
            ready, _, _ = select.select([self.front, self.back], [], [], 0.5)
            if self.front in ready:
                self.forward += self.back.sendto(self.front.recv(65535), to)
            if self.back in ready:
                self.backward += len(self.back.recv(65535))

    def close(self) -> None:
        self.front.close()
        self.back.close()


def test_launched_vehicles_are_heard_and_not_a_byte_is_said_to_them(tmp_path: Path) -> None:
    """Every datagram of the fleet goes through a socket to which the monitor would have to answer."""
    tap = Tap()
    try:
        with monitor("--connect", "udpin:127.0.0.1:0") as (lines, where):
            host, _, port = where.rpartition(":")
            with launched(tmp_path, tap.where):
                tap.pass_on((host, int(port)), until=lambda: tap.forward > 30_000)
            snapshot = lines.snapshot(lambda s: len(s["vehicles"]) == 3 and all(v["p_ned"] for v in s["vehicles"]))
    finally:
        tap.close()
    assert tap.backward == 0
    found = {vehicle["sysid"]: vehicle for vehicle in snapshot["vehicles"]}
    assert found.keys() == {1, 101, 201}
    assert {vehicle["mode"] for vehicle in found.values()} == {"hold"}
    assert {vehicle["autopilot"] for vehicle in found.values()} == {"px4"}
    assert found[1]["battery"] == pytest.approx(0.4, abs=0.02)
    apart = [a - b for a, b in zip(found[1]["p_ned"], found[201]["p_ned"], strict=True)]
    assert apart == pytest.approx([5.0, 0.0, 0.0], abs=0.03)  # the scenario's starts: 2 m and -3 m north


@pytest.mark.parametrize("control", [False, True])
def test_an_arducopter_that_nobody_asks_is_told_of_and_with_control_it_is_asked(tmp_path: Path, control: bool) -> None:
    """It tells little but its HEARTBEAT unasked, by its script as in truth."""
    options = ["--control"] if control else []
    with (
        monitor("--connect", "udpin:127.0.0.1:0", *options) as (lines, where),
        strangers(tmp_path, [*ARDUCOPTER, "--sysid", "6", "--connect", f"udpout:{where}"]),
    ):
        told = lines.snapshot(lambda s: any("Does not tell its position" in e["text"] for e in s["events"]))
        if control:
            lines.snapshot(lambda s: s["vehicles"][0]["p_ned"] is not None)
        else:
            assert told["vehicles"][0]["p_ned"] is None


def test_with_control_it_is_a_ground_station_whose_order_to_land_is_flown() -> None:
    """A real vehicle in the air, in the same process only the source that a console would have."""
    source = MonitorSource(Endpoint("udpin", "127.0.0.1", 0), control=True)
    argv = [*GCS[:1], "-c", "from simvehicle.cli import main; main()"]
    argv += ["--sysid", "7", "--connect", f"udpout:127.0.0.1:{source.port}", "--airborne", "--position", "0,0,-1.5"]
    process = subprocess.Popen(argv, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    seen: list[dict[str, Any]] = []
    replies: list[dict[str, Any]] = []

    def until(wanted: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
        deadline_s = time.monotonic() + PATIENCE_S
        while True:
            assert time.monotonic() < deadline_s, seen[-1:]
            for message in source.receive():
                if message["type"] == "reply":
                    replies.append(dict(message))
                if message["type"] == "snapshot":
                    seen.append(dict(message))
                    if wanted(seen[-1]):
                        return seen[-1]
            select.select([source], [], [], 0.1)

    try:
        until(lambda s: any(v["armed"] and v["p_ned"] for v in s["vehicles"]))
        source.send({"command": "refuel", "sysid": 7, "id": "1"})
        source.send({"command": "land", "sysid": 9, "id": "2"})
        source.send({"command": "land", "sysid": 7, "id": "3"})
        until(lambda s: any(v["mode"] == "land" and v["v_ned"][2] > 0.2 for v in s["vehicles"]))
    finally:
        process.kill()
        process.wait()
        source.close()
    assert [(reply["id"], reply["ok"]) for reply in replies] == [("1", False), ("2", False), ("3", True)]
    acks = [event for snapshot in seen for event in snapshot["events"] if event["kind"] == "ack"]
    assert [(ack["sysid"], ack["text"]) for ack in acks] == [(7, "NAV_LAND: accepted")]
    assert any(event["kind"] == "operator" for snapshot in seen for event in snapshot["events"])


def test_only_control_sends_a_heartbeat() -> None:
    """A vehicle of pymavlink's, speaking MAVLink 1 as that does by default, whose socket would hear it."""
    for control in (False, True):
        source = MonitorSource(Endpoint("udpin", "127.0.0.1", 0), control=control)
        vehicle = mavutil.mavlink_connection(f"udpout:127.0.0.1:{source.port}", source_system=3)
        try:
            vehicle.mav.heartbeat_send(mav.MAV_TYPE_QUADROTOR, mav.MAV_AUTOPILOT_ARDUPILOTMEGA, 81, 4, 4)
            select.select([source], [], [], 10.0)
            messages = source.receive()
            assert [v["label"] for m in messages if m["type"] == "snapshot" for v in m["vehicles"]] == ["copter 3"]
            source.receive()
            heard, _, _ = select.select([vehicle.port], [], [], 5.0 if control else 0.0)
            assert bool(heard) is control
            if control:
                assert vehicle.recv_match(type="HEARTBEAT").type == mav.MAV_TYPE_GCS
        finally:
            vehicle.close()
            source.close()


def _events(messages: list[Any]) -> list[dict[str, Any]]:
    return [event for message in messages if message["type"] == "snapshot" for event in message["events"]]


def test_a_second_vehicle_of_the_same_id_is_told_and_not_believed() -> None:
    source = MonitorSource(Endpoint("udpin", "127.0.0.1", 0))
    first, second = (mavutil.mavlink_connection(f"udpout:127.0.0.1:{source.port}", source_system=3) for _ in range(2))
    try:
        told: list[Any] = []
        for link, mode in ((first, 4), (second, 6)):
            link.mav.heartbeat_send(mav.MAV_TYPE_QUADROTOR, mav.MAV_AUTOPILOT_ARDUPILOTMEGA, 81, mode, 4)
            select.select([source], [], [], 10.0)
            told += source.receive()
        deadline_s = time.monotonic() + 10.0
        while not any("Another" in event["text"] for event in _events(told)):
            assert time.monotonic() < deadline_s
            select.select([source], [], [], 0.1)
            told += source.receive()
        snapshot = [message for message in told if message["type"] == "snapshot"][-1]
        assert snapshot["vehicles"][0]["mode"] == "offboard"
        assert [event["level"] for event in _events(told) if "Another vehicle says that it is 3" in event["text"]] == [
            "warning"
        ]
    finally:
        for link in (first, second):
            link.close()
        source.close()


def test_a_stream_is_read_however_it_is_cut_and_made_again_when_it_has_ended() -> None:
    """TCP, a byte at a time at first."""
    server = socket.create_server(("127.0.0.1", 0))
    source = MonitorSource(Endpoint("tcp", *server.getsockname()))
    said: list[Any] = []

    def until(wanted: Callable[[Any], bool]) -> dict[str, Any]:
        deadline_s = time.monotonic() + PATIENCE_S
        while not any(map(wanted, said)):
            assert time.monotonic() < deadline_s
            select.select([source], [], [], 0.2)
            said.extend(m for m in source.receive() if m["type"] == "snapshot")
        return dict(next(filter(wanted, reversed(said))))

    try:
        peer, _ = server.accept()
        sender = common.MAVLink(None, srcSystem=4, srcComponent=1)
        raw = b"".join(bytes(sender.heartbeat_encode(2, 12, 0x81, 6 << 16, 4).pack(sender)) for _ in range(3))
        for byte in raw[:30]:
            peer.sendall(bytes([byte]))
            select.select([source], [], [], 5.0)
            said += [m for m in source.receive() if m["type"] == "snapshot"]
        peer.sendall(raw[30:])
        row = until(lambda s: bool(s["vehicles"]))["vehicles"][0]
        assert (row["sysid"], row["mode"], row["lost"]) == (4, "offboard", 0)
        peer.close()
        told = until(lambda s: any("closed the connection" in event["text"] for event in s["events"]))
        assert [event["level"] for event in told["events"]] == ["warning"]
        until(lambda s: any(event["text"].endswith(" is there") for event in s["events"]))
        assert source.connected
        server.accept()[0].close()
    finally:
        source.close()
        server.close()


def test_bad_addresses_and_ports_in_use_are_a_sentence_and_status_2() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", 0))
        port = taken.getsockname()[1]
        for argv, word in (
            (("--connect", "udpin:nowhere"), "is no address"),
            (
                ("--connect", f"udpin:127.0.0.1:{port}"),
                f"udpin:127.0.0.1:{port} cannot be listened at: Address already in use; another program",
            ),
            (
                ("--connect", "udpin:203.0.113.7:14550"),
                "udpin:203.0.113.7:14550 cannot be listened at: Cannot assign requested address",
            ),
            (("session", "--connect", "udpin:127.0.0.1:0"), "exclude each other"),
            (("--control",), "--control is for --connect"),
        ):
            refused = gcs("monitor", "--plain", *argv)
            assert refused.returncode == 2, refused.stderr
            assert word in " ".join(refused.stderr.split())
            assert "Traceback" not in refused.stderr
