"""The vehicle's side of the supervised link, fed with bundles that pymavlink made."""

from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink.codec import message, split
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.lockstep import Bundle, Grants, bundles

EPOCH_US = 1_700_000_000_000_000


class Supervisor:
    """Numbers frames in bundle order, as docs/protocol/link.md#bundle asks."""

    def __init__(self, system: int = 255, component: int = 190) -> None:
        self.mav = mav.MAVLink(None, system, component)

    def frame(self, content: Any) -> bytes:
        raw = bytes(content.pack(self.mav))
        self.mav.seq = (self.mav.seq + 1) % 256
        return raw

    def heartbeat(self) -> bytes:
        return self.frame(mav.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3))

    def grant(self, time_ms: int) -> bytes:
        return self.frame(mav.MAVLink_system_time_message(EPOCH_US + 1000 * time_ms, time_ms))


@pytest.fixture
def grants() -> Grants:
    made = Grants(Connection(1))
    made.hello(message("HEARTBEAT")(6, 2, 12, 0, 4, 3))
    return made


@pytest.fixture
def supervisor() -> Supervisor:
    return Supervisor()


def fed(grants: Grants, datagram: bytes) -> Bundle | list[bytes] | None:
    return grants.feed(split(datagram))


def taken(grants: Grants, datagram: bytes) -> Bundle:
    bundle = fed(grants, datagram)
    assert isinstance(bundle, Bundle)
    return bundle


def relayed(sysid: int = 9, seq: int = 77) -> bytes:
    other = mav.MAVLink(None, sysid, 1)
    other.seq = seq
    return bytes(mav.MAVLink_named_value_int_message(0, b"XferOut", 5).pack(other))


def read(datagrams: list[bytes]) -> list[Any]:
    return [m for d in datagrams for m in mav.MAVLink(None).parse_buffer(d)]


def test_hello_is_heartbeat_0_and_system_time_1() -> None:
    hello = Grants(Connection(7)).hello(message("HEARTBEAT")(6, 2, 12, 0, 4, 3))
    said = [(m.get_type(), m.get_seq(), m.get_srcSystem()) for m in read([hello])]
    assert said == [("HEARTBEAT", 0, 7), ("SYSTEM_TIME", 1, 7)]


def test_missing_number_waits_until_the_whole_bundle_comes(grants: Grants, supervisor: Supervisor) -> None:
    grants.answer(taken(grants, supervisor.grant(0)))
    frames = [supervisor.heartbeat() for _ in range(3)] + [supervisor.grant(100)]
    for gone in range(3):
        assert fed(grants, b"".join(f for i, f in enumerate(frames) if i != gone)) is None
    assert fed(grants, frames[0] + frames[2] + frames[1] + frames[3]) is None
    broken = bytearray(frames[1])
    broken[12] ^= 1
    assert fed(grants, frames[0] + bytes(broken) + frames[2] + frames[3]) is None
    assert grants.time_ms == 0
    assert taken(grants, b"".join(frames)).time_ms == 100


def test_bundle_after_a_lost_one_waits(grants: Grants, supervisor: Supervisor) -> None:
    first = supervisor.grant(0)
    second = supervisor.grant(100)
    assert fed(grants, second) is None
    assert taken(grants, first).time_ms == 0
    assert taken(grants, second).time_ms == 100


@pytest.mark.parametrize("ids", [(254, 190), (255, 191), (255, 1), (1, 1)])
def test_grant_of_anybody_else_is_ignored(grants: Grants, ids: tuple[int, int]) -> None:
    assert fed(grants, Supervisor(*ids).grant(100)) is None
    assert grants.time_ms == -1


def test_bundle_without_its_grant_at_the_end_is_ignored(grants: Grants, supervisor: Supervisor) -> None:
    heartbeat, grant = supervisor.heartbeat(), supervisor.grant(0)
    assert fed(grants, heartbeat) is None
    assert fed(grants, heartbeat + grant + relayed()) is None
    assert taken(grants, heartbeat + grant).time_ms == 0


@pytest.mark.parametrize("count", [5, 60, 126, 127, 300])
def test_long_answer_is_split_numbered_through_and_closed_by_the_time(count: int, supervisor: Supervisor) -> None:
    connection = Connection(1)
    grants = Grants(connection)
    grants.hello(message("HEARTBEAT")(6, 2, 12, 0, 4, 3))
    told: list[int] = []
    seqs: list[int] = []
    ticks = 0
    for number in range(count):
        connection.put(message("STATUSTEXT")(severity=6, text=f"{number:03}".ljust(50, "x"), id=0, chunk_seq=0))
    while len(told) < count:
        datagrams = grants.answer(taken(grants, supervisor.grant(100 * ticks)))
        ticks += 1
        assert all(len(d) <= 1400 for d in datagrams)
        messages = read(datagrams)
        assert len(messages) <= 127
        assert [m.get_type() == "SYSTEM_TIME" for m in messages] == [False] * (len(messages) - 1) + [True]
        told += [int(m.text[:3]) for m in messages[:-1]]
        seqs += [m.get_seq() for m in messages]
    assert told == list(range(count))
    assert seqs == [(2 + i) % 256 for i in range(len(seqs))]
    assert ticks == -(-count // 126)


# a socket that several vehicles share


def marker(sysid: int) -> bytes:
    return bytes(mav.MAVLink_ping_message(0, 0, sysid, 1).pack(mav.MAVLink(None, 255, 190)))


def test_who_shares_a_socket_says_so_in_its_hello() -> None:
    (_, time) = read([Grants(Connection(7)).hello(message("HEARTBEAT")(6, 2, 12, 0, 4, 3), 5, shared=True)])
    assert (time.time_unix_usec, time.time_boot_ms) == (5, 1)


def test_bundles_of_a_datagram_are_told_apart_by_the_ping_before_each() -> None:
    """Relayed frames, another one's PING among them, belong to the bundle in which they stand."""
    other = mav.MAVLink(None, 9, 1)
    foreign = bytes(mav.MAVLink_ping_message(0, 0, 255, 190).pack(other))
    to_3, to_4 = Supervisor(), Supervisor()
    first, second = to_3.heartbeat() + to_3.grant(100), foreign + to_4.grant(100)
    found = dict(bundles(marker(3) + first + marker(4) + second))
    assert {sysid: b"".join(frame.raw for frame in frames) for sysid, frames in found.items()} == {3: first, 4: second}


def test_what_stands_before_the_first_ping_is_nobodys() -> None:
    assert [sysid for sysid, _ in bundles(Supervisor().grant(100) + marker(3))] == [0]
