"""PX4's ULog as the messages that the vehicle would have sent. pyulog reads the log; names of topics and fields are
PX4's (msg/*.msg)."""

from __future__ import annotations

import contextlib
import io
import math
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pyulog import ULog

from gcs.mavlink.battery import cells_mv
from gcs.mavlink.parameters.value import ParameterValue, to_wire
from gcs.recording.importing.sample import Sample, chunks
from skytender import mavlink as mav

MODES = {
    0: (1, 0), 1: (2, 0), 2: (3, 0), 3: (4, 4), 4: (4, 3), 5: (4, 5), 6: (3, 2), 8: (11, 0), 10: (5, 0), 12: (4, 6),
    13: (10, 0), 14: (6, 0), 15: (7, 0), 17: (4, 2), 18: (4, 6), 19: (4, 8), 20: (4, 9), 21: (3, 1), 22: (4, 10),
    **{number: (4, number - 12) for number in range(23, 31)},
}  # fmt: skip
"""nav_state of vehicle_status → main and sub mode of PX4's custom mode."""
ARMED = 2
"""arming_state of vehicle_status."""
TOPICS = (
    *("vehicle_local_position", "vehicle_attitude", "vehicle_status", "vehicle_land_detected", "home_position"),
    *("battery_status", "vehicle_gps_position", "sensor_gps", "vehicle_global_position"),
)
_DEGE7 = 1e7


def samples(path: Path, lacks: list[str]) -> Iterator[Sample]:
    """The log's flight, in order of time; `lacks` as of a Reader. Raises OSError, and all that pyulog raises."""
    with path.open("rb") as file, contextlib.redirect_stdout(io.StringIO()):  # it prints
        log = ULog(file, message_name_filter_list=list(TOPICS))
    lacks += _lacks(log)
    sysid = int(log.initial_parameters.get("MAV_SYS_ID", 1))
    sysid = sysid if 1 <= sysid <= 254 else 1
    said: list[tuple[int, str, dict[str, Any]]] = []
    for data in log.data_list:
        if (make := _MAKERS.get(data.name)) and (data.multi_id == 0 or data.name == "battery_status"):
            said += ((int(row.timestamp), *one) for row in _rows(data.data) for one in make(row, data.multi_id))
    for number, text in enumerate(log.logged_messages):
        parts = chunks(text.log_level - ord("0"), text.message, number)
        said += ((int(text.timestamp), "STATUSTEXT", fields) for fields in parts)
    tables = {data.name: data.data for data in log.data_list if data.multi_id == 0}
    if "vehicle_local_position" not in tables:
        said += _globals(tables)
    said += _states(tables)
    if said:
        said += _parameters(log, min(t_us for t_us, *_ in said))
    utc_us = _utc_offset_us(log)
    for t_us, message, fields in sorted(said, key=lambda one: one[0]):
        yield Sample(t_us + utc_us, sysid, message, fields)


def _lacks(log: ULog) -> Iterator[str]:
    """Dropouts, during which the vehicle could not write its log, and bytes that are no message."""
    if log.dropouts:
        longest = max(log.dropouts, key=lambda one: one.duration)
        total_s, at_s = sum(one.duration for one in log.dropouts) / 1e3, (longest.timestamp - log.start_timestamp) / 1e6
        if len(log.dropouts) == 1:
            yield f"the vehicle could not write its log for {total_s:.3g} s at {at_s:.1f} s"
        else:
            which = f"the longest {longest.duration / 1e3:.3g} s at {at_s:.1f} s"
            yield f"the vehicle could not write its log {len(log.dropouts)} times, {total_s:.3g} s in all, {which}"
    if log.file_corruption:
        yield "it holds bytes that are no ULog message; they were passed over"


def _rows(columns: dict[str, NDArray[Any]]) -> Iterator[SimpleNamespace]:
    """A topic's samples; `q[0]` is read as q0."""
    names = [name.replace("[", "").replace("]", "") for name in columns]
    for values in zip(*(column.tolist() for column in columns.values()), strict=True):
        yield SimpleNamespace(**dict(zip(names, values, strict=True)))


def _utc_offset_us(log: ULog) -> int:
    """The offset from the vehicle's time to the Unix epoch, by the first fix that says it; 0 where none does."""
    for data in log.data_list:
        utc_us = data.data.get("time_utc_usec")
        if utc_us is not None and (known := np.flatnonzero(utc_us > 0)).size:
            return int(utc_us[known[0]]) - int(data.data["timestamp"][known[0]])
    return 0


def _parameters(log: ULog, begin_us: int) -> Iterator[tuple[int, str, dict[str, Any]]]:
    """PARAM_VALUE of each parameter when the flight begins, and of each that is set later."""
    first = ((begin_us, name, number) for name, number in log.initial_parameters.items())
    for t_us, name, number in (*first, *log.changed_parameters):
        kind = mav.MAV_PARAM_TYPE_INT32 if isinstance(number, int) else mav.MAV_PARAM_TYPE_REAL32
        wire = to_wire(ParameterValue(number, kind), bytewise=True)
        fields = {"param_id": name, "param_value": wire, "param_type": kind, "param_count": 0, "param_index": 65535}
        yield int(t_us), "PARAM_VALUE", fields


def _states(tables: dict[str, dict[str, NDArray[Any]]]) -> Iterator[tuple[int, str, dict[str, Any]]]:
    """HEARTBEAT and EXTENDED_SYS_STATE once a second and at each change."""
    status = tables.get("vehicle_status")
    if status is None:
        return
    landing = tables.get("vehicle_land_detected")
    for k, t_us in enumerate(status["timestamp"].tolist()):
        armed = int(status["arming_state"][k]) == ARMED
        main, sub = MODES.get(int(status["nav_state"][k]), (0, 0))
        yield (
            t_us,
            "HEARTBEAT",
            {
                "type": int(status["system_type"][k]) if "system_type" in status else mav.MAV_TYPE_QUADROTOR,
                "autopilot": mav.MAV_AUTOPILOT_PX4,
                "base_mode": mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | (mav.MAV_MODE_FLAG_SAFETY_ARMED if armed else 0),
                "custom_mode": main << 16 | sub << 24,
                "system_status": mav.MAV_STATE_ACTIVE if armed else mav.MAV_STATE_STANDBY,
                "mavlink_version": 3,
            },
        )
        landed = mav.MAV_LANDED_STATE_UNDEFINED
        if landing is not None and (at := int(np.searchsorted(landing["timestamp"], t_us, side="right")) - 1) >= 0:
            landed = mav.MAV_LANDED_STATE_ON_GROUND if landing["landed"][at] else mav.MAV_LANDED_STATE_IN_AIR
        yield t_us, "EXTENDED_SYS_STATE", {"vtol_state": 0, "landed_state": landed}


def _globals(tables: dict[str, dict[str, NDArray[Any]]]) -> Iterator[tuple[int, str, dict[str, Any]]]:
    """GLOBAL_POSITION_INT of a log without local positions: above home, or above the lowest place where home is not
    told."""
    rows = [row for row in _rows(tables.get("vehicle_global_position", {})) if _is_fixed(row)]
    homes = [row.alt for row in _rows(tables.get("home_position", {})) if math.isfinite(row.alt)]
    home_m = homes[-1] if homes else min((row.alt for row in rows), default=0.0)
    for row in rows:
        speeds = (getattr(row, f"vel_{axis}", 0.0) for axis in "ned")
        yield (
            row.timestamp,
            "GLOBAL_POSITION_INT",
            {
                "time_boot_ms": row.timestamp // 1000 % (1 << 32),
                "lat": round(_DEGE7 * row.lat),
                "lon": round(_DEGE7 * row.lon),
                "alt": round(1e3 * row.alt),
                "relative_alt": round(1e3 * (row.alt - home_m)),
                **{name: round(100.0 * v) for name, v in zip(("vx", "vy", "vz"), speeds, strict=True)},
                "hdg": 65535,
            },
        )


def _is_fixed(row: SimpleNamespace) -> bool:
    valid = getattr(row, "lat_lon_valid", True) and getattr(row, "alt_valid", True)
    return bool(valid) and all(map(math.isfinite, (row.lat, row.lon, row.alt)))


_Made = Iterator[tuple[str, dict[str, Any]]]


def _local(row: SimpleNamespace, _: int) -> _Made:
    boot_ms = row.timestamp // 1000 % (1 << 32)
    if row.xy_valid and row.z_valid:
        names = ("x", "y", "z", "vx", "vy", "vz")
        yield "LOCAL_POSITION_NED", {"time_boot_ms": boot_ms, **{name: getattr(row, name) for name in names}}
    if row.xy_global and (row.ref_lat, row.ref_lon) != (0.0, 0.0) and math.isfinite(row.ref_alt):
        yield (
            "GPS_GLOBAL_ORIGIN",
            {
                "latitude": round(_DEGE7 * row.ref_lat),
                "longitude": round(_DEGE7 * row.ref_lon),
                "altitude": round(1e3 * row.ref_alt),
            },
        )


def _attitude(row: SimpleNamespace, _: int) -> _Made:
    """Roll, pitch and yaw of the quaternion w, x, y, z from FRD to NED."""
    w, x, y, z = row.q0, row.q1, row.q2, row.q3
    angles = {
        "roll": math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y)),
        "pitch": math.asin(min(max(2.0 * (w * y - z * x), -1.0), 1.0)),
        "yaw": math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z)),
    }
    rates = {f"{axis}speed": float(getattr(row, f"{axis}speed", 0.0)) for axis in angles}
    yield "ATTITUDE", {"time_boot_ms": row.timestamp // 1000 % (1 << 32), **angles, **rates}


def _home(row: SimpleNamespace, _: int) -> _Made:
    if math.isfinite(row.lat) and math.isfinite(row.lon) and math.isfinite(row.alt):
        unknown = dict.fromkeys(("approach_x", "approach_y", "approach_z"), math.nan)
        yield (
            "HOME_POSITION",
            {
                "latitude": round(_DEGE7 * row.lat),
                "longitude": round(_DEGE7 * row.lon),
                "altitude": round(1e3 * row.alt),
                **{axis: getattr(row, axis) for axis in "xyz"},
                "q": [math.nan] * 4,
                **unknown,
            },
        )


def _battery(row: SimpleNamespace, number: int) -> _Made:
    volts, amperes = row.voltage_v, row.current_a
    share = row.remaining
    yield (
        "BATTERY_STATUS",
        {
            "id": number,
            "battery_function": mav.MAV_BATTERY_FUNCTION_UNKNOWN,
            "type": mav.MAV_BATTERY_TYPE_UNKNOWN,
            "temperature": 32767,
            "voltages": cells_mv(volts),
            "current_battery": round(100.0 * amperes) if 0.0 <= amperes < 327.0 else -1,
            "current_consumed": round(row.discharged_mah) if row.discharged_mah >= 0.0 else -1,
            "energy_consumed": -1,
            "battery_remaining": round(100.0 * share) if 0.0 <= share <= 1.0 else -1,
        },
    )


_MAKERS: dict[str, Callable[[SimpleNamespace, int], _Made]] = {
    "vehicle_local_position": _local,
    "vehicle_attitude": _attitude,
    "home_position": _home,
    "battery_status": _battery,
}
