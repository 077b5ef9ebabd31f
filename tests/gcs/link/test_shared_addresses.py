"""Vehicles of one process: bundles and answers share datagrams, on real UDP
(docs/protocol/link.md#shared-addresses)."""

import socket
from collections.abc import Iterator
from typing import cast

import pytest
from lockstep_vehicle import BEAT, PING, Vehicle, collect, heartbeat, text

from gcs.link.bundles import SHARED_BYTES
from gcs.link.lockstep import DATAGRAM_BYTES, LockstepLink
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.mavlink.ids import STATION


class Sharing:
    """Vehicles behind one socket: a datagram holds the bundles of several, each behind a PING to its vehicle."""

    def __init__(self, link: LockstepLink, *sysids: int) -> None:
        self.vehicles = {sysid: Vehicle(link, sysid) for sysid in sysids}
        for vehicle in self.vehicles.values():
            vehicle.socket.close()
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setblocking(False)
        self.socket.connect(("127.0.0.1", link.port))
        self.datagrams: list[bytes] = []
        self.answers = b""
        for vehicle in self.vehicles.values():
            vehicle.socket = cast(socket.socket, self)  # what it sends is gathered here

    def send(self, datagram: bytes) -> None:
        self.answers += datagram

    def close(self) -> None:
        self.socket.close()

    def hello(self, *sysids: int, shared: int = 1) -> None:
        for sysid in sysids:
            vehicle = self.vehicles[sysid]
            stamp = {"time_unix_usec": vehicle.secret, "time_boot_ms": shared}
            self.socket.send(vehicle.frame("HEARTBEAT", 0, **BEAT) + vehicle.frame("SYSTEM_TIME", 1, **stamp))

    def pump(self) -> None:
        """Take every datagram that has come, and answer all of it at once."""
        while True:
            try:
                datagram = self.socket.recv(65535)
            except BlockingIOError:
                break
            self.datagrams.append(datagram)
            bundle: list[Frame] = []
            for frame in reversed(codec.split(datagram).frames):
                if (frame.msgid, frame.sysid) == (PING, STATION[0]):
                    self.vehicles[codec.fields(frame).target_system].take(bundle[::-1])
                    bundle = []
                else:
                    bundle.append(frame)
            assert not bundle, "frames before the first PING"
        if self.answers:
            self.socket.send(self.answers)
        self.answers = b""


@pytest.fixture
def link() -> Iterator[LockstepLink]:
    made = LockstepLink()
    made.expect([(1, 1), (2, 1)])
    yield made
    made.close()


@pytest.fixture
def shared(link: LockstepLink) -> Iterator[Sharing]:
    made = Sharing(link, 1, 2)
    made.hello(1, 2)
    while len(link.joined) < 2:
        link.listen(1.0)
    yield made
    made.close()


def test_vehicles_of_one_address_get_one_datagram_and_answer_in_one(link: LockstepLink, shared: Sharing) -> None:
    for tick in range(300):  # past 255
        frames = {key: link.grant(key, 100 * tick, 7, [heartbeat()], []) for key in sorted(link.joined)}
        assert not shared.answers
        link.flush()
        shared.pump()
        got = collect(link, pytest.fail)
        assert sorted(got) == [(1, 1), (2, 1)]
        for (sysid, _), answered in got.items():
            assert {frame.sysid for frame in answered} == {sysid}
            assert codec.fields(answered[-1]).time_boot_ms == 100 * tick
        recorded = b"".join(raw for key in sorted(frames) for raw in frames[key])
        unmarked = [frame.raw for frame in codec.split(shared.datagrams[-1]).frames if frame.msgid != PING]
        assert b"".join(unmarked) == recorded, "the marks are nobody's frames and are not recorded"
    assert len(shared.datagrams) == 300


def test_only_the_missing_one_of_an_address_is_sent_its_bundle_again(link: LockstepLink, shared: Sharing) -> None:
    for key in sorted(link.joined):
        link.grant(key, 0, 7, [], [])
    link.flush()
    silent = shared.vehicles[2]

    takes = silent.take

    def misses(_: list[Frame]) -> None:
        silent.take = takes  # type: ignore[method-assign]

    silent.take = misses  # type: ignore[method-assign]
    shared.pump()
    assert sorted(collect(link, shared.pump)) == [(1, 1), (2, 1)]
    assert len(shared.datagrams) == 2
    first, again = (codec.split(datagram).frames for datagram in shared.datagrams)
    assert [codec.fields(f).target_system for f in first if f.msgid == PING] == [1, 2]
    assert [codec.fields(f).target_system for f in again if f.msgid == PING] == [2]


def test_bundles_for_an_address_leave_before_the_last_is_made_once_there_is_enough(link: LockstepLink) -> None:
    link.expect([(sysid, 1) for sysid in range(1, 255)])
    many = Sharing(link, *range(1, 255))
    try:
        for sysid in many.vehicles:
            many.hello(sysid)
        while len(link.joined) < 254:
            link.listen(1.0)
        for key in sorted(link.joined):
            link.grant(key, 0, 7, [text(0)], [])
        link.flush()
        many.pump()
        assert len(collect(link, pytest.fail)) == 254
        assert 3 < len(many.datagrams) < 15
        assert max(map(len, many.datagrams)) < SHARED_BYTES + DATAGRAM_BYTES
    finally:
        many.close()


def test_who_does_not_share_its_address_lets_nobody_in_behind_it(link: LockstepLink) -> None:
    made = Sharing(link, 1, 2)
    try:
        made.hello(1, shared=0)
        while not link.joined:
            link.listen(1.0)
        made.hello(2, shared=0)
        link.listen(0.2)
        assert link.joined == {(1, 1)}
    finally:
        made.close()
