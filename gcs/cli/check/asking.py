"""Builders of check requests: COMMAND_LONG, COMMAND_INT, REQUEST_MESSAGE, passive checks; names of the peers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from gcs.cli.check.dialogue import CheckedVehicle, Question
from gcs.cli.check.predicates import acknowledged
from gcs.mavlink import codec
from gcs.mavlink.codec import Message, layout, message
from gcs.mavlink.command_protocol import CommandLong, CommandTarget
from skytender import mavlink as mav

MAVSDK, QGC, MAVPROXY = "MAVSDK", "QGroundControl", "MAVProxy"
PEERS = (MAVSDK, QGC, MAVPROXY)
OUTSIDE = {
    "PROTOCOL_VERSION": 300,
    "COMPONENT_INFORMATION": 395,
}
"""Messages that are asked for but stand in no dialect of pymavlink: known by their id, not read."""


Ask = Callable[[CheckedVehicle], Sequence[Message]]


def command_long(command: int, *params: float, to_component: int | None = None, offset: int = 0) -> Ask:
    """COMMAND_LONG to the vehicle; with `offset` to the vehicle of another system id."""

    def ask(vehicle: CheckedVehicle) -> Sequence[Message]:
        sysid = (vehicle.sysid - 1 + offset) % 250 + 1 if offset else vehicle.sysid
        target = CommandTarget(sysid, vehicle.compid if to_component is None else to_component)
        return [CommandLong(target, command, params).message(0)]

    return ask


def command_int(command: int, param1: float) -> Ask:
    """COMMAND_INT to the vehicle, without a place."""
    rest = dict.fromkeys(("param2", "param3", "param4", "x", "y", "z", "current", "autocontinue"), 0)
    return to_vehicle("COMMAND_INT", command=command, frame=mav.MAV_FRAME_GLOBAL, param1=param1, **rest)


def to_vehicle(name: str, **values: Any) -> Ask:
    """A message with the vehicle as its target."""
    return lambda v: [message(name, target_system=v.sysid, target_component=v.compid, **values)]


def commanded(key: str, what: str, misses: dict[str, str], command: int, ask: Ask, **awaited: Any) -> Question:
    """A command that is to be acknowledged; `awaited` is more of that, as `predicates.acknowledged` takes it."""
    judge, at_end = acknowledged(command, **awaited)
    return Question(key, what, misses, judge, ask, at_end)


def requested(name: str, what: str, misses: dict[str, str], **awaited: Any) -> Question:
    """MAV_CMD_REQUEST_MESSAGE for a message."""
    msgid, command = OUTSIDE.get(name) or layout(name).msgid, mav.MAV_CMD_REQUEST_MESSAGE
    key, what = name.lower().replace("_", "-"), f"{what} (REQUEST_MESSAGE {msgid})"
    return commanded(key, what, misses, command, command_long(command, msgid), then=codec.name(msgid), **awaited)


def judged(key: str, what: str, misses: dict[str, str], at_end: Any, **more: Any) -> Question:
    """A question that only looks at what has come already."""
    return Question(key, what, misses, lambda *_: None, at_end=at_end, repeat_s=0.0, tries=1, **more)
