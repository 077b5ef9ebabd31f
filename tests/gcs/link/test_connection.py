"""Connections of every way: bytes both ways, what is lost is had again, and what goes wrong is told with advice."""

import os
import select
import socket
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from patience import PATIENCE_S
from ports import free_port
from pymavlink.dialects.v20 import common as mav
from radios import Cable

from gcs.link import connection as module
from gcs.link import serial_device, tcp
from gcs.link.addresses import open_connection
from gcs.link.connection import Channel
from gcs.link.diagnosis import Diagnosis
from gcs.link.socket import AddressRefused
from gcs.mavlink import codec
from gcs.scenario.endpoint import address

SENDER = mav.MAVLink(None, srcSystem=4, srcComponent=1)
FRAME = bytes(mav.MAVLink_heartbeat_message(2, 12, 0x81, 6 << 16, 4, 3).pack(SENDER))


def opened(text: str) -> Any:
    at = address(text)
    assert at is not None
    return open_connection(at)


def until(one: Channel, holds: Callable[[], object], count: int = 0) -> list[bytes]:
    """Tend and read until something holds and so many frames have come; the frames."""
    came: list[bytes] = []
    deadline_s = time.monotonic() + PATIENCE_S
    while not holds() or len(came) < count:
        assert time.monotonic() < deadline_s, one.problem
        one.tend(time.monotonic())
        select.select([one], [], [], 0.02)
        for data, sender in one.receive():
            came += [frame.raw for frame in one.split(data, sender).frames]
    return came


def read(one: Channel, count: int) -> list[bytes]:
    return until(one, lambda: True, count)


@pytest.fixture(autouse=True)
def soon(monkeypatch: pytest.MonkeyPatch) -> None:
    for one in (tcp, serial_device):
        monkeypatch.setattr(one, "RETRY_S", 0.02)


def test_tcp_is_made_when_somebody_listens_and_again_when_it_has_ended() -> None:
    where = ("127.0.0.1", free_port())
    one = opened(f"tcp:127.0.0.1:{where[1]}")
    until(one, lambda: "it cannot be reached (Connection refused)" in one.problem)
    for _ in range(2):
        with socket.create_server(where) as server:
            until(one, lambda: not one.problem)
            peer, _ = server.accept()
            with peer:
                peer.sendall(FRAME[:5])
                peer.sendall(FRAME[5:] + FRAME)
                assert read(one, 2) == [FRAME, FRAME]
                one.send(FRAME, one.to or ())
                assert peer.recv(1000) == FRAME
        until(one, lambda: "closed the connection" in one.problem)
        assert one.pop_gone() == {one.to}
    one.close()


@pytest.mark.parametrize("host", ["127.0.0.1", "[::1]"])
def test_tcpin_answers_each_who_connects_and_knows_who_has_gone(host: str) -> None:
    one = opened(f"tcpin:{host}:0")
    to = (host.strip("[]"), one.port)
    with socket.create_connection(to) as first, socket.create_connection(to) as second:
        until(one, lambda: len(one.senders) == 2)
        first.sendall(FRAME[:9])
        second.sendall(FRAME)
        first.sendall(FRAME[9:])
        assert read(one, 2) == [FRAME, FRAME]
        for sender in one.senders:
            one.send(FRAME, sender)
        assert first.recv(1000) == second.recv(1000) == FRAME
        gone = second.getsockname()
    until(one, lambda: not one.senders)
    assert gone in one.pop_gone()
    one.close()


@pytest.mark.parametrize("first", [b"", b"no MAVLink at all", FRAME])
def test_who_has_sent_something_once_and_then_nothing_holds_no_place(
    first: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Strangers hold every place; those that have sent a frame lately keep theirs."""
    one = opened("tcpin:127.0.0.1:0")
    idle = []
    for _ in range(tcp.MOST_CONNECTIONS):
        idle.append(socket.create_connection(("127.0.0.1", one.port)))
        idle[-1].sendall(first)
        until(one, lambda: idle[-1].getsockname() in one.senders)
    if first == FRAME:
        until(one, lambda: all(stream.heard_s for stream in one._streams.values()))
        with socket.create_connection(("127.0.0.1", one.port)) as refused:
            refused.settimeout(5.0)
            assert not list(one.receive())
            assert refused.recv(1) == b""
        monkeypatch.setattr(tcp, "YIELDS_S", 0.0)
    with socket.create_connection(("127.0.0.1", one.port)) as station:
        station.sendall(FRAME)
        heard = station.getsockname()
        until(one, lambda: heard in one.senders and one._streams[heard].heard_s is not None)
        assert len(one.senders) == tcp.MOST_CONNECTIONS
    for other in idle:
        other.close()
    one.close()


def test_of_a_flood_on_a_stream_a_bounded_piece_is_taken_at_once() -> None:
    one = opened("tcpin:127.0.0.1:0")
    with socket.create_connection(("127.0.0.1", one.port)) as flood:
        flood.setblocking(False)
        until(one, lambda: one.senders)
        sent = 0
        while sent < 4 * module.STREAM_CHUNKS * 4096 and select.select([], [flood], [], 0.2)[1]:
            sent += flood.send(b"\xfd" * 65536)
        assert sum(len(data) for data, _ in one.receive()) <= module.STREAM_CHUNKS * 4096
    one.close()


def test_who_does_not_read_loses_frames_and_costs_nothing_else() -> None:
    one = opened("tcpin:127.0.0.1:0")
    with socket.create_connection(("127.0.0.1", one.port)) as deaf:
        until(one, lambda: one.senders)
        (sender,) = one.senders
        began_s = time.monotonic()
        while sum(len(stream._unsent) for stream in one._streams.values()) == 0:  # type: ignore[attr-defined]
            for _ in range(1000):
                one.send(FRAME, sender)
            assert time.monotonic() - began_s < PATIENCE_S
        for _ in range(1000):
            one.send(FRAME, sender)
        (stream,) = one._streams.values()  # type: ignore[attr-defined]
        assert len(stream._unsent) <= module.STREAM_OUT_BYTES
        got, buffer = 0, b""
        deaf.settimeout(0.5)
        while got < 200:  # what comes later is whole frames only
            buffer += deaf.recv(65536)
            frames = codec.split(buffer).frames
            got += len(frames)
            buffer = buffer[len(FRAME) * len(frames) :]
    one.close()


def test_a_cable_is_read_at_its_rate_and_opened_again_when_it_is_back(tmp_path: Path) -> None:
    device = tmp_path / "ttyRadio"
    cable = Cable(device, 57600)
    cable.start()
    one = opened(f"serial:{device}:57600")
    vehicle = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        for _ in range(2):
            until(one, lambda: not one.problem)
            vehicle.sendto(FRAME, ("127.0.0.1", cable.port))
            assert read(one, 1) == [FRAME]
            one.send(FRAME, one.to or ())
            assert select.select([vehicle], [], [], PATIENCE_S)[0]
            assert vehicle.recv(1000) == FRAME
            cable.pull()
            until(one, lambda: "there is no device" in one.problem)
            cable.plug()
        until(one, lambda: not one.problem)
        with pytest.raises(AddressRefused, match="another program has it open"):
            opened(f"serial:{device}:57600")
    finally:
        one.close()
        cable.close()
        vehicle.close()


def test_what_is_no_device_is_refused_and_one_that_is_missing_may_be_plugged_in_yet(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("no device")
    with pytest.raises(AddressRefused, match="it is no serial device"):
        opened(f"serial:{tmp_path}/file:57600")
    missing = opened(f"serial:{tmp_path}/ttyUSB0:57600")
    assert missing.problem.startswith(f"there is no device {tmp_path}/ttyUSB0; ")
    missing.close()
    with pytest.raises(AddressRefused, match=r"the host .* cannot be found"):
        opened("tcp:no.such.host.invalid:5760")


def test_who_speaks_mavlink_1_only_is_told_what_to_set() -> None:
    old = bytes(mav.MAVLink_heartbeat_message(2, 12, 0x81, 0, 4, 3).pack(SENDER, force_mavlink1=True))
    one = opened("udpin:127.0.0.1:0")
    diagnosis = Diagnosis(one.at)
    assert diagnosis.count(old, codec.split(old))
    assert diagnosis.text("", 4).startswith("only MAVLink 1 comes: let it speak MAVLink 2")
    diagnosis.count(FRAME, codec.split(FRAME))
    assert diagnosis.text("", 5) == ""
    assert diagnosis.text("", 4).startswith("only MAVLink 1 comes")
    one.close()


def test_nothing_is_left_open() -> None:
    before = len(os.listdir("/proc/self/fd"))
    with socket.create_server(("127.0.0.1", 0)) as server:
        for text in (f"tcp:127.0.0.1:{server.getsockname()[1]}", "tcpin:127.0.0.1:0", "udpin:[::1]:0"):
            opened(text).close()
    assert len(os.listdir("/proc/self/fd")) == before
