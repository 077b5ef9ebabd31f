"""Vehicles on their supervisor's clock, to the byte: what they say and what is true in flights of every kind.

They are driven with datagrams that pymavlink made. `flights.sha256` holds what each flight gave when a vehicle's tick
was also flown by a second, independent program, which said the same.
"""

from __future__ import annotations

import hashlib
import math
import random
import resource
import select
import socket
import threading
import time
from collections import defaultdict
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.parameters import Parameters
from simvehicle.law.plants import Plant, RotorPlant
from simvehicle.mavlink.codec import split
from simvehicle.sitl import supervised
from simvehicle.sitl.block import Block, Wanted
from simvehicle.sitl.link import SupervisedLink
from simvehicle.world.airframes import AIRFRAMES
from simvehicle.world.description import Air, WorldVehicle
from simvehicle.world.estimate import EstimateErrors

EPOCH_US = 1_700_000_000_000_000
FRAME = LocalFrame(47.397742, 8.545594, 488.0)
AIRBORNE = Start((3.0, -2.0, -10.0), (0.5, 0.0, 0.1), (0.05, -0.1, 2.0), airborne=True)
BOTH = 0b1101_1100_0000
GOLDEN = Path(__file__).with_name("flights.sha256")


class Supervisor:
    """Numbers what it says to each vehicle."""

    def __init__(self, sysids: Sequence[int]) -> None:
        self._speakers = {sysid: mav.MAVLink(None, 255, 190) for sysid in sysids}
        self.shared = len(sysids) > 1

    def frame(self, sysid: int, content: Any) -> bytes:
        speaker = self._speakers[sysid]
        raw = bytes(content.pack(speaker))
        speaker.seq = (speaker.seq + 1) % 256
        return raw

    def bundle(self, sysid: int, time_ms: int, contents: Sequence[Any], relays: Sequence[bytes] = ()) -> bytes:
        marker = mav.MAVLink_ping_message(0, 0, sysid, 1).pack(mav.MAVLink(None, 255, 190)) if self.shared else b""
        grant = mav.MAVLink_system_time_message(EPOCH_US + 1000 * time_ms, time_ms)
        return bytes(marker) + b"".join(
            [*(self.frame(sysid, one) for one in contents), *relays, self.frame(sysid, grant)]
        )


def set_point(sysid: int, p: Sequence[float], v: Sequence[float] = (0.0, 0.0, 0.0), **other: Any) -> Any:
    mask, frame, component = other.get("mask", BOTH), other.get("frame", 1), other.get("component", 1)
    turn = other.get("yaw", 0.0), other.get("yaw_rate", 0.0)
    return mav.MAVLink_set_position_target_local_ned_message(
        77, sysid, component, frame, mask, *p, *v, 0.0, 0.0, 0.0, *turn
    )


def heartbeat(kind: int = mav.MAV_TYPE_GCS) -> Any:
    return mav.MAVLink_heartbeat_message(kind, 8, 0, 0, 4, 3)


def command(sysid: int, number: int, *values: float) -> Any:
    return mav.MAVLink_command_long_message(sysid, 1, number, 0, *(*values, *(0.0,) * 7)[:7])


class Flown:
    """Everything that a process of vehicles said and wrote down."""

    def __init__(
        self,
        folder: Path,
        wanted: Callable[[Path], list[Wanted]],
        datagrams: Sequence[bytes],
        *,
        end: type[BaseException] = SystemExit,
    ) -> None:
        links: list[SupervisedLink] = []
        self._speaks = True

        class Link(SupervisedLink):
            def __init__(self, address: Any) -> None:
                super().__init__(address)
                links.append(self)

        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ground, pytest.MonkeyPatch.context() as patch:
            ground.bind(("127.0.0.1", 0))
            ground.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
            patch.setattr("simvehicle.sitl.block.SupervisedLink", Link)
            patch.setattr("simvehicle.sitl.block.run_supervised", partial(supervised.run_supervised, clock=self._clock))
            vehicles = wanted(folder)
            block = Block(vehicles, IDENTITIES["px4"], FRAME, [], f"udpout:127.0.0.1:{ground.getsockname()[1]}")
            sent: list[bytes] = []
            speaker = threading.Thread(target=self._speak, args=(ground, links, datagrams, sent), daemon=True)
            speaker.start()
            with pytest.raises(end):
                block.fly()
            links[0].socket.close()
            speaker.join()
            sent += _waiting(ground)
        self.truth = {path.name: path.read_bytes() for path in sorted(folder.iterdir())}
        hellos = set(sent[: len(vehicles)])
        self.sent = [datagram for datagram in sent if datagram not in hellos]
        self.said: dict[int, list[bytes]] = defaultdict(list)
        for datagram in self.sent:
            for frame in split(datagram):
                self.said[frame.sysid].append(frame.raw)

    def _clock(self) -> float:
        """Wall time, which leaps over the silence that ends a flight once all has been said."""
        return time.monotonic() if self._speaks else math.inf

    @property
    def sha256(self) -> str:
        """Of what each vehicle said, and of the files of truth."""
        said = [raw for _, frames in sorted(self.said.items()) for raw in frames]
        return hashlib.sha256(b"".join([*said, *self.truth.values()])).hexdigest()

    def _speak(
        self, ground: socket.socket, links: Sequence[SupervisedLink], datagrams: Sequence[bytes], sent: list[bytes]
    ) -> None:
        """Send all, each when the one before has been taken; what came back meanwhile."""
        datagram, peer = ground.recvfrom(65536)
        sent.append(datagram)
        for datagram in datagrams:
            while _waits(links[0].socket):
                select.select([ground], [], [], 1e-3)
                sent += _waiting(ground)
            ground.sendto(datagram, peer)
        self._speaks = False


def _waits(receiver: socket.socket) -> bool:
    """Whether a datagram has not been received yet, by a socket that is open."""
    return receiver.fileno() >= 0 and bool(select.select([receiver], [], [], 0.0)[0])


def _waiting(ground: socket.socket) -> list[bytes]:
    taken = []
    while _waits(ground):
        taken.append(ground.recv(65536))
    return taken


@pytest.fixture
def fly(tmp_path: Path, request: pytest.FixtureRequest) -> Callable[..., Flown]:
    """Fly, and hold what was said and what is true against what is known of this flight."""

    def flown(wanted: Callable[[Path], list[Wanted]], datagrams: Sequence[bytes]) -> Flown:
        one = Flown(tmp_path, wanted, datagrams)
        known = dict(reversed(line.split(maxsplit=1)) for line in GOLDEN.read_text().splitlines())
        assert one.sha256 == known[request.node.name]
        return one

    return flown


def vehicles(
    *sysids: int,
    start: Start = AIRBORNE,
    truth_hz: float | None = None,
    plant: Callable[[int], Plant] = lambda _: Plant(),
    **params: float,
) -> Any:
    def wanted(folder: Path) -> list[Wanted]:
        return [
            Wanted(sysid, start, Parameters(params), folder / f"{sysid}.truth", truth_hz=truth_hz, plant=plant(sysid))
            for sysid in sysids
        ]

    return wanted


def circle(sysid: int, time_ms: int) -> Any:
    angle = 0.0005 * time_ms + sysid
    place = (4.0 * math.cos(angle), 4.0 * math.sin(angle), -10.0 - 0.2 * sysid)
    return set_point(sysid, place, (-2.0 * math.sin(angle), 2.0 * math.cos(angle), 0.0))


@pytest.mark.parametrize("period_ms", [100, 50, 20, 6])
@pytest.mark.parametrize("sysids", [(7,), (1, 2, 254)])
def test_a_flight_of_set_points_is_the_same_to_the_byte(
    fly: Callable[..., Flown], sysids: tuple[int, ...], period_ms: int
) -> None:
    """Ten seconds: every stream has been due; 6 ms is no multiple of a step."""
    supervisor = Supervisor(sysids)
    datagrams = []
    for time_ms in range(0, 10_001, period_ms):
        beat = [heartbeat()] if time_ms % 1000 < period_ms else []
        bundles = [supervisor.bundle(sysid, time_ms, [*beat, circle(sysid, time_ms)]) for sysid in sysids]
        datagrams.append(b"".join(bundles))
    flown = fly(vehicles(*sysids), datagrams)
    heard = {frame.msgid for datagram in flown.sent for frame in split(datagram)}
    assert len(heard) >= 13


GUSTS = ((2.0, 1.0, 0.5, 3.0, -2.0, 1.0),)
IN_WEATHER: dict[str, Callable[[int], Plant]] = {
    "still air": lambda sysid: RotorPlant(WorldVehicle(AIRFRAMES["iris"]), sysid=sysid),
    "gusts, with sensors": lambda sysid: RotorPlant(
        WorldVehicle(AIRFRAMES["iris"], EstimateErrors()),
        Air(mean_nwu=(4.0, 1.0, 0.0), turbulence_m_s=5.0, gusts_nwu=GUSTS),
        seed=3,
        sysid=sysid,
    ),
    "one on rotors, one not": lambda sysid: RotorPlant(WorldVehicle(AIRFRAMES["iris"])) if sysid == 2 else Plant(),
}


@pytest.mark.parametrize("air", IN_WEATHER)
@pytest.mark.parametrize("sysids", [(2,), (1, 2)])
def test_on_rotors_too(fly: Callable[..., Flown], sysids: tuple[int, ...], air: str) -> None:
    """Twelve seconds, longer than noise is drawn ahead; with set points that end for a while, and odd ones."""
    supervisor = Supervisor(sysids)
    datagrams = []
    for t in range(0, 12_001, 100):
        bundles = []
        for sysid in sysids:
            contents = [circle(sysid, t)] if t not in (2000, 7300) else [set_point(sysid, (math.nan, 0.0, -5.0))]
            bundles.append(supervisor.bundle(sysid, t, [heartbeat(), *contents]))
        datagrams.append(b"".join(bundles))
    fly(vehicles(*sysids, plant=IN_WEATHER[air]), datagrams)


def test_on_rotors_from_the_ground_and_to_it(fly: Callable[..., Flown]) -> None:
    """Standing, it knows that it stands: the errors of its velocity do not count then."""
    supervisor = Supervisor((1,))
    ordered = {
        100: [command(1, mav.MAV_CMD_DO_SET_MODE, 1.0, 6.0)],
        200: [command(1, mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0)],
    }
    datagrams = []
    for t in range(0, 14_001, 100):
        place = set_point(1, (0.0, 0.0, -2.0 if t < 6000 else 1.5))
        datagrams.append(supervisor.bundle(1, t, [heartbeat(), *ordered.get(t, ()), place]))
    fly(vehicles(1, start=Start(), plant=IN_WEATHER["gusts, with sensors"]), datagrams)


def test_a_battery_that_runs_low_is_found_by_the_vehicle_itself(fly: Callable[..., Flown]) -> None:
    supervisor = Supervisor((1,))
    datagrams = [supervisor.bundle(1, t, [heartbeat(), circle(1, t)]) for t in range(0, 8001, 100)]
    flown = fly(vehicles(1, SIM_BAT_CAP_J=1000.0, BAT_EMERGEN_THR=0.3), datagrams)
    texts = [frame for datagram in flown.sent for frame in split(datagram) if frame.msgid == 253]
    assert texts


@pytest.mark.parametrize("silent", ["set points", "ground station"])
def test_silence_is_found_by_the_vehicle_itself(fly: Callable[..., Flown], silent: str) -> None:
    supervisor = Supervisor((1,))
    datagrams = []
    for t in range(0, 9001, 100):
        contents = [] if silent == "set points" and t > 2000 else [circle(1, t)]
        datagrams.append(
            supervisor.bundle(1, t, contents if silent == "ground station" and t > 2000 else [heartbeat(), *contents])
        )
    flown = fly(vehicles(1), datagrams)
    assert any(frame.msgid == 253 for datagram in flown.sent for frame in split(datagram))


def test_from_the_ground_and_back_through_every_mode(fly: Callable[..., Flown]) -> None:
    """Armed, taken off, steered, told to say more, to hold, to land: handed over whenever nothing else happens."""
    supervisor, sysids = Supervisor((1, 2)), (1, 2)
    at_ms = {
        500: [mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0],
        700: [mav.MAV_CMD_NAV_TAKEOFF, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 491.0],
        5000: [mav.MAV_CMD_DO_SET_MODE, 1.0, 6.0],
        6000: [mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAVLINK_MSG_ID_BATTERY_STATUS, 100_000.0],
        6500: [mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAVLINK_MSG_ID_ATTITUDE_QUATERNION, 700_000.0],
        7000: [mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAVLINK_MSG_ID_ATTITUDE, 40_000.0],
        9000: [mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_HOME_POSITION],
        11_000: [mav.MAV_CMD_NAV_LAND],
    }
    datagrams = []
    for t in range(0, 20_001, 100):
        ordered = at_ms.get(t)
        bundles = []
        for sysid in sysids:
            extra = [command(sysid, int(ordered[0]), *ordered[1:])] if ordered else []
            bundles.append(supervisor.bundle(sysid, t, [heartbeat(), *extra, circle(sysid, t)]))
        datagrams.append(b"".join(bundles))
    fly(vehicles(*sysids, start=Start()), datagrams)


def test_a_set_point_under_the_ground_is_flown_to_the_ground(fly: Callable[..., Flown]) -> None:
    """Landed in offboard: what it says of that is the same."""
    supervisor = Supervisor((1,))
    started = [
        (0, [heartbeat(), set_point(1, (0.0, 0.0, -3.0))]),
        (100, [heartbeat(), command(1, mav.MAV_CMD_DO_SET_MODE, 1.0, 6.0), set_point(1, (0.0, 0.0, -3.0))]),
        (200, [command(1, mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0), set_point(1, (0.0, 0.0, -3.0))]),
    ]
    datagrams = [supervisor.bundle(1, t, contents) for t, contents in started]
    for t in range(300, 16_001, 100):
        down = -3.0 if t < 6000 else 2.0
        datagrams.append(supervisor.bundle(1, t, [heartbeat(), set_point(1, (0.0, 0.0, down))]))
    flown = fly(vehicles(1, start=Start()), datagrams)
    states = [raw for raw in flown.said[1] if raw[7] == mav.MAVLINK_MSG_ID_EXTENDED_SYS_STATE]
    assert {raw[11] for raw in states} == {mav.MAV_LANDED_STATE_IN_AIR, mav.MAV_LANDED_STATE_ON_GROUND}


def test_truth_at_a_rate_of_its_own(fly: Callable[..., Flown]) -> None:
    supervisor = Supervisor((1, 3))
    datagrams = [
        b"".join(supervisor.bundle(sysid, t, [heartbeat(), circle(sysid, t)]) for sysid in (1, 3))
        for t in range(0, 5001, 100)
    ]
    fly(vehicles(1, 3, truth_hz=3.0), datagrams)


def odd(random_: random.Random, sysid: int, t: int) -> list[Any]:
    """Something that a supervisor may say and that is not usual."""
    nan = math.nan
    return random_.choice(
        [
            [set_point(sysid, (nan, 0.0, -5.0))],
            [set_point(sysid, (1.0, 2.0, -5.0), mask=BOTH & ~mav.POSITION_TARGET_TYPEMASK_YAW_IGNORE, yaw=0.7)],
            [set_point(sysid, (1.0, 2.0, -5.0), frame=8)],
            [set_point(sysid, (0.0, 0.0, 0.0), (0.5, 0.0, 0.0), mask=BOTH | 7)],
            [set_point(sysid, (9.0, 9.0, -9.0), component=7)],
            [set_point(sysid % 254 + 1, (9.0, 9.0, -9.0))],
            [heartbeat(mav.MAV_TYPE_QUADROTOR), circle(sysid, t)],
            [circle(sysid, t), circle(sysid, t + 40)],
            [],
            [mav.MAVLink_param_request_read_message(sysid, 1, b"MPC_XY_VEL_MAX", -1)],
            [mav.MAVLink_param_set_message(sysid, 1, b"MPC_XY_VEL_MAX", random_.uniform(1.0, 9.0), 9)],
            [command(sysid, mav.MAV_CMD_SET_MESSAGE_INTERVAL, random_.choice([1, 30, 74, 141, 147]), 150_000.0)],
            [mav.MAVLink_mission_request_list_message(sysid, 1, 0)],
        ]
    )


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("sysids", [(5,), (1, 2, 3, 200)])
def test_whatever_comes_between(fly: Callable[..., Flown], sysids: tuple[int, ...], seed: int) -> None:
    """Odd messages, relays, repeated, lost and broken datagrams, foreign vehicles, grants of many lengths."""
    random_ = random.Random(seed)
    supervisor, neighbour = Supervisor(sysids), mav.MAVLink(None, 99, 1)
    datagrams, time_ms = [], 0
    for _ in range(150):
        bundles = []
        for sysid in sysids:
            contents = [circle(sysid, time_ms)] if random_.random() < 0.85 else odd(random_, sysid, time_ms)
            if random_.random() < 0.15:
                contents = [heartbeat(), *contents]
            relays = []
            if random_.random() < 0.05:
                relays = [bytes(mav.MAVLink_named_value_int_message(time_ms, b"XferOut", 5).pack(neighbour))]
            bundles.append(supervisor.bundle(sysid, time_ms, contents, relays))
        random_.shuffle(bundles)
        datagram = b"".join(bundles)
        chance = random_.random()
        if chance < 0.05:
            datagrams.append(bytes(b ^ (random_.random() < 0.02) for b in datagram))  # broken, and then repeated
        elif chance < 0.1:
            datagrams.append(datagram[: random_.randrange(len(datagram))])
        elif chance < 0.13:
            datagrams.append(random_.randbytes(random_.randrange(1, 90)))
        datagrams += [datagram] * (1 + (random_.random() < 0.1))
        time_ms += random_.choice([100, 100, 100, 100, 50, 20, 4, 3, 104, 250])
    fly(vehicles(*sysids), datagrams)


def test_truth_that_cannot_be_written_ends_the_flight_before_the_answer(tmp_path: Path) -> None:
    """A file may grow to 20,000 bytes, as on a disk that is full then, in the middle of a record."""
    supervisor, sysids, most_bytes = Supervisor((1, 2)), (1, 2), 20_000
    datagrams = [
        b"".join(supervisor.bundle(sysid, t, [heartbeat(), circle(sysid, t)]) for sysid in sysids)
        for t in range(0, 8001, 100)
    ]
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, limits[1]))
    try:
        flown = Flown(tmp_path, vehicles(*sysids), datagrams, end=OSError)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    head_bytes = flown.truth["1.truth"].index(b"\n") + 1
    whole = 1 + (most_bytes - head_bytes - 8 * 18) // (8 * (18 + 25))  # the first, at T = 0, has no steps
    assert len(flown.truth["1.truth"]) == most_bytes
    assert len(flown.truth["2.truth"]) == head_bytes + 8 * 18 + (whole - 1) * 8 * (18 + 25)
    for sysid in sysids:
        assert [raw[7] for raw in flown.said[sysid]].count(mav.MAVLINK_MSG_ID_SYSTEM_TIME) == whole
