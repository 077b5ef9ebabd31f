"""`gcs export` of parameters: numbers of every type at its limits, by the encoding of the vehicle that has them."""

from __future__ import annotations

import csv
import math
import struct
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet
import pytest
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.recording import tables
from gcs.recording.export import export

PX4, ARDUPILOT, NO_AUTOPILOT = 12, 3, 8
PARAM_ENCODE_BYTEWISE, PARAM_ENCODE_C_CAST = 16, 131072
CODES = {1: "<B", 2: "<b", 3: "<H", 4: "<h", 5: "<I", 6: "<i", 9: "<f"}
"""Of each MAV_PARAM_TYPE that fits into four bytes."""
WIDE = {7: "<Q", 8: "<q", 10: "<d"}


def numbers(kind: int) -> list[Any]:
    """Limits of a type, zero, and what a float has no exact number for."""
    if kind == 9:
        greatest = float(np.finfo(np.float32).max)
        return [0.0, -greatest, greatest, float(np.float32(0.1)), float(np.finfo(np.float32).smallest_subnormal)]
    info = np.iinfo(CODES[kind].replace("<", "=") if kind in CODES else WIDE[kind].replace("<", "="))
    return sorted({int(info.min), 0, 1, int(info.max), min(16_777_217, int(info.max))})


class Recording:
    """Frames of vehicle 1 and of a station, ten a second."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._out: list[bytes] = []

    def add(self, message: Any, of: tuple[int, int] = (1, 1), four: bytes = b"") -> None:
        """`four`: the bytes of param_value, its first field, which a float would not keep where it is a NaN."""
        packed = bytes(message.pack(mav.MAVLink(None, *of)))
        body = packed[1:10] + four + packed[10 + len(four) : -2]
        stamp = struct.pack(">Q", 1_767_225_600_000_000 + 100_000 * len(self._out))
        crc = mav.x25crc(body + bytes([message.crc_extra])).crc
        self._out.append(stamp + packed[:1] + body + struct.pack("<H", crc))

    def value(self, four: bytes, kind: int, of: tuple[int, int] = (1, 1)) -> None:
        self.add(mav.MAVLink_param_value_message(b"P", 1.5, kind, 1, 0), of, four)

    def set(self, four: bytes, kind: int, to: tuple[int, int] = (1, 1)) -> None:
        self.add(mav.MAVLink_param_set_message(*to, b"P", 1.5, kind), (255, 190), four)

    def beat(self, autopilot: int, of: tuple[int, int] = (1, 1)) -> None:
        self.add(mav.MAVLink_heartbeat_message(2, autopilot, 0x81, 0, 4, 3), of)

    def capable(self, bits: int, of: tuple[int, int] = (1, 1)) -> None:
        self.add(mav.MAVLink_autopilot_version_message(bits, 0, 0, 0, 0, [0] * 8, [0] * 8, [0] * 8, 0, 0, 0), of)

    def exported(self, table: str) -> list[float]:
        """Its numbers, from CSV and Parquet alike; NaN where the cell is empty."""
        self.path.write_bytes(b"".join(self._out))
        found = []
        for form in ("csv", "parquet"):
            out = self.path.parent / f"{table}-{form}"
            out.mkdir()
            written = tables.tables(form, out)  # type: ignore[arg-type]
            assert export(self.path, written) == []
            written.close()
            if form == "csv":
                with (out / f"{table}.csv").open() as file:
                    cells: Iterable[Any] = [row["param_value"] for row in csv.DictReader(file)]
            else:
                cells = pyarrow.parquet.read_table(out / f"{table}.parquet")["param_value"].to_pylist()
            found.append([math.nan if cell in ("", None) else float(cell) for cell in cells])
        np.testing.assert_array_equal(found[0], found[1])
        return found[0]


@pytest.fixture
def recording(tmp_path: Path) -> Recording:
    return Recording(tmp_path / "flight.tlog")


@pytest.mark.parametrize("table", ["PARAM_VALUE", "PARAM_SET"])
def test_bytes_of_a_px4_are_its_numbers_and_what_four_bytes_cannot_hold_is_empty(
    recording: Recording, table: str
) -> None:
    recording.beat(PX4)
    expected = []
    for kind in (*CODES, *WIDE):
        for number in numbers(kind) if kind in CODES else [math.nan]:
            four = struct.pack(CODES[kind], number).ljust(4, b"\0") if kind in CODES else b"\1\2\3\4"
            recording.value(four, kind) if table == "PARAM_VALUE" else recording.set(four, kind)
            expected.append(number)
    np.testing.assert_array_equal(recording.exported(table), expected)


@pytest.mark.parametrize("table", ["PARAM_VALUE", "PARAM_SET"])
def test_floats_of_an_ardupilot_are_its_numbers(recording: Recording, table: str) -> None:
    """As near as a float is; the limit of a type whose float is beyond it is that limit."""
    recording.beat(ARDUPILOT)
    expected = []
    for kind in (*CODES, *WIDE):
        sent = [0.5, -2.0] if kind == 10 else numbers(kind)
        for number in sent:
            four = struct.pack("<f", number)
            recording.value(four, kind) if table == "PARAM_VALUE" else recording.set(four, kind)
        cast = [float(np.float32(number)) for number in sent]
        expected += [*cast[:-1], float(sent[-1])] if kind in (5, 6) else cast
    assert recording.exported(table) == expected


SEVEN = struct.pack("<i", 7)


def test_capabilities_count_before_the_autopilots_name(recording: Recording) -> None:
    recording.beat(ARDUPILOT)
    recording.capable(PARAM_ENCODE_BYTEWISE)
    recording.value(SEVEN, 6)
    recording.beat(PX4, (2, 1))
    recording.capable(PARAM_ENCODE_C_CAST, (2, 1))
    recording.value(struct.pack("<f", 7.0), 6, (2, 1))
    assert recording.exported("PARAM_VALUE") == [7.0, 7.0]


@pytest.mark.parametrize("bits", [0, PARAM_ENCODE_BYTEWISE | PARAM_ENCODE_C_CAST])
def test_capabilities_that_say_neither_or_both_say_nothing(recording: Recording, bits: int) -> None:
    recording.beat(PX4)
    recording.capable(bits)
    recording.value(SEVEN, 6)
    assert recording.exported("PARAM_VALUE") == [7.0]


def test_vehicles_beside_each_other_keep_their_encodings(recording: Recording) -> None:
    """A component without a word of its own has its vehicle's; what came before the first HEARTBEAT counts as well."""
    recording.value(SEVEN, 6)
    recording.value(struct.pack("<f", 7.0), 6, (2, 1))
    recording.value(SEVEN, 6, (1, 154))
    recording.beat(PX4)
    recording.beat(ARDUPILOT, (2, 1))
    recording.beat(NO_AUTOPILOT, (1, 154))
    recording.set(SEVEN, 6, (1, 154))
    recording.set(struct.pack("<f", 7.0), 6, (2, 0))
    assert recording.exported("PARAM_VALUE") == [7.0, 7.0, 7.0]
    assert recording.exported("PARAM_SET") == [7.0, 7.0]
