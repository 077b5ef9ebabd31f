"""A datagram whose every byte belongs to a frame of the dialect, as nearly all of a session's: its frames by sender,
found in one call of compiled code.

Whether a frame is one is decided as by `codec.split`, which is asked about every other datagram. What reads such frames
by compiled code too needs no `Frame` of each: a `FrameRun` makes them on request.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise
from typing import overload

import numpy as np
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.mavlink.frame_runs import FIRST, LAST, NO_TIME, SYSID, found_in

_new = tuple.__new__


class FrameRun(Sequence[Frame]):
    """Frames of one system that follow each other in a datagram: a sequence of `Frame`, made when it is first read."""

    __slots__ = ("_begins", "_frames", "data", "first", "in_step", "sender", "time_ms")

    def __init__(self, data: bytes, begins: list[int], row: Sequence[int]) -> None:
        """begins: of each frame in `data`, and the end of the last; row: COLUMNS values."""
        self.data = data
        self._begins = begins
        self._frames: list[Frame] | None = None
        _, _, sysid, compid, self.first, in_step, time_ms = row
        self.sender = sysid, compid
        """system and component of the first frame"""
        self.in_step = in_step == 1
        """whether all are of this component, numbered one after the other from `first` on"""
        self.time_ms = time_ms if time_ms != NO_TIME else None
        """the sender's own time, where the last frame is a SYSTEM_TIME"""

    @property
    def span(self) -> tuple[int, int]:
        """Where in `data` the first frame begins and the last one ends."""
        return self._begins[0], self._begins[-1]

    def raws(self) -> list[bytes]:
        """The frames as they stood on the wire."""
        data = self.data
        return [data[begin:end] for begin, end in pairwise(self._begins)]

    def __len__(self) -> int:
        return len(self._begins) - 1

    def __iter__(self) -> Iterator[Frame]:
        return iter(self._made())

    @overload
    def __getitem__(self, at: int) -> Frame: ...
    @overload
    def __getitem__(self, at: slice) -> list[Frame]: ...
    def __getitem__(self, at: int | slice) -> Frame | list[Frame]:
        return self._made()[at]

    def __eq__(self, other: object) -> bool:
        return self._made() == (other._made() if isinstance(other, FrameRun) else other)

    __hash__ = None  # type: ignore[assignment]

    def _made(self) -> list[Frame]:
        if self._frames is None:
            self._frames = [frame_of(raw) for raw in self.raws()]
        return self._frames


def frame_of(raw: bytes) -> Frame:
    """The frame that these bytes are."""
    return _new(Frame, (raw[5], raw[6], raw[4], raw[7] | raw[8] << 8 | raw[9] << 16, raw))


def frame_at(data: bytes, begin: int) -> Frame:
    """The frame that begins there."""
    signature = codec.SIGNATURE_BYTES if data[begin + 2] & codec.SIGNED else 0
    return frame_of(data[begin : begin + codec.HEADER_BYTES + data[begin + 1] + codec.CRC_BYTES + signature])


def raws_of(frames: Iterable[Frame]) -> list[bytes]:
    """Frames as they stood on the wire."""
    return frames.raws() if isinstance(frames, FrameRun) else [frame.raw for frame in frames]


def runs_of(datagram: bytes) -> list[FrameRun] | None:
    """Frames of a datagram by system, in their order; None where not every byte belongs to a frame of the dialect."""
    found = found_in(datagram)
    if found is None:
        return None
    begins, rows = found
    return [FrameRun(datagram, begins[row[FIRST] : row[LAST] + 1], row) for row in rows]


class AnswerRuns(Sequence[FrameRun]):
    """Runs of frames that lie in one piece of data, each a vehicle's: a sequence of `FrameRun`, made when it is asked
    for."""

    def __init__(self, frames: FrameSpans, rows: NDArray[np.int64]) -> None:
        """frames: of all, run by run; `FIRST` and `LAST` of the rows (n, COLUMNS) are places among them."""
        self.frames = frames
        self.rows = rows

    def by_system(self) -> Mapping[int, FrameRun]:
        """Each by its system id, of which there is one run."""
        return _BySystem(self)

    def __len__(self) -> int:
        return len(self.rows)

    @overload
    def __getitem__(self, at: int) -> FrameRun: ...
    @overload
    def __getitem__(self, at: slice) -> list[FrameRun]: ...
    def __getitem__(self, at: int | slice) -> FrameRun | list[FrameRun]:
        if isinstance(at, slice):
            return [self[k] for k in range(*at.indices(len(self)))]
        row = self.rows[at].tolist()
        spans = self.frames.spans[row[FIRST] : row[LAST]]
        return FrameRun(self.frames.data, [*spans[:, 0].tolist(), int(spans[-1, 1])], row)


class _BySystem(Mapping[int, FrameRun]):
    def __init__(self, runs: AnswerRuns) -> None:
        self._runs = runs
        self._made: dict[int, FrameRun] = {}

    @cached_property
    def _at(self) -> dict[int, int]:
        return {sysid: at for at, sysid in enumerate(self._runs.rows[:, SYSID].tolist())}

    def __getitem__(self, sysid: int) -> FrameRun:
        if sysid not in self._made:
            self._made[sysid] = self._runs[self._at[sysid]]
        return self._made[sysid]

    def __iter__(self) -> Iterator[int]:
        return iter(self._at)

    def __len__(self) -> int:
        return len(self._at)
