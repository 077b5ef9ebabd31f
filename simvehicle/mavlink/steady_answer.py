"""The answer of a vehicle whose tick is usual, and its record of truth, in compiled code.

Messages are telemetry.py's byte for byte: a stream's payload is built there once, and what changes in flight is brought
up to date here. `one` is a row of steady_tick.py's STEADY.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot import snapshot
from simvehicle.kernels import UNCOUNTED, inner
from simvehicle.law import step
from simvehicle.law.rotor_flight import CURRENT_A, ERROR, VOLTAGE_V
from simvehicle.mavlink import telemetry
from simvehicle.mavlink.codec import schema
from simvehicle.mavlink.motion_frames import DEGREES, TURN_DEG, bounded, remainder, write_frame, write_motion

TRUTH_NUMBERS = 18
"""Of a record of sitl/truth.py, before the thrust of each step."""
FRAMES_BYTES = 1024
"""More than all frames of one answer."""
AUTOPILOT = 1
SYSTEM_TIME_ID, SYSTEM_TIME_SEED, _SYSTEM_TIME_BYTES = 2, 137, 12

STREAMS = tuple(stream.key for stream in telemetry.TELEMETRY)
_HEARTBEAT, _STATUS, _EXTENDED, _ATTITUDE, _LOCAL, _GLOBAL = (
    STREAMS.index(key)
    for key in (
        "HEARTBEAT",
        "SYS_STATUS",
        "EXTENDED_SYS_STATE",
        "ATTITUDE",
        "LOCAL_POSITION_NED",
        "GLOBAL_POSITION_INT",
    )
)
_GPS, _HOME, _ORIGIN, _BATTERY, _TARGET, _EFFORT, _OUT, _IN = (
    STREAMS.index(key)
    for key in (
        *("GPS_RAW_INT", "HOME_POSITION", "GPS_GLOBAL_ORIGIN", "BATTERY_STATUS"),
        *("POSITION_TARGET_LOCAL_NED", "CtlEffort", "XferOut", "XferIn"),
    )
)
WRITTEN = frozenset(STREAMS[: _IN + 1])
"""Streams that are written here; a tick in which another one is due is left."""
PAYLOAD_BYTES = 64
_STANDBY, _ACTIVE = int(mav.MAV_STATE_STANDBY), int(mav.MAV_STATE_ACTIVE)
_ON_GROUND, _IN_AIR = int(mav.MAV_LANDED_STATE_ON_GROUND), int(mav.MAV_LANDED_STATE_IN_AIR)
_PREARM = int(mav.MAV_SYS_STATUS_PREARM_CHECK)
_CELLS, _FULL_V, _EMPTY_V = snapshot.CELLS, snapshot.CELL_FULL_V, snapshot.CELL_EMPTY_V
_ERROR = ERROR.start
_X, _V, _REF_X, _REF_V = (
    part.start for part in (step.POSITION, step.VELOCITY, step.REFERENCE_POSITION, step.REFERENCE_VELOCITY)
)


def frame_table() -> NDArray[np.int64]:
    """(streams, 3) id, seed of the checksum and payload's size of each stream's message, for `write_answer`."""
    table = np.zeros((len(STREAMS), 3), np.int64)
    for row, stream in zip(table, telemetry.TELEMETRY, strict=True):
        entry = schema(stream.msgid)
        assert entry is not None
        row[:] = entry.msgid, entry.seed[0], entry.packer.size
    return table


@inner(**UNCOUNTED)
def _put(out: NDArray[np.uint8], at: int, value: int, size: int) -> None:
    for i in range(size):
        out[at + i] = (value >> (8 * i)) & 0xFF


@inner(**UNCOUNTED)
def _put_float(out: NDArray[np.uint8], at: int, value: float) -> None:
    _put(out, at, int(np.float32(value).view(np.uint32)), 4)


@inner(**UNCOUNTED)
def _landed(one: Any, s: NDArray[np.float64]) -> bool:
    still = s[_V] == 0.0 and s[_V + 1] == 0.0 and s[_V + 2] == 0.0
    stands = s[step.CONTACT] != 0.0 if one.rotors != 0 else s[_X + 2] <= 0.0 and still
    return bool(one.ground != 0 and stands)


@inner(**UNCOUNTED)
def _write_values(one: Any, s: NDArray[np.float64], stream: int, payload: NDArray[np.uint8]) -> None:
    """Bring a stream's payload up to date; motion is write_motion's."""
    unix_us, remaining_j = one.unix_epoch_us + 1000 * one.time_ms, s[step.REMAINING_J]
    share = min(max(remaining_j / one.capacity_j, 0.0), 1.0)
    voltage_v = _CELLS * (_EMPTY_V + (_FULL_V - _EMPTY_V) * share)
    current = bounded(1e2 * one.power_w / voltage_v, 16)
    if one.rotors != 0:
        voltage_v, current = s[VOLTAGE_V], bounded(1e2 * s[CURRENT_A], 16)
    percent = int(min(max(np.rint(100.0 * remaining_j / one.capacity_j), 0.0), 100.0))
    north, east, down, v_north, v_east = s[_X], -s[_X + 1], -s[_X + 2], s[_V], -s[_V + 1]
    if stream == _HEARTBEAT:
        payload[7] = _STANDBY if _landed(one, s) else _ACTIVE
    elif stream == _STATUS:
        health = _number_of(payload, 8) | _PREARM
        if one.checked != 0 and remaining_j < one.floor_j:
            health ^= _PREARM
        _put(payload, 8, health, 4)
        _put(payload, 14, int(np.rint(1e3 * voltage_v)), 2)
        _put(payload, 16, current, 2)
        payload[30] = percent
    elif stream == _EXTENDED:
        payload[1] = _ON_GROUND if _landed(one, s) else _IN_AIR
    elif stream == _GPS:
        altitude = bounded(1e3 * (one.origin[2] - down), 32)
        _put(payload, 0, unix_us, 8)
        _put(payload, 8, int(np.rint(1e7 * remainder(one.origin[0] + north * one.origin[3], TURN_DEG))), 4)
        _put(payload, 12, int(np.rint(1e7 * remainder(one.origin[1] + east * one.origin[4], TURN_DEG))), 4)
        _put(payload, 16, altitude, 4)
        _put(payload, 24, bounded(100.0 * math.sqrt(v_north * v_north + v_east * v_east), 16), 2)
        _put(payload, 26, int(np.rint(1e2 * (math.atan2(v_east, v_north) * DEGREES))) % 36000, 2)
        _put(payload, 30, altitude, 4)
    elif stream == _HOME:
        _put(payload, 52, unix_us, 8)
    elif stream == _ORIGIN:
        _put(payload, 12, unix_us, 8)
    elif stream == _BATTERY:
        _put(payload, 0, bounded(1e3 * (s[step.DRAWN_J] / (_CELLS * _FULL_V) / 3600.0), 32), 4)
        _put(payload, 4, bounded(math.floor(s[step.DRAWN_J] / 100.0), 32), 4)
        cell_mv = int(np.rint(1e3 * voltage_v / _CELLS))
        for i in range(_CELLS):
            _put(payload, 10 + 2 * i, cell_mv, 2)
        _put(payload, 30, current, 2)
        payload[35] = percent
        left_s = bounded(remaining_j / one.power_w, 32) if one.power_w > 0.0 else 0
        _put(payload, 36, left_s, 4)
    else:
        _put(payload, 0, one.time_ms, 4)
        if stream == _EFFORT:
            _put_float(payload, 4, s[step.EFFORT])
        elif stream == _TARGET:
            for i in range(3):
                sign = 1.0 if i == 0 else -1.0
                _put_float(payload, 4 + 4 * i, sign * s[_REF_X + i])
                _put_float(payload, 16 + 4 * i, sign * s[_REF_V + i])


@inner(**UNCOUNTED)
def _number_of(payload: NDArray[np.uint8], at: int) -> int:
    value = 0
    for i in range(4):
        value |= int(payload[at + i]) << (8 * i)
    return value


@inner(error_model="numpy")
def write_answer(one: Any, s: NDArray[np.float64], frames: NDArray[np.int64], unix_us: int) -> None:
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
                payload = one.payloads[PAYLOAD_BYTES * stream : PAYLOAD_BYTES * (stream + 1)]
                _write_values(one, s, stream, payload)
                msgid, seed, size = frames[stream, 0], frames[stream, 1], frames[stream, 2]
                at = write_frame(out, at, payload, size, msgid, seed, one.seq, one.sysid, AUTOPILOT)
                one.seq = (one.seq + 1) & 0xFF
        if stream == _GLOBAL and motion != 0:
            _, _, length = write_motion(
                out[at:], s.reshape(1, s.size), one.origin, one.home_down_m, one.time_ms, motion, one.seq, one.sysid,
                AUTOPILOT,
            )  # fmt: skip
            at += length
            one.seq = (one.seq + (motion & 1) + (motion >> 1 & 1) + (motion >> 2)) & 0xFF
    payload = one.payloads[PAYLOAD_BYTES * len(STREAMS) :]
    _put(payload, 0, unix_us, 8)
    _put(payload, 8, one.granted_ms, 4)
    one.answer_bytes = write_frame(
        out, at, payload, _SYSTEM_TIME_BYTES, SYSTEM_TIME_ID, SYSTEM_TIME_SEED, one.seq, one.sysid, AUTOPILOT
    )
    one.seq = (one.seq + 1) & 0xFF


@inner(**UNCOUNTED)
def write_truth(one: Any, s: NDArray[np.float64], thrust: NDArray[np.float64], truth: NDArray[np.float64]) -> None:
    """A record as sitl/truth.py has it."""
    truth[0], truth[1] = one.time_ms / 1e3, thrust.size
    for i in range(12):
        true = s[i]
        if one.senses != 0 and (i < 3 or s[step.CONTACT] == 0.0):
            true -= s[_ERROR + i]
        truth[2 + i] = true if i % 3 == 0 else -true
    truth[14], truth[15], truth[16], truth[17] = s[step.DRAWN_J], one.received_j, one.given_j, s[step.REMAINING_J]
    for k in range(thrust.size):
        truth[TRUTH_NUMBERS + k] = thrust[0, k]
