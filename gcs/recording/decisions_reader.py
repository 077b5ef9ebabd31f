"""Reads decisions.jsonl: typed and many lines at once, since nearly all of them are set points, and JSON line by line
takes ten times as long.

    lines = DecisionLines(path)
    for record in lines: ...                # every decision in its order, or
    for points, others in lines.blocks(): ...   # set points as numbers, and the other decisions' lines
    lines.broken, lines.cut                 # how many lines were none, and whether the file ends inside one
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from gcs.recording import rotation

P_NED, SYSID, T_S = slice(0, 3), 3, 4
"""Columns of set points; their velocities are left out."""
COLUMNS = 5
BLOCK_BYTES = 1 << 22
MOST_OPENED = 500
"""Lists and objects in a line: one with more is no decision of ours, and could be nested deeper than is read."""
_LONG = re.compile(rb"\d{19}")
"""as many digits as a number of 64 bits may have, and further ones would make it larger"""
_BEGIN = b'{"kind":"set_point",'
"""as the recorder writes them, with sorted keys"""


class _SetPoint(msgspec.Struct, tag_field="kind", tag="set_point", gc=False):
    p_ned: tuple[float, float, float]
    sysid: Annotated[int, msgspec.Meta(ge=0, le=255)]
    t_s: float


class _Head(msgspec.Struct, gc=False):
    """Keys that every decision has, and the one that distinguishes two competitions."""

    kind: str
    t_s: float
    giver: str | None = None


_POINTS, _HEADS = msgspec.json.Decoder(_SetPoint), msgspec.json.Decoder(_Head)
_RECORDS = msgspec.json.Decoder(dict[str, Any])
_BROKEN = (msgspec.MsgspecError, UnicodeDecodeError)
"""Errors of a line that is no JSON, or no text at all."""


class DecisionLine(NamedTuple):
    """A decision that is no set point; `record` reads the rest of it."""

    t_s: float
    kind: str
    giver: str | None
    raw: bytes

    def record(self) -> dict[str, Any]:
        """All of it; nothing where only its head can be read: past that stands a number or a text that is none."""
        try:
            return _RECORDS.decode(self.raw)
        except _BROKEN:
            return {}


def _is_refused(line: bytes) -> bool:
    """Whether a line may be nested more deeply than it can be read, or holds a whole number of more than 64 bits."""
    if len(line) > MOST_OPENED and line.count(b"[") + line.count(b"{") > MOST_OPENED:
        return True
    if _LONG.search(line) is None:
        return False
    try:
        return not _is_small(_RECORDS.decode(line))
    except _BROKEN:
        return False  # and passed over where it is decoded


def _is_small(value: Any) -> bool:
    if isinstance(value, dict | list):
        return all(map(_is_small, value.values() if isinstance(value, dict) else value))
    return not isinstance(value, int) or -(1 << 63) <= value < 1 << 63


class DecisionLines:
    """One file of decisions; walking it again begins anew. Walking raises OSError where it cannot be read."""

    def __init__(self, path: Path, progress: Callable[[float], object] = lambda _: None) -> None:
        """`progress` is given the share of the file that has been read."""
        self._path = path
        self._progress = progress
        self.broken = 0
        """whole lines that are no decision"""
        self.cut = False
        """whether the file ends inside a line, which is none"""

        self._last: bytes | None = None

    @property
    def passed_over(self) -> int:
        """Number of lines that are no decision, the cut one among them."""
        return self.broken + self.cut

    def __iter__(self) -> Iterator[dict[str, Any]]:
        for lines in self._blocks():
            for record, line in self._decoded(_RECORDS, self._without_refused(lines)):
                t_s = record.get("t_s")
                if isinstance(record.get("kind"), str) and isinstance(t_s, int | float) and not isinstance(t_s, bool):
                    yield record
                else:
                    self._pass_over(line)

    def blocks(self, *, set_points: bool = True) -> Iterator[tuple[NDArray[np.float64], list[DecisionLine]]]:
        """(n, COLUMNS) numbers of set points, none where they are not wanted; and the other decisions' lines."""
        for lines in self._blocks():
            # No set point of ours is long, and the types of its numbers refuse what cannot be read.
            own = [line for line in lines if line.startswith(_BEGIN) and len(line) <= MOST_OPENED]
            rest = [line for line in lines if len(line) > MOST_OPENED or not line.startswith(_BEGIN)]
            wanted = own if set_points else [line for line in own[-1:] if line is self._last]
            points = [point for point, _ in self._decoded(_POINTS, wanted)]
            points = points if set_points else []
            others = []
            for head, line in self._decoded(_HEADS, self._without_refused(rest)):
                if head.kind != "set_point":
                    others.append(DecisionLine(head.t_s, head.kind, head.giver, line))
                elif set_points:  # by another writer
                    points += [point for point, _ in self._decoded(_POINTS, [line])]
            rows = np.empty((len(points), COLUMNS))
            rows[:, P_NED] = np.array([point.p_ned for point in points], dtype=np.float64).reshape(-1, 3)
            rows[:, SYSID] = [point.sysid for point in points]
            rows[:, T_S] = [point.t_s for point in points]
            yield rows, others

    def _blocks(self) -> Iterator[list[bytes]]:
        """All lines; some may be empty."""
        self.broken, self.cut, done = 0, False, 0
        with rotation.open_parts(self._path) as file:
            size = max(rotation.size(self._path), 1)
            while block := file.read(BLOCK_BYTES) + file.readline():
                done += len(block)
                lines = block.split(b"\n")
                self._last = lines[-1] if lines[-1] else None
                yield lines
                self._progress(min(done / size, 1.0))

    def _without_refused(self, lines: Sequence[bytes]) -> list[bytes]:
        """The lines that can be read and are not empty."""
        read = []
        for line in lines:
            if _is_refused(line):
                self._pass_over(line)
            elif line:
                read.append(line)
        return read

    def _decoded(self, decoder: msgspec.json.Decoder[Any], lines: Sequence[bytes]) -> Iterator[tuple[Any, bytes]]:
        """Values of each line; those without such a value are passed over."""
        try:
            found = decoder.decode_lines(b"\n".join(lines))
        except _BROKEN:  # one is broken: only one by one can the others be had
            found = []
        return zip(found, lines, strict=True) if len(found) == len(lines) else self._decoded_singly(decoder, lines)

    def _decoded_singly(
        self, decoder: msgspec.json.Decoder[Any], lines: Sequence[bytes]
    ) -> Iterator[tuple[Any, bytes]]:
        for line in lines:
            try:
                content = decoder.decode(line)
            except _BROKEN:
                self._pass_over(line)
            else:
                yield content, line

    def _pass_over(self, line: bytes) -> None:
        self.cut |= line is self._last
        self.broken += line is not self._last
