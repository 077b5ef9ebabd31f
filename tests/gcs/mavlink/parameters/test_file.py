"""Files of parameters as ArduPilot, MAVProxy, Mission Planner and QGroundControl write them, and what is none."""

from __future__ import annotations

import math
import struct
import tempfile
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gcs.mavlink.parameters.file import HEAD, FileRefused, line, of_vehicle, read
from gcs.mavlink.parameters.value import ParameterValue, typed

ANY, ONE = (0, 1), (1, 1)


@pytest.mark.parametrize(
    ("text", "saved"),
    [
        ("I16 0x10\nU8 9\n", {ANY: {"I16": 16, "U8": 9}}),
        ("I16 7 @READONLY\nU8\t9   # a remark\nF32=0.25\n", {ANY: {"I16": 7, "U8": 9, "F32": 0.25}}),
        ("NAME = -3\n\n# all\n  A\t= 1e-3\r\nB,2,\n", {ANY: {"NAME": -3, "A": 0.001, "B": 2}}),
        ("\ufeffI16 7\nU8 9", {ANY: {"I16": 7, "U8": 9}}),
        ("#NOTE: by a planner\nI16,7\nF32,0.250000\n", {ANY: {"I16": 7, "F32": 0.25}}),
        (f"{HEAD}\n1\t1\tI16\t7\t4\n1\t154\tU8\t9\t1\n", {ONE: {"I16": 7}, (1, 154): {"U8": 9}}),
        ("1 1 BIG 2147483647 6\n1 1 F 0.1 9\n", {ONE: {"BIG": 2**31 - 1, "F": float.fromhex("0x1.99999ap-4")}}),
        ("A 1\nA 2\n", {ANY: {"A": 2}}),
    ],
)  # fmt: skip
def test_each_programs_files_are_read(
    tmp_path: Path, text: str, saved: dict[tuple[int, int], dict[str, float]]
) -> None:
    (tmp_path / "a").write_text(text, encoding="utf-8")
    got = read(tmp_path / "a")
    assert got == saved
    for address, numbers in saved.items():
        assert {name: type(number) for name, number in got[address].items()} == {
            name: type(number) for name, number in numbers.items()
        }


@pytest.mark.parametrize(
    ("bad", "why"),
    [
        ("F32 0,5", "write a decimal number with a point"),
        ("F32 0.5 1", "no parameter: write NAME VALUE"),
        ("F32", "no parameter: write NAME VALUE"),
        ("F32 high", "'high' is no number"),
        ("F32 1e999", "'1e999' is no number"),
        ("A-NAME_OF_17_CHRS 1", "no name of a parameter"),
        ("NAME_OF_17_LETTER 1", "no name of a parameter"),
        ("1 1 BIG 2.14748365e+09 6", "2147483650.0 does not fit its type, INT32"),
        ("1 1 BIG 0.5 6", "no whole number"),
        ("1 1 BIG 1 11", "its type 11 is none of MAVLink's"),
        ("1 1 BIG 1 INT", "'INT' is no type"),
        ("0 1 BIG 1 6", "'0' is no id"),
        ("1 256 BIG 1 6", "'256' is no id"),
        ("@include", "write @include FILE"),
        ("@include nothing.parm", "there is no file"),
        ("@include a", "it includes itself"),
        ("@delete A", "no name of a parameter"),
    ],
)
def test_a_bad_line_is_named_with_file_and_line(tmp_path: Path, bad: str, why: str) -> None:
    file = tmp_path / "a"
    file.write_text(f"# one\nGOOD 1\n{bad}\n", encoding="utf-8")
    with pytest.raises(FileRefused) as refused:
        read(file)
    assert str(refused.value).startswith(f"{file}:3: {bad!r}: ")
    assert why in str(refused.value)
    assert len(str(refused.value).splitlines()) == 1


def test_a_file_includes_others_beside_it(tmp_path: Path) -> None:
    (tmp_path / "common").mkdir()
    (tmp_path / "a.parm").write_text("@include common/b.parm\nA 3\n")
    (tmp_path / "common" / "b.parm").write_text("@include c.parm\nA 1\nB 2 @READONLY\n")
    (tmp_path / "common" / "c.parm").write_text("C 5\n")
    assert read(tmp_path / "a.parm") == {ANY: {"A": 3, "B": 2, "C": 5}}
    (tmp_path / "common" / "c.parm").write_text("C 5\nC x\n")
    with pytest.raises(FileRefused, match=r"common/c.parm:2: 'C x': 'x' is no number"):
        read(tmp_path / "a.parm")
    (tmp_path / "common" / "c.parm").write_text("@include ../a.parm\n")
    with pytest.raises(FileRefused, match=r"c.parm:1: .*it includes itself"):
        read(tmp_path / "a.parm")


def test_a_file_without_a_parameter_and_no_file_are_refused(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("# nothing\n")
    with pytest.raises(FileRefused, match="holds no parameter"):
        read(tmp_path / "a")
    with pytest.raises(FileRefused, match="cannot be read"):
        read(tmp_path)


def test_each_vehicle_gets_its_lines_those_of_all_and_those_of_the_only_one() -> None:
    two = {(1, 1): {"A": 1}, (1, 154): {"B": 2}, (2, 1): {"A": 3}, ANY: {"C": 4}}
    assert of_vehicle(two, 1) == {1: {"A": 1, "C": 4}, 154: {"B": 2}}
    assert of_vehicle(two, 2) == {1: {"A": 3, "C": 4}}
    assert of_vehicle(two, 3) == {1: {"C": 4}}
    assert of_vehicle({(1, 1): {"A": 1}, (1, 154): {"B": 2}}, 7) == {1: {"A": 1}, 154: {"B": 2}}
    assert of_vehicle({(1, 1): {"A": 1}, (2, 1): {"A": 2}}, 7) == {}


FORMS = dict(zip(range(1, 11), "BbHhIiQqfd", strict=True))


@settings(derandomize=True, deadline=None, max_examples=60, database=None)
@given(st.sampled_from(sorted(FORMS)), st.binary(min_size=8, max_size=8), st.integers(1, 255), st.integers(1, 255))
def test_every_value_of_every_type_is_read_as_it_was_saved(kind: int, raw: bytes, sysid: int, compid: int) -> None:
    form = "<" + FORMS[kind]
    (number,) = struct.unpack_from(form, raw)
    saved = line((sysid, compid), "NAME", ParameterValue(number, kind))
    assert saved.split("\t")[4] == str(kind)
    (back,) = _read_text(saved)[sysid, compid].values()
    assert struct.pack(form, typed(back, kind).number) == struct.pack(form, number) or math.isnan(number)
    assert math.isnan(back) == (kind > 8 and math.isnan(number))


def _read_text(text: str) -> dict[tuple[int, int], dict[str, int | float]]:
    """Read a file that holds this."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "saved"
        file.write_text(text)
        return read(file)
