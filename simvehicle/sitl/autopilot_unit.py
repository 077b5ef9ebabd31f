"""A vehicle that an autopilot of others flies on our physics, on the supervisor's clock
(docs/protocol/autopilots.md#autopilots-of-others).

This process starts the autopilot, is its simulation, and stands between it and the supervisor: frames of a bundle go
to it before the step that they count for, frames that it says are numbered anew and go into the answer. Time passes
for it only while a step is being answered. Kinds of autopilots differ in how a step is sent and what a boot needs.
"""

from __future__ import annotations

import contextlib
import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any, Self

import numpy as np

from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.law import rows
from simvehicle.law.dynamics import ned_from_nwu
from simvehicle.law.params import VehicleParams
from simvehicle.law.plants import BodyMotion, Quaternion, RotorPlant, Vec3
from simvehicle.mavlink.codec import ReceivedFrame, decode, encode, message
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.lockstep import SUPERVISOR
from simvehicle.mavlink.real_autopilots.autopilot_boot import AutopilotBoot, BootMode
from simvehicle.mavlink.real_autopilots.battery_component import BatteryComponent
from simvehicle.mavlink.real_autopilots.given_parameters import GivenParameters
from simvehicle.mavlink.real_autopilots.world_failures import WorldFailures
from simvehicle.sitl.autopilot_process import AutopilotError, AutopilotLink, AutopilotWanted
from simvehicle.sitl.truth import head_line
from simvehicle.sitl.unit import Unit
from simvehicle.world import rotors
from simvehicle.world.airframes import GRAVITY_M_S2
from skytender import elementary
from skytender import mavlink as mav

BOOTS_WITHIN_S = 120.0
"""Of its own time: an ArduCopter with its own parameters needs 40 s."""
OURS = frozenset({mav.MAVLINK_MSG_ID_SYSTEM_TIME, mav.MAVLINK_MSG_ID_BATTERY_STATUS})
"""Messages of the autopilot's that are left out: an answer ends with a time of its own, and the battery is ours, also
the charge in its SYS_STATUS."""


Throttles = tuple[float, ...]


class Sensed:
    """Motion as sensors have it: place, velocity NED, attitude from the body to NED (w first), rates and specific
    force about the body's axes (front, right, down)."""

    p_ned: Vec3
    v_ned: Vec3
    quaternion: Quaternion
    rates_body: Vec3
    accel_body: Vec3


class AutopilotUnit(Unit, ABC):
    """The autopilot with its physics."""

    boot_mode: BootMode
    step_ms: int
    """of its simulation"""

    def __init__(self, wanted: AutopilotWanted, plant: RotorPlant, connection: Connection) -> None:
        """Start it, and let it boot; raises AutopilotError."""
        self._wanted, self._plant, self._connection = wanted, plant, connection
        self._mine = (wanted.sysid, mav.MAV_COMP_ID_AUTOPILOT1)
        flight = VehicleParams(battery=wanted.battery)
        plant.tune(flight)
        north, east, down = wanted.start_ned
        plant.start(
            flight,
            position_nwu=(north, -east, -down),
            velocity_nwu=(0.0, 0.0, 0.0),
            attitude_rad=(0.0, 0.0, -math.radians(wanted.yaw_deg)),
            airborne=False,
        )
        self._fastest_rad_s, self._step_s = plant.own.airframe.fastest_rad_s, self.step_ms / 1e3
        self._frame = LocalFrame(*wanted.home)
        self._battery = BatteryComponent(
            plant,
            wanted.sysid,
            self._frame,
            wanted.envelope,
            capacity_j=flight.battery.capacity_j,
            initial_j=flight.battery.initial_j,
        )
        self._failures = WorldFailures(wanted.sysid, plant.waste)
        self._time_ms: int | None = None
        self._steps = 0
        self._said = 0
        with contextlib.ExitStack() as opened:
            self._traffic: AutopilotLink = opened.enter_context(self._open())
            self._process = self._traffic.process
            self._boot()
            self._truth = None if wanted.truth is None else opened.enter_context(wanted.truth.open("xb", buffering=0))
            if self._truth is not None:
                self._truth.write(head_line(wanted.sysid, wanted.battery, flight.battery.initial_j, GRAVITY_M_S2))
            self._closing = opened.pop_all()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._closing.close()

    # what the loop asks of it

    def hello(self) -> object:
        """A HEARTBEAT in its name, which has booted and waits in its mode."""
        mode, base = self.boot_mode, mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
        kind, state = mav.MAV_TYPE_QUADROTOR, mav.MAV_STATE_STANDBY
        return message("HEARTBEAT")(mode.custom_mode, kind, mode.autopilot, base, state, 3)

    def start_clock(self, time_ms: int, unix_us: int) -> None:
        """Begin at the session's time."""
        self._time_ms = time_ms

    def receive(self, frame: ReceivedFrame, connection: Connection) -> None:
        """Say a frame to it, before the next step, unless it concerns its battery or its world."""
        answers = self._battery.receive(frame, self._boot_s, self._p_ned, self._v_ned)
        if answers is None:
            answers = self._failures.receive(frame)
        if answers is not None:
            for content in answers:
                connection.put(content)
            return
        self._traffic.say(frame.raw)

    def advance(self, to_ms: int) -> None:
        """Fly up to a time; queue what it has said, and what its battery says."""
        assert self._time_ms is not None
        before_ms = self._time_ms
        self._report_battery()
        self._report_failures()
        while to_ms - self._time_ms >= self.step_ms:
            self._answer(self._fly(self._time_ms / 1e3))
            self._time_ms += self.step_ms
        for frame in self._traffic.received():
            if frame.sender != self._mine or frame.msgid in OURS or self._is_answer(frame):
                continue
            said: Any = decode(frame)
            if frame.msgid == mav.MAVLINK_MSG_ID_SYS_STATUS:
                said = said._replace(battery_remaining=self._battery.percent)
            self._connection.put(said)
        for content in self._battery.move(self._boot_s, (self._time_ms - before_ms) / 1e3, self._p_ned):
            self._connection.put(content)
        if self._truth is not None:
            self._truth.write(self._truth_record())

    # what kinds of autopilots differ in

    @abstractmethod
    def _open(self) -> AutopilotLink:
        """Start it."""

    @abstractmethod
    def _throttles(self) -> Throttles:
        """Throttle of each of four motors that it wishes for now, 0 to 1."""

    @abstractmethod
    def _answer(self, accel_body: Vec3) -> None:
        """Tell it a step of its motion, and wait until it has lived through it. `accel_body`: specific force about the
        body's axes, (3,), front, right, down, m/s²."""

    @abstractmethod
    def _report_battery(self) -> None:
        """Let it measure the battery as it is now."""

    def _report_failures(self) -> None:
        """Let it have a failure that the readings of its sensors do not say."""

    def _is_answer(self, frame: ReceivedFrame) -> bool:
        """Whether a frame answers this process, and no other."""
        return False

    def _booted(self, boot: AutopilotBoot) -> None:
        """Learn from a boot that has ended."""

    # its simulation

    @property
    def _boot_s(self) -> float:
        """Its own time."""
        return self._steps * self.step_ms / 1e3

    @property
    def _p_ned(self) -> Vec3:
        return self._plant.body().p_ned

    @property
    def _v_ned(self) -> Vec3:
        return self._plant.body().v_ned

    def _boot(self) -> None:
        """Let it boot where it stands, in a time of its own before the session's, until it would let itself be armed.
        Raises AutopilotError."""
        boot, process = AutopilotBoot(self._wanted.sysid, self.boot_mode), self._process
        quaternion = np.array(self._plant.now[rows.TRUE_QUATERNION])
        standing = ned_from_nwu(rotors.in_body_axes(quaternion, 0.0, 0.0, GRAVITY_M_S2))
        while not boot.ready:
            if boot.mismatch:
                raise AutopilotError(f"{process.name} {boot.mismatch}")
            if self._boot_s >= BOOTS_WITHIN_S:
                why = f": {boot.reasons}" if boot.reasons else process.last_lines()
                raise AutopilotError(f"{process.name} was not ready in {BOOTS_WITHIN_S:.0f} s of its time{why}")
            for content in boot.requests(self._boot_s):
                self._say(content)
            self._answer(standing)
            for frame in self._traffic.received():
                boot.receive(frame)
        self._booted(boot)
        self._read_back(standing)

    def _read_back(self, standing: Vec3) -> None:
        """Ask whether it has taken what it was given. Raises AutopilotError."""
        wanted, began_s = self._wanted, self._boot_s
        bytewise = self.boot_mode.autopilot == mav.MAV_AUTOPILOT_PX4
        given = GivenParameters(wanted.sysid, wanted.parameters, bytewise=bytewise)
        while not given.done:
            for content in given.requests(self._boot_s - began_s):
                self._say(content)
            self._answer(standing)
            for frame in self._traffic.received():
                given.receive(frame)
        if given.not_taken:
            says = "; ".join(
                f"{name}: {why}{wanted.renamed.get(name, '')}" for name, why in sorted(given.not_taken.items())
            )
            raise AutopilotError(f"{self._process.name} has not taken its params: {says}")

    def _say(self, content: Any, sender: tuple[int, int] = SUPERVISOR) -> None:
        """Say a message of ours to it, as the supervisor's or another component's."""
        sysid, compid = sender
        self._traffic.say(encode(content, seq=self._said & 0xFF, sysid=sysid, compid=compid))
        self._said += 1

    def _fly(self, time_s: float) -> Vec3:
        """One step of its body by its throttles; the specific force about its axes, front, right, down, m/s²."""
        wanted = _speeds(self._throttles(), self._fastest_rad_s)
        for motor in self._failures.dead_motors:
            wanted = (*wanted[:motor], 0.0, *wanted[motor + 1 :])
        return self._plant.turn(wanted, time_s, self._step_s)

    def _sense(self, accel: Vec3) -> Sensed:
        """One step of time, and its motion then as its sensors have it, with the specific force about its axes."""
        self._steps += 1
        body: BodyMotion = self._plant.body()
        sensed: Sensed = Sensed.__new__(Sensed)
        sensed.p_ned, sensed.v_ned = _sum(body.p_ned, self._failures.position_error_ned), body.v_ned
        sensed.quaternion, sensed.rates_body, sensed.accel_body = body.quaternion, body.rates_body, accel
        if self._wanted.sensors is not None:
            errors = self._wanted.sensors.step()
            sensed.p_ned, sensed.v_ned = _sum(sensed.p_ned, errors[0]), _sum(sensed.v_ned, errors[1])
            sensed.rates_body, sensed.accel_body = _sum(sensed.rates_body, errors[3]), _sum(accel, errors[4])
            sensed.quaternion = _turned(sensed.quaternion, errors[2])
        return sensed

    # truth

    def _truth_record(self) -> bytes:
        assert self._time_ms is not None
        now = self._plant.now
        parts = (slice(0, 3), slice(3, 6), slice(6, 9), slice(9, 12))
        motion = [number for part in parts for number in ned_from_nwu(now[part])]
        drawn_j, left_j = now[rows.DRAWN_J], now[rows.REMAINING_J]
        received_j = float(self._battery.exchange.received_j)
        record = [self._time_ms / 1e3, 0.0, *motion, drawn_j, received_j, 0.0, left_j]
        return np.array(record, dtype="<f8").tobytes()


def _speeds(throttles: Throttles, fastest_rad_s: float) -> Throttles:
    """Speeds of four rotors by their throttles, rad/s."""
    a, b, c, d = throttles
    return (fastest_rad_s * a, fastest_rad_s * b, fastest_rad_s * c, fastest_rad_s * d)


def _sum(a: Sequence[float], b: Sequence[float]) -> Vec3:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def _turned(quaternion: Quaternion, angles: Sequence[float]) -> Quaternion:
    """A unit quaternion from the body's axes, turned by small angles (3,), rad, about them: q ⊗ (1, φ/2), normed."""
    w, x, y, z = quaternion
    a, b, c = (0.5 * angle for angle in angles)
    turned = (
        w - x * a - y * b - z * c,
        w * a + x + y * c - z * b,
        w * b - x * c + y + z * a,
        w * c + x * b - y * a + z,
    )
    norm = elementary.norm(turned)
    return (turned[0] / norm, turned[1] / norm, turned[2] / norm, turned[3] / norm)
