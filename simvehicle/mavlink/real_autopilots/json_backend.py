"""ArduPilot's JSON interface for a simulation of one's own: its servo packets, and the line that answers one.

A servo packet is `<HHI`, magic, rate and frame count, and 16 or 32 PWM values in µs. The answer is one line of JSON,
with an end of line before and after it: time, IMU, and the true motion in NED from home. Without `no_time_sync` it
would wait for the wall clock. What is not answered is said again, each second, with the same frame count.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import NamedTuple

MAGICS = {18458: 16, 29569: 32}
"""Channels by the packet's magic."""
_HEAD = struct.Struct("<HHI")
ROTORS = 4
PWM_LEAST_US, PWM_MOST_US = 1000.0, 2000.0
EXTRA_S = 1e-9
"""It cuts times to whole µs: so much more each step keeps them from falling short."""


class ServoPacket(NamedTuple):
    """Wish of the autopilot for its motors: frame count, and PWM of the first four, µs."""

    frame: int
    pwm_us: tuple[float, ...]


def parse(datagram: bytes) -> ServoPacket | None:
    """A servo packet; None where it is none."""
    if len(datagram) < _HEAD.size:
        return None
    magic, _, frame = _HEAD.unpack_from(datagram)
    channels = MAGICS.get(magic)
    if channels is None or len(datagram) != _HEAD.size + 2 * channels:
        return None
    return ServoPacket(frame, struct.unpack_from(f"<{ROTORS}H", datagram, _HEAD.size))


def throttles(packet: ServoPacket) -> tuple[float, ...]:
    """Throttle of each of four motors, 0 to 1; motors that are not told to turn have 0 µs."""
    span_us = PWM_MOST_US - PWM_LEAST_US
    return tuple(min(max((pwm_us - PWM_LEAST_US) / span_us, 0.0), 1.0) for pwm_us in packet.pwm_us)


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
    accel, gyro, position = (_numbers(three) for three in (accel_body, rates_body, p_ned))
    line = (
        f'{{"timestamp":{step * (dt_s + EXTRA_S)!r},"imu":{{"gyro":{gyro},"accel_body":{accel}}},"position":{position},'
        f'"quaternion":{_numbers(quaternion)},"velocity":{_numbers(v_ned)},'
        f'"battery":{{"voltage":{volts!r},"current":{amperes!r}}},"no_time_sync":1}}'
    )
    return f"\n{line}\n".encode()


def _numbers(values: Sequence[float]) -> str:
    """Floats as a list of JSON, whose numbers are Python's."""
    return f"[{','.join(map(repr, values))}]"
