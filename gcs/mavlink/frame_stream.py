"""Frames from a stream of bytes, however it is cut: a cable, a radio, a TCP connection."""

from __future__ import annotations

from gcs.mavlink import codec, dialect
from gcs.mavlink.codec import Split

_FLAGS = (0, codec.SIGNED)


class FrameStream:
    """Bytes of one sender in, whole frames out. No more than LARGEST_FRAME bytes are kept from one call to the next."""

    def __init__(self) -> None:
        self._pending = b""

    def feed(self, data: bytes) -> Split:
        """Frames that these bytes complete; what may still become one waits for the next bytes."""
        data = self._pending + data
        split = codec.split(data)
        cut = _unfinished_at(data, max(split.end, len(data) - codec.LARGEST_FRAME + 1))
        self._pending = data[cut:]
        only_unfinished = split.end < len(data) and cut == split.end
        return split._replace(malformed=split.malformed - only_unfinished)


def _unfinished_at(data: bytes, begin: int) -> int:
    """Where, from `begin` on, a frame begins that may go on beyond the end of `data`; its length where none does."""
    for at in range(begin, len(data)):
        left = len(data) - at
        if data[at] == dialect.MARKER_1:
            if left < 2 or left < dialect.HEADER_1_BYTES + dialect.CRC_BYTES + data[at + 1]:
                return at
        elif data[at] == dialect.MARKER and (
            left < 3
            or (
                data[at + 2] in _FLAGS
                and left < codec.HEADER_BYTES + data[at + 1] + codec.CRC_BYTES + codec.SIGNATURE_BYTES * data[at + 2]
            )
        ):
            return at
    return len(data)
