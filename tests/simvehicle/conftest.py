"""A vehicle on a bench: its services without a socket, spoken to and read with pymavlink."""

import math
from collections.abc import Callable
from typing import Any

import pytest
from pymavlink.dialects.v20 import common

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.law.plants import Plant
from simvehicle.mavlink.codec import split
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.dispatcher import Services

ORIGIN = (47.397742, 8.545594, 488.0)
SUPERVISOR = (255, 190)
POSITION_ONLY = 3576
BOTH = 3520


class Bench:
    """One vehicle, a period of 100 ms at a time; `heard` is all that it ever sent."""

    def __init__(
        self,
        sysid: int = 1,
        *,
        autopilot: str = "px4",
        params: dict[str, float] | None = None,
        start: Start | None = None,
        store: Any = None,
        log: Any = None,
        plant: Plant | None = None,
    ) -> None:
        self.sysid = sysid
        identity, frame = IDENTITIES[autopilot], LocalFrame(*ORIGIN)
        self.vehicle = Vehicle(identity, Parameters(params), frame, start or Start(), plant)
        self.connection = Connection(sysid)
        self.services = Services(self.vehicle, sysid, [self.connection], store, log=log)
        self.heard: list[Any] = []
        self._parser = common.MAVLink(None)
        self._writers: dict[tuple[int, int], Any] = {}

    def send(self, message: Any, source: tuple[int, int] = SUPERVISOR) -> list[Any]:
        """Let a pymavlink message reach the vehicle; what it answers at once."""
        writer = self._writers.setdefault(source, common.MAVLink(None, *source))
        return self.feed(bytes(message.pack(writer)))

    def feed(self, raw: bytes) -> list[Any]:
        """Let bytes reach the vehicle; what it answers at once."""
        for frame in split(raw):
            self.services.receive(frame, self.connection)
        return self.drain()

    def drain(self) -> list[Any]:
        """Everything that waited to be sent."""
        new = [message for raw in self.connection.frames() for message in self._parser.parse_buffer(raw)]
        self.heard += new
        return new

    def command(
        self,
        command: int,
        *params: float,
        place: tuple[int, int, float] | None = None,
        frame: int = 0,
        target: tuple[int, int] | None = None,
        source: tuple[int, int] = SUPERVISOR,
    ) -> list[Any]:
        """COMMAND_LONG, or COMMAND_INT where `place` (x, y, z as on the wire) is given."""
        system, component = target if target is not None else (self.sysid, 1)
        if place is None:
            filled = (*params, *(0.0 for _ in range(7 - len(params))))
            return self.send(common.MAVLink_command_long_message(system, component, command, 0, *filled), source)
        filled = (*params, *(0.0 for _ in range(4 - len(params))))
        message = common.MAVLink_command_int_message(system, component, frame, command, 0, 0, *filled, *place)
        return self.send(message, source)

    def result(self, command: int, *params: float, **how: Any) -> int:
        """The result of a command that is answered by exactly one COMMAND_ACK to its sender."""
        acks = [m for m in self.command(command, *params, **how) if m.get_type() == "COMMAND_ACK"]
        assert [m.command for m in acks] == [command]
        assert (acks[0].target_system, acks[0].target_component) == how.get("source", SUPERVISOR)
        return int(acks[0].result)

    def set_point(
        self,
        p_ned: tuple[float, float, float] = (0.0, 0.0, 0.0),
        v_ned: tuple[float, float, float] = (0.0, 0.0, 0.0),
        *,
        mask: int = BOTH,
        yaw: float = 0.0,
        yaw_rate: float = 0.0,
        frame: int = 1,
        target: tuple[int, int] | None = None,
    ) -> None:
        """SET_POSITION_TARGET_LOCAL_NED; what the mask ignores is sent as NaN, as strangers do."""
        numbers = [*p_ned, *v_ned, math.nan, math.nan, math.nan, yaw, yaw_rate]
        for bit in range(9):
            if mask & 1 << bit:
                numbers[bit] = math.nan
        system, component = target if target is not None else (self.sysid, 1)
        self.send(common.MAVLink_set_position_target_local_ned_message(0, system, component, frame, mask, *numbers))

    def gcs_heartbeat(self) -> None:
        """A ground station's HEARTBEAT."""
        self.send(common.MAVLink_heartbeat_message(common.MAV_TYPE_GCS, 8, 0, 0, 4, 3))

    def tick(self, periods: int = 1) -> list[Any]:
        """Some periods of 100 ms; what was sent in them."""
        new = []
        for _ in range(periods):
            self.vehicle.advance(self.vehicle.time_ms + 100)
            self.services.report()
            new += self.drain()
        return new

    def fly(
        self,
        seconds: float,
        *,
        gcs: bool = True,
        until: Callable[["Bench"], bool] | None = None,
        **set_point: Any,
    ) -> None:
        """Fly with a ground station's heartbeat and, where one is given, a set point in every period."""
        for _ in range(round(10 * seconds)):
            if gcs:
                self.gcs_heartbeat()
            if set_point:
                self.set_point(**set_point)
            self.tick()
            if until is not None and until(self):
                return
        assert until is None, f"not within {seconds} s; mode {self.vehicle.mode}, at {self.vehicle.p_ned}"

    def arm(self) -> int:
        """MAV_CMD_COMPONENT_ARM_DISARM."""
        return self.result(common.MAV_CMD_COMPONENT_ARM_DISARM, 1.0)

    def in_air(self, height_m: float = 2.5) -> "Bench":
        """Armed, taken off to a height above home and holding there."""
        assert self.arm() == 0
        assert self.vehicle.take_off(height_m)
        self.fly(20.0, until=lambda b: b.vehicle.mode == "hold")
        self.fly(3.0)
        return self

    def in_air_guided(self, height_m: float = 2.5) -> "Bench":
        """In the air as an ArduCopter gets there: GUIDED, arm, take-off to a height in param 7."""
        assert self.result(common.MAV_CMD_DO_SET_MODE, 1.0, 4.0) == 0
        assert self.arm() == 0
        assert self.result(common.MAV_CMD_NAV_TAKEOFF, *[0.0] * 6, height_m) == 0
        self.fly(20.0, until=lambda b: b.vehicle.mode == "guided")
        self.fly(3.0)
        return self

    def offboard(self, p_ned: tuple[float, float, float] = (0.0, 0.0, -2.5)) -> "Bench":
        """In the air and in offboard at a place."""
        self.in_air(-p_ned[2])
        self.set_point(p_ned)
        assert self.result(common.MAV_CMD_DO_SET_MODE, 129.0, 6.0, 0.0) == 0
        self.fly(1.0, p_ned=p_ned)
        return self

    def of(self, kind: str) -> list[Any]:
        """All messages of a type that were ever sent."""
        return [message for message in self.heard if message.get_type() == kind]

    @property
    def texts(self) -> list[str]:
        """Everything that was announced."""
        return [message.text for message in self.of("STATUSTEXT")]

    def ledger_gap_j(self) -> float:
        """initial + received - drawn - given - remaining: 0 but for rounding."""
        v = self.vehicle
        return v.initial_j + v.received_j - v.drawn_j - v.given_j - v.remaining_j


@pytest.fixture(scope="session")  # a function's own would be refused by hypothesis, which runs that function many times
def vehicle_bench() -> type[Bench]:
    """The bench's class: `vehicle_bench(sysid, params=…)` puts a vehicle on it."""
    return Bench
