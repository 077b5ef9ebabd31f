"""Frames as session.tlog holds them: before each, 8 bytes, high byte first, the time in µs since the Unix epoch."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans, Spans
from gcs.kernels import UNCOUNTED, inner, kernel

_TIME_BYTES = 8


def stamped(t_us: int, received: Sequence[bytes], sent: Sequence[bytes]) -> memoryview:
    """These frames of one time, the sent ones last."""
    first, last = FrameSpans.of(received), FrameSpans.of(sent)
    out = np.empty(len(first.data) + len(last.data) + _TIME_BYTES * (len(first.spans) + len(last.spans)), np.uint8)
    return out.data[: _stamp(t_us, first.data, first.spans, last.data, last.spans, out)]


@inner(**UNCOUNTED)
def _put(t_us: int, raw: bytes, spans: Spans, out: NDArray[np.uint8], at: Any) -> Any:
    for k in range(len(spans)):
        for i in range(_TIME_BYTES):
            out[at + i] = (t_us >> 8 * (_TIME_BYTES - 1 - i)) & 0xFF
        at += _TIME_BYTES
        begin, size = spans[k, 0], spans[k, 1] - spans[k, 0]
        for i in range(size):
            out[at + i] = raw[begin + i]
        at += size
    return at


@kernel(**UNCOUNTED)
def _stamp(t_us: int, first: bytes, first_spans: Spans, last: bytes, last_spans: Spans, out: NDArray[np.uint8]) -> Any:
    """Kernel: write the frames that stand in two texts at these spans (n, 2), each behind the time; how much it is."""
    return _put(t_us, last, last_spans, out, _put(t_us, first, first_spans, out, 0))
