"""The digest of a session: docs/protocol.md#digest."""

from __future__ import annotations

import hashlib
import struct
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from gcs.kernels import kernel

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
            raw, sizes = np.frombuffer(b"".join(frames), np.uint8), np.fromiter(map(len, frames), np.int64, len(frames))
            counted = np.empty(len(raw) + len(prefix) * len(frames), np.uint8)
            size = _count(raw, sizes, np.frombuffer(prefix, np.uint8), counted)
            self._hash.update(counted[:size].data)


@kernel()
def _count(
    raw: NDArray[np.uint8], sizes: NDArray[np.int64], prefix: NDArray[np.uint8], counted: NDArray[np.uint8]
) -> int:
    """Kernel: write what counts of frames of these sizes, which stand in `raw`, each behind the prefix; how much it is.

    A frame's byte 1 is the payload's length; bytes 5 to 9 are system, component and message id, then the payload.
    """
    begin = end = 0
    for size in sizes:
        for i in range(prefix.size):
            counted[end + i] = prefix[i]
        end += prefix.size
        counted[end] = raw[begin + 1]
        end += 1
        for i in range(5, min(10 + raw[begin + 1], size)):
            counted[end] = raw[begin + i]
            end += 1
        begin += size
    return end
