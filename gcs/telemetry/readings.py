"""Place, attitude, mode, battery and effort of a vehicle, read from its frames by compiled code: it tells them all the
time.

A vehicle's readings are one row, laid out by the constants below; its battery is an account of gcs/telemetry/energy.py.
`read` goes through frames in their order and stops where other code must go on: at a message that is kept elsewhere,
and after one that tells another mode, or what cannot be; with a battery's report, at the next message that may stop it.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import cython
import numpy as np
from cython.cimports.gcs.mavlink.frame_runs import run_at
from cython.cimports.gcs.mavlink.payload import f32, i8, i16, i32, octet, u16, u32
from cython.cimports.gcs.telemetry.energy import (
    DRAWN,
    IMPOSSIBLE_POWER,
    IMPOSSIBLE_TOTAL,
    count,
    mean_power,
)
from cython.cimports.gcs.telemetry.plausibility import POSSIBLE, place_fault
from cython.cimports.gcs.telemetry.readings import (
    _ATTITUDE,
    _BATTERY_STATUS,
    _CELLS,
    _EXTENDED_SYS_STATE,
    _FIRST_CELLS,
    _GPS_GLOBAL_ORIGIN,
    _GPS_RAW_INT,
    _HEADER_BYTES,
    _HEARTBEAT,
    _HOME_POSITION,
    _LOCAL_POSITION_NED,
    _NAMED_VALUE_FLOAT,
    _NAMED_VALUE_INT,
    _NO_CELL,
    _NO_CURRENT,
    _PX4_NO_CURRENT,
    _SYS_STATUS,
    _SYSTEM_TIME,
    BATTERY,
    ELSEWHERE,
    END,
    FROM_ANYBODY,
    FROM_AUTOPILOT,
    MODE,
    PLACE,
    SMALL_IDS,
    UNKNOWN,
    Stop,
    readings_at,
)
from cython.cimports.libc.math import INFINITY, M_PI, NAN, fabs, isfinite, isnan, sqrt
from cython.cimports.skytender.frames import CHECKSUM_BYTES, HEADER_BYTES, MAGIC, SIGNATURE_BYTES, SIGNED
from numpy.typing import NDArray

from gcs.mavlink.battery import HECTOJOULE
from skytender import mavlink as mav

Row = NDArray[np.float64]

READINGS = 41
(
    NORTH, EAST, DOWN,  # m, in its own frame; NaN before the first
    V_NORTH, V_EAST, V_DOWN,  # m/s
    POSITION_S,  # as of when, in session time; so are the others in s
    HEADING, ROLL, PITCH,  # rad
    LANDED, LANDED_REPORTED,  # 1 or 0
    EFFORT, EFFORT_S,  # NaN before the first
    AUTOPILOT, CUSTOM_MODE, BASE_MODE, SYSTEM_STATUS,  # of its last HEARTBEAT; -1 before the first
    RECEIVED_S,  # of its last HEARTBEAT
    CLOCK_S,  # offset from its own time to the session's, NaN while that is not known
    POWER_W,
    RECEIVED_REPORTED_S, GIVEN_REPORTED_S,  # its counters of energy; -inf before the first
    EXTERNAL,  # 1 or 0
    ORIGIN_LAT, ORIGIN_LON, ORIGIN_ALT,  # the last GPS_GLOBAL_ORIGIN that was believed, as it stood there; NaN without
    SEVERAL_BATTERIES,  # 1 once it has reported another than number 0, or none that it flies on
    MESSAGE_S,  # when anything but SYSTEM_TIME came from its autopilot
    UNHEALTHY,  # MAV_SYS_STATUS_SENSOR of what it has, uses, and says is out of order; 0 before the first SYS_STATUS
    FIX_TYPE, FIX_H, FIX_V, FIX_ARMED,  # of its last GPS_RAW_INT, with accuracies, mm; -1 before the first
    WAY,  # m, from each place that it has reported to the next, on the ground too
    *FIRST_BATTERY,  # of number 0, as long as it is the only one: s (-inf before its first), J, W, share, V, function
) = range(READINGS)  # fmt: skip
"""Columns of a vehicle's row, in the order of the struct Readings in readings.pxd."""

FOUND = 5

MESSAGES = frozenset(
    (_HEARTBEAT, _SYS_STATUS, _ATTITUDE, _LOCAL_POSITION_NED, _BATTERY_STATUS, _EXTENDED_SYS_STATE, _NAMED_VALUE_FLOAT)
)
"""Ids of those that are read here."""
_AUTOPILOT_1 = mav.MAV_COMP_ID_AUTOPILOT1
_ARMED = mav.MAV_MODE_FLAG_SAFETY_ARMED
_ON_GROUND, _UNDEFINED = mav.MAV_LANDED_STATE_ON_GROUND, mav.MAV_LANDED_STATE_UNDEFINED
_PROPULSION = mav.MAV_BATTERY_FUNCTION_PROPULSION
MOST_EFFORT = 1e12
_MOST_EFFORT, _HECTOJOULE = MOST_EFFORT, HECTOJOULE


def new_readings() -> Row:
    """(READINGS,) of a vehicle that has said nothing."""
    row = np.zeros(READINGS)
    row[[NORTH, EAST, DOWN, EFFORT_S, CLOCK_S, ORIGIN_LAT, ORIGIN_LON, ORIGIN_ALT]] = NAN
    row[[POSITION_S, RECEIVED_S, MESSAGE_S, RECEIVED_REPORTED_S, GIVEN_REPORTED_S, FIRST_BATTERY[0]]] = -INFINITY
    row[[AUTOPILOT, CUSTOM_MODE, BASE_MODE, SYSTEM_STATUS, FIX_TYPE]] = -1.0
    return row


def kept_elsewhere(from_autopilot: Iterable[int], from_anybody: Iterable[int]) -> NDArray[np.uint8]:
    """(SMALL_IDS,) the messages at which `read` stops."""
    table = np.zeros(SMALL_IDS, dtype=np.uint8)
    table[list(from_autopilot)] = FROM_AUTOPILOT
    table[list(from_anybody)] = FROM_ANYBODY
    return table


def _session_s(row: Any, boot_ms: int, now_s: float) -> Any:
    """When a vehicle said something, by its own clock if that is known; it was not later than now."""
    return now_s if isnan(row.clock_s) else min(boot_ms / 1e3 + row.clock_s, now_s)


def _read_place(data: Any, at: int, stop: int, row: Any, now_s: float, found: Any) -> Any:
    reported_s = _session_s(row, u32(data, at, stop), now_s)
    if reported_s < row.position_s:
        return True
    n, e, d = f32(data, at + 4, stop), f32(data, at + 8, stop), f32(data, at + 12, stop)
    v_n, v_e, v_d = f32(data, at + 16, stop), f32(data, at + 20, stop), f32(data, at + 24, stop)
    moved_m = sqrt((n - row.north) ** 2 + (e - row.east) ** 2 + (d - row.down) ** 2)
    fault = place_fault(n, e, d, v_n, v_e, v_d, moved_m, reported_s - row.position_s)
    if fault != POSSIBLE:
        found[0], found[1] = fault, moved_m
        return False
    if not isnan(moved_m):
        row.way += moved_m
    row.north, row.east, row.down = n, e, d
    row.v_north, row.v_east, row.v_down = v_n, v_e, v_d
    row.position_s = reported_s
    return True


def _read_attitude(data: Any, at: int, stop: int, row: Any) -> Any:
    roll, pitch, yaw = f32(data, at + 4, stop), f32(data, at + 8, stop), f32(data, at + 12, stop)
    if fabs(yaw) <= 2.0 * M_PI:
        row.heading = yaw
    if isfinite(roll) and isfinite(pitch):
        row.roll, row.pitch = roll, pitch


def _read_mode(data: Any, at: int, stop: int, row: Any, now_s: float) -> Any:
    """Whether it is the one before."""
    mode, autopilot = u32(data, at, stop), octet(data, at + 5, stop)
    base_mode, system_status = octet(data, at + 6, stop), octet(data, at + 7, stop)
    same = row.autopilot == autopilot and mode == row.custom_mode
    same = same and row.base_mode == base_mode and row.system_status == system_status
    row.custom_mode, row.autopilot, row.base_mode, row.system_status = (
        mode, autopilot, base_mode, system_status,
    )  # fmt: skip
    row.received_s = now_s
    return same


def _is_named(data: Any, at: int, stop: int, name: Any) -> bool:
    """Whether a NAMED_VALUE has this name, which ends with a zero."""
    k = 0
    while octet(data, at + 8 + k, stop) == name[k]:
        if name[k] == 0:
            return True
        k += 1
    return False


def _is_repeated(data: Any, at: int, stop: int, msgid: Any, row: Any, one: Any, now_s: float) -> Any:
    """Whether a message that is kept elsewhere says nothing new: where a frame lies, as before; home, whose place of
    one of ours is known; a fix with the accuracy that it had; and another value than a counter of energy, or such a one
    as before."""
    if msgid == _HOME_POSITION:
        return row.external == 0.0
    if msgid == _GPS_GLOBAL_ORIGIN:
        same = i32(data, at, stop) == row.origin_lat and i32(data, at + 4, stop) == row.origin_lon
        return same and i32(data, at + 8, stop) == row.origin_alt
    if msgid == _GPS_RAW_INT:
        same = octet(data, at + 28, stop) == row.fix_type and _is_armed(row) == row.fix_armed
        return same and u32(data, at + 34, stop) == row.fix_h and u32(data, at + 38, stop) == row.fix_v
    if msgid == _NAMED_VALUE_INT:
        if _is_named(data, at, stop, b"XferIn"):
            counter = 0
        elif _is_named(data, at, stop, b"XferOut"):
            counter = 1
        else:
            return True
        if i32(data, at + 4, stop) == one.told_j[counter]:
            one.told_s[counter] = now_s
            reported_s = _session_s(row, u32(data, at, stop), now_s)
            row.counted_s[counter] = max(row.counted_s[counter], reported_s)
            return True
    return False


def _read_effort(data: Any, at: int, stop: int, row: Any, now_s: float) -> Any:
    if not _is_named(data, at, stop, b"CtlEffort"):
        return
    value = f32(data, at + 4, stop)
    if 0.0 <= value <= _MOST_EFFORT:
        row.effort = value
        row.effort_s = _session_s(row, u32(data, at, stop), now_s)


def _cells_mv(data: Any, at: int, stop: int) -> Any:
    """Cells up to the first that is _NO_CELL; the last ones are extension fields of newer messages."""
    total_mv = cython.cast(cython.longlong, 0)
    for k in range(_CELLS):
        cell_mv = u16(data, at + 2 * k + (10 if k < _FIRST_CELLS else 21), stop)
        if cell_mv == _NO_CELL:
            break
        total_mv += cell_mv
    return total_mv


def _power_w(total_mv: int, current_ca: int) -> Any:
    if total_mv == 0 or current_ca in (_NO_CURRENT, _PX4_NO_CURRENT):
        return NAN
    return 1e-2 * current_ca * (1e-3 * total_mv)


def _share(percent: int) -> Any:
    return 0.01 * percent if 0 <= percent <= 100 else NAN


def _is_armed(row: Any) -> bool:
    return row.base_mode >= 0.0 and cython.cast(cython.int, row.base_mode) & _ARMED != 0


def _count_report(
    one: Any, found: Any, row: Any, now_s: float, consumed_j: float, power_w: float, remaining: float, second: bool
) -> bool:
    """Count a battery's report: whether nothing else follows from it."""
    armed = _is_armed(row)
    report = count(one, now_s, consumed_j, power_w, remaining, second, armed)
    other = report.became == DRAWN and mean_power(one, now_s)
    row.power_w = one.power_w
    found[0], found[1], found[2] = consumed_j, power_w, report.became
    found[3], found[4] = report.bridged_s, report.gained_j
    if report.became in (IMPOSSIBLE_POWER, IMPOSSIBLE_TOTAL):
        return False
    return not other and isnan(report.bridged_s) and isnan(report.gained_j)


def _read_run(
    data: Any, at: int, end: int, now_s: float, row: Any, one: Any, kept: NDArray[np.uint8], found: Any
) -> Any:
    """Read the frames of one system that lie in data[begin:end], one after the other."""
    counted = False
    while at + _HEADER_BYTES <= end:
        begin = at + _HEADER_BYTES
        msgid, stop = data[at + 7] | data[at + 8] << 8, min(begin + data[at + 1], end)
        own = data[at + 6] == _AUTOPILOT_1
        small = data[at + 9] == 0 and msgid < SMALL_IDS
        if own and not (small and msgid == _SYSTEM_TIME):  # it answers a grant also where the radio is out
            row.message_s = now_s
        elsewhere = small and (kept[msgid] == FROM_ANYBODY or (kept[msgid] == FROM_AUTOPILOT and own))
        if elsewhere and own and _is_repeated(data, begin, stop, msgid, row, one, now_s):
            at = stop + (15 if data[at + 2] == 1 else 2)
            continue
        if own and small and msgid == _BATTERY_STATUS:
            elsewhere = row.several_batteries != 0.0 or octet(data, begin + 32, stop) != 0
            elsewhere = elsewhere or octet(data, begin + 33, stop) > _PROPULSION
        if counted:
            may_stop = msgid in (_HEARTBEAT, _SYS_STATUS, _LOCAL_POSITION_NED, _BATTERY_STATUS)
            if elsewhere or (small and own and may_stop):
                return Stop(at, BATTERY)
        if elsewhere:
            return Stop(at, ELSEWHERE)
        at = stop + (15 if data[at + 2] == 1 else 2)
        if not (small and own):
            continue
        if msgid == _ATTITUDE:
            _read_attitude(data, begin, stop, row)
        elif msgid == _LOCAL_POSITION_NED:
            if not _read_place(data, begin, stop, row, now_s, found):
                return Stop(at, PLACE)
        elif msgid == _HEARTBEAT:
            if not _read_mode(data, begin, stop, row, now_s):
                return Stop(at, MODE)
        elif msgid == _BATTERY_STATUS:
            consumed_hj = i32(data, begin + 4, stop)
            consumed_j = NAN if consumed_hj < 0 else _HECTOJOULE * consumed_hj
            total_mv = _cells_mv(data, begin, stop)
            power_w = _power_w(total_mv, i16(data, begin + 30, stop))
            remaining = _share(i8(data, begin + 35, stop))
            row.first_s, row.first_consumed_j, row.first_power_w = now_s, consumed_j, power_w
            row.first_share, row.first_v = remaining, 1e-3 * total_mv if total_mv else NAN
            row.first_function = octet(data, begin + 33, stop)
            counted = not _count_report(one, found, row, now_s, consumed_j, power_w, remaining, False)
        elif msgid == _SYS_STATUS:
            row.unhealthy = u32(data, begin, stop) & u32(data, begin + 4, stop) & ~u32(data, begin + 8, stop)
            total_mv = u16(data, begin + 14, stop)
            power_w = _power_w(0 if total_mv == _NO_CELL else total_mv, i16(data, begin + 16, stop))
            remaining = _share(i8(data, begin + 30, stop))
            counted = not _count_report(one, found, row, now_s, NAN, power_w, remaining, True)
        elif msgid == _EXTENDED_SYS_STATE:
            landed_state = octet(data, begin + 1, stop)
            row.landed_reported = 1.0
            row.landed = 1.0 if landed_state in (_ON_GROUND, _UNDEFINED) else 0.0
        elif msgid == _NAMED_VALUE_FLOAT:
            _read_effort(data, begin, stop, row, now_s)
    return Stop(at, BATTERY if counted else END)


class TelemetryReader:
    """Reads frames into the rows of a fleet's vehicles."""

    def __init__(
        self,
        row_by_sysid: NDArray[np.int64],
        readings: NDArray[np.float64],
        accounts: NDArray[Any],
        kept: NDArray[np.uint8],
        found: Row,
    ) -> None:
        """Keep the tables, which are filled in place.

        Args:
            row_by_sysid: (256,) row of a vehicle by its system id; negative: none.
            readings, accounts: (vehicles, READINGS) and (vehicles,).
            kept: (SMALL_IDS,)
            found: (FOUND,)
        """
        self._row_by_sysid, self._readings, self._accounts = row_by_sysid, readings, accounts
        self._kept, self._found = kept, found

    def read(self, data: bytes, at: int, end: int, vehicle: int, now_s: float) -> tuple[int, int]:
        """Read the frames of the vehicle `vehicle` that lie in data[at:end], one after the other, at a session time;
        (where the next frame begins, why it stops)."""
        stop = self._read(data, at, end, vehicle, now_s)
        return stop.at, stop.why

    def read_runs(
        self,
        data: bytes,
        at: int,
        end: int,
        vehicle: int,
        run: int,
        spans: NDArray[np.int64],
        runs: NDArray[np.int64],
        now_s: float,
    ) -> tuple[int, int, int]:
        """As `read`, and then the runs from `run` on; (which run is next, where in the one before it the next frame
        begins, why it stops).

        Args:
            spans: (frames, 2) of all frames of the runs.
            runs: (n, COLUMNS of gcs/mavlink/frame_runs.py).
        """
        while True:
            stop = self._read(data, at, end, vehicle, now_s)
            if stop.why != END or run == runs.shape[0]:
                return run, stop.at, stop.why
            next_run = run_at(runs, run)
            at, end = spans[next_run.first, 0], spans[next_run.last - 1, 1]
            vehicle = self._row_by_sysid[next_run.sysid]
            run += 1
            if vehicle < 0:
                return run, at, UNKNOWN

    def read_dated(
        self,
        data: bytes,
        places: NDArray[np.int64],
        sysids: NDArray[np.int64],
        times_s: NDArray[np.float64],
        row_by_sysid: NDArray[np.int64],
        k: int,
        end: int,
    ) -> tuple[int, int, int]:
        """Read frames k to end of n that lie anywhere, each at its own time; (which one it stops at, where in that the
        next one begins, why). UNKNOWN: its vehicle is left out, or it is of MAVLink 1.

        Args:
            places, sysids, times_s: (n,) where each frame begins, its sender, and its session time.
            row_by_sysid: (256,) rows of the vehicles that are read; negative: left out.
        """
        octets = cython.cast("const unsigned char *", data)
        while k < end:
            at, vehicle = places[k], row_by_sysid[sysids[k]]
            if vehicle < 0 or octets[at] != MAGIC:
                return k, at, UNKNOWN
            signature = SIGNATURE_BYTES if octets[at + 2] & SIGNED else 0
            behind = at + HEADER_BYTES + octets[at + 1] + CHECKSUM_BYTES + signature
            stop = self._read(octets, at, behind, vehicle, times_s[k])
            if stop.why != END:
                return k, stop.at, stop.why
            k += 1
        return k, 0, END

    def _read(self, data: Any, at: int, end: int, vehicle: int, now_s: float) -> Any:
        if at >= end:
            return Stop(at, END)
        row, one = readings_at(self._readings, vehicle), cython.address(self._accounts[vehicle])
        return _read_run(data, at, end, now_s, row, one, self._kept, cython.address(self._found[0]))
