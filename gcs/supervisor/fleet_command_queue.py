"""Queue of messages and commands per vehicle for its next grant; re-sending rules: gcs/mavlink/command_protocol.py."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any

from gcs.mavlink import command_protocol
from gcs.mavlink.codec import Message
from gcs.mavlink.ids import AUTOPILOT, STATION


class FleetCommandQueue:
    """For each vehicle what waits for its next grant, and which of its commands are under way; all in session time."""

    def __init__(self, sysids: Iterable[int], stations: Mapping[int, tuple[int, int]] | None = None) -> None:
        """`stations`: our ids, to which acknowledgements come, for vehicles that know us by others than STATION."""
        known = stations or {}
        self._queues = {sysid: command_protocol.CommandQueue(*known.get(sysid, STATION)) for sysid in sysids}
        self._waiting: defaultdict[int, list[Message]] = defaultdict(list)
        """by system id, of vehicles for which something waits"""
        self._under_way: set[tuple[int, str]] = set()
        self._commanded: set[int] = set()
        """vehicles with a command under way since `pending` was last called"""

    @property
    def resent(self) -> int:
        """Commands that were sent again."""
        return sum(queue.resent for queue in self._queues.values())

    def put(self, sysid: int, messages: Sequence[Message]) -> None:
        """Send these to the vehicle with its next grant."""
        if messages:
            self._waiting[sysid] += messages

    @property
    def waiting(self) -> Collection[int]:
        """System ids of the vehicles for which something waits."""
        return self._waiting.keys()

    def pop(self, sysid: int) -> list[Message]:
        """Remove and return the messages that wait for the vehicle."""
        return self._waiting.pop(sysid, [])

    def clear(self) -> None:
        """Forget what waits; commands that are under way are still sent again."""
        self._waiting.clear()

    def ask(self, requests: Iterable[command_protocol.CommandRequest], now_s: float) -> None:
        """Send each request in a COMMAND_LONG to the vehicle's autopilot."""
        for request in requests:
            self._under_way.add((request.sysid, request.token))
            self._commanded.add(request.sysid)
            command = command_protocol.CommandLong(
                command_protocol.CommandTarget(request.sysid, AUTOPILOT), request.command, request.params
            )
            self.put(request.sysid, self._queues[request.sysid].send(command, now_s, token=request.token))

    def ask_once(self, requests: Iterable[command_protocol.CommandRequest], now_s: float) -> None:
        """Command those that are not on their way already: lined up again they would be carried out long after."""
        self.ask([request for request in requests if (request.sysid, request.token) not in self._under_way], now_s)

    def awaits(self, token: str) -> bool:
        """Whether a command of this token has not ended yet, to whichever vehicle."""
        return any(other == token for _, other in self._under_way)

    def withdraw(self, sysid: int, by: tuple[str, ...] = (command_protocol.OPERATOR, command_protocol.ARMING)) -> None:
        """Drop what arming sequence or operator wanted before: it must not be repeated after what they want now."""
        for token in self._queues[sysid].withdraw(lambda token: str(token).startswith(by)):
            self._under_way.discard((sysid, token))

    def on_ack(self, sysid: int, ack: Any, now_s: float) -> list[command_protocol.CommandResult]:
        """Take in the fields of a vehicle's COMMAND_ACK; the commands that have ended by it."""
        return self._follow_up(sysid, self._queues[sysid].on_ack(sysid, AUTOPILOT, ack, now_s))

    @property
    def pending(self) -> list[int]:
        """System ids of the vehicles that have not acknowledged a command yet, in order."""
        if self._commanded:
            self._commanded = {sysid for sysid in self._commanded if self._queues[sysid].pending}
        return sorted(self._commanded)

    def poll(self, sysid: int, now_s: float) -> list[command_protocol.CommandResult]:
        """Send again what a vehicle has not acknowledged in time; the commands that have ended by silence."""
        return self._follow_up(sysid, self._queues[sysid].poll(now_s))

    def _follow_up(self, sysid: int, step: command_protocol.Step) -> list[command_protocol.CommandResult]:
        self.put(sysid, step.messages)
        for result in step.results:
            self._under_way.discard((sysid, str(result.token)))
        return step.results
