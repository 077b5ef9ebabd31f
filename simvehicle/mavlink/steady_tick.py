"""The usual tick of supervised vehicles in one compiled call: from the bundles that came to the answers that go out.

It is what lockstep.py, offboard.py, the vehicle and telemetry.py do with a bundle of set points and HEARTBEAT for a
vehicle in offboard flight, byte for byte; whatever else comes, is due or happens is left to them. Which vehicle may be
flown so, and until when, stands in its row (`Steady`), which `sitl/steady.py` makes and takes back.
"""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.simvehicle.law.rotor_flight as rotor_flight
import cython.cimports.simvehicle.law.step as step
from cython.cimports.libc.math import isfinite
from cython.cimports.libc.string import memcpy
from cython.cimports.simvehicle.law.rotor_flight import NOISE_SIZE
from cython.cimports.simvehicle.law.rows import Command
from cython.cimports.simvehicle.mavlink.motion_frames import HEADER_BYTES, MAGIC, checksum
from cython.cimports.simvehicle.mavlink.steady_answer import (
    AUTOPILOT,
    SYSTEM_TIME_ID,
    SYSTEM_TIME_SEED,
    write_answer,
    write_truth,
)
from cython.cimports.simvehicle.mavlink.steady_tick import (
    _COMPONENT,
    _GCS,
    _HEARTBEAT_ID,
    _HEARTBEAT_SEED,
    _HEARTBEAT_TYPE,
    _LOCAL_NED,
    _PING_ID,
    _PING_SEED,
    _PING_TARGET,
    _SET_BYTES,
    _SET_ID,
    _SET_MASK,
    _SET_SEED,
    _SYSTEM,
    LONGEST_MS,
    MOST_STEPS,
    SENT_BYTES,
    STEP_MS,
)

"""Answers that are sent before others are flown."""


def _number(datagram: Any, body: int, at: int, size: int) -> int:
    """A whole number of a payload; what is cut of it is 0."""
    value, length = 0, datagram[body - HEADER_BYTES + 1]
    for i in range(size):
        if at + i < length:
            value |= cython.cast(cython.longlong, datagram[body + at + i]) << (8 * i)
    return value


def _float(datagram: Any, at: int) -> float:
    single = cython.declare(cython.float)
    memcpy(cython.address(single), datagram + at, 4)
    return single


def _frame_end(datagram: Any, at: int, size: int) -> int:
    """Where the frame ends that begins here; 0 where none can."""
    if at + HEADER_BYTES + 2 > size or datagram[at] != MAGIC:
        return 0
    end = at + HEADER_BYTES + datagram[at + 1] + 2
    return end if end <= size else 0


def _is_supervisors(datagram: Any, at: int, end: int, msgid: int, seed: int) -> bool:
    """Whether a frame is an intact one of this id of the supervisor's, without a signature."""
    if datagram[at + 2] != 0 or datagram[at + 5] != _SYSTEM or datagram[at + 6] != _COMPONENT:
        return False
    if datagram[at + 7] != msgid or datagram[at + 8] != 0 or datagram[at + 9] != 0:
        return False
    crc = checksum(datagram, at + 1, end - 2, seed)
    return cython.cast(cython.uint, datagram[end - 2]) | cython.cast(cython.uint, datagram[end - 1]) << 8 == crc


def _bundle(fleet: Any, datagram: Any, size: int, at: int) -> tuple[int, int, int]:
    """The bundle that begins here: its vehicle's row, -1 for nobody's; where its frames begin and where it ends. No
    bundle at all goes to the datagram's end."""
    if not fleet.marked:
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
    return fleet.row_of[_number(datagram, at + HEADER_BYTES, _PING_TARGET, 1)], body, stop


def _is_set_point(one: Any, datagram: Any, body: int) -> bool:
    """Whether a payload is a set point of the usual kind for this vehicle, in finite numbers."""
    if datagram[body + 50] != one.sysid or datagram[body + 51] != AUTOPILOT or datagram[body + 52] != _LOCAL_NED:
        return False
    total = 0.0
    for i in range(6):
        total += _float(datagram, body + 4 + 4 * i)
    return _number(datagram, body, 48, 2) == _SET_MASK and isfinite(total)


def _usual(one: Any, s: Any, datagram: Any, at: int, stop: int) -> int:
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
    if s.remaining_j < one.floor_j or now_s - gcs_seen_s > one.gcs_loss_s or now_s - set_s > one.set_loss_s:
        return -1
    return at


def _take_in(one: Any, datagram: Any, at: int, grant: int) -> None:
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


def _command(one: Any, command: Any) -> None:
    """The set point as the law takes it: nwu."""
    for i in range(3):
        sign = 1.0 if i == 0 else -1.0
        command.position[i] = sign * one.set_p_ned[i]
        command.velocity[i] = sign * one.set_v_ned[i]
        command.use_position[i] = 1.0
    command.time_s = one.set_s
    command.yaw = -one.yaw_ned
    command.motors = 1.0
    command.ground = one.ground
    command.speed_max = one.fastest_m_s
    command.period_s = 0.1


def _advance(fleet: Any, row: int, command: Any, time_s: float, steps: int, thrust: Any) -> None:
    """Fly a row on: on the paper's plant, or on rotors, whose next step's noise stands at its place."""
    state, p = fleet.states + fleet.state_size * row, fleet.parameters + row
    if not fleet.airframes:
        step.fly_row(cython.cast("State *", state), command, p, time_s, STEP_MS / 1e3, steps, thrust)
        return
    s, a, w = cython.cast("RotorState *", state), fleet.airframes + row, fleet.weathers + row
    noise = fleet.noise + NOISE_SIZE * (fleet.noise_steps * row + fleet.rows[row].noise_step)
    gusts, count = fleet.gusts, fleet.gust_count
    rotor_flight.fly_row(s, command, p, a, w, gusts, count, noise, time_s, STEP_MS / 1e3, steps, thrust)


def fly(fleet: Any, datagram: Any, size: int, at: int) -> tuple[int, int, int, int]:
    """Fly the usual bundles of a supervisor's datagram from a place on, until SENT_BYTES of answers are written or all
    is looked at: where it stopped, how many were flown, how many stretches were left, bytes of answers."""
    command = cython.declare(Command)
    thrust = cython.declare(cython.double[MOST_STEPS])
    many = others = written = 0
    while at < size and written < SENT_BYTES and many < fleet.count and others < fleet.most_left:
        row, body, stop = _bundle(fleet, datagram, size, at)
        for k in range(many):
            if fleet.flown[k] == row:
                row = -1
        one = fleet.rows + max(row, 0)
        s = cython.cast("RotorState *", fleet.states + fleet.state_size * max(row, 0))
        known = cython.address(s.known)
        grant = -1 if row < 0 else _usual(one, known, datagram, body, stop)
        if grant < 0:
            fleet.left[2 * others], fleet.left[2 * others + 1] = at, stop
            others += 1
            at = stop
            continue
        _take_in(one, datagram, body, grant)
        _command(one, cython.address(command))
        one.granted_ms = _number(datagram, grant + HEADER_BYTES, 8, 4)
        steps = min((one.granted_ms - one.time_ms) // STEP_MS, MOST_STEPS)
        drawn_j = known.drawn_j
        _advance(fleet, row, cython.address(command), one.time_ms / 1e3, steps, thrust)
        one.noise_step += one.noise_moves * steps
        one.power_w = (known.drawn_j - drawn_j) / (steps * STEP_MS / 1e3)
        one.time_ms += steps * STEP_MS
        write_answer(one, s, fleet.frames, _number(datagram, grant + HEADER_BYTES, 0, 8))
        write_truth(one, s, thrust, steps, fleet.truth + fleet.truth_size * row)
        memcpy(fleet.out + written, one.answer, one.answer_bytes)
        written += one.answer_bytes
        fleet.flown[many] = row
        many += 1
        at = stop
    return at, many, others, written
