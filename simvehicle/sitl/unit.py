"""Units that the loops drive: a vehicle with its MAVLink services and its truth, or another."""

from __future__ import annotations

import contextlib

from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.mavlink.codec import ReceivedFrame
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.dispatcher import Services
from simvehicle.mavlink.telemetry import message_of
from simvehicle.sitl.truth import TruthWriter


class Unit:
    """Unit that a loop drives: a vehicle with its services, another autopilot, or traffic."""

    def hello(self) -> object:
        """The HEARTBEAT of the hello."""
        raise NotImplementedError

    def start_clock(self, time_ms: int, unix_us: int) -> None:
        """Set the clock without a step."""
        raise NotImplementedError

    def receive(self, frame: ReceivedFrame, connection: Connection) -> None:
        """Act on one frame."""
        raise NotImplementedError

    def advance(self, to_ms: int) -> None:
        """Go to a time and queue what became due."""
        raise NotImplementedError


class VehicleUnit(Unit):
    """One vehicle."""

    _vehicle: Vehicle
    _services: Services
    _truth: TruthWriter | None

    def __init__(self, vehicle: Vehicle, services: Services, truth: TruthWriter | None) -> None:
        self._vehicle = vehicle
        self._services = services
        self._truth = truth

    @property
    def armed(self) -> bool:
        """Whether the vehicle is."""
        return self._vehicle.armed

    def hello(self) -> object:
        """The vehicle's HEARTBEAT."""
        return message_of(self._vehicle, "HEARTBEAT")

    def start_clock(self, time_ms: int, unix_us: int) -> None:
        """Set the vehicle's clock without a step."""
        self._vehicle.set_clock(time_ms, unix_us)

    def receive(self, frame: ReceivedFrame, connection: Connection) -> None:
        """Hand a frame to the services."""
        self._services.receive(frame, connection)

    def advance(self, to_ms: int) -> None:
        """Fly to a time, queue what became due, write down what is true."""
        self._vehicle.advance(to_ms)
        self._services.decide()
        if self._vehicle.announcements:
            self._speak()
        self._services.report()
        if self._truth is not None:
            self._truth.write()

    def _speak(self) -> None:
        """Say on stdout, which is the log of a session's vehicle, what STATUSTEXT reports to the others."""
        for severity, text in self._vehicle.announcements:
            with contextlib.suppress(OSError):  # its reader may be gone, or the disk may be full: it flies on
                print(f"vehicle {self._services.sysid}: {self._vehicle.time_s:.1f} s: {severity}: {text}", flush=True)
