"""ArduPilot's DataFlash log as the messages that the vehicle would have sent.

pymavlink's DFReader reads the log and sets its times by the GPS. Names of messages and fields are ArduPilot's
(libraries/AP_Logger/LogStructure.h).
"""

from __future__ import annotations

import contextlib
import io
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from gcs.extras import require
from gcs.mavlink.battery import cells_mv
from gcs.recording.importing import dataflash_plans
from gcs.recording.importing.dataflash_places import LoggedPlaces
from gcs.recording.importing.sample import ImportFailed, Sample, chunks
from skytender import mavlink as mav

TYPES = {
    "Copter": mav.MAV_TYPE_QUADROTOR,
    "Plane": mav.MAV_TYPE_FIXED_WING,
    "Rover": mav.MAV_TYPE_GROUND_ROVER,
    "Sub": mav.MAV_TYPE_SUBMARINE,
    "Tracker": mav.MAV_TYPE_ANTENNA_TRACKER,
    "Blimp": mav.MAV_TYPE_AIRSHIP,
}
"""MAV_TYPE by the word in the firmware's banner."""
ARMED, DISARMED, AUTO_ARMED, LANDED, FLYING = 10, 11, 15, 18, 28
"""Ids of EV. A copter that is ready to take off, or flies, is armed: a log that begins as it is armed may lack that."""
SYSID_NAMES = ("SYSID_THISMAV", "MAV_SYSID")
_HEARTBEAT_US = 1_000_000
_CENTI = 100.0
_MOST_VOLTS = 200.0
"""A greater voltage is in hundredths of a volt, as logs of before 2017 have it."""


def samples(path: Path, lacks: list[str]) -> Iterator[Sample]:
    """The log's flight; `lacks` as of a Reader. Raises OSError, and whatever pymavlink raises of a broken log."""
    with _opened(path) as reader:
        if "TIME" in reader.name_to_id:
            raise ImportFailed(f"{path} is a PX4 log of before ULog (sdlog2), which is not read.")
        vehicle = _Vehicle(_identity(reader), LoggedPlaces(reader))
        begin_s: float | None = None
        read = _Read()
        while (row := reader.recv_msg()) is not None:
            read.take(reader, row)
            if row.get_type() == "FMT":  # it has no time
                continue
            begin_s = row._timestamp if begin_s is None else begin_s
            t_us = round(1e6 * row._timestamp)
            boot_us = getattr(row, "TimeUS", max(t_us - round(1e6 * begin_s), 0))
            yield from vehicle.read(t_us, boot_us // 1000, row)
        lacks += read.lacks(reader)


class _Read:
    """How far a log has been read, and what of it was not."""

    def __init__(self) -> None:
        self._end = self._skipped = self._places = 0
        self._rejected: list[int] = []

    def take(self, reader: Any, row: Any) -> None:
        """The reader has come to the end of a row."""
        between = reader.offset - row.fmt.len - self._end
        self._skipped += between
        self._places += between > 0
        self._end = reader.offset
        if row.get_type() == "DSF":
            self._rejected.append(row.Dp)

    def lacks(self, reader: Any) -> Iterator[str]:
        """Rows that the vehicle could not write, and bytes that are no row."""
        if self._rejected and (count := self._rejected[-1] - self._rejected[0]) > 0:
            yield f"the vehicle could not write {count} messages of its log"
        if self._skipped:
            places = "one place" if self._places == 1 else f"{self._places} places"
            yield f"it holds {self._skipped} bytes in {places} that are no message; they were passed over"
        if left := reader.data_len - self._end:
            yield f"its last {left} bytes are no whole message"


@contextlib.contextmanager
def _opened(path: Path) -> Iterator[Any]:
    """pymavlink's reader of a log, which prints where it is broken, and closes nothing by itself."""
    require("it", {"pymavlink": "pymavlink"}, "dataflash")
    from pymavlink import DFReader  # noqa: PLC0415 - an extra

    reader: Any = DFReader.DFReader_binary.__new__(DFReader.DFReader_binary)
    reader.init_arrays_fast = reader.init_arrays  # in C it prints to the process's own standard error, and is no faster
    heap = io.StringIO()
    with contextlib.redirect_stdout(heap), contextlib.redirect_stderr(heap):
        try:
            reader.__init__(str(path))
            yield reader
        finally:
            if hasattr(reader, "filehandle"):
                reader.filehandle.close()


class _Identity(NamedTuple):
    """System id, MAV_TYPE and first mode, which a log tells after rows that are of them already."""

    sysid: int
    kind: int
    mode: int


def _identity(reader: Any) -> _Identity:
    sysid, kinds, modes = 1, list[int](), list[int]()
    while (row := reader.recv_match(type=["PARM", "MSG", "MODE"])) is not None:
        if row.get_type() == "MSG":
            kinds += [kind for word, kind in TYPES.items() if not kinds and word in row.Message]
        elif row.get_type() == "MODE":
            modes += [] if modes else [_mode(row)]
        elif row.Name in SYSID_NAMES and 1 <= row.Value <= 254:
            sysid = int(row.Value)
    reader.rewind()
    return _Identity(sysid, kinds[0] if kinds else mav.MAV_TYPE_GENERIC, modes[0] if modes else 0)


def _mode(row: Any) -> int:
    return int(row.ModeNum if hasattr(row, "ModeNum") else row.Mode)


class _Vehicle:
    """The vehicle by its log so far."""

    def __init__(self, identity: _Identity, places: LoggedPlaces) -> None:
        self._sysid, self._type = identity.sysid, identity.kind
        self._mode, self._armed, self._landed = identity.mode, False, mav.MAV_LANDED_STATE_UNDEFINED
        self._beat_us = -_HEARTBEAT_US
        self._texts = 0
        self._mission = dataflash_plans.ListedMission()
        self._places = places
        self._rates = (math.nan,) * 3

    def read(self, t_us: int, boot_ms: int, row: Any) -> Iterator[Sample]:
        """Messages that one row of the log gives."""
        name, boot = row.get_type(), {"time_boot_ms": boot_ms % (1 << 32)}
        if self._take(name, row) or not 0 <= t_us - self._beat_us < _HEARTBEAT_US:
            self._beat_us = t_us
            yield self._sample(t_us, "HEARTBEAT", self._heartbeat())
            yield self._sample(t_us, "EXTENDED_SYS_STATE", {"vtol_state": 0, "landed_state": self._landed})
        for message, fields in self._places.read(boot["time_boot_ms"], row):
            yield self._sample(t_us, message, fields)
        if name == "IMU" and not getattr(row, "I", 0):
            self._rates = (row.GyrX, row.GyrY, row.GyrZ)
        elif name == "ATT":
            angles = {"roll": row.Roll, "pitch": row.Pitch, "yaw": math.remainder(row.Yaw, 360.0)}
            angles = {axis: math.radians(degrees) for axis, degrees in angles.items()}
            yield self._sample(t_us, "ATTITUDE", {**boot, **angles, **dict(zip(_RATES, self._rates, strict=True))})
        elif name == "ORGN":
            yield from self._origin(t_us, row)
        elif name in ("BAT", "CURR"):
            yield self._sample(t_us, "BATTERY_STATUS", _battery(row))
        elif name == "GPS" and not getattr(row, "I", 0):
            yield self._sample(t_us, "GPS_RAW_INT", _gps(t_us, row))
        elif name == "MSG":
            self._texts += 1
            for fields in chunks(mav.MAV_SEVERITY_INFO, row.Message, self._texts):
                yield self._sample(t_us, "STATUSTEXT", fields)
        elif name == "PARM":
            value = {"param_id": row.Name, "param_value": row.Value, "param_type": mav.MAV_PARAM_TYPE_REAL32}
            yield self._sample(t_us, "PARAM_VALUE", {**value, "param_count": 0, "param_index": 65535})
        elif name == "CMD":
            for message, fields in self._mission.messages(row):
                yield self._sample(t_us, message, fields)
        elif name in dataflash_plans.ROWS:
            for message, fields in dataflash_plans.messages(row):
                yield self._sample(t_us, message, fields)

    def _sample(self, t_us: int, message: str, fields: dict[str, Any]) -> Sample:
        return Sample(t_us, self._sysid, message, fields)

    def _take(self, name: str, row: Any) -> bool:
        """Whether the row changes what a HEARTBEAT says."""
        before = self._mode, self._armed, self._landed
        if name == "MODE":
            self._mode = _mode(row)
        elif name == "ARM":
            self._armed = bool(row.ArmState)
        elif name == "EV":
            if row.Id in (ARMED, DISARMED, AUTO_ARMED, FLYING):
                self._armed = row.Id != DISARMED
            if row.Id in (LANDED, FLYING):
                self._landed = mav.MAV_LANDED_STATE_ON_GROUND if row.Id == LANDED else mav.MAV_LANDED_STATE_IN_AIR
        return before != (self._mode, self._armed, self._landed)

    def _heartbeat(self) -> dict[str, Any]:
        armed = mav.MAV_MODE_FLAG_SAFETY_ARMED if self._armed else 0
        return {
            "type": self._type,
            "autopilot": mav.MAV_AUTOPILOT_ARDUPILOTMEGA,
            "base_mode": mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | armed,
            "custom_mode": self._mode,
            "system_status": mav.MAV_STATE_ACTIVE if self._armed else mav.MAV_STATE_STANDBY,
            "mavlink_version": 3,
        }

    def _origin(self, t_us: int, row: Any) -> Iterator[Sample]:
        at = {"latitude": round(1e7 * row.Lat), "longitude": round(1e7 * row.Lng), "altitude": round(1e3 * row.Alt)}
        if row.Type == 0:
            yield self._sample(t_us, "GPS_GLOBAL_ORIGIN", at)
        else:
            unknown = dict.fromkeys(("x", "y", "z", "approach_x", "approach_y", "approach_z"), math.nan)
            yield self._sample(t_us, "HOME_POSITION", {**at, **unknown, "q": [math.nan] * 4})


_RATES = ("rollspeed", "pitchspeed", "yawspeed")


def _battery(row: Any) -> dict[str, Any]:
    scale = 1.0 / _CENTI if row.Volt > _MOST_VOLTS else 1.0
    volts, amperes = scale * row.Volt, scale * row.Curr
    percent, energy_wh = getattr(row, "RemPct", 255), getattr(row, "EnrgTot", None)
    return {
        "id": getattr(row, "Instance", getattr(row, "Inst", 0)),
        "battery_function": mav.MAV_BATTERY_FUNCTION_UNKNOWN,
        "type": mav.MAV_BATTERY_TYPE_UNKNOWN,
        "temperature": 32767,
        "voltages": cells_mv(volts),
        "current_battery": round(_CENTI * amperes) if abs(amperes) < 327.0 else -1,
        "current_consumed": round(row.CurrTot),
        "energy_consumed": -1 if energy_wh is None else round(36.0 * energy_wh),
        "battery_remaining": int(percent) if 0 <= percent <= 100 else -1,
    }


def _gps(t_us: int, row: Any) -> dict[str, Any]:
    return {
        "time_usec": t_us,
        "fix_type": row.Status,
        "lat": round(1e7 * row.Lat),
        "lon": round(1e7 * row.Lng),
        "alt": round(1e3 * row.Alt),
        "eph": min(round(_CENTI * row.HDop), 65535),
        "epv": 65535,
        "vel": min(round(_CENTI * row.Spd), 65535),
        "cog": round(_CENTI * row.GCrs) % 36000,
        "satellites_visible": row.NSats,
    }
