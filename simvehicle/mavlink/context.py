"""Context of every microservice of a vehicle: the vehicle, its connections, its store, and the way to answer."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple, Protocol

from simvehicle.autopilot.modes import Severity
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.mavlink.codec import ReceivedFrame
from simvehicle.mavlink.commands import VehicleCommand
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.services.events import EventService

COMPLAIN_EVERY_S = 5.0


class Store(Protocol):
    """Storage of parameters and plans over a reboot; a plan is rows by MAV_MISSION_TYPE (`plan_items.row_of`). What it
    cannot write it does not have: its functions raise OSError with the name of the file."""

    plans: dict[int, tuple[tuple[float, ...], ...]]

    def keep(self, name: str, value: float) -> None:
        """Keep a value that was changed."""

    def keep_plan(self, kind: int, rows: Iterable[tuple[float, ...]]) -> None:
        """Keep a plan that was taken."""


def unwritten(error: OSError) -> str:
    """Words for a file of a store that could not be written."""
    return f"cannot write {error.filename}: {error.strerror}"


class ServiceContext:
    """One vehicle's, shared by its microservices and its connections."""

    def __init__(self, vehicle: Vehicle, sysid: int, connections: list[Connection], store: Store | None) -> None:
        self.vehicle = vehicle
        self.sysid = sysid
        self.connections = connections
        self.store = store
        self.events = EventService(vehicle)
        self.after_ack: list[Any] = []
        self._complained_s: dict[str, float] = {}

    def complain(self, about: str, text: str) -> None:
        """Warn by STATUSTEXT, but not about the same kind of thing all the time."""
        if self.vehicle.time_s - self._complained_s.get(about, -math.inf) >= COMPLAIN_EVERY_S:
            self._complained_s[about] = self.vehicle.time_s
            self.vehicle.announce(Severity.WARNING, text)

    def set_rate(self, key: str, rate_hz: float) -> None:
        """Send a stream at another rate on every connection."""
        for connection in self.connections:
            connection.streams.set_rate(key, rate_hz, self.vehicle.time_ms)


class Call(NamedTuple):
    """A message that came: its content, the frame it stood in, and the connection to answer on."""

    content: Any
    frame: ReceivedFrame
    connection: Connection

    @property
    def sender(self) -> tuple[int, int]:
        """System and component that sent it."""
        return self.frame.sysid, self.frame.compid


MessageHandler = Callable[[ServiceContext, Call], None]
CommandHandler = Callable[[ServiceContext, VehicleCommand, Connection], int]
