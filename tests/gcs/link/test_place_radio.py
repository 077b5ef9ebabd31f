"""The radio on which vehicles receive each other's places: to whom, what of it, and how much."""

from __future__ import annotations

from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.link.impairment import Impairment
from gcs.link.peers.peer_radio import MOST_BYTES
from gcs.link.peers.place_radio import PlaceRadio, is_place
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.mavlink.ids import TRAFFIC
from gcs.scenario.parts.radio import RadioSplit

REFERENCE, LEADER = 0b1001_1100_0000, 0b1000_0000_0000


def frame(sysid: int, kind: str, /, **fields: Any) -> Frame:
    maker = mav.MAVLink(None, srcSystem=sysid, srcComponent=1)
    raw = getattr(maker, f"{kind.lower()}_encode")(**fields).pack(maker)
    return codec.split(bytes(raw)).frames[0]


def place(sysid: int) -> Frame:
    return frame(sysid, "LOCAL_POSITION_NED", time_boot_ms=100, x=1.0, y=2.0, z=-3.0, vx=0.0, vy=0.0, vz=0.5)


def target(sysid: int, mask: int) -> Frame:
    numbers = dict.fromkeys(("x", "y", "z", "vx", "vy", "vz", "afx", "afy", "afz", "yaw", "yaw_rate"), 1.0)
    return frame(sysid, "POSITION_TARGET_LOCAL_NED", time_boot_ms=100, coordinate_frame=1, type_mask=mask, **numbers)


def heartbeat(sysid: int) -> Frame:
    return frame(sysid, "HEARTBEAT", type=2, autopilot=12, base_mode=0, custom_mode=0, system_status=4)


def received(radio: PlaceRadio, sysid: int, *, led: bool = False) -> list[tuple[int, int]]:
    """(sender, message) of all that comes."""
    piece = radio.deliver(sysid, 0.1, led=led)
    assert not piece or is_place(piece)
    return [(one.sysid, one.msgid) for one in codec.split(piece).frames]


def test_who_is_not_led_receives_places_and_leaders_and_nothing_else() -> None:
    radio = PlaceRadio([1, 2, 3], Impairment())
    radio.send({1: [heartbeat(1), place(1), target(1, REFERENCE)], 2: [place(2), target(2, LEADER)], 3: [place(3)]})
    radio.begin({1, 2, 3}, {1})
    assert radio.listening == {2, 3}
    assert received(radio, 1, led=True) == []
    assert not radio.delivered
    assert received(radio, 3) == [(1, 32), (2, 32), (2, 85), (3, 32)]
    assert radio.delivered


def test_one_that_is_not_known_to_follow_the_set_points_that_reach_it_receives_places() -> None:
    radio = PlaceRadio([1, 2], Impairment())
    radio.send({1: [place(1)], 2: [place(2)]})
    radio.begin({1, 2}, {2})
    assert received(radio, 1, led=True) != []
    assert received(radio, 2, led=True) == []


def test_one_on_the_ground_or_of_another_kind_receives_none() -> None:
    radio = PlaceRadio([1, 2], Impairment())
    radio.send({1: [place(1)], 2: [place(2)]})
    radio.begin({1, 9}, ())
    assert received(radio, 2) == received(radio, 9) == []
    assert received(radio, 1) != []


def test_while_all_hear_the_station_every_third_tick_is_enough() -> None:
    radio = PlaceRadio([1, 2], Impairment())
    counts = []
    for _ in range(9):
        radio.send({1: [place(1)], 2: [place(2)]})
        radio.begin({1, 2}, (), seldom=True)
        counts.append(len(received(radio, 1)))
    assert sorted(counts) == [0] * 6 + [2] * 3


def test_of_a_fleet_too_large_for_a_bundle_all_come_within_a_few_ticks() -> None:
    sysids = range(1, 255)
    radio, seen = PlaceRadio(sysids, Impairment()), set[int]()
    for tick in range(3):
        radio.send({sysid: [place(sysid), target(sysid, LEADER)] for sysid in sysids})
        radio.begin(set(sysids), ())
        piece = radio.deliver(1, 0.1 * tick, led=False, beside_bytes=3000)
        assert len(piece) <= MOST_BYTES - 3000
        seen |= {one.sysid for one in codec.split(piece).frames}
    assert seen == set(sysids)


def test_a_split_parts_the_two_sides_and_lets_those_that_are_led_listen_before() -> None:
    radio = PlaceRadio([1, 2, 3], Impairment(), splits=[RadioSplit(sysids=(1, 2), from_s=0.0, to_s=1.0)])
    radio.send({sysid: [place(sysid)] for sysid in (1, 2, 3)})
    radio.begin({1, 2, 3}, {1, 2, 3})
    assert received(radio, 1, led=True) == [(2, 32)]
    assert received(radio, 3, led=True) == []


def aircraft(icao: int) -> Frame:
    maker = mav.MAVLink(None, *TRAFFIC)
    raw = maker.adsb_vehicle_encode(icao, 474000000, 85000000, 1, 500000, 0, 0, 0, b"TURN", 14, 0, 0, 0).pack(maker)
    return codec.split(bytes(raw)).frames[0]


@pytest.mark.parametrize("splits", [(), (RadioSplit(sysids=(1,), from_s=0.0, to_s=1.0),)])
def test_aircraft_are_received_on_both_sides_of_a_split(splits: tuple[RadioSplit, ...]) -> None:
    radio = PlaceRadio([1, 2], Impairment(), splits=splits, traffic=True)
    radio.send({1: [place(1)], 2: [place(2)], TRAFFIC[0]: [heartbeat(TRAFFIC[0]), aircraft(1), aircraft(2)]})
    radio.begin({1, 2}, ())
    for sysid in (1, 2):
        assert [one for one in received(radio, sysid) if one[0] == TRAFFIC[0]] == [(TRAFFIC[0], 246)] * 2


def test_what_the_station_sends_is_no_place() -> None:
    assert not is_place(place(255).raw)
    assert not is_place(heartbeat(1).raw)
