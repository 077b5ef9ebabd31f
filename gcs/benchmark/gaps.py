"""Gaps between the proven bound and the best verified schedule of an instance, and tables of gaps and other results.

A table is a file of JSON lines. Each result is appended as soon as it is there, so that a long run can be interrupted
and continued. gaps.jsonl holds the gaps of the 300 shipped instances.
"""

from __future__ import annotations

from importlib import resources
from pathlib import Path
from typing import TypeVar

import msgspec
from msgspec import Struct

from gcs.benchmark.format import FormatError


class Gap(Struct):
    """Bounds on the least number of receivers that a schedule of an instance loses."""

    instance: str
    lower: int
    """every schedule loses at least this many"""
    upper: int | None
    """a verified schedule loses this many; None: none was found that can be carried out"""
    cpu_s: float
    """processor time that was used"""

    @property
    def proven(self) -> bool:
        """Whether the schedule is an optimum."""
        return self.lower == self.upper


Row = TypeVar("Row", bound=Struct)


def read(path: Path, kind: type[Row]) -> list[Row]:
    """The table in a file, empty where there is none. Raises FormatError."""
    if not path.exists():
        return []
    try:
        return msgspec.json.Decoder(kind).decode_lines(path.read_bytes())
    except OSError as error:
        raise FormatError(f"{path}: {error.strerror}") from None
    except (msgspec.MsgspecError, UnicodeDecodeError) as error:
        what = f"{kind.__name__.lower()}s"
        raise FormatError(f"{path} is no table of {what} (docs/refuelling-benchmark.md): {error}") from None


def add(path: Path, row: Struct) -> None:
    """Append one line. Raises OSError."""
    with path.open("ab") as table:
        table.write(msgspec.json.encode(row) + b"\n")


def shipped() -> dict[str, Gap]:
    """The gaps of the 300 shipped instances, by instance, as `gcs benchmark solve --table` found them."""
    text = resources.files("gcs").joinpath("benchmark", "gaps.jsonl").read_bytes()
    return {gap.instance: gap for gap in msgspec.json.Decoder(Gap).decode_lines(text)}
