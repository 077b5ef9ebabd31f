"""A link that carries nothing: every command that asks vehicles says why in one sentence, with what to do."""

from __future__ import annotations

import itertools
import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
import serial
from commands import gcs
from ports import free_port
from pymavlink.dialects.v20 import common as mav
from radios import Cable

COMMANDS = (("check",), ("params", "get", "RTL_ALT"), ("mission", "get"), ("logs", "list"))
SENDER = mav.MAVLink(None, srcSystem=4, srcComponent=1)
HEARTBEAT = mav.MAVLink_heartbeat_message(2, 12, 0x81, 0, 4, 3)
EVERY_S = 0.02

Trouble = tuple[str, str, str]
"""(address, what is said to be wrong, what to do)"""


def spoken(stack: ExitStack, say: Callable[[], object]) -> None:
    """Have somebody say something again and again."""
    stop = threading.Event()

    def live() -> None:
        while not stop.wait(EVERY_S):
            say()

    thread = threading.Thread(target=live, daemon=True)
    thread.start()
    stack.callback(thread.join)
    stack.callback(stop.set)


def wrong_rate(stack: ExitStack, folder: Path, _: pytest.MonkeyPatch) -> Trouble:
    cable = Cable(folder / "ttyRadio", 57600)
    cable.start()
    stack.callback(cable.close)
    vehicle = stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
    spoken(stack, lambda: vehicle.sendto(3 * HEARTBEAT.pack(SENDER), ("127.0.0.1", cable.port)))
    return f"serial:{folder}/ttyRadio:115200", "what comes is no MAVLink", "has the other end another rate than 115200"


def no_device(_: ExitStack, folder: Path, __: pytest.MonkeyPatch) -> Trouble:
    return f"serial:{folder}/ttyUSB7:57600", f"there is no device {folder}/ttyUSB7", "plugged in"


def no_permission(_: ExitStack, folder: Path, patch: pytest.MonkeyPatch) -> Trouble:
    def forbid(*_: object, **__: object) -> None:
        raise serial.SerialException(13, "could not open port: [Errno 13] Permission denied")

    patch.setattr(serial, "Serial", forbid)
    return f"serial:{folder}/ttyUSB0:57600", "you may not use it", "join its group, mostly by `sudo usermod -aG dialout"


def used_port(stack: ExitStack, _: Path, __: pytest.MonkeyPatch) -> Trouble:
    taken = stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
    taken.bind(("127.0.0.1", 0))
    return (
        f"udpin:127.0.0.1:{taken.getsockname()[1]}",
        "Address already in use",
        "another program listens there: end it",
    )


def used_tcp_port(stack: ExitStack, _: Path, __: pytest.MonkeyPatch) -> Trouble:
    taken = stack.enter_context(socket.create_server(("127.0.0.1", 0)))
    return (
        f"tcpin:127.0.0.1:{taken.getsockname()[1]}",
        "Address already in use",
        "another program listens there: end it",
    )


def old_mavlink(stack: ExitStack, _: Path, __: pytest.MonkeyPatch) -> Trouble:
    port = free_port()
    vehicle = stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
    old = bytes(HEARTBEAT.pack(SENDER, force_mavlink1=True))
    spoken(stack, lambda: vehicle.sendto(old, ("127.0.0.1", port)))
    return f"udpin:127.0.0.1:{port}", "only MAVLink 1 comes", "ArduPilot: SERIALn_PROTOCOL 2; PX4: MAV_PROTO_VER 2"


@pytest.fixture
def stack() -> Iterator[ExitStack]:
    with ExitStack() as opened:
        yield opened


@pytest.mark.parametrize(
    ("words", "trouble"),
    [
        *itertools.product(COMMANDS, [wrong_rate, no_device, no_permission, used_port, used_tcp_port]),
        (("check",), old_mavlink),  # the others speak it: tests/gcs/link/test_fleet_client.py
    ],
)
def test_a_link_that_carries_nothing_is_one_sentence_with_what_to_do(
    words: tuple[str, ...],
    trouble: Callable[[ExitStack, Path, pytest.MonkeyPatch], Trouble],
    stack: ExitStack,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    address, wrong, to_do = trouble(stack, tmp_path, monkeypatch)
    done = gcs(*words, "--connect", address, "--wait", "0.7")
    assert done.returncode == 2
    said = [line for line in done.stderr.splitlines() if line and not line.startswith(("waiting for", "Usage", "Try"))]
    assert len(said) == 1, done.stderr
    assert wrong in said[0], said
    assert to_do in said[0], said
