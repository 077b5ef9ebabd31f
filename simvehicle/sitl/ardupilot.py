"""A real ArduPilot on our physics, on the supervisor's clock (docs/protocol.md#autopilots-of-others).

This process starts the autopilot, is its simulation, and stands between it and the supervisor: frames of a bundle go
into its serial port before the step that they count for, frames that it says are numbered anew and go into the answer.
Time passes for it only while one of its servo packets is being answered, so a grant ends by keeping an answer back.
"""

from __future__ import annotations

import contextlib
import json
import select
import socket
import subprocess
import time
from typing import Any, Self

import numpy as np
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.body import STEP_MS
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.snapshot import Vec3
from simvehicle.law import rotor_flight, step
from simvehicle.law.dynamics import ned_from_nwu
from simvehicle.law.params import VehicleParams
from simvehicle.law.plants import RotorPlant
from simvehicle.mavlink import json_backend
from simvehicle.mavlink.battery_component import BatteryComponent
from simvehicle.mavlink.codec import CHECKSUM_BYTES, HEADER_BYTES, MAGIC, ReceivedFrame, decode, message, split
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.world_failures import WorldFailures
from simvehicle.sitl.autopilot_process import (
    APART,
    HOST,
    SERIAL_PORT,
    STEP_S,
    AutopilotError,
    AutopilotWanted,
    end,
    simulation_port,
    start,
)
from simvehicle.sitl.truth import ENERGY, STATE
from simvehicle.world import rotors
from simvehicle.world.airframes import GRAVITY_M_S2

READY_WITHIN_S = 20.0
LOOK_EVERY_S = 0.5
SERIAL_BYTES = 65536
LAST_LINES = 5
_OURS = frozenset({mav.MAVLINK_MSG_ID_SYSTEM_TIME, mav.MAVLINK_MSG_ID_BATTERY_STATUS})
"""Messages of the autopilot's that are left out: an answer ends with a time of its own, and the battery is ours."""


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
        self._serial_pending = b""
        self._closing = contextlib.ExitStack()
        with contextlib.ExitStack() as opened:
            self._udp, instance = simulation_port()
            opened.callback(self._udp.close)
            self._process = start(wanted, instance)
            opened.callback(end, self._process)
            self._serial = self._connect(SERIAL_PORT + APART * instance)
            opened.callback(self._serial.close)
            self._peer: Any = None
            self._servo = self._next_servo(-1)
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
        """A HEARTBEAT in its name: it has said none yet."""
        base = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
        kind, autopilot = mav.MAV_TYPE_QUADROTOR, mav.MAV_AUTOPILOT_ARDUPILOTMEGA
        return message("HEARTBEAT")(0, kind, autopilot, base, mav.MAV_STATE_BOOT, 3)

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
        try:
            self._serial.sendall(frame.raw)
        except OSError as error:
            raise self._gone() from error

    def advance(self, to_ms: int) -> None:
        """Answer servo packets up to a time; queue what it has said, and what its battery says."""
        assert self._time_ms is not None
        before_ms = self._time_ms
        while to_ms - self._time_ms >= STEP_MS:
            self._answer()
            self._time_ms += STEP_MS
            self._servo = self._next_servo(self._servo.frame)
            for frame in self._received():
                self._connection.put(frame)
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

    def _answer(self) -> None:
        assert self._time_ms is not None
        plant = self._plant
        throttle = np.array(json_backend.throttles(self._servo))
        for motor in self._failures.dead_motors:
            throttle[motor] = 0.0
        before = np.array(plant.now[rotor_flight.TRUE_VELOCITY])
        wanted_rad_s = plant.own.airframe.fastest_rad_s * throttle
        plant.turn(wanted_rad_s, time_s=self._time_ms / 1e3, dt_s=STEP_S)
        now, self._steps = plant.now, self._steps + 1
        w, x, y, z = now[rotor_flight.TRUE_QUATERNION]
        force_nwu = (np.array(now[rotor_flight.TRUE_VELOCITY]) - before) / STEP_S
        force_nwu[2] += GRAVITY_M_S2
        ax, ay, az = force_nwu.tolist()
        accel_flu = rotors.rotated(np.array([w, x, y, z]), ax, ay, az, -1.0)
        volts, amperes = plant.electric
        line = json_backend.answer(
            step=self._steps,
            dt_s=STEP_S,
            rates_body=ned_from_nwu(now[rotor_flight.BODY_RATES]),
            accel_body=ned_from_nwu(accel_flu),
            p_ned=[p + error for p, error in zip(self._p_ned, self._failures.position_error_ned, strict=True)],
            v_ned=ned_from_nwu(now[rotor_flight.TRUE_VELOCITY]),
            quaternion=(w, x, -y, -z),
            volts=volts,
            amperes=amperes,
        )
        try:
            self._udp.sendto(line, self._peer)
        except OSError as error:
            raise self._gone() from error

    def _next_servo(self, last_frame: int) -> json_backend.ServoPacket:
        """The next servo packet; what it repeats is passed over. A session may stand still: it waits while it lives."""
        deadline_s = time.monotonic() + READY_WITHIN_S if last_frame < 0 else None
        while True:
            if not select.select([self._udp], [], [], LOOK_EVERY_S)[0]:
                self._look()
                if deadline_s is not None and time.monotonic() > deadline_s:
                    raise AutopilotError(f"{self._name} was not ready within {READY_WITHIN_S:.0f} s{self._said()}")
                continue
            datagram, self._peer = self._udp.recvfrom(2048)
            packet = json_backend.parse(datagram)
            if packet is not None and packet.frame != last_frame:
                return packet

    def _received(self) -> list[Any]:
        """Messages that have come through its serial port, which are all that it said before its servo packet."""
        try:
            while True:
                chunk = self._serial.recv(SERIAL_BYTES)
                if not chunk:
                    raise self._gone()
                self._serial_pending += chunk
        except BlockingIOError:
            pass
        except ConnectionError as error:
            raise self._gone() from error
        whole, self._serial_pending = _whole(self._serial_pending)
        mine = (self._wanted.sysid, mav.MAV_COMP_ID_AUTOPILOT1)
        frames = [frame for frame in split(whole) if frame[:2] == mine]
        return [decode(frame) for frame in frames if frame.msgid not in _OURS]

    def _connect(self, port: int) -> socket.socket:
        """Its serial port, which listens soon after its start."""
        deadline_s = time.monotonic() + READY_WITHIN_S
        while True:
            self._look()
            try:
                made = socket.create_connection((HOST, port), timeout=LOOK_EVERY_S)
                made.setblocking(False)
                made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                return made
            except OSError as error:
                if time.monotonic() > deadline_s:
                    said = self._said()
                    raise AutopilotError(
                        f"{self._name} opened no port {port} in {READY_WITHIN_S:.0f} s{said}"
                    ) from error
                time.sleep(0.01)

    # its end

    @property
    def _name(self) -> str:
        return f"the autopilot {self._wanted.program}"

    def _look(self) -> None:
        if self._process.poll() is not None:
            raise self._gone()

    def _gone(self) -> AutopilotError:
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(LOOK_EVERY_S)
        status = self._process.poll()
        how = "has closed its connection" if status is None else f"ended with status {status}"
        if status is not None and status < 0:
            how = f"was killed by signal {-status}"
        return AutopilotError(f"{self._name} {how}{self._said()}")

    def _said(self) -> str:
        """Last lines of its log."""
        try:
            lines = (self._wanted.folder / "autopilot.log").read_text(encoding="utf-8", errors="replace").splitlines()
        except OSError:
            lines = []
        last = [line.strip() for line in lines if line.strip()][-LAST_LINES:]
        return f"; its last lines: {' | '.join(last)}" if last else ", and said nothing"

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


def _whole(content: bytes) -> tuple[bytes, bytes]:
    """Bytes up to the end of the last whole frame, and the rest."""
    at = 0
    while (start := content.find(bytes((MAGIC,)), at)) >= 0:
        if len(content) < start + HEADER_BYTES:
            return content[:start], content[start:]
        end = start + HEADER_BYTES + content[start + 1] + CHECKSUM_BYTES
        if len(content) < end:
            return content[:start], content[start:]
        at = end
    return content, b""
