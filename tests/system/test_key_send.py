"""`gcs key send`: a real vehicle process gets a key, another one, and none, each seen by a signed exchange; pymavlink
is the stranger that then gets no answer."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from patience import PATIENCE_S
from ports import free_port
from strangers import ARDUCOPTER, SIMVEHICLE, strangers

from gcs.link.keys import new_key


@pytest.fixture
def port(tmp_path: Path) -> Iterator[int]:
    port = free_port()
    with strangers(tmp_path / "said", [*SIMVEHICLE, "--sysid", "7", "--connect", f"udpout:127.0.0.1:{port}"]):
        yield port


@pytest.fixture
def keys(tmp_path: Path) -> tuple[str, str]:
    for name in ("own.key", "other.key"):
        new_key(tmp_path / name)
    return str(tmp_path / "own.key"), str(tmp_path / "other.key")


def send(port: int, *argv: str, wait: str = f"{PATIENCE_S}") -> Any:
    return gcs("key", "send", *argv, "--connect", f"udpin:127.0.0.1:{port}", "--wait", wait)


def parameter(port: int, *argv: str, wait: str = f"{PATIENCE_S}") -> Any:
    at = f"udpin:127.0.0.1:{port}"
    return gcs("params", "get", "SYS_AUTOSTART", "--json", "--connect", at, "--wait", wait, *argv)


def test_a_key_is_given_changed_and_taken_away(port: int, keys: tuple[str, str]) -> None:
    own, other = keys
    given = send(port, own)
    assert (given.returncode, given.stdout) == (0, f"vehicle 7 answers signed with {own}.\n"), given.stderr
    assert json.loads(parameter(port, "--key-file", own).stdout)["vehicles"]["7"] == {"SYS_AUTOSTART": 4001}
    unsigned = parameter(port, wait="3")
    assert unsigned.returncode == 2
    wrong = send(port, other, "--key-file", other, wait="3")
    assert wrong.returncode == 2  # nothing that it says passes with that key
    changed = send(port, other, "--key-file", own)
    assert (changed.returncode, changed.stdout) == (0, f"vehicle 7 answers signed with {other}.\n"), changed.stderr
    taken = send(port, other, "--remove")
    assert taken.stdout == "vehicle 7 has no key any more, and answers what is not signed.\n", taken.stderr
    assert taken.returncode == 0
    assert parameter(port).returncode == 0


def test_no_key_is_sent_to_a_vehicle_that_is_armed(tmp_path: Path, keys: tuple[str, str]) -> None:
    port = free_port()
    flying = [*SIMVEHICLE, "--sysid", "7", "--airborne", "--position", "0,0,-5"]
    with strangers(tmp_path / "said", [*flying, "--connect", f"udpout:127.0.0.1:{port}"]):
        done = send(port, keys[0])
    assert done.returncode == 1
    assert "vehicle 7 is armed, and keys are set on the ground: it is as it was" in done.stderr


def test_a_vehicle_that_does_not_know_the_message_is_as_before(tmp_path: Path, keys: tuple[str, str]) -> None:
    port = free_port()
    with strangers(tmp_path / "said", [*ARDUCOPTER, "--sysid", "3", "--connect", f"udpout:127.0.0.1:{port}"]):
        done = send(port, keys[0])
    assert done.returncode == 1
    assert "vehicle 3 answers as before: it has not taken the message" in done.stderr


@pytest.mark.parametrize("connect", ["udpin:0.0.0.0:14999", "tcp:192.0.2.7:5760", "serial:/dev/ttyUSB0:57600"])
def test_a_link_that_others_may_read_carries_no_key_unasked(keys: tuple[str, str], connect: str) -> None:
    done = gcs("key", "send", keys[0], "--connect", connect)
    assert done.returncode == 2
    assert f"{connect} may be a radio or a network, where others read the key" in done.stderr
    removed = gcs("key", "send", keys[0], "--connect", connect, "--remove", "--key-file", keys[1])
    assert removed.returncode == 2
