"""Operator control over external vehicles that speak it (MAV_CMD_REQUEST_OPERATOR_CONTROL, CONTROL_STATUS).

1. A vehicle that reports its owner is asked for control, again every ASK_EVERY_S while it is not ours. One that reports
   none is asked nothing.
2. The request of another station is answered as heard, and said: the operator lets that have the vehicle by `release`.
   With `station: {takeover: allow}` the vehicle gives control by itself.
3. A vehicle that another station has taken is left to it, as after `release`, until `rejoin`; at the session's end
   control is given back.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.command_protocol import CommandRequest
from gcs.scenario.station import Station
from gcs.telemetry.events import Event, Level
from skytender import mavlink as mav

ASK_EVERY_S = 10.0
SAY_AGAIN_S = 10.0
TOKEN = "control"
_COMMAND = int(mav.MAV_CMD_REQUEST_OPERATOR_CONTROL)
_STATUS, _COMMAND_LONG = codec.msgid("CONTROL_STATUS"), codec.msgid("COMMAND_LONG")


class _Ownership:
    """A vehicle's ownership, as it reports it."""

    def __init__(self) -> None:
        self.owner: int | None = None
        """0: no station; None: it reports none"""
        self.asked_s = -math.inf
        self.asker, self.said_s = 0, -math.inf
        """the last station that asked for it"""
        self.answers: list[Message] = []
        self.released = False
        """whether the operator has left it to another station"""


class OperatorControl:
    """The ownership of all external vehicles of a session."""

    def __init__(self, sysids: Iterable[int], station: Station) -> None:
        self._vehicles = {sysid: _Ownership() for sysid in sysids}
        self._ours, self._allow = station.sysid, station.takeover == "allow"
        self._taken: set[int] = set()

    def receive(self, sysid: int, frames: Sequence[Frame], now_s: float) -> list[Event]:
        """Take what a vehicle's autopilot sent; what people should know of it."""
        vehicle, events = self._vehicles[sysid], list[Event]()

        def say(level: Level, text: str) -> None:
            events.append(Event(now_s, sysid, level, text, "link"))

        for frame in frames:
            if frame.msgid == _STATUS:
                content, before = codec.fields(frame), vehicle.owner
                vehicle.owner = content.gcs_main
                if vehicle.owner == before:
                    continue
                if vehicle.owner == self._ours:
                    say("info", "This station has control of it")
                elif vehicle.owner:
                    say("warning", f"Ground station {vehicle.owner} has control of it")
                    if before == self._ours and not vehicle.released:
                        self._taken.add(sysid)
            elif frame.msgid == _COMMAND_LONG:
                content = codec.fields(frame)
                if content.command != _COMMAND or content.target_system != self._ours:
                    continue
                vehicle.answers.append(_acknowledgement(sysid, frame.compid))
                asker = round(content.param4) if math.isfinite(content.param4) else 0
                if asker != vehicle.asker or now_s - vehicle.said_s >= SAY_AGAIN_S:
                    vehicle.asker, vehicle.said_s = asker, now_s
                    say("warning", f"Ground station {asker} asks for control of it: `release` lets it have it")
        return events

    def decide(self, sysid: int, now_s: float, *, released: bool) -> tuple[list[CommandRequest], list[Message]]:
        """Commands and messages to a vehicle. `released`: the operator has left it to another station."""
        vehicle = self._vehicles[sysid]
        answers, vehicle.answers, vehicle.released = vehicle.answers, [], released
        wanted = vehicle.owner is not None and (vehicle.owner == self._ours) is released
        if not wanted or now_s - vehicle.asked_s < ASK_EVERY_S or sysid in self._taken:
            return [], answers
        vehicle.asked_s = now_s
        return [self._request(sysid, take=not released)], answers

    def pop_taken(self) -> set[int]:
        """Vehicles that another station has taken from this one since the last call."""
        taken, self._taken = self._taken, set()
        return taken

    def give_back(self) -> list[CommandRequest]:
        """Commands that release what is ours."""
        return [self._request(sysid, take=False) for sysid, one in self._vehicles.items() if one.owner == self._ours]

    def _request(self, sysid: int, *, take: bool) -> CommandRequest:
        params = (float(take), float(take and self._allow), ASK_EVERY_S, float(self._ours))
        return CommandRequest(sysid, _COMMAND, params, TOKEN)


def _acknowledgement(sysid: int, compid: int) -> Message:
    """COMMAND_ACK that the owner gives to the request of another station, whatever it decides."""
    return codec.message(
        "COMMAND_ACK",
        command=_COMMAND,
        result=mav.MAV_RESULT_ACCEPTED,
        progress=0,
        result_param2=0,
        target_system=sysid,
        target_component=compid,
    )
