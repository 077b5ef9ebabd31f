"""Link of `gcs monitor`: any address, split into frames, MAVLink 1 too; sends only when asked to."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

from gcs.link.addresses import open_connection
from gcs.link.diagnosis import Diagnosis
from gcs.link.keys import SignatureGate
from gcs.link.socket import Where
from gcs.mavlink import v1
from gcs.mavlink.codec import Frame
from gcs.scenario.endpoint import Endpoint


class Listener:
    """Frames received at an address, with their senders, of MAVLink 1 too. Raises AddressRefused where it cannot be
    had; a connection that breaks is made again."""

    def __init__(self, at: Endpoint, key_file: Path | None = None) -> None:
        """Raises AddressRefused, KeyRefused."""
        self.gate = SignatureGate(key_file)
        self._connection = open_connection(at)
        self._diagnosis = Diagnosis(at)
        self.open = True

    @property
    def port(self) -> int:
        """The port that it is at."""
        return self._connection.port

    @property
    def problem(self) -> str:
        """Why nothing can come at present, and what to do; empty while all is well."""
        return self._connection.problem

    @property
    def silence(self) -> str:
        """Reason why no vehicle is heard, where that can be seen; MAVLink 1 is read here."""
        return self._diagnosis.text(self.problem)

    def fileno(self) -> int:
        """For select: readable when something has come."""
        return self._connection.fileno()

    def receive(self) -> Iterator[tuple[list[Frame], Where]]:
        """Frames received, with their senders, of a bounded number of datagrams; never waits."""
        if not self.open:
            return
        self._connection.tend(time.monotonic())
        for data, sender in self._connection.receive():
            split = self._connection.split(data, sender)
            frames = split.frames or v1.split(data)
            self._diagnosis.count(data, split._replace(frames=frames))
            yield self.gate.accepted(frames), sender
        self._connection.pop_gone()

    def send(self, raw: bytes, peer: Where) -> None:
        """Send a frame to a known sender, or to the one address that it speaks to."""
        self._connection.send(self.gate.signed(raw), self._connection.to or peer)

    @property
    def to(self) -> Where | None:
        """Address that it sends to; None where it listens."""
        return self._connection.to

    def close(self) -> None:
        """Close the connection."""
        self.open = False
        self._connection.close()
        self.gate.close()
