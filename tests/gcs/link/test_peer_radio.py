"""The radio among vehicles: who receives whose frames, what is lost, and what a blackout or a split cuts."""

from __future__ import annotations

from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.link.impairment import Burst, Impairment
from gcs.link.peers.peer_radio import MOST_BYTES, PeerRadio
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.scenario.parts.radio import RadioSplit

VEHICLES = (1, 2, 3, 201)


def frame(sysid: int, kind: str, seq: int = 0, /, **fields: Any) -> Frame:
    """A frame as pymavlink makes it."""
    maker = mav.MAVLink(None, srcSystem=sysid, srcComponent=1)
    maker.seq = seq
    raw = getattr(maker, f"{kind.lower()}_encode")(**fields).pack(maker)
    return codec.split(bytes(raw)).frames[0]


def report(sysid: int, seq: int = 0) -> Frame:
    return frame(sysid, "DEBUG_FLOAT_ARRAY", seq, time_usec=7, name=b"Peer", array_id=1, data=[1.0] * 58)


def order(sysid: int, target: int) -> Frame:
    params = {f"param{i}": float(i) for i in range(1, 8)}
    return frame(
        sysid, "COMMAND_LONG", target_system=target, target_component=1, command=31010, confirmation=0, **params
    )


def counter(sysid: int, name: bytes) -> Frame:
    return frame(sysid, "NAMED_VALUE_INT", time_boot_ms=0, name=name, value=5)


def heard(radio: PeerRadio, reader: int, t_s: float = 0.0) -> list[bytes]:
    """The frames that come."""
    return [frame.raw for frame in codec.split(radio.receive(reader, t_s)).frames]


def test_a_broadcast_reaches_all_others_as_it_is_and_an_order_only_its_reader() -> None:
    radio = PeerRadio(VEHICLES, Impairment())
    sent = [report(1), order(1, 201), counter(1, b"XferIn")]
    radio.send(1, sent)
    assert heard(radio, 1) == []
    assert heard(radio, 2) == [sent[0].raw, sent[2].raw]
    assert heard(radio, 201) == [one.raw for one in sent]


def test_what_is_the_ground_stations_stays_there() -> None:
    radio = PeerRadio(VEHICLES, Impairment())
    heartbeat = frame(1, "HEARTBEAT", type=2, autopilot=12, base_mode=0, custom_mode=0, system_status=4)
    radio.send(1, [heartbeat, counter(1, b"Other"), order(1, 255)])
    assert heard(radio, 2) == []


def test_frames_come_in_the_order_of_their_senders() -> None:
    radio = PeerRadio(VEHICLES, Impairment())
    frames = {sysid: report(sysid) for sysid in (201, 3, 2)}
    for sysid, one in frames.items():
        radio.send(sysid, [one])
    assert heard(radio, 1) == [frames[sysid].raw for sysid in (2, 3, 201)]


def test_of_more_than_fit_into_a_bundle_all_come_within_a_few_ticks() -> None:
    sysids = range(1, 41)
    radio, seen = PeerRadio(sysids, Impairment()), set[int]()
    for tick in range(3):
        for sysid in sysids:
            radio.send(sysid, [report(sysid)])
        raws = heard(radio, 1, 0.1 * tick)
        assert sum(map(len, raws)) <= MOST_BYTES // 2
        seen |= {raw[5] for raw in raws}
    assert seen == set(sysids) - {1}


def received(radio: PeerRadio, reader: int, ticks: int = 400, sender: int = 1) -> list[tuple[int, int]]:
    """(tick, number) of one sender's frames, one sent in each tick."""
    found = []
    for tick in range(ticks):
        radio.send(sender, [report(sender, tick % 256)])
        found += [(tick, raw[4]) for raw in heard(radio, reader, 0.1 * tick)]
    return found


def test_each_pair_loses_its_own_frames_and_all_as_many() -> None:
    to_2, to_3 = (received(PeerRadio(VEHICLES, Impairment(loss=0.2, seed=4)), reader) for reader in (2, 3))
    assert to_2 != to_3
    assert len(to_2) == pytest.approx(320, abs=30)
    assert len(to_3) == pytest.approx(320, abs=30)
    assert received(PeerRadio(VEHICLES, Impairment(loss=0.2, seed=4)), 2) == to_2
    assert received(PeerRadio(VEHICLES, Impairment(loss=0.2, seed=5)), 2) != to_2


@pytest.mark.parametrize("dark", [1, 2])
def test_a_blackout_of_either_side_cuts_it(dark: int) -> None:
    radio = PeerRadio(VEHICLES, Impairment(), blackouts=[Burst(dark, 1.0, 2.0, loss=1.0)])
    assert [tick for tick, _ in received(radio, 2, ticks=30)] == [*range(10), *range(20, 30)]


def test_a_split_cuts_the_two_sides_and_neither_within() -> None:
    split = [RadioSplit(sysids=(1, 2), from_s=1.0, to_s=2.0)]
    assert len(received(PeerRadio(VEHICLES, Impairment(), splits=split), 2, ticks=30)) == 30
    assert [tick for tick, _ in received(PeerRadio(VEHICLES, Impairment(), splits=split), 3, ticks=30)] == [
        *range(10),
        *range(20, 30),
    ]
