"""`--station`: every command that asks vehicles without a scenario speaks by that id, and by 255/190 without it."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from pathlib import Path

import pytest
from commands import gcs
from pymavlink.dialects.v20 import common as mav

from gcs.cli.check.dialogue import CheckedVehicle, ReceivedMessage
from gcs.cli.check.predicates import acknowledged
from gcs.link.fleet_client import FleetClient
from gcs.mavlink import codec
from gcs.scenario.endpoint import Endpoint
from gcs.session.monitor import MonitorSource

BRIEFLY = ("--wait", "0.2")
COMMANDS = (
    ("check", *BRIEFLY),
    ("params", "get", "RTL_ALT", *BRIEFLY),
    ("params", "set", "RTL_ALT=1", *BRIEFLY),
    ("params", "diff", *BRIEFLY),
    ("mission", "get", *BRIEFLY),
    ("mission", "clear", *BRIEFLY),
    ("logs", "list", *BRIEFLY),
    ("logs", "get", *BRIEFLY),
)


@pytest.fixture
def vehicle() -> Iterator[socket.socket]:
    """A vehicle's port: it hears who speaks, and says nothing."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as port:
        port.bind(("127.0.0.1", 0))
        port.setblocking(False)
        yield port


def speakers(vehicle: socket.socket) -> set[tuple[int, int]]:
    """(system, component) of all frames that have come."""
    heard: set[tuple[int, int]] = set()
    while True:
        try:
            raw = vehicle.recv(4096)
        except BlockingIOError:
            return heard
        heard |= {(frame.sysid, frame.compid) for frame in codec.split(raw).frames}


@pytest.mark.parametrize("words", COMMANDS, ids=" ".join)
def test_a_command_speaks_by_the_id_that_it_is_given(
    words: tuple[str, ...], vehicle: socket.socket, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    at = ("--connect", f"udpout:127.0.0.1:{vehicle.getsockname()[1]}")
    for option, ids in (((), (255, 190)), (("--station", "245"), (245, 190)), (("--station", "245/25"), (245, 25))):
        assert gcs(*words, *at, *option).returncode == 2  # nobody answers
        assert speakers(vehicle) == {ids}


def test_init_asks_by_it_and_only_where_it_asks(
    vehicle: socket.socket, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    find = FleetClient.find
    monkeypatch.setattr(FleetClient, "find", lambda fleet, wanted, _: find(fleet, wanted, 0.2))
    at = f"udpout:127.0.0.1:{vehicle.getsockname()[1]}"
    assert gcs("init", "field", "--connect", at, "--station", "245/25").returncode == 2
    assert speakers(vehicle) == {(245, 25)}
    refused = gcs("init", "field", "--station", "245/25")
    assert refused.returncode == 2
    assert "--station is for --connect" in refused.stderr


def test_the_monitor_speaks_by_it_where_it_speaks(vehicle: socket.socket) -> None:
    at = Endpoint("udpout", "127.0.0.1", vehicle.getsockname()[1])
    source = MonitorSource(at, control=True, station=(245, 25))
    source.receive()
    source.close()
    assert speakers(vehicle) == {(245, 25)}
    refused = gcs("monitor", "--connect", at.text, "--station", "245")
    assert refused.returncode == 2
    assert "--station is for --control" in refused.stderr


@pytest.mark.parametrize(("target", "verdict"), [((245, 25), "ok"), ((0, 0), "ok"), ((255, 190), None)])
def test_an_acknowledgement_counts_that_is_addressed_to_it(target: tuple[int, int], verdict: str | None) -> None:
    judge, _ = acknowledged(mav.MAV_CMD_REQUEST_MESSAGE)
    ack = codec.message(
        "COMMAND_ACK", command=mav.MAV_CMD_REQUEST_MESSAGE, result=0, target_system=target[0],
        target_component=target[1],
    )  # fmt: skip
    received = ReceivedMessage("COMMAND_ACK", codec.fields(codec.split(codec.frame(ack, 0, 1, 1)).frames[0]), 0.0)
    found = judge(CheckedVehicle(1, 1, (245, 25)), [received])
    assert (found.outcome if found else None) == verdict


@pytest.mark.parametrize("wrong", ["", "0", "256", "245/1", "245/", "/190", "one", "245/25/3", "-1"])
def test_an_id_that_is_none_is_refused(wrong: str) -> None:
    refused = gcs("params", "diff", "--station", wrong)
    assert refused.returncode == 2
    assert "--station" in refused.stderr


def test_a_scenario_has_its_own(tmp_path: Path) -> None:
    refused = gcs("check", str(tmp_path / "field.yaml"), "--station", "245")
    assert "--station is for a check without a scenario" in refused.stderr


@pytest.mark.parametrize("seconds", ["nan", "inf"])
def test_waiting_is_for_a_finite_time(seconds: str) -> None:
    for command, *_ in {words[0]: words for words in COMMANDS}.values():
        asked = {"params": ("get", "RTL_ALT"), "mission": ("get",), "logs": ("list",)}.get(command, ())
        refused = gcs(command, *asked, "--wait", seconds)
        assert (refused.returncode, f"{seconds} is not a finite number." in refused.stderr) == (2, True), refused.stderr
