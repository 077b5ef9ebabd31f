"""Names, units and frames of a message's fields as columns of a table: MAVLink's own units in, SI out.

The units are those that MAVLink's definitions give (pymavlink's classes carry them). A conversion is one division or
multiplication of the number that was sent, so that a decimal stays one: 473977420 degE7 is 47.397742. Angles are in
rad; latitude and longitude stay in degrees, temperatures in °C, shares in percent, and nanoseconds whole numbers. What
MAVLink writes for "not known" (65535 mV, -1 %) becomes NaN.

`x` of a message whose name says LOCAL_NED is called `x_ned_m`. Where such a message has a `coordinate_frame` other than
1, that column is right and the name is not.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink import codec
from gcs.mavlink.dialect import CLASSES

T = TypeVar("T")
STANDARD_GRAVITY_M_S2 = 9.80665
BYTES_SHOWN = 16
"""An array of bytes longer than this is one column of hexadecimal text."""


class Scale(NamedTuple):
    """SI = sent · `times` / `over`, called by its unit's `suffix`."""

    suffix: str
    times: float = 1.0
    over: float = 1.0


_DEGREE = math.pi / 180.0
UNITS: Mapping[str, Scale] = {
    **{
        f"{prefix}{unit}": Scale(suffix, over=over)
        for unit, suffix in {"s": "s", "m": "m", "m/s": "m_s", "V": "v", "A": "a", "%": "percent"}.items()
        for prefix, over in {"": 1.0, "d": 1e1, "c": 1e2, "m": 1e3, "u": 1e6}.items()
    },
    "ns": Scale("ns"),
    "dam": Scale("m", 10.0),
    "cm^2": Scale("m2", over=1e4),
    "l": Scale("m3", over=1e3),
    "cm^3": Scale("m3", over=1e6),
    "cm^3/min": Scale("m3_s", over=6e7),
    "m/s*5": Scale("m_s", over=5.0),
    "m/s/s": Scale("m_s2"),
    "mG": Scale("m_s2", STANDARD_GRAVITY_M_S2, 1e3),
    "rad": Scale("rad"),
    "deg": Scale("rad", _DEGREE),
    "deg/2": Scale("rad", 2.0 * _DEGREE),
    "cdeg": Scale("rad", _DEGREE, 1e2),
    "degE5": Scale("rad", _DEGREE, 1e5),
    "degE7": Scale("deg", over=1e7),
    "rad/s": Scale("rad_s"),
    "mrad/s": Scale("rad_s", over=1e3),
    "deg/s": Scale("rad_s", _DEGREE),
    "cdeg/s": Scale("rad_s", _DEGREE, 1e2),
    "ddeg/s": Scale("rad_s", _DEGREE, 1e1),
    "rpm": Scale("rad_s", math.pi, 30.0),
    "Hz": Scale("hz"),
    "degC": Scale("degc"),
    "cdegC": Scale("degc", over=1e2),
    "Pa": Scale("pa"),
    "hPa": Scale("pa", 1e2),
    "mbar": Scale("pa", 1e2),
    "kPa": Scale("pa", 1e3),
    "gauss": Scale("t", over=1e4),
    "mgauss": Scale("t", over=1e7),
    "mAh": Scale("c", 3.6),
    "Ah": Scale("c", 3600.0),
    "hJ": Scale("j", 1e2),
    "W": Scale("w"),
    "g": Scale("kg", over=1e3),
    "kg": Scale("kg"),
    "dB": Scale("db"),
    "pix": Scale("pixels"),
    "bytes": Scale("bytes"),
    "KiB/s": Scale("bytes_s", 1024.0),
    "MiB": Scale("bytes", 1048576.0),
    "MiB/s": Scale("bytes_s", 1048576.0),
    "bits/s": Scale("bits_s"),
}


def _by_field(tables: Mapping[T, Mapping[str, str]]) -> dict[tuple[str, str], T]:
    """By (message, field), from each value's messages with their fields."""
    return {
        (message, field): value
        for value, fields in tables.items()
        for message, names in fields.items()
        for field in names.split()
    }


_U8, _U16, _U32, _I8, _I16, _I32 = 255, 65535, 4294967295, 127, 32767, 2147483647
UNKNOWN: Mapping[tuple[str, str], float] = _by_field(
    {
        -1: {
            "SYS_STATUS": "current_battery battery_remaining",
            "BATTERY_STATUS": "current_battery current_consumed energy_consumed battery_remaining",
            "HIGH_LATENCY2": "battery",
            "CONTROL_SYSTEM_STATE": "airspeed",
            "HIL_OPTICAL_FLOW": "distance",
        },
        _U8: {
            "DISTANCE_SENSOR": "covariance",
            "LOGGING_DATA": "first_message_offset",
            "LOGGING_DATA_ACKED": "first_message_offset",
        },
        _U16: {
            "SYS_STATUS": "voltage_battery",
            "BATTERY_STATUS": "voltages",
            **dict.fromkeys(("GPS_RAW_INT", "GPS2_RAW", "HIL_GPS"), "vel cog"),
            "GLOBAL_POSITION_INT": "hdg",
            "OBSTACLE_DISTANCE": "distances",
        },
        _U32: {
            "ONBOARD_COMPUTER_STATUS": "ram_usage ram_total storage_usage storage_total "
            "link_tx_rate link_rx_rate link_tx_max link_rx_max"
        },
        _I8: {"ONBOARD_COMPUTER_STATUS": "temperature_board temperature_core"},
        _I16: {"BATTERY_STATUS": "temperature", "WINCH_STATUS": "temperature", "ONBOARD_COMPUTER_STATUS": "fan_speed"},
        _I32: {"CAMERA_FOV_STATUS": "lat_camera lon_camera alt_camera lat_image lon_image alt_image"},
    }
)
"""Value that MAVLink's definitions give a field when it is not known (their attribute `invalid`), where that is a
number that would pass for a measurement and the field has a unit. 0 is left as it is: it may be one."""

_NED = {
    "LOCAL_POSITION_NED": "x y z vx vy vz",
    "LOCAL_POSITION_NED_COV": "x y z vx vy vz ax ay az",
    **dict.fromkeys(("POSITION_TARGET_LOCAL_NED", "SET_POSITION_TARGET_LOCAL_NED"), "x y z vx vy vz afx afy afz"),
    **dict.fromkeys(("POSITION_TARGET_GLOBAL_INT", "SET_POSITION_TARGET_GLOBAL_INT"), "vx vy vz afx afy afz"),
    **dict.fromkeys(("GLOBAL_POSITION_INT", "GLOBAL_POSITION_INT_COV", "UTM_GLOBAL_POSITION"), "vx vy vz"),
    **dict.fromkeys(("HIL_STATE", "HIL_STATE_QUATERNION"), "vx vy vz"),
    **dict.fromkeys(("HOME_POSITION", "SET_HOME_POSITION", "ATT_POS_MOCAP"), "x y z"),
    **dict.fromkeys(("SIM_STATE", "GPS_INPUT", "HIL_GPS"), "vn ve vd"),
    "FOLLOW_TARGET": "vel acc",
}
_RATES, _IMU = "rollspeed pitchspeed yawspeed", "xacc yacc zacc xgyro ygyro zgyro xmag ymag zmag"
_BODY = {
    **dict.fromkeys(("ATTITUDE", "ATTITUDE_QUATERNION", "ATTITUDE_QUATERNION_COV"), _RATES),
    **dict.fromkeys(("HIL_STATE", "HIL_STATE_QUATERNION"), f"{_RATES} xacc yacc zacc"),
    "SIM_STATE": "xacc yacc zacc xgyro ygyro zgyro",
    **dict.fromkeys(("SCALED_IMU", "SCALED_IMU2", "SCALED_IMU3"), _IMU),
    **dict.fromkeys(("RAW_IMU", "HIGHRES_IMU", "HIL_SENSOR"), _IMU),
}
_FRAMES = _by_field({"ned": _NED, "body": _BODY})
# A unit that a field's name ends with already; the column says its own.
_SAID = re.compile(r"_(ns|usec|us|ms|s|mm|cm|m|cdeg|deg|int|mah|ma|mv|cv|pct|percent)$")
OWN = ("time_s", "sysid", "compid", "direction")
"""The columns that every message's table begins with."""


Values = NDArray[Any] | list[str]


class FieldColumn(NamedTuple):
    """One column of a message's table, from field `field`, for an array its `element`."""

    name: str
    field: str
    element: int | None
    scale: Scale | None
    unknown: float | None
    kind: str
    """`number`, `text` or `bytes`"""

    def values(self, sent: NDArray[Any]) -> Values:
        """This column of what was sent in `field`, (n,) or (n, elements): SI, unknown values NaN."""
        if self.element is not None:
            sent = sent[:, self.element]
        if self.kind == "text":
            return [bytes(text).partition(b"\0")[0].decode("utf-8", "replace") for text in sent.tolist()]
        if self.kind == "bytes":
            return [row.tobytes().hex() for row in sent]
        _, times, over = self.scale or Scale("")
        if self.unknown is None and times == over == 1.0:
            return np.ascontiguousarray(sent)
        si = sent.astype(np.float64) * times / over
        if self.unknown is not None:
            si[sent == self.unknown] = np.nan
        return si


class MessageTable(NamedTuple):
    """A message as a table."""

    name: str
    columns: tuple[FieldColumn, ...]


@cache
def layout(msgid: int) -> MessageTable | None:
    """The table of a message; None for an id that is in no dialect that pymavlink ships."""
    cls = CLASSES.get(msgid)
    if cls is None:
        return None
    wire = codec.layout(msgid)
    form = dict(zip(wire.record._fields, wire.formats, strict=True))
    columns: list[FieldColumn] = []
    taken = set(OWN)
    for name in cls.fieldnames:
        scale = _scale(cls.fieldunits_by_name.get(name, ""))
        unknown = UNKNOWN.get((cls.msgname, name))
        title = _title(cls.msgname, name, scale, taken)
        taken.add(title)
        elements = int(form[name][:-1] or 1) if form[name][-1] != "s" and len(form[name]) > 1 else 0
        if form[name][-1] == "s":
            columns.append(FieldColumn(title, name, None, None, None, "text"))
        elif form[name][-1] in "Bb" and elements > BYTES_SHOWN and scale is None:
            columns.append(FieldColumn(f"{title}_hex", name, None, None, None, "bytes"))
        elif elements:
            stem, suffix = (
                (title, "") if scale is None else (title.removesuffix(f"_{scale.suffix}"), f"_{scale.suffix}")
            )
            columns += [
                FieldColumn(f"{stem}_{index}{suffix}", name, index, scale, unknown, "number")
                for index in range(elements)
            ]
        else:
            columns.append(FieldColumn(title, name, None, scale, unknown, "number"))
    return MessageTable(cls.msgname, tuple(columns))


def _scale(unit: str) -> Scale | None:
    if not unit:
        return None
    return UNITS.get(unit) or Scale(re.sub(r"[^a-z0-9]+", "_", unit.lower()).strip("_"))


def _title(message: str, field: str, scale: Scale | None, taken: set[str]) -> str:
    """`vx_ned_m_s`; a field whose column's name is taken keeps its own name in front: `field_seq`."""
    stem = field.lower()
    if scale is not None:
        stem = _SAID.sub("", stem)
    if frame := _FRAMES.get((message, field)):
        stem = f"{stem}_{frame}"
    title = stem if scale is None else f"{stem}_{scale.suffix}"
    if title in taken:
        title = f"sent_{title}"
    return title if title not in taken else f"{title}_{field.lower()}"
