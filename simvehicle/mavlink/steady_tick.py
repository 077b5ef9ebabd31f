"""The usual tick of supervised vehicles in one compiled call: from the bundles that came to the answers that go out.

It is what lockstep.py, offboard.py, the vehicle and telemetry.py do with a bundle of set points and HEARTBEAT for a
vehicle in offboard flight, byte for byte; whatever else comes, is due or happens is left to them. Which vehicle may be
flown so, and until when, stands in its row (`STEADY`), which `sitl/steady.py` makes and takes back.
"""

from __future__ import annotations

import math
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot import snapshot
from simvehicle.kernels import UNCOUNTED, inner, overload
from simvehicle.law import rotor_flight, step
from simvehicle.mavlink import motion_frames, steady_answer, telemetry
from simvehicle.mavlink.motion_frames import HEADER_BYTES, MAGIC, checksum
from simvehicle.mavlink.steady_answer import (
    AUTOPILOT,
    FRAMES_BYTES,
    PAYLOAD_BYTES,
    STREAMS,
    SYSTEM_TIME_ID,
    SYSTEM_TIME_SEED,
    write_answer,
    write_truth,
)

LONGEST_MS = 103
"""A vehicle looks at its failsafes every 100 ms: a longer stretch is no usual tick. What is left of a step waits."""
STEP_MS = 4
MOST_STEPS = 25
SENT_BYTES = 4096
"""Answers that are sent before others are flown."""

STEADY = np.dtype(
    [
        ("steady", "i8"),  # 1 while nothing but set points moves it
        ("sysid", "i8"),
        ("granted_ms", "i8"),  # time of the last grant
        ("time_ms", "i8"),  # the vehicle's: what is no whole step is not flown yet
        ("number", "i8"),  # of the supervisor's next frame
        ("seq", "i8"),  # of its own next frame
        ("until_ms", "i8"),  # when something is due that is not written here
        ("ground", "i8"),
        ("checked", "i8"),  # whether a low battery refuses arming
        ("unix_epoch_us", "i8"),
        ("given_j", "f8"),
        ("received_j", "f8"),
        ("truth_fd", "i8"),  # of its file of truth, -1 without one
        ("truth_period_s", "f8"),  # 0: a record at each grant
        ("truth_due_s", "f8"),
        ("truth_bytes", "i8"),  # written while it is steady, and of the last record
        ("truth_taken", "i8"),
        ("ticks", "i8"),  # flown here
        ("gcs_seen_s", "f8"),  # NaN: never
        ("gcs_loss_s", "f8"),
        ("set_s", "f8"),  # of the set point, and its place and velocity
        ("set_p_ned", "f8", 3),
        ("set_v_ned", "f8", 3),
        ("set_loss_s", "f8"),
        ("yaw_ned", "f8"),
        ("fastest_m_s", "f8"),
        ("power_w", "f8"),
        ("rotors", "i8"),  # whether it flies on rotors, and its estimate errs
        ("senses", "i8"),
        ("noise_step", "i8"),  # place of the next step's noise, the end of what there is,
        ("noise_end", "i8"),
        ("noise_moves", "i8"),  # and by how many places a step goes on: 0 where all of it is 0
        ("floor_j", "f8"),  # below it the vehicle lands
        ("capacity_j", "f8"),
        ("home_down_m", "f8"),
        ("origin", "f8", 5),  # as write_motion has it
        ("due_ms", "i8", len(STREAMS)),
        ("interval_ms", "i8", len(STREAMS)),
        ("payloads", "u1", (len(STREAMS) + 1) * PAYLOAD_BYTES),  # with what stays the same; the last is SYSTEM_TIME's
        ("answer_bytes", "i8"),  # of the last one; 0 where that was not written here
        ("answer", "u1", FRAMES_BYTES),
    ],
    align=True,
)


_SYSTEM, _COMPONENT = 255, 190  # the supervisor
_PING_ID, _PING_SEED, _PING_TARGET = 4, 237, 12
_HEARTBEAT_ID, _HEARTBEAT_SEED, _HEARTBEAT_TYPE = 0, 50, 4
_SET_ID, _SET_SEED, _SET_BYTES, _SET_MASK = 84, 143, 53, 0b1101_1100_0000
_GCS, _LOCAL_NED = int(mav.MAV_TYPE_GCS), int(mav.MAV_FRAME_LOCAL_NED)


@inner(**UNCOUNTED)
def _number(datagram: NDArray[np.uint8], body: int, at: int, size: int) -> int:
    """A whole number of a payload; what is cut of it is 0."""
    value, length = 0, int(datagram[body - HEADER_BYTES + 1])
    for i in range(size):
        if at + i < length:
            value |= int(datagram[body + at + i]) << (8 * i)
    return value


@inner(**UNCOUNTED)
def _float(datagram: NDArray[np.uint8], at: int) -> float:
    bits = 0
    for i in range(4):
        bits |= int(datagram[at + i]) << (8 * i)
    return float(np.uint32(bits).view(np.float32))


@inner(**UNCOUNTED)
def _frame_end(datagram: NDArray[np.uint8], at: int, size: int) -> int:
    """Where the frame ends that begins here; 0 where none can."""
    if at + HEADER_BYTES + 2 > size or datagram[at] != MAGIC:
        return 0
    end = at + HEADER_BYTES + int(datagram[at + 1]) + 2
    return end if end <= size else 0


@inner(**UNCOUNTED)
def _is_supervisors(datagram: NDArray[np.uint8], at: int, end: int, msgid: int, seed: int) -> bool:
    """Whether a frame is an intact one of this id of the supervisor's, without a signature."""
    if datagram[at + 2] != 0 or datagram[at + 5] != _SYSTEM or datagram[at + 6] != _COMPONENT:
        return False
    if datagram[at + 7] != msgid or datagram[at + 8] != 0 or datagram[at + 9] != 0:
        return False
    crc = checksum(datagram, at + 1, end - 2, seed)
    return bool(int(datagram[end - 2]) | int(datagram[end - 1]) << 8 == crc)


@inner(**UNCOUNTED)
def _bundle(datagram: NDArray[np.uint8], at: int, marked: bool, row_of: NDArray[np.int64]) -> tuple[int, int, int]:
    """The bundle that begins here: its vehicle's row, -1 for nobody's; where its frames begin and where it ends. No
    bundle at all goes to the datagram's end."""
    size = datagram.size
    if not marked:
        return 0, at, size
    body = _frame_end(datagram, at, size)
    if body == 0 or not _is_supervisors(datagram, at, body, _PING_ID, _PING_SEED):
        return -1, at, size
    stop = body
    while stop < size:
        end = _frame_end(datagram, stop, size)
        if end == 0:
            return -1, at, size
        if datagram[stop + 7] == _PING_ID and _is_supervisors(datagram, stop, end, _PING_ID, _PING_SEED):
            break
        stop = end
    return row_of[_number(datagram, at + HEADER_BYTES, _PING_TARGET, 1)], body, stop


@inner(**UNCOUNTED)
def _is_set_point(one: Any, datagram: NDArray[np.uint8], body: int) -> bool:
    """Whether a payload is a set point of the usual kind for this vehicle, in finite numbers."""
    if datagram[body + 50] != one.sysid or datagram[body + 51] != AUTOPILOT or datagram[body + 52] != _LOCAL_NED:
        return False
    total = 0.0
    for i in range(6):
        total += _float(datagram, body + 4 + 4 * i)
    return _number(datagram, body, 48, 2) == _SET_MASK and math.isfinite(total)


@inner(**UNCOUNTED)
def _usual(one: Any, s: NDArray[np.float64], datagram: NDArray[np.uint8], at: int, stop: int) -> int:
    """Where the closing SYSTEM_TIME of a bundle begins that is usual: its frames are the next numbers, set points for
    this vehicle and HEARTBEATs, and nothing but the flight to its time happens until then. Else -1."""
    if one.steady == 0:
        return -1
    number, now_s = one.number, one.time_ms / 1e3
    set_s, gcs_seen_s = one.set_s, one.gcs_seen_s
    while True:
        end = _frame_end(datagram, at, stop)
        if end == 0 or datagram[at + 4] != number:
            return -1
        number = (number + 1) & 0xFF
        msgid, body = datagram[at + 7], at + HEADER_BYTES
        if msgid == SYSTEM_TIME_ID:
            break
        if msgid == _HEARTBEAT_ID:
            if not _is_supervisors(datagram, at, end, _HEARTBEAT_ID, _HEARTBEAT_SEED):
                return -1
            if _number(datagram, body, _HEARTBEAT_TYPE, 1) == _GCS:
                gcs_seen_s = now_s
        else:
            if msgid != _SET_ID or datagram[at + 1] != _SET_BYTES or not _is_set_point(one, datagram, body):
                return -1
            if not _is_supervisors(datagram, at, end, _SET_ID, _SET_SEED):
                return -1
            set_s = now_s
        at = end
    if end != stop or not _is_supervisors(datagram, at, end, SYSTEM_TIME_ID, SYSTEM_TIME_SEED):
        return -1
    granted_ms = _number(datagram, body, 8, 4)
    span_ms = granted_ms - one.time_ms
    if granted_ms <= one.granted_ms or not STEP_MS <= span_ms <= LONGEST_MS:
        return -1
    steps = min(span_ms // STEP_MS, MOST_STEPS)
    if one.time_ms + STEP_MS * steps >= one.until_ms or one.noise_step + steps > one.noise_end:
        return -1
    if s[step.REMAINING_J] < one.floor_j or now_s - gcs_seen_s > one.gcs_loss_s or now_s - set_s > one.set_loss_s:
        return -1
    return at


@inner(**UNCOUNTED)
def _take_in(one: Any, datagram: NDArray[np.uint8], at: int, grant: int) -> None:
    """Apply the frames of a usual bundle before its grant."""
    now_s = one.time_ms / 1e3
    while at < grant:
        body = at + HEADER_BYTES
        if datagram[at + 7] == _SET_ID:
            one.set_s = now_s
            for i in range(3):
                one.set_p_ned[i] = _float(datagram, body + 4 + 4 * i)
                one.set_v_ned[i] = _float(datagram, body + 16 + 4 * i)
        elif _number(datagram, body, _HEARTBEAT_TYPE, 1) == _GCS:
            one.gcs_seen_s = now_s
        at = _frame_end(datagram, at, grant)
        one.number = (one.number + 1) & 0xFF
    one.number = (one.number + 1) & 0xFF


@inner(**UNCOUNTED)
def _command(one: Any, command: NDArray[np.float64]) -> None:
    """The set point as the law takes it: nwu."""
    for i in range(3):
        sign = 1.0 if i == 0 else -1.0
        command[step.CMD_POSITION.start + i] = sign * one.set_p_ned[i]
        command[step.CMD_VELOCITY.start + i] = sign * one.set_v_ned[i]
        command[step.CMD_USE_POSITION.start + i] = 1.0
    command[step.CMD_TIME_S] = one.set_s
    command[step.CMD_YAW] = -one.yaw_ned
    command[step.CMD_MOTORS] = 1.0
    command[step.CMD_GROUND] = one.ground
    command[step.CMD_SPEED_MAX] = one.fastest_m_s
    command[step.CMD_PERIOD_S] = 0.1


def _advance(
    row: int,
    states: NDArray[np.float64],
    command: NDArray[np.float64],
    parameters: NDArray[np.float64],
    plants: Any,
    at: int,
    times: NDArray[np.float64],
    thrust: NDArray[np.float64],
) -> None:
    """Fly a row on: on rotors where `plants` are their airframes, weathers, gusts and noise as `rotor_flight.fly_rows`
    has them, whose next step's noise stands `at` a place; else on the paper's plant. Compiled code only."""
    raise NotImplementedError


@overload(_advance, jit_options={"error_model": "numpy"}, strict=False)
def _advance_on(
    row: Any, states: Any, command: Any, parameters: Any, plants: Any, at: Any, times: Any, thrust: Any
) -> Callable[..., None]:
    return _advance_on_rotors if len(plants) > 1 else _advance_on_paper


def _advance_on_paper(
    row: int,
    states: NDArray[np.float64],
    command: NDArray[np.float64],
    parameters: NDArray[np.float64],
    plants: Any,
    at: int,
    times: NDArray[np.float64],
    thrust: NDArray[np.float64],
) -> None:
    step.fly_rows(states[row : row + 1], command, parameters[row : row + 1], times, STEP_MS / 1e3, thrust)


def _advance_on_rotors(
    row: int,
    states: NDArray[np.float64],
    command: NDArray[np.float64],
    parameters: NDArray[np.float64],
    plants: Any,
    at: int,
    times: NDArray[np.float64],
    thrust: NDArray[np.float64],
) -> None:
    airframes, weathers, gusts, noise = plants
    rotor_flight.fly_rows(
        states[row : row + 1],
        command,
        parameters[row : row + 1],
        airframes[row : row + 1],
        weathers[row : row + 1],
        gusts,
        noise[row, at : at + thrust.shape[1]].reshape((1, thrust.shape[1], noise.shape[2])),
        times,
        STEP_MS / 1e3,
        thrust,
    )


@inner(error_model="numpy")
def fly(
    datagram: NDArray[np.uint8],
    at: int,
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
) -> tuple[int, int, int, int]:
    """Fly the usual bundles of a datagram from a place on, until SENT_BYTES of answers are written or all is looked at.

    Args:
        datagram: of a supervisor; (k,) uint8.
        at: where to begin.
        marked: whether a PING to its vehicle stands before each bundle; else the whole is one, the first row's.
        row_of: (256,) row of a system id, -1 without one.
        rows: (n,) STEADY; of those flown they change, as `states` does, (n, k) as the plant has it.
        parameters: (n, PARAMS_SIZE).
        plants: a tuple, of packed airframes (n, k), weathers (n, WEATHER_SIZE), gusts (m, DISCRETE_SIZE) that blow on
            all and noise of the next steps (n, k, NOISE_SIZE) where they fly on rotors; else of one thing.
        frames: `frame_table()`.
        truth: (n, TRUTH_NUMBERS + MOST_STEPS), a record of each that is flown.
        flown: (n,), which rows were flown, in order.
        left: (m, 2), beginnings and ends of what was not: bundles that are not usual, or the rest of what is none.
        out: (SENT_BYTES + FRAMES_BYTES,), the answers, one after the other.

    Returns:
        where it stopped, how many were flown, how many stretches were left, bytes of answers.
    """
    many = others = written = 0
    command, times = np.empty((1, step.COMMAND_SIZE)), np.empty(1)
    while at < datagram.size and written < SENT_BYTES and many < flown.size and others < left.shape[0]:
        row, body, stop = _bundle(datagram, at, marked, row_of)
        for k in range(many):
            if flown[k] == row:
                row = -1
        grant = -1 if row < 0 else _usual(rows[row], states[row], datagram, body, stop)
        if grant < 0:
            left[others, 0], left[others, 1] = at, stop
            others += 1
            at = stop
            continue
        one, s = rows[row], states[row]
        _take_in(one, datagram, body, grant)
        _command(one, command[0])
        one.granted_ms = _number(datagram, grant + HEADER_BYTES, 8, 4)
        steps = min((one.granted_ms - one.time_ms) // STEP_MS, MOST_STEPS)
        thrust, drawn_j = np.empty((1, steps)), s[step.DRAWN_J]
        times[0] = one.time_ms / 1e3
        _advance(row, states, command, parameters, plants, one.noise_step, times, thrust)
        one.noise_step += one.noise_moves * steps
        one.power_w = (s[step.DRAWN_J] - drawn_j) / (steps * STEP_MS / 1e3)
        one.time_ms += steps * STEP_MS
        write_answer(one, s, frames, _number(datagram, grant + HEADER_BYTES, 0, 8))
        write_truth(one, s, thrust, truth[row])
        for i in range(one.answer_bytes):
            out[written + i] = one.answer[i]
        written += one.answer_bytes
        flown[many] = row
        many += 1
        at = stop
    return at, many, others, written


def checksum_of_files() -> int:
    """Of the files that are compiled into `fly`, for the kernel that it is compiled into."""
    modules = (motion_frames, steady_answer, telemetry, snapshot)
    files = (__file__, *(str(module.__file__) for module in modules))
    return zlib.crc32(b"".join(Path(file).read_bytes() for file in files), rotor_flight.checksum())
