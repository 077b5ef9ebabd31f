"""Compile the flight law by flying it for a moment, so that every fork of this process has it ready."""

from __future__ import annotations

import functools
import socket

from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.law.plants import Plant, RotorPlant
from simvehicle.mavlink.codec import encode, message, split
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.dispatcher import Services
from simvehicle.mavlink.lockstep import SUPERVISOR, Bundle, Grants
from simvehicle.sitl.link import SupervisedLink, parse_supervisor
from simvehicle.sitl.steady import Flyable, SteadyFlight
from simvehicle.sitl.unit import VehicleUnit
from simvehicle.world.airframes import AIRFRAMES, ROTORS
from simvehicle.world.description import WorldVehicle

PERIOD_MS = 100
STEADY_BUNDLES = 3
BUNDLES = 30
"""Three seconds: every stream has been due, and the interpreter has seen its hot code often enough to specialise it.

Both are then shared by all forks, where each would make them for itself, in memory of its own.
"""


def warm_up() -> None:
    """Load, compile and run everything that a flying vehicle needs."""
    _fly(Plant(), BUNDLES)


def _fly(plant: Plant, bundles: int) -> None:
    """Fly a vehicle on a plant for so many bundles, and then steadily."""
    vehicle = Vehicle(IDENTITIES["px4"], Parameters(), LocalFrame(0.0, 0.0, 0.0), Start(airborne=True), plant)
    connection = Connection(1)
    services = Services(vehicle, 1, [connection])
    unit = VehicleUnit(vehicle, services, None)
    grants = Grants(connection)
    grants.hello(unit.hello())
    unit.start_clock(0, 0)
    for number in range(bundles):
        bundle = grants.feed(tuple(split(_bundle(number))))
        assert isinstance(bundle, Bundle)
        for frame in bundle.frames:
            unit.receive(frame, connection)
        unit.advance(bundle.time_ms)
        grants.answer(bundle)
    _fly_steadily(SteadyFlight([(Flyable(vehicle, services, None), connection, grants)]), bundles)


def _fly_steadily(steady: SteadyFlight, first: int) -> None:
    """Fly some bundles in compiled code; they come from a supervisor on the loopback."""
    steady.hand_over(0, ())
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as supervisor:
        supervisor.bind(("127.0.0.1", 0))
        with SupervisedLink(parse_supervisor(f"udpout:127.0.0.1:{supervisor.getsockname()[1]}")) as link:
            for number in range(first, first + STEADY_BUNDLES):
                supervisor.sendto(_bundle(number), link.socket.getsockname())
            steady.serve(link)
    steady.take_back(0)


@functools.cache
def warm_up_rotors() -> None:
    """Load and compile, if need be, what flies on rotors."""
    plant = RotorPlant(WorldVehicle(AIRFRAMES["iris"]))
    _fly(plant, 2)
    plant.turn((0.0,) * ROTORS, time_s=0.0, dt_s=PERIOD_MS / 1e3)


def _bundle(number: int) -> bytes:
    """Messages of a supervisor: its HEARTBEAT, a set point, and the grant."""
    system, component = SUPERVISOR
    contents = (
        message("HEARTBEAT")(0, mav.MAV_TYPE_GCS, mav.MAV_AUTOPILOT_INVALID, 0, mav.MAV_STATE_ACTIVE, 3),
        message("SET_POSITION_TARGET_LOCAL_NED")(
            *(number * PERIOD_MS, 0.1 * number, 0.0, -5.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
            *(0b1101_1100_0000, 1, 1, mav.MAV_FRAME_LOCAL_NED),
        ),
        message("SYSTEM_TIME")(0, number * PERIOD_MS),
    )
    first = number * len(contents)
    return b"".join(
        encode(content, seq=first + i & 0xFF, sysid=system, compid=component) for i, content in enumerate(contents)
    )
