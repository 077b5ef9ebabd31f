"""The program in Python that steps a session, as its supervisor sees it (docs/protocol/socket.md#programs-that-act).

A channel of its own, which the supervisor inherits: newline-delimited JSON. The program asks for the next snapshot, and
says with that what is to be flown meanwhile; between two of them it commands and injects, and each is answered, in
order. In lockstep the session waits for it.
"""

from __future__ import annotations

import contextlib
import select
import socket
from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import msgspec

from gcs.scenario.faults import in_flight
from gcs.session.message_types import Reply
from gcs.session.program.fleet_message import fleet_message
from gcs.session.program.messages import CHANGE, FINISH, INJECT, NEXT, SEND, STOP, FleetMessage
from gcs.supervisor.operator import COMMANDS, OperatorReply
from gcs.supervisor.script import as_points
from gcs.supervisor.supervisor import Supervisor
from gcs.telemetry.events import Event

BUFFER_BYTES = 1 << 20
READ_BYTES = 1 << 16


class Program:
    """The channel on an inherited file descriptor, and what is asked on it."""

    def __init__(self, descriptor: int, every_ms: int, *, lockstep: bool) -> None:
        self._socket = socket.socket(fileno=descriptor)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, BUFFER_BYTES)
        self._unread = b""
        self._events: list[Event] = []
        self._every_ms = every_ms
        self._lockstep = lockstep
        self._open = True
        self._requests: deque[dict[str, Any]] = deque()
        """that have to wait until the snapshot is given that was asked for before them"""
        self._asked: int | None = None
        """`id` of the request for a snapshot that is to come"""
        self.stops = False
        """whether it wants the session to end, or has ended itself"""

    @property
    def awaited(self) -> bool:
        """Whether the session must not go on before it has said something."""
        return self._lockstep and self._open and self._asked is None and not self.stops

    def wants(self, time_s: float) -> bool:
        """Whether it has asked for the snapshot of this session time."""
        return self._asked is not None and round(1e3 * time_s) % self._every_ms == 0

    def serve(self, supervisor: Supervisor, blocks: Iterable[Sequence[int]], timeout_s: float) -> bool:
        """Do what it asks for, waiting for that up to a time; whether it has said anything.

        `blocks`: system ids of the vehicles in each process.
        """
        said = self._read(supervisor, 0.0 if self._requests else timeout_s)
        while self._requests and self._asked is None:
            request = self._requests.popleft()
            if request.get("command") == NEXT:
                self._asked = request["id"]
                points = request.get("set_points") or {}
                given_ms = -(-supervisor.time_ms // self._every_ms) * self._every_ms  # time of the snapshot
                given = as_points((int(sysid), values) for sysid, values in points.items())
                supervisor.script.steer(given, given_ms / 1e3)
            else:
                answer = _obey(request, supervisor, blocks)
                self._send(Reply(request["id"], answer.taken, answer.text))
        return said

    def _read(self, supervisor: Supervisor, timeout_s: float) -> bool:
        """Take in what it says within a time; whether that is anything. Its end, FINISH and STOP wait for nothing."""
        if not self._open or not select.select([self._socket], [], [], timeout_s)[0]:
            return False
        try:
            said = self._socket.recv(READ_BYTES)
        except OSError:
            said = b""
        if not said:
            self.stops = True
            self._leave(supervisor)
        *lines, self._unread = (self._unread + said).split(b"\n")
        for request in map(msgspec.json.decode, lines):
            if request.get("command") == STOP:
                self.stops = True
            elif request.get("command") == FINISH:
                self._leave(supervisor)
            else:
                self._requests.append(request)
        return True

    def _leave(self, supervisor: Supervisor) -> None:
        self._open = False
        self._requests.clear()
        supervisor.script.steer({})

    def remember(self, events: Iterable[Event]) -> None:
        """Keep these for the next snapshot."""
        self._events += events

    def give(self, supervisor: Supervisor) -> None:
        """Answer with the present snapshot, and the events since the last one."""
        events, self._events = self._events, []
        message = fleet_message(supervisor, events)
        message.id, self._asked = self._asked, None
        self._send(message)

    def _send(self, message: FleetMessage | Reply) -> None:
        with contextlib.suppress(OSError):
            self._socket.sendall(msgspec.json.encode(message) + b"\n")


def _obey(request: Mapping[str, Any], supervisor: Supervisor, blocks: Iterable[Sequence[int]]) -> OperatorReply:
    """Carry out a command, inject a fault or change the world, or say why not."""
    command = request.get("command")
    if command in COMMANDS:
        answer = supervisor.obey(request)
        if answer.taken:
            supervisor.script.ordered(request["number"], request["sysid"], command)
        return answer
    if command == SEND:
        return supervisor.command(request["number"], request["sysid"], request["mav_cmd"], request["params"])
    if command == INJECT:
        return _inject(request["fault"], supervisor, blocks)
    if command == CHANGE:
        return supervisor.change(request["change"])
    return OperatorReply(False, f"There is no request {command!r} of a program.")


def _inject(content: Any, supervisor: Supervisor, blocks: Iterable[Sequence[int]]) -> OperatorReply:
    scenario = supervisor.scenario
    try:
        fault = in_flight(content, scenario.vehicles.all, supervisor.time_s, scenario.goal.duration_s)
    except ValueError as error:
        return OperatorReply(False, f"The fault is refused: {error}.")
    if fault.fault in ("kill", "hang"):
        together = next((block for block in blocks if fault.sysid in block), (fault.sysid,))
        if len(together) > 1:
            text = f"vehicle {fault.sysid} shares its process with others: {fault.fault} needs vehicles_per_process: 1"
            return OperatorReply(False, f"The fault is refused: {text}.")
    return supervisor.inject(fault)
