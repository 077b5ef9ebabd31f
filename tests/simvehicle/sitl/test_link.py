"""Connection strings and sockets."""

import contextlib
import re
import select
import socket
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink.codec import message
from simvehicle.mavlink.connection import DATAGRAM_BYTES, Connection, pack
from simvehicle.sitl import link
from simvehicle.sitl.link import (
    MOST_PEERS,
    PEER_SILENT_S,
    SUPERVISED_BYTES,
    Address,
    AddressError,
    PlainLink,
    SupervisedLink,
    open_socket,
    parse_address,
)
from simvehicle.sitl.supervised import GrantReader

THREAT_MODEL = Path(__file__).resolve().parents[3] / "docs" / "threat-model.md"
HEARTBEAT = bytes(mav.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3).pack(mav.MAVLink(None, 255, 190)))


@pytest.mark.parametrize(
    ("text", "address"),
    [
        ("udpout:127.0.0.1:14550", Address("udpout", "127.0.0.1", 14550)),
        ("udpin:127.0.0.1:0", Address("udpin", "127.0.0.1", 0)),
        ("udpin:localhost:65535", Address("udpin", "localhost", 65535)),
        ("udpin:[::1]:14550", Address("udpin", "::1", 14550)),
    ],
)
def test_connection_string_is_read(text: str, address: Address) -> None:
    assert parse_address(text) == address


@pytest.mark.parametrize(
    "text",
    ["", "14550", "udpin", "udpin:127.0.0.1", "udpin::14550", "tcp:127.0.0.1:5760", "udpout:127.0.0.1:0",
     "udpin:127.0.0.1:65536", "udpin:127.0.0.1:-1", "udpin:127.0.0.1:1e3", "udpin:a b:1", " udpin:127.0.0.1:1"],
)  # fmt: skip
def test_connection_string_that_is_none_is_quoted_with_an_example(text: str) -> None:
    with pytest.raises(AddressError) as error:
        parse_address(text)
    assert repr(text) in str(error.value)
    assert "udpout:127.0.0.1:14550" in str(error.value)


def test_address_of_another_machine_cannot_be_bound() -> None:
    with pytest.raises(AddressError, match=r"cannot use udpin:192\.0\.2\.1:0"):
        open_socket(Address("udpin", "192.0.2.1", 0))


@pytest.fixture
def waiting() -> Iterator[PlainLink]:
    link = PlainLink(Address("udpin", "127.0.0.1", 0), Connection(1))
    with link:
        yield link


def peer_of(link: PlainLink) -> socket.socket:
    peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    peer.settimeout(5.0)
    peer.connect(("127.0.0.1", link.port))
    return peer


def put_and_flush(link: PlainLink, count: int = 1) -> None:
    for _ in range(count):
        link.connection.put(message("SYSTEM_TIME")(time_unix_usec=1, time_boot_ms=1))
    link.flush()


def received(link: PlainLink) -> list[object]:
    select.select([link.socket], [], [], 5.0)
    return list(link.receive())


def test_waiting_link_answers_everyone_who_spoke_one_frame_per_datagram(waiting: PlainLink) -> None:
    with peer_of(waiting) as one, peer_of(waiting) as other, peer_of(waiting) as silent:
        for peer in (one, other):
            peer.send(HEARTBEAT + HEARTBEAT)
            assert len(received(waiting)) == 2
        put_and_flush(waiting, 2)
        for peer in (one, other):
            for seq in (0, 1):
                (told,) = mav.MAVLink(None).parse_buffer(peer.recv(2000))
                assert told.get_seq() == seq
        silent.setblocking(False)
        with pytest.raises(BlockingIOError):
            silent.recv(1)


def test_waiting_link_answers_mavlink_1_so_that_the_other_side_changes(waiting: PlainLink) -> None:
    old = bytes(mav.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3).pack(mav.MAVLink(None, 255, 190), force_mavlink1=True))
    with peer_of(waiting) as peer:
        peer.send(old)
        assert received(waiting) == []
        put_and_flush(waiting)
        assert peer.recv(2000)[0] == 0xFD


@pytest.mark.parametrize(
    "garbage", [b"garbage", b"\xfd", b"\xfe", b"\xfd" * 300, HEARTBEAT[:-1], b"\xfe" + HEARTBEAT[1:]]
)
def test_waiting_link_does_not_answer_garbage(waiting: PlainLink, garbage: bytes) -> None:
    with peer_of(waiting) as peer:
        peer.send(garbage)
        assert received(waiting) == []
        put_and_flush(waiting)
        peer.setblocking(False)
        with pytest.raises(BlockingIOError):
            peer.recv(1)


def test_strangers_do_not_push_out_who_is_there_and_free_their_places_by_silence() -> None:
    now_s = 0.0
    made = PlainLink(Address("udpin", "127.0.0.1", 0), Connection(1), lambda: now_s)
    peers = [peer_of(made) for _ in range(MOST_PEERS + 1)]
    station, late = peers[0], peers[-1]
    try:
        for peer in peers:
            peer.send(HEARTBEAT)
            assert len(received(made)) == 1
        put_and_flush(made)
        late.setblocking(False)
        with pytest.raises(BlockingIOError):
            late.recv(1)
        assert all(peer.recv(2000) for peer in peers[:-1])
        now_s = PEER_SILENT_S
        for peer in (station, late):
            peer.send(HEARTBEAT)
            assert len(received(made)) == 1
        put_and_flush(made)
        late.setblocking(True)
        assert station.recv(2000)
        assert late.recv(2000)
        peers[1].setblocking(False)
        with pytest.raises(BlockingIOError):
            peers[1].recv(1)
    finally:
        made.socket.close()
        for peer in peers:
            peer.close()


def test_a_forged_heartbeat_sends_as_many_bytes_as_the_threat_model_says_and_no_more(vehicle_bench: Any) -> None:
    """The vehicle flies; a single HEARTBEAT, then a minute of silence."""
    said = re.search(r"answer a HEARTBEAT .* telemetry to that address, (\d+) bytes for each", THREAT_MODEL.read_text())
    assert said is not None
    bench, now_s, got = vehicle_bench().in_air(), 0.0, 0
    with PlainLink(Address("udpin", "127.0.0.1", 0), bench.connection, lambda: now_s) as made, peer_of(made) as victim:
        victim.setblocking(False)
        victim.send(HEARTBEAT)
        assert len(received(made)) == 1
        for tick in range(600):
            bench.vehicle.advance(bench.vehicle.time_ms + 100)
            bench.services.report()
            made.flush()
            now_s = 0.1 * (tick + 1)
            with contextlib.suppress(BlockingIOError):
                while data := victim.recv(2000):
                    got += len(data)
    assert got / len(HEARTBEAT) == pytest.approx(int(said[1]), rel=0.05)


def test_a_link_takes_in_a_bounded_number_of_datagrams_at_once(
    waiting: PlainLink, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(link, "MOST_AT_ONCE", 16)  # the kernel's queue is too short for more
    with peer_of(waiting) as flood:
        for _ in range(20):
            flood.send(b"x")
        flood.send(HEARTBEAT)
        assert received(waiting) == []
        assert len(received(waiting)) == 1


def test_nobody_there_is_no_error() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        port = other.getsockname()[1]
    plain = PlainLink(Address("udpout", "127.0.0.1", port), Connection(1))
    supervised = SupervisedLink(Address("udpout", "127.0.0.1", port))
    with plain, supervised:
        for _ in range(3):
            put_and_flush(plain, 3)
            supervised.send([b"x", b"y"])
            assert plain.receive() == []
            assert not supervised.waiting


def test_supervised_link_hears_its_supervisor_only() -> None:
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as supervisor,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger,
    ):
        supervisor.bind(("127.0.0.1", 0))
        link = SupervisedLink(Address("udpout", *supervisor.getsockname()))
        with link:
            own = link.socket.getsockname()
            stranger.sendto(b"stranger", own)
            supervisor.sendto(b"supervisor", own)
            select.select([link.socket], [], [], 5.0)
            assert link.receive() == b"supervisor"
            assert not link.waiting


def test_grants_are_received_whole_whether_looked_for_or_slept_for() -> None:
    """The first wait is slept through, the next ones, after short waits, are looked through; none comes in time."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as supervisor:
        supervisor.bind(("127.0.0.1", 0))
        with SupervisedLink(parse_address(f"udpout:127.0.0.1:{supervisor.getsockname()[1]}")) as link:
            link.wait_in_receive(0.05)
            reader = GrantReader(link)
            for size in (1, 1400, SUPERVISED_BYTES):
                supervisor.sendto(b"\x2a" * size, link.socket.getsockname())
                assert reader.receive() == b"\x2a" * size
                assert reader.last_ns < 50_000_000
            assert reader.receive() == b""
            assert reader.last_ns >= 50_000_000


def test_frames_are_packed_in_order_and_within_the_limit() -> None:
    frames = [bytes([i % 256]) * (20 + 37 * i % 261) for i in range(200)]
    datagrams = pack(frames)
    assert b"".join(datagrams) == b"".join(frames)
    assert max(map(len, datagrams)) <= DATAGRAM_BYTES
    ends = {sum(map(len, frames[:i])) for i in range(201)}
    at = 0
    for datagram in datagrams[:-1]:
        at += len(datagram)
        assert at in ends  # no frame is cut
        assert min(end for end in ends if end > at) - at + len(datagram) > DATAGRAM_BYTES  # the next had no room
    assert pack([]) == []
