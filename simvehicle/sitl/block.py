"""The vehicles of one command line: one, or a block of them in one process, each with its own id and plain sockets;
the one to their supervisor they share."""

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
from simvehicle.fleet.separation import Separation
from simvehicle.fleet.separation_rules import SeparationRules
from simvehicle.law.plants import Plant
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.context import Store
from simvehicle.mavlink.dispatcher import Services
from simvehicle.mavlink.telemetry import UNPROMPTED
from simvehicle.sitl.keys import Keyring
from simvehicle.sitl.link import (
    LAST_PORT,
    Address,
    AddressError,
    PlainLink,
    SupervisedLink,
    parse_address,
    parse_supervisor,
)
from simvehicle.sitl.loop import ConnectedUnit, run_free
from simvehicle.sitl.secret import own_secret
from simvehicle.sitl.supervised import run_supervised
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
    separation: SeparationRules | None = None
    """by which it keeps apart while it flies by itself"""


@dataclass(frozen=True)
class _Built:
    """A vehicle with its services, before it has a socket or a file."""

    wanted: Wanted
    unit: VehicleUnit
    truth: TruthWriter | None
    connections: Sequence[Connection]
    """one for each address; before them that to the supervisor, if there is one"""


class Block:
    """Vehicles of one command line, every one with every plain connection for itself."""

    def __init__(
        self,
        wanted: Sequence[Wanted],
        identity: Identity,
        frame: LocalFrame,
        connect: Sequence[str],
        supervised: str | None,
    ) -> None:
        """Build them, without a socket or a file: what is forked from this process can fly them. Raises
        AddressError."""
        parsed = [parse_address(text) for text in connect]
        self._addresses = [[_own(address, i, len(wanted)) for address in parsed] for i in range(len(wanted))]
        self._supervisor = parse_supervisor(supervised) if supervised is not None else None
        self._built = [self._build(one, identity, frame, len(parsed)) for one in wanted]

    def _build(self, one: Wanted, identity: Identity, frame: LocalFrame, plain: int) -> _Built:
        vehicle = Vehicle(identity, one.parameters, frame, one.start, one.plant)
        if one.separation is not None:
            vehicle.period_s = one.separation.period_s
            vehicle.separation = Separation(vehicle, one.sysid, one.separation)
        connections = [Connection(one.sysid) for _ in range(plain)]
        for connection in connections:
            for key, rate_hz in UNPROMPTED.items():
                connection.streams.set_default(key, rate_hz)
        if self._supervisor is not None:
            connections.insert(0, Connection(one.sysid))
        writer = TruthWriter(one.truth, one.sysid, vehicle, one.truth_hz) if one.truth else None
        services = Services(vehicle, one.sysid, connections, one.store, one.rules, writer)
        return _Built(one, VehicleUnit(vehicle, services, writer), writer, connections)

    def fly(self) -> None:
        """Fly them to the end of their session, once.

        Raises AddressError, KeyRefused and OSError before anything flies, OSError with a file name when standard output
        or truth cannot be written.
        """
        with ExitStack() as opened:
            seats = [self._seat(one, i, opened) for i, one in enumerate(self._built)]
            for _, _, plain in seats:
                for link in plain:
                    link.announce()
            if self._supervisor is not None:
                run_supervised(seats, opened.enter_context(SupervisedLink(self._supervisor)), own_secret())
            else:
                run_free(seats)

    def _seat(self, one: _Built, i: int, opened: ExitStack) -> ConnectedUnit:
        wanted, connections = one.wanted, one.connections
        keyring = Keyring(wanted.sysid, wanted.key_file, wanted.state, armed=lambda: one.unit.armed)
        opened.callback(keyring.close)
        supervised = None
        if self._supervisor is not None:
            supervised, *connections = connections
        plain = [
            opened.enter_context(PlainLink(address, connection, keyring=keyring, link_id=number))
            for number, (address, connection) in enumerate(zip(self._addresses[i], connections, strict=True))
        ]
        if one.truth is not None:
            opened.enter_context(one.truth)
        return ConnectedUnit(one.unit, supervised, plain)


def _own(address: Address, i: int, count: int) -> Address:
    """Address of the i-th of `count` vehicles. Vehicles that listen have a port each, from the given one upwards.
    Raises AddressError where there are not so many ports."""
    if address.kind != "udpin" or address.port == 0:
        return address
    if address.port + count - 1 > LAST_PORT:
        raise AddressError(
            f"cannot use {address} for {count} vehicles: ports end at {LAST_PORT}; begin at {LAST_PORT + 1 - count}"
        )
    return address._replace(port=address.port + i)
