"""The link to strangers' vehicles, over real sockets on the loopback; the vehicles' bytes are pymavlink's."""

import select
import socket
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from patience import PATIENCE_S
from ports import free_port
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.link import external
from gcs.link.external import ExternalLink
from gcs.link.fleet import FleetLink
from gcs.link.lockstep import LockstepLink
from gcs.mavlink import codec
from gcs.scenario.external import External

KEYS = {1: (1, 1), 2: (2, 1)}
PING_ALL = codec.message("PING", time_usec=1, seq=1, target_system=0, target_component=0)


class Vehicle:
    """One socket, and what pymavlink writes to it and reads from it."""

    def __init__(self, sysid: int, compid: int = 1) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.setblocking(False)
        self.mav = mav.MAVLink(None, srcSystem=sysid, srcComponent=compid)
        self.port = self.socket.getsockname()[1]

    def packed(self, message: Any) -> bytes:
        return bytes(message.pack(self.mav))

    def heartbeat(self, autopilot: int = mav.MAV_AUTOPILOT_PX4, state: int = mav.MAV_STATE_ACTIVE) -> bytes:
        return self.packed(mav.MAVLink_heartbeat_message(2, autopilot, 0x81, 6 << 16, state, 3))

    def position(self, boot_ms: int) -> bytes:
        return self.packed(mav.MAVLink_local_position_ned_message(boot_ms, 1, 2, 3, 0, 0, 0))

    def say(self, port: int, *datagrams: bytes) -> None:
        for datagram in datagrams:
            self.socket.sendto(datagram, ("127.0.0.1", port))

    def hear(self, count: int) -> list[Any]:
        """The messages of the next datagrams, which must hold one each."""
        heard: list[Any] = []
        poll = select.poll()
        poll.register(self.socket, select.POLLIN)
        while len(heard) < count and poll.poll(1e3 * PATIENCE_S):
            (message,) = self.mav.parse_buffer(self.socket.recv(65536))
            heard.append(message)
        assert len(heard) == count
        return heard


@pytest.fixture
def stand() -> Iterator[Callable[..., Any]]:
    """Makes vehicles, and links that expect them; closes all."""
    made: list[Any] = []

    def make(what: Any) -> Any:
        made.append(what)
        return what

    yield make
    for one in made:
        (one if isinstance(one, ExternalLink | FleetLink) else one.socket).close()


def block(connect: str, sysid: int = 1) -> External:
    return External(connect=connect, sysid=sysid, capacity_j=1e5)


def udpin(*sysids: int, now_s: Callable[[], float] = time.monotonic) -> tuple[ExternalLink, int]:
    port = free_port()
    return ExternalLink({sysid: block(f"udpin:127.0.0.1:{port}", sysid) for sysid in sysids}, now_s), port


def until(link: ExternalLink, holds: Callable[[], bool]) -> None:
    deadline_s = time.monotonic() + PATIENCE_S
    while not holds():
        assert time.monotonic() < deadline_s
        link.listen(0.01)


def test_vehicles_on_one_port_are_known_by_their_first_heartbeat_and_answered_where_they_are(stand: Any) -> None:
    link, port = udpin(1, 2)
    stand(link)
    one, two = stand(Vehicle(1)), stand(Vehicle(2))
    one.say(port, one.position(5), one.heartbeat())
    until(link, lambda: link.joined == {KEYS[1]})
    assert link.missing == {KEYS[2]}
    two.say(port, two.heartbeat())
    until(link, lambda: not link.missing)
    sent = link.grant(KEYS[1], [PING_ALL, PING_ALL], [])
    assert [frame[4] for frame in sent] == [0, 1]
    assert [(m.get_type(), m.get_srcSystem(), m.get_seq()) for m in one.hear(2)] == [("PING", 255, 0), ("PING", 255, 1)]
    (first,) = link.grant(KEYS[2], [PING_ALL], [])
    assert first[4] == 0  # numbers are counted for each address
    assert [m.get_type() for m in two.hear(1)] == ["PING"]


def test_the_station_has_the_id_that_it_is_given(stand: Any) -> None:
    port = free_port()
    link = stand(ExternalLink({1: block(f"udpin:127.0.0.1:{port}")}, time.monotonic, (245, 191)))
    one = stand(Vehicle(1))
    one.say(port, one.heartbeat())
    until(link, lambda: not link.missing)
    link.grant(KEYS[1], [PING_ALL], [])
    (ping,) = one.hear(1)
    assert (ping.get_srcSystem(), ping.get_srcComponent()) == (245, 191)


def test_the_vehicles_clock_is_compared_and_a_boot_is_noticed_before_it_has_a_place_again(stand: Any) -> None:
    now_s = 50.0
    link, port, one = joined(stand, lambda: now_s)
    link.begin()
    one.say(port, one.packed(mav.MAVLink_attitude_message(20_000, 0, 0, 0, 0, 0, 0)), one.position(20_000))
    until(link, lambda: bool(link.offsets_s()))
    assert link.offsets_s() == {1: pytest.approx(30.0)}
    link.collect()
    assert link.collected_s == 50.0
    assert link.pop_rebooted() == set()
    one.say(port, one.packed(mav.MAVLink_attitude_message(900, 0, 0, 0, 0, 0, 0)))
    until(link, lambda: link.pop_rebooted() == {1})


def test_a_heartbeat_says_once_that_an_autopilot_boots_before_it_sends_a_time(stand: Any) -> None:
    """An ArduCopter says so twice, a second apart, and sends no time until it is asked to."""
    now_s = 50.0
    link, port, one = joined(stand, lambda: now_s)
    link.begin()
    boots = one.heartbeat(mav.MAV_AUTOPILOT_ARDUPILOTMEGA, mav.MAV_STATE_BOOT)
    one.say(port, one.heartbeat(), one.position(20_000), one.heartbeat())
    until(link, lambda: bool(link.offsets_s()))
    assert link.pop_rebooted() == set()
    one.say(port, boots)
    until(link, lambda: link.pop_rebooted() == {1})
    assert link.offsets_s() == {}
    one.say(port, boots, one.heartbeat(state=mav.MAV_STATE_STANDBY), one.position(900))
    until(link, lambda: bool(link.offsets_s()))
    assert link.offsets_s() == {1: pytest.approx(49.1)}
    assert link.pop_rebooted() == set()


@pytest.mark.parametrize(
    ("compid", "autopilot"),
    [(mav.MAV_COMP_ID_GIMBAL, mav.MAV_AUTOPILOT_INVALID), (191, mav.MAV_AUTOPILOT_PX4), (1, mav.MAV_AUTOPILOT_INVALID)],
)
def test_a_gimbal_a_companion_and_a_ground_station_are_no_vehicle(stand: Any, compid: int, autopilot: int) -> None:
    link, port = udpin(1)
    stand(link)
    other, one = stand(Vehicle(1, compid)), stand(Vehicle(1))
    other.say(port, other.heartbeat(autopilot))
    one.say(port, one.heartbeat())
    until(link, lambda: not link.missing)
    link.grant(KEYS[1], [PING_ALL], [])
    assert one.hear(1)[0].get_type() == "PING"


def version(uid: int, uid2: bytes = b"") -> Any:
    return mav.MAVLink_autopilot_version_message(
        0, 0, 0, 0, 0, [0] * 8, [0] * 8, [0] * 8, 0, 0, uid, uid2.ljust(18, b"\0")
    )


def joined(stand: Any, now_s: Callable[[], float] = time.monotonic) -> tuple[Any, int, Vehicle]:
    """A link, its port, and the one vehicle that it expects, which it has heard."""
    link, port = udpin(1, now_s=now_s)
    stand(link)
    one = stand(Vehicle(1))
    one.say(port, one.heartbeat())
    until(link, lambda: not link.missing)
    return link, port, one


def refused_twin(stand: Any) -> tuple[Any, int, Vehicle, Vehicle]:
    """A link that has begun, its port, its vehicle, and another with the same id, from elsewhere, that it refuses."""
    link, port, one = joined(stand)
    other = stand(Vehicle(1))
    link.begin()
    other.say(port, other.heartbeat(), other.position(1))
    until(link, lambda: bool(link.refused))
    assert link.refused == {KEYS[1]: ("127.0.0.1", other.port)}
    assert link.collect() == {KEYS[1]: []}
    return link, port, one, other


@pytest.mark.parametrize(
    ("kept", "other", "words"),
    [
        (version(0xA1), version(0xB2), "; their uids are b2 and a1"),
        (version(1, b"\x01\x02"), version(1, b"\x01\x03"), f"; their uids are {'0103'.ljust(36, '0')} and"),
        (version(0xA1), version(0xA1), "; both have the uid a1, as one vehicle that comes two ways has"),
        (version(0xA1), None, "; their uids are not said and a1"),
        (None, None, "is kept"),
    ],
)
def test_twins_are_asked_for_their_uids_and_named_with_both_addresses(
    stand: Any, monkeypatch: pytest.MonkeyPatch, kept: Any, other: Any, words: str
) -> None:
    if kept is None or other is None:
        monkeypatch.setattr(external, "UID_S", 0.3)
    link, port, one, twin = refused_twin(stand)
    assert link.pop_twins() == []
    for vehicle, answer in ((one, kept), (twin, other)):
        (asked,) = vehicle.hear(1)
        assert (asked.get_type(), asked.command, asked.param1) == ("COMMAND_LONG", mav.MAV_CMD_REQUEST_MESSAGE, 148.0)
        if answer is not None:
            vehicle.say(port, vehicle.packed(answer))
    said: list[tuple[int, str]] = []
    until(link, lambda: said.extend(link.pop_twins()) or said)
    ((sysid, text),) = said
    places = f"from 127.0.0.1:{twin.port}: ignored, the one at 127.0.0.1:{one.port} is kept"
    assert sysid == 1
    assert text.startswith(f"Another vehicle says that it is 1, {places}")
    assert words in text
    assert text.endswith("is kept") is (kept is other)


def test_console_text_before_the_first_frame_is_passed_over_and_broken_frames_after_it_are_counted(stand: Any) -> None:
    link, port = udpin(1)
    stand(link)
    one = stand(Vehicle(1))
    one.say(port, b"\n\nInit ArduCopter V4.5.5\n\nFree RAM: 131072\n", b"Ready to FLY " + one.heartbeat())
    until(link, lambda: not link.missing)
    assert link.malformed == 0
    broken = bytearray(one.heartbeat())
    broken[-1] ^= 0xFF
    one.say(port, bytes(broken), one.heartbeat()[:-4])
    until(link, lambda: link.malformed == 2)


def test_vehicles_behind_a_router_share_one_address(stand: Any) -> None:
    link, port = udpin(1, 2)
    stand(link)
    router, two = stand(Vehicle(1)), stand(Vehicle(2))
    router.say(port, router.heartbeat() + two.heartbeat())
    until(link, lambda: not link.missing)
    link.begin()
    router.say(port, two.position(7) + router.position(8))
    collected: dict[Any, list[Any]] = {KEYS[1]: [], KEYS[2]: []}
    deadline_s = time.monotonic() + PATIENCE_S
    while not all(collected.values()) and time.monotonic() < deadline_s:
        link.rest(0.01)
        for key, frames in link.collect().items():
            collected[key] += [codec.fields(frame).time_boot_ms for frame in frames]
    assert collected == {KEYS[1]: [8], KEYS[2]: [7]}


def test_a_vehicle_that_listens_is_spoken_to_first(stand: Any) -> None:
    one = stand(Vehicle(1))
    link = stand(ExternalLink({1: block(f"udpout:127.0.0.1:{one.port}")}, time.monotonic))
    link.listen(0.0)
    (heartbeat,) = one.hear(1)
    assert (heartbeat.get_type(), heartbeat.type) == ("HEARTBEAT", mav.MAV_TYPE_GCS)
    one.say(link._peers[1].used.opened.connection.port, one.heartbeat())
    until(link, lambda: not link.missing)


def test_who_speaks_mavlink_1_hears_mavlink_2_and_may_go_over_to_it(stand: Any) -> None:
    link, port = udpin(1)
    stand(link)
    one = stand(Vehicle(1))
    old = mav.MAVLink_heartbeat_message(2, 12, 0x81, 0, 4, 3).pack(one.mav, force_mavlink1=True)
    one.say(port, bytes(old))
    until(link, lambda: bool(select.select([one.socket], [], [], 0)[0]))
    assert one.hear(1)[0].get_type() == "HEARTBEAT"
    assert link.missing == {KEYS[1]}


def test_while_the_session_stands_still_the_last_set_point_goes_out_again(stand: Any) -> None:
    link, _, one = joined(stand)
    point = codec.message(
        "SET_POSITION_TARGET_LOCAL_NED", time_boot_ms=1, target_system=1, target_component=1, coordinate_frame=1,
        type_mask=3520, x=1.0, y=2.0, z=-3.0, vx=0.0, vy=0.0, vz=0.0, afx=0.0, afy=0.0, afz=0.0, yaw=0.0, yaw_rate=0.0,
    )  # fmt: skip
    link.grant(KEYS[1], [point], [])
    until(link, lambda: link.stand_in() is None and bool(select.select([one.socket], [], [], 0.0)[0]))
    heard = one.hear(1)
    deadline_s = time.monotonic() + PATIENCE_S
    while len(heard) < 2 and time.monotonic() < deadline_s:
        link.rest(0.01)
        link.stand_in()
        heard += one.hear(1) if select.select([one.socket], [], [], 0.0)[0] else []
    assert [(m.get_type(), m.x, m.get_seq()) for m in heard] == [
        ("SET_POSITION_TARGET_LOCAL_NED", 1.0, 0), ("SET_POSITION_TARGET_LOCAL_NED", 1.0, 1),
    ]  # fmt: skip


@contextmanager
def mixed() -> Iterator[tuple[FleetLink, Vehicle]]:
    external, port = udpin(1)
    link, one = FleetLink(LockstepLink(), external), Vehicle(1)
    try:
        one.say(port, one.heartbeat())
        until(external, lambda: not external.missing)
        yield link, one
    finally:
        link.close()
        one.socket.close()


def test_a_mixed_fleet_needs_no_grant_for_strangers_and_no_wait() -> None:
    with mixed() as (link, one):
        sent = link.grant(KEYS[1], 100, 0, [PING_ALL], [])
        assert [codec.split(raw).frames[0].msgid for raw in sent] == [codec.msgid("PING")]  # and no SYSTEM_TIME
        assert list(link.answers(lambda: pytest.fail("a stranger was waited for"))) == []
        assert link.unawaited() == {KEYS[1]: []}
        assert one.hear(1)[0].get_type() == "PING"
        assert link.joined == {KEYS[1]}
        link.leave(KEYS[1])
        assert link.joined == set()


def test_two_who_say_the_same_before_the_session_are_rivals_and_one_alone_settles(stand: Any) -> None:
    link, port, one = joined(stand)
    twin = stand(Vehicle(1))
    assert not link.settled  # the other has had no time to speak
    twin.say(port, twin.heartbeat())
    until(link, lambda: bool(link.rivals))
    assert link.rivals == {KEYS[1]: (("127.0.0.1", one.port), ("127.0.0.1", twin.port))}
    until(link, lambda: link.settled)


def test_a_vehicle_that_was_silent_may_go_on_from_another_address(stand: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    link, port, _, again = refused_twin(stand)
    assert link.pop_moved() == {}
    monkeypatch.setattr(external, "MOVED_AFTER_S", 0.0)
    again.say(port, again.heartbeat(), again.position(5))
    until(link, lambda: bool(link._moved))
    assert link.pop_moved() == {KEYS[1]: ("127.0.0.1", again.port)}
    link.grant(KEYS[1], [PING_ALL], [])
    assert [one.get_type() for one in again.hear(2)] == ["COMMAND_LONG", "PING"]  # at first it was asked for its uid


def test_of_a_flood_of_strangers_little_is_read_and_the_vehicle_is_heard(
    stand: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    link, port, one = joined(stand)
    flood = stand(Vehicle(9))
    link.begin()
    read: list[int] = []
    split = codec.split
    monkeypatch.setattr(codec, "split", lambda datagram: read.append(len(datagram)) or split(datagram))
    monkeypatch.setattr(external, "UNKNOWN_READ", 5)
    flood.say(port, *[b"\xfd" * 60_000] * 20)
    one.say(port, one.position(100))
    assert len(link.collect()[KEYS[1]]) == 1
    assert read == [external.UNKNOWN_BYTES] * 5 + [len(one.position(100))]
    assert link.malformed == 0


@pytest.mark.parametrize(
    ("status", "words"),
    [
        ((200, 190, 90, 40, 42, 0, 0), None),
        ((200, 190, 12, 40, 42, 0, 0), "its radio has 12 % of its buffer left"),
        ((200, 50, 90, 40, 42, 0, 0), "its radio's signal at the other end is weak: 50, noise 42"),
        ((255, 255, 90, 255, 255, 0, 0), None),  # it does not know
    ],
)
def test_a_telemetry_radio_that_is_full_or_weak_is_told_and_no_vehicle(stand: Any, status: Any, words: Any) -> None:
    """RADIO_STATUS comes among a vehicle's frames, from the radio's own system id."""
    link, port, one = joined(stand)
    radio = stand(Vehicle(51, 68))
    link.begin()
    report = mav.MAVLink_radio_status_message(*status)
    radio.say(port, radio.packed(report))  # a stranger's
    one.say(port, radio.packed(report), one.position(100))
    collected: list[Any] = []
    until(link, lambda: collected.extend(link.collect()[KEYS[1]]) or collected)
    told = link.pop_radios()
    assert [text.startswith(words) for _, text in told] == ([True] if words else [])
    assert link.pop_radios() == []
    assert link.joined == {KEYS[1]}
