"""Stream requests: SET_MESSAGE_INTERVAL, REQUEST_DATA_STREAM as the fallback, and checks of the rates.

1. Each needed message is asked for by MAV_CMD_SET_MESSAGE_INTERVAL.
2. What is refused, not acknowledged, or does not come in spite of it, is asked for by REQUEST_DATA_STREAM, at first the
   group that holds it, then all groups, after which each group is given its own rate again. That has no
   acknowledgement.
3. Every CHECK_S what has come is counted: a message that does not come, or at less than half of its rate, is named
   once, and again when it comes. One that begins to come in the midst of a count is counted from there.
4. A vehicle that sends none of it, though its HEARTBEAT comes, has forgotten the request and is asked again: it may
   have booted.
5. Where the local frame lies is asked for by MAV_CMD_REQUEST_MESSAGE until it is known, and now and then after: it may
   move. A vehicle that does not know that command may know MAV_CMD_GET_HOME_POSITION.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.command_protocol import CommandLong, CommandTarget
from gcs.mavlink.ids import AUTOPILOT
from skytender import mavlink as mav

STALE_S = 5.0
"""Time after which it counts as silent, and between two requests."""
RATE_HZ = 4
_TELEMETRY = frozenset(map(codec.msgid, ("GLOBAL_POSITION_INT", "LOCAL_POSITION_NED", "ATTITUDE", "SYS_STATUS")))

CHECK_S = 5.0
SLOW_SHARE = 0.5
OLD_WAY_EVERY_S = 1.0
OLD_WAY_TRIES = 4
ORIGIN_EVERY_S, ORIGIN_AGAIN_S = 2.0, 10.0
_TOKEN = "stream "
_ORIGIN = "origin "
_ORIGIN_MESSAGES = ("GPS_GLOBAL_ORIGIN", "HOME_POSITION")


class Need(NamedTuple):
    """One message, its least useful rate, and REQUEST_DATA_STREAM's group that holds it in ArduPilot."""

    name: str
    rate_hz: float
    group: int


class Ask(NamedTuple):
    """A command to send; its result is to come back with the token."""

    command: CommandLong
    token: str


def needs(period_s: float) -> tuple[Need, ...]:
    """Messages that the supervisor reads of a vehicle, with a tick every `period_s`."""
    return (
        Need("LOCAL_POSITION_NED", min(1.0 / period_s, 10.0), mav.MAV_DATA_STREAM_POSITION),
        Need("ATTITUDE", 4.0, mav.MAV_DATA_STREAM_EXTRA1),
        Need("EXTENDED_SYS_STATE", 2.0, mav.MAV_DATA_STREAM_EXTENDED_STATUS),
        Need("BATTERY_STATUS", 1.0, mav.MAV_DATA_STREAM_EXTRA3),
        Need("SYS_STATUS", 1.0, mav.MAV_DATA_STREAM_EXTENDED_STATUS),
    )


class StreamRequests:
    """The streams of one vehicle; times are the session's."""

    def __init__(self, sysid: int, wanted: Sequence[Need]) -> None:
        self._sysid = sysid
        self._needs = {codec.msgid(need.name): need for need in wanted}
        self._reported: dict[str, str] = {}
        self.restart()

    def restart(self) -> None:
        """The vehicle has forgotten what it was asked: it has booted, or was away."""
        self._asked = False
        self._old_way: dict[int, int] = {}
        self._old_way_s = -OLD_WAY_EVERY_S
        self._count = dict.fromkeys(self._needs, 0)
        self._counted_since_s: float | None = None
        self._began_s: dict[int, float] = {}
        """since when each message comes"""
        self._origin_asked_s = -ORIGIN_AGAIN_S

    @property
    def missing(self) -> tuple[str, ...]:
        """Messages that do not come, or too seldom, as of the last check."""
        return tuple(sorted(self._reported))

    def received(self, msgid: int, now_s: float) -> None:
        """Count a message that has come."""
        if msgid in self._count:
            self._began_s.setdefault(msgid, now_s)
            self._count[msgid] += 1

    @staticmethod
    def owns(token: str) -> bool:
        """Whether a command's result is for `answered`."""
        return token.startswith((_TOKEN, _ORIGIN))

    def answered(self, token: str, accepted: bool) -> list[Ask]:
        """Take in a command's result; requests to try instead."""
        if accepted:
            return []
        if token.startswith(_TOKEN):
            self._old_way.setdefault(codec.msgid(token.removeprefix(_TOKEN)), 0)
        elif token == _ORIGIN + "HOME_POSITION":
            return [Ask(self._command(mav.MAV_CMD_GET_HOME_POSITION), _ORIGIN + "home")]
        return []

    def poll(self, now_s: float, *, origin_known: bool) -> tuple[list[Ask], list[Message]]:
        """Commands and messages to send now."""
        asks: list[Ask] = []
        if not self._asked:
            self._asked = True
            if self._counted_since_s is None:
                self._counted_since_s = now_s
            for msgid, need in self._needs.items():
                command = self._command(mav.MAV_CMD_SET_MESSAGE_INTERVAL, float(msgid), 1e6 / need.rate_hz)
                asks.append(Ask(command, _TOKEN + need.name))
        if now_s - self._origin_asked_s >= (ORIGIN_AGAIN_S if origin_known else ORIGIN_EVERY_S):
            self._origin_asked_s = now_s
            for name in _ORIGIN_MESSAGES:
                asks.append(Ask(self._command(mav.MAV_CMD_REQUEST_MESSAGE, float(codec.msgid(name))), _ORIGIN + name))
        messages: list[Message] = []
        if self._old_way and now_s - self._old_way_s >= OLD_WAY_EVERY_S:
            self._old_way_s = now_s
            messages = self._ask_the_old_way()
        return asks, messages

    def check(self, now_s: float) -> dict[str, bool]:
        """Sentences on what does not come, and what comes again, with whether all is well with it; nothing between two
        checks."""
        since_s = self._counted_since_s
        if since_s is None or now_s - since_s < CHECK_S:
            return {}
        found: dict[str, str] = {}
        for msgid, need in self._needs.items():
            comes_for_s = now_s - max(since_s, self._began_s.get(msgid, since_s))
            if self._count[msgid] == 0:
                found[need.name] = f"{need.name} does not come"
                self._began_s.pop(msgid, None)
                self._old_way.setdefault(msgid, 0)
            elif self._count[msgid] < SLOW_SHARE * need.rate_hz * comes_for_s:
                found[need.name] = f"{need.name} comes at less than half of the {need.rate_hz:g} Hz asked for"
        if not any(self._count.values()):
            self._asked = False
        notices = {sentence: False for name, sentence in found.items() if self._reported.get(name) != sentence}
        notices |= {f"{name} comes as it should now": True for name in self._reported if name not in found}
        self._reported = found
        self._count = dict.fromkeys(self._needs, 0)
        self._counted_since_s = now_s
        return notices

    def count_anew(self, now_s: float) -> None:
        """The vehicle says nothing at all: no message of it is missing more than another."""
        if self._counted_since_s is not None:
            self._counted_since_s = now_s
            self._count = dict.fromkeys(self._needs, 0)

    def _ask_the_old_way(self) -> list[Message]:
        """REQUEST_DATA_STREAM for the groups of what is missing; on later tries for all, and then each at its rate."""
        rates: dict[int, float] = {}
        for msgid, tries in list(self._old_way.items()):
            need = self._needs[msgid]
            if tries >= OLD_WAY_TRIES or (tries and self._count[msgid]):
                continue
            self._old_way[msgid] = tries + 1
            group = need.group if tries < OLD_WAY_TRIES // 2 else mav.MAV_DATA_STREAM_ALL
            rates[group] = max(rates.get(group, 0.0), need.rate_hz)
        if mav.MAV_DATA_STREAM_ALL in rates:
            for need in self._needs.values():
                rates[need.group] = max(rates.get(need.group, 0.0), need.rate_hz)
        return [
            _data_stream(self._sysid, AUTOPILOT, group, max(round(rate_hz), 1))
            for group, rate_hz in sorted(rates.items())
        ]

    def _command(self, command: int, *params: float) -> CommandLong:
        return CommandLong(CommandTarget(self._sysid, AUTOPILOT), command, params)


class SilentVehicles:
    """Vehicles that send only HEARTBEAT."""

    def __init__(self) -> None:
        self._due_s: dict[int, float] = {}

    def received(self, sysid: int, msgid: int, now_s: float) -> None:
        """Take note of a message of a vehicle."""
        if msgid in _TELEMETRY or sysid not in self._due_s:
            self._due_s[sysid] = now_s + STALE_S

    def due(self, now_s: float) -> list[int]:
        """Silent vehicles to be asked now, by system id: at first, and again every STALE_S."""
        found = sorted(sysid for sysid, due_s in self._due_s.items() if now_s >= due_s)
        self._due_s.update(dict.fromkeys(found, now_s + STALE_S))
        return found


def everything(sysid: int, compid: int) -> Message:
    """REQUEST_DATA_STREAM for all that it has."""
    return _data_stream(sysid, compid, mav.MAV_DATA_STREAM_ALL, RATE_HZ)


def _data_stream(sysid: int, compid: int, group: int, rate_hz: int) -> Message:
    return codec.message(
        "REQUEST_DATA_STREAM",
        target_system=sysid,
        target_component=compid,
        req_stream_id=group,
        req_message_rate=rate_hz,
        start_stop=1,
    )
