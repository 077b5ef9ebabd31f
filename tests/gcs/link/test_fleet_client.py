"""Every vehicle at an address is spoken to as it speaks: MAVLink 1, MAVLink 2, or first the one and then the other.

The vehicles are pymavlink's, each at a port of its own or all behind one."""

from __future__ import annotations

import socket
import threading
from collections import Counter
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import Any, Literal

import pytest
from commands import gcs
from patience import PATIENCE_S
from ports import free_port
from pymavlink.dialects.v10 import ardupilotmega as mavlink1
from pymavlink.dialects.v20 import ardupilotmega as mavlink2

from gcs.link.fleet_client import FleetClient
from gcs.scenario.endpoint import address

Speech = Literal["old", "changes", "new"]
MARKERS = {0xFE: 1, 0xFD: 2}


class Vehicle:
    """Knows MAVLink 1 only, speaks it until it hears MAVLink 2, or knows MAVLink 2 only."""

    def __init__(self, sysid: int, speech: Speech) -> None:
        self.sysid, self.speech = sysid, speech
        self.version = 2 if speech == "new" else 1
        self.heard: Counter[tuple[int, str]] = Counter()
        """(version, message) of all that it could read and that was for it"""
        self._out = {1: mavlink1.MAVLink(None, sysid, 1), 2: mavlink2.MAVLink(None, sysid, 1)}

    def say(self, name: str, *values: Any) -> bytes:
        module, out = (mavlink1, mavlink2)[self.version - 1], self._out[self.version]
        raw = bytes(getattr(module, f"MAVLink_{name}_message")(*values).pack(out))
        out.seq = (out.seq + 1) % 256
        return raw

    def beat(self) -> bytes:
        return self.say("heartbeat", 2, 3, 81, 0, 3, 3)

    def hear(self, raw: bytes) -> list[bytes]:
        """Answers to a frame."""
        version = MARKERS[raw[0]]
        if (self.speech, version) in (("old", 2), ("new", 1)):
            return []
        if version == 2:
            self.version = 2
        (message,) = (mavlink1, mavlink2)[version - 1].MAVLink(None).parse_buffer(raw)
        name = message.get_type()
        if getattr(message, "target_system", 0) not in (0, self.sysid):
            return []
        self.heard[version, name] += 1
        if name == "COMMAND_LONG":
            return [self.say("home_position", 10 * self.sysid, 20, 30, 0, 0, 0, [1, 0, 0, 0], 0, 0, 0)]
        if name == "PARAM_REQUEST_READ":
            return [self.say("param_value", b"RTL_ALT", 10.0 * self.sysid, 9, 1, 0)]
        return []


@contextmanager
def flying(port: int, *groups: list[Vehicle]) -> Iterator[None]:
    """Let them live, each group at one port."""
    stop = threading.Event()

    def live(group: list[Vehicle], at: socket.socket) -> None:
        k = 0
        while not stop.is_set():
            for vehicle in group:
                if k % 20 == 0:
                    at.send(vehicle.beat())
            k += 1
            try:
                raw = at.recv(4096)
            except OSError:  # nothing came, or nobody is there
                continue
            for vehicle in group:
                for answer in vehicle.hear(raw):
                    at.send(answer)

    with ExitStack() as stack:
        threads = []
        for group in groups:
            at = stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
            at.connect(("127.0.0.1", port))
            at.settimeout(0.02)
            threads.append(threading.Thread(target=live, args=(group, at)))
        for thread in threads:
            thread.start()
        try:
            yield
        finally:
            stop.set()
            for thread in threads:
                thread.join()


def fleet() -> list[Vehicle]:
    return [Vehicle(3, "old"), Vehicle(4, "changes"), Vehicle(5, "new")]


def asked() -> FleetClient:
    at = address("udpin:127.0.0.1:0")
    assert at is not None
    return FleetClient(at)


@pytest.mark.parametrize("together", [False, True])
def test_all_are_found_and_asked_each_in_its_own_version(together: bool) -> None:
    old, changes, new = vehicles = fleet()
    link, groups = asked(), [vehicles] if together else [[one] for one in vehicles]
    with flying(link.listener.connection.port, *groups):
        assert link.find((), PATIENCE_S)
        assert link.profiles.keys() == {3, 4, 5}
        told = link.request(("HOME_POSITION",), PATIENCE_S)
        assert {sysid: home["HOME_POSITION"].latitude for sysid, home in told.items()} == {3: 30, 4: 40, 5: 50}
        while not (old.heard[1, "HEARTBEAT"] and changes.heard[2, "HEARTBEAT"] and new.heard[2, "HEARTBEAT"]):
            link.exchange([])
    link.close()
    assert old.heard[1, "COMMAND_LONG"] >= 1
    assert changes.version == 2
    assert new.heard[2, "COMMAND_LONG"] >= 1
    assert {version for version, _ in old.heard} == {1}
    assert {version for version, _ in new.heard} == {2}


def test_a_command_for_every_vehicle_reaches_the_one_that_speaks_mavlink_1() -> None:
    port = free_port()
    vehicles = fleet()
    with flying(port, *[[one] for one in vehicles]):
        done = gcs("params", "get", "RTL_ALT", "--connect", f"udpin:127.0.0.1:{port}", "--json")
    assert done.returncode == 0, done.stderr
    for sysid in (3, 4, 5):
        assert f'"{sysid}": {{"RTL_ALT": {10.0 * sysid}' in done.stdout


def test_a_vehicle_whose_messages_are_refused_is_named_and_the_command_is_not_done() -> None:
    """One signs with a key that nobody has given."""
    port, vehicles = free_port(), [Vehicle(3, "new"), Vehicle(5, "new")]
    vehicles[1]._out[2].signing.secret_key, vehicles[1]._out[2].signing.sign_outgoing = b"k" * 32, True
    words = ("params", "get", "RTL_ALT", "--connect", f"udpin:127.0.0.1:{port}")
    with flying(port, *[[one] for one in vehicles]):
        done, named = gcs(*words), gcs(*words, "--sysid", "3")
    assert done.returncode == 1
    assert "vehicle 5 is left out" in done.stderr
    assert "RTL_ALT" in done.stdout
    assert named.returncode == 0, named.stderr
    assert "left out" not in named.stderr


@pytest.mark.parametrize("sysids", [(3, 4), (3, 3)])
def test_a_second_autopilot_of_one_system_id_is_named(sysids: tuple[int, int]) -> None:
    port = free_port()
    with flying(port, *([Vehicle(sysid, "new")] for sysid in sysids)):
        done = gcs("params", "get", "RTL_ALT", "--connect", f"udpin:127.0.0.1:{port}")
    assert done.returncode == int(sysids[0] == sysids[1]), done.stderr
    named = f"gcs: two autopilots say that they are vehicle {sysids[0]}; the one at 127.0.0.1:"
    assert (named in done.stderr) == (sysids[0] == sysids[1])
