"""ATTITUDE, LOCAL_POSITION_NED and GLOBAL_POSITION_INT of a vehicle in one compiled call, from state to frames.

In most ticks nothing else is due. They are telemetry.py's messages byte for byte, read from the plant's row as
law/step.py lays it out (nwu), not from a gathered `VehicleState`.
"""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.libc.string import memcpy
from cython.cimports.simvehicle.law.rows import state_of
from cython.cimports.simvehicle.mavlink.motion_frames import (
    _ATTITUDE_ID,
    _ATTITUDE_SEED,
    _GLOBAL_ID,
    _GLOBAL_SEED,
    _LOCAL_ID,
    _LOCAL_SEED,
    _PAYLOAD_BYTES,
    ATTITUDE,
    GLOBAL_POSITION,
    HEADER_BYTES,
    LOCAL_POSITION,
    MAGIC,
    TURN_DEG,
)
from numpy.typing import NDArray

"""Bits of the messages that are wanted."""
LARGEST_BYTES: int
"""All three frames."""
_TURN_RAD = 2.0 * math.M_PI


def remainder(x: float, whole: float) -> float:
    """IEEE's remainder, as math.remainder; exact."""
    rest = math.fmod(x, whole)
    if math.fabs(rest) > 0.5 * whole:
        rest -= math.copysign(whole, rest)
    return rest


def bounded(value: float, bits: int) -> int:
    """The nearest number that so many bits hold."""
    limit = math.ldexp(1.0, bits - 1)
    return cython.cast(cython.longlong, min(max(math.rint(value), -limit), limit - 1.0))


def rounded(value: float) -> int:
    """The nearest whole number."""
    return cython.cast(cython.longlong, math.rint(value))


def heading_cdeg(angle_rad: float) -> int:
    """An angle in hundredths of a degree, 0 to 35999."""
    cdeg = rounded(1e2 * (angle_rad * (180.0 / math.M_PI))) % 36000
    return cdeg + 36000 if cdeg < 0 else cdeg


def checksum(frame: Any, start: int, end: int, seed: int) -> int:
    """CRC-16/MCRF4XX of bytes and the message's seed."""
    crc = 0xFFFF
    for i in range(start, end + 1):
        low = (crc & 0xFF) ^ (seed if i == end else frame[i])
        low = (low ^ (low << 4)) & 0xFF
        crc = (crc >> 8) ^ (low << 8) ^ (low << 3) ^ (low >> 4)
    return crc & 0xFFFF


def write_frame(
    out: Any, at: int, payload: Any, size: int, msgid: int, seed: int, seq: int, sysid: int, compid: int
) -> int:
    """Write a frame of a payload of this size, its trailing zeros cut; where it ends."""
    body = at + HEADER_BYTES
    memcpy(out + body, payload, size)
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
    s = state_of(state, 0)
    return motion_of(
        cython.address(out[0]), s, cython.address(origin[0]), home_down_m, time_ms, wanted, seq, sysid, compid
    )


def motion_of(
    out: Any, s: Any, origin: Any, home_down_m: float, time_ms: int, wanted: int, seq: int, sysid: int, compid: int
) -> tuple[int, int, int]:
    """`write_motion` of a state."""
    words = cython.declare(cython.int[7])
    floats, payload = cython.cast(cython.p_float, words), cython.cast("unsigned char *", words)
    north, east, down = s.position[0], -s.position[1], -s.position[2]
    v_north, v_east, v_down = s.velocity[0], -s.velocity[1], -s.velocity[2]
    roll, pitch, yaw = s.attitude[0], s.attitude[1], s.attitude[2]
    roll_rate, pitch_rate, yaw_rate = s.rates[0], s.rates[1], s.rates[2]
    at = 0
    if wanted & ATTITUDE:
        sin_roll, cos_roll = elementary.sin_cos(roll)
        sin_pitch, cos_pitch = elementary.sin_cos(pitch)
        words[0] = time_ms
        floats[1] = remainder(roll, _TURN_RAD)
        floats[2] = remainder(-pitch, _TURN_RAD)
        floats[3] = remainder(-yaw, _TURN_RAD)
        floats[4] = roll_rate - yaw_rate * sin_pitch
        floats[5] = -(pitch_rate * cos_roll + yaw_rate * sin_roll * cos_pitch)
        floats[6] = -(-pitch_rate * sin_roll + yaw_rate * cos_roll * cos_pitch)
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
        words[1] = rounded(1e7 * remainder(origin[0] + north * origin[3], TURN_DEG))
        words[2] = rounded(1e7 * remainder(origin[1] + east * origin[4], TURN_DEG))
        words[3] = bounded(1e3 * (origin[2] - down), 32)
        words[4] = bounded(1e3 * (home_down_m - down), 32)
        words[5] = (bounded(100.0 * v_north, 16) & 0xFFFF) | (bounded(100.0 * v_east, 16) << 16)
        words[6] = (bounded(100.0 * v_down, 16) & 0xFFFF) | (heading_cdeg(-yaw) << 16)
        at = write_frame(out, at, payload, _PAYLOAD_BYTES, _GLOBAL_ID, _GLOBAL_SEED, seq, sysid, compid)
    return first, second, at
