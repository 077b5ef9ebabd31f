"""Events in words, by the definitions that a vehicle's metadata holds, as libevents reads them.

    id          of the namespace in the upper 8 bits, of the event in the lower 24
    arguments   one after the other, little-endian, without gaps
    {2:.1m/s}   in a message: the second argument, one digit behind the point, and its unit
    <param>…    tags are left out, what they enclose stays; but that of a profile which is not the user's
[lineage] mavlink/libevents, README.md and libs/cpp/parse
"""

from __future__ import annotations

import re
import struct
from typing import NamedTuple

import msgspec

from gcs.mavlink.metadata.client import decoded

_BASE = {
    "uint8_t": "B", "int8_t": "b", "uint16_t": "H", "int16_t": "h", "uint32_t": "I", "int32_t": "i", "uint64_t": "Q",
    "int64_t": "q", "float": "f",
}  # fmt: skip
_UNITS = {"m_v": " m", "C": " °C"}
_PROFILE = re.compile(r'<profile name="(!?)([^"]*)">(.*?)</profile>', re.DOTALL)
_PART = re.compile(r"\\(.)|</?[a-z][^>]*>|\{(\d+)(?::(?:\.(\d))?)?(m|m_v|m/s|m\^2|C)?\}", re.DOTALL)
MOST_CHARACTERS = 500
"""Of a message, and of the text that is made of it; libevents' schema has 120 for the first."""
PROFILE = "normal"
"""Users' profile: what is for developers alone is left out."""


class _Argument(msgspec.Struct):
    name: str
    type: str


class _Definition(msgspec.Struct):
    name: str
    message: str
    type: str = ""
    arguments: list[_Argument] = []


class _EventGroup(msgspec.Struct):
    events: dict[int, _Definition] = {}


class _Entry(msgspec.Struct):
    description: str


class _Enum(msgspec.Struct):
    type: str
    entries: dict[int, _Entry] = {}
    is_bitfield: bool = False
    separator: str = "|"


class _Namespace(msgspec.Struct):
    namespace: str
    enums: dict[str, _Enum] = {}
    event_groups: dict[str, _EventGroup] = {}


class _Definitions(msgspec.Struct):
    version: int
    components: dict[int, _Namespace]


class EventWords(NamedTuple):
    """An event for a person; its group and type say what it is for."""

    group: str
    type: str
    text: str
    values: tuple[str | float, ...]
    """of its arguments, an enumeration's in words"""


class EventDefinitions:
    """Definitions of one vehicle's events."""

    def __init__(self, content: bytes) -> None:
        """`content`: the file's, unpacked. Raises MetadataRefused."""
        spaces = decoded(content, _Definitions, "the file of its events").components
        self._enums = {f"{one.namespace}::{name}": enum for one in spaces.values() for name, enum in one.enums.items()}
        self._known = {
            number << 24 | event: (space.namespace, name, definition)
            for number, space in spaces.items()
            for name, group in space.event_groups.items()
            for event, definition in group.events.items()
        }

    def words(self, event_id: int, arguments: bytes) -> EventWords | None:
        """The event in words; None for one that is not defined, or not as its arguments are."""
        if event_id not in self._known:
            return None
        namespace, group, definition = self._known[event_id]
        values: list[str | float] = []
        at = 0
        for argument in definition.arguments:
            enum = self._enums.get(argument.type) or self._enums.get(f"{namespace}::{argument.type}")
            form = _BASE.get(argument.type if enum is None else enum.type)
            if form is None or at + struct.calcsize(f"<{form}") > len(arguments):
                return None
            (value,) = struct.unpack_from(f"<{form}", arguments, at)
            at += struct.calcsize(f"<{form}")
            values.append(value if enum is None else _entry(enum, value))
        return EventWords(group, definition.type, _filled(definition.message, values), tuple(values))


def _entry(enum: _Enum, value: int) -> str:
    """A value of an enumeration in words."""
    if not enum.is_bitfield:
        return enum.entries[value].description if value in enum.entries else str(value)
    bits = [1 << k for k in range(64) if value & 1 << k]
    return enum.separator.join(enum.entries[bit].description if bit in enum.entries else str(bit) for bit in bits)


def _filled(message: str, values: list[str | float]) -> str:
    def shown(match: re.Match[str]) -> str:
        escaped, place, digits, unit = match.groups()
        if escaped is not None or place is None:
            return escaped or ""
        if not 1 <= int(place) <= len(values):
            return ""
        value = values[int(place) - 1]
        text = value if isinstance(value, str) else f"{value:.{digits}f}" if digits else _plain(value)
        return text + ("" if unit is None else _UNITS.get(unit, f" {unit}"))

    message = _PROFILE.sub(lambda m: m[3] if (m[2] == PROFILE) != bool(m[1]) else "", message[:MOST_CHARACTERS])
    return _PART.sub(shown, message).strip()[:MOST_CHARACTERS]


def _plain(value: float) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)
