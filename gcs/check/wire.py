"""A check over a real link: the dialogue driven by a UDP socket and the wall clock."""

from __future__ import annotations

import contextlib
import select
import socket
import time
from collections.abc import Callable, Sequence
from typing import Any

from gcs.addresses import address
from gcs.check.dialogue import FIND_WITHIN_S, Dialogue, Finding
from gcs.mavlink import codec
from gcs.mavlink.identities import STATION
from gcs.mavlink.sequence import SequenceCounter

POLL_S = 0.02
BUFFER_BYTES = 1 << 20


class CheckError(Exception):
    """Why there is nothing to check; one sentence for a person."""


class Wire:
    """One connection, `udpin:HOST:PORT` or `udpout:HOST:PORT`; a listener answers whoever spoke last."""

    def __init__(self, connect: str) -> None:
        at = address(connect, "udpin", "udpout")
        if at is None:
            raise CheckError(f"--connect {connect} is no address; write udpin:HOST:PORT or udpout:HOST:PORT")
        try:
            family, _, _, _, where = socket.getaddrinfo(at.host, at.port, type=socket.SOCK_DGRAM)[0]
            self._socket = socket.socket(family, socket.SOCK_DGRAM)
        except OSError as error:
            raise CheckError(f"--connect {connect}: {error.strerror}; give another address") from None
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER_BYTES)
        self._socket.setblocking(False)
        self._counter = SequenceCounter()
        self._peers: dict[int, Any] = {}
        try:
            self._to: Any = None if at.way == "udpin" else where
            if self._to is None:
                self._socket.bind(where)
        except OSError as error:
            self._socket.close()
            raise CheckError(f"--connect {connect}: {error.strerror}; give another address") from None

    @property
    def port(self) -> int:
        """The port that it listens at."""
        return int(self._socket.getsockname()[1])

    def receive(self, wait_s: float) -> list[codec.Frame]:
        """The frames that have come, waiting at most so long for the first."""
        select.select([self._socket], [], [], wait_s)
        frames: list[codec.Frame] = []
        with contextlib.suppress(OSError):
            while True:
                datagram, address = self._socket.recvfrom(65535)
                for frame in codec.split(datagram).frames:
                    self._peers[frame.sysid] = address
                    frames.append(frame)
        return frames

    def send(self, messages: Sequence[codec.Message], sysid: int | None) -> None:
        """Send each message in a datagram of its own, to the vehicle or to the address that was given."""
        to = self._to or (self._peers.get(sysid) if sysid is not None else None)
        if to is None:
            return
        for message in messages:
            with contextlib.suppress(OSError):
                self._socket.sendto(codec.frame(message, self._counter.take(), *STATION), to)

    def close(self) -> None:
        """Close the socket."""
        self._socket.close()


def check(
    dialogue: Dialogue,
    wire: Wire,
    told: Callable[[Finding], object],
    *,
    find_within_s: float = FIND_WITHIN_S,
) -> None:
    """Have the whole dialogue; `told` hears of each finding as it is made. Raises CheckError where nobody is there."""
    begun_s = time.monotonic()
    count = 0
    while not dialogue.done:
        now_s = time.monotonic() - begun_s
        for frame in wire.receive(POLL_S):
            dialogue.take(frame, time.monotonic() - begun_s)
        vehicle = dialogue.vehicle
        if vehicle is None and now_s > find_within_s:
            raise CheckError(f"no vehicle's HEARTBEAT came within {find_within_s:g} s")
        wire.send(dialogue.poll(time.monotonic() - begun_s), None if vehicle is None else vehicle.sysid)
        for finding in dialogue.findings[count:]:
            told(finding)
        count = len(dialogue.findings)
