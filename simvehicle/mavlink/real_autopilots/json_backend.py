"""ArduPilot's JSON interface for a simulation of one's own: its servo packets, and the line that answers one.

A servo packet is `<HHI`, magic, rate and frame count, and 16 or 32 PWM values in µs. The answer is one line of JSON,
with an end of line before and after it: time, IMU, and the true motion in NED from home. Without `no_time_sync` it
would wait for the wall clock. What is not answered is said again, each second, with the same frame count.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import NamedTuple

import msgspec

_PACKET = struct.Struct("<HHI4H")
"""Of a packet what is read: all before its fifth channel."""
_BYTES = {18458: 8 + 2 * 16, 29569: 8 + 2 * 32}
"""Length of a packet by its magic."""
PWM_LEAST_US, PWM_MOST_US = 1000.0, 2000.0
EXTRA_S = 1e-9
"""It cuts times to whole µs: so much more each step keeps them from falling short."""


class ServoPacket(NamedTuple):
    """Wish of the autopilot for its motors: frame count, and throttle of each of the first four, 0 to 1."""

    frame: int
    throttles: tuple[float, float, float, float]


def parse(datagram: bytes) -> ServoPacket | None:
    """A servo packet; None where it is none. Motors that are off have 0 µs."""
    if len(datagram) < _PACKET.size:
        return None
    magic, _, frame, a, b, c, d = _PACKET.unpack_from(datagram)
    if len(datagram) != _BYTES.get(magic):
        return None
    return ServoPacket(frame, (_throttle(a), _throttle(b), _throttle(c), _throttle(d)))


def answer(
    *,
    step: int,
    dt_s: float,
    rates_body: Sequence[float],
    accel_body: Sequence[float],
    p_ned: Sequence[float],
    v_ned: Sequence[float],
    quaternion: Sequence[float],
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


def _throttle(pwm_us: float) -> float:
    throttle = (pwm_us - PWM_LEAST_US) / (PWM_MOST_US - PWM_LEAST_US)
    return 0.0 if throttle <= 0.0 else 1.0 if throttle >= 1.0 else throttle
