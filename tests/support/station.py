"""A ground station of pymavlink's alone, for strangers' vehicles: every datagram is kept, nothing is assumed."""

from __future__ import annotations

import math
import select
import socket
import time
from collections.abc import Callable
from typing import Any, Self

from patience import PATIENCE_S
from pymavlink.dialects.v20 import common as mav

ACCEPTED = mav.MAV_RESULT_ACCEPTED
POSITION, VELOCITY = 3576, 3527


class Station:
    """One vehicle's ground station at a port of the system's choice; heartbeats and set points go out while it waits.

    `heard` is every message in the order in which they came, `datagrams` the bytes that they stood in.
    """

    def __init__(self, sysid: int = 1) -> None:
        self.sysid = sysid
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.port = int(self.socket.getsockname()[1])
        self.heard: list[Any] = []
        self.datagrams: list[bytes] = []
        self.set_point: Any = None
        self._mav = mav.MAVLink(None, 255, 190)
        self._mav.robust_parsing = True
        self._peer: tuple[str, int] | None = None
        self._read = 0
        self._beat_s = self._point_s = -math.inf

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.socket.close()

    def speaks_to(self, host: str, port: int) -> None:
        """From now on to a vehicle that waits to be spoken to."""
        self._peer = (host, port)

    def send(self, message: Any) -> None:
        """One message in a datagram of its own."""
        assert self._peer is not None, "nothing was heard of it yet"
        self.socket.sendto(message.pack(self._mav), self._peer)

    def aim(self, mask: int, numbers: tuple[float, float, float], frame: int = mav.MAV_FRAME_LOCAL_NED) -> None:
        """From now on send a set point that is a position or a velocity, by its mask, ten times a second."""
        p, v = (numbers, (0.0,) * 3) if mask == POSITION else ((0.0,) * 3, numbers)
        self.set_point = mav.MAVLink_set_position_target_local_ned_message(
            0, self.sysid, 1, frame, mask, *p, *v, 0, 0, 0, 0, 0
        )
        self._point_s = -math.inf

    def hear(self, kind: str, holds: Callable[[Any], bool] = lambda _: True, within_s: float = PATIENCE_S) -> Any:
        """The next message of a kind, among those not yet waited for, for which `holds` holds."""
        deadline_s, last = time.monotonic() + within_s, None
        while time.monotonic() < deadline_s:
            while self._read < len(self.heard):
                self._read += 1
                message = self.heard[self._read - 1]
                if message.get_type() == kind:
                    last = message
                    if holds(message):
                        return message
            self._listen(0.05)
        raise AssertionError(f"no {kind} like that in {within_s} s; last: {last}")

    def command(self, command: int, *params: float, until: int | None = ACCEPTED, within_s: float = PATIENCE_S) -> int:
        """A COMMAND_LONG's result; sent again each second until it is the one that is waited for (None: any)."""
        filled = (*params, *(0.0 for _ in range(7 - len(params))))
        deadline_s = time.monotonic() + within_s
        while True:
            self.send(mav.MAVLink_command_long_message(self.sysid, 1, command, 0, *filled))
            result = int(self.hear("COMMAND_ACK", lambda ack: ack.command == command).result)
            if until in (None, result):
                return result
            assert time.monotonic() < deadline_s, f"command {command}: {result}"
            self._listen_for(1.0)

    def all_of(self, kind: str) -> list[Any]:
        """Every message of a kind so far."""
        return [message for message in self.heard if message.get_type() == kind]

    def _listen_for(self, duration_s: float) -> None:
        end_s = time.monotonic() + duration_s
        while time.monotonic() < end_s:
            self._listen(0.05)

    def _listen(self, timeout_s: float) -> None:
        self._speak()
        while select.select([self.socket], [], [], timeout_s)[0]:
            datagram, self._peer = self.socket.recvfrom(65536)
            self.datagrams.append(datagram)
            new = self._mav.parse_buffer(datagram) or []
            self.heard += [message for message in new if message.get_srcSystem() == self.sysid]
            timeout_s = 0.0

    def _speak(self) -> None:
        now_s = time.monotonic()
        if self._peer is not None and now_s - self._beat_s > 0.5:
            self._beat_s = now_s
            self.send(mav.MAVLink_heartbeat_message(mav.MAV_TYPE_GCS, mav.MAV_AUTOPILOT_INVALID, 0, 0, 0, 3))
        if self.set_point is not None and now_s - self._point_s > 0.1:
            self._point_s = now_s
            self.send(self.set_point)
