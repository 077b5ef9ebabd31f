"""A vehicle with its MAVLink services and its truth, as the loops drive it."""

from __future__ import annotations

import contextlib

from simvehicle.autopilot.body import STEP_MS
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.mavlink.codec import ReceivedFrame
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.dispatcher import Services
from simvehicle.mavlink.telemetry import heartbeat
from simvehicle.sitl.truth import TruthWriter


class VehicleUnit:
    """One vehicle in a loop of `process`."""

    def __init__(self, vehicle: Vehicle, services: Services, truth: TruthWriter | None) -> None:
        self._vehicle = vehicle
        self._services = services
        self._truth = truth

    def hello(self) -> object:
        """The vehicle's HEARTBEAT."""
        return heartbeat(self._vehicle.snapshot())

    def start_clock(self, time_ms: int, unix_us: int) -> None:
        """Set the vehicle's clock without a step."""
        self._vehicle.set_clock(time_ms, unix_us)

    def receive(self, frame: ReceivedFrame, connection: Connection) -> None:
        """Hand a frame to the services."""
        self._services.receive(frame, connection)

    def advance(self, to_ms: int) -> None:
        """Fly to a time, queue what became due, write down what is true."""
        before_ms = self._vehicle.time_ms
        self._vehicle.advance(to_ms)
        self._services.decide()
        self._speak()
        self._services.report()
        if self._truth is not None:
            self._truth.write(self._vehicle, (self._vehicle.time_ms - before_ms) // STEP_MS)

    def _speak(self) -> None:
        """Say on stdout, which is the log of a session's vehicle, what STATUSTEXT reports to the others."""
        for severity, text in self._vehicle.announcements:
            with contextlib.suppress(OSError):  # its reader may be gone, or the disk may be full: it flies on
                print(f"vehicle {self._services.sysid}: {self._vehicle.time_s:.1f} s: {severity}: {text}", flush=True)
