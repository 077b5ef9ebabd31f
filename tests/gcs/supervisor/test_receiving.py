"""Answers that are taken in by the datagram, against the same datagrams taken in frame by frame: what is delivered, and
what the fleet, the gaps, the link's quality and the events say afterwards."""

import contextlib
import random
import socket
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gcs.link.link import Key, TickGrants
from gcs.link.lockstep import LockstepLink
from gcs.mavlink import codec
from gcs.mavlink.datagram import AnswerRuns
from gcs.mavlink.setpoints import PlacedSetPoints
from gcs.recording.recorder import Recorder
from gcs.scenario.file import find, load
from gcs.scenario.model import Scenario
from gcs.supervisor.supervisor import Supervisor

SECRET = 7
Place = int
"""A socket of the test's, by its number."""
NOBODY: Place = -1
NAMES = ["HEARTBEAT", "ATTITUDE", "ATTITUDE", "LOCAL_POSITION_NED", "LOCAL_POSITION_NED", "BATTERY_STATUS",
         "SYS_STATUS", "EXTENDED_SYS_STATE", "NAMED_VALUE_FLOAT", "NAMED_VALUE_INT", "PARAM_VALUE", "STATUSTEXT",
         "COMMAND_ACK", "ADSB_VEHICLE", "GPS_GLOBAL_ORIGIN", "HOME_POSITION", "GLOBAL_POSITION_INT",
         "DEBUG_VECT"]  # fmt: skip


class Side:
    """A supervisor and its link; `alone`: frame by frame."""

    def __init__(self, scenario: Scenario, addresses: dict[Key, Place], folder: Path, *, alone: bool) -> None:
        self.link = LockstepLink()
        places = {*addresses.values(), NOBODY}
        self.sockets = {place: socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for place in places}
        for one in self.sockets.values():
            one.connect(("127.0.0.1", self.link.port))
        self.link.secret = SECRET
        self.alone, self.together = alone, 0
        self.link.expect(addresses)
        shared = [address for address in addresses.values() if list(addresses.values()).count(address) > 1]
        for key, address in addresses.items():
            hello = codec.encode("HEARTBEAT", 0, *key, type=2, autopilot=12, base_mode=0, custom_mode=0,
                                 system_status=3)  # fmt: skip
            hello += codec.encode("SYSTEM_TIME", 1, *key, time_unix_usec=SECRET, time_boot_ms=int(address in shared))
            self.sockets[address].send(hello)
        self.link.listen(0.0)
        folder.mkdir()
        self.supervisor = Supervisor(scenario, self.link, Recorder(folder))

    def grant(self, keys: list[Key], t_ms: int) -> None:
        points = PlacedSetPoints(t_ms, (), np.empty((0, 6)))
        self.link.grant_all(TickGrants(t_ms, 0, keys, (), points, {}))
        self.link._enrolled |= self.alone

    def take(self, datagrams: list[tuple[bytes, Place]]) -> list[Key]:
        for datagram, place in datagrams:
            self.sockets[place].send(datagram)
        with contextlib.suppress(BlockingIOError):
            while True:
                self.link._socket.recv(1, socket.MSG_PEEK)
                self.link._drain()
        return self.link.awaited

    def delivered(self, now_s: float) -> Any:
        answers = list(self.link.answers(lambda: pytest.fail("somebody is still awaited")))
        self.together += sum(len(frames) for _, frames in answers if isinstance(frames, AnswerRuns))
        received = self.supervisor._receive(answers, now_s)
        return list(received.frames), {sysid: list(frames) for sysid, frames in received.by_system.items()}

    def close(self) -> None:
        self.link.close()
        for one in self.sockets.values():
            one.close()

    def state(self, now_s: float) -> Any:
        supervisor = self.supervisor
        fleet, quality = supervisor.fleet, supervisor.quality
        snapshot = fleet.snapshot(now_s)
        shares = {sysid: quality.lost_share(sysid) for sysid in range(256)}
        facts, acks = fleet.pop_facts(), fleet.pop_acks()
        return (
            *snapshot.vehicles, *snapshot.traffic, *acks, facts, supervisor.events, supervisor.received,
            shares, supervisor.gaps.lost_of, self.link.joined, self.link.malformed,
        )  # fmt: skip


def same(one: tuple[Any, ...], other: tuple[Any, ...]) -> bool:
    """Equal, where what is no number is equal to itself."""
    return len(one) == len(other) and all(a == b or repr(a) == repr(b) for a, b in zip(one, other, strict=True))


def values(name: str, rng: random.Random) -> dict[str, Any]:
    """Fields of a message, of small numbers."""
    shape = codec.layout(name)
    made: dict[str, Any] = {}
    for field, form in zip(shape.record._fields, shape.formats, strict=True):
        length = int(form[:-1]) if len(form) > 1 else 0
        draw = (lambda: rng.uniform(-1.0, 1.0)) if form[-1] in "fd" else (lambda: rng.randrange(3))
        made[field] = "x" if form[-1] == "s" else [draw() for _ in range(length)] if length else draw()
    if name == "NAMED_VALUE_INT":
        made["name"] = rng.choice(["XferIn", "XferOut", "Other"])
    if name == "STATUSTEXT":
        made["text"] = rng.choice(["short", "x" * 50])
    return made


class Vehicles:
    """Those on the other side, whose datagrams meet with everything."""

    def __init__(self, rng: random.Random, addresses: dict[Key, Place]) -> None:
        self.rng, self.addresses = rng, addresses
        self.numbers = dict.fromkeys(addresses, 2)
        self.before: list[tuple[bytes, Place]] = []

    def answers(self, keys: list[Key], t_ms: int) -> dict[Key, list[bytes]]:
        """Frames of everybody's answer."""
        rng, told = self.rng, {}
        for key in keys:
            frames = []
            for _ in range(rng.randrange(5)):
                name = rng.choice(NAMES)
                told_of = {"ICAO_address": key[0]} if name == "ADSB_VEHICLE" else {}  # each hears another aircraft
                frames.append(codec.encode(name, self.numbers[key], *key, **(values(name, rng) | told_of)))
                self.numbers[key] = (self.numbers[key] + 1) % 256
            frames.append(codec.encode("SYSTEM_TIME", self.numbers[key], *key, time_unix_usec=1, time_boot_ms=t_ms))
            self.numbers[key] = (self.numbers[key] + 1) % 256
            told[key] = frames
        return told

    def whole(self, told: dict[Key, list[bytes]]) -> list[tuple[bytes, Place]]:
        """The answers in as few datagrams as may be, in any order."""
        keys = list(told)
        self.rng.shuffle(keys)
        by_address: dict[Place, bytes] = {}
        datagrams = []
        for key in keys:
            address = self.addresses[key]
            by_address[address] = by_address.get(address, b"") + b"".join(told[key])
            if self.rng.random() < 0.1:
                datagrams.append((by_address.pop(address), address))
        return [*datagrams, *((datagram, address) for address, datagram in by_address.items())]

    def mangled(self, told: dict[Key, list[bytes]]) -> Iterator[tuple[bytes, Place]]:
        """The same with losses, cuts, repetitions, and what others say."""
        rng = self.rng
        datagrams = self.whole(told)
        if rng.random() < 0.3:
            key = rng.choice(list(told))
            at = rng.randrange(len(told[key]) + 1)
            parts = [b"".join(part) for part in (told[key][:at], told[key][at:]) if part]
            datagrams += [(part, self.addresses[key]) for part in rng.sample(parts, len(parts))]
        if rng.random() < 0.2 and self.before:
            datagrams.append(rng.choice(self.before))
        rng.shuffle(datagrams)
        for datagram, address in datagrams:
            draw = rng.random()
            if draw < 0.25:
                continue
            if draw < 0.3:
                at = rng.randrange(len(datagram))
                yield datagram[:at] + bytes([datagram[at] ^ 1 << rng.randrange(8)]) + datagram[at + 1 :], address
            elif draw < 0.35:
                yield datagram[: rng.randrange(len(datagram))], address
            elif draw < 0.4:
                sender = rng.choice([(1, 2), (77, 1), (2, 1), (3, 1)])
                other = codec.encode("ATTITUDE", rng.randrange(256), *sender, **values("ATTITUDE", rng))
                yield rng.choice([other + datagram, datagram + other]), address
            elif draw < 0.42:
                yield datagram, rng.choice([*self.addresses.values(), NOBODY])
            elif draw < 0.46:
                yield b"".join(codec.sent_by(frame, 2).raw for frame in codec.split(datagram).frames), address
            else:
                yield datagram, address
                if rng.random() < 0.1:
                    yield datagram, address
        self.before = datagrams


def twelve() -> Scenario:
    """The fleet with its first twelve pursuers and 77, which never joins, of two hundred."""
    fleet = load(find("fleet"))
    kept = tuple(one for one in fleet.vehicles.pursuers if one.sysid in {*range(1, 13), 77})
    return fleet.model_copy(update={"vehicles": fleet.vehicles.model_copy(update={"pursuers": kept})})


@pytest.mark.parametrize("seed", range(3))
def test_datagrams_of_whole_answers_are_received_as_frame_by_frame(seed: int, tmp_path: Path) -> None:
    rng = random.Random(seed)
    scenario = twelve()
    keys = [(sysid, 1) for sysid in range(1, 13)]
    addresses = {key: k // (1, 4, 12)[seed % 3] for k, key in enumerate(keys)}
    both = [Side(scenario, addresses, tmp_path / str(alone), alone=alone) for alone in (False, True)]
    usual, alone = both
    assert usual.link.joined == alone.link.joined == set(keys)
    vehicles = Vehicles(rng, addresses)
    for tick in range(60):
        now_s = 0.1 * tick
        if tick == 40:
            left = rng.choice(keys)
            keys.remove(left)
            for side in both:
                side.link.leave(left)
        granted = sorted(rng.sample(keys, rng.choice([len(keys), len(keys), len(keys) - 3])))
        for side in both:
            side.grant(granted, 100 * tick)
        told = vehicles.answers(granted, 100 * tick)
        some = list(vehicles.mangled(told)) if rng.random() < 0.6 else vehicles.whole(told)
        cut = rng.randrange(len(some) + 1)
        for part in (some[:cut], some[cut:], vehicles.whole(told)):
            assert usual.take(part) == alone.take(part)
        assert usual.link.awaited == []
        assert usual.delivered(now_s) == alone.delivered(now_s)
        assert same(usual.state(now_s), alone.state(now_s))
    assert alone.together == 0
    assert 150 < usual.together < 700
    lost = sum(usual.supervisor.gaps.lost_of.values())
    assert lost == 0
    for side in both:
        side.close()


def test_a_tick_that_does_not_fit_the_buffer_is_received_all_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("gcs.link.intake.BUFFER_BYTES", 300)
    rng = random.Random(1)
    keys = [(sysid, 1) for sysid in range(1, 13)]
    addresses = {key: key[0] for key in keys}
    side = Side(twelve(), addresses, tmp_path / "one", alone=False)
    vehicles = Vehicles(rng, addresses)
    for tick in range(20):
        side.grant(keys, 100 * tick)
        told = vehicles.answers(keys, 100 * tick)
        assert side.take(vehicles.whole(told)) == []
        arrived, _ = side.delivered(0.1 * tick)
        assert arrived == [raw for key in keys for raw in told[key]]
    assert 20 < side.together < 160
    side.close()
