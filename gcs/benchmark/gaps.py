"""Gaps between proven bounds and verified schedules; those of the 300 instances are in gaps.jsonl.

Tables of them, and of other results, are JSON lines, which are added to, so that a long run can be stopped and go on.
"""

from __future__ import annotations

from importlib import resources
from pathlib import Path
from typing import TypeVar

import msgspec
from msgspec import Struct

from gcs.benchmark.format import FormatError


class Gap(Struct):
    """At least `lower` receivers are lost by every schedule, and `upper` by one that was verified."""

    instance: str
    lower: int
    upper: int
    cpu_s: float
    """that was used"""

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
    """Those of the 300 instances, by name, as `gcs benchmark solve --table` has found them."""
    text = resources.files("gcs").joinpath("benchmark", "gaps.jsonl").read_bytes()
    return {gap.instance: gap for gap in msgspec.json.Decoder(Gap).decode_lines(text)}
