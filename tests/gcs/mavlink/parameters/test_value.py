"""Every MAV_PARAM_TYPE at its limits, by both encodings: on the wire, as text and in JSON, with struct as the truth."""

from __future__ import annotations

import json
import math
import struct

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.codec import WireFloat
from gcs.mavlink.parameters.value import (
    TYPE_NAMES,
    ParameterValue,
    carried,
    from_wire,
    parsed,
    same,
    same_as,
    to_wire,
    typed,
)

FORMS = dict(zip(range(1, 11), "BbHhIiQqfd", strict=True))
"""MAV_PARAM_TYPE → struct's format."""
INTEGERS = [kind for kind in FORMS if kind < 9]
NARROW = [kind for kind in FORMS if struct.calcsize(FORMS[kind]) <= 4]
WHOLE = [0, 1, -1, *(sign * (2**24 + d) for sign in (1, -1) for d in (-1, 0, 1))]
REALS = [0.0, -0.0, 1e-45, -1e-45, 1.17549435e-38, 3.4028234663852886e38, math.inf, -math.inf, math.nan, 0.1, -12.5]
MANY = settings(derandomize=True, deadline=None, max_examples=200, database=None)


def limits(kind: int) -> list[int | float]:
    """Numbers at the ends of a type, and where a float begins to lose integers."""
    if kind not in INTEGERS:
        return [*map(float, WHOLE), *REALS] + ([1.7976931348623157e308, 5e-324] if kind == 10 else [])
    bits = 8 * struct.calcsize(FORMS[kind])
    signed = FORMS[kind].islower()
    least, most = (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) if signed else (0, 2**bits - 1)
    return sorted({n for n in (least, least + 1, most - 1, most, *WHOLE) if least <= n <= most})


def bits(number: int | float, kind: int) -> bytes:
    return struct.pack("<" + FORMS[kind], number)


def over_the_wire(name: str, wire: float, kind: int) -> float:
    """param_value of a message that has been a frame."""
    rest = {
        "PARAM_SET": {"target_system": 1, "target_component": 1},
        "PARAM_VALUE": {"param_count": 1, "param_index": 0},
    }
    raw = codec.encode(name, 0, 1, 1, param_id="P", param_value=wire, param_type=kind, **rest[name])
    (frame,) = codec.split(raw).frames
    assert frame.payload[:4].ljust(4, b"\0") == (wire.raw if isinstance(wire, WireFloat) else struct.pack("<f", wire))
    got: float = codec.fields(frame).param_value
    return got


def test_the_types_are_all_of_the_dialects() -> None:
    names = {kind: entry.name for kind, entry in mav.enums["MAV_PARAM_TYPE"].items() if "ENUM_END" not in entry.name}
    assert {kind: f"MAV_PARAM_TYPE_{name}" for kind, name in TYPE_NAMES.items()} == names
    assert names.keys() == FORMS.keys()


@pytest.mark.parametrize("kind", NARROW)
@pytest.mark.parametrize("name", ["PARAM_SET", "PARAM_VALUE"])
def test_bytewise_every_value_is_its_own_bytes(name: str, kind: int) -> None:
    for number in limits(kind):
        wire = to_wire(typed(number, kind), bytewise=True)
        assert wire.raw == bits(number, kind).ljust(4, b"\0")
        back = from_wire(over_the_wire(name, wire, kind), kind, bytewise=True)
        assert bits(back.number, kind) == bits(number, kind)
        assert type(back.number) is (int if kind in INTEGERS else float)


@pytest.mark.parametrize("text", ["010080ff", "ffffbfff", "0100807f", "ffffff7f"])
def test_bytewise_an_integer_that_looks_like_a_nan_keeps_its_bits(text: str) -> None:
    raw = bytes.fromhex(text)
    wire = over_the_wire("PARAM_VALUE", WireFloat(raw), 6)
    assert from_wire(wire, 6, bytewise=True).number == struct.unpack("<i", raw)[0]


@pytest.mark.parametrize("kind", [7, 8, 10])
def test_bytewise_no_type_of_64_bits_is_read_or_sent(kind: int) -> None:
    for call in (lambda: from_wire(1.0, kind, bytewise=True), lambda: to_wire(typed(1, kind), bytewise=True)):
        with pytest.raises(ValueError, match=f"its type {TYPE_NAMES[kind]} does not fit into the four bytes"):
            call()


@pytest.mark.parametrize("kind", FORMS)
def test_cast_a_whole_number_arrives_as_it_is_or_is_refused(kind: int) -> None:
    for number in limits(kind):
        with np.errstate(over="ignore"):
            cast = float(np.float32(number))
        if kind in INTEGERS and cast != number:
            with pytest.raises(ValueError, match=f"{number} cannot be sent: .* floats, and {cast:.0f} is next"):
                carried(number, kind, bytewise=False)
            continue
        value = carried(number, kind, bytewise=False)
        assert struct.pack("<d", value.number) == struct.pack("<d", cast)
        assert type(value.number) is (int if kind in INTEGERS else float)
        assert to_wire(value, bytewise=False).raw == struct.pack("<f", cast)


def test_cast_what_is_no_integer_is_shown_as_the_vehicle_says_it() -> None:
    assert from_wire(1.5, 6, bytewise=False) == (1.5, 6)
    assert from_wire(math.nan, 6, bytewise=False).text == "nan"


@pytest.mark.parametrize("kind", [0, 11, 255])
@pytest.mark.parametrize("bytewise", [True, False])
def test_a_type_that_is_none_is_named(kind: int, bytewise: bool) -> None:
    with pytest.raises(ValueError, match=f"its type {kind} is none of MAVLink's"):
        from_wire(1.0, kind, bytewise=bytewise)


@pytest.mark.parametrize("kind", FORMS)
def test_text_and_json_read_as_the_same_bits(kind: int) -> None:
    for number in limits(kind):
        value = typed(number, kind)
        assert bits(typed(parsed(value.text), kind).number, kind) == bits(value.number, kind)
        told = json.loads(json.dumps(value.json, allow_nan=False))
        back = typed(parsed(told) if isinstance(told, str) else told, kind)
        assert bits(back.number, kind) == bits(value.number, kind)
        assert type(told) is (int if kind in INTEGERS else float if math.isfinite(number) else str)


@MANY
@given(st.binary(min_size=4, max_size=4))
def test_the_text_of_any_single_is_the_shortest_that_reads_as_it(raw: bytes) -> None:
    (number,) = struct.unpack("<f", raw)
    value = ParameterValue(number, 9)
    if math.isnan(number):
        assert value.text == "nan"
        return
    assert struct.pack("<f", parsed(value.text)) == raw
    if not number.is_integer():
        assert float(value.text) == float(str(np.float32(number)))  # numpy's shortest


@pytest.mark.parametrize("kind", INTEGERS)
def test_what_a_type_cannot_hold_is_refused_in_words(kind: int) -> None:
    least, most = limits(kind)[0], limits(kind)[-1]
    for number in (least - 1, most + 1, 1e300):
        with pytest.raises(ValueError, match=f"does not fit its type, {TYPE_NAMES[kind]}"):
            typed(number, kind)
    for number in (0.5, -1e-9, math.nan, math.inf):
        with pytest.raises(ValueError, match=f"is no whole number, and its type is {TYPE_NAMES[kind]}"):
            typed(number, kind)


def test_numbers_are_compared_exactly_whatever_their_types() -> None:
    assert not same(ParameterValue(2**24, 6), ParameterValue(2**24 + 1, 6))
    assert not same(ParameterValue(2**53, 8), ParameterValue(2**53 + 1, 8))
    assert same(ParameterValue(1, 2), ParameterValue(1.0, 9))
    assert same(ParameterValue(math.nan, 9), ParameterValue(math.nan, 9))
    assert not same(ParameterValue(math.nan, 9), ParameterValue(0.0, 9))
    assert not same(None, ParameterValue(0, 6))
    assert same(None, None)
    assert same_as(typed(0.1, 9), 0.1)
    assert not same_as(ParameterValue(2**24, 6), 2**24 + 1)


@pytest.mark.parametrize(
    ("text", "number"),
    [("0x0F", 15), ("-0X10", -16), ("007", 7), ("1e3", 1000.0), ("-0.0", -0.0), ("NaN", math.nan), ("-inf", -math.inf),
     ("18446744073709551615", 2**64 - 1)],
)  # fmt: skip
def test_numbers_are_written_as_people_do(text: str, number: int | float) -> None:
    assert struct.pack("<d", parsed(text)) == struct.pack("<d", number)
    assert type(parsed(text)) is type(number)


@pytest.mark.parametrize("text", ["", "1_0", "1,5", "0x", "high", "1e999", "9" * 5000])
def test_what_is_no_number_is_refused(text: str) -> None:
    with pytest.raises(ValueError):  # noqa: PT011 - its words are the caller's
        parsed(text)
