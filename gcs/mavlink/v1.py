"""MAVLink 1, as old autopilots, radio modems and many a script still send it: read, and turned into MAVLink 2."""

from __future__ import annotations

from fastcrc.crc16 import mcrf4xx
from pymavlink.dialects.v20 import common

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame

MARKER, HEADER_BYTES = 0xFE, 6


def split(datagram: bytes) -> list[Frame]:
    """The intact MAVLink 1 frames of the dialect in a datagram, each in the form of MAVLink 2; never raises."""
    frames: list[Frame] = []
    at, tries = datagram.find(MARKER), 0
    while at >= 0 and tries < codec.MOST_TRIES and at + HEADER_BYTES + codec.CRC_BYTES <= len(datagram):
        length, seq, sysid, compid, msgid = datagram[at + 1 : at + HEADER_BYTES]
        end = at + HEADER_BYTES + length
        cls = common.mavlink_map.get(msgid)
        if cls is not None and end + codec.CRC_BYTES <= len(datagram):
            seed = bytes([cls.crc_extra])
            if mcrf4xx(datagram[at + 1 : end] + seed) == int.from_bytes(
                datagram[end : end + codec.CRC_BYTES], "little"
            ):
                body = bytes([length, 0, 0, seq, sysid, compid, msgid, 0, 0]) + datagram[at + HEADER_BYTES : end]
                raw = bytes([codec.MARKER]) + body + mcrf4xx(body + seed).to_bytes(codec.CRC_BYTES, "little")
                frames.append(Frame(sysid, compid, seq, msgid, raw))
                at = datagram.find(MARKER, end + codec.CRC_BYTES)
                continue
        tries += 1
        at = datagram.find(MARKER, at + 1)
    return frames
