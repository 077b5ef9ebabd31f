"""ArduPilot's JSON interface for a simulation of one's own: its servo packets, and the line that answers one.

A servo packet is `<HHI`, magic, rate and frame count, and 16 or 32 PWM values in µs. The answer is one line of JSON,
with an end of line before and after it: time, IMU, and the true motion in NED from home. Without `no_time_sync` it
would wait for the wall clock. What is not answered is said again, each second, with the same frame count.
"""

from __future__ import annotations

from typing import Any

import cython
import msgspec
from cython.cimports.cpython.bytes import PyBytes_AS_STRING
from cython.cimports.libc.string import memcpy
from cython.cimports.simvehicle.mavlink.real_autopilots.json_backend import (
    PACKET_16,
    PACKET_16_BYTES,
    PACKET_32,
    PACKET_32_BYTES,
    Packet,
    Servo,
)

Vec3 = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
Throttles = tuple[float, float, float, float]
ServoPacket = tuple[int, Throttles]
"""Wish of the autopilot for its motors: frame count, and throttle of each of the first four, 0 to 1."""
PWM_LEAST_US, PWM_MOST_US = 1000.0, 2000.0
EXTRA_S = 1e-9
"""It cuts times to whole µs: so much more each step keeps them from falling short."""


def parse(datagram: bytes) -> ServoPacket | None:
    """A servo packet; None where it is none. Motors that are off have 0 µs."""
    servo = cython.declare(Servo)
    if not read(PyBytes_AS_STRING(datagram), len(datagram), cython.address(servo)):
        return None
    return servo.frame, throttles_of(cython.address(servo))


def read(data: Any, size: int, servo: Any) -> bool:
    """Read a servo packet of `size` octets; whether it is one."""
    packet = cython.declare(Packet)
    if size not in (PACKET_16_BYTES, PACKET_32_BYTES):
        return False
    memcpy(cython.address(packet), data, cython.sizeof(Packet))
    if packet.magic != (PACKET_16 if size == PACKET_16_BYTES else PACKET_32):
        return False
    servo.frame = packet.frame
    for motor in range(4):
        throttle = (packet.pwm_us[motor] - PWM_LEAST_US) / (PWM_MOST_US - PWM_LEAST_US)
        servo.throttles[motor] = 0.0 if throttle <= 0.0 else 1.0 if throttle >= 1.0 else throttle
    return True


def throttles_of(servo: Any) -> Throttles:
    """Throttle of each motor."""
    a = servo.throttles
    return a[0], a[1], a[2], a[3]


def answer(
    step: int,
    dt_s: float,
    rates_body: Vec3,
    accel_body: Vec3,
    p_ned: Vec3,
    v_ned: Vec3,
    quaternion: Quaternion,
    volts: float,
    amperes: float,
) -> bytes:
    """Line that ends a step: rates in rad/s and specific force in m/s² about the body's axes (front, right, down),
    place and velocity in NED, the quaternion from the body's axes to NED, w first."""
    said = {
        "timestamp": step * (dt_s + EXTRA_S),
        "imu": {"gyro": rates_body, "accel_body": accel_body},
        "position": p_ned,
        "quaternion": quaternion,
        "velocity": v_ned,
        "battery": {"voltage": volts, "current": amperes},
        "no_time_sync": 1,
    }
    return b"\n%b\n" % msgspec.json.encode(said)
