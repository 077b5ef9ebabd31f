"""The digest of a session: docs/protocol/folder.md#digest."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from typing import Any

import cython
import numpy as np
from cython.cimports.libc.string import memcpy
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans, Spans

_MOST_HEAD_BYTES = 13
"""Bytes before a frame or a line: time, direction and a line's length."""
_IN, _OUT, _DECISION = range(3)


class Digest:
    """A session's fingerprint: equal for equal frames delivered, frames sent and decisions.

    A frame counts as tick, direction, system, component, message id and payload as on the wire. Sequence numbers, flags
    and signatures do not. Feed it tick by tick, frames in the order (system, component, delivery).
    """

    def __init__(self) -> None:
        self._hash = hashlib.sha256()

    def tick(self, t_ms: int, received: Sequence[bytes], sent: Sequence[bytes], lines: Sequence[bytes]) -> None:
        """Count a tick.

        Args:
            t_ms: its time.
            received: whole frames (MAVLink 2) that were delivered to the supervisor in the tick that ends then.
            sent: those that were sent then, each once however often its datagram was repeated.
            lines: decisions made then, as their lines of decisions.jsonl.
        """
        one, two, three = FrameSpans.of(received), FrameSpans.of(sent), FrameSpans.of(lines)
        heads = _MOST_HEAD_BYTES * (len(one.spans) + len(two.spans) + len(three.spans))
        counted = np.empty(len(one.data) + len(two.data) + len(three.data) + heads, np.uint8)
        size = _count(t_ms, one.data, one.spans, two.data, two.spans, three.data, three.spans, counted)
        self._hash.update(counted[:size].data)

    def hexdigest(self) -> str:
        return f"sha256:{self._hash.hexdigest()}"


def _put_prefix(t_ms: int, part: int, out: Any, at: int) -> int:
    for i in range(8):
        out[at + i] = (t_ms >> 8 * i) & 0xFF
    out[at + 8] = part
    return at + 9


def _put_frames(t_ms: int, part: int, raw: Any, spans: Spans, out: Any, at: int) -> int:
    """Write what counts of frames, behind where `out` is filled up to; where it is then.

    A frame's byte 1 is the payload's length; bytes 5 to 9 are system, component and message id, then the payload.
    """
    for k in range(len(spans)):
        begin, end = spans[k, 0], spans[k, 1]
        at = _put_prefix(t_ms, part, out, at)
        out[at] = raw[begin + 1]
        size = max(min(5 + raw[begin + 1], end - begin - 5), 0)
        memcpy(out + at + 1, raw + begin + 5, size)
        at += 1 + size
    return at


def _count(
    t_ms: int,
    received: bytes,
    received_spans: Spans,
    sent: bytes,
    sent_spans: Spans,
    lines: bytes,
    lines_spans: Spans,
    counted: NDArray[np.uint8],
) -> int:
    """Write what counts of a tick's frames and lines, which stand at these spans (n, 2); how much it is."""
    out = cython.address(counted[0])
    at = _put_frames(t_ms, _IN, received, received_spans, out, 0)
    at = _put_frames(t_ms, _OUT, sent, sent_spans, out, at)
    for k in range(len(lines_spans)):
        begin, size = lines_spans[k, 0], lines_spans[k, 1] - lines_spans[k, 0]
        at = _put_prefix(t_ms, _DECISION, out, at)
        for i in range(4):
            out[at + i] = (size >> 8 * i) & 0xFF
        memcpy(out + at + 4, lines + begin, size)
        at += 4 + size
    return at
