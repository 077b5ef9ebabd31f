"""A real ArduPilot on our physics, on the supervisor's clock (docs/protocol.md#autopilots-of-others).

This process starts the autopilot, is its simulation, and stands between it and the supervisor: frames of a bundle go
into its serial port before the step that they count for, frames that it says are numbered anew and go into the answer.
Time passes for it only while one of its servo packets is being answered, so a grant ends by keeping an answer back.
"""

from __future__ import annotations

import contextlib
import json
import math
from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.body import STEP_MS
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.snapshot import Vec3
from simvehicle.law import rotor_flight, step
from simvehicle.law.dynamics import ned_from_nwu
from simvehicle.law.params import VehicleParams
from simvehicle.law.plants import RotorPlant
from simvehicle.mavlink import json_backend
from simvehicle.mavlink.analog_battery import AnalogBattery
from simvehicle.mavlink.autopilot_boot import GUIDED, AutopilotBoot
from simvehicle.mavlink.battery_component import BatteryComponent
from simvehicle.mavlink.codec import ReceivedFrame, decode, encode, message
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.lockstep import SUPERVISOR
from simvehicle.mavlink.world_failures import WorldFailures
from simvehicle.sitl.autopilot_link import AutopilotLink
from simvehicle.sitl.autopilot_process import STEP_S, AutopilotError, AutopilotWanted
from simvehicle.sitl.truth import ENERGY, STATE
from simvehicle.world import rotors
from simvehicle.world.airframes import GRAVITY_M_S2

Quaternion = tuple[float, float, float, float]
BOOTS_WITHIN_S = 120.0
"""Of its own time: an ArduCopter with its own parameters needs 40 s."""
_OURS = frozenset({mav.MAVLINK_MSG_ID_SYSTEM_TIME, mav.MAVLINK_MSG_ID_BATTERY_STATUS})
"""Messages of the autopilot's that are left out: an answer ends with a time of its own, and the battery is ours, also
the charge in its SYS_STATUS, which it counts from a full battery of its own."""


class ArduPilotUnit:
    """The autopilot with its physics, as the loops drive it (`loop.Unit`)."""

    def __init__(self, wanted: AutopilotWanted, plant: RotorPlant, connection: Connection) -> None:
        """Start it; raises AutopilotError."""
        self._wanted, self._plant, self._connection = wanted, plant, connection
        flight = VehicleParams(battery=wanted.battery)
        plant.tune(flight)
        north, east, down = wanted.start_ned
        yaw_rad = float(np.radians(wanted.yaw_deg))
        plant.start(
            flight,
            position_nwu=(north, -east, -down),
            velocity_nwu=(0.0, 0.0, 0.0),
            attitude_rad=(0.0, 0.0, -yaw_rad),
            airborne=False,
        )
        self._initial_j = flight.battery.initial_j
        self._battery = BatteryComponent(
            plant,
            wanted.sysid,
            LocalFrame(*wanted.home),
            wanted.envelope,
            capacity_j=flight.battery.capacity_j,
            initial_j=flight.battery.initial_j,
        )
        self._failures = WorldFailures(wanted.sysid, plant.waste)
        self._time_ms: int | None = None
        self._steps = 0
        self._said = 0
        with contextlib.ExitStack() as opened:
            self._link = opened.enter_context(AutopilotLink(wanted))
            self._monitor = AnalogBattery(wanted.sysid, self._boot())
            self._truth = None if wanted.truth is None else opened.enter_context(wanted.truth.open("xb", buffering=0))
            if self._truth is not None:
                self._truth.write(self._truth_head())
            self._closing = opened.pop_all()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._closing.close()

    # loop.Unit

    def hello(self) -> object:
        """A HEARTBEAT in its name, which has booted and waits in GUIDED."""
        base = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
        kind, autopilot = mav.MAV_TYPE_QUADROTOR, mav.MAV_AUTOPILOT_ARDUPILOTMEGA
        return message("HEARTBEAT")(GUIDED, kind, autopilot, base, mav.MAV_STATE_STANDBY, 3)

    def start_clock(self, time_ms: int, unix_us: int) -> None:
        """Begin at the session's time."""
        self._time_ms = time_ms

    def receive(self, frame: ReceivedFrame, connection: Connection) -> None:
        """Say a frame into its serial port, before the next step, unless it concerns its battery or its world."""
        answers = self._battery.receive(frame, self._boot_s, self._p_ned, self._v_ned)
        if answers is None:
            answers = self._failures.receive(frame)
        if answers is not None:
            for content in answers:
                connection.put(content)
            return
        self._link.say(frame.raw)

    def advance(self, to_ms: int) -> None:
        """Answer servo packets up to a time; queue what it has said, and what its battery says."""
        assert self._time_ms is not None
        before_ms = self._time_ms
        for content in self._monitor.settings(self._boot_s, *self._plant.electric):
            self._say(content)
        while to_ms - self._time_ms >= STEP_MS:
            self._answer(self._fly(self._time_ms / 1e3))
            self._time_ms += STEP_MS
        for frame in self._link.received():
            if frame.msgid in _OURS or self._monitor.answers(frame):
                continue
            said: Any = decode(frame)
            if frame.msgid == mav.MAVLINK_MSG_ID_SYS_STATUS:
                said = said._replace(battery_remaining=self._battery.percent)
            self._connection.put(said)
        for content in self._battery.move(self._boot_s, (self._time_ms - before_ms) / 1e3, self._p_ned):
            self._connection.put(content)
        if self._truth is not None:
            self._truth.write(self._truth_record())

    @property
    def _boot_s(self) -> float:
        """Its own time."""
        return self._steps * STEP_S

    @property
    def _p_ned(self) -> Vec3:
        return ned_from_nwu(self._plant.now[rotor_flight.TRUE_POSITION])

    @property
    def _v_ned(self) -> Vec3:
        return ned_from_nwu(self._plant.now[rotor_flight.TRUE_VELOCITY])

    # its simulation

    def _boot(self) -> float:
        """Let it boot where it stands, in a time of its own before the session's, until it would let itself be armed.
        The voltage that it measures. Raises AutopilotError."""
        boot, standing = AutopilotBoot(self._wanted.sysid), np.array([0.0, 0.0, GRAVITY_M_S2])
        while not boot.ready:
            if not boot.is_arducopter:
                kind, autopilot = boot.kind or (0, 0)
                said = f"its HEARTBEAT has type {kind} and autopilot {autopilot}, not 2 and 3"
                raise AutopilotError(f"{self._link.name} is no ArduCopter with four rotors: {said}")
            if self._boot_s >= BOOTS_WITHIN_S:
                why = f": {boot.reasons}" if boot.reasons else self._link.last_lines()
                raise AutopilotError(f"{self._link.name} was not ready in {BOOTS_WITHIN_S:.0f} s of its time{why}")
            for content in boot.requests(self._boot_s):
                self._say(content)
            self._answer(standing)
            for frame in self._link.received():
                boot.receive(frame)
        return boot.volts

    def _say(self, content: Any) -> None:
        """Say a message of ours to it, as the supervisor's."""
        sysid, compid = SUPERVISOR
        self._link.say(encode(content, seq=self._said & 0xFF, sysid=sysid, compid=compid))
        self._said += 1

    def _fly(self, time_s: float) -> NDArray[np.float64]:
        """One step of its body by its servo packet; the force on it but gravity's, per mass, (3,), nwu."""
        plant = self._plant
        throttle = np.array(json_backend.throttles(self._link.servo))
        for motor in self._failures.dead_motors:
            throttle[motor] = 0.0
        before = np.array(plant.now[rotor_flight.TRUE_VELOCITY])
        plant.turn(plant.own.airframe.fastest_rad_s * throttle, time_s=time_s, dt_s=STEP_S)
        force_nwu: NDArray[np.float64] = (np.array(plant.now[rotor_flight.TRUE_VELOCITY]) - before) / STEP_S
        force_nwu[2] += GRAVITY_M_S2
        return force_nwu

    def _answer(self, force_nwu: NDArray[np.float64]) -> None:
        """Answer its servo packet with its motion as it is now, as its sensors have it."""
        now = self._plant.now
        self._steps += 1
        w, x, y, z = now[rotor_flight.TRUE_QUATERNION]
        ax, ay, az = force_nwu.tolist()
        p_ned = _sum(self._p_ned, self._failures.position_error_ned)
        v_ned: Sequence[float] = self._v_ned
        rates: Sequence[float] = ned_from_nwu(now[rotor_flight.BODY_RATES])
        accel: Sequence[float] = ned_from_nwu(rotors.rotated(np.array([w, x, y, z]), ax, ay, az, -1.0))
        quaternion = (w, x, -y, -z)
        errors = self._wanted.sensors.step()
        if errors is not None:
            p_ned, v_ned = _sum(p_ned, errors[0]), _sum(v_ned, errors[1])
            rates, accel = _sum(rates, errors[3]), _sum(accel, errors[4])
            quaternion = _turned(quaternion, errors[2])
        volts, amperes = self._plant.electric
        line = json_backend.answer(
            step=self._steps,
            dt_s=STEP_S,
            rates_body=rates,
            accel_body=accel,
            p_ned=p_ned,
            v_ned=v_ned,
            quaternion=quaternion,
            volts=volts,
            amperes=amperes,
        )
        self._link.answer(line)

    # truth

    def _truth_head(self) -> bytes:
        battery = self._wanted.battery
        head = {
            "schema": 1,
            "sysid": self._wanted.sysid,
            "step_s": STEP_S,
            "state": STATE,
            "energy": ENERGY,
            "initial_j": self._initial_j,
            "capacity_j": battery.capacity_j,
            "hover_w": battery.hover_w,
            "avionics_w": battery.avionics_w,
            "gravity_m_s2": GRAVITY_M_S2,
        }
        return json.dumps(head, sort_keys=True).encode() + b"\n"

    def _truth_record(self) -> bytes:
        assert self._time_ms is not None
        now = self._plant.now
        parts = (slice(0, 3), slice(3, 6), slice(6, 9), slice(9, 12))
        motion = [number for part in parts for number in ned_from_nwu(now[part])]
        drawn_j, left_j = now[step.DRAWN_J], now[step.REMAINING_J]
        received_j = float(self._battery.exchange.received_j)
        record = [self._time_ms / 1e3, 0.0, *motion, drawn_j, received_j, 0.0, left_j]
        return np.array(record, dtype="<f8").tobytes()


def _sum(a: Sequence[float], b: Sequence[float]) -> tuple[float, ...]:
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
    norm = math.hypot(*turned)
    return (turned[0] / norm, turned[1] / norm, turned[2] / norm, turned[3] / norm)
