"""Many frames in one buffer, with the place of each: compiled code reads them without cutting them apart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, groupby
from typing import overload

import numpy as np
from numpy.typing import NDArray

Spans = NDArray[np.int64]


class FrameSpans(Sequence[bytes]):
    """Whole frames as they stand on the wire, in order; a sequence of `bytes`, cut when one is asked for."""

    __slots__ = ("data", "spans")

    def __init__(self, data: bytes, spans: Spans) -> None:
        self.data = data
        self.spans = spans
        """(n, 2) where in `data` each frame begins and ends; what lies between two frames is none"""

    @classmethod
    def of(cls, frames: Sequence[bytes]) -> FrameSpans:
        """These frames, side by side."""
        if isinstance(frames, FrameSpans):
            return frames
        spans = np.empty((len(frames), 2), np.int64)
        np.cumsum(np.fromiter(map(len, frames), np.int64, len(frames)), out=spans[:, 1])
        spans[:1, 0], spans[1:, 0] = 0, spans[:-1, 1]
        return cls(b"".join(frames), spans)

    @classmethod
    def joined(cls, parts: Sequence[Sequence[bytes]]) -> FrameSpans:
        """The frames of all parts, one part after the other."""
        if len(parts) == 1 and isinstance(parts[0], cls):
            return parts[0]
        several: list[FrameSpans] = []
        for alike, run in groupby(filter(len, parts), lambda part: isinstance(part, cls)):
            some = list(run)
            several += some if alike else [cls.of(list(chain.from_iterable(some)))]  # type: ignore[arg-type]
        if len(several) == 1:
            return several[0]
        begins: dict[int, int] = {}  # of each piece of memory, which several parts may lie in
        data: list[bytes] = []
        size = 0
        for part in several:
            if id(part.data) not in begins:
                begins[id(part.data)] = size
                data.append(part.data)
                size += len(part.data)
        spans = [part.spans + begins[id(part.data)] for part in several]
        return cls(b"".join(data), np.concatenate(spans) if spans else np.empty((0, 2), np.int64))

    def __len__(self) -> int:
        return len(self.spans)

    def __iter__(self) -> Iterator[bytes]:
        data = self.data
        return iter([data[begin:end] for begin, end in self.spans.tolist()])

    @overload
    def __getitem__(self, at: int) -> bytes: ...
    @overload
    def __getitem__(self, at: slice) -> FrameSpans: ...
    def __getitem__(self, at: int | slice) -> bytes | FrameSpans:
        if isinstance(at, slice):
            return FrameSpans(self.data, self.spans[at])
        begin, end = self.spans[at].tolist()
        return self.data[begin:end]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and list(self) == list(other)

    __hash__ = None  # type: ignore[assignment]
