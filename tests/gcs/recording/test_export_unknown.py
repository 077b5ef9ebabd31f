"""What is not known is an empty cell: every field that MAVLink's definitions give a value for that.

The definitions are read by pymavlink's own generator, and each value is worked out here."""

from __future__ import annotations

import csv
import math
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet
import pytest
from pymavlink.dialects.v20 import ardupilotmega as mav
from pymavlink.generator.mavparse import MAVXML, PROTOCOL_2_0

from gcs.mavlink import field_units
from gcs.recording import tables
from gcs.recording.export import export

LIMITS = {
    f"{sign}INT{bits}_{end}": getattr(np.iinfo(f"{sign.lower()}int{bits}"), end.lower())
    for sign in ("", "U") for bits in (8, 16, 32, 64) for end in ("MIN", "MAX")
}  # fmt: skip


def definitions() -> dict[tuple[str, str], str]:
    """`invalid` of each field of the dialect, by message and field."""
    folder = Path(mav.__file__).parent
    files = [MAVXML(str(path), PROTOCOL_2_0) for path in folder.glob("*.xml")]
    known = {cls.msgname for cls in mav.mavlink_map.values()}
    return {
        (message.name, field.name): field.invalid
        for file in files for message in file.message if message.name in known
        for field in message.fields if field.invalid
    }  # fmt: skip


INVALID = definitions()
MESSAGES = sorted({message for message, _ in INVALID})


def value_of(text: str) -> float:
    text = text.strip("[:]")
    if text in LIMITS:
        return int(LIMITS[text])
    if text.startswith("MAV_"):
        return int(getattr(mav, text))
    return math.nan if text.lower() == "nan" else float(int(text, 16) if text.startswith("0x") else float(text))


def made(cls: Any, changed: dict[str, float]) -> Any:
    """A message whose fields are 1, but those; of an array all elements."""
    values: list[Any] = []
    for index, (name, kind) in enumerate(zip(cls.fieldnames, cls.fieldtypes, strict=True)):
        length, value = cls.array_lengths[cls.orders[index]], changed.get(name, 1)
        value = value if kind in ("float", "double") else int(value)
        values.append(b"x" if kind == "char" else [value] * length if length else value)
    return cls(*values)


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Of each message a row in which all is known, and one in which nothing is, as CSV and Parquet."""
    folder, sender, rows = tmp_path_factory.mktemp("unknown"), mav.MAVLink(None, 1, 1), []
    for name in MESSAGES:
        cls = next(cls for cls in mav.mavlink_map.values() if cls.msgname == name)
        unknown = {field: value_of(text) for (message, field), text in INVALID.items() if message == name}
        rows += [made(cls, {}), made(cls, unknown)]
    source = folder / "all.tlog"
    source.write_bytes(b"".join(struct.pack(">Q", 10**15 + k) + bytes(m.pack(sender)) for k, m in enumerate(rows)))
    found = []
    for form in ("csv", "parquet"):
        out = folder / form
        out.mkdir()
        written = tables.tables(form, out)
        assert export(source, written) == []
        written.close()
        found.append(out)
    return found[0], found[1]


def test_every_field_is_a_number_when_it_is_known_and_empty_when_it_is_not(exported: tuple[Path, Path]) -> None:
    checked = set()
    for name in MESSAGES:
        with (exported[0] / f"{name}.csv").open(newline="") as file:
            known, unknown = csv.DictReader(file)
        in_parquet = pyarrow.parquet.read_table(exported[1] / f"{name}.parquet").to_pylist()
        cls = next(cls for cls in mav.mavlink_map.values() if cls.msgname == name)
        shape = field_units.layout(cls.id)
        assert shape is not None
        for column in shape.columns:
            says = (name, column.field) in INVALID
            assert known[column.name] != "", (name, column.name)
            assert (unknown[column.name] == "") == says, (name, column.name)
            assert in_parquet[0][column.name] is not None
            assert (in_parquet[1][column.name] is None) == says, (name, column.name)
            checked |= {(name, column.field)} if says else set()
    assert checked == INVALID.keys()
    assert len(checked) > 240


def test_an_array_is_unknown_as_its_notation_says() -> None:
    sent = np.array([[math.nan, 2.0], [1.0, math.nan], [0.0, 0.0], [1.0, 0.0]])
    by_first, zeros, each = (field_units.unknown_of(text) for text in ("[NaN:]", "[0]", "[UINT16_MAX]"))
    assert by_first is not None
    assert zeros is not None
    assert each is not None
    assert [by_first.mask(sent, k).tolist() for k in (0, 1)] == [[True, False, False, False]] * 2
    assert [zeros.mask(sent, k).tolist() for k in (0, 1)] == [[False, False, True, False]] * 2  # a quaternion has zeros
    cells = np.array([[65535, 3], [3, 65535]], np.uint16)
    assert [each.mask(cells, k).tolist() for k in (0, 1)] == [[True, False], [False, True]]


def test_whole_numbers_stay_whole_and_exact(tmp_path: Path) -> None:
    cls = mav.MAVLink_gimbal_device_information_message
    serial = 2**63 + 3
    sender = mav.MAVLink(None, 1, 1)
    rows = [made(cls, {"uid": serial}), made(cls, {"uid": 0})]
    source = tmp_path / "uid.tlog"
    source.write_bytes(b"".join(struct.pack(">Q", 10**15 + k) + bytes(m.pack(sender)) for k, m in enumerate(rows)))
    written = tables.tables("csv", tmp_path)
    assert export(source, written) == []
    written.close()
    with (tmp_path / f"{cls.msgname}.csv").open(newline="") as file:
        assert [row["uid"] for row in csv.DictReader(file)] == [str(serial), ""]
