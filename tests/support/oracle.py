"""pymavlink as the oracle of both codecs: frames that it makes, and values compared with those that it reads."""

from __future__ import annotations

import math
import struct
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mav

CLASSES: dict[str, Any] = {cls.msgname: cls for cls in mav.mavlink_map.values()}


def peer_frame(name: str, payload: bytes, seq: int = 7, sysid: int = 3, compid: int = 1) -> bytes:
    """A frame around these payload bytes, made by pymavlink."""
    sender = mav.MAVLink(None, srcSystem=sysid, srcComponent=compid)
    sender.seq = seq
    return bytes(mav.MAVLink_message(CLASSES[name].id, name)._pack(sender, CLASSES[name].crc_extra, payload))


def values_of(cls: Any) -> dict[str, Any]:
    """Another value for each field of a message of pymavlink's."""
    values: dict[str, Any] = {}
    for index, (field, kind) in enumerate(zip(cls.fieldnames, cls.fieldtypes, strict=True)):
        length = cls.array_lengths[cls.orders[index]]
        if kind == "char":
            values[field] = "Skytender"[: length or 1]
        elif length:
            values[field] = [(i + index) % 100 for i in range(length)]
        else:
            values[field] = index + 0.5 if kind in ("float", "double") else index + 1
    return values


def made(cls: Any, values: dict[str, Any]) -> Any:
    """The message with these values."""
    return cls(**{name: value.encode() if isinstance(value, str) else value for name, value in values.items()})


def with_crc(head_and_payload: bytes, seed: int) -> bytes:
    """The frame that these bytes begin, ended as its kind's seed asks."""
    return head_and_payload + struct.pack("<H", mav.x25crc(head_and_payload[1:] + bytes([seed])).crc)


def same(ours: Any, theirs: Any) -> bool:
    """Whether a field's values are equal and of one type; NaN equals NaN."""
    if isinstance(ours, tuple):
        return len(ours) == len(theirs) and all(map(same, ours, theirs))
    if isinstance(ours, float) and math.isnan(ours):
        return math.isnan(theirs)
    return isinstance(ours, type(theirs)) and bool(ours == theirs)


def value_of(message: Any, field: str) -> Any:
    """A field of a message of pymavlink's, which reads characters as ASCII: here as UTF-8, which texts are."""
    value = getattr(message, field)
    if isinstance(value, str):
        return bytes(getattr(message, f"_{field}_raw")).partition(b"\0")[0].decode("utf-8", "replace")
    return tuple(value) if isinstance(value, list) else value
