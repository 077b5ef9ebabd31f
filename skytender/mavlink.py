"""MAVLink's definitions that both programs read: numbers, messages and autopilots' modes of ArduPilot's dialect, which
holds the common messages too. Every number has its name here, for example MAV_TYPE_QUADROTOR and
MAVLINK_MSG_ID_HEARTBEAT.

They stand in mavlink.json, which tests/support/mavlink_definitions.py makes of pymavlink's and of what these lack
(tests/support/newer.xml).
"""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

_CODES = {
    "char": "s", "int8_t": "b", "uint8_t": "B", "int16_t": "h", "uint16_t": "H", "int32_t": "i", "uint32_t": "I",
    "int64_t": "q", "uint64_t": "Q", "float": "f", "double": "d",
}  # fmt: skip


class Field(NamedTuple):
    """A field of a message."""

    name: str
    kind: str
    """MAVLink's type, of an array that of its elements"""
    length: int
    """of an array, 0 of a single value"""
    units: str
    invalid: str
    """how the definitions write the value that means that none is known; empty without one"""

    @property
    def form(self) -> str:
        """`struct`'s format: `f`, `4B`, `16s`."""
        return f"{self.length or ('1' if self.kind == 'char' else '')}{_CODES[self.kind]}"

    @property
    def unset(self) -> Any:
        """The value of a field that is not given."""
        return "" if self.kind == "char" else (0,) * self.length or 0


class Command(NamedTuple):
    """A command, also as an item of a mission."""

    name: str
    """`NAV_WAYPOINT`"""
    has_place: bool
    """whether its last three parameters are a place"""
    labels: Mapping[int, str]
    """names of its parameters, which are counted from 1; not all have one"""


class Definition(NamedTuple):
    """A message; its fields in the definitions' order, extensions last."""

    id: int
    name: str
    seed: int
    """the byte with which checksums of its frames end (CRC_EXTRA)"""
    common: bool
    """whether it is one of the common messages"""
    base: tuple[Field, ...]
    """the fields of MAVLink 1"""
    extensions: tuple[Field, ...]

    @property
    def wire(self) -> tuple[Field, ...]:
        """The fields in wire order: the greatest types first, extensions as they are
        (https://mavlink.io/en/guide/serialization.html#field_reordering)."""
        base = sorted(self.base, key=lambda field: struct.calcsize(f"<{_CODES[field.kind]}"), reverse=True)
        return (*base, *self.extensions)


def _definition(name: str, row: list[Any]) -> Definition:
    msgid, seed, common, extended, rows = row
    fields = tuple(Field(*field) for field in rows)
    return Definition(msgid, name, seed, common, fields[: len(fields) - extended], fields[len(fields) - extended :])


_FILE = json.loads(Path(__file__).with_name("mavlink.json").read_bytes())

PYMAVLINK: str = _FILE["pymavlink"]
"""Its version whose definitions these are."""
MESSAGES: Mapping[int, Definition] = {row[0]: _definition(name, row) for name, row in _FILE["messages"].items()}
ENUMS: Mapping[str, Mapping[int, str]] = {
    name: {value: entry for entry, value in entries.items()} for name, entries in _FILE["enums"].items()
}
"""Names of an enumeration's entries by their value."""
COMMANDS: Mapping[int, Command] = {
    _FILE["enums"]["MAV_CMD"][name]: Command(
        name.removeprefix("MAV_CMD_"), has_place, {int(number): label for number, label in labels.items()}
    )
    for name, (has_place, labels) in _FILE["commands"].items()
}
"""By their number, MAV_CMD."""
MODES: Mapping[str, Mapping[str, int]] = _FILE["modes"]
"""HEARTBEAT.custom_mode by the name that pymavlink and MAVProxy give the mode: of each of ArduPilot's vehicles, and of
PX4 as `main and sub` mode."""


def command_name(command: int) -> str:
    """`NAV_WAYPOINT`; `command 31010` for one that the dialect lacks."""
    known = COMMANDS.get(command)
    return known.name if known else f"command {command}"


globals().update((name, value) for entries in _FILE["enums"].values() for name, value in entries.items())
globals().update((f"MAVLINK_MSG_ID_{name}", row[0]) for name, row in _FILE["messages"].items())


def __getattr__(name: str) -> int:
    raise AttributeError(f"MAVLink's definitions (skytender/mavlink.json) have no {name}")
