"""The two forms of a frame, of MAVLink 1 and 2, one turned into the other.

Old autopilots, radio modems and many a script still send MAVLink 1. Its frames are read in the form of MAVLink 2. Both
sum a frame alike, header and payload without the marker, and end with a seed of the message's own, so that a checksum
tells the seed of a message that the table lacks.
"""

from __future__ import annotations

import struct
from typing import NamedTuple

from fastcrc.crc16 import mcrf4xx

from skytender.mavlink import MESSAGES, Definition

NAME = "ardupilotmega"
MARKER, HEADER_BYTES = 0xFD, 10
MARKER_1, HEADER_1_BYTES = 0xFE, 6
CRC_BYTES = 2
SMALLEST_1 = HEADER_1_BYTES + CRC_BYTES
IDS_1 = 256
"""MAVLink 1 has no id above 255."""

CRC_TERMS = [mcrf4xx(bytes([seed]), 0) for seed in range(256)]
"""Terms that one seed byte can add to a checksum: CRC(body, seed) = CRC(body) >> 8 ^ one of these, that at
(CRC(body) ^ seed) & 0xFF."""
_INDEX_OF = {term: index for index, term in enumerate(CRC_TERMS)}


class OlderFrame(NamedTuple):
    """A frame that came in MAVLink 1."""

    raw: bytes
    """in the form of MAVLink 2"""
    end: int
    """where it ends in what it was found in"""
    known: bool
    """whether the table has its id; of another only that some seed explains its checksum"""


def seed_that_explains(body_crc: int, crc: int) -> int | None:
    """The seed by which a frame's checksum follows from that of its body; None where there is none."""
    index = _INDEX_OF.get(crc ^ body_crc >> 8)
    return None if index is None else index ^ body_crc & 0xFF


def older_frame(data: bytes, at: int) -> OlderFrame | None:
    """The intact MAVLink 1 frame whose marker stands there; None where there is none."""
    if at + SMALLEST_1 > len(data) or data[at] != MARKER_1:
        return None
    length, seq, sysid, compid, msgid = data[at + 1 : at + HEADER_1_BYTES]
    body_end = at + HEADER_1_BYTES + length
    end = body_end + CRC_BYTES
    if end > len(data):
        return None
    crc = int.from_bytes(data[body_end:end], "little")
    seed = seed_that_explains(mcrf4xx(data[at + 1 : body_end]), crc)
    known = MESSAGES.get(msgid)
    if seed is None or (known is not None and seed != known.seed):
        return None
    body = bytes([length, 0, 0, seq, sysid, compid, msgid, 0, 0]) + data[at + HEADER_1_BYTES : body_end]
    raw = bytes([MARKER]) + body + mcrf4xx(body + bytes([seed])).to_bytes(CRC_BYTES, "little")
    return OlderFrame(raw, end, known is not None)


def older_form(raw: bytes) -> bytes:
    """A MAVLink 2 frame as MAVLink 1, without extension fields and signature.

    Raises ValueError for a message that the table, or MAVLink 1, lacks.
    """
    msgid = int.from_bytes(raw[7:10], "little")
    known = MESSAGES.get(msgid)
    if known is None or msgid >= IDS_1:
        raise ValueError(f"{msgid if known is None else known.name} cannot be sent in MAVLink 1")
    size = base_bytes(known)
    payload = raw[HEADER_BYTES : HEADER_BYTES + raw[1]][:size].ljust(size, b"\0")
    body = bytes([size]) + raw[4:8] + payload
    return bytes([MARKER_1]) + body + mcrf4xx(body + bytes([known.seed])).to_bytes(CRC_BYTES, "little")


def base_bytes(message: Definition) -> int:
    """Length of a message's payload without extension fields, which stand at its end: all of it in MAVLink 1."""
    return struct.calcsize("<" + "".join(field.form for field in message.base))
