"""A check over a real link: the dialogue driven by a connection and the wall clock."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from pathlib import Path

from gcs.cli.check.dialogue import FIND_WITHIN_S, CheckFinding, Dialogue
from gcs.link.listener import Listener
from gcs.link.socket import Where
from gcs.mavlink import codec
from gcs.mavlink.ids import STATION
from gcs.mavlink.sequence import sequence_numbers
from gcs.scenario.endpoint import Endpoint

POLL_S = 0.02
STALL_S = 0.5
"""A pass of the loop that took longer was kept from running."""


class CheckError(Exception):
    """Why there is nothing to check, a sentence for a person; and what can be seen of the reason, if anything."""

    def __init__(self, text: str, why: str = "") -> None:
        super().__init__(text)
        self.why = why


class ClockWithoutStalls:
    """Time in which this program has run, s.

    Of a pass that the machine has kept from running only STALL_S count: what came meanwhile came unseen, and a vehicle
    on the same machine may have been kept from sending. Neither says anything of the vehicle.
    """

    def __init__(self, now_s: float) -> None:
        self.time_s = 0.0
        self._last_s = now_s

    def advance(self, now_s: float) -> float:
        """The time at `now_s` of the clock that goes on through stalls."""
        self.time_s += min(now_s - self._last_s, STALL_S)
        self._last_s = now_s
        return self.time_s


class Wire:
    """One connection; a listener answers the last sender. Raises AddressRefused, KeyRefused."""

    def __init__(self, at: Endpoint, key_file: Path | None = None, station: tuple[int, int] = STATION) -> None:
        """`station`: our system and component id."""
        self._station = station
        self.listener = Listener(at, key_file)
        self._numbers = sequence_numbers()
        self._peers: dict[int, Where] = {}

    def receive(self, wait_s: float) -> list[tuple[codec.Frame, str]]:
        """The frames that have come, with their addresses, waiting at most so long for the first."""
        self.listener.wait(wait_s)
        received: list[tuple[codec.Frame, str]] = []
        for frames, sender in self.listener.receive():
            self._peers.update((frame.sysid, sender) for frame in frames)
            received += [(frame, f"{sender[0]}:{sender[1]}") for frame in frames]
        return received

    def send(self, messages: Sequence[codec.Message], sysid: int | None, *, unsigned: bool = False) -> None:
        """Send each message by itself, to the vehicle or to the address that was given."""
        to = self.listener.connection.to or (self._peers.get(sysid) if sysid is not None else None)
        # Some that speak MAVLink 1 change when they hear MAVLink 2.
        for address in [to] if to is not None else sorted(self.listener.older_senders, key=str):
            for message in messages:
                raw = codec.frame(message, next(self._numbers), *self._station)
                self.listener.send(raw, address, unsigned=unsigned)

    def close(self) -> None:
        """Close the connection."""
        self.listener.close()


def check(
    dialogue: Dialogue,
    wire: Wire,
    on_finding: Callable[[CheckFinding], object],
    *,
    find_within_s: float = FIND_WITHIN_S,
) -> None:
    """Have the whole dialogue; `on_finding` is called with each finding. Raises CheckError where no vehicle is
    there."""
    clock = ClockWithoutStalls(time.monotonic())
    count = 0
    while not dialogue.done:
        frames = wire.receive(POLL_S)
        now_s = clock.advance(time.monotonic())
        for frame, at in frames:
            dialogue.receive(frame, now_s, at)
        vehicle = dialogue.vehicle
        if vehicle is None and now_s > find_within_s:
            reasons = ", ".join(sorted(set(wire.listener.gate.reasons.values())))
            refused = f", only messages that are {reasons}" if reasons else ""
            why = f": {silence}" if (silence := wire.listener.silence) else ""
            raise CheckError(f"no vehicle's HEARTBEAT came within {find_within_s:g} s{refused}", why)
        messages = dialogue.poll(now_s)
        question = dialogue.current
        unsigned = question is not None and question.unsigned
        wire.send(messages, None if vehicle is None else vehicle.sysid, unsigned=unsigned)
        for finding in dialogue.findings[count:]:
            on_finding(finding)
        count = len(dialogue.findings)
