"""A parameter's value with its MAV_PARAM_TYPE: exact on the wire, compared, shown, in JSON and in files.

PARAM_VALUE and PARAM_SET carry four bytes, by one of two encodings:

    bytewise  these are the value's own bytes, so that no type of 64 bits can be carried
    C cast    these are a float of the value's size: a whole number beyond 2^24 may become another one

[lineage] https://mavlink.io/en/services/parameter.html#parameter-encoding
"""

from __future__ import annotations

import math
import struct
from ctypes import c_float
from typing import NamedTuple

from gcs.mavlink.codec import WireFloat
from skytender import mavlink as mav

REAL32, REAL64 = int(mav.MAV_PARAM_TYPE_REAL32), int(mav.MAV_PARAM_TYPE_REAL64)
NO_TYPE = 0
"""MAV_PARAM_TYPE begins at 1."""
WIRE_BYTES = 4
PLAIN_BELOW = 1e15
"""Floats without a fraction are written without exponent below this."""
_PREFIX = "MAV_PARAM_TYPE_"
_CODES = {"UINT8": "<B", "INT8": "<b", "UINT16": "<H", "INT16": "<h", "UINT32": "<I", "INT32": "<i"}
_CODES |= {"UINT64": "<Q", "INT64": "<q", "REAL32": "<f", "REAL64": "<d"}
TYPE_NAMES: dict[int, str] = {int(getattr(mav, _PREFIX + name)): name for name in _CODES}
"""Name of each MAV_PARAM_TYPE."""
_FORMS = {kind: _CODES[name] for kind, name in TYPE_NAMES.items()}


class ParameterValue(NamedTuple):
    """A parameter's number, and its MAV_PARAM_TYPE. The number is an int where the type is one of integers, unless the
    vehicle says a fraction for one; a REAL32's is exactly what 32 bits hold."""

    number: int | float
    kind: int

    @property
    def text(self) -> str:
        """The shortest decimal number that reads as this one."""
        number = self.number
        if isinstance(number, int) or not math.isfinite(number):
            return str(number)
        if number.is_integer() and abs(number) < PLAIN_BELOW:
            return f"{number:.0f}" if number or math.copysign(1.0, number) > 0.0 else "-0.0"  # -0 would be an integer
        if self.kind != REAL32:
            return repr(number)
        texts = (f"{number:.{digits}g}" for digits in range(1, 10))
        return next(text for text in texts if _single(float(text)) == number)

    @property
    def json(self) -> int | float | str:
        """The number for JSON, which has none for nan and infinities: these are text."""
        if isinstance(self.number, int) or not math.isfinite(self.number):
            return self.number if isinstance(self.number, int) else self.text
        return float(self.text)


def parsed(text: str) -> int | float:
    """A number as people and files write it: decimal, hexadecimal after 0x, nan or inf. Raises ValueError."""
    if "_" in text:
        raise ValueError(f"{text!r} is no number")
    try:
        return int(text, 16 if "x" in text.lower() else 10)
    except ValueError:
        number = float(text)
    if math.isinf(number) and "inf" not in text.lower():
        raise ValueError(f"{text} is beyond every type")
    return number


def typed(number: int | float, kind: int) -> ParameterValue:
    """A number as a type holds it: a REAL32 the nearest one. Raises ValueError, in words, where the type cannot."""
    form = _form(kind)
    try:
        if kind in (REAL32, REAL64):
            (held,) = struct.unpack(form, struct.pack(form, number))
            return ParameterValue(float(held), kind)
        whole = int(number) if math.isfinite(number) else 0
        if whole != number:
            raise ValueError(f"{number:g} is no whole number, and its type is {TYPE_NAMES[kind]}")
        struct.pack(form, whole)
    except (struct.error, OverflowError):
        raise ValueError(f"{number} does not fit its type, {TYPE_NAMES[kind]}") from None
    return ParameterValue(whole, kind)


def given(number: int | float, like: ParameterValue | None) -> ParameterValue:
    """A number as another value's type holds it, where there is one that can."""
    try:
        return typed(number, like.kind if like is not None else NO_TYPE)
    except ValueError:
        return ParameterValue(number, NO_TYPE)


def cast_keeps(number: int | float) -> bool:
    """Whether the C cast to a float carries a number as it is, or as a fraction's nearest."""
    return not isinstance(number, int) or _single(number) == number


def carried(number: int | float, kind: int, *, bytewise: bool) -> ParameterValue:
    """Value that a vehicle hears of a number for a parameter of this type. Raises ValueError, in words, where this
    would be another whole number, or none."""
    value = typed(number, kind)
    return from_wire(to_wire(value, bytewise=bytewise), kind, bytewise=bytewise)


def to_wire(value: ParameterValue, *, bytewise: bool) -> WireFloat:
    """PARAM_SET's param_value. Raises ValueError, in words, where the encoding cannot carry it."""
    number, kind = value
    form = _form(kind, bytewise=bytewise)
    if bytewise:
        return WireFloat(struct.pack(form, number).ljust(WIRE_BYTES, b"\0"))
    sent = _single(number)
    if not cast_keeps(number):
        raise ValueError(f"{number} cannot be sent: this vehicle's parameters travel as floats, and {sent:.0f} is next")
    return WireFloat(struct.pack("<f", sent))


def from_wire(wire: float, kind: int, *, bytewise: bool) -> ParameterValue:
    """Value of PARAM_VALUE's param_value. Raises ValueError, in words, where the encoding cannot carry the type.

    Where the cast of a type's greatest number is beyond the type, it is read as that greatest number.
    """
    form = _form(kind, bytewise=bytewise)
    if bytewise:
        raw = wire.raw if isinstance(wire, WireFloat) else struct.pack("<f", wire)
        return ParameterValue(struct.unpack_from(form, raw)[0], kind)
    if kind in (REAL32, REAL64) or not math.isfinite(wire) or wire != int(wire):
        return ParameterValue(float(wire), kind)
    (most,) = struct.unpack(form, _greatest(form))
    return ParameterValue(most if _single(most) == wire else int(wire), kind)


def same(a: ParameterValue | None, b: ParameterValue | None) -> bool:
    """Whether two values are one number, whatever their types."""
    if a is None or b is None:
        return a is b
    return a.number == b.number or (a.number != a.number and b.number != b.number)  # nan is nothing but nan


def same_as(value: ParameterValue, number: int | float) -> bool:
    """Whether a value is this number, as its type holds it."""
    try:
        return same(value, typed(number, value.kind))
    except ValueError:
        return value.number == number


def _greatest(form: str) -> bytes:
    """Bytes of the greatest number of a type of integers."""
    size = struct.calcsize(form)
    return b"\xff" * (size - 1) + (b"\x7f" if form[-1].islower() else b"\xff")


def _form(kind: int, *, bytewise: bool = False) -> str:
    form = _FORMS.get(kind)
    if form is None:
        raise ValueError(f"its type {kind} is none of MAVLink's")
    if bytewise and struct.calcsize(form) > WIRE_BYTES:
        raise ValueError(f"its type {TYPE_NAMES[kind]} does not fit into the four bytes of PARAM_VALUE")
    return form


def _single(number: int | float) -> float:
    """The nearest number of 32 bits, infinite beyond the greatest."""
    try:
        return c_float(number).value
    except OverflowError:  # an integer beyond every float
        return math.inf if number > 0 else -math.inf
