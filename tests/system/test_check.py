"""`gcs check` against real vehicle processes, some of whose replies never arrive."""

from __future__ import annotations

import json
import select
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from ports import free_port
from pymavlink.dialects.v20 import common as mav
from sessions import GCS
from strangers import ARDUCOPTER, strangers

VEHICLE = [sys.executable, "-c", "from simvehicle.cli import main; main()"]
CHECK = ["check", "--json", "--wait", "60"]
SWALLOWED = {
    mav.MAVLINK_MSG_ID_BATTERY_STATUS: "stream-battery-status",
    mav.MAVLINK_MSG_ID_PING: "ping",
    mav.MAVLINK_MSG_ID_TIMESYNC: "timesync",
}
"""Each swallowed message is one question's only answer."""
GONE_WITHOUT = {mav.MAVLINK_MSG_ID_PARAM_ERROR: "parameter-unknown"}
"""Likewise, but real autopilots do not send it and their peers know to go on."""


STOPPED_S = 4.0
"""Longer than MAVSDK waits for a HEARTBEAT."""
COMMAND = mav.MAVLINK_MSG_ID_COMMAND_LONG


def msgid_of(datagram: bytes) -> int:
    """Of a datagram that carries one message, as all here do."""
    return int.from_bytes(datagram[7:10], "little")


def port_of(vehicle: subprocess.Popen[str]) -> int:
    """The port that the vehicle says it got."""
    assert vehicle.stdout is not None
    return int(vehicle.stdout.readline().rsplit(" ", 1)[1].strip(")\n"))


@contextmanager
def swallowing(to_port: int, msgids: set[int], asked: threading.Event | None = None) -> Iterator[int]:
    """A port that passes datagrams on to a vehicle and back, without these messages on the way back; `asked` is set
    when the vehicle is asked something."""
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as near,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as far,
    ):
        near.bind(("127.0.0.1", 0))
        far.connect(("127.0.0.1", to_port))
        stop, stopped = socket.socketpair()

        def pass_on() -> None:
            asker = None
            while True:
                ready = select.select([near, far, stopped], [], [])[0]
                if stopped in ready:
                    return
                if near in ready:
                    datagram, asker = near.recvfrom(65535)
                    far.send(datagram)
                    if asked is not None and msgid_of(datagram) == COMMAND:
                        asked.set()
                if far in ready:
                    datagram = far.recv(65535)
                    if asker and msgid_of(datagram) not in msgids:
                        near.sendto(datagram, asker)

        thread = threading.Thread(target=pass_on)
        thread.start()
        try:
            yield near.getsockname()[1]
        finally:
            stop.close()
            thread.join()
            stopped.close()


@pytest.fixture(scope="module")
def checked() -> dict[str, tuple[int, dict[str, Any]]]:
    """(exit status, what was found) for each autopilot, for one whose replies are swallowed, and by a check that is
    stopped for a while; all at once."""
    runs = {"px4": ["--arm"], "ardupilot": ["--arm"], "generic": [], "swallowed": [], "stopped": []}
    with ExitStack() as stack:
        checks = {}
        for name, options in runs.items():
            autopilot = ["--autopilot", name if name in ("px4", "ardupilot", "generic") else "px4"]
            argv = [*VEHICLE, "--sysid", "3", "--connect", "udpin:127.0.0.1:0", *autopilot]
            vehicle = stack.enter_context(subprocess.Popen(argv, stdout=subprocess.PIPE, text=True))
            stack.callback(vehicle.kill)
            port = port_of(vehicle)
            if name == "swallowed":
                port = stack.enter_context(swallowing(port, {*SWALLOWED, *GONE_WITHOUT}))
            if name == "stopped":
                asked = threading.Event()
                port = stack.enter_context(swallowing(port, set(), asked))
            argv = [*GCS, *CHECK, "--connect", f"udpout:127.0.0.1:{port}", *options]
            process = subprocess.Popen(argv, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            checks[name] = stack.enter_context(process)
            stack.callback(process.kill)
        port = free_port()
        copter = [*ARDUCOPTER, "--sysid", "3", "--connect", f"udpout:127.0.0.1:{port}"]
        stack.callback(stack.enter_context(subprocess.Popen(copter, stdin=subprocess.PIPE)).kill)
        argv = [*GCS, *CHECK, "--connect", f"udpin:127.0.0.1:{port}"]
        process = subprocess.Popen(argv, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        checks["arducopter"] = stack.enter_context(process)
        stack.callback(process.kill)
        assert asked.wait(60.0)
        checks["stopped"].send_signal(signal.SIGSTOP)
        with pytest.raises(subprocess.TimeoutExpired):
            checks["stopped"].wait(timeout=STOPPED_S)
        checks["stopped"].send_signal(signal.SIGCONT)
        outputs = {name: process.communicate(timeout=90)[0] for name, process in checks.items()}
        return {name: (checks[name].returncode, json.loads(output)) for name, output in outputs.items()}


@pytest.mark.parametrize("autopilot", ["px4", "ardupilot"])
def test_our_vehicle_makes_no_peer_miss_anything(checked: dict[str, Any], autopilot: str) -> None:
    status, found = checked[autopilot]
    assert [f for f in found["findings"] if f["outcome"] in ("missing", "wrong")] == []
    assert status == 0
    assert found["autopilot"] == autopilot
    assert {"arm", "disarm", "offboard", "parameter-list"} <= {f["key"] for f in found["findings"]}


def test_the_habits_of_an_arducopter_are_no_fault(checked: dict[str, Any]) -> None:
    """The scripted one, which has those that the real one of 4.6 showed."""
    status, found = checked["arducopter"]
    assert [f for f in found["findings"] if f["outcome"] in ("missing", "wrong")] == []
    assert (status, found["autopilot"]) == (0, "ardupilot")
    assert [f["key"] for f in found["findings"] if f["outcome"] == "late"] == ["parameter-unknown"]
    skipped = {f["key"] for f in found["findings"] if f["outcome"] == "skipped"}
    assert "ping" in skipped
    assert not skipped & {"parameter-list", "parameter-read", "parameter-set", "parameter-encoding"}


def test_a_generic_autopilot_is_named_as_what_qgroundcontrol_cannot_command(checked: dict[str, Any]) -> None:
    status, found = checked["generic"]
    faults = [f for f in found["findings"] if f["outcome"] in ("missing", "wrong")]
    assert [f["key"] for f in faults] == ["autopilot"]
    assert list(faults[0]["misses"]) == ["QGroundControl"]
    assert status == 1


def test_exactly_the_replies_that_are_swallowed_are_named(checked: dict[str, Any]) -> None:
    status, found = checked["swallowed"]
    assert {f["key"] for f in found["findings"] if f["outcome"] in ("missing", "wrong")} == set(SWALLOWED.values())
    assert {f["key"] for f in found["findings"] if f["outcome"] == "late"} >= set(GONE_WITHOUT.values())
    assert all(f["misses"] for f in found["findings"] if f["outcome"] == "missing")
    assert status == 1


def test_a_check_that_the_machine_keeps_from_running_for_a_while_blames_no_vehicle(checked: dict[str, Any]) -> None:
    status, found = checked["stopped"]
    assert [f for f in found["findings"] if f["outcome"] in ("missing", "wrong")] == []
    assert status == 0


@pytest.mark.parametrize("as_json", [False, True])
def test_one_that_has_just_started_is_said_to_be_not_ready_yet(tmp_path: Path, as_json: bool) -> None:
    """The scripted one, whose pre-arm bit is set after 60 s here."""
    port = free_port()
    copter = [*ARDUCOPTER, "--connect", f"udpout:127.0.0.1:{port}", "--refuse-arming-s", "100"]
    options = ["--peer", "qgroundcontrol", "--wait", "60", *(["--json"] if as_json else [])]
    with strangers(tmp_path, copter):
        done = gcs("check", "--connect", f"udpin:127.0.0.1:{port}", *options)
    assert done.returncode == 1
    last = (done.stderr if as_json else done.stdout).splitlines()[-1]
    assert last.startswith("not ready yet: vehicle 1 had run for ")
    assert last.endswith("its pre-arm checks did not pass; with --wait-ready 60 the check waits for that first")


def test_nobody_there_is_one_sentence() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as silent:
        silent.bind(("127.0.0.1", 0))
        to = f"udpout:127.0.0.1:{silent.getsockname()[1]}"
        done = gcs(*CHECK, "--connect", to, "--wait", "0.5")
    assert done.returncode == 2
    assert done.stderr.splitlines()[-1].startswith("gcs: no vehicle's HEARTBEAT came within 0.5 s")
    assert "Traceback" not in done.stderr


def test_a_port_in_use_and_an_address_that_is_none_are_named() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", 0))
        address = f"udpin:127.0.0.1:{taken.getsockname()[1]}"
        for connect, words in (
            (address, "in use; another program listens there: end it"),
            ("14550", "no address"),
            ("udpout:no-such-host.invalid:1", "no-such"),
        ):
            done = gcs(*CHECK, "--connect", connect)
            assert done.returncode == 2
            assert words in done.stderr
            assert "Traceback" not in done.stderr
