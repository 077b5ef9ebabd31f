"""Events: what the vehicle announces, numbered, so that a ground station notices which it missed, and can say
them in its own way.

Rules:
1. An announcement whose words stand in FORMS is an event, and gets the next number. Its id and its arguments say what
   it says; what else is announced goes as STATUSTEXT alone.
2. To a connection nothing of this is sent until a station has asked there for COMPONENT_METADATA, for
   CURRENT_EVENT_SEQUENCE or for an event: so a flight without such a station stays as it was. From then on each event
   is sent there once, and once a second the number of the last one. The STATUSTEXT that says the same ends there with a
   tabulator, by which stations that show events know it.
3. REQUEST_EVENT brings events again, the last KEPT of them; RESPONSE_EVENT_ERROR is the answer for others.
[lineage] Events Interface, https://mavlink.io/en/services/events.html; libevents' README for the definitions
"""

from __future__ import annotations

import re
import struct
import zlib
from collections import deque
from functools import cache
from typing import Any, NamedTuple

from simvehicle.autopilot.failures import Failure
from simvehicle.autopilot.modes import RULES, STAND_DOWN, Mode, Severity
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.peers import DecidedBy
from simvehicle.mavlink.codec import message
from simvehicle.mavlink.connection import Connection
from skytender import mavlink as mav

KEPT = 32
SEQUENCE_EVERY_MS = 1000
NAMESPACE = "skytender"
LEVELS = {Severity.INFO: 6, Severity.WARNING: 4, Severity.CRITICAL: 2}
"""libevents' log levels, the same as MAV_SEVERITY."""

ENUMS: dict[str, tuple[str, ...]] = {
    "failure_t": tuple(Failure),
    "mode_t": tuple(Mode),
    "decided_by_t": tuple(by.name.lower() for by in DecidedBy),
    "ending_t": (
        "stopped", "limit reached", "the receiver takes no more", "the giver is silent",
        *(f"mode {mode}" for mode in Mode),
    ),
}  # fmt: skip
"""Words by their number, of a uint8_t."""
_WIRE = {"uint8_t": "B", "uint16_t": "H", "int32_t": "i", "float": "f", **dict.fromkeys(ENUMS, "B")}
_NUMBERS = (r"-?\d+", r"-?\d+(?:\.\d+)?")
"""How a whole number, and any, is announced."""

FORMS: dict[str, tuple[str, ...]] = {
    **{rule.text: () for rule in (*RULES, STAND_DOWN) if rule.text},
    "Geofence breached": (),
    "Arming refused: {1} failed": ("failure_t",),
    "Arming refused: battery below BAT_EMERGEN_THR": (),
    "Arming refused: outside the geofence": (),
    "Arming refused: not in mode {1}": ("mode_t",),
    "Disarming refused: in the air": (),
    "Offboard refused: no set points": (),
    "Mission refused: there is none": (),
    "Follow refused: on the ground": (),
    "Mission has no item {1}": ("uint16_t",),
    "Set point ignored: frame {1}": ("uint8_t",),
    "Set point ignored: type_mask {1}": ("uint16_t",),
    "Set point ignored: not a number": (),
    "Reboot refused: armed or in the air": (),
    "Ground station {1} has control": ("uint8_t",),
    "Ground station {1} lost, nothing has control": ("uint8_t",),
    "Refused: ground station {1} has control": ("uint8_t",),
    "Rebooting": (),
    "Booted": (),
    "Gave {1} J: {2}": ("int32_t", "ending_t"),
    "Gave {1} J: the giver is {2:.1} m away": ("int32_t", "float"),
    "Gave {1} J: the giver moves at {2:.1} m/s": ("int32_t", "float"),
    "Received {1} J: {2}": ("int32_t", "ending_t"),
    "Received {1} J: the giver is {2:.1} m away": ("int32_t", "float"),
    "Received {1} J: the giver moves at {2:.1} m/s": ("int32_t", "float"),
    "Took back {1} J that did not arrive": ("int32_t",),
    "Calls tanker {1}: {2}": ("uint8_t", "decided_by_t"),
    "Serves {1}": ("uint8_t",),
    "Has served {1}: {2} J": ("uint8_t", "int32_t"),
    "Failure refused: SYS_FAILURE_EN is 0": (),
    "Injected: {1} failed": ("failure_t",),
    "Injected: {1} is off by {2:.1} m": ("failure_t", "float"),
    "Injected: {1} J of the battery are gone": ("int32_t",),
    "Mended: {1}": ("failure_t",),
}
"""Words of events, with libevents' places for arguments, and the arguments' types."""


class _Kept(NamedTuple):
    sequence: int
    content: Any


class _Form(NamedTuple):
    id: int
    pattern: re.Pattern[str]
    types: tuple[str, ...]


def definitions() -> dict[str, Any]:
    """Definitions of all events, as libevents' schema has them."""
    enums = {
        name: {
            "type": "uint8_t",
            "entries": {
                str(number): {"name": re.sub(r"\W+", "_", words).lower(), "description": words}
                for number, words in enumerate(entries)
            },
        }
        for name, entries in ENUMS.items()
    }
    events = {
        str(_sub_id(words)): {
            "name": _name(words),
            "message": words,
            "arguments": [{"name": f"argument_{k + 1}", "type": kind} for k, kind in enumerate(types)],
        }
        for words, types in FORMS.items()
    }
    component = {"namespace": NAMESPACE, "enums": enums, "event_groups": {"default": {"events": events}}}
    return {"version": 2, "components": {str(mav.MAV_COMP_ID_AUTOPILOT1): component}}


def event_of(text: str) -> tuple[int, bytes] | None:
    """Id and arguments of the event that these words are; None where they are none."""
    for form in _forms():
        if (found := form.pattern.fullmatch(text)) is not None:
            values = [_number(kind, words) for kind, words in zip(form.types, found.groups(), strict=True)]
            try:
                return form.id, struct.pack("<" + "".join(_WIRE[kind] for kind in form.types), *values)
            except struct.error:  # a number that its type cannot hold
                return None
    return None


class EventService:
    """Events of one vehicle."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle = vehicle
        self._listeners: list[Connection] = []
        self._kept: deque[_Kept] = deque(maxlen=KEPT)
        self._sequence = 0
        self._due_ms = 0

    @property
    def at_work(self) -> bool:
        """Whether a station listens."""
        return bool(self._listeners)

    def listen(self, connection: Connection) -> None:
        """From now on events are sent there."""
        if connection not in self._listeners:
            self._listeners.append(connection)
            self._due_ms = self._vehicle.time_ms

    def reaches(self, connection: Connection) -> bool:
        """Whether events are sent there."""
        return connection in self._listeners

    def take(self, severity: Severity, text: str) -> Any | None:
        """Number what is announced; the EVENT, or None where it is none."""
        found = event_of(text)
        if found is None:
            return None
        self._sequence = self._sequence + 1 & 0xFFFF
        content = message("EVENT")(
            id=found[0],
            event_time_boot_ms=self._vehicle.time_ms,
            sequence=self._sequence,
            log_levels=LEVELS[severity] << 4 | LEVELS[severity],
            arguments=tuple(found[1].ljust(40, b"\0")),
        )
        self._kept.append(_Kept(self._sequence, content))
        return content

    def request(self, first: int, last: int, sender: tuple[int, int], connection: Connection) -> None:
        """Send events again, of a range no more than are kept."""
        self.listen(connection)
        kept = dict(self._kept)
        oldest = self._kept[0].sequence if self._kept else self._sequence
        for k in range(min((last - first & 0xFFFF) + 1, KEPT)):
            sequence = first + k & 0xFFFF
            error = message("RESPONSE_EVENT_ERROR")(
                target_system=sender[0],
                target_component=sender[1],
                sequence=sequence,
                sequence_oldest_available=oldest,
                reason=mav.MAV_EVENT_ERROR_REASON_UNAVAILABLE,
            )
            connection.put(kept.get(sequence, error))

    def current(self) -> Any:
        """CURRENT_EVENT_SEQUENCE."""
        flags = 0 if self._kept else mav.MAV_EVENT_CURRENT_SEQUENCE_FLAGS_RESET
        return message("CURRENT_EVENT_SEQUENCE")(sequence=self._sequence, flags=flags)

    def report(self) -> None:
        """Queue the number of the last event where it is due."""
        if self._listeners and self._vehicle.time_ms >= self._due_ms:
            self._due_ms = self._vehicle.time_ms + SEQUENCE_EVERY_MS
            for connection in self._listeners:
                connection.put(self.current())


def _name(words: str) -> str:
    return re.sub(r"\W+", "_", words).strip("_").lower()


def _sub_id(words: str) -> int:
    """The lower 24 bits of an event's id: of its name, as an autopilot's are, so that a new event moves no other."""
    return zlib.crc32(_name(words).encode()) & 0xFFFFFF


@cache
def _forms() -> tuple[_Form, ...]:
    component = mav.MAV_COMP_ID_AUTOPILOT1 << 24
    return tuple(_Form(component | _sub_id(words), _pattern(words, types), types) for words, types in FORMS.items())


def _pattern(words: str, types: tuple[str, ...]) -> re.Pattern[str]:
    """Pattern of these words with any arguments."""
    literal = [re.escape(part) for part in re.split(r"\{[^}]*\}", words)]
    places = ["|".join(map(re.escape, ENUMS[kind])) if kind in ENUMS else _NUMBERS[kind == "float"] for kind in types]
    ends = [*(f"({place})" for place in places), ""]
    return re.compile("".join(part + end for part, end in zip(literal, ends, strict=True)))


def _number(kind: str, words: str) -> float:
    if kind in ENUMS:
        return ENUMS[kind].index(words)
    return float(words) if kind == "float" else int(words)
