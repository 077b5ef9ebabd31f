"""The two forms of a frame, of MAVLink 1 and 2, one turned into the other.

Old autopilots, radio modems and many a script still send MAVLink 1. Its frames are read in the form of MAVLink 2. Both
sum a frame alike, header and payload without the marker, and end with a seed of the message's own, so that a checksum
tells the seed of a message that the table lacks.
"""

from __future__ import annotations

import struct

from skytender.checksum import mcrf4xx
from skytender.mavlink import MESSAGES, Definition

NAME = "ardupilotmega"
MARKER, HEADER_BYTES = 0xFD, 10
MARKER_1, HEADER_1_BYTES = 0xFE, 6
CRC_BYTES = 2
IDS_1 = 256
"""MAVLink 1 has no id above 255."""

CRC_TERMS = [mcrf4xx(bytes([seed]), 0) for seed in range(256)]
"""Terms that one seed byte can add to a checksum: CRC(body, seed) = CRC(body) >> 8 ^ one of these, that at
(CRC(body) ^ seed) & 0xFF."""
_INDEX_OF = {term: index for index, term in enumerate(CRC_TERMS)}


def newer_form(data: bytes, at: int) -> bytes:
    """The intact MAVLink 1 frame whose marker stands there, as MAVLink 2."""
    length, seq, sysid, compid, msgid = data[at + 1 : at + HEADER_1_BYTES]
    body_end = at + HEADER_1_BYTES + length
    crc = int.from_bytes(data[body_end : body_end + CRC_BYTES], "little")
    body_crc = mcrf4xx(data[at + 1 : body_end])
    seed = _INDEX_OF[crc ^ body_crc >> 8] ^ body_crc & 0xFF
    body = bytes([length, 0, 0, seq, sysid, compid, msgid, 0, 0]) + data[at + HEADER_1_BYTES : body_end]
    return bytes([MARKER]) + body + mcrf4xx(body + bytes([seed])).to_bytes(CRC_BYTES, "little")


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
