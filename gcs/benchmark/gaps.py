"""Gaps between proven bounds and verified schedules, as JSON lines; those of the 300 instances are in gaps.jsonl."""

from __future__ import annotations

from importlib import resources
from pathlib import Path
from typing import Final

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


TABLE: Final = msgspec.json.Decoder(Gap)


def read(path: Path) -> list[Gap]:
    """The table in a file. Raises FormatError."""
    try:
        return TABLE.decode_lines(path.read_bytes())
    except OSError as error:
        raise FormatError(f"{path}: {error.strerror}") from None
    except (msgspec.MsgspecError, UnicodeDecodeError) as error:
        raise FormatError(f"{path} is no table of gaps (docs/refuelling-benchmark.md#bounds): {error}") from None


def add(path: Path, gap: Gap) -> None:
    """Append one line. Raises OSError."""
    with path.open("ab") as table:
        table.write(msgspec.json.encode(gap) + b"\n")


def shipped() -> dict[str, Gap]:
    """Those of the 300 instances, by name, as `gcs benchmark solve --table` has found them."""
    text = resources.files("gcs").joinpath("benchmark", "gaps.jsonl").read_bytes()
    return {gap.instance: gap for gap in TABLE.decode_lines(text)}
