"""Frames as session.tlog holds them: before each, 8 bytes, high byte first, the time in µs since the Unix epoch."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import cython
import numpy as np
from cython.cimports.libc.string import memcpy
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans, Spans

_TIME_BYTES = 8


def stamped(t_us: int, received: Sequence[bytes], sent: Sequence[bytes]) -> memoryview:
    """These frames of one time, the sent ones last."""
    first, last = FrameSpans.of(received), FrameSpans.of(sent)
    out = np.empty(len(first.data) + len(last.data) + _TIME_BYTES * (len(first.spans) + len(last.spans)), np.uint8)
    return out.data[: _stamp(t_us, first.data, first.spans, last.data, last.spans, out)]


def _put(t_us: int, raw: Any, spans: Spans, out: Any, at: int) -> int:
    for k in range(len(spans)):
        for i in range(8):
            out[at + i] = (t_us >> 8 * (7 - i)) & 0xFF
        begin, size = spans[k, 0], spans[k, 1] - spans[k, 0]
        memcpy(out + at + 8, raw + begin, size)
        at += 8 + size
    return at


def _stamp(
    t_us: int, first: bytes, first_spans: Spans, last: bytes, last_spans: Spans, stamped: NDArray[np.uint8]
) -> int:
    """Write the frames that stand in two texts at these spans (n, 2), each behind the time; how much it is."""
    out = cython.address(stamped[0])
    return _put(t_us, last, last_spans, out, _put(t_us, first, first_spans, out, 0))
