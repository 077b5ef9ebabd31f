"""The digest of a session: docs/protocol.md#digest."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans, Spans
from gcs.kernels import UNCOUNTED, inner, kernel

Bytes = NDArray[np.uint8]

_PREFIX_BYTES = 9
_LENGTH_BYTES = 4
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
        heads = (_PREFIX_BYTES + _LENGTH_BYTES) * (len(one.spans) + len(two.spans) + len(three.spans))
        counted = np.empty(len(one.data) + len(two.data) + len(three.data) + heads, np.uint8)
        size = _count(t_ms, one.data, one.spans, two.data, two.spans, three.data, three.spans, counted)
        self._hash.update(counted[:size].data)

    def hexdigest(self) -> str:
        return f"sha256:{self._hash.hexdigest()}"


@inner(**UNCOUNTED)
def _put_prefix(t_ms: int, part: int, out: Bytes, at: Any) -> Any:
    for i in range(_PREFIX_BYTES - 1):
        out[at + i] = (t_ms >> 8 * i) & 0xFF
    out[at + _PREFIX_BYTES - 1] = part
    return at + _PREFIX_BYTES


@inner(**UNCOUNTED)
def _put_frames(t_ms: int, part: int, raw: bytes, spans: Spans, out: Bytes, at: Any) -> Any:
    """Write what counts of frames, behind where `out` is filled up to; where it is then.

    A frame's byte 1 is the payload's length; bytes 5 to 9 are system, component and message id, then the payload.
    """
    for k in range(len(spans)):
        begin, end = spans[k, 0], spans[k, 1]
        at = _put_prefix(t_ms, part, out, at)
        out[at] = raw[begin + 1]
        at += 1
        size = min(5 + np.int64(raw[begin + 1]), end - begin - 5)
        for i in range(size):
            out[at + i] = raw[begin + 5 + i]
        at += size
    return at


@kernel(**UNCOUNTED)
def _count(
    t_ms: int,
    received: bytes,
    received_spans: Spans,
    sent: bytes,
    sent_spans: Spans,
    lines: bytes,
    lines_spans: Spans,
    counted: Bytes,
) -> Any:
    """Kernel: write what counts of a tick's frames and lines, which stand at these spans (n, 2); how much it is."""
    at = _put_frames(t_ms, _IN, received, received_spans, counted, 0)
    at = _put_frames(t_ms, _OUT, sent, sent_spans, counted, at)
    for k in range(len(lines_spans)):
        begin, size = lines_spans[k, 0], lines_spans[k, 1] - lines_spans[k, 0]
        at = _put_prefix(t_ms, _DECISION, counted, at)
        for i in range(_LENGTH_BYTES):
            counted[at + i] = (size >> 8 * i) & 0xFF
        at += _LENGTH_BYTES
        for i in range(size):
            counted[at + i] = lines[begin + i]
        at += size
    return at
