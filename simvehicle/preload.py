"""Compile the flight law by flying it for a moment, so that every fork of this process has it ready."""

from __future__ import annotations

from simvehicle.geo import LocalFrame
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.identity import IDENTITIES
from simvehicle.mavlink.parameters import Parameters
from simvehicle.services import Services
from simvehicle.unit import VehicleUnit
from simvehicle.vehicle import Start, Vehicle


def warm_up() -> None:
    """Load, compile and run everything that a flying vehicle needs."""
    vehicle = Vehicle(IDENTITIES["px4"], Parameters(), LocalFrame(0.0, 0.0, 0.0), Start(airborne=True))
    connection = Connection(1)
    unit = VehicleUnit(vehicle, Services(vehicle, 1, [connection]), None)
    unit.start_clock(0, 0)
    unit.advance(1000)
    connection.frames()
