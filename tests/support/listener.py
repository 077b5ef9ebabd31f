"""The port of a ground station that is gone, with pymavlink: what vehicles say there, and what they answer."""

from __future__ import annotations

import select
import socket
import time
from collections.abc import Callable, Iterable
from typing import Any, Self

from patience import PATIENCE_S
from pymavlink.dialects.v20 import ardupilotmega as mav


class Listener:
    """Every vehicle that speaks to a port of this machine."""

    def __init__(self, port: int) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", port))
        self._mav = mav.MAVLink(None, 255, 190)
        self._mav.robust_parsing = True
        self.at: dict[int, Any] = {}
        """address of each vehicle, by system id"""
        self.armed: dict[int, bool] = {}
        """as its last HEARTBEAT said, by system id"""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.socket.close()

    def hear(self, holds: Callable[[Any], bool], within_s: float = PATIENCE_S) -> Any:
        """The first message for which `holds` holds."""
        deadline_s = time.monotonic() + within_s
        while (left_s := deadline_s - time.monotonic()) > 0.0:
            if not select.select([self.socket], [], [], left_s)[0]:
                break
            data, address = self.socket.recvfrom(65536)
            for message in self._mav.parse_buffer(data) or []:
                sysid = message.get_srcSystem()
                self.at[sysid] = address
                if message.get_type() == "HEARTBEAT":
                    self.armed[sysid] = bool(message.base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED)
                if holds(message):
                    return message
        raise AssertionError("what was awaited was not heard")

    def until_disarmed(self, sysids: Iterable[int], within_s: float) -> None:
        """Wait until the HEARTBEAT of each of these has said that it is disarmed."""
        wanted = set(sysids)
        self.hear(lambda _: all(self.armed.get(sysid) is False for sysid in wanted), within_s)

    def parameter(self, sysid: int, name: str) -> float:
        """Number of a parameter, asked for again each second."""
        self.hear(lambda message: message.get_srcSystem() == sysid)
        for _ in range(int(PATIENCE_S)):
            request = mav.MAVLink_param_request_read_message(sysid, 1, name.encode(), -1)
            self.socket.sendto(request.pack(self._mav), self.at[sysid])
            try:
                answer = self.hear(
                    lambda m: m.get_type() == "PARAM_VALUE" and (m.get_srcSystem(), m.param_id) == (sysid, name), 1.0
                )
            except AssertionError:
                continue
            return float(answer.param_value)
        raise AssertionError(f"{sysid} does not say its {name}")
