"""The vehicles of one command line: one, or a block of them in one process, each with its own id and sockets."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import Identity
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.rules import FleetRules
from simvehicle.law.plants import Plant
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.context import Store
from simvehicle.mavlink.dispatcher import Services
from simvehicle.mavlink.telemetry import UNPROMPTED
from simvehicle.sitl.keys import Keyring
from simvehicle.sitl.link import Address, PlainLink, SupervisedLink, parse_address, parse_supervisor
from simvehicle.sitl.loop import ConnectedUnit, run_free, run_supervised
from simvehicle.sitl.secret import from_hatch
from simvehicle.sitl.truth import TruthWriter
from simvehicle.sitl.unit import VehicleUnit


@dataclass(frozen=True)
class Wanted:
    """One vehicle of a command line; `truth` is a file to make."""

    sysid: int
    start: Start
    parameters: Parameters
    truth: Path | None
    truth_hz: float | None = field(default=None, kw_only=True)
    store: Store | None = None
    key_file: Path | None = None
    state: Path | None = None
    """folder in which a key that is set outlives the process"""
    plant: Plant | None = None
    """what it flies on; without one the paper's plant"""
    rules: FleetRules | None = None
    """of the fleet that it belongs to, where vehicles compete on board"""


def fly(
    wanted: Sequence[Wanted], identity: Identity, frame: LocalFrame, connect: Sequence[str], supervised: str | None
) -> None:
    """Fly them to the end of their session; every vehicle has every connection for itself.

    Raises AddressError, KeyFileError and OSError before anything flies, OSError with a file name when truth cannot be
    written.
    """
    addresses = [parse_address(text) for text in connect]
    supervisor = parse_supervisor(supervised) if supervised is not None else None
    with ExitStack() as opened:
        seats = [
            _seat(one, identity, frame, [_own(address, i) for address in addresses], supervisor, opened)
            for i, one in enumerate(wanted)
        ]
        for one, (_, _, plain) in zip(wanted, seats, strict=True):
            for link in plain:
                print(f"vehicle {one.sysid}: {link.address} (local port {link.port})", flush=True)
        if supervisor is not None:
            run_supervised(seats, from_hatch())
        else:
            run_free(seats)


def _own(address: Address, i: int) -> Address:
    """The i-th vehicle's: those that wait at a port wait at one each, from the given one upwards."""
    if address.kind != "udpin" or address.port == 0:
        return address
    return address._replace(port=address.port + i)


def _seat(
    one: Wanted,
    identity: Identity,
    frame: LocalFrame,
    addresses: Sequence[Address],
    supervisor: Address | None,
    opened: ExitStack,
) -> ConnectedUnit:
    vehicle = Vehicle(identity, one.parameters, frame, one.start, one.plant)
    connections = [Connection(one.sysid) for _ in addresses]
    for connection in connections:
        for key, rate_hz in UNPROMPTED.items():
            connection.streams.set_default(key, rate_hz)
    keyring = Keyring(one.sysid, one.key_file, one.state)
    opened.callback(keyring.close)
    plain = [
        opened.enter_context(PlainLink(address, connection, keyring=keyring, link_id=i))
        for i, (address, connection) in enumerate(zip(addresses, connections, strict=True))
    ]
    link = None
    if supervisor is not None:
        link = opened.enter_context(SupervisedLink(supervisor, Connection(one.sysid)))
        connections.insert(0, link.connection)
    writer = opened.enter_context(TruthWriter(one.truth, one.sysid, vehicle, one.truth_hz)) if one.truth else None
    services = Services(vehicle, one.sysid, connections, one.store, one.rules, writer)
    return ConnectedUnit(VehicleUnit(vehicle, services, writer), link, plain)
