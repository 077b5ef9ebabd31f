"""Any address without a fleet that is known before: split into frames, with their senders; sends only when asked to."""

from __future__ import annotations

import select
import time
from collections.abc import Iterator
from pathlib import Path

from gcs.link.addresses import open_connection
from gcs.link.diagnosis import Diagnosis
from gcs.link.keys import SignatureGate
from gcs.link.socket import Where
from gcs.mavlink.codec import Frame
from gcs.scenario.endpoint import Endpoint


class Listener:
    """Frames received at an address, with their senders. A connection that breaks is made again."""

    def __init__(self, at: Endpoint, key_file: Path | None = None, *, older: bool = False) -> None:
        """older: read MAVLink 1 too. Raises AddressRefused, KeyRefused."""
        self._older = older
        self.gate = SignatureGate(key_file)
        self.connection = open_connection(at)
        self._diagnosis = Diagnosis(at)
        self.open = True

    @property
    def silence(self) -> str:
        """Reason why no vehicle is heard, where that can be seen."""
        return self._diagnosis.text(self.connection.problem)

    def wait(self, wait_s: float) -> None:
        """Wait until something has come, at most so long."""
        self.connection.tend(time.monotonic())
        select.select([self.connection], [], [], wait_s)

    def receive(self) -> Iterator[tuple[list[Frame], Where]]:
        """Frames received, with their senders, of a bounded number of datagrams; never waits."""
        if not self.open:
            return
        self.connection.tend(time.monotonic())
        for data, sender in self.connection.receive():
            split = self.connection.split(data, sender)
            self._diagnosis.count(data, split)
            frames = [*split.frames, *split.older] if self._older else split.frames
            yield self.gate.accepted(frames), sender
        self.connection.pop_gone()

    def send(self, raw: bytes, peer: Where, *, unsigned: bool = False) -> None:
        """Send a frame to a known sender, or to the one address that it speaks to; signed, where there is a key."""
        self.connection.send(raw if unsigned else self.gate.signed(raw), self.connection.to or peer)

    def close(self) -> None:
        """Close the connection."""
        self.open = False
        self.connection.close()
        self.gate.close()
