"""Truth of a vehicle, step by step, beside its telemetry: `vehicles/SYSID.truth`.

The file begins with one JSON line: {"schema": 1, "sysid": N, "step_s": 0.004, "state": [...], ...}. Then come records
of little-endian float64, one per grant:

    T (s), number of steps n, 12 states (p, v in NED; roll, pitch, yaw and their rates in NED), drawn, received, given,
    remaining (J, each an accumulator of its own), then the thrust u1 (m/s2) of each of the n steps.

At a rate of its own n is 0. It is also the vehicle's log, as others download it (`mavlink/log_protocol.py`).
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, Self

import cython
from cython.cimports.cpython.bytearray import PyByteArray_AS_STRING
from cython.cimports.cpython.bytes import PyBytes_AS_STRING
from cython.cimports.cpython.exc import PyErr_SetFromErrno
from cython.cimports.libc.errno import EINTR, errno
from cython.cimports.libc.string import memcpy
from cython.cimports.posix.unistd import write
from cython.cimports.simvehicle.autopilot.body import STEP_MS
from cython.cimports.simvehicle.sitl.truth import FIXED_NUMBERS, MOTION

from simvehicle.law.params import BatteryParams

ROUNDING_S = 1e-6
STATE = ["n", "e", "d", "vn", "ve", "vd", "roll", "pitch", "yaw", "roll_rate", "pitch_rate", "yaw_rate"]
LAST_NUMBER = 65534
"""65535 is no log but the end of a list that is asked for."""
ENERGY = ["drawn_j", "received_j", "given_j", "remaining_j"]


def head_line(sysid: int, battery: BatteryParams, initial_j: float, gravity_m_s2: float) -> bytes:
    """The file's first line; `initial_j`: in the battery at the start."""
    head = {
        "schema": 1,
        "sysid": sysid,
        "step_s": STEP_MS / 1e3,
        "state": STATE,
        "energy": ENERGY,
        "initial_j": initial_j,
        "capacity_j": battery.capacity_j,
        "hover_w": battery.hover_w,
        "avionics_w": battery.avionics_w,
        "gravity_m_s2": gravity_m_s2,
    }
    return json.dumps(head, sort_keys=True).encode() + b"\n"


class TruthWriter:
    """Writes one vehicle's truth; every record is whole on disk before the answer that reports it goes out."""

    number: int
    """of the present log"""
    _vehicle: Any
    _file: Any
    _fd: int
    _room: bytearray
    _path: Path
    _head: bytes
    _period_s: float
    _due_s: float
    _written: int
    _begun_ms: int
    _begun_at: int

    def __init__(self, path: Path, sysid: int, vehicle: Any, hz: float | None = None) -> None:
        """`hz`: records a second, which have no thrust; without it one per grant. The file is made by its context."""
        self._room = bytearray(8 * FIXED_NUMBERS)
        self._period_s = 0.0 if hz is None else 1.0 / hz
        self._due_s = 0.0
        flight = vehicle.plant.parameters(vehicle.parameters.flight())
        self._path = path
        self._head = head_line(sysid, flight.battery, vehicle.initial_j, flight.airframe.gravity_m_s2)
        self._written = 0
        self._vehicle = vehicle
        self._begun_ms = 0
        self._begun_at = len(self._head)
        self.number = 1

    @property
    def unix_s(self) -> int:
        """When the present log began, by the vehicle's clock."""
        return (self._vehicle.unix_epoch_us + 1000 * self._begun_ms) // 1_000_000

    @property
    def size_bytes(self) -> int:
        """Bytes of the present log: the head, and the records since it began."""
        return len(self._head) + self._written - self._begun_at

    def read(self, offset: int, count: int) -> bytes:
        """Bytes of the present log from a place on, as many as there are of `count`. Raises OSError."""
        head = self._head[offset : offset + count]
        at = self._begun_at + max(offset - len(self._head), 0)
        return head + os.pread(self._file.fileno(), min(count - len(head), max(self._written - at, 0)), at)

    def erase(self) -> None:
        """Let a new log begin here, with the same head; the file, which a session judges by, stays as it is."""
        self.number = self.number % LAST_NUMBER + 1
        self._begun_ms, self._begun_at = self._vehicle.time_ms, self._written

    def write(self) -> None:
        """One record at the vehicle's present time, if it is due, with the thrust of the flight to it. Raises
        OSError."""
        motion, v = cython.declare(cython.double[MOTION]), self._vehicle
        steps, now_s = v.steps, v.time_ms / 1e3
        if self._period_s > 0.0:
            if now_s < self._due_s - ROUNDING_S:
                return
            self._due_s = max(self._due_s + self._period_s, now_s)
            steps = 0
        if FIXED_NUMBERS + steps > len(self._room) // 8:
            self._room = bytearray(8 * (FIXED_NUMBERS + steps))
        record = cython.cast(cython.p_double, PyByteArray_AS_STRING(self._room))
        v.plant.true_motion(motion)
        record[0], record[1] = now_s, steps
        for i in range(MOTION):
            record[2 + i] = motion[i] if i % 3 == 0 else -motion[i]
        record[14], record[15] = v.plant.row.drawn_j, v.exchange.received_j
        record[16], record[17] = v.exchange.given_j, v.plant.row.remaining_j
        memcpy(record + FIXED_NUMBERS, v.thrust, 8 * steps)
        self._put(cython.cast("const char *", record), 8 * (FIXED_NUMBERS + steps))

    def _put(self, content: Any, size: int) -> None:
        """Write all of it: a disk that is nearly full takes a part first and complains at the rest."""
        while size > 0:
            taken = write(self._fd, content, size)
            if taken < 0 and errno != EINTR:
                PyErr_SetFromErrno(OSError)
            taken = max(taken, 0)
            self._written += taken
            content, size = content + taken, size - taken

    def __enter__(self) -> Self:
        self._file = self._path.open("x+b", buffering=0)
        self._fd = self._file.fileno()
        self._put(PyBytes_AS_STRING(self._head), len(self._head))
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()
