"""MAVLink frames ↔ messages: one decoder and one encoder, both driven by a table.

The table comes from MAVLink's definitions (skytender/mavlink.py: id, CRC seed, wire format, field names) and is built
per message when it is first met. Frames are in the form of MAVLink 2; MAVLink 1 is converted to it. A message
is a named tuple with its fields in *wire order*, values in MAVLink's own units: arrays are tuples, character arrays are
str, of UTF-8 up to the first NUL.
"""

from __future__ import annotations

import struct
from collections import namedtuple
from collections.abc import Callable, Sequence
from functools import lru_cache, partial
from operator import itemgetter
from typing import Any, NamedTuple, cast

from gcs.mavlink import dialect
from gcs.mavlink.dialect import CRC_TERMS
from gcs.mavlink.frames import MOST_TRIES, Frame, Split, split
from skytender import mavlink
from skytender.checksum import mcrf4xx
from skytender.mavlink import MESSAGES

__all__ = [
    "BEFORE_MARKER", "CRC_BYTES", "HEADER_BYTES", "LARGEST_FRAME", "MARKER", "MOST_TRIES", "SIGNATURE_BYTES", "SIGNED",
    "Frame", "Message", "Split", "WireFloat", "WireLayout", "encode", "fields", "frame", "layout", "message", "msgid",
    "name", "seed_of", "sent_by", "split", "target_of",
]  # fmt: skip

MARKER, HEADER_BYTES, CRC_BYTES = dialect.MARKER, dialect.HEADER_BYTES, dialect.CRC_BYTES
SIGNED = 0x01
SIGNATURE_BYTES = 13
LARGEST_FRAME = HEADER_BYTES + 255 + CRC_BYTES + SIGNATURE_BYTES

# Marker, payload length, incompatibility flags, compatibility flags, seq, sysid, compid, id (low 16 bits, high 8).
_HEADER = "<BBBBBBBHB"
_new = tuple.__new__  # fills a named tuple from a tuple without the detour over its constructor

_IDS: dict[str, int] = {known.name: msgid for msgid, known in MESSAGES.items()}
# By the id as it stands in a frame.
_SEEDS = {msgid.to_bytes(3, "little"): bytes([known.seed]) for msgid, known in MESSAGES.items()}

# A checksum leaves the marker out. From this register the marker leads to the one that checksums begin with, so that a
# frame need not be cut before it is summed: a byte makes crc >> 8 ^ term[crc & 0xFF ^ byte] of crc, here 0xFFFF.
_INDEX = next(index for index, term in enumerate(CRC_TERMS) if term >> 8 == 0xFF)
BEFORE_MARKER = (0xFF ^ CRC_TERMS[_INDEX] & 0xFF) << 8 | _INDEX ^ MARKER


class Message(NamedTuple):
    """A message without a header, one value per field in wire order: what is numbered, and framed, when it is sent."""

    msgid: int
    values: tuple[Any, ...]


class WireLayout(NamedTuple):
    """Wire layout of one message: the one table from which codec, recordings and exports read it; `record` is its
    named tuple, fields in wire order."""

    msgid: int
    name: str
    record: Any
    formats: tuple[str, ...]  # struct format of each field
    defaults: dict[str, Any]  # fields that a sender may leave out


class WireFloat(float):
    """A float field's number with its four bytes: an integer's that look like a NaN are lost in the number alone."""

    __slots__ = ("raw",)
    raw: bytes

    def __new__(cls, raw: bytes) -> WireFloat:
        """`raw`: four bytes, little-endian."""
        number = super().__new__(cls, *struct.unpack("<f", raw))
        number.raw = raw
        return number


_BYTEWISE = {mavlink.MAVLINK_MSG_ID_PARAM_VALUE, mavlink.MAVLINK_MSG_ID_PARAM_SET}
"""Messages whose floats may be the bytes of integers."""


class _Reader(NamedTuple):
    """Part of a layout that decoding needs."""

    payload_bytes: int  # uncut
    wire: struct.Struct  # of a frame with such a payload, its header skipped, without CRC
    unpack: Callable[[bytes], tuple[Any, ...]]  # such a frame → flat values
    regroup: Callable[[Any], tuple[Any, ...]] | None  # flat values → one per field; None where they are the same
    text_at: tuple[int, ...]  # the fields that are character arrays
    record: Any


class _Table(dict[int, Any]):
    """Message id → what `build` makes of it, made when first asked for."""

    def __init__(self, build: Callable[[int], Any]) -> None:
        super().__init__()
        self._build = build

    def __missing__(self, msgid: int) -> Any:
        entry = self[msgid] = self._build(msgid)
        return entry


def _layout(msgid: int) -> WireLayout:
    known = MESSAGES.get(msgid)
    if known is None:
        raise ValueError(
            f"message id {msgid} is not in the MAVLink dialect '{dialect.NAME}': it cannot be read or sent"
        )
    formats = tuple(field.form for field in known.wire)
    defaults = {field.name: field.unset for field in known.extensions}
    if "mavlink_version" in (names := [field.name for field in known.wire]):
        defaults["mavlink_version"] = 3  # throughout MAVLink 2
    record = namedtuple(known.name, names)  # type: ignore[misc]
    return WireLayout(msgid, known.name, record, formats, defaults)


def _is_array(form: str) -> bool:
    return len(form) > 1 and form[-1] != "s"


def _reader(msgid: int) -> _Reader:
    shape = _LAYOUTS[msgid]
    takes: list[int | slice] = []
    at = 0
    for form in shape.formats:
        flat = int(form[:-1]) if _is_array(form) else 1
        takes.append(slice(at, at + flat) if _is_array(form) else at)
        at += flat
    regroup: Callable[[Any], tuple[Any, ...]] | None = None
    if any(map(_is_array, shape.formats)):
        regroup = itemgetter(*takes) if len(takes) > 1 else lambda values: (values,)
    forms = _struct_formats(shape)
    if forms != shape.formats:
        regroup = partial(_with_bytes, tuple(index for index, form in enumerate(shape.formats) if form == "f"))
    wire = struct.Struct(f"<{HEADER_BYTES}x{''.join(forms)}")
    text_at = tuple(index for index, form in enumerate(shape.formats) if form[-1] == "s")
    return _Reader(wire.size - HEADER_BYTES, wire, wire.unpack_from, regroup, text_at, shape.record)


def _struct_formats(shape: WireLayout) -> tuple[str, ...]:
    """The formats of a message's fields by which it is read and packed."""
    return tuple("4s" if form == "f" and shape.msgid in _BYTEWISE else form for form in shape.formats)


def _with_bytes(float_at: tuple[int, ...], values: tuple[Any, ...]) -> tuple[Any, ...]:
    return tuple(WireFloat(value) if index in float_at else value for index, value in enumerate(values))


def layout(message: int | str) -> WireLayout:
    """The layout of a message by name or id. Raises ValueError for one that the dialect lacks."""
    if isinstance(message, str):
        if message not in _IDS:
            raise ValueError(f"{message} is no message of the MAVLink dialect '{dialect.NAME}'")
        message = _IDS[message]
    return cast(WireLayout, _LAYOUTS[message])


def name(msgid: int) -> str:
    """The message's name; `UNKNOWN_<id>` for an id that the dialect lacks."""
    known = MESSAGES.get(msgid)
    return f"UNKNOWN_{msgid}" if known is None else known.name


def msgid(message: str) -> int:
    """The message's id. Raises ValueError for a name that the dialect lacks."""
    return layout(message).msgid


def seed_of(raw: bytes) -> bytes:
    """The byte with which the checksum of a frame of the dialect ends."""
    return _SEEDS[raw[7:10]]


def fields(frame: Frame) -> Any:
    """Decode a frame's payload: a named tuple of the message's fields, its class named like the message.

    A cut payload is filled with zeros, a longer one (newer extensions) is read as far as it is known. Raises ValueError
    for an id that the dialect lacks.
    """
    _, _, _, msgid, raw = frame
    payload_bytes, _, unpack, regroup, text_at, record = _READERS[msgid]
    if raw[1] < payload_bytes:
        raw = raw[: HEADER_BYTES + raw[1]].ljust(HEADER_BYTES + payload_bytes, b"\0")
    values = unpack(raw)
    if regroup is not None:
        values = regroup(values)
    if text_at:
        values = _with_text(values, text_at)
    return _new(record, values)


def target_of(raw: bytes) -> int:
    """System id that a frame is for; 0 for all, and of a message that names none. Raises ValueError for an id that the
    dialect lacks."""
    frame = Frame(raw[5], raw[6], raw[4], int.from_bytes(raw[7:10], "little"), raw)
    return int(getattr(fields(frame), "target_system", 0))


def sent_by(frame: Frame, compid: int, sysid: int | None = None) -> Frame:
    """The frame as if another component, or system, had sent it, unsigned; as it is where the dialect lacks its id."""
    raw = frame.raw
    if frame.msgid not in MESSAGES:
        return frame
    sysid = frame.sysid if sysid is None else sysid
    body = raw[:2] + b"\0" + raw[3:5] + bytes([sysid, compid]) + raw[7 : HEADER_BYTES + raw[1]]
    crc = mcrf4xx(body + seed_of(raw), BEFORE_MARKER)
    return frame._replace(sysid=sysid, compid=compid, raw=body + crc.to_bytes(CRC_BYTES, "little"))


def _with_text(values: tuple[Any, ...], text_at: tuple[int, ...]) -> tuple[Any, ...]:
    shown = list(values)
    for index in text_at:
        shown[index] = _text(shown[index])
    return tuple(shown)


@lru_cache(maxsize=4096)  # names recur: of counters, of parameters
def _text(characters: bytes) -> str:
    return characters.partition(b"\0")[0].decode("utf-8", "replace")


def _packer(msgid: int) -> Callable[..., bytes]:
    """The function `(seq, sysid, compid, *values) -> frame` of one message, its values in wire order: an array as a
    sequence, text as str. It raises ValueError, in one sentence that names the field, for a value that does not fit."""
    shape = _LAYOUTS[msgid]
    wire = struct.Struct(_HEADER + "".join(_struct_formats(shape)))
    pack, pack_crc, payload_bytes = wire.pack, struct.Struct("<H").pack, wire.size - HEADER_BYTES
    id_low, id_high = msgid & 0xFFFF, msgid >> 16
    seed = _SEEDS[msgid.to_bytes(3, "little")]
    plain = all(len(form) == 1 for form in shape.formats)

    def pack_frame(seq: int, sysid: int, compid: int, *values: Any) -> bytes:
        try:
            items = values if plain else _flat(shape, values)
            body = pack(MARKER, payload_bytes, 0, 0, seq, sysid, compid, id_low, id_high, *items)
        except (struct.error, OverflowError, TypeError):
            raise _refusal(shape, (seq, sysid, compid), values) from None
        if not body[-1]:
            payload = body[HEADER_BYTES:].rstrip(b"\0") or b"\0"
            body = body[:1] + bytes([len(payload)]) + body[2:HEADER_BYTES] + payload
        return body + pack_crc(mcrf4xx(body + seed, BEFORE_MARKER))

    return pack_frame


_LAYOUTS, _READERS, _PACKERS = _Table(_layout), _Table(_reader), _Table(_packer)


def message(message: int | str, /, **values: Any) -> Message:
    """A message from its fields by name; extension fields may be left out.

    Raises ValueError for an unknown message, an unknown or missing field, and a value that its field cannot hold.
    """
    shape = layout(message)
    names = shape.record._fields
    given = shape.defaults | values
    if given.keys() != set(names):
        unknown, missing = sorted(given.keys() - set(names)), [field for field in names if field not in given]
        fault = f"has no field {', '.join(unknown)}" if unknown else f"needs {', '.join(missing)}"
        raise ValueError(f"{shape.name} {fault}; its fields are {', '.join(names)}")
    made = Message(shape.msgid, tuple(given[field] for field in names))
    frame(made, 0, 0, 0)  # so that a value that does not fit is refused where it was given, not where it is sent
    return made


def frame(message: Message, seq: int, sysid: int, compid: int) -> bytes:
    """The message as a MAVLink 2 frame with this sequence number and sender, each 0-255 (else ValueError)."""
    msgid, values = message
    return cast(bytes, _PACKERS[msgid](seq, sysid, compid, *values))


def encode(name: int | str, seq: int, sysid: int, compid: int, /, **values: Any) -> bytes:
    """A frame from the message's fields by name: `frame(message(name, ...), ...)`, with the errors of both."""
    return frame(message(name, **values), seq, sysid, compid)


def _flat(shape: WireLayout, values: Sequence[Any]) -> list[Any]:
    """One value per field → one per struct item. Raises ValueError where an array's length or a text does not fit."""
    items: list[Any] = []
    for field, form, value in zip(shape.record._fields, shape.formats, values, strict=False):
        length = int(form[:-1]) if len(form) > 1 else 1
        if form[-1] == "s" and isinstance(value, str | bytes):
            # What could not be read is one byte again: a text that was received fits where it came from.
            text = value.replace("\ufffd", "?").encode("utf-8", "replace") if isinstance(value, str) else value
            if len(text) > length:
                raise ValueError(f"{shape.name}.{field} holds {length} bytes of text, not the {len(text)} of {value!r}")
            items.append(text)
        elif _is_array(form):
            if not isinstance(value, Sequence) or len(value) != length:
                raise ValueError(f"{shape.name}.{field} holds {length} values, not {value!r}")
            items.extend(value)
        elif form == "f" and shape.msgid in _BYTEWISE:
            items.append(value.raw if isinstance(value, WireFloat) else struct.pack("<f", value))
        else:
            items.append(value)
    return items


def _refusal(shape: WireLayout, header: tuple[int, int, int], values: Sequence[Any]) -> ValueError:
    """The error for values that struct refused: which, and what it takes."""
    names = shape.record._fields
    if len(values) != len(names):
        return ValueError(f"{shape.name} takes {len(names)} values, {', '.join(names)}; {len(values)} were given")
    places = zip((*names, "seq", "sysid", "compid"), (*shape.formats, "B", "B", "B"), (*values, *header), strict=True)
    for field, form, value in places:
        for item in value if _is_array(form) else (value,):
            try:
                struct.pack(form if form[-1] == "s" else "<" + form[-1], item)
            except (struct.error, OverflowError):
                takes = "text" if form[-1] == "s" else "a number" if form[-1] in "fd" else "an integer"
                return ValueError(f"{shape.name}.{field} cannot be {item!r}: it takes {takes} that fits '{form[-1]}'")
    return ValueError(f"{shape.name} cannot be packed from {values!r}")
