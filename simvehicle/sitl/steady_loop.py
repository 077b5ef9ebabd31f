"""The compiled loop of a process of supervised vehicles: wait for a datagram, fly it, write truth down, answer.

It makes the system's calls itself, so that nothing of the interpreter runs in a usual tick, and ends with the first
datagram that is not usual.
"""

from __future__ import annotations

import socket
from typing import Any

import cython
import numpy as np
from cython.cimports.posix.time import CLOCK_MONOTONIC, clock_gettime, timespec
from cython.cimports.posix.unistd import write
from cython.cimports.simvehicle.mavlink.steady_tick import Fleet, fly
from cython.cimports.simvehicle.sitl.steady_loop import (
    CROWDED_NS,
    DATAGRAMS,
    LOOK_NS,
    MOST_SLEEPS,
    SLEEPS,
    UNDISTURBED,
    recv,
    sched_yield,
    send,
)
from numpy.typing import NDArray

from simvehicle.sitl.truth import FIXED_NUMBERS, ROUNDING_S

"""So many are taken before the interpreter has its turn: signals wait for it."""
"""For so long the next datagram is looked for, where the last came as soon, and the processor left to others in
between: to be woken from sleep costs a vehicle and its supervisor more than most of a tick."""
LAST_NS, SLEEPS_LEFT, _SLEPT, _LOOKED = range(4)
WAITS = 4
"""Numbers that the loop keeps of its waits, in the order of the struct Waits."""
_DONTWAIT = int(socket.MSG_DONTWAIT)
_FIXED_NUMBERS, _ROUNDING_S = FIXED_NUMBERS, ROUNDING_S


def _now_ns() -> int:
    now = cython.declare(timespec)
    clock_gettime(CLOCK_MONOTONIC, cython.address(now))
    return cython.cast(cython.longlong, now.tv_sec) * 1_000_000_000 + now.tv_nsec


def _go_on_with_sleep(waits: Any) -> None:
    again = waits.slept > 0 and waits.looked < UNDISTURBED
    waits.slept = min(2 * waits.slept, MOST_SLEEPS) if again else SLEEPS
    waits.sleeps_left, waits.looked = waits.slept, 0


def _received(fd: int, buffer: Any, size: int, waits: Any) -> int:
    """Wait for a datagram: its bytes, or none above 0."""
    begun_ns = now_ns = _now_ns()
    have = -1
    if waits.sleeps_left > 0:
        waits.sleeps_left -= 1
    elif waits.last_ns < LOOK_NS:
        waits.looked += 1
        while have < 0 and now_ns - begun_ns < LOOK_NS:
            have = recv(fd, buffer, size, _DONTWAIT)
            if have < 0:
                sched_yield()
                left_ns, now_ns = now_ns, _now_ns()
                if now_ns - left_ns >= CROWDED_NS:
                    _go_on_with_sleep(waits)
    if have < 0:
        have = recv(fd, buffer, size, 0)
        now_ns = _now_ns()
    waits.last_ns = now_ns - begun_ns
    return have


def _written_down(one: Any, record: Any) -> bool:
    """Write a record of truth, if there is to be one; False where not all of it was taken."""
    if one.truth_fd < 0:
        return True
    numbers = _FIXED_NUMBERS + cython.cast(cython.longlong, record[1])
    if one.truth_period_s > 0.0:
        if record[0] < one.truth_due_s - _ROUNDING_S:
            return True
        one.truth_due_s = max(one.truth_due_s + one.truth_period_s, record[0])
        record[1], numbers = 0.0, _FIXED_NUMBERS
    one.truth_taken = max(write(one.truth_fd, record, 8 * numbers), 0)
    one.truth_bytes += one.truth_taken
    return one.truth_taken == 8 * numbers


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
    airframes: NDArray[np.float64] | None,
    weathers: Any,
    gusts: Any,
    noise: Any,
    frames: NDArray[np.int64],
    truth: NDArray[np.float64],
    flown: NDArray[np.int64],
    left: NDArray[np.int64],
    out: NDArray[np.uint8],
    waits: NDArray[np.int64],
) -> tuple[int, int, int, int, int, int]:
    """Fly datagrams for as long as they are usual, DATAGRAMS of them at most.

    Args:
        fd: the socket, which waits in `recv`.
        have, at, others, many, first, written: what the last call has returned; 0 before the first.
        buffer: (k,), for a datagram.
        marked: whether a PING to its vehicle stands before each bundle; else the whole is one, the first row's.
        row_of: (256,) row of a system id, -1 without one.
        rows: (n,) STEADY; of those flown they change, as `states` does, (n, k) as the plant has it.
        parameters: (n, PARAMS_SIZE).
        airframes: packed, (n, AIRFRAME_SIZE), where the vehicles fly on rotors; with it weathers (n, WEATHER_SIZE),
            gusts (m, DISCRETE_SIZE) that blow on all and noise of the next steps (n, k, NOISE_SIZE).
        frames: `frame_table()`.
        truth: (n, TRUTH_NUMBERS + MOST_STEPS), a record of each that is flown.
        flown: (n,), which rows were flown, in order.
        left: (m, 2), beginnings and ends of what was not: bundles that are not usual, or the rest of what is none.
        out: (SENT_BYTES + FRAMES_BYTES,), the answers, one after the other.
        waits: (WAITS,), zeros at first.

    Returns:
        bytes of the datagram in `buffer`, where to go on with it, and how many stretches of it were left. Then 0, 0, 0;
        or, where a record of truth was not taken whole, how many were flown, at which of them it goes on once it is,
        and the bytes of answers that are to be sent then.
    """
    fleet = cython.declare(Fleet)
    fleet.marked, fleet.row_of, fleet.count = marked, cython.address(row_of[0]), flown.shape[0]
    fleet.rows, fleet.states, fleet.state_size = cython.address(rows[0]), cython.address(states[0, 0]), states.shape[1]
    fleet.parameters = cython.cast("const Parameters *", cython.address(parameters[0, 0]))
    fleet.airframes = cython.NULL
    if airframes is not None:
        fleet.airframes = cython.cast("const AirframeRow *", cython.address(airframes[0, 0]))
        fleet.weathers = cython.cast("const Weather *", cython.address(weathers[0, 0]))
        fleet.gusts, fleet.gust_count = cython.cast("const Gust *", cython.address(gusts[0, 0])), gusts.shape[0]
        fleet.noise, fleet.noise_steps = cython.address(noise[0, 0, 0]), noise.shape[1]
    fleet.frames, fleet.truth, fleet.truth_size = (
        cython.address(frames[0, 0]),
        cython.address(truth[0, 0]),
        truth.shape[1],
    )
    fleet.flown, fleet.left, fleet.most_left = cython.address(flown[0]), cython.address(left[0, 0]), left.shape[0]
    fleet.out = cython.address(out[0])
    room, bytes_of_datagram = cython.address(buffer[0]), buffer.shape[0]
    kept = cython.cast("Waits *", cython.address(waits[0]))
    with cython.nogil:
        have, at, others, many, first, written = _serve(
            cython.address(fleet), fd, have, at, others, many, first, written, room, bytes_of_datagram, kept
        )
    return have, at, others, many, first, written


def _serve(
    fleet: Any, fd: int, have: int, at: int, others: int, many: int, first: int, written: int, buffer: Any, size: int,
    waits: Any,
) -> tuple[int, int, int, int, int, int]:  # fmt: skip
    for _ in range(DATAGRAMS):
        if written == 0:
            if at >= have:
                have, at = _received(fd, buffer, size, waits), 0
                if have <= 0:
                    return 0, 0, 0, 0, 0, 0
            at, many, others, written = fly(fleet, buffer, have, at)
            first = 0
        while first < many:
            row = fleet.flown[first]
            if not _written_down(fleet.rows + row, fleet.truth + fleet.truth_size * row):
                return have, at, others, many, first, written
            fleet.rows[row].ticks += 1
            first += 1
        if written > 0:
            send(fd, fleet.out, written, _DONTWAIT)
            written = 0
        if others > 0:
            break
    return have, at, others, 0, 0, 0
