"""The supervised link on real loopback UDP; the test drives both ends by hand, by the rules of
docs/protocol.md#vehicle-side-of-the-link."""

import random
import socket
from collections.abc import Callable, Iterator
from typing import Any, cast

import pytest

from gcs.link.link import Key
from gcs.link.lockstep import DATAGRAM_BYTES, MOST_AT_ONCE, SHARED_BYTES, LockstepLink
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.ids import STATION

SYSTEM_TIME, HEARTBEAT, PING = map(codec.msgid, ("SYSTEM_TIME", "HEARTBEAT", "PING"))
BEAT = {"type": 2, "autopilot": 12, "base_mode": 0, "custom_mode": 0, "system_status": 3}


def collect(link: LockstepLink, idle: Callable[[], None]) -> dict[Key, list[Frame]]:
    """Every vehicle's answer to the last grant, in order of (system, component)."""
    return dict(sorted(link.answers(idle)))


def heartbeat() -> Message:
    return codec.message("HEARTBEAT", **BEAT)


def text(k: int) -> Message:
    return codec.message("STATUSTEXT", severity=6, text=f"{k:04d}".ljust(50, "x"))


class Vehicle:
    """Answers a grant once every number since the last one is there, and repeats the same bytes when asked again."""

    def __init__(self, link: LockstepLink, sysid: int = 1, extra: int = 2, drop: float = 0.0) -> None:
        self.sysid = sysid
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setblocking(False)
        self.socket.connect(("127.0.0.1", link.port))
        self.secret = link.secret
        self.t_ms = -1
        self.seq, self.expected, self.extra = 2, 0, extra
        self.bundles: list[bytes] = []
        self.heard: list[Frame] = []
        self.last = b""
        self.split_at = 0
        self._random, self._drop = random.Random(sysid), drop

    def frame(self, name: str, seq: int, **values: Any) -> bytes:
        return codec.encode(name, seq, self.sysid, 1, **values)

    def hello(self) -> None:
        stamp = {"time_unix_usec": self.secret, "time_boot_ms": 0}
        self.socket.send(self.frame("HEARTBEAT", 0, **BEAT) + self.frame("SYSTEM_TIME", 1, **stamp))

    def pump(self) -> None:
        """Take every datagram that has come, and answer."""
        while True:
            try:
                bundle = self.socket.recv(65535)
            except BlockingIOError:
                return
            self.bundles.append(bundle)
            self.take(codec.split(bundle).frames)

    def take(self, frames: list[Frame]) -> None:
        granted_ms = codec.fields(frames[-1]).time_boot_ms
        if granted_ms == self.t_ms:
            self.send()
            return
        own = [frame for frame in frames if (frame.sysid, frame.compid) == STATION]
        assert [frame.seq for frame in own] == [(self.expected + k) % 256 for k in range(len(own))]
        self.expected = (self.expected + len(own)) % 256
        self.heard += frames
        self.t_ms = granted_ms
        told = [self.frame("HEARTBEAT", 0, **BEAT) for _ in range(self.extra)]
        told.append(self.frame("SYSTEM_TIME", 0, time_unix_usec=0, time_boot_ms=granted_ms))
        numbered = []
        for raw in told:
            message = codec.split(raw).frames[0]
            numbered.append(codec.frame(Message(message.msgid, tuple(codec.fields(message))), self.seq, self.sysid, 1))
            self.seq = (self.seq + 1) % 256
        self.last = b"".join(numbered)
        self.split_at = len(b"".join(numbered[:-1])) if self.split_at else 0
        self.send()

    def send(self) -> None:
        for part in (self.last[: self.split_at], self.last[self.split_at :]):
            if part and self._random.random() >= self._drop:
                self.socket.send(part)


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


def test_a_hello_of_an_expected_vehicle_joins(link: LockstepLink, made_vehicles: list[Vehicle]) -> None:
    assert link.listen(0.0) == {(1, 1), (2, 1)}
    stranger = Vehicle(link, 9)
    stranger.hello()
    join(link, made_vehicles, 1)
    assert link.listen(0.0) == {(2, 1)}
    assert link.joined == {(1, 1)}
    stranger.socket.close()


def test_what_is_no_hello_does_not_join(link: LockstepLink, made_vehicles: list[Vehicle]) -> None:
    one = Vehicle(link, 1)
    made_vehicles.append(one)
    one.socket.send(one.frame("HEARTBEAT", 0, **BEAT))
    one.socket.send(b"\x00garbage that is no MAVLink")
    join(link, made_vehicles, 2)
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


def test_answers_come_back_in_order_of_system_id_and_end_with_the_time(
    link: LockstepLink, made_vehicles: list[Vehicle]
) -> None:
    two, one = join(link, made_vehicles, 2, 1)
    for tick in range(120):  # numbers wrap
        for key in ((1, 1), (2, 1)):
            link.grant(key, 100 * tick, 7, [heartbeat(), heartbeat()], [])
        two.pump()
        one.pump()
        answers = collect(link, lambda: None)
        assert list(answers) == [(1, 1), (2, 1)]
        for frames in answers.values():
            assert [frame.msgid for frame in frames] == [HEARTBEAT, HEARTBEAT, SYSTEM_TIME]
            assert frames[0].seq == (2 + 3 * tick) % 256
    assert link.resent == 0


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


def test_the_largest_frames_still_fit(link: LockstepLink, made_vehicles: list[Vehicle]) -> None:
    (one,) = join(link, made_vehicles, 1)
    largest = codec.message("FILE_TRANSFER_PROTOCOL", target_network=0, target_system=1, target_component=1,
                            payload=[255] * 251)  # fmt: skip
    for tick in range(8):
        link.grant((1, 1), 100 * tick, 0, [heartbeat(), *[largest] * 10] if tick == 0 else [], [])
        one.pump()
        collect(link, lambda: None)
    assert max(map(len, one.bundles)) <= DATAGRAM_BYTES
    assert sum(len(codec.split(bundle).frames) for bundle in one.bundles) == 8 + 11


def test_after_silence_the_same_bytes_go_out_again_to_the_missing_one_only(
    link: LockstepLink, made_vehicles: list[Vehicle]
) -> None:
    one, two = join(link, made_vehicles, 1, 2)
    for key in ((1, 1), (2, 1)):
        link.grant(key, 0, 7, [heartbeat()], [])
    two.pump()
    silences = 0

    def idle() -> None:
        nonlocal silences
        silences += 1
        if silences == 3:
            one.pump()

    assert set(collect(link, idle)) == {(1, 1), (2, 1)}
    two.pump()
    one.pump()
    assert link.resent >= 2
    assert len(one.bundles) >= 3
    assert len(set(one.bundles)) == len(two.bundles) == 1


def test_an_answer_in_two_datagrams_is_one_tick(link: LockstepLink, made_vehicles: list[Vehicle]) -> None:
    (one,) = join(link, made_vehicles, 1)
    one.split_at = 1
    link.grant((1, 1), 0, 0, [], [])
    one.pump()
    assert len(collect(link, lambda: None)[1, 1]) == 3


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
    split = codec.split
    monkeypatch.setattr(codec, "split", lambda datagram: read.append(len(datagram)) or split(datagram))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as flood:
        flood.connect(("127.0.0.1", link.port))
        for tick in range(3):
            link.grant((1, 1), 100 * tick, 0, [], [])
            for _ in range(40):
                flood.send(b"\xfd" * 65507)
            one.pump()
            read.clear()
            assert len(collect(link, lambda: None)[1, 1]) == 3
            assert max(read) < DATAGRAM_BYTES


def test_no_more_than_a_bounded_number_of_datagrams_is_taken_before_others_have_their_turn(link: LockstepLink) -> None:
    class Endless:
        taken = 0

        def recvfrom(self, size: int) -> tuple[bytes, tuple[str, int]]:
            self.taken += 1
            return b"\xfd" * size, ("127.0.0.1", 9)

    endless = Endless()
    real, link._socket = link._socket, endless  # type: ignore[assignment]
    try:
        link._drain()
    finally:
        link._socket = real
    assert endless.taken == MOST_AT_ONCE


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


# vehicles that share an address


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


def test_who_leaves_a_shared_address_does_not_take_the_others_with_it(link: LockstepLink, shared: Sharing) -> None:
    link.leave((1, 1))
    link.grant((2, 1), 0, 7, [], [])
    link.flush()
    shared.pump()
    assert sorted(collect(link, pytest.fail)) == [(2, 1)]
    link.leave((2, 1))
    assert not link.joined


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
