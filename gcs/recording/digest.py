"""The digest of a session: docs/protocol.md#digest."""

from __future__ import annotations

import hashlib
import struct
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans
from gcs.kernels import UNCOUNTED, kernel

_PREFIX = struct.Struct("<QB").pack
_IN, _OUT, _DECISION = range(3)


class Digest:
    """A session's fingerprint: equal for equal frames delivered, frames sent and decisions.

    A frame counts as tick, direction, system, component, message id and payload as on the wire. Sequence numbers, flags
    and signatures do not. Feed it tick by tick, frames in the order (system, component, delivery).
    """

    def __init__(self) -> None:
        self._hash = hashlib.sha256()

    def frames_in(self, t_ms: int, frames: Sequence[bytes]) -> None:
        """Whole frames (MAVLink 2) that were delivered to the supervisor in the tick that ends at `t_ms`."""
        self._frames(_PREFIX(t_ms, _IN), frames)

    def frames_out(self, t_ms: int, frames: Sequence[bytes]) -> None:
        """Whole frames (MAVLink 2) that were sent at `t_ms`, each once however often its datagram was repeated."""
        self._frames(_PREFIX(t_ms, _OUT), frames)

    def decisions(self, t_ms: int, lines: Iterable[bytes]) -> None:
        """Decisions made at `t_ms`, as their lines of decisions.jsonl."""
        prefix = _PREFIX(t_ms, _DECISION)
        self._hash.update(b"".join([prefix + len(line).to_bytes(4, "little") + line for line in lines]))

    def hexdigest(self) -> str:
        return f"sha256:{self._hash.hexdigest()}"

    def _frames(self, prefix: bytes, frames: Sequence[bytes]) -> None:
        if frames:
            whole = FrameSpans.of(frames)
            counted = np.empty(len(whole.data) + len(prefix) * len(frames), np.uint8)
            size = _count(whole.data, whole.spans, prefix, counted)
            self._hash.update(counted[:size].data)


@kernel(**UNCOUNTED)
def _count(raw: bytes, spans: NDArray[np.int64], prefix: bytes, counted: NDArray[np.uint8]) -> Any:
    """Kernel: write what counts of frames, which stand in `raw` at these spans (n, 2), each behind the prefix; how much
    it is.

    A frame's byte 1 is the payload's length; bytes 5 to 9 are system, component and message id, then the payload.
    """
    at: Any = 0
    for k in range(len(spans)):
        begin, end = spans[k, 0], spans[k, 1]
        for i in range(len(prefix)):
            counted[at + i] = prefix[i]
        at += len(prefix)
        counted[at] = raw[begin + 1]
        at += 1
        for i in range(begin + 5, min(begin + 10 + raw[begin + 1], end)):
            counted[at] = raw[i]
            at += 1
    return at
