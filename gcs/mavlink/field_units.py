"""Names, units and frames of a message's fields as columns of a table: MAVLink's own units in, SI out.

The units are those that MAVLink's definitions give. A conversion is one division or
multiplication of the number that was sent, so that a decimal stays one: 473977420 degE7 is 47.397742. Angles are in
rad; latitude and longitude stay in degrees, temperatures in °C, shares in percent, and nanoseconds whole numbers. What
MAVLink sends for "not known" (65535 mV, -1 %, 255 satellites) is NaN, or masked.

`x` of a message whose name says LOCAL_NED is called `x_ned_m`. Where such a message has a `coordinate_frame` other than
1, that column is right and the name is not.
"""

from __future__ import annotations

import contextlib
import math
import re
from collections.abc import Mapping
from functools import cache
from typing import Any, Literal, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink import codec
from skytender import mavlink
from skytender.mavlink import MESSAGES

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


class Unknown(NamedTuple):
    """Value that MAVLink's definitions send in a field that is not known (their attribute `invalid`)."""

    value: float
    of: Literal["element", "array by its first", "array"] = "element"
    """what is not known where an element, the first one, or each has this value"""

    def mask(self, sent: NDArray[Any], element: int | None) -> NDArray[np.bool_]:
        """(n,) whether the field, (n,) or of an array (n, elements) this element, is not known."""
        if element is None or self.of != "array":
            one = sent if element is None else sent[:, 0 if self.of == "array by its first" else element]
            return np.isnan(one) if math.isnan(self.value) else np.asarray(one == self.value)
        return np.asarray((sent == self.value).all(axis=1))


_LIMIT = re.compile(r"(U?)INT(\d+)_(MAX|MIN)")


def _sent_value(text: str) -> float:
    """A value of `invalid`: a number, a limit of a type, or an entry of an enumeration. Raises ValueError."""
    if limit := _LIMIT.fullmatch(text):
        info = np.iinfo(f"{limit[1].lower()}int{limit[2]}")
        return int(info.max if limit[3] == "MAX" else info.min)
    if hasattr(mavlink, text):
        return int(getattr(mavlink, text))
    return int(text, 0) if re.fullmatch(r"-?\d+|0[xX][0-9a-fA-F]+", text) else float(text)


def unknown_of(invalid: str) -> Unknown | None:
    """Meaning of the attribute; None where it has none, or a NaN that is one in a table as well. Raises ValueError.

    `[x]`: an element that is x; `[x:]`: the array whose first element is x. Of `[0]` it is the array of zeros, for a
    quaternion has some.
    """
    inner = re.fullmatch(r"\[([^:,]+)(:?)\]", invalid)
    if not invalid:
        return None
    value = _sent_value(inner[1] if inner else invalid)
    of: Literal["element", "array by its first", "array"] = "element"
    if inner:
        of = "array by its first" if inner[2] else "element" if value else "array"
    return None if math.isnan(value) and of == "element" else Unknown(value, of)


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
    unknown: Unknown | None
    kind: str
    """`number`, `text` or `bytes`"""

    def values(self, sent: NDArray[Any]) -> Values:
        """This column of what was sent in `field`, (n,) or (n, elements), in SI; a value that is not known is NaN, of
        whole numbers masked."""
        if self.kind == "text":
            return [bytes(text).partition(b"\0")[0].decode("utf-8", "replace") for text in sent.tolist()]
        if self.kind == "bytes":
            return [row.tobytes().hex() for row in sent]
        _, times, over = self.scale or Scale("")
        column = np.ascontiguousarray(sent if self.element is None else sent[:, self.element])
        if times != 1.0 or over != 1.0:
            column = column.astype(np.float64) * times / over
        if self.unknown is None:
            return column
        mask = self.unknown.mask(sent, self.element)
        return np.where(mask, np.nan, column) if column.dtype.kind == "f" else np.ma.masked_array(column, mask)


class MessageTable(NamedTuple):
    """A message as a table."""

    name: str
    columns: tuple[FieldColumn, ...]


@cache
def layout(msgid: int) -> MessageTable | None:
    """The table of a message; None for an id that the dialect lacks."""
    known = MESSAGES.get(msgid)
    if known is None:
        return None
    wire = codec.layout(msgid)
    form = dict(zip(wire.record._fields, wire.formats, strict=True))
    columns: list[FieldColumn] = []
    taken = set(OWN)
    for field in (*known.base, *known.extensions):
        name, scale, unknown = field.name, _scale(field.units), None
        with contextlib.suppress(ValueError):  # a notation to come: the field is as it was sent
            unknown = unknown_of(field.invalid)
        title = _title(known.name, name, scale, taken)
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
    return MessageTable(known.name, tuple(columns))


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
