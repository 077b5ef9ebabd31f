"""ATTITUDE, LOCAL_POSITION_NED and GLOBAL_POSITION_INT of a vehicle in one compiled call, from state to frames.

In most ticks nothing else is due. They are telemetry.py's messages byte for byte, read from the plant's row as
law/step.py lays it out (nwu), not from a gathered `VehicleState`.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from simvehicle.kernels import UNCOUNTED, inner, kernel

ATTITUDE, LOCAL_POSITION, GLOBAL_POSITION = 1, 2, 4
"""Bits of the messages that are wanted."""
LARGEST_BYTES = 3 * 40
"""All three frames."""

_PAYLOAD_BYTES = 28  # of each of the three
HEADER_BYTES = 10
_ATTITUDE_ID, _LOCAL_ID, _GLOBAL_ID = 30, 32, 33
_ATTITUDE_SEED, _LOCAL_SEED, _GLOBAL_SEED = 39, 185, 104
MAGIC = 0xFD
_TURN_RAD, TURN_DEG = 2.0 * math.pi, 360.0
DEGREES = 180.0 / math.pi


@inner(**UNCOUNTED)
def remainder(x: float, whole: float) -> float:
    """IEEE's remainder, as math.remainder; exact."""
    rest: float = np.fmod(x, whole)
    if abs(rest) > 0.5 * whole:
        rest -= math.copysign(whole, rest)
    return rest


@inner(**UNCOUNTED)
def bounded(value: float, bits: int) -> int:
    """The nearest number that so many bits hold."""
    limit = 2.0 ** (bits - 1)
    return int(min(max(np.rint(value), -limit), limit - 1.0))


@inner(**UNCOUNTED)
def checksum(frame: NDArray[np.uint8], start: int, end: int, seed: int) -> int:
    """CRC-16/MCRF4XX of bytes and the message's seed."""
    crc = 0xFFFF
    for i in range(start, end + 1):
        low = (crc & 0xFF) ^ (seed if i == end else int(frame[i]))
        low = (low ^ (low << 4)) & 0xFF
        crc = (crc >> 8) ^ (low << 8) ^ (low << 3) ^ (low >> 4)
    return crc & 0xFFFF


@inner(**UNCOUNTED)
def write_frame(
    out: NDArray[np.uint8],
    at: int,
    payload: NDArray[np.uint8],
    size: int,
    msgid: int,
    seed: int,
    seq: int,
    sysid: int,
    compid: int,
) -> int:
    """Write a frame of a payload of this size, its trailing zeros cut; where it ends."""
    body = at + HEADER_BYTES
    for i in range(size):
        out[body + i] = payload[i]
    length = size
    while length > 1 and out[body + length - 1] == 0:
        length -= 1
    out[at], out[at + 1], out[at + 2], out[at + 3] = MAGIC, length, 0, 0
    out[at + 4], out[at + 5], out[at + 6] = seq & 0xFF, sysid, compid
    out[at + 7], out[at + 8], out[at + 9] = msgid & 0xFF, msgid >> 8, 0
    end = body + length
    crc = checksum(out, at + 1, end, seed)
    out[end], out[end + 1] = crc & 0xFF, crc >> 8
    return end + 2


@kernel(error_model="numpy")
def write_motion(
    out: NDArray[np.uint8],
    state: NDArray[np.float64],
    origin: NDArray[np.float64],
    home_down_m: float,
    time_ms: int,
    wanted: int,
    seq: int,
    sysid: int,
    compid: int,
) -> tuple[int, int, int]:
    """Write the wanted frames, one after the other, numbered from `seq` on; where each of the three ends.

    Args:
        out: (LARGEST_BYTES,) at least.
        state: (1, n), the plant's row, nwu, m, m/s, rad, rad/s.
        origin: (5,), latitude and longitude in degrees and height in m of the local frame's origin, degrees per metre
            north and east.
        home_down_m: home in the local frame.
        time_ms: since boot.
        wanted: ATTITUDE | LOCAL_POSITION | GLOBAL_POSITION.
        seq, sysid, compid: number of the first frame, and sender.
    """
    s = state[0]
    words = np.empty(7, np.int32)
    floats, payload = words.view(np.float32), words.view(np.uint8)
    north, east, down = s[0], -s[1], -s[2]
    v_north, v_east, v_down = s[3], -s[4], -s[5]
    roll, pitch, yaw = s[6], s[7], s[8]
    at = 0
    if wanted & ATTITUDE:
        sin_roll, cos_roll, cos_pitch = math.sin(roll), math.cos(roll), math.cos(pitch)
        words[0] = time_ms
        floats[1] = remainder(roll, _TURN_RAD)
        floats[2] = remainder(-pitch, _TURN_RAD)
        floats[3] = remainder(-yaw, _TURN_RAD)
        floats[4] = s[9] - s[11] * math.sin(pitch)
        floats[5] = -(s[10] * cos_roll + s[11] * sin_roll * cos_pitch)
        floats[6] = -(-s[10] * sin_roll + s[11] * cos_roll * cos_pitch)
        at = write_frame(out, at, payload, _PAYLOAD_BYTES, _ATTITUDE_ID, _ATTITUDE_SEED, seq, sysid, compid)
        seq += 1
    first = at
    if wanted & LOCAL_POSITION:
        words[0] = time_ms
        floats[1], floats[2], floats[3] = north, east, down
        floats[4], floats[5], floats[6] = v_north, v_east, v_down
        at = write_frame(out, at, payload, _PAYLOAD_BYTES, _LOCAL_ID, _LOCAL_SEED, seq, sysid, compid)
        seq += 1
    second = at
    if wanted & GLOBAL_POSITION:
        words[0] = time_ms
        words[1] = int(np.rint(1e7 * remainder(origin[0] + north * origin[3], TURN_DEG)))
        words[2] = int(np.rint(1e7 * remainder(origin[1] + east * origin[4], TURN_DEG)))
        words[3] = bounded(1e3 * (origin[2] - down), 32)
        words[4] = bounded(1e3 * (home_down_m - down), 32)
        heading = int(np.rint(1e2 * (-yaw * DEGREES))) % 36000
        words[5] = (bounded(100.0 * v_north, 16) & 0xFFFF) | (bounded(100.0 * v_east, 16) << 16)
        words[6] = (bounded(100.0 * v_down, 16) & 0xFFFF) | (heading << 16)
        at = write_frame(out, at, payload, _PAYLOAD_BYTES, _GLOBAL_ID, _GLOBAL_SEED, seq, sysid, compid)
    return first, second, at
