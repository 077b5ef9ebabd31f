"""Place, attitude, mode, battery and effort of a vehicle, read from its frames by compiled code: it tells them all the
time.

A vehicle's readings are one row, laid out by the constants below; its battery is an account of gcs/telemetry/energy.py.
`read` goes through frames in their order and stops where somebody else must go on: at a message that is kept elsewhere,
and after one that tells another mode, or what cannot be; with a battery's report, at the next message that may stop it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.kernel_files import checksum
from gcs.kernels import UNCOUNTED, inner, kernel
from gcs.mavlink.battery import HECTOJOULE, NO_CELL
from gcs.mavlink.codec import HEADER_BYTES
from gcs.mavlink.datagram import FIRST, LAST, SYSID
from gcs.telemetry import energy, plausibility

Row = NDArray[np.float64]

READINGS = 29
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
) = range(READINGS)  # fmt: skip

END, ELSEWHERE, MODE, PLACE, BATTERY, UNKNOWN = range(6)
"""Why `read` stops: nothing is left; the next message is kept elsewhere; a HEARTBEAT told another mode; a place cannot
be (found[0]: a fault of plausibility.py, found[1]: how far it jumps, m); there is more to a battery's report than what
its account keeps (found: the arguments of `BatteryAccount.taken`); the last run is of none of the vehicles."""
FOUND = 5

FROM_AUTOPILOT, FROM_ANYBODY = 1, 2
SMALL_IDS = 256
"""All messages that are kept have an id below."""

_HEARTBEAT, _SYS_STATUS, _SYSTEM_TIME, _ATTITUDE, _LOCAL_POSITION_NED = 0, 1, 2, 30, 32
_BATTERY_STATUS, _EXTENDED_SYS_STATE, _NAMED_VALUE_FLOAT = 147, 245, 251
_GPS_GLOBAL_ORIGIN, _HOME_POSITION, _NAMED_VALUE_INT = 49, 242, 252
MESSAGES = frozenset(
    (_HEARTBEAT, _SYS_STATUS, _ATTITUDE, _LOCAL_POSITION_NED, _BATTERY_STATUS, _EXTENDED_SYS_STATE, _NAMED_VALUE_FLOAT)
)
"""Ids of those that are read here."""
_MAY_STOP = (_HEARTBEAT, _SYS_STATUS, _LOCAL_POSITION_NED, _BATTERY_STATUS)
_AUTOPILOT_1 = mav.MAV_COMP_ID_AUTOPILOT1
_ARMED = mav.MAV_MODE_FLAG_SAFETY_ARMED
_ON_GROUND, _UNDEFINED = mav.MAV_LANDED_STATE_ON_GROUND, mav.MAV_LANDED_STATE_UNDEFINED
_PROPULSION = mav.MAV_BATTERY_FUNCTION_PROPULSION
_NO_CURRENT, _PX4_NO_CURRENT = -1, -100
_CELLS, _MORE_CELLS = 10, 4
_EFFORT_NAME = b"CtlEffort\0"
MOST_EFFORT = 1e12
_RECEIVED_NAME, _GIVEN_NAME = b"XferIn\0", b"XferOut\0"


def new_readings() -> Row:
    """(READINGS,) of a vehicle that has said nothing."""
    row = np.zeros(READINGS)
    row[[NORTH, EAST, DOWN, EFFORT_S, CLOCK_S, ORIGIN_LAT, ORIGIN_LON, ORIGIN_ALT]] = math.nan
    row[[POSITION_S, RECEIVED_S, MESSAGE_S, RECEIVED_REPORTED_S, GIVEN_REPORTED_S]] = -math.inf
    row[[AUTOPILOT, CUSTOM_MODE, BASE_MODE, SYSTEM_STATUS]] = -1.0
    return row


def kept_elsewhere(from_autopilot: Iterable[int], from_anybody: Iterable[int]) -> NDArray[np.uint8]:
    """(SMALL_IDS,) the messages at which `read` stops."""
    table = np.zeros(SMALL_IDS, dtype=np.uint8)
    table[list(from_autopilot)] = FROM_AUTOPILOT
    table[list(from_anybody)] = FROM_ANYBODY
    return table


# A payload whose trailing zeros were cut: what lies at `stop` or behind it is 0.


@inner(**UNCOUNTED)
def _octet(data: bytes, at: int, stop: int) -> Any:
    return np.int64(data[at]) if at < stop else np.int64(0)


@inner(**UNCOUNTED)
def _u16(data: bytes, at: int, stop: int) -> Any:
    return _octet(data, at, stop) | _octet(data, at + 1, stop) << 8


@inner(**UNCOUNTED)
def _i16(data: bytes, at: int, stop: int) -> Any:
    value = _u16(data, at, stop)
    return value - 65536 if value >= 32768 else value


@inner(**UNCOUNTED)
def _i8(data: bytes, at: int, stop: int) -> Any:
    value = _octet(data, at, stop)
    return value - 256 if value >= 128 else value


@inner(**UNCOUNTED)
def _u32(data: bytes, at: int, stop: int) -> Any:
    return _u16(data, at, stop) | _u16(data, at + 2, stop) << 16


@inner(**UNCOUNTED)
def _i32(data: bytes, at: int, stop: int) -> Any:
    value = _u32(data, at, stop)
    return value - (1 << 32) if value >= 1 << 31 else value


@inner(**UNCOUNTED)
def _f32(data: bytes, at: int, stop: int) -> Any:
    return np.float64(np.uint32(_u32(data, at, stop)).view(np.float32))


@inner(**UNCOUNTED)
def _session_s(row: Row, boot_ms: int, now_s: float) -> Any:
    """When a vehicle said something, by its own clock if that is known; it was not later than now."""
    return now_s if math.isnan(row[CLOCK_S]) else min(boot_ms / 1e3 + row[CLOCK_S], now_s)


@inner(**UNCOUNTED)
def _read_place(data: bytes, at: int, stop: int, row: Row, now_s: float, found: Row) -> Any:
    reported_s = _session_s(row, _u32(data, at, stop), now_s)
    if reported_s < row[POSITION_S]:
        return True
    n, e, d = _f32(data, at + 4, stop), _f32(data, at + 8, stop), _f32(data, at + 12, stop)
    v_n, v_e, v_d = _f32(data, at + 16, stop), _f32(data, at + 20, stop), _f32(data, at + 24, stop)
    moved_m = math.sqrt((n - row[NORTH]) ** 2 + (e - row[EAST]) ** 2 + (d - row[DOWN]) ** 2)
    fault = plausibility.place_fault(n, e, d, v_n, v_e, v_d, moved_m, reported_s - row[POSITION_S])
    if fault != plausibility.POSSIBLE:
        found[0], found[1] = fault, moved_m
        return False
    row[NORTH], row[EAST], row[DOWN] = n, e, d
    row[V_NORTH], row[V_EAST], row[V_DOWN] = v_n, v_e, v_d
    row[POSITION_S] = reported_s
    return True


@inner(**UNCOUNTED)
def _read_attitude(data: bytes, at: int, stop: int, row: Row) -> Any:
    roll, pitch, yaw = _f32(data, at + 4, stop), _f32(data, at + 8, stop), _f32(data, at + 12, stop)
    if abs(yaw) <= math.tau:
        row[HEADING] = yaw
    if math.isfinite(roll) and math.isfinite(pitch):
        row[ROLL], row[PITCH] = roll, pitch


@inner(**UNCOUNTED)
def _read_mode(data: bytes, at: int, stop: int, row: Row, now_s: float) -> Any:
    """Whether it is the one before."""
    custom_mode, autopilot = np.float64(_u32(data, at, stop)), np.float64(_octet(data, at + 5, stop))
    base_mode, system_status = np.float64(_octet(data, at + 6, stop)), np.float64(_octet(data, at + 7, stop))
    same = row[CUSTOM_MODE] == custom_mode and row[AUTOPILOT] == autopilot
    same = same and row[BASE_MODE] == base_mode and row[SYSTEM_STATUS] == system_status
    row[CUSTOM_MODE], row[AUTOPILOT], row[BASE_MODE], row[SYSTEM_STATUS] = (
        custom_mode, autopilot, base_mode, system_status,
    )  # fmt: skip
    row[RECEIVED_S] = now_s
    return same


@inner(**UNCOUNTED)
def _is_named(data: bytes, at: int, stop: int, name: bytes) -> Any:
    for k in range(len(name)):  # noqa: SIM110, as numba compiles it
        if _octet(data, at + 8 + k, stop) != name[k]:
            return False
    return True


@inner(**UNCOUNTED)
def _is_repeated(data: bytes, at: int, stop: int, msgid: Any, row: Row, one: Any, now_s: float) -> Any:
    """Whether a message that is kept elsewhere tells nothing new: where a frame lies, as before; home, whose place of
    one of ours is known; and another value than a counter of energy, or such a one as before."""
    if msgid == _HOME_POSITION:
        return row[EXTERNAL] == 0.0
    if msgid == _GPS_GLOBAL_ORIGIN:
        same = _i32(data, at, stop) == row[ORIGIN_LAT] and _i32(data, at + 4, stop) == row[ORIGIN_LON]
        return same and _i32(data, at + 8, stop) == row[ORIGIN_ALT]
    if msgid == _NAMED_VALUE_INT:
        if _is_named(data, at, stop, _RECEIVED_NAME):
            counter = 0
        elif _is_named(data, at, stop, _GIVEN_NAME):
            counter = 1
        else:
            return True
        if _i32(data, at + 4, stop) == one.told_j[counter]:
            one.told_s[counter] = now_s
            reported_s = _session_s(row, _u32(data, at, stop), now_s)
            row[RECEIVED_REPORTED_S + counter] = max(row[RECEIVED_REPORTED_S + counter], reported_s)
            return True
    return False


@inner(**UNCOUNTED)
def _read_effort(data: bytes, at: int, stop: int, row: Row, now_s: float) -> Any:
    if not _is_named(data, at, stop, _EFFORT_NAME):
        return
    value = _f32(data, at + 4, stop)
    if 0.0 <= value <= MOST_EFFORT:
        row[EFFORT] = value
        row[EFFORT_S] = _session_s(row, _u32(data, at, stop), now_s)


@inner(**UNCOUNTED)
def _cells_mv(data: bytes, at: int, stop: int) -> Any:
    """Cells up to the first that is NO_CELL, and only if there is none the further ones of newer messages."""
    total_mv = np.int64(0)
    for k in range(_CELLS):
        cell_mv = _u16(data, at + 10 + 2 * k, stop)
        if cell_mv == NO_CELL:
            return total_mv
        total_mv += cell_mv
    for k in range(_MORE_CELLS):
        total_mv += _u16(data, at + 41 + 2 * k, stop)
    return total_mv


@inner(**UNCOUNTED)
def _power_w(total_mv: int, current_ca: int) -> Any:
    if total_mv == 0 or current_ca in (_NO_CURRENT, _PX4_NO_CURRENT):
        return math.nan
    return 1e-2 * current_ca * (1e-3 * total_mv)


@inner(**UNCOUNTED)
def _count_report(
    account: Any, found: Row, row: Row, now_s: float, consumed_j: float, power_w: float, percent: int, second: bool
) -> Any:
    """Count a battery's report: whether nothing else follows from it."""
    remaining = 0.01 * percent if 0 <= percent <= 100 else math.nan
    armed = row[BASE_MODE] >= 0.0 and np.int64(row[BASE_MODE]) & _ARMED != 0
    one = account[0]
    became, bridged_s, gained_j = energy.count(one, now_s, consumed_j, power_w, remaining, second, armed)
    other = became == energy.DRAWN and energy.mean_power(one, now_s)
    row[POWER_W] = one.power_w
    found[0], found[1], found[2], found[3], found[4] = consumed_j, power_w, became, bridged_s, gained_j
    can_be = became not in (energy.IMPOSSIBLE_POWER, energy.IMPOSSIBLE_TOTAL)
    return can_be and not other and math.isnan(bridged_s) and math.isnan(gained_j)


@inner(**UNCOUNTED)
def _read_run(
    data: bytes, at: Any, end: int, now_s: float, row: Row, account: Any, kept: NDArray[np.uint8], found: Row
) -> tuple[int, int]:
    """Kernel: read the frames of one system that lie in data[begin:end], one after the other; (where the next one
    begins, why it stops)."""
    counted = False
    while at + HEADER_BYTES <= end:
        begin: Any = at + HEADER_BYTES
        msgid, stop = np.int64(data[at + 7]), min(begin + np.int64(data[at + 1]), end)
        own = data[at + 6] == _AUTOPILOT_1
        small = data[at + 8] == 0 and data[at + 9] == 0
        if own and not (small and msgid == _SYSTEM_TIME):  # it answers a grant also where the radio is out
            row[MESSAGE_S] = now_s
        elsewhere = small and (kept[msgid] == FROM_ANYBODY or (kept[msgid] == FROM_AUTOPILOT and own))
        if elsewhere and own and _is_repeated(data, begin, stop, msgid, row, account[0], now_s):
            at = stop + (15 if data[at + 2] == 1 else 2)
            continue
        if own and small and msgid == _BATTERY_STATUS:
            elsewhere = row[SEVERAL_BATTERIES] != 0.0 or _octet(data, begin + 32, stop) != 0
            elsewhere = elsewhere or _octet(data, begin + 33, stop) > _PROPULSION
        if counted and (elsewhere or (small and own and msgid in _MAY_STOP)):
            return at, BATTERY
        if elsewhere:
            return at, ELSEWHERE
        at = stop + (15 if data[at + 2] == 1 else 2)
        if not (small and own):
            continue
        if msgid == _ATTITUDE:
            _read_attitude(data, begin, stop, row)
        elif msgid == _LOCAL_POSITION_NED:
            if not _read_place(data, begin, stop, row, now_s, found):
                return at, PLACE
        elif msgid == _HEARTBEAT:
            if not _read_mode(data, begin, stop, row, now_s):
                return at, MODE
        elif msgid == _BATTERY_STATUS:
            consumed_hj = _i32(data, begin + 4, stop)
            consumed_j = math.nan if consumed_hj < 0 else HECTOJOULE * consumed_hj
            power_w = _power_w(_cells_mv(data, begin, stop), _i16(data, begin + 30, stop))
            percent = _i8(data, begin + 35, stop)
            counted = not _count_report(account, found, row, now_s, consumed_j, power_w, percent, False)
        elif msgid == _SYS_STATUS:
            total_mv = _u16(data, begin + 14, stop)
            power_w = _power_w(0 if total_mv == NO_CELL else total_mv, _i16(data, begin + 16, stop))
            percent = _i8(data, begin + 30, stop)
            counted = not _count_report(account, found, row, now_s, math.nan, power_w, percent, True)
        elif msgid == _EXTENDED_SYS_STATE:
            landed_state = _octet(data, begin + 1, stop)
            row[LANDED_REPORTED] = 1.0
            row[LANDED] = 1.0 if landed_state in (_ON_GROUND, _UNDEFINED) else 0.0
        elif msgid == _NAMED_VALUE_FLOAT:
            _read_effort(data, begin, stop, row, now_s)
    return at, BATTERY if counted else END


def _compiled(build: int) -> Callable[..., Any]:
    """The entry, the only kernel here that numba keeps on disk; `build`: checksum of the other files that it is made
    of."""

    @kernel(**UNCOUNTED)
    def read(
        data: bytes,
        at: int,
        end: int,
        lane: int,
        run: int,
        spans: NDArray[np.int64],
        runs: NDArray[np.int64],
        lanes: NDArray[np.int64],
        now_s: float,
        readings: NDArray[np.float64],
        accounts: Any,
        kept: NDArray[np.uint8],
        found: Row,
    ) -> tuple[int, int, int]:
        _ = build
        while True:
            if at < end:
                at, why = _read_run(data, at, end, now_s, readings[lane], accounts[lane : lane + 1], kept, found)
                if why != END:
                    return run, at, why
            if run == runs.shape[0]:
                return run, at, END
            at, end = spans[runs[run, FIRST], 0], spans[runs[run, LAST] - 1, 1]
            lane = lanes[runs[run, SYSID]]
            run += 1
            if lane < 0:
                return run, at, UNKNOWN

    return read


read = _compiled(checksum(energy, plausibility))
"""(data, at, end, lane, run, spans of frames (frames, 2), runs (n, COLUMNS of gcs/mavlink/datagram.py), lanes (256,) by
system id, session time, readings (vehicles, READINGS), accounts (vehicles,), kept (SMALL_IDS,), found (FOUND,)): read
the frames of the vehicle `lane` that lie in data[at:end], one after the other, and then the runs from `run` on; (which
run is next, where in the one before it the next frame begins, why it stops)."""
