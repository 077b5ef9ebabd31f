"""The compiled loop of a process of supervised vehicles: wait for a datagram, fly it, write truth down, answer.

It makes the system's calls itself, so that nothing of the interpreter runs in a usual tick, and ends with the first
datagram that is not usual.
"""

from __future__ import annotations

import socket
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from simvehicle.kernels import UNCOUNTED, external, inner, kernel
from simvehicle.mavlink import steady_tick
from simvehicle.sitl.truth import FIXED_NUMBERS, ROUNDING_S

DATAGRAMS = 64
"""So many are taken before the interpreter has its turn: signals wait for it."""

LOOK_NS = 500_000
"""For so long the next datagram is looked for, where the last came as soon, and the processor left to others in
between: to be woken from sleep costs a vehicle and its supervisor more than most of a tick."""
CROWDED_NS = 1_300_000
"""After so long without the processor that was left to others, sleep is better: to be woken gives it back at once."""
SLEEPS, MOST_SLEEPS, UNDISTURBED = 50, 3200, 200
"""So many waits are slept through then; twice as many as the last time, up to a most, where fewer waits than those of
the last number were looked through in between."""
_SECONDS, _NANOSECONDS, LAST_NS, SLEEPS_LEFT, _SLEPT, _LOOKED = range(6)
WAITS = 6
"""Numbers that the loop keeps of its waits: room for a time; how long the last one was; how many are to be slept
through; how many were to be, and were looked through since."""

_recv = external("recv", "intp", "int32", "uintp", "uintp", "int32")
_send = external("send", "intp", "int32", "uintp", "uintp", "int32")
_write = external("write", "intp", "int32", "uintp", "uintp")
_sched_yield = external("sched_yield", "int32")
_clock_gettime = external("clock_gettime", "int32", "int32", "uintp")
_MONOTONIC = int(time.CLOCK_MONOTONIC)
_DONTWAIT = int(socket.MSG_DONTWAIT)


@inner(**UNCOUNTED)
def _now_ns(waits: NDArray[np.int64]) -> int:
    _clock_gettime(_MONOTONIC, waits.ctypes.data)
    return int(waits[_SECONDS]) * 1_000_000_000 + int(waits[_NANOSECONDS])


@inner(**UNCOUNTED)
def _go_on_with_sleep(waits: NDArray[np.int64]) -> None:
    again = waits[_SLEPT] > 0 and waits[_LOOKED] < UNDISTURBED
    waits[_SLEPT] = min(2 * waits[_SLEPT], MOST_SLEEPS) if again else SLEEPS
    waits[SLEEPS_LEFT], waits[_LOOKED] = waits[_SLEPT], 0


@inner(**UNCOUNTED)
def _received(fd: int, buffer: NDArray[np.uint8], waits: NDArray[np.int64]) -> int:
    """Wait for a datagram: its bytes, or none above 0."""
    begun_ns = now_ns = _now_ns(waits)
    have = -1
    if waits[SLEEPS_LEFT] > 0:
        waits[SLEEPS_LEFT] -= 1
    elif waits[LAST_NS] < LOOK_NS:
        waits[_LOOKED] += 1
        while have < 0 and now_ns - begun_ns < LOOK_NS:
            have = _recv(fd, buffer.ctypes.data, buffer.size, _DONTWAIT)
            if have < 0:
                _sched_yield()
                left_ns, now_ns = now_ns, _now_ns(waits)
                if now_ns - left_ns >= CROWDED_NS:
                    _go_on_with_sleep(waits)
    if have < 0:
        have = _recv(fd, buffer.ctypes.data, buffer.size, 0)
        now_ns = _now_ns(waits)
    waits[LAST_NS] = now_ns - begun_ns
    return have


@inner(**UNCOUNTED)
def _written_down(one: Any, record: NDArray[np.float64]) -> bool:
    """Write a record of truth, if there is to be one; False where not all of it was taken."""
    if one.truth_fd < 0:
        return True
    numbers = FIXED_NUMBERS + int(record[1])
    if one.truth_period_s > 0.0:
        if record[0] < one.truth_due_s - ROUNDING_S:
            return True
        one.truth_due_s = max(one.truth_due_s + one.truth_period_s, record[0])
        record[1], numbers = 0.0, FIXED_NUMBERS
    one.truth_taken = max(_write(one.truth_fd, record.ctypes.data, 8 * numbers), 0)
    one.truth_bytes += one.truth_taken
    return bool(one.truth_taken == 8 * numbers)


def _compiled(build: int) -> Callable[..., Any]:
    """The entry point; `build` is a checksum of what is compiled into it, as in law/step.py."""

    @kernel(error_model="numpy", nogil=True)
    def serve(
        fd: int,
        have: int,
        at: int,
        others: int,
        many: int,
        first: int,
        written: int,
        buffer: NDArray[np.uint8],
        marked: bool,
        row_of: NDArray[np.int64],
        rows: NDArray[Any],
        states: NDArray[np.float64],
        parameters: NDArray[np.float64],
        plants: Any,
        frames: NDArray[np.int64],
        truth: NDArray[np.float64],
        flown: NDArray[np.int64],
        left: NDArray[np.int64],
        out: NDArray[np.uint8],
        waits: NDArray[np.int64],
    ) -> tuple[int, int, int, int, int, int]:
        _ = build
        for _ in range(DATAGRAMS):
            if written == 0:
                if at >= have:
                    have, at = _received(fd, buffer, waits), 0
                    if have <= 0:
                        return 0, 0, 0, 0, 0, 0
                at, many, others, written = steady_tick.fly(
                    buffer[:have], at, marked, row_of, rows, states, parameters, plants, frames, truth, flown, left, out
                )
                first = 0
            while first < many:
                row = flown[first]
                if not _written_down(rows[row], truth[row]):
                    return have, at, others, many, first, written
                rows[row].ticks += 1
                first += 1
            if written > 0:
                _send(fd, out.ctypes.data, written, _DONTWAIT)
                written = 0
            if others > 0:
                break
        return have, at, others, 0, 0, 0

    return serve


serve = _compiled(steady_tick.checksum_of_files())
"""Fly datagrams for as long as they are usual, DATAGRAMS of them at most.

Args:
    fd: the socket, which waits in `recv`.
    have to written: what the last call has returned; 0 before the first.
    buffer: (k,) uint8, for a datagram.
    marked to out: as `steady_tick.fly` has them.
    waits: (WAITS,) int64, zeros at first.

Returns:
    bytes of the datagram in `buffer`, where to go on with it, and how many stretches of it were left. Then 0, 0, 0; or,
    where a record of truth was not taken whole, how many were flown, at which of them it goes on once it is, and the
    bytes of answers that are to be sent then.
"""
