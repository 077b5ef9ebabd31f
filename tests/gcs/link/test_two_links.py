"""A vehicle with two links, over real sockets on the loopback; its bytes are pymavlink's."""

import socket
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from patience import PATIENCE_S
from ports import free_port
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.link.external import ExternalLink
from gcs.link.external_peer import ExternalPeer, PeerLink
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.mavlink.gaps import GapCounter
from gcs.scenario.external import External

KEY = (1, 1)
PING_ALL = codec.message("PING", time_usec=7, seq=1, target_system=0, target_component=0)


class Port:
    """One of a vehicle's ports, with sequence numbers of its own unless it shares those of another."""

    def __init__(self, to: int, numbers: "Port | None" = None) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect(("127.0.0.1", to))
        self.socket.setblocking(False)
        self.mav = mav.MAVLink(None, srcSystem=1, srcComponent=1) if numbers is None else numbers.mav

    def heartbeat(self) -> bytes:
        return self.packed(mav.MAVLink_heartbeat_message(2, mav.MAV_AUTOPILOT_PX4, 0x81, 6 << 16, 4, 3))

    def position(self, boot_ms: int) -> bytes:
        return self.packed(mav.MAVLink_local_position_ned_message(boot_ms, 1, 2, 3, 0, 0, 0))

    def packed(self, message: Any) -> bytes:
        raw = bytes(message.pack(self.mav))
        self.mav.seq = (self.mav.seq + 1) % 256
        return raw

    def say(self, *datagrams: bytes) -> None:
        for datagram in datagrams:
            self.socket.send(datagram)

    def heard(self) -> list[str]:
        """Names of the messages that have come."""
        names: list[str] = []
        parser = mav.MAVLink(None)
        while True:
            try:
                names += [m.get_type() for m in parser.parse_buffer(self.socket.recv(65536)) or ()]
            except BlockingIOError:
                return names


class Stand:
    """A link to vehicle 1 at two addresses, and its two ports."""

    def __init__(self, *, one_stream: bool) -> None:
        ports = free_port(), free_port()
        self.connects = [f"udpin:127.0.0.1:{port}" for port in ports]
        block = External.model_validate({"connect": self.connects, "sysid": 1, "capacity_j": 1e5})
        self.link = ExternalLink({1: block}, time.monotonic)
        self.first = Port(ports[0])
        self.second = Port(ports[1], self.first if one_stream else None)
        self.boot_ms = 0

    def until(self, holds: Callable[[], object]) -> None:
        deadline_s = time.monotonic() + PATIENCE_S
        while not holds():
            assert time.monotonic() < deadline_s
            self.link.listen(0.01)

    def begin(self) -> None:
        for port in (self.first, self.second):
            port.say(port.heartbeat())
        self.until(lambda: len(self.used()) == 1 and all(one.received for one in self.link.links()[1]))
        self.link.begin()

    def used(self) -> list[str]:
        return [one.connect for one in self.link.links()[1] if one.used]

    def collected(self, frames: int) -> list[int]:
        """Times of the positions that are delivered, until there are so many."""
        times: list[int] = []
        deadline_s = time.monotonic() + PATIENCE_S
        while len(times) < frames and time.monotonic() < deadline_s:
            self.link.rest(0.005)
            times += [codec.fields(frame).time_boot_ms for frame in self.link.collect()[KEY]]
        self.link.rest(0.02)
        return times + [codec.fields(frame).time_boot_ms for frame in self.link.collect()[KEY]]


@pytest.fixture
def stand() -> Iterator[Callable[..., Stand]]:
    made: list[Stand] = []

    def make(**how: Any) -> Stand:
        made.append(Stand(**how))
        return made[-1]

    yield make
    for one in made:
        one.link.close()
        one.first.socket.close()
        one.second.socket.close()


def test_a_routers_frames_are_taken_once_and_what_one_link_loses_comes_over_the_other(
    stand: Callable[..., Stand],
) -> None:
    field = stand(one_stream=True)
    field.begin()
    for boot_ms in range(100, 1100, 100):  # both bring everything
        raw = field.first.position(boot_ms)
        field.first.say(raw)
        field.second.say(raw)
    assert field.collected(10) == list(range(100, 1100, 100))
    first, second = field.first.position(1100), field.first.position(1200)
    field.first.say(first)
    field.second.say(second)
    assert sorted(field.collected(2)) == [1100, 1200]  # each has lost one
    field.first.say(second)  # late
    field.second.say(first)
    assert field.collected(0) == []


def test_what_is_sent_goes_over_the_link_in_use_and_heartbeats_and_stream_requests_over_both(
    stand: Callable[..., Stand],
) -> None:
    field = stand(one_stream=False)
    field.begin()
    for port in (field.first, field.second):
        port.heard()
    request = {"target_system": 1, "target_component": 1, "confirmation": 0}
    rest = {f"param{i}": 0.0 for i in range(1, 8)}
    interval = codec.message("COMMAND_LONG", command=mav.MAV_CMD_SET_MESSAGE_INTERVAL, **request, **rest)
    arm = codec.message("COMMAND_LONG", command=mav.MAV_CMD_COMPONENT_ARM_DISARM, **request, **rest)
    sent = field.link.grant(KEY, [PING_ALL, arm, interval], [])
    assert len(sent) == 4
    assert field.first.heard() == ["PING", "COMMAND_LONG", "COMMAND_LONG"]
    assert field.second.heard() == ["COMMAND_LONG"]


def test_a_link_that_falls_silent_is_left_within_half_a_second_and_said(stand: Callable[..., Stand]) -> None:
    field = stand(one_stream=False)
    field.begin()
    field.link.pop_relinked()
    begun_s = last_s = time.monotonic()
    while field.used() == field.connects[:1] and (now_s := time.monotonic()) - begun_s < PATIENCE_S:
        field.boot_ms += 20
        if now_s - begun_s < 1.5:  # then the first is cut
            last_s = now_s
            field.first.say(field.first.position(field.boot_ms))
        field.second.say(field.second.position(field.boot_ms + 7))
        field.link.rest(0.02)
        field.link.collect()
    assert field.used() == field.connects[1:]
    assert time.monotonic() - last_s < 0.6
    assert field.link.pop_changes() == [(1, f"Flown over {field.connects[1]} now: {field.connects[0]} is silent")]
    assert field.link.pop_relinked() == {1}
    field.second.heard()
    field.link.grant(KEY, [PING_ALL], [])
    assert field.second.heard() == ["PING"]
    field.second.say(field.second.position(9000))
    assert field.collected(1) == [9000]


class Feed:
    """Two links of one vehicle without sockets; times are given."""

    def __init__(self) -> None:
        links = [PeerLink(None, name, address=("a", i)) for i, name in enumerate("AB")]  # type: ignore[arg-type]
        self.peer = ExternalPeer(KEY, links, links[0])

    def hear(self, place: int, seq: int, now_s: float) -> bool:
        link = self.peer.links[place]
        raw = bytes([place, seq % 256, seq // 256])
        taken = self.peer.takes(Frame(1, 1, seq % 256, 0, raw), link, now_s)
        link.received_s = now_s
        return taken


def test_the_link_that_loses_less_is_used_and_the_first_again_when_it_is_as_good() -> None:
    feed, changes = Feed(), []
    for step in range(600):  # 10 Hz; of A's frames every second is lost from 5 s to 20 s
        now_s = 0.1 * step
        if not (5.0 <= now_s < 20.0 and step % 2):
            feed.hear(0, step, now_s)
        feed.hear(1, step, now_s)
        if text := feed.peer.choose(now_s):
            changes.append((now_s, text))
    (left_s, left), (back_s, back) = changes
    assert left.startswith("Flown over B now: A has ")
    assert 5.5 < left_s < 9.0
    assert back == "Flown over A now: it is as good, and preferred"
    assert 28.0 < back_s < 32.0  # what it has lost in the last 10 s counts


def test_a_silent_link_is_not_left_for_one_that_is_silent_too() -> None:
    feed = Feed()
    for step in range(20):
        feed.hear(0, step, 0.1 * step)
        feed.hear(1, step, 0.1 * step)
    assert feed.peer.choose(8.0) == ""
    assert feed.peer.used.connect == "A"


def frame(seq: int, content: int) -> Frame:
    return Frame(1, 1, seq, 0, bytes([seq, content]))


def test_streams_that_begin_alike_and_part_are_taken_from_one_link() -> None:
    """Two ports of a vehicle that was switched on a moment ago have said the same, until one is asked for more."""
    feed, taken = Feed(), []
    for step in range(40):
        shift = 0 if step < 20 else 1  # then the second port has sent one frame more
        for place in (0, 1):
            seq = step + shift * place
            raw = bytes([step])
            if feed.peer.takes(Frame(1, 1, seq, 0, raw), feed.peer.links[place], 0.1 * step):
                taken.append(step)
    assert sorted({*taken}) == list(range(40))
    assert len(taken) == 41  # the first frame that parts has a number that the other has not used yet


def test_numbers_of_another_link_are_no_gap() -> None:
    counter = GapCounter()
    for number in (5, 6, 8):
        counter.feed(1, 1, number)
    counter.forget(1)
    for number in (200, 201, 203):
        counter.feed(1, 1, number)
    assert counter.lost_of == {1: 2}
