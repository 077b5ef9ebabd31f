"""The frame that begins at a place in some bytes, of MAVLink 1 or 2: the check by which both programs, links and
recordings, know frames (https://mavlink.io/en/guide/serialization.html).

A frame is intact where all of it is there, its incompatibility flags hold nothing but the signature's, and its checksum
is right. The checksum ends with a seed of the message's own; of a message that the definitions lack it is only known
that one of the 256 seeds must explain it, as one in 256 of all checksums is.
"""

from __future__ import annotations

from typing import Any

import cython
from cython.cimports.libc.string import memchr
from cython.cimports.skytender.checksum import crc_of, ended
from cython.cimports.skytender.frames import (
    CHECKSUM_BYTES,
    HEADER_1_BYTES,
    HEADER_BYTES,
    MAGIC,
    MAGIC_1,
    SIGNATURE_BYTES,
    SIGNED,
)
from cython.cimports.skytender.intact_frames import _COMMON, _EXPLAINED, _IDS, _SEEDS, NO_SEED, Intact

from skytender.mavlink import MESSAGES

for _msgid in range(_IDS):
    _SEEDS[_msgid] = NO_SEED
for _known in MESSAGES.values():
    _SEEDS[_known.id] = _known.seed | (_COMMON if _known.common else 0)
for _seed in range(256):
    _EXPLAINED[ended(0, _seed)] = True


def intact_at(data: Any, at: int, size: int) -> Any:
    """The frame that begins at data[at], of `size` bytes in all."""
    found: Any = Intact(0, 0, 0, 0, 0, NO_SEED, False)
    if at + HEADER_1_BYTES + CHECKSUM_BYTES > size:
        return found
    signature = 0
    if data[at] == MAGIC:
        if at + HEADER_BYTES + CHECKSUM_BYTES > size or data[at + 2] & ~SIGNED:
            return found
        found.version, found.payload = 2, at + HEADER_BYTES
        found.msgid = data[at + 7] | data[at + 8] << 8 | data[at + 9] << 16
        signature = SIGNATURE_BYTES if data[at + 2] & SIGNED else 0
    elif data[at] == MAGIC_1:
        found.version, found.payload, found.msgid = 1, at + HEADER_1_BYTES, data[at + 5]
    else:
        return found
    found.checksum = found.payload + data[at + 1]
    end = found.checksum + CHECKSUM_BYTES + signature
    if end > size:
        return found
    known = _SEEDS[found.msgid] if found.msgid < _IDS else NO_SEED
    crc, sent_crc = crc_of(data, at + 1, found.checksum), data[found.checksum] | data[found.checksum + 1] << 8
    if known == NO_SEED:
        found.end = end if _EXPLAINED[sent_crc ^ crc >> 8] else 0
        return found
    found.seed, found.common = known & 0xFF, known & _COMMON != 0
    found.end = end if ended(crc, found.seed) == sent_crc else 0
    return found


def next_marker(data: Any, at: int, size: int) -> int:
    """Place of the first byte from data[at] on with which a frame may begin; `size` where there is none."""
    place = cython.cast("const unsigned char *", memchr(data + at, MAGIC, size - at))
    end = place - data if place else size
    place = cython.cast("const unsigned char *", memchr(data + at, MAGIC_1, end - at))
    return place - data if place else end
