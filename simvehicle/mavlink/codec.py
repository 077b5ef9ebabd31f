"""MAVLink 2 frames: bytes to messages and back, driven by one table.

The table (ids, CRC seeds, field order, types) is taken from MAVLink's definitions of the common messages, a message at
a time, when it is first needed. A message is a named tuple whose fields stand in wire order, so that packing is one
`struct` call.
"""

from __future__ import annotations

import struct
from collections import namedtuple
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, NamedTuple

from fastcrc.crc16 import mcrf4xx

from skytender import mavlink
from skytender.mavlink import MESSAGES, Definition

MAGIC, MAGIC_1 = 0xFD, 0xFE
HEADER_1_BYTES = 6
HEADER = struct.Struct("<BBBBBBBHB")
HEADER_BYTES = 10
CHECKSUM_BYTES = 2
SIGNATURE_BYTES = 13
SIGNED = 0x01
MOST_TRIES = 64
"""Places in a datagram that may look like a frame's beginning and be none, before the rest of it is passed over."""
_MAGIC_BYTE = bytes((MAGIC,))
_CHECKSUM = struct.Struct("<H")


class ReceivedFrame(NamedTuple):
    """One frame as it came: header, payload as on the wire (trailing zeros may be missing) and all its bytes."""

    sysid: int
    compid: int
    seq: int
    msgid: int
    payload: bytes
    raw: bytes


Arrays = tuple[tuple[int, int], ...]
Encoder = Callable[[Any, int, int, int], bytes]


class Schema(NamedTuple):
    """The table's entry of one message; `arrays` holds (first slot, length) of each array in wire order."""

    msgid: int
    seed: bytes
    packer: struct.Struct
    arrays: Arrays
    text: tuple[int, ...]
    make: Any
    encode: Encoder


_tuple_class: Any = namedtuple  # the fields come from the table, where no type checker can follow


def schema(msgid: int) -> Schema | None:
    """The table's row of a message id; None where the dialect has none, of which nothing is kept."""
    row = _rows.get(msgid)
    if row is None and (known := MESSAGES.get(msgid)) is not None and known.common:
        row = _rows[msgid] = _row(known)
    return row


_rows: dict[int, Schema] = {}


def _row(definition: Definition) -> Schema:
    wire = definition.wire
    text = tuple(slot for slot, field in enumerate(wire) if field.kind == "char")
    arrays = tuple((slot, field.length) for slot, field in enumerate(wire) if field.length and slot not in text)
    make: Any = _tuple_class(definition.name, [field.name for field in wire], defaults=[field.unset for field in wire])
    packer = struct.Struct("<" + "".join(field.form for field in wire))
    seed = bytes((definition.seed,))
    encoder = _encoder(definition.id, seed, packer, arrays, text)
    row = make.SCHEMA = Schema(definition.id, seed, packer, arrays, text, make, encoder)
    return row


@cache
def message(name: str) -> Any:
    """The named-tuple class of a message by its MAVLink name, e.g. `message("ATTITUDE")`; 0 is what is not given."""
    row = schema(getattr(mavlink, f"MAVLINK_MSG_ID_{name}"))
    assert row is not None
    return row.make


def encode(content: Any, *, seq: int, sysid: int, compid: int) -> bytes:
    """The frame of a message made by `message(...)`; trailing zeros of the payload are cut as MAVLink 2 asks."""
    frame: bytes = content.SCHEMA.encode(content, seq, sysid, compid)
    return frame


def _encoder(msgid: int, seed: bytes, packer: struct.Struct, arrays: Arrays, text: tuple[int, ...]) -> Encoder:
    """`encode` of one message."""
    pack, pack_crc = struct.Struct(HEADER.format + packer.format.removeprefix("<")).pack, _CHECKSUM.pack
    size, low, high = packer.size, msgid & 0xFFFF, msgid >> 16
    plain = not (arrays or text)

    def encode_message(content: Any, seq: int, sysid: int, compid: int) -> bytes:
        values = content
        if not plain:
            values = list(content)
            for slot in text:
                values[slot] = as_bytes(values[slot])
            for slot, _ in reversed(arrays):
                values[slot : slot + 1] = values[slot]
        body = pack(MAGIC, size, 0, 0, seq, sysid, compid, low, high, *values)
        if not body[-1]:
            payload = body[HEADER_BYTES:].rstrip(b"\0") or b"\0"
            body = body[:1] + bytes((len(payload),)) + body[2:HEADER_BYTES] + payload
        return body + pack_crc(mcrf4xx(body[1:] + seed))

    return encode_message


def as_bytes(text: str | bytes) -> bytes:
    """A text field on the wire: UTF-8."""
    return text.encode("utf-8", "replace") if isinstance(text, str) else text


def decode(frame: ReceivedFrame) -> Any | None:
    """The named tuple of a frame's message; None where the dialect does not know its id."""
    row = schema(frame.msgid)
    if row is None:
        return None
    size = row.packer.size
    values: Any = row.packer.unpack(frame.payload[:size].ljust(size, b"\0"))
    if row.arrays or row.text:
        values = list(values)
        for slot, length in row.arrays:
            values[slot : slot + length] = [tuple(values[slot : slot + length])]
        for slot in row.text:
            values[slot] = values[slot].split(b"\0", 1)[0].decode("utf-8", "replace")
    return row.make._make(values)


def speaks_mavlink_1(datagram: bytes) -> bool:
    """Whether a datagram begins with an intact MAVLink 1 frame of the dialect."""
    if len(datagram) < HEADER_1_BYTES + CHECKSUM_BYTES or datagram[0] != MAGIC_1:
        return False
    check = HEADER_1_BYTES + datagram[1]
    row = schema(datagram[5]) if check + CHECKSUM_BYTES <= len(datagram) else None
    if row is None:
        return False
    return mcrf4xx(datagram[1:check] + row.seed) == int(_CHECKSUM.unpack_from(datagram, check)[0])


def split(datagram: bytes) -> Iterator[ReceivedFrame]:
    """Every intact MAVLink 2 frame of a datagram, in order; whatever is none is passed over.

    A frame of an id that the dialect does not know cannot be checked and is passed over too. Size, flags and id are
    looked at before a checksum is taken, and no more than MOST_TRIES places that are no frame are tried: what a
    stranger can make this cost is bounded.
    """
    start, end, tries = datagram.find(_MAGIC_BYTE), len(datagram), 0
    while start >= 0 and end - start >= HEADER_BYTES + CHECKSUM_BYTES and tries < MOST_TRIES:
        _, length, incompat, _, seq, sysid, compid, low, high = HEADER.unpack_from(datagram, start)
        body = start + HEADER_BYTES
        check = body + length
        stop = check + CHECKSUM_BYTES + (SIGNATURE_BYTES if incompat & SIGNED else 0)
        row = schema(low | high << 16) if stop <= end and not incompat & ~SIGNED else None
        if row is None or mcrf4xx(datagram[start + 1 : check] + row.seed) != _CHECKSUM.unpack_from(datagram, check)[0]:
            tries += 1
            start = datagram.find(_MAGIC_BYTE, start + 1)
            continue
        yield ReceivedFrame(sysid, compid, seq, low | high << 16, datagram[body:check], datagram[start:stop])
        start = datagram.find(_MAGIC_BYTE, stop)
