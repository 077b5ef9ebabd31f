"""A check over a real link: the dialogue driven by a connection and the wall clock."""

from __future__ import annotations

import select
import time
from collections.abc import Callable, Sequence
from pathlib import Path

from gcs.cli.check.dialogue import FIND_WITHIN_S, CheckFinding, Dialogue
from gcs.link.addresses import open_connection
from gcs.link.diagnosis import Diagnosis
from gcs.link.keys import SignatureGate
from gcs.link.socket import Where
from gcs.mavlink import codec
from gcs.mavlink.ids import STATION
from gcs.mavlink.sequence import SequenceCounter
from gcs.scenario.endpoint import Endpoint

POLL_S = 0.02


class CheckError(Exception):
    """Why there is nothing to check, a sentence for a person; and what can be seen of the reason, if anything."""

    def __init__(self, text: str, why: str = "") -> None:
        super().__init__(text)
        self.why = why


class Wire:
    """One connection; a listener answers whoever spoke last. Raises AddressRefused, KeyRefused."""

    def __init__(self, at: Endpoint, key_file: Path | None = None) -> None:
        self.gate = SignatureGate(key_file)
        self._connection = open_connection(at)
        self._diagnosis = Diagnosis(at)
        self._counter = SequenceCounter()
        self._peers: dict[int, Where] = {}

    @property
    def port(self) -> int:
        """The port that it listens at."""
        return self._connection.port

    @property
    def silence(self) -> str:
        """Reason why no vehicle is heard, where that can be seen."""
        return self._diagnosis.text(self._connection.problem)

    def receive(self, wait_s: float) -> list[codec.Frame]:
        """The frames that have come, waiting at most so long for the first."""
        self._connection.tend(time.monotonic())
        select.select([self._connection], [], [], wait_s)
        frames: list[codec.Frame] = []
        for data, sender in self._connection.receive():
            split = self._connection.split(data, sender)
            self._diagnosis.count(data, split)
            for frame in self.gate.accepted(split.frames):
                self._peers[frame.sysid] = sender
                frames.append(frame)
        return frames

    def send(self, messages: Sequence[codec.Message], sysid: int | None, *, unsigned: bool = False) -> None:
        """Send each message by itself, to the vehicle or to the address that was given."""
        to = self._connection.to or (self._peers.get(sysid) if sysid is not None else None)
        if to is None:
            return
        for message in messages:
            raw = codec.frame(message, self._counter.next(), *STATION)
            self._connection.send(raw if unsigned else self.gate.signed(raw), to)

    def close(self) -> None:
        """Close the connection."""
        self._connection.close()
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
            why = f": {wire.silence}" if wire.silence else ""
            raise CheckError(f"no vehicle's HEARTBEAT came within {find_within_s:g} s{refused}", why)
        messages = dialogue.poll(time.monotonic() - begun_s)
        question = dialogue.current
        unsigned = question is not None and question.unsigned
        wire.send(messages, None if vehicle is None else vehicle.sysid, unsigned=unsigned)
        for finding in dialogue.findings[count:]:
            on_finding(finding)
        count = len(dialogue.findings)
