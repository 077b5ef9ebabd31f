"""The answer of a vehicle whose tick is usual, and its record of truth, in compiled code.

Messages are telemetry.py's byte for byte: a stream's payload is built there once, and what changes in flight is brought
up to date here. `one` is a row of STEADY.
"""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.libc.string import memcpy
from cython.cimports.simvehicle.mavlink.motion_frames import (
    TURN_DEG,
    bounded,
    heading_cdeg,
    motion_of,
    remainder,
    rounded,
    write_frame,
)
from cython.cimports.simvehicle.mavlink.steady_answer import (
    _ACTIVE,
    _ATTITUDE,
    _BATTERY,
    _CELLS,
    _EFFORT,
    _EXTENDED,
    _GLOBAL,
    _GPS,
    _HEARTBEAT,
    _HOME,
    _IN,
    _IN_AIR,
    _ON_GROUND,
    _ORIGIN,
    _PREARM,
    _STANDBY,
    _STATUS,
    _SYSTEM_TIME_BYTES,
    _TARGET,
    AUTOPILOT,
    PAYLOAD_BYTES,
    STREAM_COUNT,
    SYSTEM_TIME_ID,
    SYSTEM_TIME_SEED,
    TRUTH_NUMBERS,
    a_row,
)
from numpy.typing import NDArray

from simvehicle.autopilot import snapshot
from simvehicle.mavlink import telemetry
from simvehicle.mavlink.codec import schema

"""Of a record of sitl/truth.py, before the thrust of each step."""
FRAMES_BYTES: int
"""More than all frames of one answer."""
"""Room for the payload of each stream."""
STREAMS = tuple(stream.key for stream in telemetry.TELEMETRY)
WRITTEN = frozenset(STREAMS[: _IN + 1])
"""Streams that are written here; a tick in which another one is due is left."""
_FULL_V, _EMPTY_V = snapshot.CELL_FULL_V, snapshot.CELL_EMPTY_V


STEADY = np.asarray(a_row()).dtype
"""Of a vehicle's row, with the fields of the struct Steady."""


def frame_table() -> NDArray[np.int64]:
    """(streams, 3) id, seed of the checksum and payload's size of each stream's message, for `write_answer`."""
    table = np.zeros((len(STREAMS), 3), np.int64)
    for row, stream in zip(table, telemetry.TELEMETRY, strict=True):
        entry = schema(stream.msgid)
        assert entry is not None
        row[:] = entry.msgid, entry.seed[0], entry.packer.size
    return table


def _put(out: Any, at: int, value: int, size: int) -> None:
    for i in range(size):
        out[at + i] = (value >> (8 * i)) & 0xFF


def _put_float(out: Any, at: int, value: float) -> None:
    single = cython.cast(cython.float, value)
    memcpy(out + at, cython.address(single), 4)


def _landed(one: Any, s: Any) -> bool:
    v = s.known.velocity
    still = v[0] == 0.0 and v[1] == 0.0 and v[2] == 0.0
    stands = s.known.contact != 0.0 if one.rotors != 0 else s.known.position[2] <= 0.0 and still
    return one.ground != 0 and stands


def _write_values(one: Any, s: Any, stream: int, payload: Any) -> None:
    """Bring a stream's payload up to date; motion is write_motion's."""
    known = cython.address(s.known)
    unix_us, remaining_j = one.unix_epoch_us + 1000 * one.time_ms, known.remaining_j
    share = min(max(remaining_j / one.capacity_j, 0.0), 1.0)
    voltage_v = _CELLS * (_EMPTY_V + (_FULL_V - _EMPTY_V) * share)
    current = bounded(1e2 * one.power_w / voltage_v, 16)
    if one.rotors != 0:
        voltage_v, current = s.voltage_v, bounded(1e2 * s.current_a, 16)
    percent = rounded(min(max(math.rint(100.0 * remaining_j / one.capacity_j), 0.0), 100.0))
    north, east, down = known.position[0], -known.position[1], -known.position[2]
    v_north, v_east = known.velocity[0], -known.velocity[1]
    if stream == _HEARTBEAT:
        payload[7] = _STANDBY if _landed(one, s) else _ACTIVE
    elif stream == _STATUS:
        health = _number_of(payload, 8) | _PREARM
        if one.checked != 0 and remaining_j < one.floor_j:
            health ^= _PREARM
        _put(payload, 8, health, 4)
        _put(payload, 14, rounded(1e3 * voltage_v), 2)
        _put(payload, 16, current, 2)
        payload[30] = percent
    elif stream == _EXTENDED:
        payload[1] = _ON_GROUND if _landed(one, s) else _IN_AIR
    elif stream == _GPS:
        altitude = bounded(1e3 * (one.origin[2] - down), 32)
        _put(payload, 0, unix_us, 8)
        _put(payload, 8, rounded(1e7 * remainder(one.origin[0] + north * one.origin[3], TURN_DEG)), 4)
        _put(payload, 12, rounded(1e7 * remainder(one.origin[1] + east * one.origin[4], TURN_DEG)), 4)
        _put(payload, 16, altitude, 4)
        _put(payload, 24, bounded(100.0 * math.sqrt(v_north * v_north + v_east * v_east), 16), 2)
        _put(payload, 26, heading_cdeg(elementary.atan2(v_east, v_north)), 2)
        _put(payload, 30, altitude, 4)
    elif stream == _HOME:
        _put(payload, 52, unix_us, 8)
    elif stream == _ORIGIN:
        _put(payload, 12, unix_us, 8)
    elif stream == _BATTERY:
        _put(payload, 0, bounded(1e3 * (known.drawn_j / (_CELLS * _FULL_V) / 3600.0), 32), 4)
        _put(payload, 4, bounded(math.floor(known.drawn_j / 100.0), 32), 4)
        cell_mv = rounded(1e3 * voltage_v / _CELLS)
        for i in range(_CELLS):
            _put(payload, 10 + 2 * i, cell_mv, 2)
        _put(payload, 30, current, 2)
        payload[35] = percent
        left_s = bounded(remaining_j / one.power_w, 32) if one.power_w > 0.0 else 0
        _put(payload, 36, left_s, 4)
    else:
        _put(payload, 0, one.time_ms, 4)
        if stream == _EFFORT:
            _put_float(payload, 4, known.effort)
        elif stream == _TARGET:
            for i in range(3):
                sign = 1.0 if i == 0 else -1.0
                _put_float(payload, 4 + 4 * i, sign * known.reference_position[i])
                _put_float(payload, 16 + 4 * i, sign * known.reference_velocity[i])


def _number_of(payload: Any, at: int) -> int:
    value = 0
    for i in range(4):
        value |= cython.cast(cython.longlong, payload[at + i]) << (8 * i)
    return value


def write_answer(one: Any, s: Any, frames: Any, unix_us: int) -> None:
    """Write what is due, closed by the own SYSTEM_TIME; what is due next is put down."""
    at, out, motion = 0, one.answer, 0
    for stream in range(_IN + 1):
        interval_ms, due_ms = one.interval_ms[stream], one.due_ms[stream]
        if interval_ms != 0 and one.time_ms >= due_ms:
            late_ms = one.time_ms - due_ms
            one.due_ms[stream] = one.time_ms + interval_ms - (late_ms if late_ms < interval_ms else 0)
            if _ATTITUDE <= stream <= _GLOBAL:
                motion |= 1 << (stream - _ATTITUDE)
            else:
                payload = one.payloads + PAYLOAD_BYTES * stream
                _write_values(one, s, stream, payload)
                msgid, seed, size = frames[3 * stream], frames[3 * stream + 1], frames[3 * stream + 2]
                at = write_frame(out, at, payload, size, msgid, seed, one.seq, one.sysid, AUTOPILOT)
                one.seq = (one.seq + 1) & 0xFF
        if stream == _GLOBAL and motion != 0:
            _, _, length = motion_of(
                out + at, cython.address(s.known), one.origin, one.home_down_m, one.time_ms, motion, one.seq, one.sysid,
                AUTOPILOT,
            )  # fmt: skip
            at += length
            one.seq = (one.seq + (motion & 1) + (motion >> 1 & 1) + (motion >> 2)) & 0xFF
    payload = one.payloads + PAYLOAD_BYTES * STREAM_COUNT
    _put(payload, 0, unix_us, 8)
    _put(payload, 8, one.granted_ms, 4)
    one.answer_bytes = write_frame(
        out, at, payload, _SYSTEM_TIME_BYTES, SYSTEM_TIME_ID, SYSTEM_TIME_SEED, one.seq, one.sysid, AUTOPILOT
    )
    one.seq = (one.seq + 1) & 0xFF


def write_truth(one: Any, s: Any, thrust: Any, steps: int, truth: Any) -> None:
    """A record as sitl/truth.py has it, with the thrust of each of some steps."""
    known, motion = cython.address(s.known), cython.cast(cython.p_double, s)
    truth[0], truth[1] = one.time_ms / 1e3, steps
    for i in range(12):
        true = motion[i]
        if one.senses != 0 and (i < 3 or known.contact == 0.0):
            true -= s.error[i]
        truth[2 + i] = true if i % 3 == 0 else -true
    truth[14], truth[15], truth[16], truth[17] = known.drawn_j, one.received_j, one.given_j, known.remaining_j
    for k in range(steps):
        truth[TRUTH_NUMBERS + k] = thrust[k]
