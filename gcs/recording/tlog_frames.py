"""Frames as session.tlog holds them: before each, 8 bytes, high byte first, the time in µs since the Unix epoch."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans
from gcs.kernels import UNCOUNTED, kernel

_TIME = struct.Struct(">Q")


def stamped(t_us: int, frames: Sequence[bytes]) -> bytes | memoryview:
    """These frames of one time."""
    time = _TIME.pack(t_us)
    if not isinstance(frames, FrameSpans):
        return time + time.join(frames) if frames else b""
    out = np.empty(len(frames.data) + _TIME.size * len(frames), np.uint8)
    return out.data[: _stamp(frames.data, frames.spans, time, out)]


@kernel(**UNCOUNTED)
def _stamp(raw: bytes, spans: NDArray[np.int64], time: bytes, out: NDArray[np.uint8]) -> Any:
    """Kernel: write the frames that stand in `raw` at these spans (n, 2), each behind the time; how much it is."""
    at: Any = 0
    for k in range(len(spans)):
        for i in range(len(time)):
            out[at + i] = time[i]
        at += len(time)
        for i in range(spans[k, 0], spans[k, 1]):
            out[at] = raw[i]
            at += 1
    return at
