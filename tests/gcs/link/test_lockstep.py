"""The supervised link on real loopback UDP; the test drives both ends by hand, by the rules of
docs/protocol/link.md#vehicle-side-of-the-link."""

import random
import socket
from collections.abc import Iterator
from typing import Any

import pytest
from lockstep_vehicle import BEAT, Vehicle, collect, heartbeat, text

from gcs.link import lockstep
from gcs.link.lockstep import DATAGRAM_BYTES, LockstepLink
from gcs.mavlink import codec


@pytest.fixture(params=[False, True])
def link(request: pytest.FixtureRequest) -> Iterator[LockstepLink]:
    made = LockstepLink(unpaced=request.param)
    made.expect([(1, 1), (2, 1)])
    yield made
    made.close()


@pytest.fixture
def made_vehicles() -> Iterator[list[Vehicle]]:
    made: list[Vehicle] = []
    yield made
    for vehicle in made:
        vehicle.socket.close()


def join(link: LockstepLink, made: list[Vehicle], *sysids: int, **how: Any) -> list[Vehicle]:
    for sysid in sysids:
        made.append(Vehicle(link, sysid, **how))
        made[-1].hello()
    while not {(sysid, 1) for sysid in sysids} <= link.joined:
        link.listen(1.0)
    return made


def test_a_hello_of_an_expected_vehicle_joins_and_nothing_else(
    link: LockstepLink, made_vehicles: list[Vehicle]
) -> None:
    assert link.listen(0.0) == {(1, 1), (2, 1)}
    one, stranger = Vehicle(link, 1), Vehicle(link, 9)
    made_vehicles += [one, stranger]
    stranger.hello()
    one.socket.send(one.frame("HEARTBEAT", 0, **BEAT))
    one.socket.send(b"\x00garbage that is no MAVLink")
    join(link, made_vehicles, 2)
    assert link.listen(0.0) == {(1, 1)}
    assert link.joined == {(2, 1)}
    assert link.malformed == 0  # strangers' bytes are not counted: they are not read


def test_who_has_not_the_sessions_secret_never_owns_a_link_even_if_it_is_first(
    link: LockstepLink, made_vehicles: list[Vehicle]
) -> None:
    thief = Vehicle(link, 1)
    made_vehicles.append(thief)
    for secret in (0, link.secret ^ 1, (1 << 64) - 1):
        thief.secret = secret
        thief.hello()
    link.listen(0.0)
    assert link.joined == set()
    assert link.refused == {(1, 1): thief.socket.getsockname()}
    one = join(link, made_vehicles, 1)[-1]
    assert link.joined == {(1, 1)}
    link.grant((1, 1), 0, 7, [heartbeat()], [])
    one.pump()
    assert [frame.seq for frame in collect(link, lambda: None)[1, 1]] == [2, 3, 4]


def test_secrets_are_not_guessed_and_not_the_same_twice() -> None:
    links = [LockstepLink() for _ in range(8)]
    secrets = {link.secret for link in links}
    for link in links:
        link.close()
    assert len(secrets) == 8
    assert max(secret.bit_length() for secret in secrets) > 56


def test_a_second_address_of_the_same_vehicle_is_a_rival(link: LockstepLink, made_vehicles: list[Vehicle]) -> None:
    (one,) = join(link, made_vehicles, 1)
    foreign = Vehicle(link, 1)
    for _ in range(2):
        foreign.hello()
    join(link, made_vehicles, 2)
    assert link.rivals == {(1, 1): foreign.socket.getsockname()}
    assert link.refused == {}
    link.grant((1, 1), 0, 7, [heartbeat()], [])
    one.pump()
    foreign.socket.send(one.last)
    assert [frame.seq for frame in collect(link, lambda: None)[1, 1]] == [2, 3, 4]
    foreign.socket.close()


def test_a_bundle_ends_with_the_grant_and_relayed_frames_stand_uncounted_before_it(
    link: LockstepLink, made_vehicles: list[Vehicle]
) -> None:
    (one,) = join(link, made_vehicles, 1)
    relayed = codec.encode("HEARTBEAT", 77, 201, 1, **BEAT)
    frames = link.grant((1, 1), 0, 1234, [heartbeat()], [relayed])
    one.pump()
    assert b"".join(frames) == one.bundles[0]
    read = codec.split(one.bundles[0]).frames
    assert [(f.sysid, f.compid, f.seq) for f in read] == [(255, 190, 0), (201, 1, 77), (255, 190, 1)]
    assert read[1].raw == relayed
    assert codec.fields(read[-1]) == (1234, 0)
    collect(link, lambda: None)
    link.grant((1, 1), 100, 1234, [heartbeat()], [])
    one.pump()
    assert [frame.seq for frame in codec.split(one.bundles[1]).frames] == [2, 3]


def test_what_does_not_fit_into_1400_bytes_waits_for_the_next_bundle_in_order(
    link: LockstepLink, made_vehicles: list[Vehicle]
) -> None:
    (one,) = join(link, made_vehicles, 1)
    for tick in range(6):
        link.grant((1, 1), 100 * tick, 0, [text(k) for k in range(60)] if tick == 0 else [], [])
        one.pump()
        collect(link, lambda: None)
    sizes = [len(bundle) for bundle in one.bundles]
    assert max(sizes) <= DATAGRAM_BYTES
    assert sizes[0] > 1000
    texts = [codec.fields(frame).text for frame in one.heard if frame.msgid == codec.msgid("STATUSTEXT")]
    assert [int(t[:4]) for t in texts] == list(range(60))


def test_what_peers_have_broadcast_goes_out_at_once_beside_what_waits(
    link: LockstepLink, made_vehicles: list[Vehicle]
) -> None:
    (one,) = join(link, made_vehicles, 1)
    air = b"".join(codec.encode("HEARTBEAT", seq, 201, 1, **BEAT) for seq in range(200))
    for tick in range(6):
        link.grant((1, 1), 100 * tick, 0, [text(k) for k in range(60)] if tick == 0 else [], [], air)
        one.pump()
        collect(link, lambda: None)
    assert [bundle.count(air) for bundle in one.bundles] == [1] * 6
    assert max(len(bundle) for bundle in one.bundles) <= DATAGRAM_BYTES + len(air)
    texts = [codec.fields(frame).text for frame in one.heard if frame.msgid == codec.msgid("STATUSTEXT")]
    assert [int(t[:4]) for t in texts] == list(range(60))


def test_who_leaves_in_mid_tick_is_not_waited_for_and_the_others_go_on(
    link: LockstepLink, made_vehicles: list[Vehicle]
) -> None:
    _, two = join(link, made_vehicles, 1, 2)
    for key in ((1, 1), (2, 1)):
        link.grant(key, 0, 7, [], [])
    two.pump()
    assert list(collect(link, lambda: link.leave((1, 1)))) == [(2, 1)]
    assert link.joined == {(2, 1)}
    link.grant((2, 1), 100, 7, [], [])
    two.pump()
    assert list(collect(link, lambda: None)) == [(2, 1)]
    link.leave((2, 1))
    assert collect(link, lambda: None) == {}


def test_garbage_between_the_answers_is_counted_and_harms_nothing(
    link: LockstepLink, made_vehicles: list[Vehicle]
) -> None:
    (one,) = join(link, made_vehicles, 1)
    link.grant((1, 1), 0, 0, [], [])
    one.socket.send(b"\xfd\x09\x00")
    one.socket.send(random.Random(1).randbytes(300))
    one.pump()
    assert len(collect(link, lambda: None)[1, 1]) == 3
    assert link.malformed == 2


def test_a_flood_of_strangers_is_not_read_and_does_not_keep_a_tick_from_ending(
    link: LockstepLink, made_vehicles: list[Vehicle], monkeypatch: pytest.MonkeyPatch
) -> None:
    (one,) = join(link, made_vehicles, 1)
    read: list[int] = []
    for module, name in ((codec, "split"), (lockstep, "runs_of")):
        reader = getattr(module, name)
        monkeypatch.setattr(
            module, name, lambda datagram, reader=reader: read.append(len(datagram)) or reader(datagram)
        )
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as flood:
        flood.connect(("127.0.0.1", link.port))
        for tick in range(3):
            link.grant((1, 1), 100 * tick, 0, [], [])
            for _ in range(40):
                flood.send(b"\xfd" * 65507)
            one.pump()
            read.clear()
            assert len(collect(link, lambda: None)[1, 1]) == 3
            assert max(read, default=0) < DATAGRAM_BYTES


def test_no_more_than_a_bounded_number_of_datagrams_is_taken_before_others_have_their_turn(
    link: LockstepLink, made_vehicles: list[Vehicle], monkeypatch: pytest.MonkeyPatch
) -> None:
    (one,) = join(link, made_vehicles, 1)
    monkeypatch.setattr(lockstep, "MOST_AT_ONCE", 10)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as flood:
        flood.connect(("127.0.0.1", link.port))
        for _ in range(5):
            flood.send(b"")  # short and long ones end the taking differently
            flood.send(b"x" * 200)
        one.hello()
        link.expect([(2, 1)])
        two = Vehicle(link, 2)
        made_vehicles.append(two)
        two.hello()
        link.listen(0.0)
        assert link.joined == {(1, 1)}
        link.listen(0.0)
        assert link.joined == {(1, 1), (2, 1)}


def test_a_pause_repeats_the_last_bundle_and_the_answers_to_it_are_no_new_tick(
    link: LockstepLink, made_vehicles: list[Vehicle]
) -> None:
    (one,) = join(link, made_vehicles, 1)
    for tick in range(3):
        link.grant((1, 1), 100 * tick, 0, [], [])
        one.pump()
        assert len(collect(link, lambda: None)[1, 1]) == 3
        link.repeat()
        one.pump()
    assert [codec.fields(codec.split(b).frames[-1]).time_boot_ms for b in one.bundles] == [0, 0, 100, 100, 200, 200]


def flown(drop: float) -> tuple[list[bytes], int]:
    link = LockstepLink(drop=drop, seed=5)
    link.expect([(1, 1), (2, 1)])
    vehicles = [Vehicle(link, sysid, drop=drop) for sysid in (1, 2)]
    while len(link.joined) < 2:
        for vehicle in vehicles:
            vehicle.hello()
        link.listen(0.05)
    frames = []

    def pump() -> None:
        for vehicle in vehicles:
            vehicle.pump()

    for tick in range(40):
        for vehicle in vehicles:
            link.grant((vehicle.sysid, 1), 100 * tick, 7, [text(tick)], [])
        pump()
        for answer in collect(link, pump).values():
            frames += [frame.raw for frame in answer]
    frames += [frame.raw for vehicle in vehicles for frame in vehicle.heard]
    for vehicle in vehicles:
        vehicle.socket.close()
    link.close()
    return frames, link.resent


def test_lost_datagrams_are_sent_again_and_nothing_is_different() -> None:
    whole, none = flown(0.0)
    lossy, some = flown(0.1)
    assert whole == lossy
    assert (none, some > 5) == (0, True)


def test_kernel_drops_are_read_from_the_kernel(link: LockstepLink) -> None:
    assert link.overflowed() == 0
    link._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        for _ in range(200):
            sender.sendto(b"x" * 500, ("127.0.0.1", link.port))
    assert 100 < link.overflowed() < 200
