"""Forwarding to stations that are there, that are not, and that do not read."""

import contextlib
import select
import socket

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.link import forwarder
from gcs.link.forwarder import MOST_STATIONS, Forwarder

SENDER = mav.MAVLink(None, srcSystem=245, srcComponent=190)
HEARTBEAT = bytes(mav.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3).pack(SENDER))


def station() -> socket.socket:
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    made.bind(("127.0.0.1", 0))
    made.settimeout(5.0)
    return made


def test_everyone_who_listens_or_has_asked_gets_each_frame_as_it_is() -> None:
    with station() as one, station() as asks, socket.create_server(("127.0.0.1", 0)) as server:
        out = Forwarder([
            f"udpout:127.0.0.1:{one.getsockname()[1]}", "udpin:127.0.0.1:0", f"tcp:127.0.0.1:{server.getsockname()[1]}",
            "udpout:127.0.0.1:9", "tcp:127.0.0.1:9",
        ])  # fmt: skip
        port = int(out.addresses[1].rpartition(":")[2])
        peer, _ = server.accept()
        asks.sendto(b"no MAVLink", ("127.0.0.1", port))
        assert select.select([out._channels[1]], [], [], 5.0)[0]
        assert out.receive() == []
        out.send([b"one"])
        assert one.recv(100) == b"one"
        asks.sendto(HEARTBEAT, ("127.0.0.1", port))
        assert select.select([out._channels[1]], [], [], 5.0)[0]
        ((frame, by),) = out.receive()
        assert (frame.raw, by) == (HEARTBEAT, f"245/190 at {out._channels[1].at.text}")
        out.send([b"two", b"three"])
        assert [one.recv(100), one.recv(100)] == [b"two", b"three"]
        assert [asks.recv(100), asks.recv(100)] == [b"two", b"three"]  # and not the one before it had spoken
        with peer:
            assert peer.recv(11, socket.MSG_WAITALL) == b"onetwothree"
        problems = dict(out.pop_problems())
        assert list(problems) == ["tcp:127.0.0.1:9"]
        out.close()


def test_of_many_who_ask_a_few_are_answered_and_those_who_go_make_room(monkeypatch: pytest.MonkeyPatch) -> None:
    out = Forwarder(["udpin:127.0.0.1:0"])
    port = int(out.addresses[0].rpartition(":")[2])
    many = [station() for _ in range(MOST_STATIONS + 5)]
    old = bytes(mav.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3).pack(SENDER, force_mavlink1=True))
    many[0].sendto(old, ("127.0.0.1", port))  # it would go over to MAVLink 2 once it hears that
    for one in many[1:]:
        one.sendto(HEARTBEAT, ("127.0.0.1", port))
    heard = 0
    while heard < len(many) - 1:
        assert select.select([out._channels[0]], [], [], 5.0)[0]
        heard += len(out.receive())
    assert len(out._stations) == MOST_STATIONS
    assert (0, many[0].getsockname()) in out._stations
    monkeypatch.setattr(forwarder, "SILENT_S", 0.0)
    out.send([b"x"])
    assert not out._stations
    for one in many:
        one.close()
    out.close()


def test_strangers_that_fall_silent_shut_no_station_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """They hold every place with a HEARTBEAT each now and then; a station's comes every second."""
    out = Forwarder(["udpin:127.0.0.1:0"])
    port = int(out.addresses[0].rpartition(":")[2])
    with contextlib.ExitStack() as stack:
        strangers = [stack.enter_context(station()) for _ in range(MOST_STATIONS)]
        ours = stack.enter_context(station())

        def says(one: socket.socket) -> None:
            one.sendto(HEARTBEAT, ("127.0.0.1", port))
            assert select.select([out._channels[0]], [], [], 5.0)[0]
            assert len(out.receive()) == 1

        for one in strangers:
            says(one)
        says(ours)
        assert (0, ours.getsockname()) not in out._stations
        monkeypatch.setattr(forwarder, "YIELDS_S", 0.0)
        says(ours)
        assert (0, ours.getsockname()) in out._stations
        assert (0, strangers[0].getsockname()) not in out._stations
        assert len(out._stations) == MOST_STATIONS
    out.close()
