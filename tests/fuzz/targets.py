"""Links and sockets that are attacked: each target takes hostile datagrams or lines in this process."""

from __future__ import annotations

import contextlib
import json
import socket
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, cast

from dialogues import dialogues, signed_link
from hostile import Hostile

from gcs.link.external import ExternalLink
from gcs.link.lockstep import LockstepLink
from gcs.mavlink import codec
from gcs.mavlink.frame_stream import FrameStream
from gcs.mavlink.sequence import TickCollector
from gcs.processes.pace import Pace
from gcs.recording.recorder import Recorder
from gcs.scenario.endpoint import Endpoint
from gcs.scenario.external import External
from gcs.scenario.model import Scenario
from gcs.session.client import SOCKET
from gcs.session.commands import Clients
from gcs.session.messages import snapshot_message
from gcs.session.monitor import MonitorSource
from gcs.session.server import Publisher
from gcs.supervisor.forwarding import passed
from gcs.supervisor.redecide import Comparer, RecordedLink
from gcs.supervisor.supervisor import Supervisor
from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.mavlink.codec import split
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.dispatcher import Services
from simvehicle.mavlink.lockstep import Bundle, Grants, bundles
from simvehicle.sitl.link import Address, PlainLink
from simvehicle.sitl.unit import VehicleUnit

WHERE = ("127.0.0.1", 4242)
KEY = (7, 1)


class Replayed:
    """A socket that has one datagram at a time."""

    def __init__(self) -> None:
        self.waiting: list[tuple[bytes, Any]] = []

    def recvfrom(self, size: int) -> tuple[bytes, Any]:
        if not self.waiting:
            raise BlockingIOError
        datagram, address = self.waiting.pop()
        return datagram[:size], address

    def recv(self, size: int) -> bytes:
        return self.recvfrom(size)[0]

    def send(self, data: bytes) -> int:
        return len(data)

    def sendto(self, data: bytes, _: Any) -> int:
        return len(data)

    def fileno(self) -> int:
        return -1

    def close(self) -> None:
        pass


def _unit(link: Connection) -> VehicleUnit:
    vehicle = Vehicle(IDENTITIES["px4"], Parameters({}), LocalFrame(47.4, 8.5, 488.0), Start())
    return VehicleUnit(vehicle, Services(vehicle, 7, [link], None), None)


@contextlib.contextmanager
def simvehicle(hostile: Hostile) -> Iterator[Callable[[int], None]]:
    """A vehicle on a plain udpin link that flies on between the datagrams; addresses change."""
    connection = Connection(7)
    link = PlainLink(Address("udpin", "127.0.0.1", 0), connection)
    link.socket.close()
    wire = Replayed()
    link.socket = cast(socket.socket, wire)
    unit = _unit(connection)
    unit.start_clock(0, 1)
    with contextlib.redirect_stdout(None):

        def attack(n: int) -> None:
            wire.waiting = [
                (hostile.datagram(), ("127.0.0.1", hostile.random.randrange(1024, 1200))) for _ in range(50)
            ]
            for frame in link.receive():
                unit.receive(frame, connection)
            unit.advance(20 * (n // 50 + 1))
            link.flush()
            if hostile.random.random() < 0.5:  # a key that was set would keep all that follows out
                link._keyring._signing._use(None)

        yield attack


@contextlib.contextmanager
def supervised(hostile: Hostile) -> Iterator[Callable[[int], None]]:
    """Both ends of a supervised link: strangers and the joined vehicle's own address, and bundles to a vehicle."""
    link = LockstepLink()
    vehicle, stranger = (socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(2))
    for one in (vehicle, stranger):
        one.connect(("127.0.0.1", link.port))
    link.expect([KEY, (9, 1)])
    own = Grants(Connection(7))
    hello = own.hello(_unit(Connection(7)).hello(), link.secret)
    vehicle.send(hello)
    link._drain()
    assert link.joined == {KEY}
    grants = Grants(Connection(7))
    state = {"t_ms": 0}

    def attack(n: int) -> None:
        for _ in range(50):
            datagram = hostile.datagram()
            (vehicle if hostile.random.random() < 0.5 else stranger).send(datagram)
            link._drain()
            list(bundles(datagram))
            if isinstance(bundle := grants.feed(split(datagram)), Bundle):
                grants.answer(bundle)
        if not link._awaited:
            state["t_ms"] += 100
            list(link.answers(lambda: None))
            link._peers[KEY].collector = TickCollector(*KEY)
            link._enrolled = False
            link._enrol()
            link.grant(KEY, state["t_ms"], 0, [], [])
        assert link.joined == {KEY}
        _ = n

    yield attack
    for one in (link, vehicle, stranger):
        one.close()


def _scenario(**more: Any) -> Scenario:
    battery = {"capacity_j": 24_000.0}
    return Scenario.model_validate(
        {
            "schema": 1, "name": "fuzzed", "axes": "ned", "origin": {"lat_deg": 47.4, "lon_deg": 8.5, "alt_m": 488.0},
            "goal": {"duration_s": 86_400.0}, "clock": {"mode": "real"}, "formation": {"ring_m": 2.0},
            "vehicles": {
                "pursuers": [
                    {"start_m": (0, 0, 0), "external": {"sysid": 7, "connect": "udpin:127.0.0.1:9", "capacity_j": 24e3},
                     "sysid": 7, "battery": battery},
                    {"sysid": 1, "start_m": (3.0, 0.0, -4.0), "airborne": True, "battery": battery},
                ],
                "targets": [{"sysid": 101, "start_m": (0, 0, -4.0), "airborne": True, "battery": battery,
                             "path_m": [(0, 0, -4.0), (30, 0, -4.0)], "speed_m_s": 0.8}],
                "tankers": [{"sysid": 201, "start_m": (-6, 0, -4.0), "airborne": True, "battery": battery}],
            },
        }
        | more
    )  # fmt: skip


def _supervisor() -> tuple[Supervisor, RecordedLink]:
    scenario = _scenario()
    link = RecordedLink([(vehicle.sysid, 1) for vehicle in scenario.vehicles.all])
    supervisor = Supervisor(scenario, link, cast(Recorder, Comparer()))
    supervisor.begin()
    return supervisor, link


@contextlib.contextmanager
def external(hostile: Hostile) -> Iterator[Callable[[int], None]]:
    """An external link whose vehicle is hostile, with the supervisor's whole tick behind it."""
    supervisor, recorded = _supervisor()
    link = _external_link()
    wire = cast(Any, next(iter(link._addresses.values())).connection)._socket

    def attack(n: int) -> None:
        wire.waiting = [
            (
                hostile.datagram(),
                WHERE if hostile.random.random() < 0.8 else ("127.0.0.1", hostile.random.randrange(9999)),
            )
            for _ in range(50)
        ]
        recorded.recorded = link.collect()
        supervisor.tick(lambda: None)
        message = snapshot_message(supervisor, phase="flying", speed=1.0, refuelled=0, events=supervisor.events)
        json.dumps(message, allow_nan=False)
        supervisor.events.clear()
        cast(Any, supervisor._recorder).made.clear()
        _ = n

    yield attack
    link.close()


def _external_link() -> ExternalLink:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
        one.bind(("127.0.0.1", 0))
        port = one.getsockname()[1]
    link = ExternalLink({7: External(connect=f"udpin:127.0.0.1:{port}", sysid=7, capacity_j=24e3)}, lambda: 1.0)
    (opened,) = link._addresses.values()
    connection = cast(Any, opened.connection)
    connection._socket.close()
    wire = Replayed()
    connection._socket = wire
    beat = codec.encode(
        "HEARTBEAT", 0, 7, 1, type=2, autopilot=12, base_mode=0x81, custom_mode=6 << 16, system_status=4
    )
    wire.waiting = [(beat, WHERE)]
    link._drain()
    assert link.joined == {KEY}
    link._kept = True
    return link


@contextlib.contextmanager
def stations(hostile: Hostile) -> Iterator[Callable[[int], None]]:
    """A stream that is cut anywhere, of other ground stations that may command: what passes is framed again."""
    stream = FrameStream()

    def attack(_: int) -> None:
        for _ in range(50):
            data = hostile.datagram()
            at = hostile.random.randrange(len(data) + 1)
            for piece in (data[:at], data[at:]):
                for frame in stream.feed(piece).frames:
                    one = passed(frame._replace(sysid=255, compid=190), (1, 7))
                    if one is not None and isinstance(one.message, codec.Message):
                        codec.frame(one.message, 0, 255, 190)
            assert len(stream._pending) < codec.LARGEST_FRAME

    yield attack


@contextlib.contextmanager
def monitor(hostile: Hostile) -> Iterator[Callable[[int], None]]:
    """A monitor with control, whose listener hears a crowd."""
    now = {"s": 0.0}
    source = MonitorSource(Endpoint("udpin", "127.0.0.1", 0), control=True, clock=lambda: now["s"])
    connection = cast(Any, source._listener.connection)
    connection._socket.close()
    wire = Replayed()
    connection._socket = wire

    def attack(n: int) -> None:
        now["s"] = 0.1 * (n // 50 + 1)
        wire.waiting = [(hostile.datagram(), ("127.0.0.1", hostile.random.randrange(20))) for _ in range(50)]
        for message in source.receive():
            json.dumps(message, allow_nan=False)

    yield attack
    source.close()


@contextlib.contextmanager
def session_sock(hostile: Hostile) -> Iterator[Callable[[int], None]]:
    """The session's socket with clients that come, say anything, do not read, and go."""
    supervisor, _ = _supervisor()
    with tempfile.TemporaryDirectory() as folder:
        publisher = Publisher(Path(folder), {"type": "session"})
        clients = Clients(publisher, supervisor, Pace(None, lambda: 0.0))
        connected: list[socket.socket] = []
        path = str(Path(folder) / SOCKET)

        def attack(n: int) -> None:
            rng = hostile.random
            if len(connected) < 8 or rng.random() < 0.05:
                client = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
                client.setblocking(False)
                with contextlib.suppress(BlockingIOError):
                    client.connect(path)
                connected.append(client)
            for _ in range(50):
                with contextlib.suppress(OSError):
                    rng.choice(connected).send(hostile.line())
            for client in connected[:]:
                with contextlib.suppress(OSError):
                    client.recv(1 << 18)
                if rng.random() < 0.01:
                    client.close()
                    connected.remove(client)
            while any(b"\n" in waiting for waiting in publisher._clients.values()) or not n:
                clients.serve()
                n = 1
            clients.serve()
            publisher.publish({"type": "snapshot", "events": [{"text": "x"}]})
            supervisor.operator._records.clear()
            supervisor.events.clear()
            cast(Any, supervisor._recorder).made.clear()

        yield attack
        for client in connected:
            client.close()
        publisher.close()


FRAMES = {
    "simvehicle": simvehicle,
    "supervised link": supervised,
    "external link": external,
    "monitor": monitor,
    "stations": stations,
    "dialogues": dialogues,
    "signed link": signed_link,
    "session.sock": session_sock,
}
"""Targets of datagrams and lines; one call of `attack` takes 50."""
