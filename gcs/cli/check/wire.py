"""A check over a real link: the dialogue driven by a UDP socket and the wall clock."""

from __future__ import annotations

import contextlib
import select
import time
from collections.abc import Callable, Sequence
from pathlib import Path

from gcs.cli.check.dialogue import FIND_WITHIN_S, CheckFinding, Dialogue
from gcs.link.keys import SignatureGate
from gcs.link.socket import MOST_AT_ONCE, RECEIVE_BYTES, Where, open_udp
from gcs.mavlink import codec
from gcs.mavlink.ids import STATION
from gcs.mavlink.sequence import SequenceCounter
from gcs.scenario.endpoint import Endpoint

POLL_S = 0.02


class CheckError(Exception):
    """Why there is nothing to check; one sentence for a person."""


class Wire:
    """One connection, udpin or udpout; a listener answers whoever spoke last. Raises AddressRefused, KeyRefused."""

    def __init__(self, at: Endpoint, key_file: Path | None = None) -> None:
        self.gate = SignatureGate(key_file)
        self._socket, where = open_udp(at)
        self._to = None if at.way == "udpin" else where
        self._counter = SequenceCounter()
        self._peers: dict[int, Where] = {}

    @property
    def port(self) -> int:
        """The port that it listens at."""
        return int(self._socket.getsockname()[1])

    def receive(self, wait_s: float) -> list[codec.Frame]:
        """The frames that have come, waiting at most so long for the first."""
        select.select([self._socket], [], [], wait_s)
        frames: list[codec.Frame] = []
        with contextlib.suppress(OSError):
            for _ in range(MOST_AT_ONCE):
                datagram, address = self._socket.recvfrom(RECEIVE_BYTES)
                for frame in self.gate.accepted(codec.split(datagram).frames):
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
                self._socket.sendto(self.gate.signed(codec.frame(message, self._counter.next(), *STATION)), to)

    def close(self) -> None:
        """Close the socket."""
        self._socket.close()
        self.gate.close()


def check(
    dialogue: Dialogue,
    wire: Wire,
    on_finding: Callable[[CheckFinding], object],
    *,
    find_within_s: float = FIND_WITHIN_S,
) -> None:
    """Have the whole dialogue; `on_finding` is called with each finding. Raises CheckError where no vehicle is
    there."""
    begun_s = time.monotonic()
    count = 0
    while not dialogue.done:
        now_s = time.monotonic() - begun_s
        for frame in wire.receive(POLL_S):
            dialogue.receive(frame, time.monotonic() - begun_s)
        vehicle = dialogue.vehicle
        if vehicle is None and now_s > find_within_s:
            reasons = ", ".join(sorted(set(wire.gate.reasons.values())))
            refused = f", only messages that are {reasons}" if reasons else ""
            raise CheckError(f"no vehicle's HEARTBEAT came within {find_within_s:g} s{refused}")
        wire.send(dialogue.poll(time.monotonic() - begun_s), None if vehicle is None else vehicle.sysid)
        for finding in dialogue.findings[count:]:
            on_finding(finding)
        count = len(dialogue.findings)
