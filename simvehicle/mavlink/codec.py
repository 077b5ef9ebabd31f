"""MAVLink 2 frames: bytes to messages and back, driven by one table.

The table (ids, CRC seeds, field order, types) is taken from MAVLink's definitions of the common messages, a message at
a time, when it is first needed. A message is a named tuple whose fields stand in wire order, so that packing is one
`struct` call.
"""

from __future__ import annotations

import struct
from collections import namedtuple
from functools import cache
from typing import Any, NamedTuple

import cython
from cython.cimports.cpython.bytes import PyBytes_AS_STRING, PyBytes_FromStringAndSize
from cython.cimports.libc.string import memchr
from cython.cimports.simvehicle.mavlink.codec import MOST_TRIES
from cython.cimports.skytender.frames import MAGIC
from cython.cimports.skytender.intact_frames import intact_at

from skytender import frames, mavlink
from skytender.mavlink import MESSAGES, Definition

"""Of a datagram MOST_TRIES places may look like a frame's beginning and be none, before its rest is passed over."""


class ReceivedFrame:
    """One frame as it came: header, payload as on the wire (trailing zeros may be missing) and all its bytes."""

    sysid: int
    compid: int
    seq: int
    msgid: int
    payload: bytes
    raw: bytes

    def __init__(self, sysid: int, compid: int, seq: int, msgid: int, payload: bytes, raw: bytes) -> None:
        self.sysid, self.compid, self.seq, self.msgid = sysid, compid, seq, msgid
        self.payload, self.raw = payload, raw

    @property
    def sender(self) -> tuple[int, int]:
        """System and component that sent it."""
        return self.sysid, self.compid


Arrays = tuple[tuple[int, int], ...]


class Schema(NamedTuple):
    """The table's entry of one message; `arrays` holds (first slot, length) of each array in wire order."""

    msgid: int
    seed: int
    packer: struct.Struct
    arrays: Arrays
    text: tuple[int, ...]
    make: Any


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
    row = make.SCHEMA = Schema(definition.id, definition.seed, packer, arrays, text, make)
    return row


@cache
def message(name: str) -> Any:
    """The named-tuple class of a message by its MAVLink name, e.g. `message("ATTITUDE")`; 0 is what is not given."""
    row = schema(getattr(mavlink, f"MAVLINK_MSG_ID_{name}"))
    assert row is not None
    return row.make


def encode(content: Any, *, seq: int, sysid: int, compid: int) -> bytes:
    """The frame of a message made by `message(...)`; trailing zeros of the payload are cut as MAVLink 2 asks."""
    row = content.SCHEMA
    return frames.frame(packed(content), row.msgid, row.seed, seq, sysid, compid)


def packed(content: Any) -> bytes:
    """Payload of a message made by `message(...)`, with all its zeros."""
    row, values = content.SCHEMA, content
    if row.arrays or row.text:
        values = list(content)
        for slot in row.text:
            values[slot] = as_bytes(values[slot])
        for slot, _ in reversed(row.arrays):
            values[slot : slot + 1] = values[slot]
    return row.packer.pack(*values)


def as_bytes(text: str | bytes) -> bytes:
    """A text field on the wire: UTF-8."""
    return text.encode("utf-8", "replace") if isinstance(text, str) else text


def decode(frame: ReceivedFrame) -> Any | None:
    """The named tuple of a frame's message; None where the dialect does not know its id."""
    row = schema(frame.msgid)
    return None if row is None else unpacked(row, frame.payload)


def unpacked(row: Schema, payload: bytes) -> Any:
    """The named tuple of a message's payload, which may lack zeros at its end."""
    size = row.packer.size
    values: Any = row.packer.unpack(payload[:size].ljust(size, b"\0"))
    if row.arrays or row.text:
        values = list(values)
        for slot, length in row.arrays:
            values[slot : slot + length] = [tuple(values[slot : slot + length])]
        for slot in row.text:
            values[slot] = values[slot].split(b"\0", 1)[0].decode("utf-8", "replace")
    return row.make._make(values)


def speaks_mavlink_1(datagram: bytes) -> bool:
    """Whether a datagram begins with an intact MAVLink 1 frame of the dialect."""
    first = intact_at(cython.cast("const unsigned char *", PyBytes_AS_STRING(datagram)), 0, len(datagram))
    return bool(first.end != 0 and first.version == 1 and first.common)


def split(datagram: bytes) -> list[ReceivedFrame]:
    """Every intact MAVLink 2 frame of a datagram, in order; whatever is none is passed over.

    A frame of an id that the dialect does not know cannot be checked and is passed over too. No more than MOST_TRIES
    places that are no frame are tried: what a stranger can make this cost is bounded.
    """
    found: list[ReceivedFrame] = []
    _split(datagram, found)
    return found


def _split(datagram: bytes, found: list[ReceivedFrame]) -> None:
    data = cython.cast("const unsigned char *", PyBytes_AS_STRING(datagram))
    text = cython.cast("const char *", data)
    at, size, tries = 0, len(datagram), 0
    while tries < MOST_TRIES:
        place = cython.cast("const unsigned char *", memchr(data + at, MAGIC, size - at))
        if not place:
            return
        at = place - data
        intact = intact_at(data, at, size)
        if intact.end and intact.common:
            frame = ReceivedFrame.__new__(ReceivedFrame)
            frame.sysid, frame.compid, frame.seq = data[at + 5], data[at + 6], data[at + 4]
            frame.msgid = intact.msgid
            frame.payload = PyBytes_FromStringAndSize(text + intact.payload, intact.checksum - intact.payload)
            frame.raw = PyBytes_FromStringAndSize(text + at, intact.end - at)
            found.append(frame)
            at = intact.end
        else:
            tries += 1
            at += 1
